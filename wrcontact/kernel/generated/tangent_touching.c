/* Generated from tangent_touching.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of touching.py.
 */

#include "tangent_touching.h"

/* Tangent of ``limited``. */
static inline int64_t tangent_touching__limited_t(double* result_0, double* result_1, double step, double step_t, double limit, double limit_t)
{
    if (step > limit)
    {
        step_t = limit_t;
        step = limit;
    }
    if (step < -limit)
    {
        step_t = -limit_t;
        step = -limit;
    }
    (*result_0) = step;
    (*result_1) = step_t;
    return 0;
}

/* Tangent of ``turning_point``. */
static inline int64_t tangent_touching__turning_point_t(double* result_0, double* result_1, double* result_2_0001, double* result_3_0001, double* result_4, double* result_5, int64_t* result_6, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double low, double low_t, double high, double high_t, double y, double y_t, double height, double height_t, double sign, double sign_t)
{
    double v1;
    double x_t;
    double x;
    double overlap_t;
    double overlap;
    double rise_t;
    double rise;
    double before_t;
    double before;
    int64_t moved_low;
    int64_t moved_high;
    int64_t i;
    double bend;
    double bend_t;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double wheel_bend;
    double wheel_bend_t;
    int64_t found;
    double v2;
    double following_t;
    double following;
    double z_rail;
    double z_rail_t;
    double v3;
    double v4;
    double v5;
    double v6;
    double newton_t;
    double newton;
    int64_t turned;
    v1 = low + high;
    x_t = 0.5 * (low_t + high_t);
    x = 0.5 * v1;
    overlap_t = 0.0;
    overlap = 0.0;
    rise_t = 0.0;
    rise = 1.0;
    before_t = 0.0;
    before = 0.0;
    moved_low = INT64_C(0);
    moved_high = INT64_C(0);
    for (i = INT64_C(0); i < touching__DEEP_ITERATIONS; i += INT64_C(1))
    {
        tangent_pressed__meet_rule_t(&y, &y_t, &overlap, &overlap_t, &rise, &rise_t, &bend, &bend_t, &z, &z_t, &slope, &slope_t, &wheel_bend, &wheel_bend_t, &found, work, work_t, tables, place, x, x_t, y, y_t, height, height_t, pressed__LINE_SHARP, 0.0);
        if (found == INT64_C(0))
        {
            (*result_0) = x;
            (*result_1) = x_t;
            (*result_2_0001) = y;
            (*result_3_0001) = y_t;
            (*result_4) = overlap;
            (*result_5) = overlap_t;
            (*result_6) = INT64_C(0);
            return 0;
        }
        if (sign * rise > 0.0)
        {
            low_t = x_t;
            low = x;
            moved_low = INT64_C(1);
        }
        else
        {
            high_t = x_t;
            high = x;
            moved_high = INT64_C(1);
        }
        v2 = low + high;
        following_t = 0.5 * (low_t + high_t);
        following = 0.5 * v2;
        if ((sign * bend < 0.0) && ((i == INT64_C(0)) || (fabs(rise) < 0.5 * before)))
        {
            tangent_profile_table__height_slope_t(&z_rail, &z_rail_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x, x_t);
            v3 = 1.0 + slope * slope;
            v4 = sqrt(v3);
            v5 = bend * v4;
            v6 = rise / v5;
            newton_t = x_t - (rise_t - v6 * (bend_t * v4 + bend * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t))) / v5;
            newton = x - v6;
            if ((newton > low) && (newton < high))
            {
                following_t = newton_t;
                following = newton;
            }
        }
        if (fabs(following - x) < touching__DEEP_SHARP)
        {
            break;
        }
        x_t = following_t;
        x = following;
        before_t = tangent_rates__size_rate(rise, rise_t);
        before = fabs(rise);
    }
    turned = INT64_C(0);
    if ((fabs(rise) < touching__ZERO_RISE) || ((fabs(rise) < touching__LEVEL_RISE) && (moved_low * moved_high == INT64_C(1))))
    {
        turned = INT64_C(1);
    }
    (*result_0) = x;
    (*result_1) = x_t;
    (*result_2_0001) = y;
    (*result_3_0001) = y_t;
    (*result_4) = overlap;
    (*result_5) = overlap_t;
    (*result_6) = turned;
    return 0;
}
