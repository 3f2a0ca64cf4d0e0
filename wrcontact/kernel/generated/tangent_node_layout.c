/* Generated from tangent_node_layout.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of node_layout.py.
 */

#include "tangent_node_layout.h"

/* Tangent of ``zone_share``. */
static inline int64_t tangent_node_layout__zone_share_t(double* share, double* share_t, array_double_1d tables, double A, double A_t, double side, double side_t)
{
    double v2;
    double v1;
    double v1_t;
    double v3;
    if (side < node_coefficients__FLOOR * A)
    {
        side_t = node_coefficients__FLOOR * A_t;
        side = node_coefficients__FLOOR * A;
    }
    v2 = A / side;
    tangent_hertz__table_value_t(&v1, &v1_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(v2), (A_t - v2 * side_t) / side / v2);
    v3 = node_layout__SPREAD / v1;
    (*share_t) = (-v3) * v1_t / v1;
    (*share) = v3;
    if (((*share) > node_layout__COVER) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE))
    {
        (*share_t) = 0.0;
        (*share) = node_layout__COVER;
    }
    return 0;
}

/* Tangent of ``node_spacing``. */
static inline int64_t tangent_node_layout__node_spacing_t(double* spacing, double* spacing_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double enlarge, double enlarge_t)
{
    double v1;
    double mean_t;
    double mean;
    double widest_t;
    double widest;
    double v2;
    double v3;
    double least_t;
    double least;
    int64_t v4;
    double v5;
    v1 = (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH));
    mean_t = 0.5 * ((*cspan_at(&work_t, region + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work_t, region + layout__REGION_WIDTH_HIGH)));
    mean = 0.5 * v1;
    widest_t = (*cspan_at(&work_t, region + layout__REGION_WIDTH_LOW));
    widest = (*cspan_at(&work, region + layout__REGION_WIDTH_LOW));
    if ((*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) > widest)
    {
        widest_t = (*cspan_at(&work_t, region + layout__REGION_WIDTH_HIGH));
        widest = (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH));
    }
    v2 = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) / (*cspan_at(&work, region + layout__REGION_CURVATURE));
    v3 = sqrt(v2);
    least_t = node_layout__NARROWEST * tangent_rates__root_rate(v3, ((*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) - v2 * (*cspan_at(&work_t, region + layout__REGION_CURVATURE))) / (*cspan_at(&work, region + layout__REGION_CURVATURE)));
    least = node_layout__NARROWEST * v3;
    if (mean < least)
    {
        mean_t = least_t;
        mean = least;
    }
    v4 = (int64_t)((*cspan_at(&tables, layout__TABLES_NODES)));
    (*spacing_t) = mean_t / v4;
    (*spacing) = mean / v4;
    if (widest * enlarge > node_layout__WIDEST * (*spacing))
    {
        v5 = widest * enlarge;
        (*spacing_t) = (widest_t * enlarge + widest * enlarge_t) / node_layout__WIDEST;
        (*spacing) = v5 / node_layout__WIDEST;
    }
    return 0;
}

/* Tangent of ``prepare_regions``. */
static inline int64_t tangent_node_layout__prepare_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double enlarge, double enlarge_t)
{
    int64_t i;
    int64_t region;
    double v1;
    double v1_t;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        tangent_planes__enter_plane_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i, i);
        tangent_widths__measure_widths_t(work, work_t, tables, state, region, node_layout__MEASURED * (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)), node_layout__MEASURED * (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)));
        tangent_node_layout__node_spacing_t(&v1, &v1_t, work, work_t, tables, region, enlarge, enlarge_t);
        (*cspan_at(&work_t, region + layout__REGION_SPACING)) = v1_t;
        (*cspan_at(&work, region + layout__REGION_SPACING)) = v1;
        tangent_node_layout__prepare_nodes_t(work, work_t, tables, state, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, enlarge, enlarge_t);
        tangent_planes__leave_plane_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i);
    }
    return INT64_C(0);
}

/* Tangent of ``prepare_nodes``. */
static inline int64_t tangent_node_layout__prepare_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double enlarge, double enlarge_t)
{
    int64_t yawed;
    double reach_t;
    double reach;
    double A_t;
    double A;
    double v1;
    double v1_t;
    double low_reach_t;
    double low_reach;
    double v2;
    double v2_t;
    double high_reach_t;
    double high_reach;
    double v3;
    double v4;
    double v5;
    yawed = contact_plane__is_yawed(work);
    reach_t = (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) * enlarge + (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) * enlarge_t;
    reach = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) * enlarge;
    A_t = 0.5 * (*cspan_at(&work_t, region + layout__REGION_CURVATURE));
    A = 0.5 * (*cspan_at(&work, region + layout__REGION_CURVATURE));
    tangent_node_layout__zone_share_t(&v1, &v1_t, tables, A, A_t, (*cspan_at(&work, region + layout__REGION_SIDE_LOW)), (*cspan_at(&work_t, region + layout__REGION_SIDE_LOW)));
    low_reach_t = reach_t * v1 + reach * v1_t;
    low_reach = reach * v1;
    tangent_node_layout__zone_share_t(&v2, &v2_t, tables, A, A_t, (*cspan_at(&work, region + layout__REGION_SIDE_HIGH)), (*cspan_at(&work_t, region + layout__REGION_SIDE_HIGH)));
    high_reach_t = reach_t * v2 + reach * v2_t;
    high_reach = reach * v2;
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) && (yawed == INT64_C(1)))
    {
        v3 = (double)(nodes__node_stride(tables));
        v4 = (*cspan_at(&work, region + layout__REGION_SPACING)) * v3;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = (*cspan_at(&work_t, region + layout__REGION_SPACING)) * v3 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS)) + v4 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = v4 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS));
    }
    tangent_nodes__lay_nodes_t(work, work_t, tables, state, region, nodes, low_reach, low_reach_t, high_reach, high_reach_t);
    tangent_nodes__bring_nearer_t(work, work_t, region, nodes);
    tangent_node_coefficients__weigh_nodes_t(work, work_t, tables, region, nodes, nodes__window_nodes(tables), yawed);
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
    {
        tangent_mean_normal__mean_normal_t(work, work_t, tables, region, nodes, (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)), (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)));
    }
    v5 = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) / (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + INT64_C(0)));
    (*cspan_at(&work_t, region + layout__REGION_SQUARE)) = ((*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) - v5 * (*cspan_at(&work_t, nodes + layout__NODES_LENGTH + INT64_C(128) + INT64_C(0)))) / (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + INT64_C(0)));
    (*cspan_at(&work, region + layout__REGION_SQUARE)) = v5;
    return INT64_C(0);
}
