/* Generated from wheelset/creep_forces.py by tools/transpile_kernel.py; change that one.
 *
 * Creep forces of a wheelset whose contact is solved and whose creepages are known.
 *
 * For each reported patch: its friction and the creepage of each strip, which has its own rolling radius; then
 * the tangential model, and its force and moment on the wheel in the track frame.  On the right y to the field
 * side is the opposite of the creepages' y_c, and the normal x times y that of the normal n from the rail to the
 * wheel; on the left they are the same:
 *
 *     xi' = xi,   eta' = -+ eta,   phi' = -+ phi,   M = -+ M'       (upper sign: right)
 *
 * Normal forces of a body of revolution go through its axle; the torque about the axle is that of the creep
 * forces.
 */

#include "creep_forces.h"

/* 1 if there are creep forces: a model is chosen, and the wheelset rolls. */
static inline int64_t creep_forces__has_creep_forces(array_double_1d tables, array_double_1d work)
{
    int64_t wanted;
    wanted = INT64_C(0);
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) != layout__TANGENTIAL_NONE) && (moving__is_rolling(work) == INT64_C(1)))
    {
        wanted = INT64_C(1);
    }
    return wanted;
}

/* Creep forces of all patches into the outputs, and their part of the resultants. */
static inline int64_t creep_forces__write_creep_forces(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work)
{
    creep_forces__write_side_creep(left_tables, work, INT64_C(0), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_FRICTION)));
    creep_forces__write_side_creep(right_tables, work, INT64_C(1), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_FRICTION)));
    return INT64_C(0);
}

/* Creep forces of the patches of side ``index``, whose coefficient of friction is ``friction``. */
static inline int64_t creep_forces__write_side_creep(array_double_1d tables, array_double_1d work, int64_t index, double friction)
{
    int64_t rolling;
    int64_t side;
    double mirror;
    int64_t number_end;
    int64_t number;
    int64_t patch;
    int64_t to;
    double limit;
    rolling = layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index;
    side = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    mirror = (double)(INT64_C(2) * index - INT64_C(1));
    number_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        patch = rolling + layout__ROLLING_SIDE_PATCHES + layout__ROLLING_PATCH_SIZE * number;
        to = side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * number;
        if (creepage__patch_speed(work, to) > creepage__STANDSTILL)
        {
            creep_forces__open_rolling(work, tables, patch, to, mirror, friction);
            limit = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
            tangential_contact__solve_tangential(work, tables, patch);
            creep_forces__write_creep(work, patch, to, mirror, limit);
            creep_forces__add_creep(work, side, to, mirror);
        }
    }
    creep_forces__write_side_wear(tables, work, index);
    return INT64_C(0);
}

/* Shear and slip over the outline of side ``index``, where that is wanted. */
static inline int64_t creep_forces__write_side_wear(array_double_1d tables, array_double_1d work, int64_t index)
{
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_ALL)
    {
        wear_outline__write_wear(work, outlines__outline_place(tables, work, index), (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))), layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index);
    }
    return INT64_C(0);
}

/* Load, creepages and friction of a patch, from its outputs ``to``. */
static inline int64_t creep_forces__open_rolling(array_double_1d work, array_double_1d tables, int64_t patch, int64_t to, double mirror, double friction)
{
    double rolling_x;
    double rolling_y;
    double rolling_z;
    double speed;
    int64_t index_end;
    int64_t index;
    int64_t strip;
    double y;
    double z;
    double sliding;
    creep_forces__set_load(work, patch, (*cspan_at(&work, to + layout__PATCH_NORMAL_FORCE)));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) = (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) = (-mirror) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) = (-mirror) * (*cspan_at(&work, to + layout__PATCH_SPIN));
    creepage__rolling_velocity(&rolling_x, &rolling_y, &rolling_z, work, (*cspan_at(&work, to + layout__PATCH_X_TRACK)), (*cspan_at(&work, to + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)), (*cspan_at(&work, to + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)), (*cspan_at(&work, to + layout__PATCH_ROLLING_RADIUS)));
    speed = creepage__reference_speed(work, rolling_x);
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED)) = speed;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_BACKWARDS)) = (double)((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) + rolling_x < 0.0);
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_PUBLISHED)) = (double)((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_PUBLISHED_SPIN)) == 1.0);
    index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
        y = (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
        z = (*cspan_at(&work, strip + layout__ROLLING_STRIP_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
        creepage__rolling_velocity(&rolling_x, &rolling_y, &rolling_z, work, (*cspan_at(&work, to + layout__PATCH_X_TRACK)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)), y, z, (*cspan_at(&work, strip + layout__ROLLING_STRIP_ROLLING_RADIUS)));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = creepage__velocity_along(work, y, z, rolling_x) / speed;
    }
    sliding = speed * sqrt((*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) + (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) = friction__patch_friction(tables, friction, (*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)), sliding);
    friction__reduce_slope(work, tables, patch);
    return INT64_C(0);
}

