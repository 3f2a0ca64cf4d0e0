/* Generated from tangential/slip_march.py by tools/transpile_kernel.py; change that one.
 *
 * Tractions of a strip from its leading edge to its trailing one.
 *
 * In the slip zone the traction is the bound; two marches tell its direction.  Both lose traction to the slip,
 * over steps D = x_{q-1} - x_q, and are cut to the bound g = m sqrt(a^2 - x^2):
 *
 *     p_A <- p_A - D (w_x i1, w_y i2 + phi x_m i3)   from zero at the leading edge,                (M1)
 *     p_B <- p_B - D i_c (w_x, w_y + phi x_m)        from the edge of the stick zone,              (M2)
 *     i1 = (pi/2) K1 sum(a h)/sum(a^2 h),  i2 the same with K2,
 *     i3 = (3 pi/4) K3 sum(a^2 h)/sum(a^3 h),   s = 3 pi a phi / 32,
 *     i_c = (w_x^2 i1 + w_y^2 i2 + s^2 i3) / (w_x^2 + w_y^2 + s^2)                                  (M3)
 *
 * x_m = x_q + L D.  A describes long patches, B has the direction of the rigid slip where that is large.  With
 * t = 2 sqrt(w_x^2 i1^2 + w_y^2 i2^2 + s^2 i3^2)/m, how often the creepage fills the bound, A becomes B:
 *
 *     i_j <- i_c + (i_j - i_c) / (1 + (t/6)^2),   L = (0.4 + 0.1 r/(r + 3)) / (1 + (t'/20)^2)       (M4)
 *
 * with t' = t for the new i_j.  The direction is that of c = (1 - W) p_A + W p_B, W = 0.65/(1 + (r/1.2)^4),
 *
 *     n = c g / sqrt(|c|^2 + 0.05^2 (g^2 - |c|^2))                                                 (M5)
 *
 * Where the stick zone (stick_zone.py) has the weight c < 1, the rest of the traction is that of a strip which
 * slips all over.  The first point behind the stick zone takes over in proportion to the way from its edge.
 */

#include "slip_march.h"

/* What both marches lose per way, eqs. (M1) to (M4); ``plane`` = i1/K1 = i2/K2 and ``spinning`` = i3/K3
 * [1/m] of the patch, ``ratio`` its a/b.
 */
static inline int64_t slip_march__set_pushes(array_double_1d work, int64_t march, double plane, double spinning, double ratio)
{
    double i1;
    double i2;
    double i3;
    double s;
    double x;
    double y;
    double z;
    double centre;
    double fills;
    double scale;
    double near;
    double lag;
    double square;
    i1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * plane;
    i2 = (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) * plane;
    i3 = (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) * spinning;
    s = 3.0 * M_PI / 32.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN));
    x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP));
    y = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL));
    z = s * s;
    centre = (x * i1 + y * i2 + z * i3 + slip_march__NOTHING * i1) / (x + y + z + slip_march__NOTHING);
    fills = x * i1 * i1 + y * i2 * i2 + z * i3 * i3;
    scale = 4.0 / ((*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)));
    near = 1.0 / (1.0 + scale * fills / (slip_march__FILLS * slip_march__FILLS));
    i1 = centre + (i1 - centre) * near;
    i2 = centre + (i2 - centre) * near;
    i3 = centre + (i3 - centre) * near;
    fills = x * i1 * i1 + y * i2 * i2 + z * i3 * i3;
    lag = slip_march__LAG + slip_march__LONG_LAG * ratio / (ratio + slip_march__LAG_RATIO);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG)) = lag / (1.0 + scale * fills / (slip_march__LAG_FILLS * slip_march__LAG_FILLS));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * i1;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * i2;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * i3;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * centre;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(1))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * centre;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * centre;
    square = ratio / slip_march__SHARE_RATIO * (ratio / slip_march__SHARE_RATIO);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) = slip_march__SHARE / (1.0 + square * square);
    return INT64_C(0);
}

/* Sums of the tractions over the points of a strip, and the largest of them. */
static inline int64_t slip_march__march_strip(array_double_1d tables, array_double_1d work, int64_t table, int64_t march)
{
    int64_t first;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = 0.0;
    first = INT64_C(0);
    if ((*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) > 0.0)
    {
        if (((*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) < 1.0) || ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0))
        {
            first = slip_march__march_stick(tables, work, table, march);
        }
        else
        {
            first = slip_march__march_held(tables, work, table, march);
        }
        if (first < layout__POINT_LIMIT)
        {
            slip_march__cross_edge(tables, work, table, march, first);
            first += INT64_C(1);
        }
    }
    slip_march__march_slip(tables, work, table, march, first);
    return INT64_C(0);
}

/* The traction of march ``index`` at ``x``, a ``step`` further, eq. (M1) or (M2). */
static inline int64_t slip_march__stepped(double* result_0, double* result_1, array_double_1d work, int64_t march, int64_t index, double p_x, double p_y, double x, double step, double bound)
{
    double across;
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + index)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + index)) * (x + (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG)) * step);
    tractions__cut_to(result_0, result_1, p_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + index)), p_y - step * across, bound);
    return 0;
}

