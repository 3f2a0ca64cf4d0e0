/* Generated from tangent_contact_rates.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_rates.py.
 */

#include "tangent_contact_rates.h"

/* Tangent of ``touching_constraint``. */
static inline int64_t tangent_contact_rates__touching_constraint_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, double mirror, double mirror_t, int64_t constraint)
{
    int64_t place;
    double wheel_height;
    double wheel_height_t;
    double wheel_slope;
    double wheel_slope_t;
    double r_t;
    double r;
    double arm_t;
    double arm;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double v1;
    double lateral_t;
    double lateral;
    double v2;
    double x_t;
    double x;
    double v3;
    double y_t;
    double y;
    double v4;
    double z_t;
    double z;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double normal_y;
    double normal_y_t;
    double normal_z;
    double normal_z_t;
    double v5;
    double v6;
    double v7;
    place = side + layout__SIDE_SEARCH_PLACE;
    tangent_profile_table__height_slope_t(&wheel_height, &wheel_height_t, &wheel_slope, &wheel_slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST_Y)));
    r_t = (*cspan_at(&work_t, place + layout__PLACE_RADIUS)) + wheel_height_t;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + wheel_height;
    arm_t = (*cspan_at(&work_t, place + layout__PLACE_ARM)) + (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST_Y));
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y));
    tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, wheel_slope, wheel_slope_t);
    v1 = r * cos_phi;
    lateral_t = arm_t * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + arm * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)) - ((r_t * cos_phi + r * cos_phi_t) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + v1 * (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)));
    lateral = arm * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) - v1 * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    v2 = (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r;
    x_t = ((*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) * r + (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r_t) * sin_phi + v2 * sin_phi_t - ((*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) * lateral + (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral_t);
    x = v2 * sin_phi - (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral;
    v3 = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * r;
    y_t = ((*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) * r + (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * r_t) * sin_phi + v3 * sin_phi_t + ((*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) * lateral + (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * lateral_t);
    y = v3 * sin_phi + (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * lateral;
    v4 = r * cos_phi;
    z_t = arm_t * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + arm * (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)) + ((r_t * cos_phi + r * cos_phi_t) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + v4 * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)));
    z = arm * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + v4 * (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, place + layout__PLACE_SHIFT)) + y - (*cspan_at(&tables, layout__TABLES_RAIL_Y)), (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) + y_t);
    tangent_contact_rates__turned_by_rail_t(&normal_y, &normal_y_t, &normal_z, &normal_z_t, work, work_t, place, slope, slope_t, -1.0, 0.0);
    tangent_contact_rates__turned_by_rail_t(&y, &y_t, &z, &z_t, work, work_t, place, y, y_t, z, z_t);
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Y)) = mirror_t * normal_y + mirror * normal_y_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) = mirror * normal_y;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Z)) = normal_z_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) = normal_z;
    v5 = y * normal_z - z * normal_y;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_X)) = mirror_t * v5 + mirror * (y_t * normal_z + y * normal_z_t - (z_t * normal_y + z * normal_y_t));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) = mirror * v5;
    v6 = -x;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Y)) = (-x_t) * normal_z + v6 * normal_z_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Y)) = v6 * normal_z;
    v7 = mirror * x;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Z)) = (mirror_t * x + mirror * x_t) * normal_y + v7 * normal_y_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) = v7 * normal_y;
    return INT64_C(0);
}

/* Tangent of ``turned_by_rail``. */
static inline int64_t tangent_contact_rates__turned_by_rail_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t place, double y, double y_t, double z, double z_t)
{
    double across_t;
    double across;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        across_t = y_t;
        across = y;
        y_t = (*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * across_t - ((*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * z + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * z_t);
        y = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * across - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * z;
        z_t = (*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * across_t + ((*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * z + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * z_t);
        z = (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * z;
    }
    (*result_0) = y;
    (*result_1) = y_t;
    (*result_2) = z;
    (*result_3) = z_t;
    return 0;
}

/* Tangent of ``loaded_constraint``. */
static inline int64_t tangent_contact_rates__loaded_constraint_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t constraint)
{
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Y)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1)));
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Z)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2)));
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_X)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0)));
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Y)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Y)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1)));
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Z)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2)));
    return INT64_C(0);
}

