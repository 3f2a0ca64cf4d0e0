/* Generated from tangent_slip_march.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of slip_march.py.
 */

#include "tangent_slip_march.h"

/* Tangent of ``set_pushes``. */
static inline int64_t tangent_slip_march__set_pushes_t(array_double_1d work, array_double_1d work_t, int64_t march, double plane, double plane_t, double spinning, double spinning_t, double ratio, double ratio_t)
{
    double i1_t;
    double i1;
    double i2_t;
    double i2;
    double i3_t;
    double i3;
    double v1;
    double v2;
    double s_t;
    double s;
    double x_t;
    double x;
    double y_t;
    double y;
    double z_t;
    double z;
    double v3;
    double v4;
    double v5;
    double centre_t;
    double centre;
    double v6;
    double v7;
    double v8;
    double fills_t;
    double fills;
    double v9;
    double v10;
    double scale_t;
    double scale;
    double v11;
    double v12;
    double v13;
    double v14;
    double near_t;
    double near;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    double v21;
    double v22;
    double v23;
    double lag_t;
    double lag;
    double v24;
    double v25;
    double v26;
    double v27;
    double v28;
    double v29;
    double square_t;
    double square;
    double v30;
    double v31;
    i1_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG)) * plane + (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * plane_t;
    i1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * plane;
    i2_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ACROSS)) * plane + (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) * plane_t;
    i2 = (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) * plane;
    i3_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_TURNING)) * spinning + (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) * spinning_t;
    i3 = (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) * spinning;
    v1 = 3.0 * M_PI / 32.0;
    v2 = v1 * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    s_t = v1 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) + v2 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN));
    s = v2 * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN));
    x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP));
    x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP));
    y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL));
    y = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL));
    z_t = s_t * s + s * s_t;
    z = s * s;
    v3 = x * i1 + y * i2 + z * i3 + slip_march__NOTHING * i1;
    v4 = x + y + z + slip_march__NOTHING;
    v5 = v3 / v4;
    centre_t = (x_t * i1 + x * i1_t + (y_t * i2 + y * i2_t) + (z_t * i3 + z * i3_t) + slip_march__NOTHING * i1_t - v5 * (x_t + y_t + z_t)) / v4;
    centre = v5;
    v6 = x * i1;
    v7 = y * i2;
    v8 = z * i3;
    fills_t = (x_t * i1 + x * i1_t) * i1 + v6 * i1_t + ((y_t * i2 + y * i2_t) * i2 + v7 * i2_t) + ((z_t * i3 + z * i3_t) * i3 + v8 * i3_t);
    fills = v6 * i1 + v7 * i2 + v8 * i3;
    v9 = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    v10 = 4.0 / v9;
    scale_t = (-v10) * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / v9;
    scale = v10;
    v11 = scale * fills;
    v12 = slip_march__FILLS * slip_march__FILLS;
    v13 = 1.0 + v11 / v12;
    v14 = 1.0 / v13;
    near_t = (-v14) * ((scale_t * fills + scale * fills_t) / v12) / v13;
    near = v14;
    v15 = i1 - centre;
    i1_t = centre_t + ((i1_t - centre_t) * near + v15 * near_t);
    i1 = centre + v15 * near;
    v16 = i2 - centre;
    i2_t = centre_t + ((i2_t - centre_t) * near + v16 * near_t);
    i2 = centre + v16 * near;
    v17 = i3 - centre;
    i3_t = centre_t + ((i3_t - centre_t) * near + v17 * near_t);
    i3 = centre + v17 * near;
    v18 = x * i1;
    v19 = y * i2;
    v20 = z * i3;
    fills_t = (x_t * i1 + x * i1_t) * i1 + v18 * i1_t + ((y_t * i2 + y * i2_t) * i2 + v19 * i2_t) + ((z_t * i3 + z * i3_t) * i3 + v20 * i3_t);
    fills = v18 * i1 + v19 * i2 + v20 * i3;
    v21 = slip_march__LONG_LAG * ratio;
    v22 = ratio + slip_march__LAG_RATIO;
    v23 = v21 / v22;
    lag_t = (slip_march__LONG_LAG * ratio_t - v23 * ratio_t) / v22;
    lag = slip_march__LAG + v23;
    v24 = scale * fills;
    v25 = slip_march__LAG_FILLS * slip_march__LAG_FILLS;
    v26 = 1.0 + v24 / v25;
    v27 = lag / v26;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LAG)) = (lag_t - v27 * ((scale_t * fills + scale * fills_t) / v25)) / v26;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG)) = v27;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP)) * i1 + (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * i1_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * i1;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL)) * i2 + (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * i2_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * i2;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN)) * i3 + (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * i3_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * i3;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1))) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP)) * centre + (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * centre_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * centre;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(1))) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL)) * centre + (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * centre_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(1))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * centre;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN)) * centre + (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * centre_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * centre;
    v28 = ratio / slip_march__SHARE_RATIO;
    v29 = ratio / slip_march__SHARE_RATIO;
    square_t = ratio_t / slip_march__SHARE_RATIO * v29 + v28 * (ratio_t / slip_march__SHARE_RATIO);
    square = v28 * v29;
    v30 = 1.0 + square * square;
    v31 = slip_march__SHARE / v30;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SHARE)) = (-v31) * (square_t * square + square * square_t) / v30;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) = v31;
    return INT64_C(0);
}