/* Let the first march come to ``x``, a ``step`` further. */
static inline int64_t slip_march__step_first(array_double_1d work, int64_t march, double x, double step, double bound)
{
    double p_x;
    double p_y;
    slip_march__stepped(&p_x, &p_y, work, march, INT64_C(0), (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)), (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)), x, step, bound);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = p_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = p_y;
    return INT64_C(0);
}

/* Let the second march come to ``x``, a ``step`` further, from this traction. */
static inline int64_t slip_march__step_second(array_double_1d work, int64_t march, double from_x, double from_y, double x, double step, double bound)
{
    double p_x;
    double p_y;
    slip_march__stepped(&p_x, &p_y, work, march, INT64_C(1), from_x, from_y, x, step, bound);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)) = p_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)) = p_y;
    return INT64_C(0);
}

/* The traction of eq. (M5). */
static inline int64_t slip_march__slip_traction(double* result_0, double* result_1, array_double_1d work, int64_t march, double bound)
{
    double along;
    double across;
    double square;
    double scale;
    along = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) * ((*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)));
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE)) * ((*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)));
    square = along * along + across * across;
    scale = bound / sqrt(square + slip_march__SOFT * slip_march__SOFT * (bound * bound - square) + slip_march__NOTHING);
    (*result_0) = along * scale;
    (*result_1) = across * scale;
    return 0;
}

/* Add the traction of a point to the sums. */
static inline int64_t slip_march__add_point(array_double_1d work, int64_t march, double x, double weight, double p_x, double p_y)
{
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) += weight * p_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) += weight * p_y;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) += weight * x * p_y;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = x;
    return INT64_C(0);
}

/* Keep the largest traction. */
static inline int64_t slip_march__note_largest(array_double_1d work, int64_t march, double p_x, double p_y)
{
    double square;
    square = p_x * p_x + p_y * p_y;
    if (square > (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)))
    {
        (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = square;
    }
    return INT64_C(0);
}

/* Add the points of a stick zone that counts as a whole and stays within the bound, without the second
 * root of eq. (Z1); the first point behind.
 */
static inline int64_t slip_march__march_held(array_double_1d tables, array_double_1d work, int64_t table, int64_t march)
{
    double a;
    double top;
    double lag;
    double before;
    double first_x;
    double first_y;
    double sum_x;
    double sum_moment;
    double x;
    double bound;
    double step;
    int64_t q;
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    top = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
    lag = (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG));
    before = (*cspan_at(&work, march + layout__ROLLING_MARCH_X));
    first_x = 0.0;
    first_y = 0.0;
    sum_x = 0.0;
    sum_moment = 0.0;
    q = INT64_C(0);
    while((q < layout__POINT_LIMIT) && (a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) >= (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE))))
    {
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        bound = top * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        step = before - x;
        before = x;
        tractions__cut_to(&first_x, &first_y, first_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))), first_y - step * ((*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * (x + lag * step)), bound);
        sum_x += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * bound;
        sum_moment += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * bound * x;
        q += INT64_C(1);
    }
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = before;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = first_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = first_y;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * sum_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * sum_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * sum_moment;
    return q;
}

/* Add the points of the stick zone, without the second root of eq. (Z1) but for what cuts it to the
 * bound; the first point behind.
 */
static inline int64_t slip_march__march_stick(array_double_1d tables, array_double_1d work, int64_t table, int64_t march)
{
    double a;
    double weight;
    double x;
    double step;
    double bound;
    double p_x;
    double p_y;
    double over_x;
    double over_y;
    double slip_x;
    double slip_y;
    int64_t q;
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
    q = INT64_C(0);
    while((q < layout__POINT_LIMIT) && (a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) >= (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE))))
    {
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        step = (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - x;
        bound = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        slip_march__step_first(work, march, x, step, bound);
        p_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * bound;
        p_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * bound;
        if ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0)
        {
            slip_march__beyond_bound(&over_x, &over_y, work, march, x, bound);
            p_x += over_x;
            p_y += over_y;
        }
        if (weight < 1.0)
        {
            slip_march__step_second(work, march, (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X)), (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y)), x, step, bound);
            slip_march__slip_traction(&slip_x, &slip_y, work, march, bound);
            slip_march__note_largest(work, march, (1.0 - weight) * slip_x, (1.0 - weight) * slip_y);
            p_x = slip_x + weight * (p_x - slip_x);
            p_y = slip_y + weight * (p_y - slip_y);
        }
        slip_march__add_point(work, march, x, (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)), p_x, p_y);
        q += INT64_C(1);
    }
    return q;
}

