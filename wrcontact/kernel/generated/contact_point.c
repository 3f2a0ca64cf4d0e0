/* Generated from wheelset/contact_point.py by tools/transpile_kernel.py; change that one.
 *
 * The contact of one side, described: where it is on wheel, rail and track, its angle, radius and
 * curvatures.
 */

#include "contact_point.h"

/* Positions, angle, radius and curvatures of side ``index`` (0 left, 1 right) where its wheel touches
 * with abscissa ``y`` when moved by ``aside`` and ``shift`` [m]; opens its contact plane.
 *
 * 1 if this is a contact, else 0: the smallest gap at the end of a profile, or where a yawed outline is
 * folded.
 */
static inline int64_t contact_point__describe_contact(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double y, double aside, double shift)
{
    int64_t place;
    int64_t out;
    double z;
    double slope;
    double y_track;
    double rail_slope;
    double mismatch;
    double sin_phi;
    double cos_phi;
    double r;
    double lateral;
    double x_track;
    double pitch_sin;
    double pitch_cos;
    double ahead;
    double z_track;
    int64_t touches;
    place = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_PLACE;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    contact_plane__open_frame(&z, &slope, &y_track, &rail_slope, &mismatch, work, tables, place, y, aside, shift);
    locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
    r = (*cspan_at(&tables, layout__TABLES_RADIUS)) + z;
    lateral = ((*cspan_at(&work, place + layout__PLACE_ARM)) + y) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) - r * cos_phi * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    x_track = (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r * sin_phi - (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        rails__pitch_of_frame(&pitch_sin, &pitch_cos, work, place);
        ahead = sin_phi * pitch_cos - cos_phi * pitch_sin;
        cos_phi = sin_phi * pitch_sin + cos_phi * pitch_cos;
        sin_phi = ahead;
    }
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_X_WHEEL)) = r * sin_phi;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_WHEEL)) = y;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Z_WHEEL)) = r * cos_phi - (*cspan_at(&tables, layout__TABLES_RADIUS));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Z_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
    rails__on_track(&y_track, &z_track, work, place, (*cspan_at(&tables, layout__TABLES_RAIL_Y)), y_track, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z)));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_X_TRACK)) = x_track;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_TRACK)) = y_track;
    if (index == INT64_C(0))
    {
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_TRACK)) = -y_track;
    }
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Z_TRACK)) = z_track;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CONTACT_ANGLE)) = -atan(rail_slope);
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CONTACT_ANGLE)) = (-atan(rail_slope)) - (*cspan_at(&work, place + layout__PLACE_RAIL_ROLL));
    }
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_ROLLING_RADIUS)) = r;
    regions__measure_contact(work, tables, state);
    regions__open_contact_region(work, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS);
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CURVATURE_X)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_CURVATURE));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CURVATURE_Y)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_BEND));
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CURVATURE_Y)) = 2.0 * lateral_curvature__relative_curvature(tables, y, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)));
    }
    touches = INT64_C(1);
    if (fabs(mismatch) >= contact_point__PARALLEL)
    {
        if ((fabs(mismatch) > contact_point__CORNER) || (contact_point__is_end(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y) == INT64_C(1)))
        {
            touches = INT64_C(0);
        }
        if (contact_point__is_end(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y))) == INT64_C(1))
        {
            touches = INT64_C(0);
        }
    }
    return touches;
}

/* 1 if ``y`` [m] is at an end of the profile, else 0. */
static inline int64_t contact_point__is_end(array_double_1d tables, int64_t profile, double y)
{
    int64_t end;
    end = INT64_C(0);
    if ((y < (*cspan_at(&tables, profile + layout__PROFILE_START)) + contact_point__AT_END) || (y > (*cspan_at(&tables, profile + layout__PROFILE_STOP)) - contact_point__AT_END))
    {
        end = INT64_C(1);
    }
    return end;
}
