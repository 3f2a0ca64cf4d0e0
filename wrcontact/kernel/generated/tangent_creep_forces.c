/* Generated from tangent_creep_forces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of creep_forces.py.
 */

#include "tangent_creep_forces.h"

/* Tangent of ``write_creep_forces``. */
static inline int64_t tangent_creep_forces__write_creep_forces_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t)
{
    tangent_creep_forces__write_side_creep_t(left_tables, work, work_t, INT64_C(0), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_FRICTION)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_FRICTION)));
    tangent_creep_forces__write_side_creep_t(right_tables, work, work_t, INT64_C(1), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_FRICTION)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_FRICTION)));
    return INT64_C(0);
}

/* Tangent of ``write_side_creep``. */
static inline int64_t tangent_creep_forces__write_side_creep_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, double friction, double friction_t)
{
    int64_t rolling;
    int64_t side;
    double mirror;
    int64_t number_end;
    int64_t number;
    int64_t patch;
    int64_t to;
    double limit_t;
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
            tangent_creep_forces__open_rolling_t(work, work_t, tables, patch, to, mirror, 0.0, friction, friction_t);
            limit_t = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_LOAD));
            limit = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
            tangent_tangential_contact__solve_tangential_t(work, work_t, tables, patch);
            tangent_creep_forces__write_creep_t(work, work_t, patch, to, mirror, 0.0, limit, limit_t);
            tangent_creep_forces__add_creep_t(work, work_t, side, to, mirror, 0.0);
        }
    }
    tangent_creep_forces__write_side_wear_t(tables, work, work_t, index);
    return INT64_C(0);
}

/* Tangent of ``write_side_wear``. */
static inline int64_t tangent_creep_forces__write_side_wear_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index)
{
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_ALL)
    {
        tangent_wear_outline__write_wear_t(work, work_t, outlines__outline_place(tables, work, index), (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))), layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index);
    }
    return INT64_C(0);
}

/* Tangent of ``open_rolling``. */
static inline int64_t tangent_creep_forces__open_rolling_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t patch, int64_t to, double mirror, double mirror_t, double friction, double friction_t)
{
    double v1;
    double v2;
    double rolling_x;
    double rolling_x_t;
    double rolling_y;
    double rolling_y_t;
    double rolling_z;
    double rolling_z_t;
    double v3;
    double v3_t;
    double speed_t;
    double speed;
    int64_t index_end;
    int64_t index;
    int64_t strip;
    double y_t;
    double y;
    double z_t;
    double z;
    double v4;
    double v4_t;
    double v5;
    double v6;
    double v7;
    double sliding_t;
    double sliding;
    double v8;
    double v8_t;
    tangent_creep_forces__set_load_t(work, work_t, patch, (*cspan_at(&work, to + layout__PATCH_NORMAL_FORCE)), (*cspan_at(&work_t, to + layout__PATCH_NORMAL_FORCE)));
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_X)) = (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_X));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_X)) = (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X));
    v1 = -mirror;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) = (-mirror_t) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) + v1 * (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_Y));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) = v1 * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y));
    v2 = -mirror;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPIN)) = (-mirror_t) * (*cspan_at(&work, to + layout__PATCH_SPIN)) + v2 * (*cspan_at(&work_t, to + layout__PATCH_SPIN));
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) = v2 * (*cspan_at(&work, to + layout__PATCH_SPIN));
    tangent_creepage__rolling_velocity_t(&rolling_x, &rolling_x_t, &rolling_y, &rolling_y_t, &rolling_z, &rolling_z_t, work, work_t, (*cspan_at(&work, to + layout__PATCH_X_TRACK)), (*cspan_at(&work_t, to + layout__PATCH_X_TRACK)), (*cspan_at(&work, to + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)), (*cspan_at(&work_t, to + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)), (*cspan_at(&work, to + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)), (*cspan_at(&work_t, to + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)), (*cspan_at(&work, to + layout__PATCH_ROLLING_RADIUS)), (*cspan_at(&work_t, to + layout__PATCH_ROLLING_RADIUS)));
    tangent_creepage__reference_speed_t(&v3, &v3_t, work, work_t, rolling_x, rolling_x_t);
    speed_t = v3_t;
    speed = v3;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPEED)) = speed_t;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED)) = speed;
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_BACKWARDS)) = 0.0;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_BACKWARDS)) = (double)((*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) + rolling_x < 0.0);
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_PUBLISHED)) = 0.0;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_PUBLISHED)) = (double)((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_PUBLISHED_SPIN)) == 1.0);
    index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
        y_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
        y = (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
        z_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
        z = (*cspan_at(&work, strip + layout__ROLLING_STRIP_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
        tangent_creepage__rolling_velocity_t(&rolling_x, &rolling_x_t, &rolling_y, &rolling_y_t, &rolling_z, &rolling_z_t, work, work_t, (*cspan_at(&work, to + layout__PATCH_X_TRACK)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)), (*cspan_at(&work_t, to + layout__PATCH_X_TRACK)) + (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)), y, y_t, z, z_t, (*cspan_at(&work, strip + layout__ROLLING_STRIP_ROLLING_RADIUS)), (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_ROLLING_RADIUS)));
        tangent_creepage__velocity_along_t(&v4, &v4_t, work, work_t, y, y_t, z, z_t, rolling_x, rolling_x_t);
        v5 = v4 / speed;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) = (v4_t - v5 * speed_t) / speed;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = v5;
    }
    v6 = (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) + (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y));
    v7 = sqrt(v6);
    sliding_t = speed_t * v7 + speed * tangent_rates__root_rate(v7, (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) + (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_X)) + ((*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) + (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) * (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_Y))));
    sliding = speed * v7;
    tangent_friction__patch_friction_t(&v8, &v8_t, tables, friction, friction_t, (*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)), (*cspan_at(&work_t, to + layout__PATCH_CONTACT_ANGLE)), sliding, sliding_t);
    (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FRICTION)) = v8_t;
    (*cspan_at(&work, patch + layout__ROLLING_PATCH_FRICTION)) = v8;
    tangent_friction__reduce_slope_t(work, work_t, tables, patch);
    return INT64_C(0);
}

