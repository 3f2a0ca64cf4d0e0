/* Generated from tangent_stick_zone.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of stick_zone.py.
 */

#include "tangent_stick_zone.h"

/* Tangent of ``find_stick_zone``. */
static inline int64_t tangent_stick_zone__find_stick_zone_t(array_double_1d work, array_double_1d work_t, int64_t march, double width, double width_t, double ratio, double ratio_t)
{
    double a_t;
    double a;
    double v1;
    double inverse_t;
    double inverse;
    double v2;
    double v3;
    double u_t;
    double u;
    double v4;
    double v5;
    double v_t;
    double v;
    double v6;
    double v7;
    double k_t;
    double k;
    double v8;
    double v8_t;
    double spread_t;
    double spread;
    double depth;
    double depth_t;
    double first_weight;
    double first_weight_t;
    double v10;
    double v9;
    double v9_t;
    double share_t;
    double share;
    double v11;
    double weight;
    double weight_t;
    double v12;
    double v13;
    double v14;
    double v15;
    double v17;
    double v18;
    double v16;
    double v16_t;
    double v19;
    double v20;
    double v20_t;
    a_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    v1 = 1.0 / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    inverse_t = (-v1) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    inverse = v1;
    v2 = -(*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG));
    v3 = v2 * (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP));
    u_t = ((-(*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) + v2 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP))) * inverse + v3 * inverse_t;
    u = v3 * inverse;
    v4 = -(*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS));
    v5 = v4 * (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL));
    v_t = ((-(*cspan_at(&work_t, march + layout__ROLLING_MARCH_ACROSS))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) + v4 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL))) * inverse + v5 * inverse_t;
    v = v5 * inverse;
    v6 = -(*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING));
    v7 = v6 * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN));
    k_t = ((-(*cspan_at(&work_t, march + layout__ROLLING_MARCH_TURNING))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) + v6 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN))) * inverse + v7 * inverse_t;
    k = v7 * inverse;
    tangent_stick_zone__spread_square_t(&v8, &v8_t, work, work_t, march, width * inverse, width_t * inverse + width * inverse_t, k, k_t, ratio, ratio_t);
    spread_t = v8_t;
    spread = v8;
    tangent_stick_zone__slip_depth_t(&depth, &depth_t, &first_weight, &first_weight_t, u * u + spread, u_t * u + u * u_t + spread_t, v, v_t, k, k_t, a, a_t);
    v10 = depth / a;
    tangent_stick_zone__later_share_t(&v9, &v9_t, v10, (depth_t - v10 * a_t) / a, ratio, ratio_t);
    share_t = v9_t;
    share = v9;
    u_t = u_t * share + u * share_t;
    u = u * share;
    v_t = v_t * share + v * share_t;
    v = v * share;
    k_t = k_t * share + k * share_t;
    k = k * share;
    v11 = share * share;
    tangent_stick_zone__slip_depth_t(&depth, &depth_t, &weight, &weight_t, u * u + v11 * spread, u_t * u + u * u_t + ((share_t * share + share * share_t) * spread + v11 * spread_t), v, v_t, k, k_t, a, a_t);
    if (first_weight < weight)
    {
        weight_t = first_weight_t;
        weight = first_weight;
    }
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) = a_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = a;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)) = k_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) = k;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = 0.0;
    if ((weight > 0.0) && (depth < a))
    {
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) = depth_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = depth;
        v12 = depth + stick_zone__NOTHING;
        v13 = u / v12;
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) = (u_t - v13 * depth_t) / v12;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = v13;
        v14 = depth + stick_zone__NOTHING;
        v15 = v / v14;
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) = (v_t - v15 * depth_t) / v14 + k_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = v15 + k;
        v17 = depth / a;
        v18 = 1.0 - v17;
        tangent_stick_zone__smooth_step_t(&v16, &v16_t, v18 / stick_zone__FADE, (-((depth_t - v17 * a_t) / a)) / stick_zone__FADE);
        v19 = weight * v16;
        tangent_stick_zone__edge_weight_t(&v20, &v20_t, work, work_t, march);
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT)) = (weight_t * v16 + weight * v16_t) * v20 + v19 * v20_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) = v19 * v20;
    }
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)) = 2.0 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) - a_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) = 2.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) - a;
    return INT64_C(0);
}

/* Tangent of ``spread_square``. */
static inline int64_t tangent_stick_zone__spread_square_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t march, double scale, double scale_t, double k, double k_t, double ratio, double ratio_t)
{
    double v1;
    double over_width_t;
    double over_width;
    double twist_t;
    double twist;
    double long_t;
    double long_0001;
    double v2;
    double v3;
    double v4;
    double floor_t;
    double floor;
    double v5;
    v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN));
    over_width_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN))) * scale + v1 * scale_t;
    over_width = v1 * scale;
    twist_t = tangent_rates__size_rate(k, k_t);
    twist = fabs(k);
    if (twist > stick_zone__FLOOR_TWIST)
    {
        twist_t = 0.0;
        twist = stick_zone__FLOOR_TWIST;
    }
    long_t = ratio_t / stick_zone__FLOOR_RATIO;
    long_0001 = ratio / stick_zone__FLOOR_RATIO;
    if (long_0001 > 1.0)
    {
        long_t = 0.0;
        long_0001 = 1.0;
    }
    v2 = stick_zone__FLOOR * long_0001;
    v3 = v2 * twist;
    v4 = v3 * twist;
    floor_t = ((stick_zone__FLOOR * long_t * twist + v2 * twist_t) * twist + v3 * twist_t) * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) + v4 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    floor = v4 * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    v5 = over_width * over_width;
    (*result_0) = v5 / 6.0 + floor * floor;
    (*result_1) = (over_width_t * over_width + over_width * over_width_t) / 6.0 + (floor_t * floor + floor * floor_t);
    return 0;
}

