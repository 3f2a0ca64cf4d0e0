/* Generated from contact/touching.py by tools/transpile_kernel.py; change that one.
 *
 * Pairs of points of wheel and rail with a common normal: where the overlap of a pressed wheel is largest, or
 * smallest between two largest ones.
 *
 * They are found by a bracket on the rail, with Newton's method inside it, also where curvatures jump.  In a
 * pair the outline and the rail have one slope m and the line between both points is normal to them,
 *
 *     m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
 *     depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)
 *
 * with (X, Z) the wheel's point at abscissa y in its present pose.
 */

#include "touching.h"

/* ``step``, no longer than ``limit`` either way. */
static OUT_OF_LINE double touching__limited(double step, double limit)
{
    if (step > limit)
    {
        step = limit;
    }
    if (step < -limit)
    {
        step = -limit;
    }
    return step;
}

/* Rail and wheel abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail
 * abscissae, and the overlap [m]: Newton's method on its slope, bracketed, from the middle on.  Fourth
 * value: 1 if the slope changes its sign there, else 0: it may do so a little beyond the bracket.
 *
 * The bend leaves out a factor (:mod:`pressed`); between nearly conformal profiles under a deep overlap
 * Newton's method can then alternate between two places.  Where a step has not halved the slope, the bracket
 * is halved.
 */
static OUT_OF_LINE int64_t touching__turning_point(double* result_0, double* result_1_0001, double* result_2, int64_t* result_3, array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y, double height, double sign)
{
    double x;
    double overlap;
    double rise;
    double before;
    int64_t moved_low;
    int64_t moved_high;
    int64_t i;
    double bend;
    double z;
    double slope;
    double wheel_bend;
    int64_t found;
    double following;
    double z_rail;
    double newton;
    int64_t turned;
    x = 0.5 * (low + high);
    overlap = 0.0;
    rise = 1.0;
    before = 0.0;
    moved_low = INT64_C(0);
    moved_high = INT64_C(0);
    for (i = INT64_C(0); i < touching__DEEP_ITERATIONS; i += INT64_C(1))
    {
        pressed__meet_wheel(&y, &overlap, &rise, &bend, &z, &slope, &wheel_bend, &found, work, tables, place, x, y, height, pressed__LINE_SHARP);
        if (found == INT64_C(0))
        {
            (*result_0) = x;
            (*result_1_0001) = y;
            (*result_2) = overlap;
            (*result_3) = INT64_C(0);
            return 0;
        }
        if (sign * rise > 0.0)
        {
            low = x;
            moved_low = INT64_C(1);
        }
        else
        {
            high = x;
            moved_high = INT64_C(1);
        }
        following = 0.5 * (low + high);
        if ((sign * bend < 0.0) && ((i == INT64_C(0)) || (fabs(rise) < 0.5 * before)))
        {
            profile_table__height_slope(&z_rail, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
            newton = x - rise / (bend * sqrt(1.0 + slope * slope));
            if ((newton > low) && (newton < high))
            {
                following = newton;
            }
        }
        if (fabs(following - x) < touching__DEEP_SHARP)
        {
            break;
        }
        x = following;
        before = fabs(rise);
    }
    turned = INT64_C(0);
    if ((fabs(rise) < touching__ZERO_RISE) || ((fabs(rise) < touching__LEVEL_RISE) && (moved_low * moved_high == INT64_C(1))))
    {
        turned = INT64_C(1);
    }
    (*result_0) = x;
    (*result_1_0001) = y;
    (*result_2) = overlap;
    (*result_3) = turned;
    return 0;
}
