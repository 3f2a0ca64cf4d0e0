/* Generated from contact/zone_width.py by tools/transpile_kernel.py; change that one.
 *
 * How far the interpenetration of a region reaches to either side.
 */

#include "zone_width.h"

/* Distance [m] from the region's minimum to its bound in ``direction`` (1.0 or -1.0). */
static inline double zone_width__width_limit(array_double_1d work, int64_t region, double direction)
{
    double limit;
    limit = (*cspan_at(&work, region + layout__REGION_HIGH)) - (*cspan_at(&work, region + layout__REGION_STATION));
    if (direction < 0.0)
    {
        limit = (*cspan_at(&work, region + layout__REGION_STATION)) - (*cspan_at(&work, region + layout__REGION_LOW));
    }
    return limit;
}

/* Tolerance of the traces [m] for an estimated half-width [m]. */
static inline double zone_width__width_tolerance(double estimate)
{
    double tolerance;
    tolerance = zone_width__TRACE_OF_WIDTH * estimate;
    if (tolerance > zone_width__WIDTH_TRACE)
    {
        tolerance = zone_width__WIDTH_TRACE;
    }
    return tolerance;
}

/* Distance [m] from the region's minimum to where the gap has risen by ``level`` [m], or to the region's
 * bound or the end of a profile; ``region.reached`` is how far it has risen there, and there the traces are.
 *
 * Doubling to a bracket, then Newton on the square root of the gap, which is nearly linear.  The gap is the
 * chosen separation, with arcs in place of the chords whose length follows from this width.
 */
static inline double zone_width__zone_width(array_double_1d work, array_double_1d tables, int64_t region, array_double_1d state, double direction, double level, double estimate)
{
    double limit;
    double tolerance;
    double root;
    double low;
    double high;
    double width;
    double station;
    double abscissa;
    double y;
    double near;
    int64_t i;
    double gap;
    double rate;
    double bend;
    double curvature;
    double rise;
    double following;
    double sharp;
    double square;
    double newton;
    limit = zone_width__width_limit(work, region, direction);
    traces__start_traces(work, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)));
    curves__open_origin(work, tables, region, 0.0);
    tolerance = zone_width__width_tolerance(estimate);
    root = sqrt(level);
    low = 0.0;
    high = -1.0;
    width = estimate;
    (*cspan_at(&work, region + layout__REGION_REACHED)) = 0.0;
    station = (*cspan_at(&work, region + layout__REGION_STATION));
    abscissa = (*cspan_at(&work, region + layout__REGION_RAIL));
    y = (*cspan_at(&work, region + layout__REGION_WHEEL));
    near = zone_width__WIDTH_SHARP;
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        near = zone_width__PRESSED_SHARP;
    }
    for (i = INT64_C(0); i < zone_width__WIDTH_ITERATIONS; i += INT64_C(1))
    {
        if (width > limit)
        {
            width = limit;
        }
        separation__separation(&gap, &rate, &bend, &curvature, work, tables, state, (*cspan_at(&work, region + layout__REGION_STATION)) + direction * width, tolerance);
        if (gap >= contact_plane__NO_GAP)
        {
            /* beyond an end the traces are lost */
            traces__start_traces(work, station, abscissa, y);
        }
        else
        {
            station = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
            abscissa = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
            y = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
        }
        rise = gap - (*cspan_at(&work, region + layout__REGION_GAP));
        if (rise < level)
        {
            low = width;
            (*cspan_at(&work, region + layout__REGION_REACHED)) = rise;
            if (width >= limit)
            {
                return limit;
            }
        }
        else
        {
            high = width;
        }
        following = 2.0 * width;
        sharp = zone_width__HALVED_SHARP;
        if (high > 0.0)
        {
            following = 0.5 * (low + high);
        }
        if ((rise > 0.0) && (rate * direction > 0.0))
        {
            square = sqrt(rise);
            newton = width + (root - square) * 2.0 * square / (rate * direction);
            if ((newton > low) && (newton < 4.0 * width) && ((high < 0.0) || (newton < high)))
            {
                following = newton;
                sharp = near;
            }
        }
        if (fabs(following - width) < sharp * width)
        {
            if (sharp == near)
            {
                (*cspan_at(&work, region + layout__REGION_REACHED)) = level;
            }
            return following;
        }
        width = following;
    }
    return width;
}
