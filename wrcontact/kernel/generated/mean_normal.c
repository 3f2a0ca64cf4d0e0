/* Generated from normal/mean_normal.py by tools/transpile_kernel.py; change that one.
 *
 * The direction along which the force of a region acts, where that is the mean of the rail's normals.
 */

#include "mean_normal.h"

/* Let the force of a region act along the mean of the rail's normals, weighted by the line load at a
 * local penetration [m].
 *
 * The nodes lie along the rail.
 */
static inline int64_t mean_normal__mean_normal(array_double_1d work, array_double_1d tables, int64_t region, int64_t nodes, double local_penetration)
{
    double arc;
    double total;
    double cosines;
    double sines;
    int64_t direction;
    double x;
    double step;
    int64_t last;
    int64_t k;
    double height;
    double slope;
    double cosine;
    double weight;
    arc = cubic_table__read_cubic(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC))), (*cspan_at(&work, region + layout__REGION_RAIL)));
    total = 0.0;
    cosines = 0.0;
    sines = 0.0;
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        x = (*cspan_at(&work, region + layout__REGION_RAIL));
        step = (double)(direction) * (*cspan_at(&work, region + layout__REGION_SPACING));
        last = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
        if (direction < INT64_C(0))
        {
            last = -(int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
        }
        for (k = INT64_C(0); k < last + INT64_C(1); k += INT64_C(1))
        {
            profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
            cosine = 1.0 / sqrt(1.0 + slope * slope);
            weight = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + direction * k)) * (local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + direction * k)));
            if (weight <= 0.0)
            {
                break;
            }
            if (k == INT64_C(0))
            {
                weight *= 0.5;
            }
            total += weight;
            cosines += weight * cosine;
            sines += weight * slope * cosine;
            x = cubic_table__read_cubic(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_AT_ARC))), arc + step * (double)(k + INT64_C(1)));
        }
    }
    if (total > 0.0)
    {
        (*cspan_at(&work, region + layout__REGION_COS)) = cosines / total;
        (*cspan_at(&work, region + layout__REGION_SIN)) = sines / total;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            (*cspan_at(&work, region + layout__REGION_SHARE)) = rails__upright_share(work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_COS)), (*cspan_at(&work, region + layout__REGION_SIN)));
        }
    }
    return INT64_C(0);
}
