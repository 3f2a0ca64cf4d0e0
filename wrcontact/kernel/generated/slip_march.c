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
 *
 * All strips march side by side, with places over a and tractions over m a, so that bounds and steps are those
 * of all of them, and compilers do several strips at once.
 */

#include "slip_march.h"

/* Nothing is pushed and nothing counts yet in any strip; ``ratio`` is the patch's a/b. */
static inline int64_t slip_march__open_marches(array_double_1d work, int64_t marches, double ratio)
{
    int64_t i;
    int64_t q;
    double square;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) = 0.0;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) = 0.0;
    }
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q)) = -1.0;
    }
    square = ratio / slip_march__SHARE_RATIO * (ratio / slip_march__SHARE_RATIO);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) = slip_march__SHARE / (1.0 + square * square);
    return INT64_C(0);
}

/* What both marches of strip ``number`` lose per way, eqs. (M1) to (M4); ``plane`` = i1/K1 = i2/K2 and
 * ``spinning`` = i3/K3 [1/m] of the patch, ``ratio`` its a/b.
 */
static inline int64_t slip_march__set_pushes(array_double_1d work, int64_t march, int64_t marches, int64_t number, double plane, double spinning, double ratio)
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
    double along;
    double across;
    double turning;
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
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + number)) = lag / (1.0 + scale * fills / (slip_march__LAG_FILLS * slip_march__LAG_FILLS));
    along = (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    turning = (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + number)) = along * i1;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_Y + number)) = across * i2;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + number)) = turning * i3;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + number)) = along * centre;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + number)) = across * centre;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + number)) = turning * centre;
    return INT64_C(0);
}

/* Begin the sums of strip ``number`` with its stick zone: eqs. (T1), (T2) without what slips, and the
 * points before the edge; the first point behind the edge takes note of the strip.
 */
static inline int64_t slip_march__set_stick(array_double_1d tables, array_double_1d work, int64_t table, int64_t march, int64_t marches, int64_t number)
{
    double weight;
    double depth;
    double edge;
    double total;
    double moment;
    int64_t q;
    double inner;
    double across;
    weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + number)) = 1.0 - weight;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + number)) = (1.0 - weight) * (1.0 - weight);
    if (weight > 0.0)
    {
        depth = (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
        edge = 2.0 * depth - 1.0;
        total = 0.0;
        moment = 0.0;
        q = INT64_C(0);
        while((q < layout__POINT_LIMIT) && ((*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) >= edge))
        {
            total += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
            moment += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
            q += INT64_C(1);
        }
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICKS + number)) = weight;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + number)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X));
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + number)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y));
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE + number)) = edge;
        inner = 0.5 * (double)(layout__POINT_LIMIT + INT64_C(1)) * (1.0 - depth) * (1.0 - depth);
        across = weight * ((*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST))) * inner;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + number)) = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (total - inner);
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + number)) = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * total - across;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) = weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * moment - across * depth;
        if ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0)
        {
            slip_march__add_beyond(tables, work, table, march, marches, number, q);
        }
        if (q < layout__POINT_LIMIT)
        {
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NEXT + number)) = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q));
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_AT_POINT + q)) = (double)(number);
        }
    }
    return INT64_C(0);
}

/* Add what eq. (Z1) has to be changed by to stay within the bound, at the points before ``last``. */
static inline int64_t slip_march__add_beyond(array_double_1d tables, array_double_1d work, int64_t table, int64_t march, int64_t marches, int64_t number, int64_t last)
{
    double depth;
    int64_t q;
    double bound;
    double away;
    double inner;
    double root;
    double p_x;
    double p_y;
    double cut_x;
    double cut_y;
    double weight;
    depth = (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    for (q = INT64_C(0); q < last; q += INT64_C(1))
    {
        bound = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        away = (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) - depth;
        inner = (1.0 - depth) * (1.0 - depth) - away * away;
        if (inner > 0.0)
        {
            root = sqrt(inner);
            p_x = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (bound - root);
            p_y = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (bound - root) + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root;
            tractions__cut_to(&cut_x, &cut_y, p_x, p_y, bound);
            weight = (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) * bound;
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + number)) += weight * (cut_x - p_x);
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + number)) += weight * (cut_y - p_y);
            (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + number)) += weight * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q)) * (cut_y - p_y);
        }
    }
    return INT64_C(0);
}