/* Tangent of ``set_load``. */
static inline int64_t tangent_creep_forces__set_load_t(array_double_1d work, array_double_1d work_t, int64_t patch, double load, double load_t)
{
    double v1;
    double factor_t;
    double factor;
    int64_t index_end;
    int64_t index;
    int64_t strip;
    if ((load != (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD))) && ((*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD)) > 0.0))
    {
        v1 = load / (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
        factor_t = (load_t - v1 * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_LOAD))) / (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD));
        factor = v1;
        index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
        for (index = INT64_C(0); index < index_end; index += INT64_C(1))
        {
            strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
            (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) * factor + (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) * factor_t;
            (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) * factor;
        }
        (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_LOAD)) = load_t;
        (*cspan_at(&work, patch + layout__ROLLING_PATCH_LOAD)) = load;
    }
    return INT64_C(0);
}

/* Tangent of ``write_creep``. */
static inline int64_t tangent_creep_forces__write_creep_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t to, double mirror, double mirror_t, double limit, double limit_t)
{
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_X)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FORCE_X));
    (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X));
    (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_Y)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FORCE_Y));
    (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y));
    v1 = -mirror;
    (*cspan_at(&work_t, to + layout__PATCH_CREEP_MOMENT)) = (-mirror_t) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_MOMENT)) + v1 * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_MOMENT));
    (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT)) = v1 * (*cspan_at(&work, patch + layout__ROLLING_PATCH_MOMENT));
    (*cspan_at(&work_t, to + layout__PATCH_STICK_SHARE)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_STICK_SHARE));
    (*cspan_at(&work, to + layout__PATCH_STICK_SHARE)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_STICK_SHARE));
    (*cspan_at(&work_t, to + layout__PATCH_MAX_SHEAR)) = (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_MAX_SHEAR));
    (*cspan_at(&work, to + layout__PATCH_MAX_SHEAR)) = (*cspan_at(&work, patch + layout__ROLLING_PATCH_MAX_SHEAR));
    if (limit > 0.0)
    {
        v2 = (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y));
        v3 = sqrt(v2);
        v4 = v3 / limit;
        (*cspan_at(&work_t, to + layout__PATCH_SATURATION)) = (tangent_rates__root_rate(v3, (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FORCE_X)) + ((*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work_t, patch + layout__ROLLING_PATCH_FORCE_Y)))) - v4 * limit_t) / limit;
        (*cspan_at(&work, to + layout__PATCH_SATURATION)) = v4;
    }
    v5 = -(*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED));
    v6 = mirror * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y));
    v7 = (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) - v6 * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) + (*cspan_at(&work, to + layout__PATCH_SPIN)) * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT));
    (*cspan_at(&work_t, to + layout__PATCH_FRICTION_POWER)) = (-(*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPEED))) * v7 + v5 * ((*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) + (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) * (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_X)) - ((mirror_t * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) + mirror * (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_Y))) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) + v6 * (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_Y))) + ((*cspan_at(&work_t, to + layout__PATCH_SPIN)) * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT)) + (*cspan_at(&work, to + layout__PATCH_SPIN)) * (*cspan_at(&work_t, to + layout__PATCH_CREEP_MOMENT))));
    (*cspan_at(&work, to + layout__PATCH_FRICTION_POWER)) = v5 * v7;
    return INT64_C(0);
}

