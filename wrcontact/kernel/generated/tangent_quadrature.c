/* Generated from tangent_quadrature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of quadrature.py.
 */

#include "tangent_quadrature.h"

/* Tangent of ``bend_of``. */
static inline int64_t tangent_quadrature__bend_of_t(double* bend, double* bend_t, double before, double before_t, double low, double low_t, double high, double high_t)
{
    double v1;
    double v2;
    double limit_t;
    double limit;
    v1 = before - 2.0 * low + high;
    (*bend_t) = 0.5 * (before_t - 2.0 * low_t + high_t);
    (*bend) = 0.5 * v1;
    v2 = fabs(low) + fabs(high);
    limit_t = 0.5 * (tangent_rates__size_rate(low, low_t) + tangent_rates__size_rate(high, high_t));
    limit = 0.5 * v2;
    if ((*bend) > limit)
    {
        (*bend_t) = limit_t;
        (*bend) = limit;
    }
    if ((*bend) < -limit)
    {
        (*bend_t) = -limit_t;
        (*bend) = -limit;
    }
    return 0;
}

/* Tangent of ``quadratic_value``. */
static inline int64_t tangent_quadrature__quadratic_value_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double x, double x_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double v2;
    tangent_quadrature__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    v2 = high - low - bend + x * bend;
    (*result_0) = low + x * v2;
    (*result_1) = low_t + (x_t * v2 + x * (high_t - low_t - bend_t + (x_t * bend + x * bend_t)));
    return 0;
}

/* Tangent of ``cell_part``. */
static inline int64_t tangent_quadrature__cell_part_t(double* start, double* start_t, double* stop, double* stop_t, double d_before, double d_before_t, double d_low, double d_low_t, double d_high, double d_high_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double slope_t;
    double slope;
    double v2;
    double spread_t;
    double spread;
    double v3;
    double root_t;
    double root;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    (*start_t) = 0.0;
    (*start) = 0.0;
    (*stop_t) = 0.0;
    (*stop) = 1.0;
    if ((d_low <= 0.0) && (d_high <= 0.0))
    {
        (*stop_t) = 0.0;
        (*stop) = 0.0;
    }
    else if ((d_low <= 0.0) || (d_high <= 0.0))
    {
        tangent_quadrature__bend_of_t(&v1, &v1_t, d_before, d_before_t, d_low, d_low_t, d_high, d_high_t);
        bend_t = v1_t;
        bend = v1;
        slope_t = d_high_t - d_low_t - bend_t;
        slope = d_high - d_low - bend;
        v2 = 4.0 * bend;
        spread_t = slope_t * slope + slope * slope_t - (4.0 * bend_t * d_low + v2 * d_low_t);
        spread = slope * slope - v2 * d_low;
        if (spread < 0.0)
        {
            spread_t = 0.0;
            spread = 0.0;
        }
        v3 = sqrt(spread);
        spread_t = tangent_rates__root_rate(v3, spread_t);
        spread = v3;
        root_t = 0.0;
        root = 0.0;
        if (d_low > 0.0)
        {
            v4 = 2.0 * d_low;
            v5 = spread - slope;
            v6 = v4 / v5;
            root_t = (2.0 * d_low_t - v6 * (spread_t - slope_t)) / v5;
            root = v6;
            (*stop_t) = root_t;
            (*stop) = root;
        }
        else
        {
            v7 = -2.0;
            v8 = v7 * d_low;
            v9 = spread + slope;
            v10 = v8 / v9;
            root_t = (v7 * d_low_t - v10 * (spread_t + slope_t)) / v9;
            root = v10;
            (*start_t) = root_t;
            (*start) = root;
        }
    }
    return 0;
}

/* Tangent of ``quadratic_integral``. */
static inline int64_t tangent_quadrature__quadratic_integral_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double slope_t;
    double slope;
    double v2;
    double v3;
    double v4;
    tangent_quadrature__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    slope_t = high_t - low_t - bend_t;
    slope = high - low - bend;
    v2 = stop * bend;
    v3 = slope / 2.0 + v2 / 3.0;
    v4 = low + stop * v3;
    (*result_0) = stop * v4;
    (*result_1) = stop_t * v4 + stop * (low_t + (stop_t * v3 + stop * (slope_t / 2.0 + (stop_t * bend + stop * bend_t) / 3.0)));
    return 0;
}

