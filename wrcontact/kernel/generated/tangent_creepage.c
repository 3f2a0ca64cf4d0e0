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
    double along_t;
    double along;
    double v5;
    double lateral_t;
    double lateral;
    double v6;
    double vertical_t;
    double vertical;
    double v7;
    double v8;
    double normal_y_t;
    double normal_y;
    double normal_z_t;
    double normal_z;
    double v9;
    double v10;
    double reference_t;
    double reference;
    double v11;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    double v17;
    x_t = (*cspan_at(&work_t, patch + layout__PATCH_X_TRACK));
    x = (*cspan_at(&work, patch + layout__PATCH_X_TRACK));
    y_t = (*cspan_at(&work_t, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    y = (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z_t = (*cspan_at(&work_t, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    z = (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
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
    v3 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, patch + layout__PATCH_ROLLING_RADIUS));
    v4 = v3 / distance;
    rolling_t = ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, patch + layout__PATCH_ROLLING_RADIUS)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work_t, patch + layout__PATCH_ROLLING_RADIUS)) - v4 * distance_t) / distance;
    rolling = v4;
    along_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_SPEED)) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * (*cspan_at(&work_t, patch + layout__PATCH_Y_TRACK))) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y_t) - (rolling_t * around_x + rolling * around_x_t);
    along = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * z - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * y - rolling * around_x;
    v5 = (*cspan_at(&work, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z));
    lateral_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_LATERAL)) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x_t) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z_t) - (rolling_t * around_y + rolling * around_y_t) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_LATERAL)) + ((*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)) * v5 + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work_t, patch + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Z))));
    lateral = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * x - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z - rolling * around_y - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL)) + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * v5;
    v6 = (*cspan_at(&work, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y));
    vertical_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x_t) - (rolling_t * around_z + rolling * around_z_t) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_VERTICAL)) - ((*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)) * v6 + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work_t, patch + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Y))));
    vertical = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * x - rolling * around_z - (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * v6;
    v7 = -mirror;
    v8 = sin((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_y_t = (-mirror_t) * v8 + v7 * (cos((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE))) * (*cspan_at(&work_t, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_y = v7 * v8;
    normal_z_t = -((-sin((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)))) * (*cspan_at(&work_t, patch + layout__PATCH_CONTACT_ANGLE)));
    normal_z = -cos((*cspan_at(&work, patch + layout__PATCH_CONTACT_ANGLE)));
    v9 = rolling * around_x;
    v10 = fabs((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED))) + fabs(v9);
    reference_t = 0.5 * (tangent_rates__size_rate((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)), (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_SPEED))) + tangent_rates__size_rate(v9, rolling_t * around_x + rolling * around_x_t));
    reference = 0.5 * v10;
    if (reference > creepage__STANDSTILL)
    {
        v11 = along / reference;
        (*cspan_at(&work_t, patch + layout__PATCH_CREEPAGE_X)) = (along_t - v11 * reference_t) / reference;
        (*cspan_at(&work, patch + layout__PATCH_CREEPAGE_X)) = v11;
        v12 = normal_z * lateral - normal_y * vertical;
        v13 = v12 / reference;
        (*cspan_at(&work_t, patch + layout__PATCH_CREEPAGE_Y)) = (normal_z_t * lateral + normal_z * lateral_t - (normal_y_t * vertical + normal_y * vertical_t) - v13 * reference_t) / reference;
        (*cspan_at(&work, patch + layout__PATCH_CREEPAGE_Y)) = v13;
        v14 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y));
        v15 = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z));
        v16 = v14 * normal_y + v15 * normal_z;
        v17 = v16 / reference;
        (*cspan_at(&work_t, patch + layout__PATCH_SPIN)) = (((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Y)))) * normal_y + v14 * normal_y_t + (((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) + (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Z)))) * normal_z + v15 * normal_z_t) - v17 * reference_t) / reference;
        (*cspan_at(&work, patch + layout__PATCH_SPIN)) = v17;
    }
    return INT64_C(0);
}