/* Tangent of ``known_part``. */
static inline int64_t tangent_contact_rates__known_part_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index)
{
    int64_t constraint;
    int64_t rail;
    double v1;
    double v2;
    double rail_moment_t;
    double rail_moment;
    double v3;
    constraint = layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * index;
    rail = layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * index;
    v1 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y));
    v2 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z));
    rail_moment_t = (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_X)) + (((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Y))) * (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) + v1 * (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Z))) - (((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Z))) * (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) + v2 * (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Y)));
    rail_moment = (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) + v1 * (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) - v2 * (*cspan_at(&work, constraint + layout__CONSTRAINT_Y));
    v3 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL));
    (*result_0) = (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) * v3 + (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) - (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) * (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - rail_moment * (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL));
    (*result_1) = (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Y)) * v3 + (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) * ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_LATERAL)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_LATERAL))) + ((*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Z)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) + (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z))) - ((*cspan_at(&work_t, constraint + layout__CONSTRAINT_Z)) * (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) + (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) * (*cspan_at(&work_t, rail + layout__RAIL_MOTION_VERTICAL))) - (rail_moment_t * (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) + rail_moment * (*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)));
    return 0;
}

/* Tangent of ``contact_rates``. */
static inline int64_t tangent_contact_rates__contact_rates_t(double* vertical, double* vertical_t, double* roll_rate, double* roll_rate_t, array_double_1d work, array_double_1d work_t)
{
    double sin_yaw_t;
    double sin_yaw;
    double cos_yaw_t;
    double cos_yaw;
    int64_t right;
    double left_roll_t;
    double left_roll;
    double right_roll_t;
    double right_roll;
    double v1;
    double v1_t;
    double known_left_t;
    double known_left;
    double v2;
    double v2_t;
    double known_right_t;
    double known_right;
    double determinant_t;
    double determinant;
    double v3;
    double v4;
    double v5;
    double v6;
    sin_yaw_t = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW))) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW));
    sin_yaw = sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    cos_yaw_t = (-sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)))) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW));
    cos_yaw = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    right = layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * INT64_C(1);
    left_roll_t = cos_yaw_t * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_X)) + cos_yaw * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_X)) + (sin_yaw_t * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_Y)) + sin_yaw * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_Y)));
    left_roll = cos_yaw * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_X)) + sin_yaw * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_Y));
    right_roll_t = cos_yaw_t * (*cspan_at(&work, right + layout__CONSTRAINT_MOMENT_X)) + cos_yaw * (*cspan_at(&work_t, right + layout__CONSTRAINT_MOMENT_X)) + (sin_yaw_t * (*cspan_at(&work, right + layout__CONSTRAINT_MOMENT_Y)) + sin_yaw * (*cspan_at(&work_t, right + layout__CONSTRAINT_MOMENT_Y)));
    right_roll = cos_yaw * (*cspan_at(&work, right + layout__CONSTRAINT_MOMENT_X)) + sin_yaw * (*cspan_at(&work, right + layout__CONSTRAINT_MOMENT_Y));
    tangent_contact_rates__known_part_t(&v1, &v1_t, work, work_t, INT64_C(0));
    known_left_t = v1_t;
    known_left = v1;
    tangent_contact_rates__known_part_t(&v2, &v2_t, work, work_t, INT64_C(1));
    known_right_t = v2_t;
    known_right = v2;
    determinant_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z)) * right_roll + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z)) * right_roll_t - ((*cspan_at(&work_t, right + layout__CONSTRAINT_Z)) * left_roll + (*cspan_at(&work, right + layout__CONSTRAINT_Z)) * left_roll_t);
    determinant = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z)) * right_roll - (*cspan_at(&work, right + layout__CONSTRAINT_Z)) * left_roll;
    (*vertical_t) = 0.0;
    (*vertical) = 0.0;
    (*roll_rate_t) = 0.0;
    (*roll_rate) = 0.0;
    if (determinant != 0.0)
    {
        v3 = known_right * left_roll - known_left * right_roll;
        v4 = v3 / determinant;
        (*vertical_t) = (known_right_t * left_roll + known_right * left_roll_t - (known_left_t * right_roll + known_left * right_roll_t) - v4 * determinant_t) / determinant;
        (*vertical) = v4;
        v5 = known_left * (*cspan_at(&work, right + layout__CONSTRAINT_Z)) - known_right * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z));
        v6 = v5 / determinant;
        (*roll_rate_t) = (known_left_t * (*cspan_at(&work, right + layout__CONSTRAINT_Z)) + known_left * (*cspan_at(&work_t, right + layout__CONSTRAINT_Z)) - (known_right_t * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z)) + known_right * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z))) - v6 * determinant_t) / determinant;
        (*roll_rate) = v6;
    }
    return 0;
}