/* Tangent of ``march_strip``. */
static inline int64_t tangent_slip_march__march_strip_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march)
{
    int64_t first;
    int64_t n1;
    int64_t n2;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = 0.0;
    first = INT64_C(0);
    if ((*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) > 0.0)
    {
        if (((*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) < 1.0) || ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0))
        {
            n1 = tangent_slip_march__march_stick_t(tables, work, work_t, table, march);
            first = n1;
        }
        else
        {
            n2 = tangent_slip_march__march_held_t(tables, work, work_t, table, march);
            first = n2;
        }
        if (first < layout__POINT_LIMIT)
        {
            tangent_slip_march__cross_edge_t(tables, work, work_t, table, march, first);
            first = first + INT64_C(1);
        }
    }
    tangent_slip_march__march_slip_t(tables, work, work_t, table, march, first);
    return INT64_C(0);
}

/* Tangent of ``stepped``. */
static inline int64_t tangent_slip_march__stepped_t(double* r2, double* r2_t, double* r3, double* r3_t, array_double_1d work, array_double_1d work_t, int64_t march, int64_t index, double p_x, double p_x_t, double p_y, double p_y_t, double x, double x_t, double step, double step_t, double bound, double bound_t)
{
    double v1;
    double across_t;
    double across;
    v1 = x + (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG)) * step;
    across_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y + index)) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN + index)) * v1 + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + index)) * (x_t + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_LAG)) * step + (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG)) * step_t)));
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + index)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + index)) * v1;
    tangent_tractions__cut_to_t(r2, r2_t, r3, r3_t, p_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + index)), p_x_t - (step_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + index)) + step * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X + index))), p_y - step * across, p_y_t - (step_t * across + step * across_t), bound, bound_t);
    return 0;
}

/* Tangent of ``step_first``. */
static inline int64_t tangent_slip_march__step_first_t(array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double step, double step_t, double bound, double bound_t)
{
    double p_x;
    double p_x_t;
    double p_y;
    double p_y_t;
    tangent_slip_march__stepped_t(&p_x, &p_x_t, &p_y, &p_y_t, work, work_t, march, INT64_C(0), (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)), (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)), x, x_t, step, step_t, bound, bound_t);
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) = p_x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = p_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) = p_y_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = p_y;
    return INT64_C(0);
}

/* Tangent of ``step_second``. */
static inline int64_t tangent_slip_march__step_second_t(array_double_1d work, array_double_1d work_t, int64_t march, double from_x, double from_x_t, double from_y, double from_y_t, double x, double x_t, double step, double step_t, double bound, double bound_t)
{
    double p_x;
    double p_x_t;
    double p_y;
    double p_y_t;
    tangent_slip_march__stepped_t(&p_x, &p_x_t, &p_y, &p_y_t, work, work_t, march, INT64_C(1), from_x, from_x_t, from_y, from_y_t, x, x_t, step, step_t, bound, bound_t);
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_X)) = p_x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)) = p_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_Y)) = p_y_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)) = p_y;
    return INT64_C(0);
}

