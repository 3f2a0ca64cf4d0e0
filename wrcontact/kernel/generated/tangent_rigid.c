/* Generated from tangent_rigid.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rigid.py.
 */

#include "tangent_rigid.h"

/* Tangent of ``solve_rigid``. */
static inline int64_t tangent_rigid__solve_rigid_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t)
{
    int64_t index;
    double v2;
    double v2_t;
    int64_t n1;
    int64_t outcome;
    int64_t status;
    status = layout__VALID;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST));
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        tangent_resultant__clear_resultant_t(work, work_t, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        if (requested__is_requested(tables, index) == INT64_C(1))
        {
            tangent_requested__side_force_t(&v2, &v2_t, work, work_t, index);
            n1 = tangent_side__solve_side_t(tables, work, work_t, state, index, v2, v2_t);
            outcome = n1;
            if (outcome > status)
            {
                status = outcome;
            }
        }
    }
    return status;
}
