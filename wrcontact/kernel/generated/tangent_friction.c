/* Generated from tangent_friction.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of friction.py.
 */

#include "tangent_friction.h"

/* Tangent of ``patch_friction``. */
static inline int64_t tangent_friction__patch_friction_t(double* found, double* found_t, array_double_1d tables, double friction, double friction_t, double angle, double angle_t, double sliding, double sliding_t)
{
    double v1;
    double v2;
    double v2_t;
    double v3;
    double fall;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    (*found_t) = friction_t;
    (*found) = friction;
    if ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FLANGE_FRICTION_RATIO)) != 1.0)
    {
        v1 = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FLANGE_FRICTION_RATIO)) - 1.0;
        tangent_friction__flange_share_t(&v2, &v2_t, tables, angle, angle_t);
        v3 = 1.0 + v1 * v2;
        (*found_t) = (*found_t) * v3 + (*found) * (v1 * v2_t);
        (*found) = (*found) * v3;
    }
    if ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FRICTION_FALL_RATE)) > 0.0)
    {
        fall = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FRICTION_FALL));
        v4 = 1.0 - fall;
        v5 = -(*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FRICTION_FALL_RATE));
        v6 = v5 * sliding;
        v7 = exp(v6);
        v8 = v4 * v7 + fall;
        (*found_t) = (*found_t) * v8 + (*found) * (v4 * (v7 * (v5 * sliding_t)));
        (*found) = (*found) * v8;
    }
    return 0;
}

/* Tangent of ``flange_share``. */
static inline int64_t tangent_friction__flange_share_t(double* result_0, double* result_1, array_double_1d tables, double angle, double angle_t)
{
    double v1;
    double v2;
    double share_t;
    double share;
    double v3;
    double v4;
    v1 = angle - (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_FLANGE_FRICTION_ANGLE));
    v2 = 0.5 * v1;
    share_t = 0.5 * angle_t / friction__FLANGE_RANGE;
    share = 0.5 + v2 / friction__FLANGE_RANGE;
    if (share < 0.0)
    {
        share_t = 0.0;
        share = 0.0;
    }
    if (share > 1.0)
    {
        share_t = 0.0;
        share = 1.0;
    }
    v3 = share * share;
    v4 = 3.0 - 2.0 * share;
    (*result_0) = v3 * v4;
    (*result_1) = (share_t * share + share * share_t) * v4 + v3 * (-(2.0 * share_t));
    return 0;
}

/* Tangent of ``reduce_slope``. */
static inline int64_t tangent_friction__reduce_slope_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t patch)
{
    double initial;
    double limit_t;
    double limit;
    double factor_t;
    double factor;
    double across_t;
    double across;
    double v1;
    double v2;
    double creepage_t;
    double creepage;
    double v3;
    double c11;
    double c11_t;
    double c22;
    double c22_t;
    double c23;
    double c23_t;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double epsilon_t;
    double epsilon;
    double v12;
    double v13;
    double v14;
    if (((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION)) != 1.0) || ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) > 0.0))
    {
        initial = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION));
        limit_t = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_LOAD));
        limit = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
        factor_t = 0.0;
        factor = initial * (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_FLOOR));
        if ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) == 0.0)
        {
            factor_t = 0.0;
            factor = initial;
        }
        else if (limit > 0.0)
        {
            across_t = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) + ((*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_HALF_LENGTH)));
            across = (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH));
            v1 = (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) + across * across;
            v2 = sqrt(v1);
            creepage_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_X)) + (across_t * across + across * across_t));
            creepage = v2;
            v3 = (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_WIDTH));
            tangent_shapes__kalker_coefficients_t(&c11, &c11_t, &c22, &c22_t, &c23, &c23_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), v3, ((*cspan_at(&work_t, patch + layout__ROLLING_PATCH_HALF_LENGTH)) - v3 * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_WIDTH)));
            v4 = (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)) * friction__PI;
            v5 = v4 * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_LENGTH));
            v6 = v5 * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_WIDTH));
            v7 = v6 * initial;
            v8 = v7 * c11;
            v9 = v8 * creepage;
            v10 = 4.0 * limit;
            v11 = v9 / v10;
            epsilon_t = (((v4 * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_HALF_WIDTH)) + v5 * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_HALF_WIDTH))) * initial * c11 + v7 * c11_t) * creepage + v8 * creepage_t - v11 * (4.0 * limit_t)) / v10;
            epsilon = v11;
            v12 = initial - factor;
            v13 = 1.0 + (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) * epsilon;
            v14 = v12 / v13;
            factor_t = factor_t + ((-factor_t) - v14 * ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_SLOPE_REDUCTION_RATE)) * epsilon_t)) / v13;
            factor = factor + v14;
        }
        tangent_friction__multiply_creepages_t(work, work_t, patch, factor, factor_t);
    }
    return INT64_C(0);
}

/* Tangent of ``multiply_creepages``. */
static inline int64_t tangent_friction__multiply_creepages_t(array_double_1d work, array_double_1d work_t, int64_t patch, double factor, double factor_t)
{
    int64_t index_end;
    int64_t index;
    int64_t strip;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_X)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * factor + (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * factor_t;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) * factor;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * factor + (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * factor_t;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * factor;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPIN)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPIN)) * factor + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * factor_t;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * factor;
    index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) * factor + (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * factor_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * factor;
    }
    return INT64_C(0);
}
