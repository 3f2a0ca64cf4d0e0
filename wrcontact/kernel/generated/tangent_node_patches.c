/* Generated from tangent_node_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of node_patches.py.
 */

#include "tangent_node_patches.h"

/* Tangent of ``fill_from_nodes``. */
static inline int64_t tangent_node_patches__fill_from_nodes_t(array_double_1d work, array_double_1d work_t, int64_t count)
{
    int64_t strips;
    int64_t index;
    int64_t region;
    double angle_t;
    double angle;
    int64_t k_end;
    int64_t k;
    tangent_filling__clear_patches_t(work, work_t);
    strips = INT64_C(0);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        (*cspan_at(&work_t, region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work_t, region + layout__REGION_MOMENT)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_MOMENT)) = 0.0;
        if ((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) > 0.0)
        {
            (*cspan_at(&work_t, region + layout__REGION_STRIP)) = 0.0;
            (*cspan_at(&work, region + layout__REGION_STRIP)) = (double)(strips - (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))));
            tangent_node_patches__fill_strips_t(work, work_t, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * index);
            strips = strips + ((int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) - (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))) + INT64_C(1));
            angle_t = -((*cspan_at(&work_t, region + layout__REGION_INCLINATION)) / (1.0 + (*cspan_at(&work, region + layout__REGION_INCLINATION)) * (*cspan_at(&work, region + layout__REGION_INCLINATION))));
            angle = -atan((*cspan_at(&work, region + layout__REGION_INCLINATION)));
            k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
            for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
            {
                tangent_node_patches__add_cell_t(work, work_t, region, index, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * index, k, angle, angle_t);
            }
        }
    }
    tangent_filling__finish_patch_t(work, work_t);
    tangent_filling__finish_patches_t(work, work_t);
    return INT64_C(0);
}

/* Tangent of ``fill_strips``. */
static inline int64_t tangent_node_patches__fill_strips_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes)
{
    double deepest_t;
    double deepest;
    int64_t middle;
    double spacing_t;
    double spacing;
    double origin_t;
    double origin;
    double along_t;
    double along;
    double slant_t;
    double slant;
    int64_t k_end;
    int64_t k;
    int64_t strip;
    double d_t;
    double d;
    double load_t;
    double load;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double away_t;
    double away;
    int64_t k6;
    int64_t k7;
    deepest_t = (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION));
    deepest = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION));
    middle = (int64_t)((*cspan_at(&work, region + layout__REGION_STRIP)));
    spacing_t = (*cspan_at(&work_t, region + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    origin_t = (*cspan_at(&work_t, region + layout__REGION_OFFSET)) + (*cspan_at(&work_t, region + layout__REGION_STATION));
    origin = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    along_t = (*cspan_at(&work_t, region + layout__REGION_X_TRACK));
    along = (*cspan_at(&work, region + layout__REGION_X_TRACK));
    slant_t = (*cspan_at(&work_t, region + layout__REGION_SLANT));
    slant = (*cspan_at(&work, region + layout__REGION_SLANT));
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (middle + k);
        d_t = deepest_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + k));
        d = deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + k));
        load_t = (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + k)) * d + (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k)) * d_t;
        load = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k)) * d;
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_LINE_LOAD)) = load_t;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_LINE_LOAD)) = load;
        v1 = d / (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k));
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (d_t - v1 * (*cspan_at(&work_t, nodes + layout__NODES_LENGTH + INT64_C(128) + k))) / (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k));
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = v1;
        v2 = 4.0 / (M_PI * M_PI);
        v3 = v2 * (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k));
        v4 = v3 * load;
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (v2 * (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + k)) * load + v3 * load_t) * (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k)) + v4 * (*cspan_at(&work_t, nodes + layout__NODES_LENGTH + INT64_C(128) + k));
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = v4 * (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k));
        v5 = (double)(k);
        away_t = spacing_t * v5;
        away = spacing * v5;
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_STATION)) = origin_t + away_t;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_STATION)) = origin + away;
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_WIDTH)) = spacing_t;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_WIDTH)) = spacing;
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_X)) = along_t + (slant_t * away + slant * away_t);
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_X)) = along + slant * away;
        (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + k));
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k));
    }
    k6 = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (middle + (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))) + layout__SOLVED_STRIP_WIDTH;
    (*cspan_at(&work_t, k6)) = 0.5 * spacing_t;
    (*cspan_at(&work, k6)) = 0.5 * spacing;
    k7 = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (middle + (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)))) + layout__SOLVED_STRIP_WIDTH;
    (*cspan_at(&work_t, k7)) = 0.5 * spacing_t;
    (*cspan_at(&work, k7)) = 0.5 * spacing;
    return INT64_C(0);
}

