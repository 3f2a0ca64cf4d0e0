/* Generated from tangent_resultant.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of resultant.py.
 */

#include "tangent_resultant.h"

/* Tangent of ``clear_resultant``. */
static inline int64_t tangent_resultant__clear_resultant_t(array_double_1d work, array_double_1d work_t, int64_t resultant)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__RESULTANT_COUNT; i += INT64_C(1))
    {
        (*cspan_at(&work_t, resultant + i)) = 0.0;
        (*cspan_at(&work, resultant + i)) = 0.0;
    }
    return INT64_C(0);
}

/* Tangent of ``add_patches``. */
static inline int64_t tangent_resultant__add_patches_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, double penetration, double penetration_t, double mirror, double mirror_t, int64_t resultant)
{
    int64_t index_end;
    int64_t index;
    int64_t part;
    int64_t patch;
    int64_t region;
    double local_t;
    double local;
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        tangent_resultant__clear_force_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index);
    }
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
        if ((*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) != 0.0)
        {
            patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH)));
            region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_REGION)));
            local_t = (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) * penetration + (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration_t - (*cspan_at(&work_t, region + layout__REGION_GAP));
            local = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP));
            if (local > (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)))
            {
                (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = local_t;
                (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = local;
            }
            tangent_resultant__add_part_force_t(work, work_t, tables, region, part, patch, mirror, mirror_t, resultant);
        }
    }
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        tangent_resultant__finish_force_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index, mirror, mirror_t);
    }
    return INT64_C(0);
}

/* Tangent of ``clear_force``. */
static inline int64_t tangent_resultant__clear_force_t(array_double_1d work, array_double_1d work_t, int64_t patch)
{
    int64_t force;
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = 0.0;
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_X)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Y)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Z)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_X_TRACK)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y_TRACK)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z_TRACK)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) = 0.0;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = 0.0;
    return INT64_C(0);
}

