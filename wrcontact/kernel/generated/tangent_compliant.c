/* Generated from tangent_compliant.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of compliant.py.
 */

#include "tangent_compliant.h"

/* Tangent of ``load_at_height``. */
static inline int64_t tangent_compliant__load_at_height_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double height, double height_t)
{
    double approach_t;
    double approach;
    int64_t n1;
    int64_t n2;
    int64_t status;
    int64_t count;
    approach_t = height_t - (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    approach = height - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(approach > compliant__GRAZING))
    {
        n1 = tangent_side__touch_side_t(tables, work, work_t, state, index);
        return n1;
    }
    if (approach > trial__DEEPEST)
    {
        return layout__OFF_PROFILE;
    }
    n2 = tangent_side__press_side_t(tables, work, work_t, state, index, approach, approach_t);
    status = n2;
    if (status == layout__VALID)
    {
        tangent_side__load_side_t(&count, &status, tables, work, work_t, state, index, 0.0, 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)));
    }
    if ((status == layout__VALID) && (damping__is_damped(tables) == INT64_C(1)))
    {
        tangent_damping__damp_patches_t(work, work_t, tables, index, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
        tangent_totals__write_patches_t(work, work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index);
    }
    return status;
}