/* Tangent of ``add_cell``. */
static inline int64_t tangent_node_patches__add_cell_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t number, int64_t nodes, int64_t k, double contact_angle, double contact_angle_t)
{
    double spacing_t;
    double spacing;
    double deepest_t;
    double deepest;
    int64_t outward;
    int64_t low;
    int64_t before;
    int64_t high;
    double start;
    double start_t;
    double stop;
    double stop_t;
    double v1;
    double v1_t;
    int64_t strip;
    int64_t inner;
    int64_t outer;
    double begin_t;
    double begin;
    double end_t;
    double end;
    int64_t n2;
    int64_t index;
    int64_t patch;
    double v3;
    double load;
    double load_t;
    double moment;
    double moment_t;
    spacing_t = (*cspan_at(&work_t, region + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    deepest_t = (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION));
    deepest = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION));
    outward = INT64_C(1);
    low = k;
    if (k < INT64_C(0))
    {
        outward = -INT64_C(1);
        low = k + INT64_C(1);
    }
    before = low - outward;
    high = low + outward;
    tangent_quadrature__cell_part_t(&start, &start_t, &stop, &stop_t, deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + before)), deepest_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + before)), deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + low)), deepest_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + low)), deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + high)), deepest_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + high)));
    if ((k == (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))) || (k == (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) - INT64_C(1)))
    {
        tangent_analyn__clip_to_bound_t(&v1, &v1_t, work, work_t, region, low, outward, stop, stop_t);
        stop_t = v1_t;
        stop = v1;
    }
    strip = (int64_t)((*cspan_at(&work, region + layout__REGION_STRIP)));
    inner = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + low);
    outer = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + high);
    if ((start > 0.0) || (stop < 1.0))
    {
        tangent_node_patches__narrow_strips_t(work, work_t, inner, outer, start, start_t, stop, stop_t, spacing, spacing_t);
    }
    if (stop > start)
    {
        begin_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_STATION)) + (spacing_t * start + spacing * start_t);
        begin = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) + spacing * start;
        end_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_STATION)) + (spacing_t * stop + spacing * stop_t);
        end = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) + spacing * stop;
        if (outward < INT64_C(0))
        {
            begin_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_STATION)) - (spacing_t * stop + spacing * stop_t);
            begin = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) - spacing * stop;
            end_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_STATION)) - (spacing_t * start + spacing * start_t);
            end = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) - spacing * start;
        }
        n2 = tangent_node_patches__patch_from_t(work, work_t, region, begin, begin_t, strip + k, contact_angle, contact_angle_t);
        index = n2;
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = end_t;
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = end;
        (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LAST)) = 0.0;
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(strip + k + INT64_C(1));
        v3 = (double)(outward);
        tangent_node_patches__add_load_t(&load, &load_t, &moment, &moment_t, work, work_t, patch + layout__SOLVED_PATCH_TOTALS, region, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + before), inner, outer, start, start_t, stop, stop_t, spacing * v3, spacing_t * v3);
        tangent_filling__add_part_t(work, work_t, index, number, load, load_t, moment, moment_t);
        tangent_node_patches__keep_largest_t(work, work_t, strip + low);
    }
    return INT64_C(0);
}