/* Tangent of ``slip_traction``. */
static inline int64_t tangent_slip_march__slip_traction_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t march, double bound, double bound_t)
{
    double v1;
    double along_t;
    double along;
    double v2;
    double across_t;
    double across;
    double square_t;
    double square;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    double scale_t;
    double scale;
    v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X));
    along_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_SHARE)) * v1 + (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_X)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X))));
    along = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) * v1;
    v2 = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y));
    across_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_SHARE)) * v2 + (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_Y)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y))));
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) * v2;
    square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
    square = along * along + across * across;
    v3 = slip_march__SOFT * slip_march__SOFT;
    v4 = bound * bound - square;
    v5 = square + v3 * v4 + slip_march__NOTHING;
    v6 = sqrt(v5);
    v7 = bound / v6;
    scale_t = (bound_t - v7 * tangent_rates__root_rate(v6, square_t + v3 * (bound_t * bound + bound * bound_t - square_t))) / v6;
    scale = v7;
    (*result_0) = along * scale;
    (*result_1) = along_t * scale + along * scale_t;
    (*result_2) = across * scale;
    (*result_3) = across_t * scale + across * scale_t;
    return 0;
}

/* Tangent of ``add_point``. */
static inline int64_t tangent_slip_march__add_point_t(array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double weight, double weight_t, double p_x, double p_x_t, double p_y, double p_y_t)
{
    double v1;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) + (weight_t * p_x + weight * p_x_t);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) + weight * p_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) + (weight_t * p_y + weight * p_y_t);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) + weight * p_y;
    v1 = weight * x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) + ((weight_t * x + weight * x_t) * p_y + v1 * p_y_t);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) + v1 * p_y;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) = x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = x;
    return INT64_C(0);
}

/* Tangent of ``note_largest``. */
static inline int64_t tangent_slip_march__note_largest_t(array_double_1d work, array_double_1d work_t, int64_t march, double p_x, double p_x_t, double p_y, double p_y_t)
{
    double square_t;
    double square;
    square_t = p_x_t * p_x + p_x * p_x_t + (p_y_t * p_y + p_y * p_y_t);
    square = p_x * p_x + p_y * p_y;
    if (square > (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)))
    {
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LARGEST)) = square_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = square;
    }
    return INT64_C(0);
}

/* Tangent of ``march_held``. */
static inline int64_t tangent_slip_march__march_held_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march)
{
    double a_t;
    double a;
    double top_t;
    double top;
    double lag_t;
    double lag;
    double before_t;
    double before;
    double first_x_t;
    double first_x;
    double first_y_t;
    double first_y;
    double sum_x_t;
    double sum_x;
    double sum_moment_t;
    double sum_moment;
    double x_t;
    double x;
    double bound_t;
    double bound;
    double step_t;
    double step;
    double v1;
    double v2;
    double v3;
    int64_t q;
    a_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    top_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * a + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a_t;
    top = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
    lag_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LAG));
    lag = (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG));
    before_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X));
    before = (*cspan_at(&work, march + layout__ROLLING_MARCH_X));
    first_x_t = 0.0;
    first_x = 0.0;
    first_y_t = 0.0;
    first_y = 0.0;
    sum_x_t = 0.0;
    sum_x = 0.0;
    sum_moment_t = 0.0;
    sum_moment = 0.0;
    q = INT64_C(0);
    while((q < layout__POINT_LIMIT) && (a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) >= (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE))))
    {
        x_t = a_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        bound_t = top_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        bound = top * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        step_t = before_t - x_t;
        step = before - x;
        before_t = x_t;
        before = x;
        v1 = x + lag * step;
        v2 = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * v1;
        tangent_tractions__cut_to_t(&first_x, &first_x_t, &first_y, &first_y_t, first_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))), first_x_t - (step_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))) + step * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0)))), first_y - step * v2, first_y_t - (step_t * v2 + step * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * v1 + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * (x_t + (lag_t * step + lag * step_t))))), bound, bound_t);
        sum_x_t = sum_x_t + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * bound_t;
        sum_x = sum_x + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * bound;
        v3 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * bound;
        sum_moment_t = sum_moment_t + ((*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * bound_t * x + v3 * x_t);
        sum_moment = sum_moment + v3 * x;
        q = q + INT64_C(1);
    }
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) = before_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = before;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) = first_x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = first_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) = first_y_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = first_y;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) * sum_x + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * sum_x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * sum_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * sum_x + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * sum_x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * sum_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * sum_moment + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * sum_moment_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * sum_moment;
    return q;
}

