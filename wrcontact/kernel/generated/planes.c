/* Generated from contact/planes.py by tools/transpile_kernel.py; change that one.
 *
 * Planes of their own for regions of a rigid contact that lean away from the contact point's: a flange beside a tread.
 *
 * One contact plane serves all regions whose normals differ little.  A region that leans by more than SPLIT has its own frame,
 * in the pair of points where it would touch (:mod:`touching`): its gap is measured along its own normal, its stations run in
 * its own plane, and of the wheel's approach it gets the share that comes along its normal,
 *
 *     level_i = cos(angle_i - angle_0) penetration - gap_i
 *
 * In the outputs its stations follow those of the contact point, by the length of the rail between the two.
 */

#include "planes.h"

/* Keep the open frame for region ``slot``; REGION_LIMIT is the contact point's. */
static OUT_OF_LINE int64_t planes__keep_frame(array_double_1d work, int64_t slot)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__CONTACT_BLOCK; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_FRAMES + layout__CONTACT_BLOCK * slot + i)) = (*cspan_at(&work, layout__WORK_CONTACT + i));
    }
    return INT64_C(0);
}

/* Open the frame that was kept for ``slot``. */
static OUT_OF_LINE int64_t planes__use_frame(array_double_1d work, int64_t slot)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__CONTACT_BLOCK; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + i)) = (*cspan_at(&work, layout__WORK_FRAMES + layout__CONTACT_BLOCK * slot + i));
    }
    return INT64_C(0);
}

/* Rail abscissa [m] of a region's ``bound``, a station in the contact point's plane; FAR beyond any rail if it has none. */
static OUT_OF_LINE double planes__bound_abscissa(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t block, double bound)
{
    double gap;
    double rate;
    double bend;
    double curvature;
    double abscissa;
    abscissa = bound;
    if (fabs(bound) < regions__FAR)
    {
        contact_plane__start_tracer(work, (*cspan_at(&work, block + layout__REGION_STATION)), (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)));
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, tables, work, state, bound, regions__TRACE);
        abscissa = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL));
    }
    return abscissa;
}

/* Station [m] in the open frame of the rail's point at ``abscissa``; FAR stays FAR. */
static OUT_OF_LINE double planes__bound_station(array_double_1d tables, array_double_1d work, double abscissa)
{
    double height;
    double slope;
    double station;
    station = abscissa;
    if (fabs(abscissa) < regions__FAR)
    {
        profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
        station = (abscissa - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA))) * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + (height - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT))) * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    }
    return station;
}

/* 1 if the region's normal differs from the open frame's by more than SPLIT, else 0. */
static OUT_OF_LINE int64_t planes__leans_away(array_double_1d work, int64_t region)
{
    int64_t block;
    double away;
    int64_t leans;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    away = (*cspan_at(&work, block + layout__REGION_SIN)) * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) - (*cspan_at(&work, block + layout__REGION_COS)) * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    leans = INT64_C(0);
    if (fabs(away) > planes__SPLIT)
    {
        leans = INT64_C(1);
    }
    return leans;
}

/* Give ``region`` its own frame, kept in its slot; the contact point's frame stays open. */
static OUT_OF_LINE int64_t planes__own_plane(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region)
{
    int64_t block;
    int64_t at;
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
    double turn;
    double z;
    double y_track;
    double rail_slope;
    double mismatch;
    double gap;
    double rate;
    double bend;
    double curvature;
    int64_t found;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    touching__touching_pair(&y, &abscissa, &depth, &aside, &shift, &found, tables, work, at, (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SHIFT)));
    if (found == INT64_C(1))
    {
        low = planes__bound_abscissa(tables, work, state, block, (*cspan_at(&work, block + layout__REGION_LOW)));
        high = planes__bound_abscissa(tables, work, state, block, (*cspan_at(&work, block + layout__REGION_HIGH)));
        planes__keep_frame(work, layout__REGION_LIMIT);
        cosine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        sine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
        (*cspan_at(&work, block + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_RAIL)) = abscissa;
        (*cspan_at(&work, block + layout__REGION_WHEEL)) = y;
        profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
        regions__lean_region(tables, work, block, slope);
        (*cspan_at(&work, block + layout__REGION_OWN)) = (double)(1);
        (*cspan_at(&work, block + layout__REGION_OFFSET)) = pressed__rail_length(tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)), abscissa);
        turn = (*cspan_at(&work, block + layout__REGION_COS)) * cosine + (*cspan_at(&work, block + layout__REGION_SIN)) * sine;
        (*cspan_at(&work, block + layout__REGION_TURN)) = turn;
        (*cspan_at(&work, block + layout__REGION_GAP)) = -depth;
        contact_plane__open_frame(&z, &slope, &y_track, &rail_slope, &mismatch, tables, work, at, y, aside, shift);
        (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) = (*cspan_at(&work, block + layout__REGION_GAP));
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, tables, work, state, 0.0, regions__TRACE);
        (*cspan_at(&work, block + layout__REGION_BEND)) = bend;
        (*cspan_at(&work, block + layout__REGION_CURVATURE)) = curvature;
        (*cspan_at(&work, block + layout__REGION_LOW)) = planes__bound_station(tables, work, low);
        (*cspan_at(&work, block + layout__REGION_HIGH)) = planes__bound_station(tables, work, high);
        planes__keep_frame(work, region);
        planes__use_frame(work, layout__REGION_LIMIT);
    }
    return found;
}

/* Give every region that leans away its own plane. */
static OUT_OF_LINE int64_t planes__give_planes(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count)
{
    int64_t own;
    int64_t region;
    own = INT64_C(0);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        if (planes__leans_away(work, region) == INT64_C(1))
        {
            own += planes__own_plane(tables, work, state, region);
        }
    }
    if (own > INT64_C(0))
    {
        planes__line_up(tables, work, count);
    }
    return INT64_C(0);
}

/* Note how far ahead every region lies: of a yawed wheel, a flange is some 20 mm ahead of the flange root. */
static OUT_OF_LINE int64_t planes__line_up(array_double_1d tables, array_double_1d work, int64_t count)
{
    int64_t region;
    int64_t block;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        (*cspan_at(&work, block + layout__REGION_ALONG)) = contact_plane__ridge_place(tables, work, (*cspan_at(&work, block + layout__REGION_WHEEL)));
    }
    return INT64_C(0);
}

/* Open the frame of a region with its own plane. */
static OUT_OF_LINE int64_t planes__enter_plane(array_double_1d work, int64_t region)
{
    if ((*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_OWN)) == 1.0)
    {
        planes__use_frame(work, region);
    }
    return INT64_C(0);
}

/* Open the contact point's frame again. */
static OUT_OF_LINE int64_t planes__leave_plane(array_double_1d work, int64_t region)
{
    if ((*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_OWN)) == 1.0)
    {
        planes__use_frame(work, layout__REGION_LIMIT);
    }
    return INT64_C(0);
}