/* Tangent of ``narrow_strips``. */
static inline int64_t tangent_node_patches__narrow_strips_t(array_double_1d work, array_double_1d work_t, int64_t inner, int64_t outer, double start, double start_t, double stop, double stop_t, double spacing, double spacing_t)
{
    double inner_share_t;
    double inner_share;
    double outer_share_t;
    double outer_share;
    double v1;
    double v2;
    inner_share_t = 0.0;
    inner_share = 0.0;
    outer_share_t = 0.0;
    outer_share = 0.0;
    if (stop > start)
    {
        if (start > 0.0)
        {
            outer_share_t = stop_t - start_t;
            outer_share = stop - start;
        }
        else
        {
            inner_share_t = stop_t - start_t;
            inner_share = stop - start;
        }
    }
    v1 = inner_share - 0.5;
    (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_WIDTH)) + (inner_share_t * spacing + v1 * spacing_t);
    (*cspan_at(&work, inner + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work, inner + layout__SOLVED_STRIP_WIDTH)) + v1 * spacing;
    v2 = outer_share - 0.5;
    (*cspan_at(&work_t, outer + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work_t, outer + layout__SOLVED_STRIP_WIDTH)) + (outer_share_t * spacing + v2 * spacing_t);
    (*cspan_at(&work, outer + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work, outer + layout__SOLVED_STRIP_WIDTH)) + v2 * spacing;
    return INT64_C(0);
}

/* Tangent of ``patch_from``. */
static inline int64_t tangent_node_patches__patch_from_t(array_double_1d work, array_double_1d work_t, int64_t region, double start, double start_t, int64_t strip, double contact_angle, double contact_angle_t)
{
    int64_t joined;
    int64_t last;
    int64_t n1;
    int64_t index;
    index = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1);
    joined = INT64_C(0);
    if (index >= INT64_C(0))
    {
        last = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        if (start - (*cspan_at(&work, last + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) < node_patches__JOINED * (*cspan_at(&work, region + layout__REGION_SPACING)))
        {
            joined = INT64_C(1);
        }
    }
    if (joined == INT64_C(0))
    {
        tangent_filling__finish_patch_t(work, work_t);
        n1 = tangent_filling__begin_patch_t(work, work_t, region, start, start_t, strip, layout__RULE_QUADRATIC, contact_angle, contact_angle_t);
        index = n1;
    }
    return index;
}

