/* Generated from contact/pressed_regions.py by tools/transpile_kernel.py; change that one.
 *
 * The regions of a pressed wheel, from its overlaps: each has a frame of its own at its deepest point.
 */

#include "pressed_regions.h"

/* Lateral and vertical shift [m] that let the wheel just touch at a deepest point. */
static OUT_OF_LINE int64_t pressed_regions__touching_shift(double* result_0, double* result_1, array_double_1d work, array_double_1d tables, int64_t place, int64_t point)
{
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double z_rail;
    double m;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)));
    locus__outline_point(&y_track, &z_track, &outline_slope, work, place, (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), z, slope);
    profile_table__height_slope(&z_rail, &m, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)));
    (*result_0) = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) + (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - y_track;
    (*result_1) = z_rail - z_track;
    return 0;
}

/* Let the open frame be that of a wheel pressed ``depth`` deep at vertical shift ``height``, whose own
 * gap is ``gap`` [m].
 */
static OUT_OF_LINE int64_t pressed_regions__press_frame(array_double_1d work, double height, double depth, double gap)
{
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)) = height;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) = depth;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) = (double)(1);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = gap;
    return INT64_C(0);
}

/* Press the wheel of the open frame, which just touches, straight down until its contact point is
 * ``penetration`` [m] deep along the normal; the number of regions in which it overlaps its rail.
 */
static OUT_OF_LINE int64_t pressed_regions__sink_wheel(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double penetration)
{
    double height;
    int64_t count;
    height = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) + penetration / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    count = overlaps__find_overlaps(work, tables, side, state, height);
    pressed_regions__press_frame(work, height, penetration, 0.0);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) = (double)(1);
    return count;
}

/* Press a sunk wheel with ``count`` regions until its contact point is ``penetration`` [m] deep.
 *
 * The regions stay: their deepest points move by less than what counts.
 */
static OUT_OF_LINE int64_t pressed_regions__sink_deeper(array_double_1d work, int64_t count, double penetration)
{
    double height;
    int64_t index;
    int64_t region;
    height = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) + penetration / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    pressed_regions__press_frame(work, height, penetration, 0.0);
    planes__keep_frame(work, layout__REGION_LIMIT);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        planes__use_frame(work, index);
        pressed_regions__press_frame(work, height, (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP)), (*cspan_at(&work, region + layout__REGION_GAP)));
        planes__keep_frame(work, index);
    }
    planes__use_frame(work, layout__REGION_LIMIT);
    return INT64_C(0);
}

/* Start a region at a deepest point, inclined as the rail there. */
static OUT_OF_LINE int64_t pressed_regions__open_pressed_region(array_double_1d work, array_double_1d tables, int64_t region, int64_t point)
{
    double z_rail;
    double m;
    (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL));
    profile_table__height_slope(&z_rail, &m, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)));
    regions__incline_region(work, tables, region, m);
    return INT64_C(0);
}

/* Open the frame of a region beside the contact point's, whose frame is open; what it gets of the
 * approach follows from both inclinations.
 */
static OUT_OF_LINE int64_t pressed_regions__give_own_frame(array_double_1d work, array_double_1d tables, int64_t region, int64_t point)
{
    double cosine;
    double abscissa;
    double height;
    double depth;
    double aside;
    double shift;
    double Dummy_0000_0;
    double Dummy_0000_1;
    double Dummy_0000_2;
    double Dummy_0000_3;
    double Dummy_0000_4;
    cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    abscissa = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    height = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT));
    depth = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    pressed_regions__touching_shift(&aside, &shift, work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), point);
    contact_plane__open_frame(&Dummy_0000_0, &Dummy_0000_1, &Dummy_0000_2, &Dummy_0000_3, &Dummy_0000_4, work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), aside, shift);
    (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(1);
    (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = (*cspan_at(&work, region + layout__REGION_COS)) / cosine;
    (*cspan_at(&work, region + layout__REGION_GAP)) = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * depth - (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH));
    (*cspan_at(&work, region + layout__REGION_OFFSET)) = arc_length__rail_length(tables, abscissa, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)));
    pressed_regions__press_frame(work, height, (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)), (*cspan_at(&work, region + layout__REGION_GAP)));
    return INT64_C(0);
}

/* Open a region for every deepest point on the list, each with its own frame; their number.  The open
 * frame is that of the deepest, whose share of the approach counts as one, or of a sunk wheel that of the
 * point where it just touched.
 */
static OUT_OF_LINE int64_t pressed_regions__gather_overlaps(array_double_1d work, array_double_1d tables, array_double_1d state)
{
    int64_t contact;
    int64_t index;
    int64_t region;
    int64_t point;
    double gap;
    double rate;
    double bend;
    double curvature;
    int64_t count;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    contact = deep_points__deepest_entry(work);
    planes__keep_frame(work, layout__REGION_LIMIT);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * index;
        pressed_regions__open_pressed_region(work, tables, region, point);
        if ((index != contact) || ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) == 1.0))
        {
            pressed_regions__give_own_frame(work, tables, region, point);
        }
        traces__start_traces(work, 0.0, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)));
        pressed__pressed_gap(&gap, &rate, &bend, &curvature, work, tables, state, 0.0);
        (*cspan_at(&work, region + layout__REGION_BEND)) = bend;
        (*cspan_at(&work, region + layout__REGION_CURVATURE)) = curvature;
        (*cspan_at(&work, region + layout__REGION_LOW)) = -regions__BEYOND;
        (*cspan_at(&work, region + layout__REGION_HIGH)) = regions__BEYOND;
        if (index > INT64_C(0))
        {
            (*cspan_at(&work, region + layout__REGION_LOW)) = arc_length__rail_length(tables, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (index - INT64_C(1)) + layout__DEEP_POINT_SADDLE)));
        }
        if (index < count - INT64_C(1))
        {
            (*cspan_at(&work, region + layout__REGION_HIGH)) = arc_length__rail_length(tables, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)));
        }
        planes__keep_frame(work, index);
        planes__use_frame(work, layout__REGION_LIMIT);
    }
    if (count > INT64_C(1))
    {
        planes__locate_along_track(work, tables, count);
    }
    return count;
}