/* Tangent of ``add_part_force``. */
static inline int64_t tangent_resultant__add_part_force_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t block, int64_t part, int64_t patch, double mirror, double mirror_t, int64_t resultant)
{
    double load_t;
    double load;
    double away_t;
    double away;
    double v1;
    double abscissa_t;
    double abscissa;
    double v2;
    double v2_t;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v3;
    double v4;
    double v5;
    double normal_cos_t;
    double normal_cos;
    double normal_sin_t;
    double normal_sin;
    double x_t;
    double x;
    double y;
    double y_t;
    double z;
    double z_t;
    double down_t;
    double down;
    int64_t k6;
    int64_t k7;
    int64_t k8;
    int64_t k9;
    double v10;
    double force_y_t;
    double force_y;
    double v11;
    double force_z_t;
    double force_z;
    double moment_x_t;
    double moment_x;
    double v12;
    double moment_y_t;
    double moment_y;
    double moment_z_t;
    double moment_z;
    double wheel_height;
    double wheel_height_t;
    double wheel_slope;
    double wheel_slope_t;
    double v13;
    double v14;
    double v15;
    int64_t force;
    double v16;
    load_t = (*cspan_at(&work_t, part + layout__SOLVED_PART_LOAD));
    load = (*cspan_at(&work, part + layout__SOLVED_PART_LOAD));
    away_t = 0.0;
    away = 0.0;
    if (load > 0.0)
    {
        v1 = (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) / load;
        away_t = ((*cspan_at(&work_t, part + layout__SOLVED_PART_MOMENT)) - v1 * load_t) / load - (*cspan_at(&work_t, block + layout__REGION_OFFSET)) - (*cspan_at(&work_t, block + layout__REGION_STATION));
        away = v1 - (*cspan_at(&work, block + layout__REGION_OFFSET)) - (*cspan_at(&work, block + layout__REGION_STATION));
    }
    abscissa_t = (*cspan_at(&work_t, block + layout__REGION_RAIL)) + (away_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + away * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
    abscissa = (*cspan_at(&work, block + layout__REGION_RAIL)) + away * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        tangent_arc_length__rail_abscissa_t(&v2, &v2_t, tables, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work_t, block + layout__REGION_RAIL)), away, away_t);
        abscissa_t = v2_t;
        abscissa = v2;
    }
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    v3 = 1.0 + slope * slope;
    v4 = sqrt(v3);
    v5 = 1.0 / v4;
    normal_cos_t = (-v5) * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t) / v4;
    normal_cos = v5;
    normal_sin_t = slope_t * normal_cos + slope * normal_cos_t;
    normal_sin = slope * normal_cos;
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
    {
        normal_cos_t = (*cspan_at(&work_t, block + layout__REGION_COS));
        normal_cos = (*cspan_at(&work, block + layout__REGION_COS));
        normal_sin_t = (*cspan_at(&work_t, block + layout__REGION_SIN));
        normal_sin = (*cspan_at(&work, block + layout__REGION_SIN));
    }
    x_t = (*cspan_at(&work_t, block + layout__REGION_X_TRACK)) + ((*cspan_at(&work_t, block + layout__REGION_SLANT)) * away + (*cspan_at(&work, block + layout__REGION_SLANT)) * away_t);
    x = (*cspan_at(&work, block + layout__REGION_X_TRACK)) + (*cspan_at(&work, block + layout__REGION_SLANT)) * away;
    tangent_rails__on_track_t(&y, &y_t, &z, &z_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&tables, layout__TABLES_RAIL_Y)), 0.0, (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + abscissa, abscissa_t, height, height_t);
    y_t = mirror_t * y + mirror * y_t;
    y = mirror * y;
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_LEANING)) == 1.0)
    {
        down_t = normal_cos_t;
        down = normal_cos;
        k6 = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_COS;
        k7 = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_SIN;
        normal_cos_t = (*cspan_at(&work_t, k6)) * down + (*cspan_at(&work, k6)) * down_t - ((*cspan_at(&work_t, k7)) * normal_sin + (*cspan_at(&work, k7)) * normal_sin_t);
        normal_cos = (*cspan_at(&work, k6)) * down - (*cspan_at(&work, k7)) * normal_sin;
        k8 = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_COS;
        k9 = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_SIN;
        normal_sin_t = (*cspan_at(&work_t, k8)) * normal_sin + (*cspan_at(&work, k8)) * normal_sin_t + ((*cspan_at(&work_t, k9)) * down + (*cspan_at(&work, k9)) * down_t);
        normal_sin = (*cspan_at(&work, k8)) * normal_sin + (*cspan_at(&work, k9)) * down;
    }
    v10 = mirror * normal_sin;
    force_y_t = (mirror_t * normal_sin + mirror * normal_sin_t) * load + v10 * load_t;
    force_y = v10 * load;
    v11 = -normal_cos;
    force_z_t = (-normal_cos_t) * load + v11 * load_t;
    force_z = v11 * load;
    (*cspan_at(&work_t, resultant + INT64_C(1))) = (*cspan_at(&work_t, resultant + INT64_C(1))) + force_y_t;
    (*cspan_at(&work, resultant + INT64_C(1))) = (*cspan_at(&work, resultant + INT64_C(1))) + force_y;
    (*cspan_at(&work_t, resultant + INT64_C(2))) = (*cspan_at(&work_t, resultant + INT64_C(2))) + force_z_t;
    (*cspan_at(&work, resultant + INT64_C(2))) = (*cspan_at(&work, resultant + INT64_C(2))) + force_z;
    moment_x_t = y_t * force_z + y * force_z_t - (z_t * force_y + z * force_y_t);
    moment_x = y * force_z - z * force_y;
    v12 = -x;
    moment_y_t = (-x_t) * force_z + v12 * force_z_t;
    moment_y = v12 * force_z;
    moment_z_t = x_t * force_y + x * force_y_t;
    moment_z = x * force_y;
    (*cspan_at(&work_t, resultant + INT64_C(3))) = (*cspan_at(&work_t, resultant + INT64_C(3))) + moment_x_t;
    (*cspan_at(&work, resultant + INT64_C(3))) = (*cspan_at(&work, resultant + INT64_C(3))) + moment_x;
    (*cspan_at(&work_t, resultant + INT64_C(4))) = (*cspan_at(&work_t, resultant + INT64_C(4))) + moment_y_t;
    (*cspan_at(&work, resultant + INT64_C(4))) = (*cspan_at(&work, resultant + INT64_C(4))) + moment_y;
    (*cspan_at(&work_t, resultant + INT64_C(5))) = (*cspan_at(&work_t, resultant + INT64_C(5))) + moment_z_t;
    (*cspan_at(&work, resultant + INT64_C(5))) = (*cspan_at(&work, resultant + INT64_C(5))) + moment_z;
    tangent_profile_table__height_slope_t(&wheel_height, &wheel_height_t, &wheel_slope, &wheel_slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work_t, block + layout__REGION_WHEEL)));
    v13 = 1.0 + wheel_slope * wheel_slope;
    v14 = sqrt(v13);
    v15 = away / v14;
    tangent_profile_table__height_slope_t(&wheel_height, &wheel_height_t, &wheel_slope, &wheel_slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, block + layout__REGION_WHEEL)) + v15, (*cspan_at(&work_t, block + layout__REGION_WHEEL)) + (away_t - v15 * tangent_rates__root_rate(v14, wheel_slope_t * wheel_slope + wheel_slope * wheel_slope_t)) / v14);
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y)) + force_y_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) + force_y;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z)) + force_z_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) + force_z;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_X)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_X)) + moment_x_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) = (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) + moment_x;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Y)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Y)) + moment_y_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) = (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) + moment_y;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Z)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Z)) + moment_z_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) = (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) + moment_z;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_X_TRACK)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_X_TRACK)) + (load_t * x + load * x_t);
    (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) = (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) + load * x;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y_TRACK)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y_TRACK)) + (load_t * y + load * y_t);
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) + load * y;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z_TRACK)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z_TRACK)) + (load_t * z + load * z_t);
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) + load * z;
    v16 = (*cspan_at(&tables, layout__TABLES_RADIUS)) + wheel_height;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_ROLLING_RADIUS)) + (load_t * v16 + load * wheel_height_t);
    (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) + load * v16;
    return INT64_C(0);
}

