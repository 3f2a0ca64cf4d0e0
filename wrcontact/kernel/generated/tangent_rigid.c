/* Generated from tangent_rigid.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rigid.py.
 */

#include "tangent_rigid.h"

/* Tangent of ``solve_rigid``. */
static inline int64_t tangent_rigid__solve_rigid_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t)
{
    int64_t index;
    double v2;
    double v2_t;
    int64_t n1;
    double v4;
    double v4_t;
    int64_t n3;
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
    if (requested__is_requested(right_tables, INT64_C(0)) == INT64_C(1))
    {
        tangent_requested__side_force_t(&v2, &v2_t, work, work_t, INT64_C(0));
        n1 = tangent_side__solve_side_t(left_tables, work, work_t, state, INT64_C(0), v2, v2_t);
        status = n1;
    }
    if (requested__is_requested(right_tables, INT64_C(1)) == INT64_C(1))
    {
        tangent_requested__side_force_t(&v4, &v4_t, work, work_t, INT64_C(1));
        n3 = tangent_side__solve_side_t(right_tables, work, work_t, state, INT64_C(1), v4, v4_t);
        outcome = n3;
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
}
