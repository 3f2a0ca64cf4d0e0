/* Generated from contact/planes.py by tools/transpile_kernel.py; change that one.
 *
 * Frames that are set aside: every region of a pressed wheel beside the contact point's has its own, at its
 * deepest point.
 */

#include "planes.h"

/* Keep the open frame for region ``slot``; REGION_LIMIT is the contact point's. */
static OUT_OF_LINE int64_t planes__keep_frame(array_double_1d work, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(27) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, kept + i)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i));
    }
    return INT64_C(0);
}

/* Open the frame that was kept for ``slot``. */
static OUT_OF_LINE int64_t planes__use_frame(array_double_1d work, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(27) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i)) = (*cspan_at(&work, kept + i));
    }
    return INT64_C(0);
}

/* Note where along the track every region lies: of a yawed wheel, a flange is some 20 mm ahead of the
 * flange root.
 */
static OUT_OF_LINE int64_t planes__locate_along_track(array_double_1d work, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t region;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        (*cspan_at(&work, region + layout__REGION_X_TRACK)) = locus__outline_x(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_WHEEL)));
    }
    return INT64_C(0);
}

/* Open the frame of a region with its own plane, kept in ``slot``. */
static OUT_OF_LINE int64_t planes__enter_plane(array_double_1d work, int64_t region, int64_t slot)
{
    if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
    {
        planes__use_frame(work, slot);
    }
    return INT64_C(0);
}

/* Open the contact point's frame again. */
static OUT_OF_LINE int64_t planes__leave_plane(array_double_1d work, int64_t region)
{
    if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
    {
        planes__use_frame(work, layout__REGION_LIMIT);
    }
    return INT64_C(0);
}
