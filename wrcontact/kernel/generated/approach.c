/* Generated from motion/approach.py by tools/transpile_kernel.py; change that one.
 *
 * How fast a wheel and its rail approach each other.
 */

#include "approach.h"

/* Speed [m/s] at which wheel and rail of side ``index`` approach each other along a patch's normal, at
 * its centre of load; ``angle`` [rad] is the normal's, positive towards the flange.
 *
 * Neither the rotation of a round wheel about its axle nor the course of a curve brings them closer.
 */
static inline double approach__approach_rate(array_double_1d work, int64_t index, int64_t at, double angle)
{
    int64_t rail;
    double y;
    double z;
    double lateral;
    double vertical;
    rail = layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * index;
    y = (*cspan_at(&work, at + layout__PATCH_FORCE_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z = (*cspan_at(&work, at + layout__PATCH_FORCE_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    lateral = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) * (*cspan_at(&work, at + layout__PATCH_FORCE_X_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * z - (*cspan_at(&work, rail + layout__RAIL_MOTION_LATERAL)) + (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work, at + layout__PATCH_FORCE_Z_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Z)));
    vertical = (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) + (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) * y - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) * (*cspan_at(&work, at + layout__PATCH_FORCE_X_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_VERTICAL)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_ROLL)) * ((*cspan_at(&work, at + layout__PATCH_FORCE_Y_TRACK)) - (*cspan_at(&work, rail + layout__RAIL_MOTION_Y)));
    return (double)(INT64_C(2) * index - INT64_C(1)) * sin(angle) * lateral + cos(angle) * vertical;
}
