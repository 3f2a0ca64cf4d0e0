/* Generated from tangent_slip_march.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of slip_march.py.
 */

#include "tangent_slip_march.h"

/* Tangent of ``open_marches``. */
static inline int64_t tangent_slip_march__open_marches_t(array_double_1d work, array_double_1d work_t, int64_t marches, double ratio, double ratio_t)
{
    int64_t i;
    int64_t q;
    double v1;
    double v2;
    double square_t;
    double square;
    double v3;
    double v4;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_Y + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LAG + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SLIPS + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = 0.0;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LARGEST + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) = 0.0;
    }
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_AT_POINT + q)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q)) = -1.0;
    }
    v1 = ratio / slip_march__SHARE_RATIO;
    v2 = ratio / slip_march__SHARE_RATIO;
    square_t = ratio_t / slip_march__SHARE_RATIO * v2 + v1 * (ratio_t / slip_march__SHARE_RATIO);
    square = v1 * v2;
    v3 = 1.0 + square * square;
    v4 = slip_march__SHARE / v3;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SHARE)) = (-v4) * (square_t * square + square * square_t) / v3;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) = v4;
    return INT64_C(0);
}

/* Tangent of ``set_pushes``. */
static inline int64_t tangent_slip_march__set_pushes_t(array_double_1d work, array_double_1d work_t, int64_t march, int64_t marches, int64_t number, double plane, double plane_t, double spinning, double spinning_t, double ratio, double ratio_t)
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
    double along_t;
    double along;
    double v29;
    double across_t;
    double across;
    double v30;
    double v31;
    double turning_t;
    double turning;
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
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LAG + number)) = (lag_t - v27 * ((scale_t * fills + scale * fills_t) / v25)) / v26;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + number)) = v27;
    v28 = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    along_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP)) - v28 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    along = v28;
    v29 = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    across_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL)) - v29 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    across = v29;
    v30 = (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    v31 = v30 / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    turning_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) - v31 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    turning = v31;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_X + number)) = along_t * i1 + along * i1_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + number)) = along * i1;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_Y + number)) = across_t * i2 + across * i2_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_Y + number)) = across * i2;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_TURN + number)) = turning_t * i3 + turning * i3_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + number)) = turning * i3;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_X + number)) = along_t * centre + along * centre_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + number)) = along * centre;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_Y + number)) = across_t * centre + across * centre_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + number)) = across * centre;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_TURN + number)) = turning_t * centre + turning * centre_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + number)) = turning * centre;
    return INT64_C(0);
}