/* Tangent of ``add_creep``. */
static inline int64_t tangent_creep_forces__add_creep_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t to, double mirror, double mirror_t)
{
    double sine_t;
    double sine;
    double cosine_t;
    double cosine;
    double force_x_t;
    double force_x;
    double v1;
    double force_y_t;
    double force_y;
    double v2;
    double force_z_t;
    double force_z;
    double x_t;
    double x;
    double y_t;
    double y;
    double z_t;
    double z;
    double moment_x_t;
    double moment_x;
    double v3;
    double moment_y_t;
    double moment_y;
    double moment_z_t;
    double moment_z;
    double v4;
    double v5;
    sine_t = cos((*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE))) * (*cspan_at(&work_t, to + layout__PATCH_CONTACT_ANGLE));
    sine = sin((*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)));
    cosine_t = (-sin((*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)))) * (*cspan_at(&work_t, to + layout__PATCH_CONTACT_ANGLE));
    cosine = cos((*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)));
    force_x_t = (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_X));
    force_x = (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X));
    v1 = mirror * cosine;
    force_y_t = (mirror_t * cosine + mirror * cosine_t) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) + v1 * (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_Y));
    force_y = v1 * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y));
    v2 = -sine;
    force_z_t = (-sine_t) * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) + v2 * (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_Y));
    force_z = v2 * (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y));
    x_t = (*cspan_at(&work_t, to + layout__PATCH_X_TRACK));
    x = (*cspan_at(&work, to + layout__PATCH_X_TRACK));
    y_t = (*cspan_at(&work_t, to + layout__PATCH_Y_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    y = (*cspan_at(&work, to + layout__PATCH_Y_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y));
    z_t = (*cspan_at(&work_t, to + layout__PATCH_Z_TRACK)) - (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    z = (*cspan_at(&work, to + layout__PATCH_Z_TRACK)) - (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z));
    moment_x_t = y_t * force_z + y * force_z_t - (z_t * force_y + z * force_y_t);
    moment_x = y * force_z - z * force_y;
    v3 = mirror * sine;
    moment_y_t = z_t * force_x + z * force_x_t - (x_t * force_z + x * force_z_t) - ((mirror_t * sine + mirror * sine_t) * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT)) + v3 * (*cspan_at(&work_t, to + layout__PATCH_CREEP_MOMENT)));
    moment_y = z * force_x - x * force_z - v3 * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT));
    moment_z_t = x_t * force_y + x * force_y_t - (y_t * force_x + y * force_x_t) - (cosine_t * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT)) + cosine * (*cspan_at(&work_t, to + layout__PATCH_CREEP_MOMENT)));
    moment_z = x * force_y - y * force_x - cosine * (*cspan_at(&work, to + layout__PATCH_CREEP_MOMENT));
    (*cspan_at(&work_t, to + layout__PATCH_FORCE + INT64_C(0))) = (*cspan_at(&work_t, to + layout__PATCH_FORCE + INT64_C(0))) + force_x_t;
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(0))) = (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(0))) + force_x;
    (*cspan_at(&work_t, to + layout__PATCH_FORCE + INT64_C(1))) = (*cspan_at(&work_t, to + layout__PATCH_FORCE + INT64_C(1))) + force_y_t;
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(1))) = (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(1))) + force_y;
    (*cspan_at(&work_t, to + layout__PATCH_FORCE + INT64_C(2))) = (*cspan_at(&work_t, to + layout__PATCH_FORCE + INT64_C(2))) + force_z_t;
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(2))) = (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(2))) + force_z;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(0))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(0))) + force_x_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(0))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(0))) + force_x;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))) + force_y_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))) + force_y;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) + force_z_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) + force_z;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) + moment_x_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) + moment_x;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1))) + moment_y_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(1))) + moment_y;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2))) + moment_z_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(2))) + moment_z;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(0))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(0))) + force_x_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(0))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(0))) + force_x;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) + force_y_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) + force_y;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) + force_z_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) + force_z;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) + moment_x_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) + moment_x;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(1))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(1))) + moment_y_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(1))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(1))) + moment_y;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(2))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(2))) + moment_z_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(2))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(2))) + moment_z;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) - (moment_x_t * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) + moment_x * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_X)) + (moment_y_t * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) + moment_y * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Y))) + (moment_z_t * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) + moment_z * (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Z))));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) - (moment_x * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) + moment_y * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) + moment_z * (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)));
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FRICTION_POWER)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FRICTION_POWER)) + (*cspan_at(&work_t, to + layout__PATCH_FRICTION_POWER));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FRICTION_POWER)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FRICTION_POWER)) + (*cspan_at(&work, to + layout__PATCH_FRICTION_POWER));
    v4 = (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X));
    v5 = (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y));
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_WEAR_NUMBER)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_WEAR_NUMBER)) + (tangent_rates__size_rate(v4, (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_X)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_X)) + (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_X)) * (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_X))) + tangent_rates__size_rate(v5, (*cspan_at(&work_t, to + layout__PATCH_CREEP_FORCE_Y)) * (*cspan_at(&work, to + layout__PATCH_CREEPAGE_Y)) + (*cspan_at(&work, to + layout__PATCH_CREEP_FORCE_Y)) * (*cspan_at(&work_t, to + layout__PATCH_CREEPAGE_Y))));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_WEAR_NUMBER)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_WEAR_NUMBER)) + (fabs(v4) + fabs(v5));
    return INT64_C(0);
}
