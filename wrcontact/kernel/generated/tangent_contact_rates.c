/* Generated from tangent_contact_rates.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_rates.py.
 */

#include "tangent_contact_rates.h"

/* Tangent of ``touching_constraint``. */
static inline int64_t tangent_contact_rates__touching_constraint_t(array_double_1d work, array_double_1d work_t, int64_t side, double mirror, double mirror_t, int64_t constraint)
{
    double x_t;
    double x;
    double y_t;
    double y;
    double z_t;
    double z;
    double v1;
    double v2;
    double normal_y_t;
    double normal_y;
    double normal_z_t;
    double normal_z;
    double v3;
    x_t = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_X_TRACK));
    x = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_X_TRACK));
    y_t = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    y = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z_t = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    z = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    v1 = -mirror;
    v2 = sin((*cspan_at(&work, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    normal_y_t = (-mirror_t) * v2 + v1 * (cos((*cspan_at(&work, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE))) * (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    normal_y = v1 * v2;
    normal_z_t = -((-sin((*cspan_at(&work, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)))) * (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    normal_z = -cos((*cspan_at(&work, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Y)) = normal_y_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) = normal_y;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_Z)) = normal_z_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) = normal_z;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_X)) = y_t * normal_z + y * normal_z_t - (z_t * normal_y + z * normal_y_t);
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) = y * normal_z - z * normal_y;
    v3 = -x;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Y)) = (-x_t) * normal_z + v3 * normal_z_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Y)) = v3 * normal_z;
    (*cspan_at(&work_t, constraint + layout__CONSTRAINT_MOMENT_Z)) = x_t * normal_y + x * normal_y_t;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) = x * normal_y;
    return INT64_C(0);
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