/* Add the points of all strips, from the leading edge on, to their sums. */
static inline int64_t slip_march__march_strips(array_double_1d tables, array_double_1d work, int64_t table, int64_t marches)
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
            slip_march__reach_edge(work, marches, strip, before, x, bound);
            strip = (int64_t)((*cspan_at(&work, marches + layout__ROLLING_MARCHES_NEXT + strip)));
        }
        slip_march__march_first(work, marches, x, bound, before - x);
        if (slipping == INT64_C(1))
        {
            slip_march__march_second(work, marches, x, bound, before - x);
        }
        strip = first;
        while(strip >= INT64_C(0))
        {
            slip_march__leave_edge(work, marches, strip, x, bound);
            slipping = INT64_C(1);
            strip = (int64_t)((*cspan_at(&work, marches + layout__ROLLING_MARCHES_NEXT + strip)));
        }
        before = x;
    }
    return INT64_C(0);
}

/* 1 if slip counts in some strip at its leading edge, else 0. */
static inline int64_t slip_march__has_slip(array_double_1d work, int64_t marches)
{
    int64_t i;
    int64_t found;
    found = INT64_C(0);
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        if ((*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) > 0.0)
        {
            found = INT64_C(1);
        }
    }
    return found;
}

/* Let march A of all strips come to ``x``, a ``step`` further, eq. (M1). */
static inline int64_t slip_march__march_first(array_double_1d work, int64_t marches, double x, double bound, double step)
{
    double limit;
    int64_t i;
    double at;
    double along;
    double across;
    double square;
    double cut;
    limit = bound * bound;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        at = x + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step;
        along = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) - step * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_X + i));
        across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) - step * ((*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_PUSH_TURN + i)) * at);
        square = along * along + across * across;
        if (square < limit)
        {
            square = limit;
        }
        cut = bound / sqrt(square);
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) = cut * along;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) = cut * across;
    }
    return INT64_C(0);
}

/* The same for march B, and add what slips there: eqs. (M2), (M5), most of all time that the model
 * takes.
 */
static inline int64_t slip_march__march_second(array_double_1d work, int64_t marches, double x, double bound, double step)
{
    double share;
    double limit;
    double soft;
    int64_t i;
    double at;
    double second_x;
    double second_y;
    double square;
    double cut;
    double along;
    double across;
    double scale;
    double largest;
    share = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE));
    limit = bound * bound;
    soft = slip_march__SOFT * slip_march__SOFT * limit;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        at = x + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step;
        second_x = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) - step * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i));
        second_y = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) - step * ((*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * at);
        square = second_x * second_x + second_y * second_y;
        if (square < limit)
        {
            square = limit;
        }
        cut = bound / sqrt(square);
        second_x *= cut;
        second_y *= cut;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = second_x;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = second_y;
        along = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) + share * (second_x - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)));
        across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) + share * (second_y - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)));
        square = along * along + across * across;
        scale = bound / sqrt((1.0 - slip_march__SOFT * slip_march__SOFT) * square + soft);
        largest = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) * (square * scale * scale);
        if (largest < (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)))
        {
            largest = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i));
        }
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) = largest;
        scale *= bound * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i));
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) += scale * along;
        across *= scale;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) += across;
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) += x * across;
    }
    return INT64_C(0);
}

/* The traction of strip ``i`` at the edge of its stick zone, between ``before`` and the point ``x``, and
 * how much slip counts at that point.
 */
