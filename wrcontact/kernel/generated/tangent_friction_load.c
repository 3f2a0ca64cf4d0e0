/* Generated from tangent_friction_load.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of friction_load.py.
 */

#include "tangent_friction_load.h"

/* Tangent of ``carried_share``. */
static inline int64_t tangent_friction_load__carried_share_t(double* share, double* share_t, array_double_1d work, array_double_1d work_t, int64_t index)
{
    double v1;
    double v2;
    double wanted_t;
    double wanted;
    double v3;
    double v4;
    (*share_t) = 0.0;
    (*share) = 1.0;
    v1 = (double)(INT64_C(2) * index - INT64_C(1));
    v2 = 1.0 + v1 * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER));
    wanted_t = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * v2 + (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * (v1 * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER)));
    wanted = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * v2;
    if ((wanted > 0.0) && ((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_NORMAL_PART + INT64_C(2))) < 0.0))
    {
        v3 = -(*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_FORCE + INT64_C(2)));
        v4 = v3 / wanted;
        (*share_t) = ((-(*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_FORCE + INT64_C(2)))) - v4 * wanted_t) / wanted;
        (*share) = v4;
    }
    return 0;
}