/* Tangent of ``set_stick``. */
static inline int64_t tangent_slip_march__set_stick_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t marches, int64_t number)
{
    double weight_t;
    double weight;
    double v1;
    double v2;
    double v3;
    double depth_t;
    double depth;
    double edge_t;
    double edge;
    double total;
    double moment;
    int64_t q;
    double v4;
    double v5;
    double v6;
    double v7;
    double inner_t;
    double inner;
    double v8;
    double v9;
    double across_t;
    double across;
    double v10;
    double v11;
    double v12;
    double v13;
    weight_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT));
    weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SLIPS + number)) = -weight_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + number)) = 1.0 - weight;
    v1 = 1.0 - weight;
    v2 = 1.0 - weight;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_NOTED + number)) = (-weight_t) * v2 + v1 * (-weight_t);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + number)) = v1 * v2;
    if (weight > 0.0)
    {
        v3 = (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
        depth_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) - v3 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
        depth = v3;
        edge_t = 2.0 * depth_t;
        edge = 2.0 * depth - 1.0;
        total = 0.0;
        moment = 0.0;
        q = INT64_C(0);
        while((q < layout__POINT_LIMIT) && ((*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) >= edge))
        {
            total = total + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
            moment = moment + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
            q = q + INT64_C(1);
        }
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICKS + number)) = weight_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICKS + number)) = weight;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_X + number)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X));
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + number)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X));
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_Y + number)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y));
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + number)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y));
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE + number)) = edge_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE + number)) = edge;
        v4 = 0.5 * (double)(layout__POINT_LIMIT + INT64_C(1));
        v5 = 1.0 - depth;
        v6 = v4 * v5;
        v7 = 1.0 - depth;
        inner_t = v4 * (-depth_t) * v7 + v6 * (-depth_t);
        inner = v6 * v7;
        v8 = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST));
        v9 = weight * v8;
        across_t = (weight_t * v8 + weight * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)))) * inner + v9 * inner_t;
        across = v9 * inner;
        v10 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X));
        v11 = total - inner;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + number)) = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X))) * v11 + v10 * (-inner_t);
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + number)) = v10 * v11;
        v12 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y));
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + number)) = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y))) * total - across_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + number)) = v12 * total - across;
        v13 = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y));
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) = (weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y))) * moment - (across_t * depth + across * depth_t);
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) = v13 * moment - across * depth;
        if ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0)
        {
            tangent_slip_march__add_beyond_t(tables, work, work_t, table, march, marches, number, q);
        }
        if (q < layout__POINT_LIMIT)
        {
            (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_NEXT + number)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_AT_POINT + q));
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NEXT + number)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q));
            (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_AT_POINT + q)) = 0.0;
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q)) = (double)(number);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``add_beyond``. */
static inline int64_t tangent_slip_march__add_beyond_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t marches, int64_t number, int64_t last)
{
    double v1;
    double depth_t;
    double depth;
    int64_t q;
    double bound;
    double away_t;
    double away;
    double v2;
    double v3;
    double inner_t;
    double inner;
    double v4;
    double root_t;
    double root;
    double v5;
    double p_x_t;
    double p_x;
    double v6;
    double p_y_t;
    double p_y;
    double cut_x;
    double cut_x_t;
    double cut_y;
    double cut_y_t;
    double weight_t;
    double weight;
    double v7;
    double v8;
    double v9;
    double v10;
    v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    depth_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) - v1 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    depth = v1;
    for (q = INT64_C(0); q < last; q += INT64_C(1))
    {
        bound = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        away_t = -depth_t;
        away = (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) - depth;
        v2 = 1.0 - depth;
        v3 = 1.0 - depth;
        inner_t = (-depth_t) * v3 + v2 * (-depth_t) - (away_t * away + away * away_t);
        inner = v2 * v3 - away * away;
        if (inner > 0.0)
        {
            v4 = sqrt(inner);
            root_t = tangent_rates__root_rate(v4, inner_t);
            root = v4;
            v5 = bound - root;
            p_x_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) * v5 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (-root_t);
            p_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * v5;
            v6 = bound - root;
            p_y_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * v6 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (-root_t) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)) * root + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root_t);
            p_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * v6 + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root;
            tangent_tractions__cut_to_t(&cut_x, &cut_x_t, &cut_y, &cut_y_t, p_x, p_x_t, p_y, p_y_t, bound, 0.0);
            weight_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT)) * bound;
            weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) * bound;
            v7 = cut_x - p_x;
            (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + number)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + number)) + (weight_t * v7 + weight * (cut_x_t - p_x_t));
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + number)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + number)) + weight * v7;
            v8 = cut_y - p_y;
            (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + number)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + number)) + (weight_t * v8 + weight * (cut_y_t - p_y_t));
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + number)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + number)) + weight * v8;
            v9 = weight * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
            v10 = cut_y - p_y;
            (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) + (weight_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) * v10 + v9 * (cut_y_t - p_y_t));
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) + v9 * v10;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``march_strips``. */
static inline int64_t tangent_slip_march__march_strips_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t marches)
{
    double before;
    int64_t slipping;
    int64_t q;
    double x;
    double bound;
    int64_t first;
    int64_t strip;
    before = 1.0;
    slipping = slip_march__has_slip(work, marches);
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x = (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        bound = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        first = (int64_t)((*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q)));
        strip = first;
        while(strip >= INT64_C(0))
        {
            tangent_slip_march__reach_edge_t(work, work_t, marches, strip, before, 0.0, x, 0.0, bound, 0.0);
            strip = (int64_t)((*cspan_at(&work, marches + layout__ROLLING_MARCHES_NEXT + strip)));
        }
        tangent_slip_march__march_first_t(work, work_t, marches, x, 0.0, bound, 0.0, before - x, 0.0);
        if (slipping == INT64_C(1))
        {
            tangent_slip_march__march_second_t(work, work_t, marches, x, 0.0, bound, 0.0, before - x, 0.0);
        }
        strip = first;
        while(strip >= INT64_C(0))
        {
            tangent_slip_march__leave_edge_t(work, work_t, marches, strip, x, 0.0, bound, 0.0);
            slipping = INT64_C(1);
            strip = (int64_t)((*cspan_at(&work, marches + layout__ROLLING_MARCHES_NEXT + strip)));
        }
        before = x;
    }
    return INT64_C(0);
}

