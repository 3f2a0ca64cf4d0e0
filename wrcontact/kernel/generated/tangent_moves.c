/* Generated from tangent_moves.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of moves.py.
 */

#include "tangent_moves.h"

/* Tangent of ``move_to_station``. */
static inline int64_t tangent_moves__move_to_station_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double station, double station_t)
{
    double way_t;
    double way;
    double spacing_t;
    double spacing;
    int64_t n1;
    double chord_t;
    double chord;
    int64_t i;
    int64_t n2;
    int64_t exists;
    way_t = station_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    way = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    spacing_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING));
    spacing = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING));
    exists = INT64_C(1);
    if (spacing == 0.0)
    {
        n1 = tangent_moves__arc_rule_t(work, work_t, tables, curve, way, way_t);
        exists = n1;
    }
    else
    {
        chord_t = spacing_t;
        chord = spacing;
        if (way < 0.0)
        {
            chord_t = -spacing_t;
            chord = -spacing;
        }
        for (i = INT64_C(0); i < (int64_t)(fabs(way) / spacing + 0.5); i += INT64_C(1))
        {
            if (exists == INT64_C(1))
            {
                n2 = tangent_moves__chord_rule_t(work, work_t, tables, curve, chord, chord_t);
                exists = n2;
            }
        }
    }
    return exists;
}

/* Tangent of ``arc_rule``. */
static inline int64_t tangent_moves__arc_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double length, double length_t)
{
    double start_t;
    double start;
    int64_t n1;
    double u;
    double v2;
    double place_t;
    double place;
    double v3;
    double v3_t;
    double v4;
    int64_t exists;
    start_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
    n1 = moves__move_arc(work, tables, curve, length);
    exists = n1;
    if (exists == INT64_C(1))
    {
        u = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
        v2 = curves__curve_speed(work, tables, curve, u);
        place_t = length_t / v2;
        place = length / v2;
        if (u == start)
        {
            place_t = start_t + place_t;
            place = start + place;
        }
        else
        {
            tangent_arc_length__arc_length_t(&v3, &v3_t, work, work_t, tables, curve, start, start_t, u, 0.0);
            v4 = curves__curve_speed(work, tables, curve, u);
            place_t = place_t - v3_t / v4;
            place = place - v3 / v4;
        }
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA)) = place_t;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA)) = u;
    }
    return exists;
}

/* Tangent of ``chord_rule``. */
static inline int64_t tangent_moves__chord_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double chord, double chord_t)
{
    double start_t;
    double start;
    double from_across;
    double from_across_t;
    double from_down;
    double from_down_t;
    double slope;
    double slope_t;
    double stretch;
    double stretch_t;
    double bend;
    double bend_t;
    int64_t n1;
    double u;
    double across;
    double across_t;
    double down;
    double down_t;
    double v2;
    double v3;
    double length_t;
    double length;
    double v4;
    double along_t;
    double along;
    double v5;
    double v6;
    int64_t exists;
    start_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
    tangent_curves__curve_jet_t(&from_across, &from_across_t, &from_down, &from_down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, curve, start, start_t);
    n1 = moves__move_chord(work, tables, curve, chord);
    exists = n1;
    if (exists == INT64_C(1))
    {
        u = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA));
        tangent_curves__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, curve, u, 0.0);
        across_t = across_t - from_across_t;
        across = across - from_across;
        down_t = down_t - from_down_t;
        down = down - from_down;
        v2 = across * across + down * down;
        v3 = sqrt(v2);
        length_t = tangent_rates__root_rate(v3, across_t * across + across * across_t + (down_t * down + down * down_t));
        length = v3;
        v4 = across + slope * down;
        along_t = (across_t + (slope_t * down + slope * down_t)) * stretch + v4 * stretch_t;
        along = v4 * stretch;
        v5 = -(length - fabs(chord));
        v6 = length / along;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA)) = (-(length_t - tangent_rates__size_rate(chord, chord_t))) * v6;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * curve + layout__TRACE_ABSCISSA)) = u;
    }
    return exists;
}

/* Tangent of ``across_rule``. */
static inline int64_t tangent_moves__across_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, double lateral, double lateral_t)
{
    int64_t n1;
    double u;
    double across;
    double across_t;
    double down;
    double down_t;
    double slope;
    double slope_t;
    double stretch;
    double stretch_t;
    double bend;
    double bend_t;
    double v2;
    int64_t exists;
    n1 = moves__move_across(work, tables, lateral);
    exists = n1;
    if (exists == INT64_C(1))
    {
        u = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
        tangent_curves__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, layout__WHEEL, u, 0.0);
        v2 = -(across - lateral);
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)) = (-(across_t - lateral_t)) / stretch;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)) = u;
    }
    return exists;
}