/* Tangent of ``quadratic_moment``. */
static inline int64_t tangent_quadrature__quadratic_moment_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double slope_t;
    double slope;
    double v2;
    double v3;
    double v4;
    double v5;
    tangent_quadrature__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    slope_t = high_t - low_t - bend_t;
    slope = high - low - bend;
    v2 = stop * stop;
    v3 = stop * bend;
    v4 = slope / 3.0 + v3 / 4.0;
    v5 = low / 2.0 + stop * v4;
    (*result_0) = v2 * v5;
    (*result_1) = (stop_t * stop + stop * stop_t) * v5 + v2 * (low_t / 2.0 + (stop_t * v4 + stop * (slope_t / 3.0 + (stop_t * bend + stop * bend_t) / 4.0)));
    return 0;
}

/* Tangent of ``root_integral``. */
static inline int64_t tangent_quadrature__root_integral_t(double* v2, double* v2_t, double before, double before_t, double low, double low_t, double high, double high_t, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double slope_t;
    double slope;
    double v3;
    double v3_t;
    double first_t;
    double first;
    double v4;
    double v4_t;
    double last_t;
    double last;
    double v5;
    double p_t;
    double p;
    double v6;
    double q_t;
    double q;
    double total_t;
    double total;
    double width_t;
    double width;
    double v7;
    double v8;
    double v9;
    double v10;
    double chord_t;
    double chord;
    double v11;
    double cube_t;
    double cube;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    tangent_quadrature__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    slope_t = high_t - low_t - bend_t;
    slope = high - low - bend;
    if (bend < (-quadrature__STRAIGHT) * (fabs(low) + fabs(high)))
    {
        tangent_quadrature__bent_integral_t(v2, v2_t, low, low_t, slope, slope_t, bend, bend_t, start, start_t, stop, stop_t);
        return 0;
    }
    tangent_quadrature__quadratic_at_t(&v3, &v3_t, low, low_t, slope, slope_t, bend, bend_t, start, start_t);
    first_t = v3_t;
    first = v3;
    tangent_quadrature__quadratic_at_t(&v4, &v4_t, low, low_t, slope, slope_t, bend, bend_t, stop, stop_t);
    last_t = v4_t;
    last = v4;
    v5 = sqrt(first);
    p_t = tangent_rates__root_rate(v5, first_t);
    p = v5;
    v6 = sqrt(last);
    q_t = tangent_rates__root_rate(v6, last_t);
    q = v6;
    total_t = p_t + q_t;
    total = p + q;
    if (!(total > 0.0))
    {
        (*v2) = 0.0;
        (*v2_t) = 0.0;
        return 0;
    }
    width_t = stop_t - start_t;
    width = stop - start;
    v7 = 2.0 / 3.0;
    v8 = first + p * q + last;
    v9 = v7 * v8;
    v10 = v9 / total;
    chord_t = (v7 * (first_t + (p_t * q + p * q_t) + last_t) - v10 * total_t) / total;
    chord = v10;
    v11 = total * total;
    cube_t = (total_t * total + total * total_t) * total + v11 * total_t;
    cube = v11 * total;
    v12 = 2.0 / 15.0;
    v13 = v12 * bend;
    v14 = v13 * width;
    v15 = v14 * width;
    v16 = 3.0 * p;
    v17 = first + v16 * q + last;
    v18 = v15 * v17;
    v19 = v18 / cube;
    v20 = chord - v19;
    (*v2) = width * v20;
    (*v2_t) = width_t * v20 + width * (chord_t - (((v12 * bend_t * width + v13 * width_t) * width + v14 * width_t) * v17 + v15 * (first_t + (3.0 * p_t * q + v16 * q_t) + last_t) - v19 * cube_t) / cube);
    return 0;
}

