/* Generated from tangent_approach.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of approach.py.
 */

#include "tangent_approach.h"

/* Tangent of ``approach_rate``. */
static inline int64_t tangent_approach__approach_rate_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index, int64_t at, double angle, double angle_t)
{
    int64_t rail;
    double y_t;
    double y;
    double z_t;
    double z;
    double v1;
    double lateral_t;
    double lateral;
    double v2;
    double vertical_t;
    double vertical;
    double v3;
    double v4;
    double v5;
    double v6;
    rail = layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * index;
    y_t = (*cspan_at(&work_t, at + layout__PATCH_FORCE_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    y = (*cspan_at(&work, at + layout__PATCH_FORCE_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z_t = (*cspan_at(&work_t, at + layout__PATCH_FORCE_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    z = (*cspan_at(&work, at + layout__PATCH_FORCE_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    v1 = (*cspan_at(&work, at + layout__PATCH_FORCE_Z_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z));
    lateral_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_LATERAL)) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * (*cspan_at(&work, at + layout__PATCH_FORCE_X_TRACK)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * (*cspan_at(&work_t, at + layout__PATCH_FORCE_X_TRACK))) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z_t) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_LATERAL)) + ((*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)) * v1 + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work_t, at + layout__PATCH_FORCE_Z_TRACK)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Z))));
    lateral = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * (*cspan_at(&work, at + layout__PATCH_FORCE_X_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL)) + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * v1;
    v2 = (*cspan_at(&work, at + layout__PATCH_FORCE_Y_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y));
    vertical_t = (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y_t) - ((*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * (*cspan_at(&work, at + layout__PATCH_FORCE_X_TRACK)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * (*cspan_at(&work_t, at + layout__PATCH_FORCE_X_TRACK))) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_VERTICAL)) - ((*cspan_at(&work_t, rail + layout__RAIL_MOTION_ROLL)) * v2 + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work_t, at + layout__PATCH_FORCE_Y_TRACK)) - (*cspan_at(&work_t, rail + layout__RAIL_MOTION_Y))));
    vertical = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * (*cspan_at(&work, at + layout__PATCH_FORCE_X_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * v2;
    v3 = (double)(INT64_C(2) * index - INT64_C(1));
    v4 = sin(angle);
    v5 = v3 * v4;
    v6 = cos(angle);
    (*result_0) = v5 * lateral + v6 * vertical;
    (*result_1) = v3 * (cos(angle) * angle_t) * lateral + v5 * lateral_t + ((-sin(angle)) * angle_t * vertical + v6 * vertical_t);
    return 0;
}
