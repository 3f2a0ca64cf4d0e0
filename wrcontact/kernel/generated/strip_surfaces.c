/* Generated from normal/strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * What the surfaces are at each strip: gap, curvature, and ANALYN's half-length and coefficients, read from
 * the region's nodes.
 */

#include "strip_surfaces.h"

/* The node before the middle of a strip, and the share of the way from there to the next node. */
static inline int64_t strip_surfaces__node_cell(int64_t* k, double* result_1, array_double_1d work, int64_t strip, int64_t region)
{
    double u;
    u = ((*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)) - (*cspan_at(&work, region + layout__REGION_STATION))) / (*cspan_at(&work, region + layout__REGION_SPACING));
    (*k) = (int64_t)(u + (double)(layout__NODE_MIDDLE)) - layout__NODE_MIDDLE;
    if ((*k) > (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) - INT64_C(1))
    {
        (*k) = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) - INT64_C(1);
    }
    if ((*k) < (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))))
    {
        (*k) = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
    }
    (*result_1) = u - (double)((*k));
    return 0;
}

/* Gap and curvature of a strip at the share ``x`` of the way from node ``k`` to the next one.
 *
 * Under yaw the patch is tilted; the strips are those of the upright ellipse with the same half-length,
 * half-width and pressure (hertz.upright_coefficients).
 */
static inline int64_t strip_surfaces__read_surfaces(array_double_1d work, int64_t strip, int64_t region, int64_t nodes, int64_t k, double x)
{
    double gap;
    double A;
    gap = cubic__cubic_through((*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (k - INT64_C(1)))), (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k)), (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (k + INT64_C(1)))), (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (k + INT64_C(2)))), x);
    if (gap < 0.0)
    {
        /* next to a sudden rise the cubic falls below the region's smallest gap */
        gap = 0.0;
    }
    A = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k)) + x * ((*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k)));
    (*cspan_at(&work, strip + layout__STRIP_GAP)) = (*cspan_at(&work, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work, region + layout__REGION_GAP)) + gap * (*cspan_at(&work, region + layout__REGION_UPRIGHT_B));
    (*cspan_at(&work, strip + layout__STRIP_A)) = A * (*cspan_at(&work, region + layout__REGION_UPRIGHT_A));
    (*cspan_at(&work, strip + layout__STRIP_CURVATURE)) = 2.0 * A;
    (*cspan_at(&work, strip + layout__STRIP_PENETRATION_SHARE)) = (*cspan_at(&work, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work, region + layout__REGION_ALIGNMENT));
    return INT64_C(0);
}

/* Inclination of the rail at every strip of a pressed wheel; of another one, that of its plane. */
static inline int64_t strip_surfaces__incline_strips(array_double_1d work, array_double_1d tables)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    int64_t region;
    double abscissa;
    double height;
    double slope;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        (*cspan_at(&work, strip + layout__STRIP_COS)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work, strip + layout__STRIP_SIN)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
        {
            (*cspan_at(&work, strip + layout__STRIP_COS)) = (*cspan_at(&work, region + layout__REGION_COS));
            (*cspan_at(&work, strip + layout__STRIP_SIN)) = (*cspan_at(&work, region + layout__REGION_SIN));
        }
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            abscissa = arc_length__rail_abscissa(tables, (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)) - (*cspan_at(&work, region + layout__REGION_STATION)));
            profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
            (*cspan_at(&work, strip + layout__STRIP_COS)) = 1.0 / sqrt(1.0 + slope * slope);
            (*cspan_at(&work, strip + layout__STRIP_SIN)) = slope * (*cspan_at(&work, strip + layout__STRIP_COS));
        }
    }
    return INT64_C(0);
}

/* Gap, curvature, and ANALYN's half-length and load of every placed strip. */
static inline int64_t strip_surfaces__describe_strips(array_double_1d work)
{
    int64_t count;
    double longest;
    int64_t i;
    int64_t strip;
    int64_t region;
    int64_t own;
    int64_t k;
    double x;
    double line;
    double length;
    double level;
    int64_t loaded;
    double square;
    double below;
    double inside;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    longest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        own = layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        strip_surfaces__node_cell(&k, &x, work, strip, region);
        strip_surfaces__read_surfaces(work, strip, region, own, k, x);
        line = (*cspan_at(&work, own + layout__NODES_LINE + INT64_C(128) + k)) + x * ((*cspan_at(&work, own + layout__NODES_LINE + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, own + layout__NODES_LINE + INT64_C(128) + k)));
        length = (*cspan_at(&work, own + layout__NODES_LENGTH + INT64_C(128) + k)) + x * ((*cspan_at(&work, own + layout__NODES_LENGTH + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, own + layout__NODES_LENGTH + INT64_C(128) + k)));
        level = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) - ((*cspan_at(&work, own + layout__NODES_RISE + INT64_C(128) + k)) + x * ((*cspan_at(&work, own + layout__NODES_RISE + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, own + layout__NODES_RISE + INT64_C(128) + k))));
        (*cspan_at(&work, strip + layout__STRIP_LOAD_PER_SQUARE)) = line * length;
        loaded = INT64_C(0);
        square = 0.0;
        if (level > 0.0)
        {
            loaded = INT64_C(1);
            square = level / length;
        }
        below = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work, strip + layout__STRIP_GAP)) / (*cspan_at(&work, strip + layout__STRIP_PENETRATION_SHARE));
        below *= (*cspan_at(&work, region + layout__REGION_ALIGNMENT));
        inside = strip_surfaces__INSIDE * strip_surfaces__INSIDE * below / length;
        if (inside > square)
        {
            square = inside;
        }
        (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(loaded);
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = sqrt(square);
        if ((loaded == INT64_C(1)) && ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) > longest))
        {
            longest = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
        }
    }
    strip_surfaces__limit_lengths(work, count, longest);
    strip_surfaces__load_one(work, count);
    return INT64_C(0);
}

/* Raise half-lengths to their smallest, eq. (S9), where the longest of a loaded strip is ``longest`` [m];
 * their logarithms.
 */
static inline int64_t strip_surfaces__limit_lengths(array_double_1d work, int64_t count, double longest)
{
    int64_t i;
    int64_t strip;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_surfaces__SHORTEST * longest)
        {
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_surfaces__SHORTEST * longest;
        }
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_surfaces__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH)))
        {
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_surfaces__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        }
        (*cspan_at(&work, strip + layout__STRIP_LOG_HALF_LENGTH)) = log((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)));
    }
    return INT64_C(0);
}

/* Load the strip with the smallest gap if ANALYN loads none. */
static inline int64_t strip_surfaces__load_one(array_double_1d work, int64_t count)
{
    int64_t smallest;
    int64_t found;
    int64_t i;
    smallest = INT64_C(0);
    found = INT64_C(0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LOADED)) == 1.0)
        {
            found = INT64_C(1);
        }
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_GAP)) < (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * smallest + layout__STRIP_GAP)))
        {
            smallest = i;
        }
    }
    if (found == INT64_C(0))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * smallest + layout__STRIP_LOADED)) = (double)(1);
    }
    return INT64_C(0);
}
