/* Generated from normal/node_layout.py by tools/transpile_kernel.py; change that one.
 *
 * Where the nodes of regions lie: spacing from the width of the interpenetration, as far as the gap says that
 * strips are loaded.
 */

#include "node_layout.h"

/* Share of the local penetration up to which the gap is laid with nodes on a side with lateral curvature
 * ``side`` [1/m]: strips are loaded while (1 + beta) g is below the local penetration.  With prepared
 * curvatures 1 + beta may fall to 1.
 */
static inline double node_layout__zone_share(array_double_1d tables, double A, double side)
{
    double share;
    if (side < node_coefficients__FLOOR * A)
    {
        side = node_coefficients__FLOOR * A;
    }
    share = node_layout__SPREAD / hertz__table_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(A / side));
    if ((share > node_layout__COVER) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE))
    {
        share = node_layout__COVER;
    }
    return share;
}

/* Spacing of a region's nodes [m]: its half-width over the nodes wanted on it, unless there is no room
 * for so many.
 */
static inline double node_layout__node_spacing(array_double_1d work, array_double_1d tables, int64_t region, double enlarge)
{
    double mean;
    double widest;
    double least;
    double spacing;
    mean = 0.5 * ((*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)));
    widest = (*cspan_at(&work, region + layout__REGION_WIDTH_LOW));
    if ((*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) > widest)
    {
        widest = (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH));
    }
    least = node_layout__NARROWEST * sqrt((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) / (*cspan_at(&work, region + layout__REGION_CURVATURE)));
    if (mean < least)
    {
        mean = least;
    }
    spacing = mean / (int64_t)((*cspan_at(&tables, layout__TABLES_NODES)));
    if (widest * enlarge > node_layout__WIDEST * spacing)
    {
        spacing = widest * enlarge / node_layout__WIDEST;
    }
    return spacing;
}

/* Widths, nodes and coefficients of all regions at their local penetrations times ``enlarge``. */
static inline int64_t node_layout__prepare_regions(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double enlarge)
{
    int64_t i;
    int64_t region;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        planes__enter_plane(work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i, i);
        widths__measure_widths(work, tables, state, region, node_layout__MEASURED * (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)));
        (*cspan_at(&work, region + layout__REGION_SPACING)) = node_layout__node_spacing(work, tables, region, enlarge);
        node_layout__prepare_nodes(work, tables, state, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, enlarge);
        planes__leave_plane(work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i);
    }
    return INT64_C(0);
}

/* Nodes and coefficients of a region whose frame is open, up to its local
 * penetration times ``enlarge``.
 */
static inline int64_t node_layout__prepare_nodes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double enlarge)
{
    int64_t yawed;
    double reach;
    double A;
    double low_reach;
    double high_reach;
    yawed = contact_plane__is_yawed(work);
    reach = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) * enlarge;
    A = 0.5 * (*cspan_at(&work, region + layout__REGION_CURVATURE));
    low_reach = reach * node_layout__zone_share(tables, A, (*cspan_at(&work, region + layout__REGION_SIDE_LOW)));
    high_reach = reach * node_layout__zone_share(tables, A, (*cspan_at(&work, region + layout__REGION_SIDE_HIGH)));
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) && (yawed == INT64_C(1)))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = (*cspan_at(&work, region + layout__REGION_SPACING)) * (double)(nodes__node_stride(tables)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS));
    }
    nodes__lay_nodes(work, tables, state, region, nodes, low_reach, high_reach);
    nodes__bring_nearer(work, region, nodes);
    node_coefficients__weigh_nodes(work, tables, region, nodes, nodes__window_nodes(tables), yawed);
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
    {
        mean_normal__mean_normal(work, tables, region, nodes, (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)));
    }
    (*cspan_at(&work, region + layout__REGION_SQUARE)) = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) / (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + INT64_C(0)));
    return INT64_C(0);
}

/* 1 if no region is loaded at an end of its nodes other than its bound, else 0. */
static inline int64_t node_layout__covered(array_double_1d work, int64_t count)
{
    int64_t i;
    int64_t region;
    double low;
    double high;
    int64_t ends;
    int64_t result;
    result = INT64_C(1);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        low = (*cspan_at(&work, region + layout__REGION_LOW));
        high = (*cspan_at(&work, region + layout__REGION_HIGH));
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            /* a bound that it does not reach is none */
            if (low < (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))))
            {
                low = -regions__BEYOND;
            }
            if (high > (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))))
            {
                high = regions__BEYOND;
            }
        }
        ends = layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i;
        if (((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) > (*cspan_at(&work, ends + layout__NODES_RISE + INT64_C(128) + (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)))))) && (high >= regions__BEYOND))
        {
            result = INT64_C(0);
        }
        if (((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) > (*cspan_at(&work, ends + layout__NODES_RISE + INT64_C(128) + (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))))) && (low <= -regions__BEYOND))
        {
            result = INT64_C(0);
        }
    }
    return result;
}