/* What eq. (Z1) has to be changed by to stay within the bound. */
static inline int64_t slip_march__beyond_bound(double* change_x, double* change_y, array_double_1d work, int64_t march, double x, double bound)
{
    double reach;
    double inner;
    double root;
    double p_x;
    double p_y;
    double cut_x;
    double cut_y;
    reach = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    inner = reach * reach - (x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH))) * (x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)));
    (*change_x) = 0.0;
    (*change_y) = 0.0;
    if (inner > 0.0)
    {
        root = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * sqrt(inner);
        p_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (bound - root);
        p_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (bound - root) + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root;
        tractions__cut_to(&cut_x, &cut_y, p_x, p_y, bound);
        (*change_x) = cut_x - p_x;
        (*change_y) = cut_y - p_y;
    }
    return 0;
}

/* Add point ``q``, the first one behind the stick zone, and let the second march begin at its edge. */
static inline int64_t slip_march__cross_edge(array_double_1d tables, array_double_1d work, int64_t table, int64_t march, int64_t q)
{
    double a;
    double x;
    double step;
    double bound;
    double weight;
    double edge_bound;
    double start_x;
    double start_y;
    double near_x;
    double near_y;
    double second_x;
    double second_y;
    double slip_x;
    double slip_y;
    double to_x;
    double to_y;
    double p_x;
    double p_y;
    double share;
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
    step = (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - x;
    bound = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
    weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
    slip_march__step_first(work, march, x, step, bound);
    edge_bound = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * slip_march__sqrt_of(a * a - (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)));
    start_x = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * edge_bound;
    start_y = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * edge_bound;
    near_x = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * bound;
    near_y = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * bound;
    if (weight < 1.0)
    {
        second_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X));
        second_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y));
        slip_march__step_second(work, march, second_x, second_y, x, step, bound);
        slip_march__slip_traction(&slip_x, &slip_y, work, march, bound);
        near_x += (1.0 - weight) * slip_x;
        near_y += (1.0 - weight) * slip_y;
        slip_march__stepped(&to_x, &to_y, work, march, INT64_C(1), second_x, second_y, (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)), (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)), edge_bound);
        start_x += (1.0 - weight) * to_x;
        start_y += (1.0 - weight) * to_y;
    }
    slip_march__note_largest(work, march, start_x, start_y);
    slip_march__step_second(work, march, start_x, start_y, x, (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) - x, bound);
    slip_march__slip_traction(&p_x, &p_y, work, march, bound);
    share = ((*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) - x) / step;
    p_x = near_x + share * (p_x - near_x);
    p_y = near_y + share * (p_y - near_y);
    slip_march__note_largest(work, march, p_x, p_y);
    slip_march__add_point(work, march, x, (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)), p_x, p_y);
    return INT64_C(0);
}

/* Square root, of nothing below zero. */
static inline double slip_march__sqrt_of(double value)
{
    double root;
    root = 0.0;
    if (value > 0.0)
    {
        root = sqrt(value);
    }
    return root;
}

/* Add the points of the slip zone from ``first`` on: eqs. (M1), (M2), (M5), most of all time that the
 * model takes, so that nothing is kept in the record meanwhile.
 */
static inline int64_t slip_march__march_slip(array_double_1d tables, array_double_1d work, int64_t table, int64_t march, int64_t first)
{
    double a;
    double top;
    double lag;
    double share;
    double before;
    double first_x;
    double first_y;
    double second_x;
    double second_y;
    double sum_x;
    double sum_y;
    double sum_moment;
    double largest;
    int64_t q;
    double x;
    double weight;
    double bound;
    double step;
    double at;
    double along;
    double across;
    double square;
    double scale;
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    top = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
    lag = (*cspan_at(&work, march + layout__ROLLING_MARCH_LAG));
    share = (*cspan_at(&work, march + layout__ROLLING_MARCH_SHARE));
    before = (*cspan_at(&work, march + layout__ROLLING_MARCH_X));
    first_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X));
    first_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y));
    second_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_X));
    second_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_SECOND_Y));
    sum_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X));
    sum_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y));
    sum_moment = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT));
    largest = (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST));
    for (q = first; q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        weight = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        bound = top * weight;
        step = before - x;
        before = x;
        at = x + lag * step;
        tractions__cut_to(&first_x, &first_y, first_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(0))), first_y - step * ((*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(0))) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(0))) * at), bound);
        tractions__cut_to(&second_x, &second_y, second_x - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X + INT64_C(1))), second_y - step * ((*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y + INT64_C(1))) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN + INT64_C(1))) * at), bound);
        along = first_x + share * (second_x - first_x);
        across = first_y + share * (second_y - first_y);
        square = along * along + across * across;
        scale = bound / sqrt(square + slip_march__SOFT * slip_march__SOFT * (bound * bound - square) + slip_march__NOTHING);
        along *= scale;
        across *= scale;
        square = along * along + across * across;
        if (square > largest)
        {
            largest = square;
        }
        sum_x += weight * along;
        sum_y += weight * across;
        sum_moment += weight * x * across;
    }
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = sum_x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = sum_y;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = sum_moment;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = largest;
    return INT64_C(0);
}
