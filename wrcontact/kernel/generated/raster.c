/* Generated from search/raster.py by tools/transpile_kernel.py; change that one.
 *
 * The wheel's outline over the rail, at the nodes of the raster and at the ends of the rail.
 */

#include "raster.h"

/* The node at or below ``y`` [m]; the second last one at most. */
static inline int64_t raster__node_below(array_double_1d tables, int64_t scan, double y)
{
    double u;
    int64_t node;
    u = (y - (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_Y))) * (*cspan_at(&tables, scan + layout__SCAN_BINS_PER_METRE));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (int64_t)((*cspan_at(&tables, scan + layout__SCAN_BIN_COUNT))) - 1.0)
    {
        u = (int64_t)((*cspan_at(&tables, scan + layout__SCAN_BIN_COUNT))) - 1.0;
    }
    node = (int64_t)((*cspan_at(&tables, scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_BINS))) + (int64_t)(u))));
    if ((node + INT64_C(2) < (int64_t)((*cspan_at(&tables, scan + layout__SCAN_COUNT)))) && ((*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (node + INT64_C(1)) + layout__SCAN_NODE_Y)) <= y))
    {
        node += INT64_C(1);
    }
    return node;
}

/* Gap [m], slope difference rail - outline [-] and rail abscissa [m] at node ``node``. */
static inline int64_t raster__node_gap(double* result_0, double* result_1, double* abscissa, array_double_1d work, array_double_1d tables, int64_t at, int64_t node)
{
    int64_t point;
    double y_track;
    double z_track;
    double outline_slope;
    double height;
    double rail_slope;
    point = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node;
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, (*cspan_at(&tables, point + layout__SCAN_NODE_Y)), (*cspan_at(&tables, point + layout__SCAN_NODE_HEIGHT)), (*cspan_at(&tables, point + layout__SCAN_NODE_SLOPE)));
    (*abscissa) = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope(&height, &rail_slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*abscissa));
    (*result_0) = height - z_track;
    (*result_1) = rail_slope - outline_slope;
    return 0;
}

/* Abscissa on the rail [m] below wheel abscissa ``y`` [m]. */
static inline double raster__rail_below(array_double_1d work, array_double_1d tables, int64_t at, double y)
{
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double result;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, y, z, slope);
    result = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    return result;
}

/* 1 if the outline, beside the rail at node ``node``, does not come back above it further
 * in ``direction``, else 0.
 *
 * Yaw moves a place of the wheel sideways by about sin^2(yaw) r times its slope, so that a steep flank can
 * reach over a rail that ends below the flange root.
 */
static inline int64_t raster__leaves_rail(array_double_1d work, array_double_1d tables, int64_t at, int64_t node, int64_t direction, double abscissa)
{
    int64_t scan;
    int64_t rail;
    double apart;
    double reach;
    double sine;
    double steep;
    int64_t leaves;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    apart = abscissa - (*cspan_at(&tables, rail + layout__PROFILE_STOP));
    if (direction < INT64_C(0))
    {
        apart = (*cspan_at(&tables, rail + layout__PROFILE_START)) - abscissa;
    }
    reach = 0.0;
    if ((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0)
    {
        sine = (*cspan_at(&work, at + layout__PLACE_SIN_YAW));
        steep = (*cspan_at(&tables, scan + layout__SCAN_STEEPEST)) + (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_SLOPE));
        reach = raster__REACH_SHARE * sine * sine * (*cspan_at(&work, at + layout__PLACE_RADIUS)) * steep + raster__REACH_ROLL * fabs((*cspan_at(&work, at + layout__PLACE_SIN_ROLL)));
    }
    leaves = INT64_C(0);
    if (apart > reach)
    {
        leaves = INT64_C(1);
    }
    return leaves;
}

/* Wheel abscissa [m] above the end of the rail, which lies between node ``node``, above the rail, and the
 * next one ``outward`` (1 or -1).
 */
static inline double raster__above_rail_end(array_double_1d work, array_double_1d tables, int64_t at, int64_t node, int64_t outward)
{
    double outside;
    double middle;
    double inside;
    inside = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y));
    outside = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (node + outward) + layout__SCAN_NODE_Y));
    while(fabs(outside - inside) > raster__END_SHARP)
    {
        middle = 0.5 * (inside + outside);
        if (gap__above_rail(tables, raster__rail_below(work, tables, at, middle)) == INT64_C(1))
        {
            inside = middle;
        }
        else
        {
            outside = middle;
        }
    }
    return inside;
}
