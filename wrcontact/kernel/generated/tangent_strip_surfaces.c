/* Generated from tangent_strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_surfaces.py.
 */

#include "tangent_strip_surfaces.h"

/* Tangent of ``node_cell``. */
static inline int64_t tangent_strip_surfaces__node_cell_t(int64_t* k, double* result_1, double* u_t, array_double_1d work, array_double_1d work_t, int64_t strip, int64_t region)
{
    double v1;
    double v2;
    double u;
    v1 = (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)) - (*cspan_at(&work, region + layout__REGION_STATION));
    v2 = v1 / (*cspan_at(&work, region + layout__REGION_SPACING));
    (*u_t) = ((*cspan_at(&work_t, strip + layout__STRIP_STATION)) - (*cspan_at(&work_t, region + layout__REGION_OFFSET)) - (*cspan_at(&work_t, region + layout__REGION_STATION)) - v2 * (*cspan_at(&work_t, region + layout__REGION_SPACING))) / (*cspan_at(&work, region + layout__REGION_SPACING));
    u = v2;
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

/* Tangent of ``read_surfaces``. */
static inline int64_t tangent_strip_surfaces__read_surfaces_t(array_double_1d work, array_double_1d work_t, int64_t strip, int64_t region, int64_t nodes, int64_t k, double x, double x_t)
{
    double v1;
    double v1_t;
    double gap_t;
    double gap;
    double v2;
    double A_t;
    double A;
    tangent_cubic__cubic_through_t(&v1, &v1_t, (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (k - INT64_C(1)))), (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + (k - INT64_C(1)))), (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k)), (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k)), (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (k + INT64_C(1)))), (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + (k + INT64_C(1)))), (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (k + INT64_C(2)))), (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + (k + INT64_C(2)))), x, x_t);
    gap_t = v1_t;
    gap = v1;
    if (gap < 0.0)
    {
        gap_t = 0.0;
        gap = 0.0;
    }
    v2 = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k));
    A_t = (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + k)) + (x_t * v2 + x * ((*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + k))));
    A = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k)) + x * v2;
    (*cspan_at(&work_t, strip + layout__STRIP_GAP)) = (*cspan_at(&work_t, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work, region + layout__REGION_GAP)) + (*cspan_at(&work, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work_t, region + layout__REGION_GAP)) + (gap_t * (*cspan_at(&work, region + layout__REGION_UPRIGHT_B)) + gap * (*cspan_at(&work_t, region + layout__REGION_UPRIGHT_B)));
    (*cspan_at(&work, strip + layout__STRIP_GAP)) = (*cspan_at(&work, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work, region + layout__REGION_GAP)) + gap * (*cspan_at(&work, region + layout__REGION_UPRIGHT_B));
    (*cspan_at(&work_t, strip + layout__STRIP_A)) = A_t * (*cspan_at(&work, region + layout__REGION_UPRIGHT_A)) + A * (*cspan_at(&work_t, region + layout__REGION_UPRIGHT_A));
    (*cspan_at(&work, strip + layout__STRIP_A)) = A * (*cspan_at(&work, region + layout__REGION_UPRIGHT_A));
    (*cspan_at(&work_t, strip + layout__STRIP_CURVATURE)) = 2.0 * A_t;
    (*cspan_at(&work, strip + layout__STRIP_CURVATURE)) = 2.0 * A;
    (*cspan_at(&work_t, strip + layout__STRIP_PENETRATION_SHARE)) = (*cspan_at(&work_t, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) + (*cspan_at(&work, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT));
    (*cspan_at(&work, strip + layout__STRIP_PENETRATION_SHARE)) = (*cspan_at(&work, region + layout__REGION_UPRIGHT_SHARE)) * (*cspan_at(&work, region + layout__REGION_ALIGNMENT));
    return INT64_C(0);
}