/* Let a patch carry ``load`` [N]: contact damping changes it. */
static inline int64_t creep_forces__set_load(array_double_1d work, int64_t patch, double load)
{
    double factor;
    int64_t index_end;
    int64_t index;
    int64_t strip;
    if ((load != (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD))) && ((*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD)) > 0.0))
    {
        factor = load / (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
        index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
        for (index = INT64_C(0); index < index_end; index += INT64_C(1))
        {
            strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
            (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) *= factor;
        }
        (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD)) = load;
    }
    return INT64_C(0);
}

/* What the tangential model has found into the outputs of a patch, whose creep force is at most ``limit``
 * [N].
 */
static inline int64_t creep_forces__write_creep(array_double_1d work, int64_t patch, int64_t to, double mirror, double limit)
{
    (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X));
    (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y));
    (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT)) = (-mirror) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_MOMENT));
    (*cspan_at(&work, to + layout__PATCH_STICK_SHARE)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_STICK_SHARE));
    (*cspan_at(&work, to + layout__PATCH_MAX_SHEAR)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_MAX_SHEAR));
    if (limit > 0.0)
    {
        (*cspan_at(&work, to + layout__PATCH_SATURATION)) = sqrt((*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y))) / limit;
    }
    (*cspan_at(&work, to + layout__PATCH_FRICTION_POWER)) = (-(*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED))) * ((*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) - mirror * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) + (*cspan_at(&work, to + layout__PATCH_SPIN)) * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT)));
    return INT64_C(0);
}

/* Add the creep force of a patch to its force and to those of its wheel and the wheelset. */
static inline int64_t creep_forces__add_creep(array_double_1d work, int64_t side, int64_t to, double mirror)
{
    double sine;
    double cosine;
    double force_x;
    double force_y;
    double force_z;
    double x;
    double y;
    double z;
    double moment_x;
    double moment_y;
    double moment_z;
    sine = sin((*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)));
    cosine = cos((*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)));
    force_x = (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X));
    force_y = mirror * cosine * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y));
    force_z = (-sine) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y));
    x = (*cspan_at(&work, to + layout__PATCH_X_TRACK));
    y = (*cspan_at(&work, to + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z = (*cspan_at(&work, to + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    moment_x = y * force_z - z * force_y;
    moment_y = z * force_x - x * force_z - mirror * sine * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT));
    moment_z = x * force_y - y * force_x - cosine * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT));
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(0))) += force_x;
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(1))) += force_y;
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(2))) += force_z;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(0))) += force_x;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))) += force_y;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) += force_z;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) += moment_x;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1))) += moment_y;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2))) += moment_z;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(0))) += force_x;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) += force_y;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) += force_z;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) += moment_x;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(1))) += moment_y;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(2))) += moment_z;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) -= moment_x * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) + moment_y * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) + moment_z * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FRICTION_POWER)) += (*cspan_at(&work, to + layout__PATCH_FRICTION_POWER));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_WEAR_NUMBER)) += fabs((*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X))) + fabs((*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)));
    return INT64_C(0);
}
