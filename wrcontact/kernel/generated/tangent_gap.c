/* Generated from tangent_gap.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of gap.py.
 */

#include "tangent_gap.h"

/* Tangent of ``vertical_gap``. */
static inline int64_t tangent_gap__vertical_gap_t(double* result_0, double* result_1, double* mismatch, double* mismatch_t, double* result_4, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t)
{
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double stretch;
    double stretch_t;
    double outline_rate;
    double outline_rate_t;
    double z_rail;
    double z_rail_t;
    double rail_slope;
    double rail_slope_t;
    double rail_bend;
    double rail_bend_t;
    tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &outline_rate, &outline_rate_t, work, work_t, place, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
    tangent_profile_table__height_slope_bend_t(&z_rail, &z_rail_t, &rail_slope, &rail_slope_t, &rail_bend, &rail_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)), y_track_t);
    (*mismatch_t) = rail_slope_t - outline_slope_t;
    (*mismatch) = rail_slope - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch_t) = 0.0;
        (*mismatch) = gap__FOLDED;
    }
    (*result_0) = z_rail - z_track;
    (*result_1) = z_rail_t - z_track_t;
    (*result_4) = rail_bend * stretch - outline_rate;
    (*result_5) = rail_bend_t * stretch + rail_bend * stretch_t - outline_rate_t;
    return 0;
}

/* Tangent of ``gap_per_roll``. */
static inline int64_t tangent_gap__gap_per_roll_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t)
{
    double z;
    double z_t;
    double slope;
    double slope_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double z_rail;
    double z_rail_t;
    double rail_slope;
    double rail_slope_t;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double arm_t;
    double arm;
    double v1;
    double height_t;
    double height;
    double sin_roll_t;
    double sin_roll;
    double cos_roll_t;
    double cos_roll;
    double v2;
    double v3;
    double lateral_t;
    double lateral;
    double vertical_t;
    double vertical;
    tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_locus__outline_point_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, work, work_t, place, y, y_t, z, z_t, slope, slope_t);
    tangent_profile_table__height_slope_t(&z_rail, &z_rail_t, &rail_slope, &rail_slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)), y_track_t);
    tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, slope, slope_t);
    arm_t = (*cspan_at(&work_t, place + layout__PLACE_ARM)) + y_t;
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    v1 = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    height_t = ((*cspan_at(&work_t, place + layout__PLACE_RADIUS)) + z_t) * cos_phi + v1 * cos_phi_t;
    height = v1 * cos_phi;
    sin_roll_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL));
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll_t = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    v2 = -(*cspan_at(&work, place + layout__PLACE_COS_YAW));
    v3 = arm * sin_roll + height * cos_roll;
    lateral_t = (-(*cspan_at(&work_t, place + layout__PLACE_COS_YAW))) * v3 + v2 * (arm_t * sin_roll + arm * sin_roll_t + (height_t * cos_roll + height * cos_roll_t));
    lateral = v2 * v3;
    vertical_t = arm_t * cos_roll + arm * cos_roll_t - (height_t * sin_roll + height * sin_roll_t);
    vertical = arm * cos_roll - height * sin_roll;
    (*result_0) = rail_slope * lateral - vertical;
    (*result_1) = rail_slope_t * lateral + rail_slope * lateral_t - vertical_t;
    return 0;
}