/* Tangent of ``incline_strips``. */
static inline int64_t tangent_strip_surfaces__incline_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    int64_t region;
    double v1;
    double v1_t;
    double abscissa_t;
    double abscissa;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v2;
    double v3;
    double v4;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        (*cspan_at(&work_t, strip + layout__STRIP_COS)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work, strip + layout__STRIP_COS)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work_t, strip + layout__STRIP_SIN)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        (*cspan_at(&work, strip + layout__STRIP_SIN)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
        {
            (*cspan_at(&work_t, strip + layout__STRIP_COS)) = (*cspan_at(&work_t, region + layout__REGION_COS));
            (*cspan_at(&work, strip + layout__STRIP_COS)) = (*cspan_at(&work, region + layout__REGION_COS));
            (*cspan_at(&work_t, strip + layout__STRIP_SIN)) = (*cspan_at(&work_t, region + layout__REGION_SIN));
            (*cspan_at(&work, strip + layout__STRIP_SIN)) = (*cspan_at(&work, region + layout__REGION_SIN));
        }
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            tangent_arc_length__rail_abscissa_t(&v1, &v1_t, tables, (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)) - (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - (*cspan_at(&work_t, region + layout__REGION_OFFSET)) - (*cspan_at(&work_t, region + layout__REGION_STATION)));
            abscissa_t = v1_t;
            abscissa = v1;
            tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
            v2 = 1.0 + slope * slope;
            v3 = sqrt(v2);
            v4 = 1.0 / v3;
            (*cspan_at(&work_t, strip + layout__STRIP_COS)) = (-v4) * tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t) / v3;
            (*cspan_at(&work, strip + layout__STRIP_COS)) = v4;
            (*cspan_at(&work_t, strip + layout__STRIP_SIN)) = slope_t * (*cspan_at(&work, strip + layout__STRIP_COS)) + slope * (*cspan_at(&work_t, strip + layout__STRIP_COS));
            (*cspan_at(&work, strip + layout__STRIP_SIN)) = slope * (*cspan_at(&work, strip + layout__STRIP_COS));
        }
    }
    return INT64_C(0);
}

