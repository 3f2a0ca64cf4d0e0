/* Generated from tangent_leaning.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of leaning.py.
 */

#include "tangent_leaning.h"

/* Tangent of ``set_reference``. */
static inline int64_t tangent_leaning__set_reference_t(array_double_1d work, array_double_1d work_t, double height, double height_t)
{
    (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)) = height_t;
    (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)) = height;
    (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)) = height_t;
    (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)) = height;
    return INT64_C(0);
}
