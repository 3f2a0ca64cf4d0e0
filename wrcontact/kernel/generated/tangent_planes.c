/* Generated from tangent_planes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of planes.py.
 */

#include "tangent_planes.h"

/* Tangent of ``keep_frame``. */
static inline int64_t tangent_planes__keep_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(27) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, kept + i)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + i));
        (*cspan_at(&work, kept + i)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i));
    }
    return INT64_C(0);
}

/* Tangent of ``use_frame``. */
static inline int64_t tangent_planes__use_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(27) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + i)) = (*cspan_at(&work_t, kept + i));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i)) = (*cspan_at(&work, kept + i));
    }
    return INT64_C(0);
}

/* Tangent of ``locate_along_track``. */
static inline int64_t tangent_planes__locate_along_track_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t region;
    double v1;
    double v1_t;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        tangent_locus__outline_x_t(&v1, &v1_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
        (*cspan_at(&work_t, region + layout__REGION_X_TRACK)) = v1_t;
        (*cspan_at(&work, region + layout__REGION_X_TRACK)) = v1;
    }
    return INT64_C(0);
}

/* Tangent of ``enter_plane``. */
static inline int64_t tangent_planes__enter_plane_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t slot)
{
    if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
    {
        tangent_planes__use_frame_t(work, work_t, slot);
    }
    return INT64_C(0);
}

/* Tangent of ``leave_plane``. */
static inline int64_t tangent_planes__leave_plane_t(array_double_1d work, array_double_1d work_t, int64_t region)
{
    if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
    {
        tangent_planes__use_frame_t(work, work_t, layout__REGION_LIMIT);
    }
    return INT64_C(0);
}
