/* Generated from wheelset/resultant.py by tools/transpile_kernel.py; change that one.
 *
 * The resultant of the contact forces on the wheelset, in the track's axes.
 *
 * The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left,
 * where a region's load acts: the rail's normal there, or the mean over the region where that is known
 * (mean_normal.py).  The moment is that about the wheelset's centre, which is the nominal radius above the
 * running circles.
 *
 * Forces are summed over the parts of patches: a patch that reaches over the bound between two regions has two
 * normals and two points, one for each.  The force of a patch is the sum over its parts, that of a wheel the sum
 * over its patches, and that of the wheelset the sum over both wheels.
 */

#include "resultant.h"

/* No force and no moment. */
static inline int64_t resultant__clear_resultant(array_double_1d work, int64_t resultant)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__RESULTANT_COUNT; i += INT64_C(1))
    {
        (*cspan_at(&work, resultant + i)) = 0.0;
    }
    return INT64_C(0);
}

/* Forces and local penetrations of the solved patches of a side with this ``penetration`` [m], and their
 * resultant about the track's origin; ``mirror`` = 1 on the right, -1 on the left.
 */
static inline int64_t resultant__add_patches(array_double_1d work, array_double_1d tables, double penetration, double mirror, int64_t resultant)
{
    int64_t index_end;
    int64_t index;
    int64_t part;
    int64_t patch;
    int64_t region;
    double local;
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        resultant__clear_force(work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index);
    }
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
        if ((*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) != 0.0)
        {
            patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH)));
            region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_REGION)));
            local = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP));
            if (local > (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)))
            {
                (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = local;
            }
            resultant__add_part_force(work, tables, region, part, patch, mirror, resultant);
        }
    }
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        resultant__finish_force(work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index, mirror);
    }
    return INT64_C(0);
}

/* No force and no penetration yet. */
static inline int64_t resultant__clear_force(array_double_1d work, int64_t patch)
{
    int64_t force;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = 0.0;
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) = 0.0;
    (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) = 0.0;
    return INT64_C(0);
}

/* Add the force of a part of a patch, which lies in the region ``block``, to the patch and to
 * ``resultant``; the patch's centre of load [m] is weighted by the loads, until :func:`finish_force`.
 */
static inline int64_t resultant__add_part_force(array_double_1d work, array_double_1d tables, int64_t block, int64_t part, int64_t patch, double mirror, int64_t resultant)
{
    double load;
    double away;
    double abscissa;
    double height;
    double slope;
    double normal_cos;
    double normal_sin;
    double x;
    double y;
    double z;
    double down;
    double force_y;
    double force_z;
    double moment_x;
    double moment_y;
    double moment_z;
    double wheel_height;
    double wheel_slope;
    int64_t force;
    load = (*cspan_at(&work, part + layout__SOLVED_PART_LOAD));
    /* from the region's smallest gap to the part's centre of load; a part that carries less than nothing */
    /* (patch/filling.py) has no such centre */
    away = 0.0;
    if (load > 0.0)
    {
        away = (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) / load - (*cspan_at(&work, block + layout__REGION_OFFSET)) - (*cspan_at(&work, block + layout__REGION_STATION));
    }
    /* stations of a wheel that just touches are those of its contact plane, all others run along the rail */
    abscissa = (*cspan_at(&work, block + layout__REGION_RAIL)) + away * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        abscissa = arc_length__rail_abscissa(tables, (*cspan_at(&work, block + layout__REGION_RAIL)), away);
    }
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    normal_cos = 1.0 / sqrt(1.0 + slope * slope);
    normal_sin = slope * normal_cos;
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
    {
        normal_cos = (*cspan_at(&work, block + layout__REGION_COS));
        normal_sin = (*cspan_at(&work, block + layout__REGION_SIN));
    }
    x = (*cspan_at(&work, block + layout__REGION_X_TRACK)) + (*cspan_at(&work, block + layout__REGION_SLANT)) * away;
    rails__on_track(&y, &z, work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&tables, layout__TABLES_RAIL_Y)), (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + abscissa, height);
    y = mirror * y;
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_LEANING)) == 1.0)
    {
        down = normal_cos;
        normal_cos = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_COS)) * down - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_SIN)) * normal_sin;
        normal_sin = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_COS)) * normal_sin + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_RAIL_SIN)) * down;
    }
    force_y = mirror * normal_sin * load;
    force_z = (-normal_cos) * load;
    (*cspan_at(&work, resultant + INT64_C(1))) += force_y;
    (*cspan_at(&work, resultant + INT64_C(2))) += force_z;
    moment_x = y * force_z - z * force_y;
    moment_y = (-x) * force_z;
    moment_z = x * force_y;
    (*cspan_at(&work, resultant + INT64_C(3))) += moment_x;
    (*cspan_at(&work, resultant + INT64_C(4))) += moment_y;
    (*cspan_at(&work, resultant + INT64_C(5))) += moment_z;
    profile_table__height_slope(&wheel_height, &wheel_slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, block + layout__REGION_WHEEL)));
    profile_table__height_slope(&wheel_height, &wheel_slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, block + layout__REGION_WHEEL)) + away / sqrt(1.0 + wheel_slope * wheel_slope));
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) += force_y;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) += force_z;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) += moment_x;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) += moment_y;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) += moment_z;
    (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) += load * x;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) += load * y;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) += load * z;
    (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) += load * ((*cspan_at(&tables, layout__TABLES_RADIUS)) + wheel_height);
    return INT64_C(0);
}

/* The centre of load of a patch [m], and the angle of its force [rad]. */
static inline int64_t resultant__finish_force(array_double_1d work, int64_t patch, double mirror)
{
    double load;
    int64_t force;
    load = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
    if (load > 0.0)
    {
        force = patch + layout__SOLVED_PATCH_FORCE;
        (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK)) /= load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK)) /= load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK)) /= load;
        (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS)) /= load;
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = -atan(mirror * (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) / (-(*cspan_at(&work, force + layout__PATCH_FORCE_Z))));
    }
    return INT64_C(0);
}

/* The resultants of both sides and of the wheelset, from ``left`` and ``right``; moments about
 * the wheelset's centre.
 */
static inline int64_t resultant__write_resultant(array_double_1d work, array_double_1d tables, int64_t left, int64_t right)
{
    int64_t i;
    double y;
    double z;
    int64_t index;
    int64_t side;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&work, left + i)) + (*cspan_at(&work, right + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&work, left + (INT64_C(3) + i))) + (*cspan_at(&work, right + (INT64_C(3) + i)));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_FORCE + i)) = (*cspan_at(&work, left + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_MOMENT + i)) = (*cspan_at(&work, left + (INT64_C(3) + i)));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_FORCE + i)) = (*cspan_at(&work, right + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_MOMENT + i)) = (*cspan_at(&work, right + (INT64_C(3) + i)));
    }
    y = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    z = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) - (*cspan_at(&tables, layout__TABLES_HEIGHT));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) -= y * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) - z * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1)));
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        side = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + INT64_C(0))) -= y * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) - z * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + INT64_C(1)));
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_FORCE + i));
            (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MOMENT + i));
        }
    }
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i));
    }
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = 0.0;
    return INT64_C(0);
}