/* Tangent of ``march_stick``. */
static inline int64_t tangent_slip_march__march_stick_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march)
{
    double a_t;
    double a;
    double weight_t;
    double weight;
    double x_t;
    double x;
    double step_t;
    double step;
    double v1;
    double bound_t;
    double bound;
    double p_x_t;
    double p_x;
    double p_y_t;
    double p_y;
    double over_x;
    double over_x_t;
    double over_y;
    double over_y_t;
    double slip_x;
    double slip_x_t;
    double slip_y;
    double slip_y_t;
    double v2;
    double v3;
    double v4;
    double v5;
    int64_t q;
    a_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    weight_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT));
    weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
    q = INT64_C(0);
    while((q < layout__POINT_LIMIT) && (a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) >= (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE))))
    {
        x_t = a_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        step_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) - x_t;
        step = (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - x;
        v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
        bound_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * a + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a_t) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        bound = v1 * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        tangent_slip_march__step_first_t(work, work_t, march, x, x_t, step, step_t, bound, bound_t);
        p_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) * bound + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * bound_t;
        p_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * bound;
        p_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * bound + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * bound_t;
        p_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * bound;
        if ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0)
        {
            tangent_slip_march__beyond_bound_t(&over_x, &over_x_t, &over_y, &over_y_t, work, work_t, march, x, x_t, bound, bound_t);
            p_x_t = p_x_t + over_x_t;
            p_x = p_x + over_x;
            p_y_t = p_y_t + over_y_t;
            p_y = p_y + over_y;
        }
        if (weight < 1.0)
        {
            tangent_slip_march__step_second_t(work, work_t, march, (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_X)), (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_Y)), x, x_t, step, step_t, bound, bound_t);
            tangent_slip_march__slip_traction_t(&slip_x, &slip_x_t, &slip_y, &slip_y_t, work, work_t, march, bound, bound_t);
            v2 = 1.0 - weight;
            v3 = 1.0 - weight;
            tangent_slip_march__note_largest_t(work, work_t, march, v2 * slip_x, (-weight_t) * slip_x + v2 * slip_x_t, v3 * slip_y, (-weight_t) * slip_y + v3 * slip_y_t);
            v4 = p_x - slip_x;
            p_x_t = slip_x_t + (weight_t * v4 + weight * (p_x_t - slip_x_t));
            p_x = slip_x + weight * v4;
            v5 = p_y - slip_y;
            p_y_t = slip_y_t + (weight_t * v5 + weight * (p_y_t - slip_y_t));
            p_y = slip_y + weight * v5;
        }
        tangent_slip_march__add_point_t(work, work_t, march, x, x_t, (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)), 0.0, p_x, p_x_t, p_y, p_y_t);
        q = q + INT64_C(1);
    }
    return q;
}

/* Tangent of ``beyond_bound``. */
static inline int64_t tangent_slip_march__beyond_bound_t(double* change_x, double* change_x_t, double* change_y, double* change_y_t, array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double bound, double bound_t)
{
    double reach_t;
    double reach;
    double v1;
    double v2;
    double inner_t;
    double inner;
    double v3;
    double root_t;
    double root;
    double v4;
    double p_x_t;
    double p_x;
    double v5;
    double p_y_t;
    double p_y;
    double cut_x;
    double cut_x_t;
    double cut_y;
    double cut_y_t;
    reach_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH));
    reach = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    v1 = x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    v2 = x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    inner_t = reach_t * reach + reach * reach_t - ((x_t - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH))) * v2 + v1 * (x_t - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH))));
    inner = reach * reach - v1 * v2;
    (*change_x_t) = 0.0;
    (*change_x) = 0.0;
    (*change_y_t) = 0.0;
    (*change_y) = 0.0;
    if (inner > 0.0)
    {
        v3 = sqrt(inner);
        root_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * v3 + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * tangent_rates__root_rate(v3, inner_t);
        root = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * v3;
        v4 = bound - root;
        p_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) * v4 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (bound_t - root_t);
        p_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * v4;
        v5 = bound - root;
        p_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * v5 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (bound_t - root_t) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)) * root + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root_t);
        p_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * v5 + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root;
        tangent_tractions__cut_to_t(&cut_x, &cut_x_t, &cut_y, &cut_y_t, p_x, p_x_t, p_y, p_y_t, bound, bound_t);
        (*change_x_t) = cut_x_t - p_x_t;
        (*change_x) = cut_x - p_x;
        (*change_y_t) = cut_y_t - p_y_t;
        (*change_y) = cut_y - p_y;
    }
    return 0;
}

