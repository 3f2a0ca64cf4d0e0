/* Generated from contact/planes.py by tools/transpile_kernel.py; change that one.
 *
 * Planes of their own for regions of a rigid contact whose normal differs from the contact point's: a flange
 * beside a tread.
 *
 * One contact plane serves all regions whose normals differ little.  A region whose normal differs by more than
 * SPLIT has its own frame, in the pair of points where it would touch (:mod:`touching`): its gap is measured
 * along its own normal, its stations run in its own plane, and of the wheel's approach it gets the share that
 * comes along its normal,
 *
 *     level_i = cos(angle_i - angle_0) penetration - gap_i
 *
 * In the outputs its stations follow those of the contact point, by the length of the rail between the two.
 */

#include "planes.h"

/* Keep the open frame for region ``slot``; REGION_LIMIT is the contact point's. */
static OUT_OF_LINE int64_t planes__keep_frame(array_double_1d work, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(26) * slot;
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
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(26) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i)) = (*cspan_at(&work, kept + i));
    }
    return INT64_C(0);
}

/* Rail abscissa [m] of a region's ``bound``, a station in the contact point's plane; BEYOND if it has
 * none.
 */
static OUT_OF_LINE double planes__bound_abscissa(array_double_1d work, array_double_1d tables, int64_t region, array_double_1d state, double bound)
{
    double gap;
    double rate;
    double bend;
    double curvature;
    double abscissa;
    abscissa = bound;
    if (fabs(bound) < regions__BEYOND)
    {
        traces__start_traces(work, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)));
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, bound, regions__PLACE_TRACE);
        abscissa = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
    }
    return abscissa;
}

/* Station [m] in the open frame of the rail's point at ``abscissa``; BEYOND stays BEYOND. */
static OUT_OF_LINE double planes__bound_station(array_double_1d work, array_double_1d tables, double abscissa)
{
    double height;
    double slope;
    double station;
    station = abscissa;
    if (fabs(abscissa) < regions__BEYOND)
    {
        profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
        station = (abscissa - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + (height - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    }
    return station;
}

/* 1 if the region's normal differs from the open frame's by more than SPLIT, else 0. */
static OUT_OF_LINE int64_t planes__needs_own_plane(array_double_1d work, int64_t region)
{
    double difference;
    int64_t needed;
    difference = (*cspan_at(&work, region + layout__REGION_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) - (*cspan_at(&work, region + layout__REGION_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    needed = INT64_C(0);
    if (fabs(difference) > planes__SPLIT)
    {
        needed = INT64_C(1);
    }
    return needed;
}

/* Give a region its own frame, kept in ``slot``; the contact point's frame stays open.  1 if it has one,
 * else 0.
 */
static OUT_OF_LINE int64_t planes__own_plane(array_double_1d work, array_double_1d tables, int64_t region, int64_t slot, array_double_1d state)
{
    double y;
    double abscissa;
    double depth;
    double aside;
    double shift;
    double low;
    double high;
    double cosine;
    double sine;
    double height;
    double slope;
    double z;
    double y_track;
    double rail_slope;
    double mismatch;
    double gap;
    double rate;
    double bend;
    double curvature;
    int64_t found;
    touching__touching_pair(&y, &abscissa, &depth, &aside, &shift, &found, work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)));
    if (found == INT64_C(1))
    {
        low = planes__bound_abscissa(work, tables, region, state, (*cspan_at(&work, region + layout__REGION_LOW)));
        high = planes__bound_abscissa(work, tables, region, state, (*cspan_at(&work, region + layout__REGION_HIGH)));
        planes__keep_frame(work, layout__REGION_LIMIT);
        cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        sine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_RAIL)) = abscissa;
        (*cspan_at(&work, region + layout__REGION_WHEEL)) = y;
        profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
        regions__incline_region(work, tables, region, slope);
        (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(1);
        (*cspan_at(&work, region + layout__REGION_OFFSET)) = arc_length__rail_length(tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)), abscissa);
        (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = (*cspan_at(&work, region + layout__REGION_COS)) * cosine + (*cspan_at(&work, region + layout__REGION_SIN)) * sine;
        (*cspan_at(&work, region + layout__REGION_GAP)) = -depth;
        contact_plane__open_frame(&z, &slope, &y_track, &rail_slope, &mismatch, work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), y, aside, shift);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = (*cspan_at(&work, region + layout__REGION_GAP));
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, 0.0, regions__PLACE_TRACE);
        (*cspan_at(&work, region + layout__REGION_BEND)) = bend;
        (*cspan_at(&work, region + layout__REGION_CURVATURE)) = curvature;
        (*cspan_at(&work, region + layout__REGION_LOW)) = planes__bound_station(work, tables, low);
        (*cspan_at(&work, region + layout__REGION_HIGH)) = planes__bound_station(work, tables, high);
        planes__keep_frame(work, slot);
        planes__use_frame(work, layout__REGION_LIMIT);
    }
    return found;
}

/* Give every region that needs one its own plane. */
static OUT_OF_LINE int64_t planes__give_planes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count)
{
    int64_t own;
    int64_t index;
    int64_t region;
    own = INT64_C(0);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        if (planes__needs_own_plane(work, region) == INT64_C(1))
        {
            own += planes__own_plane(work, tables, region, index, state);
        }
    }
    if (own > INT64_C(0))
    {
        planes__locate_along_track(work, tables, count);
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