/* Tangent of ``march_first``. */
static inline int64_t tangent_slip_march__march_first_t(array_double_1d work, array_double_1d work_t, int64_t marches, double x, double x_t, double bound, double bound_t, double step, double step_t)
{
    double limit_t;
    double limit;
    int64_t i;
    double at_t;
    double at;
    double along_t;
    double along;
    double v1;
    double across_t;
    double across;
    double square_t;
    double square;
    double v2;
    double v3;
    double cut_t;
    double cut;
    limit_t = bound_t * bound + bound * bound_t;
    limit = bound * bound;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        at_t = x_t + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LAG + i)) * step + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step_t);
        at = x + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step;
        along_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i)) - (step_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + i)) + step * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_X + i)));
        along = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) - step * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + i));
        v1 = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) * at;
        across_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) - (step_t * v1 + step * ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_Y + i)) + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) * at + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) * at_t)));
        across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) - step * v1;
        square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
        square = along * along + across * across;
        if (square < limit)
        {
            square_t = limit_t;
            square = limit;
        }
        v2 = sqrt(square);
        v3 = bound / v2;
        cut_t = (bound_t - v3 * tangent_rates__root_rate(v2, square_t)) / v2;
        cut = v3;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i)) = cut_t * along + cut * along_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) = cut * along;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) = cut_t * across + cut * across_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) = cut * across;
    }
    return INT64_C(0);
}

/* Tangent of ``march_second``. */
static inline int64_t tangent_slip_march__march_second_t(array_double_1d work, array_double_1d work_t, int64_t marches, double x, double x_t, double bound, double bound_t, double step, double step_t)
{
    double share_t;
    double share;
    double limit_t;
    double limit;
    double v1;
    double soft_t;
    double soft;
    int64_t i;
    double at_t;
    double at;
    double second_x_t;
    double second_x;
    double v2;
    double second_y_t;
    double second_y;
    double square_t;
    double square;
    double v3;
    double v4;
    double cut_t;
    double cut;
    double v5;
    double along_t;
    double along;
    double v6;
    double across_t;
    double across;
    double v7;
    double v8;
    double v9;
    double v10;
    double scale_t;
    double scale;
    double v11;
    double v12;
    double largest_t;
    double largest;
    double v13;
    share_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SHARE));
    share = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE));
    limit_t = bound_t * bound + bound * bound_t;
    limit = bound * bound;
    v1 = slip_march__SOFT * slip_march__SOFT;
    soft_t = v1 * limit_t;
    soft = v1 * limit;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        at_t = x_t + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LAG + i)) * step + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step_t);
        at = x + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step;
        second_x_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_X + i)) - (step_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i)) + step * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_X + i)));
        second_x = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) - step * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i));
        v2 = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * at;
        second_y_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) - (step_t * v2 + step * ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * at + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * at_t)));
        second_y = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) - step * v2;
        square_t = second_x_t * second_x + second_x * second_x_t + (second_y_t * second_y + second_y * second_y_t);
        square = second_x * second_x + second_y * second_y;
        if (square < limit)
        {
            square_t = limit_t;
            square = limit;
        }
        v3 = sqrt(square);
        v4 = bound / v3;
        cut_t = (bound_t - v4 * tangent_rates__root_rate(v3, square_t)) / v3;
        cut = v4;
        second_x_t = second_x_t * cut + second_x * cut_t;
        second_x = second_x * cut;
        second_y_t = second_y_t * cut + second_y * cut_t;
        second_y = second_y * cut;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = second_x_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = second_x;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = second_y_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = second_y;
        v5 = second_x - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i));
        along_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i)) + (share_t * v5 + share * (second_x_t - (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i))));
        along = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) + share * v5;
        v6 = second_y - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i));
        across_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) + (share_t * v6 + share * (second_y_t - (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i))));
        across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) + share * v6;
        square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
        square = along * along + across * across;
        v7 = 1.0 - slip_march__SOFT * slip_march__SOFT;
        v8 = v7 * square + soft;
        v9 = sqrt(v8);
        v10 = bound / v9;
        scale_t = (bound_t - v10 * tangent_rates__root_rate(v9, v7 * square_t + soft_t)) / v9;
        scale = v10;
        v11 = square * scale;
        v12 = v11 * scale;
        largest_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_NOTED + i)) * v12 + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) * ((square_t * scale + square * scale_t) * scale + v11 * scale_t);
        largest = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) * v12;
        if (largest < (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)))
        {
            largest_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LARGEST + i));
            largest = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i));
        }
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LARGEST + i)) = largest_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) = largest;
        v13 = bound * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i));
        scale_t = scale_t * v13 + scale * (bound_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) + bound * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SLIPS + i)));
        scale = scale * v13;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) + (scale_t * along + scale * along_t);
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) + scale * along;
        across_t = across_t * scale + across * scale_t;
        across = across * scale;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + across_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + across;
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + (x_t * across + x * across_t);
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + x * across;
    }
    return INT64_C(0);
}