/* Tangent of ``finish_force``. */
static inline int64_t tangent_resultant__finish_force_t(array_double_1d work, array_double_1d work_t, int64_t patch, double mirror, double mirror_t)
{
    double load_t;
    double load;
    int64_t force;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    load_t = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
    load = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
    if (load > 0.0)
    {
        force = patch + layout__SOLVED_PATCH_FORCE;
        v1 = (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) / load;
        (*cspan_at(&work_t, force + layout__PATCH_FORCE_X_TRACK)) = ((*cspan_at(&work_t, force + layout__PATCH_FORCE_X_TRACK)) - v1 * load_t) / load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) = v1;
        v2 = (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) / load;
        (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y_TRACK)) = ((*cspan_at(&work_t, force + layout__PATCH_FORCE_Y_TRACK)) - v2 * load_t) / load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) = v2;
        v3 = (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) / load;
        (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z_TRACK)) = ((*cspan_at(&work_t, force + layout__PATCH_FORCE_Z_TRACK)) - v3 * load_t) / load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) = v3;
        v4 = (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) / load;
        (*cspan_at(&work_t, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = ((*cspan_at(&work_t, force + layout__PATCH_FORCE_ROLLING_RADIUS)) - v4 * load_t) / load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = v4;
        v5 = mirror * (*cspan_at(&work, force + layout__PATCH_FORCE_Y));
        v6 = -(*cspan_at(&work, force + layout__PATCH_FORCE_Z));
        v7 = v5 / v6;
        (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = -((mirror_t * (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) + mirror * (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y)) - v7 * (-(*cspan_at(&work_t, force + layout__PATCH_FORCE_Z)))) / v6 / (1.0 + v7 * v7));
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = -atan(v7);
    }
    return INT64_C(0);
}

/* Tangent of ``write_resultant``. */
static inline int64_t tangent_resultant__write_resultant_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t left, int64_t right)
{
    int64_t i;
    double y_t;
    double y;
    double z_t;
    double z;
    int64_t index;
    int64_t side;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&work_t, left + i)) + (*cspan_at(&work_t, right + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&work, left + i)) + (*cspan_at(&work, right + i));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&work_t, left + (INT64_C(3) + i))) + (*cspan_at(&work_t, right + (INT64_C(3) + i)));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&work, left + (INT64_C(3) + i))) + (*cspan_at(&work, right + (INT64_C(3) + i)));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_FORCE + i)) = (*cspan_at(&work_t, left + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_FORCE + i)) = (*cspan_at(&work, left + i));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_MOMENT + i)) = (*cspan_at(&work_t, left + (INT64_C(3) + i)));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_MOMENT + i)) = (*cspan_at(&work, left + (INT64_C(3) + i)));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_FORCE + i)) = (*cspan_at(&work_t, right + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_FORCE + i)) = (*cspan_at(&work, right + i));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_MOMENT + i)) = (*cspan_at(&work_t, right + (INT64_C(3) + i)));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_MOMENT + i)) = (*cspan_at(&work, right + (INT64_C(3) + i)));
    }
    y_t = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    y = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    z_t = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT));
    z = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) - (*cspan_at(&tables, layout__TABLES_HEIGHT));
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) - (y_t * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) + y * (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) - (z_t * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) + z * (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1)))));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) - (y * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) - z * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))));
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        side = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
        (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) - (y_t * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) + y * (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) - (z_t * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))) + z * (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1)))));
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) - (y * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) - z * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1))));
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_FORCE + i));
            (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + i));
            (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MOMENT + i));
            (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + i));
        }
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i));
    }
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = 0.0;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = 0.0;
    return INT64_C(0);
}
