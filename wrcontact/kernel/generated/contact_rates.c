/* Generated from motion/contact_rates.py by tools/transpile_kernel.py; change that one.
 *
 * Vertical velocity and roll rate of a wheelset that stays on both rails.
 *
 * A wheel that stays in contact moves along the plane of the contact: the velocity of its surface against the
 * rail has no part along the normal n.  With the velocity v of the wheelset's centre and its rotation W this is
 *
 *     n . v + ((P - C) x n) . W = the same for the rail
 *
 * at each wheel, two linear equations for the two that are not given.  The rotation about the axle is left out:
 * it does not move the surface of a round wheel, whose normal goes through the axle.
 */

#include "contact_rates.h"

/* The normal of the place where a rigid wheel touches its rail; ``mirror`` = 1 on the right, -1 on the
 * left.
 */
static inline int64_t contact_rates__touching_constraint(array_double_1d work, int64_t side, double mirror, int64_t constraint)
{
    double x;
    double y;
    double z;
    double normal_y;
    double normal_z;
    x = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_X_TRACK));
    y = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    normal_y = (-mirror) * sin((*cspan_at(&work, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    normal_z = -cos((*cspan_at(&work, side + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) = normal_y;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) = normal_z;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) = y * normal_z - z * normal_y;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Y)) = (-x) * normal_z;
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) = x * normal_y;
    return INT64_C(0);
}

/* The force of an elastic wheel [N] and its moment about the wheelset's centre [N m]: what its patches
 * approach is zero in the mean over the load, which stays.
 */
static inline int64_t contact_rates__loaded_constraint(array_double_1d work, int64_t side, int64_t constraint)
{
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Y)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1)));
    (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2)));
    return INT64_C(0);
}

/* What the velocities that are known do with the constraint of side ``index``. */
static inline double contact_rates__known_part(array_double_1d work, int64_t index)
{
    int64_t constraint;
    int64_t rail;
    double rail_moment;
    double result;
    constraint = layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * index;
    rail = layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * index;
    /* of the force about the point about which the rail rolls */
    rail_moment = (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_X)) + ((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y))) * (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) - ((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z))) * (*cspan_at(&work, constraint + layout__CONSTRAINT_Y));
    result = (*cspan_at(&work, constraint + layout__CONSTRAINT_Y)) * ((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL))) + (*cspan_at(&work, constraint + layout__CONSTRAINT_MOMENT_Z)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) - (*cspan_at(&work, constraint + layout__CONSTRAINT_Z)) * (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - rail_moment * (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL));
    return result;
}

/* Vertical velocity [m/s] and roll rate [rad/s] with which both constraints hold; zero where they cannot
 * tell.
 */
static inline int64_t contact_rates__contact_rates(double* vertical, double* roll_rate, array_double_1d work)
{
    double sin_yaw;
    double cos_yaw;
    int64_t right;
    double left_roll;
    double right_roll;
    double known_left;
    double known_right;
    double determinant;
    sin_yaw = sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    cos_yaw = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    right = layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * INT64_C(1);
    left_roll = cos_yaw * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_X)) + sin_yaw * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_MOMENT_Y));
    right_roll = cos_yaw * (*cspan_at(&work, right + layout__CONSTRAINT_MOMENT_X)) + sin_yaw * (*cspan_at(&work, right + layout__CONSTRAINT_MOMENT_Y));
    known_left = contact_rates__known_part(work, INT64_C(0));
    known_right = contact_rates__known_part(work, INT64_C(1));
    determinant = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z)) * right_roll - (*cspan_at(&work, right + layout__CONSTRAINT_Z)) * left_roll;
    (*vertical) = 0.0;
    (*roll_rate) = 0.0;
    if (determinant != 0.0)
    {
        (*vertical) = (known_right * left_roll - known_left * right_roll) / determinant;
        (*roll_rate) = (known_left * (*cspan_at(&work, right + layout__CONSTRAINT_Z)) - known_right * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_Z))) / determinant;
    }
    return 0;
}