/* Tangent of ``reach_edge``. */
static inline int64_t tangent_slip_march__reach_edge_t(array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double before, double before_t, double x, double x_t, double bound, double bound_t)
{
    double edge_t;
    double edge;
    double weight_t;
    double weight;
    double v1;
    double v1_t;
    double edge_bound_t;
    double edge_bound;
    double v2;
    double start_x_t;
    double start_x;
    double v3;
    double start_y_t;
    double start_y;
    double to_x;
    double to_x_t;
    double to_y;
    double to_y_t;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double near_t;
    double near;
    double v9;
    double v10;
    double v11;
    double v12;
    edge_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE + i));
    edge = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE + i));
    weight_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICKS + i));
    weight = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICKS + i));
    tangent_slip_march__sqrt_of_t(&v1, &v1_t, 1.0 - edge * edge, -(edge_t * edge + edge * edge_t));
    edge_bound_t = v1_t;
    edge_bound = v1;
    v2 = weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i));
    start_x_t = (weight_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i)) + weight * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_X + i))) * edge_bound + v2 * edge_bound_t;
    start_x = v2 * edge_bound;
    v3 = weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i));
    start_y_t = (weight_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) + weight * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_Y + i))) * edge_bound + v3 * edge_bound_t;
    start_y = v3 * edge_bound;
    if (weight < 1.0)
    {
        tangent_slip_march__stepped_t(&to_x, &to_x_t, &to_y, &to_y_t, work, work_t, marches, i, (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)), (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_X + i)), (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)), (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_Y + i)), edge, edge_t, before - edge, before_t - edge_t);
        tangent_tractions__cut_to_t(&to_x, &to_x_t, &to_y, &to_y_t, to_x, to_x_t, to_y, to_y_t, edge_bound, edge_bound_t);
        v4 = 1.0 - weight;
        start_x_t = start_x_t + ((-weight_t) * to_x + v4 * to_x_t);
        start_x = start_x + v4 * to_x;
        v5 = 1.0 - weight;
        start_y_t = start_y_t + ((-weight_t) * to_y + v5 * to_y_t);
        start_y = start_y + v5 * to_y;
    }
    tangent_slip_march__note_largest_t(work, work_t, marches, i, start_x, start_x_t, start_y, start_y_t);
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_X + i)) = start_x_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_X + i)) = start_x;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_Y + i)) = start_y_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_Y + i)) = start_y;
    v6 = edge - x;
    v7 = before - x;
    v8 = v6 / v7;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i)) = (edge_t - x_t - v8 * (before_t - x_t)) / v7;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i)) = v8;
    near_t = -(*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i));
    near = 1.0 - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i));
    v9 = 1.0 - weight;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SLIPS + i)) = near_t * v9 + near * (-weight_t);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) = near * v9;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
    v10 = near * bound;
    v11 = v10 * bound;
    weight_t = weight_t * v11 + weight * ((near_t * bound + near * bound_t) * bound + v10 * bound_t);
    weight = weight * v11;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) + (weight_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i)) + weight * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_X + i)));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) + weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i));
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + (weight_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) + weight * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_Y + i)));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i));
    v12 = weight * x;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + ((weight_t * x + weight * x_t) * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) + v12 * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_Y + i)));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + v12 * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i));
    return INT64_C(0);
}

