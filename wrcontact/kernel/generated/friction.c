/* Generated from wheelset/friction.py by tools/transpile_kernel.py; change that one.
 *
 * Friction in a patch: its coefficient, and how steeply the creep force begins.
 *
 *     mu = mu_side f(gamma) [(1 - A) exp(-B w) + A]                 Polach (2005)
 *     k  = k0 [alpha + (1 - alpha) / (1 + beta epsilon)]            Spiryagin, Polach, Cole (2013)
 *
 * with f from 1 on the tread to ``flange_friction_ratio`` on the flange over the contact angle gamma, the
 * sliding velocity w = V_ref sqrt(xi^2 + eta^2), and epsilon = G pi a b k0 C11 sqrt(xi^2 + (eta + phi a)^2) / (4
 * mu N). The flexibility of the contact is divided by k; as the models know it only beside the creepages, these
 * are multiplied by k.
 */

#include "friction.h"

/* Coefficient of friction of a patch with the contact ``angle`` [rad] that slides with ``sliding`` [m/s],
 * where that of its side is ``friction``.
 */
static inline double friction__patch_friction(array_double_1d tables, double friction, double angle, double sliding)
{
    double fall;
    double found;
    found = friction;
    if ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FLANGE_FRICTION_RATIO)) != 1.0)
    {
        found *= 1.0 + ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FLANGE_FRICTION_RATIO)) - 1.0) * friction__flange_share(tables, angle);
    }
    if ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FRICTION_FALL_RATE)) > 0.0)
    {
        fall = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FRICTION_FALL));
        found *= (1.0 - fall) * exp((-(*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FRICTION_FALL_RATE))) * sliding) + fall;
    }
    return found;
}

/* How much of the flange's friction there is at a contact ``angle`` [rad]: 0 on the tread, 1 on the
 * flange, with a smooth slope.
 */
static inline double friction__flange_share(array_double_1d tables, double angle)
{
    double share;
    share = 0.5 + 0.5 * (angle - (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FLANGE_FRICTION_ANGLE))) / friction__FLANGE_RANGE;
    if (share < 0.0)
    {
        share = 0.0;
    }
    if (share > 1.0)
    {
        share = 1.0;
    }
    return share * share * (3.0 - 2.0 * share);
}

/* Multiply the creepages of a patch by k, where wet or dirty rails reduce the initial slope. */
static inline int64_t friction__reduce_slope(array_double_1d work, array_double_1d tables, int64_t patch)
{
    double initial;
    double limit;
    double factor;
    double across;
    double creepage;
    double c11;
    double c22;
    double c23;
    double epsilon;
    if (((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION)) != 1.0) || ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) > 0.0))
    {
        initial = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION));
        limit = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
        factor = initial * (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_FLOOR));
        if ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) == 0.0)
        {
            factor = initial;
        }
        else if (limit > 0.0)
        {
            across = (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH));
            creepage = sqrt((*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) + across * across);
            shapes__kalker_coefficients(&c11, &c22, &c23, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_WIDTH)));
            epsilon = (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)) * friction__PI * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_WIDTH)) * initial * c11 * creepage / (4.0 * limit);
            factor = factor + (initial - factor) / (1.0 + (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) * epsilon);
        }
        friction__multiply_creepages(work, patch, factor);
    }
    return INT64_C(0);
}

/* Multiply the creepages of a patch and of its strips by ``factor``. */
static inline int64_t friction__multiply_creepages(array_double_1d work, int64_t patch, double factor)
{
    int64_t index_end;
    int64_t index;
    int64_t strip;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) *= factor;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) *= factor;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) *= factor;
    index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) *= factor;
    }
    return INT64_C(0);
}

/* 1 if a coefficient of friction is within 0 and ``limit``, else 0. */
static inline int64_t friction__is_frictional(double friction, double limit)
{
    int64_t frictional;
    frictional = INT64_C(0);
    if ((friction >= 0.0) && (friction <= limit))
    {
        frictional = INT64_C(1);
    }
    return frictional;
}