static inline int64_t slip_march__reach_edge(array_double_1d work, int64_t marches, int64_t i, double before, double x, double bound)
{
    double edge;
    double weight;
    double edge_bound;
    double start_x;
    double start_y;
    double to_x;
    double to_y;
    double near;
    edge = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE + i));
    weight = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICKS + i));
    edge_bound = slip_march__sqrt_of(1.0 - edge * edge);
    start_x = weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i)) * edge_bound;
    start_y = weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) * edge_bound;
    if (weight < 1.0)
    {
        slip_march__stepped(&to_x, &to_y, work, marches, i, (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)), (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)), edge, before - edge);
        tractions__cut_to(&to_x, &to_y, to_x, to_y, edge_bound);
        start_x += (1.0 - weight) * to_x;
        start_y += (1.0 - weight) * to_y;
    }
    slip_march__note_largest(work, marches, i, start_x, start_y);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_X + i)) = start_x;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_Y + i)) = start_y;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i)) = (edge - x) / (before - x);
    near = 1.0 - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) = near * (1.0 - weight);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) = 0.0;
    weight *= near * bound * bound;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) += weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) += weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i));
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) += weight * x * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i));
    return INT64_C(0);
}

/* Let the second march of strip ``i`` begin at the edge of its stick zone, and add the rest of its
 * traction at ``x``, the first point behind.
 */
static inline int64_t slip_march__leave_edge(array_double_1d work, int64_t marches, int64_t i, double x, double bound)
{
    double weight;
    double near;
    double p_x;
    double p_y;
    double slip_x;
    double slip_y;
    double step;
    double to_x;
    double to_y;
    double share;
    weight = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICKS + i));
    near = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i));
    p_x = 0.0;
    p_y = 0.0;
    if (weight < 1.0)
    {
        slip_march__slip_traction(&slip_x, &slip_y, work, marches, i, bound);
        p_x = near * slip_x;
        p_y = near * slip_y;
    }
    step = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE + i)) - x;
    slip_march__stepped(&to_x, &to_y, work, marches, i, (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_X + i)), (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_Y + i)), x, step);
    tractions__cut_to(&to_x, &to_y, to_x, to_y, bound);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) = to_x;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) = to_y;
    slip_march__slip_traction(&slip_x, &slip_y, work, marches, i, bound);
    share = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_EDGE_SHARE + i));
    slip_x *= share;
    slip_y *= share;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) += bound * slip_x;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) += bound * slip_y;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) += bound * x * slip_y;
    weight *= (1.0 - share) * bound;
    slip_march__note_largest(work, marches, i, p_x + weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_X + i)) + slip_x, p_y + weight * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_STICK_Y + i)) + slip_y);
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SLIPS + i)) = 1.0;
    (*cspan_at(&work, marches + layout__ROLLING_MARCHES_NOTED + i)) = 1.0;
    return INT64_C(0);
}

/* The traction of the second march of strip ``i`` at ``x``, a ``step`` further, not yet cut; eq. (M2). */
static inline int64_t slip_march__stepped(double* result_0, double* result_1, array_double_1d work, int64_t marches, int64_t i, double p_x, double p_y, double x, double step)
{
    double across;
    across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_TURN + i)) * (x + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LAG + i)) * step);
    (*result_0) = p_x - step * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_CENTRE_X + i));
    (*result_1) = p_y - step * across;
    return 0;
}

/* The traction of strip ``i`` of eq. (M5). */
static inline int64_t slip_march__slip_traction(double* result_0, double* result_1, array_double_1d work, int64_t marches, int64_t i, double bound)
{
    double along;
    double across;
    double square;
    double scale;
    along = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) * ((*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_X + i)) - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_X + i)));
    across = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)) + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SHARE)) * ((*cspan_at(&work, marches + layout__ROLLING_MARCHES_SECOND_Y + i)) - (*cspan_at(&work, marches + layout__ROLLING_MARCHES_FIRST_Y + i)));
    square = along * along + across * across;
    scale = bound / sqrt(square + slip_march__SOFT * slip_march__SOFT * (bound * bound - square));
    (*result_0) = along * scale;
    (*result_1) = across * scale;
    return 0;
}

/* Keep the largest traction of strip ``i``. */
static inline int64_t slip_march__note_largest(array_double_1d work, int64_t marches, int64_t i, double p_x, double p_y)
{
    double square;
    square = p_x * p_x + p_y * p_y;
    if (square > (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)))
    {
        (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) = square;
    }
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