/* Tangent of ``leave_edge``. */
static inline int64_t tangent_slip_march__leave_edge_t(array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double x, double x_t, double bound, double bound_t)
{
    double weight_t;
    double weight;
    double near_t;
    double near;
    double p_x_t;
    double p_x;
    double p_y_t;
    double p_y;
    double slip_x;
    double slip_x_t;
    double slip_y;
    double slip_y_t;
    double step_t;
    double step;
    double to_x;
    double to_x_t;
    double to_y;
    double to_y_t;
    double share_t;
    double share;
    double v1;
    double v2;
    double v3;
    weight_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICKS + i));
    weight = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICKS + i));
    near_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SLIPS + i));
    near = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i));
    p_x_t = 0.0;
    p_x = 0.0;
    p_y_t = 0.0;
    p_y = 0.0;
    if (weight < 1.0)
    {
        tangent_slip_march__slip_traction_t(&slip_x, &slip_x_t, &slip_y, &slip_y_t, work, work_t, marches, i, bound, bound_t);
        p_x_t = near_t * slip_x + near * slip_x_t;
        p_x = near * slip_x;
        p_y_t = near_t * slip_y + near * slip_y_t;
        p_y = near * slip_y;
    }
    step_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE + i)) - x_t;
    step = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE + i)) - x;
    tangent_slip_march__stepped_t(&to_x, &to_x_t, &to_y, &to_y_t, work, work_t, marches, i, (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_X + i)), (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_X + i)), (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_Y + i)), (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_Y + i)), x, x_t, step, step_t);
    tangent_tractions__cut_to_t(&to_x, &to_x_t, &to_y, &to_y_t, to_x, to_x_t, to_y, to_y_t, bound, bound_t);
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = to_x_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = to_x;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = to_y_t;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = to_y;
    tangent_slip_march__slip_traction_t(&slip_x, &slip_x_t, &slip_y, &slip_y_t, work, work_t, marches, i, bound, bound_t);
    share_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i));
    share = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i));
    slip_x_t = slip_x_t * share + slip_x * share_t;
    slip_x = slip_x * share;
    slip_y_t = slip_y_t * share + slip_y * share_t;
    slip_y = slip_y * share;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)) + (bound_t * slip_x + bound * slip_x_t);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) + bound * slip_x;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + (bound_t * slip_y + bound * slip_y_t);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + bound * slip_y;
    v1 = bound * x;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + ((bound_t * x + bound * x_t) * slip_y + v1 * slip_y_t);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + v1 * slip_y;
    v2 = 1.0 - share;
    v3 = v2 * bound;
    weight_t = weight_t * v3 + weight * ((-share_t) * bound + v2 * bound_t);
    weight = weight * v3;
    tangent_slip_march__note_largest_t(work, work_t, marches, i, p_x + weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i)) + slip_x, p_x_t + (weight_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i)) + weight * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_X + i))) + slip_x_t, p_y + weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) + slip_y, p_y_t + (weight_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) + weight * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_STICK_Y + i))) + slip_y_t);
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SLIPS + i)) = 0.0;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) = 1.0;
    (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) = 1.0;
    return INT64_C(0);
}

/* Tangent of ``stepped``. */
static inline int64_t tangent_slip_march__stepped_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double p_x, double p_x_t, double p_y, double p_y_t, double x, double x_t, double step, double step_t)
{
    double v1;
    double across_t;
    double across;
    v1 = x + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step;
    across_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * v1 + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * (x_t + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LAG + i)) * step + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step_t)));
    across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * v1;
    (*result_0) = p_x - step * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i));
    (*result_1) = p_x_t - (step_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i)) + step * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_CENTRE_X + i)));
    (*result_2) = p_y - step * across;
    (*result_3) = p_y_t - (step_t * across + step * across_t);
    return 0;
}

/* Tangent of ``slip_traction``. */
static inline int64_t tangent_slip_march__slip_traction_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double bound, double bound_t)
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
    v1 = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i));
    along_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i)) + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SHARE)) * v1 + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) * ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_X + i)) - (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_X + i))));
    along = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) * v1;
    v2 = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i));
    across_t = (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) + ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SHARE)) * v2 + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) * ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) - (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_FIRST_Y + i))));
    across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) * v2;
    square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
    square = along * along + across * across;
    v3 = slip_march__SOFT * slip_march__SOFT;
    v4 = bound * bound - square;
    v5 = square + v3 * v4;
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

/* Tangent of ``note_largest``. */
static inline int64_t tangent_slip_march__note_largest_t(array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double p_x, double p_x_t, double p_y, double p_y_t)
{
    double square_t;
    double square;
    square_t = p_x_t * p_x + p_x * p_x_t + (p_y_t * p_y + p_y * p_y_t);
    square = p_x * p_x + p_y * p_y;
    if (square > (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)))
    {
        (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LARGEST + i)) = square_t;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) = square;
    }
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
