/* Generated from wheelset/resultant.py by tools/transpile_kernel.py; change that one.
 *
 * The resultant of the contact forces on the wheelset, in the track's axes.
 *
 * The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left,
 * where a region's load acts: the rail's normal there, or the mean over the region where that is known
 * (mean_normal.py).  The moment is that about the wheelset's centre, which is the nominal radius above the
 * running circles.
 *
 * Forces are summed over regions and not over patches: a patch that reaches over the bound between two regions
 * has two normals and two points, one for each.  Load and moment of a region are those that its strips carry in
 * the solved patches.
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

/* Add the force of a region and its moment about the track's origin to ``resultant``; ``mirror`` = 1 on
 * the right, -1 on the left.
 */
static inline int64_t resultant__add_region(array_double_1d tables, array_double_1d work, int64_t region, double mirror, int64_t resultant)
{
    int64_t block;
    double load;
    double cosine;
    double away;
    double abscissa;
    double height;
    double slope;
    double normal_cos;
    double normal_sin;
    double x;
    double y;
    double z;
    double force_y;
    double force_z;
    block = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * region;
    load = (*cspan_at(&work, block + layout__REGION_CARRIED));
    if (load > 0.0)
    {
        /* of the region's plane */
        cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((*cspan_at(&work, block + layout__REGION_OWN)) == 1.0))
        {
            cosine = 1.0 / sqrt(1.0 + (*cspan_at(&work, block + layout__REGION_INCLINATION)) * (*cspan_at(&work, block + layout__REGION_INCLINATION)));
        }
        /* from the region's smallest gap to its centre of load, along its plane */
        away = (*cspan_at(&work, block + layout__REGION_MOMENT)) / load - (*cspan_at(&work, block + layout__REGION_OFFSET)) - (*cspan_at(&work, block + layout__REGION_STATION));
        abscissa = (*cspan_at(&work, block + layout__REGION_RAIL)) + away * cosine;
        profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
        normal_cos = 1.0 / sqrt(1.0 + slope * slope);
        normal_sin = slope * normal_cos;
        if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
        {
            normal_cos = (*cspan_at(&work, block + layout__REGION_COS));
            normal_sin = (*cspan_at(&work, block + layout__REGION_SIN));
        }
        x = (*cspan_at(&work, block + layout__REGION_X_TRACK)) + (*cspan_at(&work, block + layout__REGION_SLANT)) * away;
        y = mirror * ((*cspan_at(&tables, layout__TABLES_RAIL_Y)) + abscissa);
        z = height;
        force_y = mirror * normal_sin * load;
        force_z = (-normal_cos) * load;
        (*cspan_at(&work, resultant + INT64_C(1))) += force_y;
        (*cspan_at(&work, resultant + INT64_C(2))) += force_z;
        (*cspan_at(&work, resultant + INT64_C(3))) += y * force_z - z * force_y;
        (*cspan_at(&work, resultant + INT64_C(4))) -= x * force_z;
        (*cspan_at(&work, resultant + INT64_C(5))) += x * force_y;
    }
    return INT64_C(0);
}

/* The resultant of both sides, from ``left`` and ``right``, its moment about the wheelset's centre. */
static inline int64_t resultant__write_resultant(array_double_1d work, array_double_1d tables, int64_t left, int64_t right)
{
    int64_t i;
    double y;
    double z;
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&work, left + i)) + (*cspan_at(&work, right + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&work, left + (INT64_C(3) + i))) + (*cspan_at(&work, right + (INT64_C(3) + i)));
    }
    y = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    z = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) - (*cspan_at(&tables, layout__TABLES_RADIUS));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) -= y * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) - z * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1)));
    return INT64_C(0);
}
