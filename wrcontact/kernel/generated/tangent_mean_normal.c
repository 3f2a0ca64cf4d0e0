/* Generated from tangent_mean_normal.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of mean_normal.py.
 */

#include "tangent_mean_normal.h"

/* Tangent of ``mean_normal``. */
static inline int64_t tangent_mean_normal__mean_normal_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t nodes, double local_penetration, double local_penetration_t)
{
    double v1;
    double v1_t;
    double arc_t;
    double arc;
    double total_t;
    double total;
    double cosines_t;
    double cosines;
    double sines_t;
    double sines;
    int64_t direction;
    double x_t;
    double x;
    double v2;
    double step_t;
    double step;
    int64_t last;
    int64_t k;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v3;
    double v4;
    double v5;
    double cosine_t;
    double cosine;
    double v6;
    double weight_t;
    double weight;
    double v7;
    double v9;
    double v8;
    double v8_t;
    double v10;
    double v11;
    double v12;
    double v12_t;
    tangent_cubic_table__read_cubic_t(&v1, &v1_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC))), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)));
    arc_t = v1_t;
    arc = v1;
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
        v2 = (double)(direction);
        step_t = v2 * (*cspan_at(&work_t, region + layout__REGION_SPACING));
        step = v2 * (*cspan_at(&work, region + layout__REGION_SPACING));
        last = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
        if (direction < INT64_C(0))
        {
            last = -(int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
        }
        for (k = INT64_C(0); k < last + INT64_C(1); k += INT64_C(1))
        {
            tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x, x_t);
            v3 = 1.0 + slope * slope;
            v4 = sqrt(v3);
            v5 = 1.0 / v4;
            cosine_t = (-v5) * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t) / v4;
            cosine = v5;
            v6 = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + direction * k));
            weight_t = (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * v6 + (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * (local_penetration_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + direction * k)));
            weight = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * v6;
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
            v7 = weight * slope;
            sines_t = sines_t + ((weight_t * slope + weight * slope_t) * cosine + v7 * cosine_t);
            sines = sines + v7 * cosine;
            v9 = (double)(k + INT64_C(1));
            tangent_cubic_table__read_cubic_t(&v8, &v8_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_AT_ARC))), arc + step * v9, arc_t + step_t * v9);
            x_t = v8_t;
            x = v8;
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
            tangent_rails__upright_share_t(&v12, &v12_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_COS)), (*cspan_at(&work_t, region + layout__REGION_COS)), (*cspan_at(&work, region + layout__REGION_SIN)), (*cspan_at(&work_t, region + layout__REGION_SIN)));
            (*cspan_at(&work_t, region + layout__REGION_SHARE)) = v12_t;
            (*cspan_at(&work, region + layout__REGION_SHARE)) = v12;
        }
    }
    return INT64_C(0);
}
