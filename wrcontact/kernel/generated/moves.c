/* Generated from contact/moves.py by tools/transpile_kernel.py; change that one.
 *
 * Moves along the two curves of :mod:`curves`: by arc length, by chords, or to a lateral coordinate.
 *
 * A move leaves the new abscissa in the frame's trace, and returns whether the curve reaches that far.
 */

#include "moves.h"

/* Move a curve's abscissa by ``length`` [m] of arc, by Newton's method; 1 if the curve is
 * that long, else 0.
 */
static OUT_OF_LINE int64_t moves__move_arc(array_double_1d work, array_double_1d tables, int64_t curve, double length)
{
    double u;
    double remainder;
    int64_t i;
    double speed;
    double following;
    u = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
    remainder = length;
    for (i = INT64_C(0); i < moves__MOVE_ITERATIONS; i += INT64_C(1))
    {
        if (fabs(remainder) < moves__MOVE_SHARP)
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA)) = u;
            return INT64_C(1);
        }
        speed = curves__curve_speed(work, tables, curve, u);
        if (!(speed > 0.0))
        {
            return INT64_C(0);
        }
        following = curves__within(tables, curve, u + remainder / speed);
        if (following == u)
        {
            return INT64_C(0);
        }
        remainder -= arc_length__arc_length(work, tables, curve, u, following);
        u = following;
    }
    return INT64_C(0);
}

/* Move a curve's abscissa to where a circle of radius abs(``chord``) [m] around the point cuts the curve,
 * forward where ``chord`` is positive; 1 if it does, else 0.
 */
static OUT_OF_LINE int64_t moves__move_chord(array_double_1d work, array_double_1d tables, int64_t curve, double chord)
{
    double start;
    double from_across;
    double from_down;
    double slope;
    double stretch;
    double bend;
    double u;
    int64_t i;
    double across;
    double down;
    double length;
    double along;
    double following;
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
    curves__curve_jet(&from_across, &from_down, &slope, &stretch, &bend, work, tables, curve, start);
    if (!(stretch > 0.0))
    {
        return INT64_C(0);
    }
    u = curves__within(tables, curve, start + chord / (stretch * sqrt(1.0 + slope * slope)));
    for (i = INT64_C(0); i < moves__MOVE_ITERATIONS; i += INT64_C(1))
    {
        curves__curve_jet(&across, &down, &slope, &stretch, &bend, work, tables, curve, u);
        across -= from_across;
        down -= from_down;
        length = sqrt(across * across + down * down);
        if (fabs(length - fabs(chord)) < moves__MOVE_SHARP)
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA)) = u;
            return INT64_C(1);
        }
        along = (across + slope * down) * stretch;
        if (!(along * chord > 0.0))
        {
            return INT64_C(0);
        }
        following = curves__within(tables, curve, u - (length - fabs(chord)) * length / along);
        if (following == u)
        {
            return INT64_C(0);
        }
        u = following;
    }
    return INT64_C(0);
}

/* Move a curve's abscissa from the station of the traces to ``station`` [m], by arc or by chords; 1 if
 * there is one.
 */
static OUT_OF_LINE int64_t moves__move_to_station(array_double_1d work, array_double_1d tables, int64_t curve, double station)
{
    double way;
    double spacing;
    double chord;
    int64_t i;
    int64_t exists;
    way = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    spacing = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING));
    exists = INT64_C(1);
    if (spacing == 0.0)
    {
        exists = moves__move_arc(work, tables, curve, way);
    }
    else
    {
        chord = spacing;
        if (way < 0.0)
        {
            chord = -spacing;
        }
        for (i = INT64_C(0); i < (int64_t)(fabs(way) / spacing + 0.5); i += INT64_C(1))
        {
            if (exists == INT64_C(1))
            {
                exists = moves__move_chord(work, tables, curve, chord);
            }
        }
    }
    return exists;
}

/* Move the wheel's abscissa to where its outline is ``lateral`` [m] from the origin, by Newton's method;
 * 1 if there is such a place, else 0.
 */
static OUT_OF_LINE int64_t moves__move_across(array_double_1d work, array_double_1d tables, double lateral)
{
    double u;
    int64_t i;
    double across;
    double down;
    double slope;
    double stretch;
    double bend;
    double following;
    u = curves__within(tables, layout__WHEEL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
    for (i = INT64_C(0); i < moves__MOVE_ITERATIONS; i += INT64_C(1))
    {
        curves__curve_jet(&across, &down, &slope, &stretch, &bend, work, tables, layout__WHEEL, u);
        if (!(stretch > 0.0))
        {
            return INT64_C(0);
        }
        if (fabs(across - lateral) < moves__MOVE_SHARP)
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)) = u;
            return INT64_C(1);
        }
        following = curves__within(tables, layout__WHEEL, u - (across - lateral) / stretch);
        if (following == u)
        {
            return INT64_C(0);
        }
        u = following;
    }
    return INT64_C(0);
}
