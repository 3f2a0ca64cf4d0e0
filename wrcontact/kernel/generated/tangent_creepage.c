/* Generated from tangent_creepage.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of creepage.py.
 */

#include "tangent_creepage.h"

/* Tangent of ``write_side_creepages``. */
static inline int64_t tangent_creepage__write_side_creepages_t(array_double_1d work, array_double_1d work_t, int64_t rail, int64_t side, double mirror, double mirror_t)
{
    int64_t index;
    int64_t patch;
    for (index = INT64_C(0); index < layout__PATCH_LIMIT; index += INT64_C(1))
    {
        patch = side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * index;
        if ((*cspan_at(&work, patch + layout__PATCH_NORMAL_FORCE)) > 0.0)
        {
            tangent_creepage__write_creepage_t(work, work_t, rail, patch, mirror, mirror_t);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``write_creepage``. */
static inline int64_t tangent_creepage__write_creepage_t(array_double_1d work, array_double_1d work_t, int64_t rail, int64_t patch, double mirror, double mirror_t)
{
    double x_t;
    double x;
    double y_t;
    double y;
    double z_t;
    double z;
    double rolling_x;
    double rolling_x_t;
    double rolling_y;
    double rolling_y_t;
    double rolling_z;
    double rolling_z_t;
    double v1;
    double v1_t;
    double along_t;
    double along;
    double v2;
    double lateral_t;
    double lateral;
    double v3;
    double vertical_t;
    double vertical;
    double v4;
    double v5;
    double normal_y_t;
    double normal_y;
    double normal_z_t;
    double normal_z;
    double v6;
    double v6_t;
    double reference_t;
    double reference;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    x_t = (*cspan_at(&work_t, patch + layout__PATCH_X_TRACK));
    x = (*cspan_at(&work, patch + layout__PATCH_X_TRACK));
    y_t = (*cspan_at(&work_t, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    y = (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z_t = (*cspan_at(&work_t, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    z = (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    tangent_creepage__rolling_velocity_t(&rolling_x, &rolling_x_t, &rolling_y, &rolling_y_t, &rolling_z, &rolling_z_t, work, work_t, x, x_t, y, y_t, z, z_t, (*cspan_at(&work, patch + layout__PATCH_ROLLING_RADIUS)), (*cspan_at(&work_t, patch + layout__PATCH_ROLLING_RADIUS)));
    tangent_creepage__velocity_along_t(&v1, &v1_t, work, work_t, y, y_t, z, z_t, rolling_x, rolling_x_t);
    along_t = v1_t;
    along = v1;
    v2 = (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z));
    lateral_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_LATERAL)) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x_t) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z_t) - rolling_y_t - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_LATERAL)) + ((*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)) * v2 + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work_t, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Z))));
    lateral = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z - rolling_y - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL)) + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * v2;
    v3 = (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y));
    vertical_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x_t) - rolling_z_t - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_VERTICAL)) - ((*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)) * v3 + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work_t, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Y))));
    vertical = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x - rolling_z - (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * v3;
    v4 = -mirror;
    v5 = sin((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_y_t = (-mirror_t) * v5 + v4 * (cos((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE))) * (*cspan_at(&work_t, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_y = v4 * v5;
    normal_z_t = -((-sin((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)))) * (*cspan_at(&work_t, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_z = -cos((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)));
    tangent_creepage__reference_speed_t(&v6, &v6_t, work, work_t, rolling_x, rolling_x_t);
    reference_t = v6_t;
    reference = v6;
    if (reference > creepage__STANDSTILL)
    {
        v7 = along / reference;
        (*cspan_at(&work_t, patch + layout__PATCH_CREEPAGE_X)) = (along_t - v7 * reference_t) / reference;
        (*cspan_at(&work, patch + layout__PATCH_CREEPAGE_X)) = v7;
        v8 = normal_z * lateral - normal_y * vertical;
        v9 = v8 / reference;
        (*cspan_at(&work_t, patch + layout__PATCH_CREEPAGE_Y)) = (normal_z_t * lateral + normal_z * lateral_t - (normal_y_t * vertical + normal_y * vertical_t) - v9 * reference_t) / reference;
        (*cspan_at(&work, patch + layout__PATCH_CREEPAGE_Y)) = v9;
        v10 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y));
        v11 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z));
        v12 = v10 * normal_y + v11 * normal_z;
        v13 = v12 / reference;
        (*cspan_at(&work_t, patch + layout__PATCH_SPIN)) = (((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Y)))) * normal_y + v10 * normal_y_t + (((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) + (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Z)))) * normal_z + v11 * normal_z_t) - v13 * reference_t) / reference;
        (*cspan_at(&work, patch + layout__PATCH_SPIN)) = v13;
    }
    return INT64_C(0);
}

