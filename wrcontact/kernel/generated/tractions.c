/* Generated from tangential/tractions.py by tools/transpile_kernel.py; change that one.
 *
 * Tractions along a strip: points, bound, and sums.
 *
 * The points x_q = a cos(q pi / (n + 1)), q = 1 ... n, run from the leading edge at a to the trailing one at -a.
 * With the weights a pi / (n + 1) sin(q pi / (n + 1)) the bound m sqrt(a^2 - x^2) is integrated exactly.  m is
 * the coefficient of friction times the pressure on the strip's middle over its half-length.
 */

#include "tractions.h"

/* m of a strip [Pa/m]: its bound on traction is m sqrt(a^2 - x^2); 0 where the strip carries nothing. */
static inline double tractions__bound_rate(array_double_1d work, int64_t rolling, int64_t strip)
{
    double a;
    double rate;
    a = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    rate = 0.0;
    if (((*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) > tractions__SLIGHT * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD))) && (a > tractions__SLIGHT * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH))))
    {
        rate = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * 2.0 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) / (M_PI * a * a);
    }
    return rate;
}

/* A traction, cut to its bound. */
static inline int64_t tractions__cut_to(double* result_0, double* result_1, double along, double across, double bound)
{
    double square;
    double share;
    square = along * along + across * across;
    if (square > bound * bound)
    {
        share = bound / sqrt(square);
        along *= share;
        across *= share;
    }
    (*result_0) = along;
    (*result_1) = across;
    return 0;
}

/* Add a strip's force per width [N/m] to the patch's force; ``moment`` is that of the lateral force about
 * the strip's own middle, per width [N].
 */
static inline int64_t tractions__add_strip(array_double_1d work, int64_t rolling, int64_t strip, double along, double across, double moment)
{
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = along;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) = across;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) = moment + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * across;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) += along * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) += across * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) += (moment + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * across - (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) * along) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    return INT64_C(0);
}

/* Area of the strips [m^2]. */
static inline double tractions__patch_area(array_double_1d work, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double area;
    area = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        area += 2.0 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    }
    return area;
}

/* Weight of a point of a strip [m], over its sine. */
static inline double tractions__point_weight(array_double_1d work, int64_t strip)
{
    double result;
    result = tractions__WEIGHT * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    return result;
}
