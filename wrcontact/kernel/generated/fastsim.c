/* Generated from tangential/fastsim.py by tools/transpile_kernel.py; change that one.
 *
 * FASTSIM, Kalker's simplified theory.
 *
 * J. J. Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System Dynamics 11 (1982)
 * 1-13.  The surface gives way like u = L p, so that along a strip, in the direction of rolling,
 *
 *     dp_x/dx = (xi - phi y) / L1,   dp_y/dx = eta / L2 + phi x / L3                              (F1)
 *     L1 = 8 a / (3 C11 G),  L2 = 8 a / (3 C22 G),  L3 = pi a sqrt(a/b) / (4 C23 G)               (F2)
 *
 * from zero at the leading edge, cut to the bound.  a, b and the coefficients are those of the ellipse with the
 * patch's area and length over width.  As published, -phi y has the flexibility L3; with L1, which is that of
 * all longitudinal creepage, the force is closer to the complete theory.  The bound is that of the pressure,
 * mu p0 sqrt(1 - (x/a)^2).  Where L1 and L2 differ, the force of full slip does not point quite against the
 * slip: up to 10 degrees.
 */

#include "fastsim.h"

/* Force, moment, stick share and largest traction of a patch. */
static inline int64_t fastsim__solve_fastsim(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    double along;
    double across;
    double turning;
    double stuck;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double rate;
    double push;
    double area;
    fastsim__stiffnesses(&along, &across, &turning, work, tables, rolling);
    stuck = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        rate = tractions__bound_rate(work, rolling, strip);
        if (rate > 0.0)
        {
            push = fastsim__strip_push(work, rolling, strip, along, turning);
            stuck += fastsim__march_strip(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), rolling, strip, rate, push, across, turning);
        }
    }
    area = tractions__patch_area(work, rolling);
    if (area > 0.0)
    {
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = stuck / area;
    }
    return INT64_C(0);
}

/* 1/L1, 1/L2, 1/L3 [Pa/m]; eq. (F2). */
static inline int64_t fastsim__stiffnesses(double* result_0, double* result_1, double* result_2, array_double_1d work, array_double_1d tables, int64_t rolling)
{
    double a;
    double ratio;
    double first;
    double second;
    double third;
    double modulus;
    a = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    ratio = a / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    shapes__kalker_coefficients(&first, &second, &third, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), ratio);
    modulus = (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    (*result_0) = 3.0 * first * modulus / (8.0 * a);
    (*result_1) = 3.0 * second * modulus / (8.0 * a);
    (*result_2) = 4.0 * third * modulus / (M_PI * a * sqrt(ratio));
    return 0;
}

/* dp_x/dx of a strip [Pa/m]; eq. (F1). */
static inline double fastsim__strip_push(array_double_1d work, int64_t rolling, int64_t strip, double along, double turning)
{
    double push;
    push = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * along;
    if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_PUBLISHED)) == 1.0)
    {
        push = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * along + ((*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X))) * turning;
    }
    return push;
}

/* Add a strip's force from its tractions; the area that sticks [m^2]. */
static inline double fastsim__march_strip(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling, int64_t strip, double rate, double push, double across, double turning)
{
    double a;
    double lateral;
    double turn;
    double before;
    double p_x;
    double p_y;
    double force_x;
    double force_y;
    double moment;
    double stuck;
    double total;
    double largest;
    int64_t q;
    double x;
    double weight;
    double step;
    double free_x;
    double free_y;
    double square;
    double result;
    a = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    lateral = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * turning;
    turn = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * turning;
    before = a;
    p_x = 0.0;
    p_y = 0.0;
    force_x = 0.0;
    force_y = 0.0;
    moment = 0.0;
    stuck = 0.0;
    total = 0.0;
    largest = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR));
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        weight = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        step = before - x;
        free_x = p_x - step * push;
        free_y = p_y - step * (lateral + turn * (x + 0.5 * step));
        tractions__cut_to(&p_x, &p_y, free_x, free_y, rate * a * weight);
        if ((p_x == free_x) && (p_y == free_y))
        {
            stuck += weight;
        }
        total += weight;
        square = p_x * p_x + p_y * p_y;
        if (square > largest)
        {
            largest = square;
        }
        force_x += weight * p_x;
        force_y += weight * p_y;
        moment += weight * x * p_y;
        before = x;
    }
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = sqrt(largest);
    weight = tractions__point_weight(work, strip);
    tractions__add_strip(work, rolling, strip, weight * force_x, weight * force_y, weight * moment);
    result = 2.0 * a * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) * stuck / total;
    return result;
}