/* Tangent of ``cross_edge``. */
static inline int64_t tangent_slip_march__cross_edge_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t q)
{
    double a_t;
    double a;
    double x_t;
    double x;
    double step_t;
    double step;
    double v1;
    double bound_t;
    double bound;
    double weight_t;
    double weight;
    double v2;
    double v2_t;
    double edge_bound_t;
    double edge_bound;
    double v3;
    double start_x_t;
    double start_x;
    double v4;
    double start_y_t;
    double start_y;
    double v5;
    double near_x_t;
    double near_x;
    double v6;
    double near_y_t;
    double near_y;
    double second_x_t;
    double second_x;
    double second_y_t;
    double second_y;
    double slip_x;
    double slip_x_t;
    double slip_y;
    double slip_y_t;
    double v7;
    double v8;
    double to_x;
    double to_x_t;
    double to_y;
    double to_y_t;
    double v9;
    double v10;
    double p_x;
    double p_x_t;
    double p_y;
    double p_y_t;
    double v11;
    double v12;
    double share_t;
    double share;
    double v13;
    double v14;
    a_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    x_t = a_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
    x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
    step_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) - x_t;
    step = (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - x;
    v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
    bound_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * a + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a_t) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
    bound = v1 * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
    weight_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT));
    weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
    tangent_slip_march__step_first_t(work, work_t, march, x, x_t, step, step_t, bound, bound_t);
    tangent_slip_march__sqrt_of_t(&v2, &v2_t, a * a - (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)), a_t * a + a * a_t - ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE))));
    edge_bound_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * v2 + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * v2_t;
    edge_bound = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * v2;
    v3 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X));
    start_x_t = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X))) * edge_bound + v3 * edge_bound_t;
    start_x = v3 * edge_bound;
    v4 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y));
    start_y_t = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y))) * edge_bound + v4 * edge_bound_t;
    start_y = v4 * edge_bound;
    v5 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X));
    near_x_t = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X))) * bound + v5 * bound_t;
    near_x = v5 * bound;
    v6 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y));
    near_y_t = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y))) * bound + v6 * bound_t;
    near_y = v6 * bound;
    if (weight < 1.0)
    {
        second_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_X));
        second_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X));
        second_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_Y));
        second_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y));
        tangent_slip_march__step_second_t(work, work_t, march, second_x, second_x_t, second_y, second_y_t, x, x_t, step, step_t, bound, bound_t);
        tangent_slip_march__slip_traction_t(&slip_x, &slip_x_t, &slip_y, &slip_y_t, work, work_t, march, bound, bound_t);
        v7 = 1.0 - weight;
        near_x_t = near_x_t + ((-weight_t) * slip_x + v7 * slip_x_t);
        near_x = near_x + v7 * slip_x;
        v8 = 1.0 - weight;
        near_y_t = near_y_t + ((-weight_t) * slip_y + v8 * slip_y_t);
        near_y = near_y + v8 * slip_y;
        tangent_slip_march__stepped_t(&to_x, &to_x_t, &to_y, &to_y_t, work, work_t, march, INT64_C(1), second_x, second_x_t, second_y, second_y_t, (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)), (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)), edge_bound, edge_bound_t);
        v9 = 1.0 - weight;
        start_x_t = start_x_t + ((-weight_t) * to_x + v9 * to_x_t);
        start_x = start_x + v9 * to_x;
        v10 = 1.0 - weight;
        start_y_t = start_y_t + ((-weight_t) * to_y + v10 * to_y_t);
        start_y = start_y + v10 * to_y;
    }
    tangent_slip_march__note_largest_t(work, work_t, march, start_x, start_x_t, start_y, start_y_t);
    tangent_slip_march__step_second_t(work, work_t, march, start_x, start_x_t, start_y, start_y_t, x, x_t, (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) - x, (*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)) - x_t, bound, bound_t);
    tangent_slip_march__slip_traction_t(&p_x, &p_x_t, &p_y, &p_y_t, work, work_t, march, bound, bound_t);
    v11 = (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) - x;
    v12 = v11 / step;
    share_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)) - x_t - v12 * step_t) / step;
    share = v12;
    v13 = p_x - near_x;
    p_x_t = near_x_t + (share_t * v13 + share * (p_x_t - near_x_t));
    p_x = near_x + share * v13;
    v14 = p_y - near_y;
    p_y_t = near_y_t + (share_t * v14 + share * (p_y_t - near_y_t));
    p_y = near_y + share * v14;
    tangent_slip_march__note_largest_t(work, work_t, march, p_x, p_x_t, p_y, p_y_t);
    tangent_slip_march__add_point_t(work, work_t, march, x, x_t, (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)), 0.0, p_x, p_x_t, p_y, p_y_t);
    return INT64_C(0);
}