/* Tangent of ``quadratic_at``. */
static inline int64_t tangent_quadrature__quadratic_at_t(double* value, double* value_t, double low, double low_t, double slope, double slope_t, double bend, double bend_t, double x, double x_t)
{
    double v1;
    v1 = slope + x * bend;
    (*value_t) = low_t + (x_t * v1 + x * (slope_t + (x_t * bend + x * bend_t)));
    (*value) = low + x * v1;
    if ((*value) < 0.0)
    {
        (*value_t) = 0.0;
        (*value) = 0.0;
    }
    return 0;
}

/* Tangent of ``bent_integral``. */
static inline int64_t tangent_quadrature__bent_integral_t(double* result_0, double* result_1, double low, double low_t, double slope, double slope_t, double bend, double bend_t, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double first_t;
    double first;
    double v2;
    double v2_t;
    double last_t;
    double last;
    double v3;
    double spread_t;
    double spread;
    double v4;
    double first_root_t;
    double first_root;
    double v5;
    double last_root_t;
    double last_root;
    double v6;
    double first_rate_t;
    double first_rate;
    double v7;
    double last_rate_t;
    double last_rate;
    double v8;
    double v9;
    double across_t;
    double across;
    double v10;
    double height_t;
    double height;
    double v11;
    double height_before_t;
    double height_before;
    double v12;
    double v13;
    double angle_t;
    double angle;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    tangent_quadrature__quadratic_at_t(&v1, &v1_t, low, low_t, slope, slope_t, bend, bend_t, start, start_t);
    first_t = v1_t;
    first = v1;
    tangent_quadrature__quadratic_at_t(&v2, &v2_t, low, low_t, slope, slope_t, bend, bend_t, stop, stop_t);
    last_t = v2_t;
    last = v2;
    v3 = 4.0 * bend;
    spread_t = slope_t * slope + slope * slope_t - (4.0 * bend_t * low + v3 * low_t);
    spread = slope * slope - v3 * low;
    if (!(spread > 0.0))
    {
        (*result_0) = 0.0;
        (*result_1) = 0.0;
        return 0;
    }
    v4 = sqrt(first);
    first_root_t = tangent_rates__root_rate(v4, first_t);
    first_root = v4;
    v5 = sqrt(last);
    last_root_t = tangent_rates__root_rate(v5, last_t);
    last_root = v5;
    v6 = 2.0 * bend;
    first_rate_t = 2.0 * bend_t * start + v6 * start_t + slope_t;
    first_rate = v6 * start + slope;
    v7 = 2.0 * bend;
    last_rate_t = 2.0 * bend_t * stop + v7 * stop_t + slope_t;
    last_rate = v7 * stop + slope;
    v8 = -bend;
    v9 = sqrt(v8);
    across_t = tangent_rates__root_rate(v9, -bend_t);
    across = v9;
    v10 = 2.0 * across;
    height_t = 2.0 * across_t * last_root + v10 * last_root_t;
    height = v10 * last_root;
    v11 = 2.0 * across;
    height_before_t = 2.0 * across_t * first_root + v11 * first_root_t;
    height_before = v11 * first_root;
    v12 = height * first_rate - height_before * last_rate;
    v13 = height * height_before + last_rate * first_rate;
    angle_t = (v13 * (height_t * first_rate + height * first_rate_t - (height_before_t * last_rate + height_before * last_rate_t)) - v12 * (height_t * height_before + height * height_before_t + (last_rate_t * first_rate + last_rate * first_rate_t))) / (v13 * v13 + v12 * v12);
    angle = atan2(v12, v13);
    v14 = last_rate * last_root - first_rate * first_root;
    v15 = 4.0 * bend;
    v16 = v14 / v15;
    v17 = -bend;
    v18 = 8.0 * v17;
    v19 = v18 * across;
    v20 = spread / v19;
    (*result_0) = v16 + v20 * angle;
    (*result_1) = (last_rate_t * last_root + last_rate * last_root_t - (first_rate_t * first_root + first_rate * first_root_t) - v16 * (4.0 * bend_t)) / v15 + ((spread_t - v20 * (8.0 * (-bend_t) * across + v18 * across_t)) / v19 * angle + v20 * angle_t);
    return 0;
}
