/* Generated from motion/creepage.py by tools/transpile_kernel.py; change that one.
 *
 * Creepages of the patches: how the wheel slides and turns on the rail, over the rolling speed.
 *
 * At a patch's centre of load P the wheel's surface has the velocity
 *
 *     v = (V, y', z') + W x (P - C) - w e2 x (P - C)
 *
 * with the velocity of the wheelset's centre C, its rotation W but for that about the axle, and its rotation w
 * about the axle e2, positive when it rolls forward.  With the normal n from the rail to the wheel and
 * y_c = n x e_x, which points to the left on both sides,
 *
 *     V_ref = (|V| + |w e2 x (P - C)|_x) / 2
 *     xi = v . e_x / V_ref,   eta = v . y_c / V_ref,   phi = (W - w e2) . n / V_ref
 *
 * The distance of P from the axle counts as the rolling radius there: an elastic wheel turns with the
 * circumference that it has when it carries nothing, however deep it is pressed.
 */

#include "creepage.h"

/* Creepages of the patches of a side; ``mirror`` = 1 on the right, -1 on the left. */
static inline int64_t creepage__write_side_creepages(array_double_1d work, int64_t rail, int64_t side, double mirror)
{
    int64_t index;
    int64_t patch;
    for (index = INT64_C(0); index < layout__PATCH_LIMIT; index += INT64_C(1))
    {
        patch = side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * index;
        if ((*cspan_at(&work, patch + layout__PATCH_NORMAL_FORCE)) > 0.0)
        {
            creepage__write_creepage(work, rail, patch, mirror);
        }
    }
    return INT64_C(0);
}

/* Creepages of one patch. */
static inline int64_t creepage__write_creepage(array_double_1d work, int64_t rail, int64_t patch, double mirror)
{
    double x;
    double y;
    double z;
    double rolling_x;
    double rolling_y;
    double rolling_z;
    double along;
    double lateral;
    double vertical;
    double normal_y;
    double normal_z;
    double reference;
    x = (*cspan_at(&work, patch + layout__PATCH_X_TRACK));
    y = (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z = (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    creepage__rolling_velocity(&rolling_x, &rolling_y, &rolling_z, work, x, y, z, (*cspan_at(&work, patch + layout__PATCH_ROLLING_RADIUS)));
    along = creepage__velocity_along(work, y, z, rolling_x);
    lateral = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z - rolling_y - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL)) + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z)));
    vertical = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x - rolling_z - (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y)));
    normal_y = (-mirror) * sin((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_z = -cos((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)));
    reference = creepage__reference_speed(work, rolling_x);
    if (reference > creepage__STANDSTILL)
    {
        (*cspan_at(&work, patch + layout__PATCH_CREEPAGE_X)) = along / reference;
        (*cspan_at(&work, patch + layout__PATCH_CREEPAGE_Y)) = (normal_z * lateral - normal_y * vertical) / reference;
        (*cspan_at(&work, patch + layout__PATCH_SPIN)) = (((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y))) * normal_y + ((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z))) * normal_z) / reference;
    }
    return INT64_C(0);
}

/* Velocity w e2 x (P - C) [m/s] of a place (x, y, z) from the wheelset's centre, where the wheel has the
 * rolling ``radius`` [m]; its three components.
 */
static inline int64_t creepage__rolling_velocity(double* result_0, double* result_1, double* result_2, array_double_1d work, double x, double y, double z, double radius)
{
    double around_x;
    double around_y;
    double around_z;
    double distance;
    double rolling;
    around_x = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * z - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * y;
    around_y = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * x - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * z;
    around_z = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * x;
    distance = sqrt(around_x * around_x + around_y * around_y + around_z * around_z);
    rolling = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * radius / distance;
    (*result_0) = rolling * around_x;
    (*result_1) = rolling * around_y;
    (*result_2) = rolling * around_z;
    return 0;
}

/* Velocity of the wheel's surface along the track [m/s] at a place y, z from the wheelset's centre. */
static inline double creepage__velocity_along(array_double_1d work, double y, double z, double rolling_x)
{
    double result;
    result = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * (y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y))) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y - rolling_x;
    return result;
}

/* The rolling speed [m/s] that creepages are referred to. */
static inline double creepage__reference_speed(array_double_1d work, double rolling_x)
{
    double result;
    result = 0.5 * (fabs((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED))) + fabs(rolling_x));
    return result;
}

/* The rolling speed [m/s] that the creepages of a patch are referred to. */
static inline double creepage__patch_speed(array_double_1d work, int64_t patch)
{
    double rolling_x;
    double rolling_y;
    double rolling_z;
    double result;
    creepage__rolling_velocity(&rolling_x, &rolling_y, &rolling_z, work, (*cspan_at(&work, patch + layout__PATCH_X_TRACK)), (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)), (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)), (*cspan_at(&work, patch + layout__PATCH_ROLLING_RADIUS)));
    result = creepage__reference_speed(work, rolling_x);
    return result;
}