/* Tangent of ``slip_depth``. */
static inline int64_t tangent_stick_zone__slip_depth_t(double* depth, double* depth_t, double* weight, double* weight_t, double square, double square_t, double v, double v_t, double k, double k_t, double a, double a_t)
{
    double rest_t;
    double rest;
    double cross_t;
    double cross;
    double spread_t;
    double spread;
    double v1;
    double root_t;
    double root;
    double v2;
    double v3;
    double v4;
    double v6;
    double v7;
    double v5;
    double v5_t;
    double v8;
    double v9;
    rest_t = -(k_t * k + k * k_t);
    rest = 1.0 - k * k;
    cross_t = v_t * k + v * k_t;
    cross = v * k;
    spread_t = v_t * v + v * v_t + (rest_t * square + rest * square_t);
    spread = v * v + rest * square;
    (*depth_t) = 2.0 * a_t;
    (*depth) = 2.0 * a;
    (*weight_t) = 0.0;
    (*weight) = 0.0;
    if ((spread > 0.0) || ((rest > 0.0) && (spread == 0.0)))
    {
        v1 = sqrt(spread);
        root_t = tangent_rates__root_rate(v1, spread_t);
        root = v1;
        if (cross <= 0.0)
        {
            v2 = square + v * v;
            v3 = root - cross + stick_zone__NOTHING;
            v4 = v2 / v3;
            (*depth_t) = (square_t + (v_t * v + v * v_t) - v4 * (root_t - cross_t)) / v3;
            (*depth) = v4;
            (*weight_t) = 0.0;
            (*weight) = 1.0;
            if (rest < 0.0)
            {
                v6 = v * v + stick_zone__NOTHING;
                v7 = spread / v6;
                tangent_stick_zone__smooth_step_t(&v5, &v5_t, v7, (spread_t - v7 * (v_t * v + v * v_t)) / v6);
                (*weight_t) = v5_t;
                (*weight) = v5;
            }
        }
        else if (rest > 0.0)
        {
            v8 = cross + root;
            v9 = v8 / rest;
            (*depth_t) = (cross_t + root_t - v9 * rest_t) / rest;
            (*depth) = v9;
            (*weight_t) = 0.0;
            (*weight) = 1.0;
        }
    }
    return 0;
}

/* Tangent of ``later_share``. */
static inline int64_t tangent_stick_zone__later_share_t(double* share, double* share_t, double depth, double depth_t, double ratio, double ratio_t)
{
    double filled_t;
    double filled;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    filled_t = 0.0;
    filled = 1.0;
    (*share_t) = 0.0;
    (*share) = 1.0;
    if (depth < 1.0)
    {
        v1 = 2.0 - depth;
        filled_t = depth_t * v1 + depth * (-depth_t);
        filled = depth * v1;
    }
    if (depth > 0.0)
    {
        v2 = 0.5 * stick_zone__LATER;
        v3 = v2 * ratio;
        v4 = 1.0 + ratio;
        v5 = v3 / v4;
        v6 = v5 * filled;
        v7 = filled / depth;
        (*share_t) = -(((v2 * ratio_t - v5 * ratio_t) / v4 * filled + v5 * filled_t) * v7 + v6 * ((filled_t - v7 * depth_t) / depth));
        (*share) = 1.0 - v6 * v7;
    }
    return 0;
}

/* Tangent of ``edge_weight``. */
static inline int64_t tangent_stick_zone__edge_weight_t(double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t march)
{
    double v1;
    double v2;
    double v3;
    double t_t;
    double t;
    double v4;
    double along_t;
    double along;
    double v5;
    double across_t;
    double across;
    double v7;
    double v8;
    double v6;
    double v6_t;
    (*weight_t) = 0.0;
    (*weight) = 1.0;
    if ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0)
    {
        v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
        v2 = 1.0 - v1;
        v3 = sqrt(v2);
        t_t = tangent_rates__root_rate(v3, -(((*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) - v1 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH))));
        t = v3;
        v4 = 1.0 - t;
        along_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) * v4 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (-t_t);
        along = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * v4;
        v5 = 1.0 - t;
        across_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * v5 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (-t_t) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)) * t + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * t_t);
        across = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * v5 + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * t;
        v7 = along * along + across * across;
        v8 = sqrt(v7);
        tangent_stick_zone__smooth_step_t(&v6, &v6_t, v8 - 1.0, tangent_rates__root_rate(v8, along_t * along + along * along_t + (across_t * across + across * across_t)));
        (*weight_t) = -v6_t;
        (*weight) = 1.0 - v6;
    }
    return 0;
}

/* Tangent of ``smooth_step``. */
static inline int64_t tangent_stick_zone__smooth_step_t(double* value, double* value_t, double z, double z_t)
{
    double v1;
    double v2;
    (*value_t) = 0.0;
    (*value) = 0.0;
    if (z >= 1.0)
    {
        (*value_t) = 0.0;
        (*value) = 1.0;
    }
    else if (z > 0.0)
    {
        v1 = z * z;
        v2 = 3.0 - 2.0 * z;
        (*value_t) = (z_t * z + z * z_t) * v2 + v1 * (-(2.0 * z_t));
        (*value) = v1 * v2;
    }
    return 0;
}
