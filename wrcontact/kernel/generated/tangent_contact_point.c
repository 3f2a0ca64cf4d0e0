/* Generated from tangent_contact_point.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_point.py.
 */

#include "tangent_contact_point.h"

/* Tangent of ``describe_contact``. */
static inline int64_t tangent_contact_point__describe_contact_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double y, double y_t, double aside, double aside_t, double shift, double shift_t)
{
    int64_t place;
    int64_t out;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double y_track;
    double y_track_t;
    double rail_slope;
    double rail_slope_t;
    double mismatch;
    double mismatch_t;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double r_t;
    double r;
    double v1;
    double v2;
    double lateral_t;
    double lateral;
    double v3;
    double x_track_t;
    double x_track;
    double pitch_sin;
    double pitch_sin_t;
    double pitch_cos;
    double pitch_cos_t;
    double ahead_t;
    double ahead;
    double z_track;
    double z_track_t;
    double v4;
    double v4_t;
    int64_t touches;
    place = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_PLACE;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    tangent_contact_plane__open_frame_t(&z, &z_t, &slope, &slope_t, &y_track, &y_track_t, &rail_slope, &rail_slope_t, &mismatch, &mismatch_t, work, work_t, tables, place, y, y_t, aside, aside_t, shift, shift_t);
    tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, slope, slope_t);
    r_t = z_t;
    r = (*cspan_at(&tables, layout__TABLES_RADIUS)) + z;
    v1 = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    v2 = r * cos_phi;
    lateral_t = ((*cspan_at(&work_t, place + layout__PLACE_ARM)) + y_t) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + v1 * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)) - ((r_t * cos_phi + r * cos_phi_t) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + v2 * (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)));
    lateral = v1 * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) - v2 * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    v3 = (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r;
    x_track_t = ((*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) * r + (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r_t) * sin_phi + v3 * sin_phi_t - ((*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) * lateral + (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral_t);
    x_track = v3 * sin_phi - (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        tangent_rails__pitch_of_frame_t(&pitch_sin, &pitch_sin_t, &pitch_cos, &pitch_cos_t, work, work_t, place);
        ahead_t = sin_phi_t * pitch_cos + sin_phi * pitch_cos_t - (cos_phi_t * pitch_sin + cos_phi * pitch_sin_t);
        ahead = sin_phi * pitch_cos - cos_phi * pitch_sin;
        cos_phi_t = sin_phi_t * pitch_sin + sin_phi * pitch_sin_t + (cos_phi_t * pitch_cos + cos_phi * pitch_cos_t);
        cos_phi = sin_phi * pitch_sin + cos_phi * pitch_cos;
        sin_phi_t = ahead_t;
        sin_phi = ahead;
    }
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_X_WHEEL)) = r_t * sin_phi + r * sin_phi_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_X_WHEEL)) = r * sin_phi;
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Y_WHEEL)) = y_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_WHEEL)) = y;
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Z_WHEEL)) = r_t * cos_phi + r * cos_phi_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Z_WHEEL)) = r * cos_phi - (*cspan_at(&tables, layout__TABLES_RADIUS));
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Y_RAIL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Z_RAIL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Z_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
    tangent_rails__on_track_t(&y_track, &y_track_t, &z_track, &z_track_t, work, work_t, place, (*cspan_at(&tables, layout__TABLES_RAIL_Y)), 0.0, y_track, y_track_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z)));
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_X_TRACK)) = x_track_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_X_TRACK)) = x_track;
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Y_TRACK)) = y_track_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_TRACK)) = y_track;
    if (index == INT64_C(0))
    {
        (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Y_TRACK)) = -y_track_t;
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Y_TRACK)) = -y_track;
    }
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_Z_TRACK)) = z_track_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_Z_TRACK)) = z_track;
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_CONTACT_ANGLE)) = -(rail_slope_t / (1.0 + rail_slope * rail_slope));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CONTACT_ANGLE)) = -atan(rail_slope);
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_CONTACT_ANGLE)) = (-(rail_slope_t / (1.0 + rail_slope * rail_slope))) - (*cspan_at(&work_t, place + layout__PLACE_RAIL_ROLL));
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CONTACT_ANGLE)) = (-atan(rail_slope)) - (*cspan_at(&work, place + layout__PLACE_RAIL_ROLL));
    }
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_ROLLING_RADIUS)) = r_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_ROLLING_RADIUS)) = r;
    tangent_regions__measure_contact_t(work, work_t, tables, state);
    tangent_regions__open_contact_region_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS);
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_CURVATURE_X)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_CURVATURE));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CURVATURE_X)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_CURVATURE));
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_CURVATURE_Y)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_BEND));
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CURVATURE_Y)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_BEND));
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        tangent_lateral_curvature__relative_curvature_t(&v4, &v4_t, tables, y, y_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)));
        (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_CURVATURE_Y)) = 2.0 * v4_t;
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_CURVATURE_Y)) = 2.0 * v4;
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
