/* Generated from tangential/fastrip.py by tools/transpile_kernel.py; change that one.
 *
 * FaStrip: strip theory in the stick zone, FASTSIM's direction in the slip zone.
 *
 * M. Sh. Sichani, R. Enblom, M. Berg, An alternative to FASTSIM for tangential solution of the wheel-rail
 * contact, Vehicle System Dynamics 54 (2016) 748-764.  Strip theory (eqs. (Z1), (Z2) of stick_zone.py, there
 * with s = 0) has the stiffnesses that give Kalker's force for an ellipse,
 *
 *     K1 = 2 C11 G / pi^2,   K2 = 2 C22 G / pi^2,   K3 = 3 C23 G sqrt(b/a) / (2 pi)                (A1)
 *
 * the same in all strips.  A strip that has no stick zone, or one that is longer than itself, slips all over.
 * Where a strip slips its traction is the bound, in the direction that FASTSIM's traction has there.  As
 * published, -phi y has the stiffness K3 / (1 - nu) in strip theory and L3 in FASTSIM; with those of
 * longitudinal creepage, K1 and L1, the force is closer to the complete theory.
 *
 * The force is not continuous: strips begin to slip all over while their stick zone has a length.
 */

#include "fastrip.h"

/* Force, moment, stick share and largest traction of a patch. */
static inline int64_t fastrip__solve_fastrip(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    int64_t march;
    double along;
    double across;
    double turning;
    double stuck;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double rate;
    double lateral;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    fastsim__stiffnesses(&along, &across, &turning, work, tables, rolling);
    fastrip__set_stiffnesses(work, tables, rolling);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = 0.0;
    stuck = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        rate = tractions__bound_rate(work, rolling, strip);
        if (rate > 0.0)
        {
            (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
            (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) = rate;
            lateral = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
            fastrip__find_stick(work, march, fastrip__longitudinal(work, tables, rolling, strip), lateral, (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)));
            (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X)) = fastsim__strip_push(work, rolling, strip, along, turning);
            (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * turning;
            (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * turning;
            fastrip__add_tractions(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), rolling, strip);
            stuck += 2.0 * ((*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH))) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        }
    }
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = sqrt((*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = stuck / tractions__patch_area(work, rolling);
    return INT64_C(0);
}

/* K1, K2, K3 of all strips; eq. (A1). */
static inline int64_t fastrip__set_stiffnesses(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    int64_t march;
    double ratio;
    double first;
    double second;
    double third;
    double modulus;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    ratio = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    shapes__kalker_coefficients(&first, &second, &third, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), ratio);
    modulus = (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) = 2.0 * first * modulus / (M_PI * M_PI);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) = 2.0 * second * modulus / (M_PI * M_PI);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) = 1.5 * third * modulus / (M_PI * sqrt(ratio));
    return INT64_C(0);
}

/* K1 w_x of a strip [Pa]. */
static inline double fastrip__longitudinal(array_double_1d work, array_double_1d tables, int64_t rolling, int64_t strip)
{
    int64_t march;
    double push;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    push = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP));
    if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_PUBLISHED)) == 1.0)
    {
        push = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) * ((*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X))) / (1.0 - (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_POISSON_RATIO)));
    }
    return push;
}

/* Depth of the slip zone and direction of the stick zone of a strip; ``push`` = K1 w_x. */
static inline int64_t fastrip__find_stick(array_double_1d work, int64_t march, double push, double lateral, double spin)
{
    double u;
    double v;
    double k;
    double rest;
    double cross;
    double spread;
    double depth;
    double root;
    u = (-push) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    v = (-(*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS))) * lateral / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    k = (-(*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING))) * spin / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    rest = 1.0 - k * k;
    cross = v * k;
    spread = v * v + rest * u * u;
    depth = 2.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    if (rest > 0.0)
    {
        root = sqrt(spread);
        depth = root + cross;
        if (cross < 0.0)
        {
            /* the same without cancellation */
            depth = (u * u + v * v) / (root - cross) * rest;
        }
        depth /= rest;
    }
    else if ((cross < 0.0) && (spread > 0.0))
    {
        depth = (u * u + v * v) / (sqrt(spread) - cross);
    }
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) = k;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = 0.0;
    if (depth < (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)))
    {
        (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = depth;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = u / (depth + 1e-300);
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = v / (depth + 1e-300) + k;
    }
    (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) = 2.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    return INT64_C(0);
}

/* Add a strip's force from its tractions at the points. */
static inline int64_t fastrip__add_tractions(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling, int64_t strip)
{
    int64_t march;
    double a;
    int64_t q;
    double x;
    double bound;
    double p_x;
    double p_y;
    double square;
    double weight;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = a;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = 0.0;
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        bound = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        fastrip__next_traction(&p_x, &p_y, work, march, x, bound);
        square = p_x * p_x + p_y * p_y;
        if (square > (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)))
        {
            (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = square;
        }
        (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * p_x;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * p_y;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) += (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * x * p_y;
    }
    weight = tractions__point_weight(work, strip);
    tractions__add_strip(work, rolling, strip, weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)), weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)), weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)));
    return INT64_C(0);
}

/* The traction at the next point ``x``: that of strip theory in the stick zone, the bound in FASTSIM's
 * direction behind it.
 */
static inline int64_t fastrip__next_traction(double* p_x, double* p_y, array_double_1d work, int64_t march, double x, double bound)
{
    double step;
    double across;
    double reach;
    double inner;
    double root;
    double size;
    step = (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - x;
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN)) * (x + 0.5 * step);
    tractions__cut_to(p_x, p_y, (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X)), (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) - step * across, bound);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = x;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = (*p_x);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = (*p_y);
    reach = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    inner = reach * reach - (x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH))) * (x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)));
    if (inner > 0.0)
    {
        root = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * sqrt(inner);
        tractions__cut_to(p_x, p_y, (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (bound - root), (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (bound - root) + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root, bound);
    }
    else
    {
        size = sqrt((*p_x) * (*p_x) + (*p_y) * (*p_y));
        if (size > 0.0)
        {
            (*p_x) *= bound / size;
            (*p_y) *= bound / size;
        }
    }
    return 0;
}
