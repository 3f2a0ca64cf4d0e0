/* Generated from tangential/coupled_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Coupled strips: creep force of any patch, strip by strip.
 *
 * Each strip has its stick zone (stick_zone.py) and its slip zone (slip_march.py), with the stiffness that it
 * has beside the others on one half-space (stiffness.py).  What an ellipse with the patch's area and length over
 * width is known to differ by from the complete theory comes to the sum (correction.py).  Sums over a strip:
 *
 *     int p dx = sum_q p_q a pi/(n + 1) sin t_q - c (e - (0, k)) (pi/2) m (a - d)^2,   x_q = a cos t_q   (T1)
 *     int x p_y dx = sum_q x_q p_q,y a pi/(n + 1) sin t_q - c (e_y - k) (pi/2) m (a - d)^2 d            (T2)
 *
 * in which the second root of eq. (Z1) is integrated exactly.
 */

#include "coupled_strips.h"

/* Force, moment, stick share and largest traction of a patch. */
static inline int64_t coupled_strips__solve_strips(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    stiffness__find_stiffnesses(work, tables, rolling);
    coupled_strips__add_strips(work, tables, rolling);
    if (!((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BARE)) == 1.0))
    {
        correction__correct_force(work, tables, rolling);
    }
    return INT64_C(0);
}

/* What the strips add up to, without correction. */
static inline int64_t coupled_strips__add_strips(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    int64_t march;
    int64_t marches;
    double ratio;
    double plane;
    double spinning;
    double stuck;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double rate;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    marches = rolling + layout__ROLLING_PATCH_MARCHES;
    ratio = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    coupled_strips__flexibilities(&plane, &spinning, work, rolling);
    slip_march__open_marches(work, marches, ratio);
    stuck = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        rate = tractions__bound_rate(work, rolling, strip);
        if (rate > 0.0)
        {
            coupled_strips__begin_march(work, rolling, strip, rate, i);
            stick_zone__find_stick_zone(work, march, (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)), ratio);
            slip_march__set_pushes(work, march, marches, i, plane, spinning, ratio);
            slip_march__set_stick(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), march, marches, i);
            stuck += 2.0 * ((*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        }
    }
    slip_march__march_strips(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), marches);
    coupled_strips__finish_marches(work, rolling);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = stuck / tractions__patch_area(work, rolling);
    return INT64_C(0);
}

/* i1/K1 and i3/K3 [1/m] of eq. (M3). */
static inline int64_t coupled_strips__flexibilities(double* result_0, double* result_1, array_double_1d work, int64_t rolling)
{
    double first;
    double second;
    double third;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double area;
    first = 0.0;
    second = 0.0;
    third = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        area = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        first += area;
        second += area * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        third += area * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    }
    (*result_0) = 0.5 * M_PI * first / second;
    (*result_1) = 0.75 * M_PI * second / third;
    return 0;
}

/* Creepages and stiffnesses of a strip. */
static inline int64_t coupled_strips__begin_march(array_double_1d work, int64_t rolling, int64_t strip, double rate, int64_t index)
{
    int64_t march;
    double along;
    double across;
    double turning;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) = rate;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
    stiffness__stiffnesses_at(&along, &across, &turning, work, rolling + layout__ROLLING_PATCH_BLOCKS, index, (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) = along;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) = across;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) = turning;
    return INT64_C(0);
}

/* Add the strips' forces, eqs. (T1), (T2), and find the largest traction. */
static inline int64_t coupled_strips__finish_marches(array_double_1d work, int64_t rolling)
{
    int64_t marches;
    double largest;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double unit;
    double square;
    marches = rolling + layout__ROLLING_PATCH_MARCHES;
    largest = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        unit = tractions__bound_rate(work, rolling, strip) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        square = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) * unit * unit;
        if (square > largest)
        {
            largest = square;
        }
        if (unit > 0.0)
        {
            unit *= tractions__point_weight(work, strip);
            tractions__add_strip(work, rolling, strip, unit * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)), unit * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)), unit * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)));
        }
    }
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = sqrt(largest);
    return INT64_C(0);
}
