/* Generated from tangent_mean_normal.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of mean_normal.py.
 */

#include "tangent_mean_normal.h"

/* Tangent of ``rail_per_station``. */
static inline int64_t tangent_mean_normal__rail_per_station_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, double abscissa, double abscissa_t)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    double v2;
    double along_t;
    double along;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    along_t = tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t);
    along = v2;
    if (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0))
    {
        along_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + (slope_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) + slope * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
        along = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    }
    (*v3) = 1.0 / along;
    (*result_1) = (-(*v3)) * along_t / along;
    return 0;
}

/* Tangent of ``mean_normal``. */
static inline int64_t tangent_mean_normal__mean_normal_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t nodes, double local_penetration, double local_penetration_t)
{
    double total_t;
    double total;
    double cosines_t;
    double cosines;
    double sines_t;
    double sines;
    int64_t direction;
    double x_t;
    double x;
    double v1;
    double step_t;
    double step;
    int64_t last;
    int64_t k;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v2;
    double v3;
    double v4;
    double cosine_t;
    double cosine;
    double v5;
    double weight_t;
    double weight;
    double v6;
    double v8;
    double v9;
    double v9_t;
    double v7;
    double v7_t;
    double v10;
    double v11;
    total_t = 0.0;
    total = 0.0;
    cosines_t = 0.0;
    cosines = 0.0;
    sines_t = 0.0;
    sines = 0.0;
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        x_t = (*cspan_at(&work_t, region + layout__REGION_RAIL));
        x = (*cspan_at(&work, region + layout__REGION_RAIL));
        v1 = (double)(direction);
        step_t = v1 * (*cspan_at(&work_t, region + layout__REGION_SPACING));
        step = v1 * (*cspan_at(&work, region + layout__REGION_SPACING));
        last = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
        if (direction < INT64_C(0))
        {
            last = -(int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
        }
        for (k = INT64_C(0); k < last + INT64_C(1); k += INT64_C(1))
        {
            tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x, x_t);
            v2 = 1.0 + slope * slope;
            v3 = sqrt(v2);
            v4 = 1.0 / v3;
            cosine_t = (-v4) * tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t) / v3;
            cosine = v4;
            v5 = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + direction * k));
            weight_t = (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * v5 + (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * (local_penetration_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + direction * k)));
            weight = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * v5;
            if (weight <= 0.0)
            {
                break;
            }
            if (k == INT64_C(0))
            {
                weight_t = weight_t * 0.5;
                weight = weight * 0.5;
            }
            total_t = total_t + weight_t;
            total = total + weight;
            cosines_t = cosines_t + (weight_t * cosine + weight * cosine_t);
            cosines = cosines + weight * cosine;
            v6 = weight * slope;
            sines_t = sines_t + ((weight_t * slope + weight * slope_t) * cosine + v6 * cosine_t);
            sines = sines + v6 * cosine;
            v8 = 0.5 * step;
            tangent_mean_normal__rail_per_station_t(&v9, &v9_t, work, work_t, tables, x, x_t);
            tangent_mean_normal__rail_per_station_t(&v7, &v7_t, work, work_t, tables, x + v8 * v9, x_t + (0.5 * step_t * v9 + v8 * v9_t));
            x_t = x_t + (step_t * v7 + step * v7_t);
            x = x + step * v7;
        }
    }
    if (total > 0.0)
    {
        v10 = cosines / total;
        (*cspan_at(&work_t, region + layout__REGION_COS)) = (cosines_t - v10 * total_t) / total;
        (*cspan_at(&work, region + layout__REGION_COS)) = v10;
        v11 = sines / total;
        (*cspan_at(&work_t, region + layout__REGION_SIN)) = (sines_t - v11 * total_t) / total;
        (*cspan_at(&work, region + layout__REGION_SIN)) = v11;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            (*cspan_at(&work_t, region + layout__REGION_SHARE)) = (*cspan_at(&work_t, region + layout__REGION_COS));
            (*cspan_at(&work, region + layout__REGION_SHARE)) = (*cspan_at(&work, region + layout__REGION_COS));
        }
    }
    return INT64_C(0);
}