/* Tangent of ``describe_strips``. */
static inline int64_t tangent_strip_surfaces__describe_strips_t(array_double_1d work, array_double_1d work_t)
{
    int64_t count;
    double longest_t;
    double longest;
    int64_t i;
    int64_t strip;
    int64_t region;
    int64_t own;
    int64_t k;
    double x;
    double x_t;
    double v1;
    double line_t;
    double line;
    double v2;
    double length_t;
    double length;
    double v3;
    double level_t;
    double level;
    int64_t loaded;
    double square_t;
    double square;
    double v4;
    double v5;
    double below_t;
    double below;
    double v6;
    double v7;
    double v8;
    double inside_t;
    double inside;
    double v9;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    longest_t = 0.0;
    longest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        own = layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        tangent_strip_surfaces__node_cell_t(&k, &x, &x_t, work, work_t, strip, region);
        tangent_strip_surfaces__read_surfaces_t(work, work_t, strip, region, own, k, x, x_t);
        v1 = (*cspan_at(&work, own + layout__NODES_LINE + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, own + layout__NODES_LINE + INT64_C(128) + k));
        line_t = (*cspan_at(&work_t, own + layout__NODES_LINE + INT64_C(128) + k)) + (x_t * v1 + x * ((*cspan_at(&work_t, own + layout__NODES_LINE + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work_t, own + layout__NODES_LINE + INT64_C(128) + k))));
        line = (*cspan_at(&work, own + layout__NODES_LINE + INT64_C(128) + k)) + x * v1;
        v2 = (*cspan_at(&work, own + layout__NODES_LENGTH + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, own + layout__NODES_LENGTH + INT64_C(128) + k));
        length_t = (*cspan_at(&work_t, own + layout__NODES_LENGTH + INT64_C(128) + k)) + (x_t * v2 + x * ((*cspan_at(&work_t, own + layout__NODES_LENGTH + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work_t, own + layout__NODES_LENGTH + INT64_C(128) + k))));
        length = (*cspan_at(&work, own + layout__NODES_LENGTH + INT64_C(128) + k)) + x * v2;
        v3 = (*cspan_at(&work, own + layout__NODES_RISE + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work, own + layout__NODES_RISE + INT64_C(128) + k));
        level_t = (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) - ((*cspan_at(&work_t, own + layout__NODES_RISE + INT64_C(128) + k)) + (x_t * v3 + x * ((*cspan_at(&work_t, own + layout__NODES_RISE + INT64_C(128) + (k + INT64_C(1)))) - (*cspan_at(&work_t, own + layout__NODES_RISE + INT64_C(128) + k)))));
        level = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) - ((*cspan_at(&work, own + layout__NODES_RISE + INT64_C(128) + k)) + x * v3);
        (*cspan_at(&work_t, strip + layout__STRIP_LOAD_PER_SQUARE)) = line_t * length + line * length_t;
        (*cspan_at(&work, strip + layout__STRIP_LOAD_PER_SQUARE)) = line * length;
        loaded = INT64_C(0);
        square_t = 0.0;
        square = 0.0;
        if (level > 0.0)
        {
            loaded = INT64_C(1);
            v4 = level / length;
            square_t = (level_t - v4 * length_t) / length;
            square = v4;
        }
        v5 = (*cspan_at(&work, strip + layout__STRIP_GAP)) / (*cspan_at(&work, strip + layout__STRIP_PENETRATION_SHARE));
        below_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - ((*cspan_at(&work_t, strip + layout__STRIP_GAP)) - v5 * (*cspan_at(&work_t, strip + layout__STRIP_PENETRATION_SHARE))) / (*cspan_at(&work, strip + layout__STRIP_PENETRATION_SHARE));
        below = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - v5;
        below_t = below_t * (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) + below * (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT));
        below = below * (*cspan_at(&work, region + layout__REGION_ALIGNMENT));
        v6 = strip_surfaces__INSIDE * strip_surfaces__INSIDE;
        v7 = v6 * below;
        v8 = v7 / length;
        inside_t = (v6 * below_t - v8 * length_t) / length;
        inside = v8;
        if (inside > square)
        {
            square_t = inside_t;
            square = inside;
        }
        (*cspan_at(&work_t, strip + layout__STRIP_LOADED)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(loaded);
        v9 = sqrt(square);
        (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = tangent_rates__root_rate(v9, square_t);
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = v9;
        if ((loaded == INT64_C(1)) && ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) > longest))
        {
            longest_t = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH));
            longest = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
        }
    }
    tangent_strip_surfaces__limit_lengths_t(work, work_t, count, longest, longest_t);
    tangent_strip_surfaces__load_one_t(work, work_t, count);
    return INT64_C(0);
}

/* Tangent of ``limit_lengths``. */
static inline int64_t tangent_strip_surfaces__limit_lengths_t(array_double_1d work, array_double_1d work_t, int64_t count, double longest, double longest_t)
{
    int64_t i;
    int64_t strip;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_surfaces__SHORTEST * longest)
        {
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = strip_surfaces__SHORTEST * longest_t;
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_surfaces__SHORTEST * longest;
        }
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_surfaces__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH)))
        {
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = strip_surfaces__SQUARE * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_surfaces__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        }
        (*cspan_at(&work_t, strip + layout__STRIP_LOG_HALF_LENGTH)) = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) / (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
        (*cspan_at(&work, strip + layout__STRIP_LOG_HALF_LENGTH)) = log((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)));
    }
    return INT64_C(0);
}

/* Tangent of ``load_one``. */
static inline int64_t tangent_strip_surfaces__load_one_t(array_double_1d work, array_double_1d work_t, int64_t count)
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
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * smallest + layout__STRIP_LOADED)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * smallest + layout__STRIP_LOADED)) = (double)(1);
    }
    return INT64_C(0);
}
