/* Generated from tangential/stick_zone.py by tools/transpile_kernel.py; change that one.
 *
 * Where a strip sticks: strip theory with a bound, made continuous.
 *
 * In units of the bound's rate m the creepages of a strip are u = -K1 w_x / m, v = -K2 w_y / m [m] and
 * k = -K3 phi / m.  The strip sticks from -a + 2 d to its leading edge a, with the traction
 *
 *     p = m (e sqrt(a^2 - x^2) - (e - (0, k)) sqrt((a - d)^2 - (x - d)^2))                         (Z1)
 *     e = (u, v + k d) / d,   d^2 (1 - k^2) - 2 v k d - (U + v^2) = 0,   U = u^2 + s^2             (Z2)
 *
 * after Haines & Ollerton (1963) and Kalker (1967); without spin this is Carter's.  s^2 is twice the variance
 * of u over the strip's width, and a floor in long patches, where all strips would begin to slip at once as k
 * passes 1:
 *
 *     s^2 = (K1 phi h / m)^2 / 6 + (0.3 min(1, r/6) min(|k|, 1.5)^2 a)^2,   r = a/b of the patch     (Z3)
 *
 * Strips slip later than lines: u, v, k and s are taken 1 - (1/2) E f^2 / (d/a) times, E = 0.08 r / (1 + r),
 * f = 2 d/a - (d/a)^2, and eq. (Z2) is solved once more.                                            (Z4)
 *
 * Where the stick zone of eq. (Z2) is about to be none, or asks for tractions beyond the bound at the leading
 * edge, its weight c falls smoothly from 1 to 0, so that no force jumps:  with S(z) = z^2 (3 - 2 z),
 * D = v^2 + (1 - k^2) U, t = sqrt(1 - d/a) and q = |e (1 - t) + (0, k) t|
 *
 *     c = S(D/v^2) (1 - S(q - 1)) S((1 - d/a) / 0.1)                                               (Z5)
 *
 * of which the first two count only for k^2 > 1, the first only for v k < 0.
 */

#include "stick_zone.h"

/* Depth, direction and weight of a strip's stick zone, into its march; ``width`` [m] is the strip's,
 * ``ratio`` the patch's a/b.
 */
static inline int64_t stick_zone__find_stick_zone(array_double_1d work, int64_t march, double width, double ratio)
{
    double a;
    double inverse;
    double u;
    double v;
    double k;
    double spread;
    double depth;
    double first_weight;
    double share;
    double weight;
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    inverse = 1.0 / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    u = (-(*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) * inverse;
    v = (-(*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) * inverse;
    k = (-(*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * inverse;
    spread = stick_zone__spread_square(work, march, width * inverse, k, ratio);
    stick_zone__slip_depth(&depth, &first_weight, u * u + spread, v, k, a);
    share = stick_zone__later_share(depth / a, ratio);
    u *= share;
    v *= share;
    k *= share;
    stick_zone__slip_depth(&depth, &weight, u * u + share * share * spread, v, k, a);
    if (first_weight < weight)
    {
        weight = first_weight;
    }
    (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = a;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) = k;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = 0.0;
    if ((weight > 0.0) && (depth < a))
    {
        (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = depth;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = u / (depth + stick_zone__NOTHING);
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = v / (depth + stick_zone__NOTHING) + k;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) = weight * stick_zone__smooth_step((1.0 - depth / a) / stick_zone__FADE) * stick_zone__edge_weight(work, march);
    }
    (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) = 2.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) - a;
    return INT64_C(0);
}

/* s^2 [m^2] of eq. (Z3); ``scale`` is the strip's width over m. */
static inline double stick_zone__spread_square(array_double_1d work, int64_t march, double scale, double k, double ratio)
{
    double over_width;
    double twist;
    double long_0001;
    double floor;
    over_width = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) * scale;
    twist = fabs(k);
    if (twist > stick_zone__FLOOR_TWIST)
    {
        twist = stick_zone__FLOOR_TWIST;
    }
    long_0001 = ratio / stick_zone__FLOOR_RATIO;
    if (long_0001 > 1.0)
    {
        long_0001 = 1.0;
    }
    floor = stick_zone__FLOOR * long_0001 * twist * twist * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    return over_width * over_width / 6.0 + floor * floor;
}

/* d of eq. (Z2) [m] for ``square`` = U, and the first factor of eq. (Z5); a weight of 0 is no stick
 * zone.
 */
static inline int64_t stick_zone__slip_depth(double* depth, double* weight, double square, double v, double k, double a)
{
    double rest;
    double cross;
    double spread;
    double root;
    rest = 1.0 - k * k;
    cross = v * k;
    spread = v * v + rest * square;
    (*depth) = 2.0 * a;
    (*weight) = 0.0;
    if ((spread > 0.0) || ((rest > 0.0) && (spread == 0.0)))
    {
        root = sqrt(spread);
        if (cross <= 0.0)
        {
            (*depth) = (square + v * v) / (root - cross + stick_zone__NOTHING);
            (*weight) = 1.0;
            if (rest < 0.0)
            {
                (*weight) = stick_zone__smooth_step(spread / (v * v + stick_zone__NOTHING));
            }
        }
        else if (rest > 0.0)
        {
            (*depth) = (cross + root) / rest;
            (*weight) = 1.0;
        }
    }
    return 0;
}

/* The factor of eq. (Z4) for d/a = ``depth``. */
static inline double stick_zone__later_share(double depth, double ratio)
{
    double filled;
    double share;
    filled = 1.0;
    share = 1.0;
    if (depth < 1.0)
    {
        filled = depth * (2.0 - depth);
    }
    if (depth > 0.0)
    {
        share = 1.0 - 0.5 * stick_zone__LATER * ratio / (1.0 + ratio) * filled * (filled / depth);
    }
    return share;
}

/* The second factor of eq. (Z5). */
static inline double stick_zone__edge_weight(array_double_1d work, int64_t march)
{
    double t;
    double along;
    double across;
    double weight;
    weight = 1.0;
    if ((*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) > 1.0)
    {
        t = sqrt(1.0 - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) / (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)));
        along = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (1.0 - t);
        across = (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (1.0 - t) + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * t;
        weight = 1.0 - stick_zone__smooth_step(sqrt(along * along + across * across) - 1.0);
    }
    return weight;
}

/* S: from 0 at 0 to 1 at 1. */
static inline double stick_zone__smooth_step(double z)
{
    double value;
    value = 0.0;
    if (z >= 1.0)
    {
        value = 1.0;
    }
    else if (z > 0.0)
    {
        value = z * z * (3.0 - 2.0 * z);
    }
    return value;
}