/* Tangent of ``rolling_velocity``. */
static inline int64_t tangent_creepage__rolling_velocity_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d work, array_double_1d work_t, double x, double x_t, double y, double y_t, double z, double z_t, double radius, double radius_t)
{
    double around_x_t;
    double around_x;
    double around_y_t;
    double around_y;
    double around_z_t;
    double around_z;
    double v1;
    double v2;
    double distance_t;
    double distance;
    double v3;
    double v4;
    double rolling_t;
    double rolling;
    around_x_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * z_t - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * y_t);
    around_x = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * z - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * y;
    around_y_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * x_t - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * z_t);
    around_y = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) * x - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * z;
    around_z_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * y_t - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * x_t);
    around_z = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) * x;
    v1 = around_x * around_x + around_y * around_y + around_z * around_z;
    v2 = sqrt(v1);
    distance_t = tangent_rates__root_rate(v2, around_x_t * around_x + around_x * around_x_t + (around_y_t * around_y + around_y * around_y_t) + (around_z_t * around_z + around_z * around_z_t));
    distance = v2;
    v3 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * radius;
    v4 = v3 / distance;
    rolling_t = ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * radius + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * radius_t - v4 * distance_t) / distance;
    rolling = v4;
    (*result_0) = rolling * around_x;
    (*result_1) = rolling_t * around_x + rolling * around_x_t;
    (*result_2) = rolling * around_y;
    (*result_3) = rolling_t * around_y + rolling * around_y_t;
    (*result_4) = rolling * around_z;
    (*result_5) = rolling_t * around_z + rolling * around_z_t;
    return 0;
}

/* Tangent of ``velocity_along``. */
static inline int64_t tangent_creepage__velocity_along_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double y, double y_t, double z, double z_t, double rolling_x, double rolling_x_t)
{
    double v1;
    v1 = y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    (*result_0) = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * v1 + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y - rolling_x;
    (*result_1) = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_SPEED)) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * v1 + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * (y_t + (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)))) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y_t) - rolling_x_t;
    return 0;
}

/* Tangent of ``reference_speed``. */
static inline int64_t tangent_creepage__reference_speed_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double rolling_x, double rolling_x_t)
{
    double v1;
    v1 = fabs((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED))) + fabs(rolling_x);
    (*result_0) = 0.5 * v1;
    (*result_1) = 0.5 * (tangent_rates__size_rate((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)), (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_SPEED))) + tangent_rates__size_rate(rolling_x, rolling_x_t));
    return 0;
}

/* Tangent of ``patch_speed``. */
static inline int64_t tangent_creepage__patch_speed_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, int64_t patch)
{
    double rolling_x;
    double rolling_x_t;
    double rolling_y;
    double rolling_y_t;
    double rolling_z;
    double rolling_z_t;
    tangent_creepage__rolling_velocity_t(&rolling_x, &rolling_x_t, &rolling_y, &rolling_y_t, &rolling_z, &rolling_z_t, work, work_t, (*cspan_at(&work, patch + layout__PATCH_X_TRACK)), (*cspan_at(&work_t, patch + layout__PATCH_X_TRACK)), (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)), (*cspan_at(&work_t, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)), (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)), (*cspan_at(&work_t, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)), (*cspan_at(&work, patch + layout__PATCH_ROLLING_RADIUS)), (*cspan_at(&work_t, patch + layout__PATCH_ROLLING_RADIUS)));
    tangent_creepage__reference_speed_t(v1, v1_t, work, work_t, rolling_x, rolling_x_t);
    return 0;
}