/* Tangent of ``sqrt_of``. */
static inline int64_t tangent_slip_march__sqrt_of_t(double* root, double* root_t, double value, double value_t)
{
    double v1;
    (*root_t) = 0.0;
    (*root) = 0.0;
    if (value > 0.0)
    {
        v1 = sqrt(value);
        (*root_t) = tangent_rates__root_rate(v1, value_t);
        (*root) = v1;
    }
    return 0;
}

/* Tangent of ``march_slip``. */
static inline int64_t tangent_slip_march__march_slip_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t first)
{
    double a_t;
    double a;
    double top_t;
    double top;
    double lag_t;
    double lag;
    double share_t;
    double share;
    double before_t;
    double before;
    double first_x_t;
    double first_x;
    double first_y_t;
    double first_y;
    double second_x_t;
    double second_x;
    double second_y_t;
    double second_y;
    double sum_x_t;
    double sum_x;
    double sum_y_t;
    double sum_y;
    double sum_moment_t;
    double sum_moment;
    double largest_t;
    double largest;
    int64_t q;
    double x_t;
    double x;
    double weight;
    double bound_t;
    double bound;
    double step_t;
    double step;
    double at_t;
    double at;
    double v1;
    double v2;
    double v3;
    double along_t;
    double along;
    double v4;
    double across_t;
    double across;
    double square_t;
    double square;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double scale_t;
    double scale;
    double v10;
    a_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    top_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * a + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a_t;
    top = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
    lag_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LAG));
    lag = (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG));
    share_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SHARE));
    share = (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE));
    before_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X));
    before = (*cspan_at(&work, march + layout__ROLLING_MARCH_X));
    first_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X));
    first_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X));
    first_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y));
    first_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y));
    second_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_X));
    second_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X));
    second_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SECOND_Y));
    second_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y));
    sum_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X));
    sum_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X));
    sum_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y));
    sum_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y));
    sum_moment_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT));
    sum_moment = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT));
    largest_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LARGEST));
    largest = (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST));
    for (q = first; q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x_t = a_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        weight = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        bound_t = top_t * weight;
        bound = top * weight;
        step_t = before_t - x_t;
        step = before - x;
        before_t = x_t;
        before = x;
        at_t = x_t + (lag_t * step + lag * step_t);
        at = x + lag * step;
        v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * at;
        tangent_tractions__cut_to_t(&first_x, &first_x_t, &first_y, &first_y_t, first_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))), first_x_t - (step_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))) + step * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0)))), first_y - step * v1, first_y_t - (step_t * v1 + step * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * at + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * at_t))), bound, bound_t);
        v2 = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(1))) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) * at;
        tangent_tractions__cut_to_t(&second_x, &second_x_t, &second_y, &second_y_t, second_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1))), second_x_t - (step_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1))) + step * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1)))), second_y - step * v2, second_y_t - (step_t * v2 + step * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(1))) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) * at + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) * at_t))), bound, bound_t);
        v3 = second_x - first_x;
        along_t = first_x_t + (share_t * v3 + share * (second_x_t - first_x_t));
        along = first_x + share * v3;
        v4 = second_y - first_y;
        across_t = first_y_t + (share_t * v4 + share * (second_y_t - first_y_t));
        across = first_y + share * v4;
        square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
        square = along * along + across * across;
        v5 = slip_march__SOFT * slip_march__SOFT;
        v6 = bound * bound - square;
        v7 = square + v5 * v6 + slip_march__NOTHING;
        v8 = sqrt(v7);
        v9 = bound / v8;
        scale_t = (bound_t - v9 * tangent_rates__root_rate(v8, square_t + v5 * (bound_t * bound + bound * bound_t - square_t))) / v8;
        scale = v9;
        along_t = along_t * scale + along * scale_t;
        along = along * scale;
        across_t = across_t * scale + across * scale_t;
        across = across * scale;
        square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
        square = along * along + across * across;
        if (square > largest)
        {
            largest_t = square_t;
            largest = square;
        }
        sum_x_t = sum_x_t + weight * along_t;
        sum_x = sum_x + weight * along;
        sum_y_t = sum_y_t + weight * across_t;
        sum_y = sum_y + weight * across;
        v10 = weight * x;
        sum_moment_t = sum_moment_t + (weight * x_t * across + v10 * across_t);
        sum_moment = sum_moment + v10 * across;
    }
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) = sum_x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = sum_x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) = sum_y_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = sum_y;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) = sum_moment_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = sum_moment;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LARGEST)) = largest_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = largest;
    return INT64_C(0);
}