/* Tangent of ``add_load``. */
static inline int64_t tangent_node_patches__add_load_t(double* load, double* load_t, double* moment, double* moment_t, array_double_1d work, array_double_1d work_t, int64_t totals, int64_t region, int64_t before, int64_t low, int64_t high, double start, double start_t, double stop, double stop_t, double step, double step_t)
{
    double width_t;
    double width;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    double v3;
    double v3_t;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    double area_t;
    double area;
    double v6;
    double v7;
    width_t = tangent_rates__size_rate(step, step_t);
    width = fabs(step);
    tangent_quadrature__quadratic_integral_t(&v1, &v1_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_LINE_LOAD)), stop, stop_t);
    (*load_t) = v1_t;
    (*load) = v1;
    tangent_quadrature__quadratic_moment_t(&v2, &v2_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_LINE_LOAD)), stop, stop_t);
    (*moment_t) = v2_t;
    (*moment) = v2;
    if (start > 0.0)
    {
        tangent_quadrature__quadratic_integral_t(&v3, &v3_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_LINE_LOAD)), start, start_t);
        (*load_t) = (*load_t) - v3_t;
        (*load) = (*load) - v3;
        tangent_quadrature__quadratic_moment_t(&v4, &v4_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_LINE_LOAD)), start, start_t);
        (*moment_t) = (*moment_t) - v4_t;
        (*moment) = (*moment) - v4;
    }
    (*load_t) = (*load_t) * width + (*load) * width_t;
    (*load) = (*load) * width;
    tangent_quadrature__root_integral_t(&v5, &v5_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, low + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, high + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), start, start_t, stop, stop_t);
    area_t = v5_t;
    area = v5;
    v6 = width * step;
    (*moment_t) = (*cspan_at(&work_t, low + layout__SOLVED_STRIP_STATION)) * (*load) + (*cspan_at(&work, low + layout__SOLVED_STRIP_STATION)) * (*load_t) + ((width_t * step + width * step_t) * (*moment) + v6 * (*moment_t));
    (*moment) = (*cspan_at(&work, low + layout__SOLVED_STRIP_STATION)) * (*load) + v6 * (*moment);
    (*cspan_at(&work_t, region + layout__REGION_CARRIED)) = (*cspan_at(&work_t, region + layout__REGION_CARRIED)) + (*load_t);
    (*cspan_at(&work, region + layout__REGION_CARRIED)) = (*cspan_at(&work, region + layout__REGION_CARRIED)) + (*load);
    (*cspan_at(&work_t, region + layout__REGION_MOMENT)) = (*cspan_at(&work_t, region + layout__REGION_MOMENT)) + (*moment_t);
    (*cspan_at(&work, region + layout__REGION_MOMENT)) = (*cspan_at(&work, region + layout__REGION_MOMENT)) + (*moment);
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD)) + (*load_t);
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) + (*load);
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MOMENT)) + (*moment_t);
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) + (*moment);
    v7 = 2.0 * width;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) + (2.0 * width_t * area + v7 * area_t);
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) + v7 * area;
    return 0;
}

/* Tangent of ``keep_largest``. */
static inline int64_t tangent_node_patches__keep_largest_t(array_double_1d work, array_double_1d work_t, int64_t strip)
{
    int64_t low;
    int64_t here;
    int64_t high;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    low = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip - INT64_C(1));
    here = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * strip;
    high = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + INT64_C(1));
    if ((*cspan_at(&work, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)))
    {
        tangent_node_patches__peak_square_t(&v1, &v1_t, (*cspan_at(&work, low + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, high + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)));
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = v1_t;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = v1;
    }
    if ((*cspan_at(&work, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)))
    {
        tangent_node_patches__peak_square_t(&v2, &v2_t, (*cspan_at(&work, low + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work_t, low + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work_t, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, high + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work_t, high + layout__SOLVED_STRIP_PRESSURE_SQUARE)));
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = v2_t;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = v2;
    }
    return INT64_C(0);
}

/* Tangent of ``peak_square``. */
static inline int64_t tangent_node_patches__peak_square_t(double* result_0, double* result_1, double before, double before_t, double square, double square_t, double after, double after_t)
{
    double v1;
    double top_t;
    double top;
    double v2;
    double left_t;
    double left;
    double v3;
    double right_t;
    double right;
    double bend_t;
    double bend;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    if ((before > 0.0) && (after > 0.0) && (square >= before) && (square >= after))
    {
        v1 = sqrt(square);
        top_t = tangent_rates__root_rate(v1, square_t);
        top = v1;
        v2 = sqrt(before);
        left_t = tangent_rates__root_rate(v2, before_t);
        left = v2;
        v3 = sqrt(after);
        right_t = tangent_rates__root_rate(v3, after_t);
        right = v3;
        bend_t = left_t - 2.0 * top_t + right_t;
        bend = left - 2.0 * top + right;
        if (bend < 0.0)
        {
            v4 = right - left;
            v5 = right - left;
            v6 = v4 * v5;
            v7 = 8.0 * bend;
            v8 = v6 / v7;
            top_t = top_t - ((right_t - left_t) * v5 + v4 * (right_t - left_t) - v8 * (8.0 * bend_t)) / v7;
            top = top - v8;
            square_t = top_t * top + top * top_t;
            square = top * top;
        }
    }
    (*result_0) = square;
    (*result_1) = square_t;
    return 0;
}
