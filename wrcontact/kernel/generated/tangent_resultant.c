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

/* Tangent of ``add_region``. */
static inline int64_t tangent_resultant__add_region_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region, double mirror, double mirror_t, int64_t resultant)
{
    int64_t block;
    double load_t;
    double load;
    double cosine_t;
    double cosine;
    double v1;
    double v2;
    double v3;
    double v4;
    double away_t;
    double away;
    double abscissa_t;
    double abscissa;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v5;
    double v6;
    double v7;
    double normal_cos_t;
    double normal_cos;
    double normal_sin_t;
    double normal_sin;
    double x_t;
    double x;
    double v8;
    double y_t;
    double y;
    double z_t;
    double z;
    double v9;
    double force_y_t;
    double force_y;
    double v10;
    double force_z_t;
    double force_z;
    block = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * region;
    load_t = (*cspan_at(&work_t, block + layout__REGION_CARRIED));
    load = (*cspan_at(&work, block + layout__REGION_CARRIED));
    if (load > 0.0)
    {
        cosine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((*cspan_at(&work, block + layout__REGION_OWN)) == 1.0))
        {
            v1 = 1.0 + (*cspan_at(&work, block + layout__REGION_INCLINATION)) * (*cspan_at(&work, block + layout__REGION_INCLINATION));
            v2 = sqrt(v1);
            v3 = 1.0 / v2;
            cosine_t = (-v3) * tangent_rates__root_rate(v2, (*cspan_at(&work_t, block + layout__REGION_INCLINATION)) * (*cspan_at(&work, block + layout__REGION_INCLINATION)) + (*cspan_at(&work, block + layout__REGION_INCLINATION)) * (*cspan_at(&work_t, block + layout__REGION_INCLINATION))) / v2;
            cosine = v3;
        }
        v4 = (*cspan_at(&work, block + layout__REGION_MOMENT)) / load;
        away_t = ((*cspan_at(&work_t, block + layout__REGION_MOMENT)) - v4 * load_t) / load - (*cspan_at(&work_t, block + layout__REGION_OFFSET)) - (*cspan_at(&work_t, block + layout__REGION_STATION));
        away = v4 - (*cspan_at(&work, block + layout__REGION_OFFSET)) - (*cspan_at(&work, block + layout__REGION_STATION));
        abscissa_t = (*cspan_at(&work_t, block + layout__REGION_RAIL)) + (away_t * cosine + away * cosine_t);
        abscissa = (*cspan_at(&work, block + layout__REGION_RAIL)) + away * cosine;
        tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
        v5 = 1.0 + slope * slope;
        v6 = sqrt(v5);
        v7 = 1.0 / v6;
        normal_cos_t = (-v7) * tangent_rates__root_rate(v6, slope_t * slope + slope * slope_t) / v6;
        normal_cos = v7;
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
        v8 = (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + abscissa;
        y_t = mirror_t * v8 + mirror * abscissa_t;
        y = mirror * v8;
        z_t = height_t;
        z = height;
        v9 = mirror * normal_sin;
        force_y_t = (mirror_t * normal_sin + mirror * normal_sin_t) * load + v9 * load_t;
        force_y = v9 * load;
        v10 = -normal_cos;
        force_z_t = (-normal_cos_t) * load + v10 * load_t;
        force_z = v10 * load;
        (*cspan_at(&work_t, resultant + INT64_C(1))) = (*cspan_at(&work_t, resultant + INT64_C(1))) + force_y_t;
        (*cspan_at(&work, resultant + INT64_C(1))) = (*cspan_at(&work, resultant + INT64_C(1))) + force_y;
        (*cspan_at(&work_t, resultant + INT64_C(2))) = (*cspan_at(&work_t, resultant + INT64_C(2))) + force_z_t;
        (*cspan_at(&work, resultant + INT64_C(2))) = (*cspan_at(&work, resultant + INT64_C(2))) + force_z;
        (*cspan_at(&work_t, resultant + INT64_C(3))) = (*cspan_at(&work_t, resultant + INT64_C(3))) + (y_t * force_z + y * force_z_t - (z_t * force_y + z * force_y_t));
        (*cspan_at(&work, resultant + INT64_C(3))) = (*cspan_at(&work, resultant + INT64_C(3))) + (y * force_z - z * force_y);
        (*cspan_at(&work_t, resultant + INT64_C(4))) = (*cspan_at(&work_t, resultant + INT64_C(4))) - (x_t * force_z + x * force_z_t);
        (*cspan_at(&work, resultant + INT64_C(4))) = (*cspan_at(&work, resultant + INT64_C(4))) - x * force_z;
        (*cspan_at(&work_t, resultant + INT64_C(5))) = (*cspan_at(&work_t, resultant + INT64_C(5))) + (x_t * force_y + x * force_y_t);
        (*cspan_at(&work, resultant + INT64_C(5))) = (*cspan_at(&work, resultant + INT64_C(5))) + x * force_y;
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
    for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&work_t, left + i)) + (*cspan_at(&work_t, right + i));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&work, left + i)) + (*cspan_at(&work, right + i));
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&work_t, left + (INT64_C(3) + i))) + (*cspan_at(&work_t, right + (INT64_C(3) + i)));
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&work, left + (INT64_C(3) + i))) + (*cspan_at(&work, right + (INT64_C(3) + i)));
    }
    y_t = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    y = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    z_t = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT));
    z = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) - (*cspan_at(&tables, layout__TABLES_RADIUS));
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) - (y_t * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) + y * (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) - (z_t * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))) + z * (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1)))));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + INT64_C(0))) - (y * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(2))) - z * (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + INT64_C(1))));
    return INT64_C(0);
}
