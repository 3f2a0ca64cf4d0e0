/* Generated from tangent_sections.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of sections.py.
 */

#include "tangent_sections.h"

/* Tangent of ``cut_patch``. */
static inline int64_t tangent_sections__cut_patch_t(array_double_1d work, array_double_1d work_t, int64_t index, int64_t rolling)
{
    int64_t patch;
    int64_t totals;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    totals = patch + layout__SOLVED_PATCH_TOTALS;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
    tangent_sections__describe_ellipse_t(work, work_t, totals, rolling);
    tangent_sections__lay_strips_t(work, work_t, rolling, (*cspan_at(&work, totals + layout__PATCH_TOTALS_START)), (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_START)), (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)), (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP)));
    if ((*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) > 0.0)
    {
        if ((int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_RULE))) == layout__RULE_ELLIPSE)
        {
            tangent_sections__cut_ellipse_t(work, work_t, totals, rolling);
        }
        else
        {
            tangent_sections__cut_strips_t(work, work_t, patch, rolling);
        }
    }
    tangent_sections__finish_strips_t(work, work_t, rolling, (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID)), (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_CENTROID)), (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)), (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_SLANT)));
    tangent_sections__plane_slips_t(work, work_t, rolling);
    return INT64_C(0);
}

/* Tangent of ``describe_ellipse``. */
static inline int64_t tangent_sections__describe_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t totals, int64_t rolling)
{
    double v1;
    double v2;
    double ratio_t;
    double ratio;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = 0.0;
    if (((*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) > 0.0) && ((*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) > 0.0))
    {
        v1 = 2.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
        v2 = v1 / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        ratio_t = (2.0 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) - v2 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH))) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        ratio = v2;
        if (ratio < sections__SHORTEST)
        {
            ratio_t = 0.0;
            ratio = sections__SHORTEST;
        }
        if (ratio > sections__LONGEST)
        {
            ratio_t = 0.0;
            ratio = sections__LONGEST;
        }
        v3 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) / M_PI;
        v4 = v3 * ratio;
        v5 = sqrt(v4);
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = tangent_rates__root_rate(v5, (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) / M_PI * ratio + v3 * ratio_t);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = v5;
        v6 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) / M_PI;
        v7 = v6 / ratio;
        v8 = sqrt(v7);
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = tangent_rates__root_rate(v8, ((*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) / M_PI - v7 * ratio_t) / ratio);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = v8;
    }
    return INT64_C(0);
}

/* Tangent of ``lay_strips``. */
static inline int64_t tangent_sections__lay_strips_t(array_double_1d work, array_double_1d work_t, int64_t rolling, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double middle_t;
    double middle;
    double v2;
    double half_t;
    double half;
    double before;
    double here;
    double edge_t;
    double edge;
    int64_t i;
    int64_t strip;
    double after;
    double v3;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_COUNT)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)) = (double)(layout__ROLLING_STRIP_LIMIT);
    v1 = start + stop;
    middle_t = 0.5 * (start_t + stop_t);
    middle = 0.5 * v1;
    v2 = stop - start;
    half_t = 0.5 * (stop_t - start_t);
    half = 0.5 * v2;
    before = sections__COSINE;
    here = 1.0;
    edge_t = start_t;
    edge = start;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        after = 2.0 * sections__COSINE * here - before;
        before = here;
        here = after;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_START)) = edge_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_START)) = edge;
        edge_t = middle_t - half_t * here;
        edge = middle - half * here;
        if (i == layout__ROLLING_STRIP_LIMIT - INT64_C(1))
        {
            edge_t = stop_t;
            edge = stop;
        }
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STOP)) = edge_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP)) = edge;
        v3 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_START)) + edge;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)) = 0.5 * ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_START)) + edge_t);
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) = 0.5 * v3;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)) = edge_t - (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_START));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) = edge - (*cspan_at(&work, strip + layout__ROLLING_STRIP_START));
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = 0.0;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = 0.0;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = 0.0;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) = 0.0;
    }
    return INT64_C(0);
}

/* Tangent of ``cut_ellipse``. */
static inline int64_t tangent_sections__cut_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t totals, int64_t rolling)
{
    double square_t;
    double square;
    double v1;
    double v2;
    double v3;
    double third_t;
    double third;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double low_t;
    double low;
    double high_t;
    double high;
    double v4;
    double v5;
    double share_t;
    double share;
    square_t = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) + (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    square = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    v1 = 3.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP));
    v2 = v1 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP));
    v3 = 1.0 / v2;
    third_t = (-v3) * (3.0 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP)) * (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)) + v1 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP))) / v2;
    third = v3;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        low_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_START));
        low = (*cspan_at(&work, strip + layout__ROLLING_STRIP_START));
        high_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STOP));
        high = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP));
        v4 = low * low + low * high + high * high;
        v5 = 1.0 - third * v4;
        share_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)) * v5 + (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) * (-(third_t * v4 + third * (low_t * low + low * low_t + (low_t * high + low * high_t) + (high_t * high + high * high_t))));
        share = (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) * v5;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = square_t * share + square * share_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = square * share;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) = share_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = share;
    }
    return INT64_C(0);
}

/* Tangent of ``cut_strips``. */
static inline int64_t tangent_sections__cut_strips_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t rolling)
{
    double low_t;
    double low;
    double low_square_t;
    double low_square;
    double low_load_t;
    double low_load;
    int64_t at;
    int64_t k_end;
    int64_t k;
    int64_t node;
    bool inside;
    bool loaded;
    int64_t n1;
    low_t = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    low = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    low_square_t = 0.0;
    low_square = 0.0;
    low_load_t = 0.0;
    low_load = 0.0;
    at = INT64_C(0);
    k_end = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST))); k < k_end; k += INT64_C(1))
    {
        node = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * k;
        inside = ((*cspan_at(&work, node + layout__SOLVED_STRIP_STATION)) > low) && ((*cspan_at(&work, node + layout__SOLVED_STRIP_STATION)) < (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)));
        loaded = ((*cspan_at(&work, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) > 0.0) && ((*cspan_at(&work, node + layout__SOLVED_STRIP_LINE_LOAD)) > 0.0);
        if (inside && loaded && ((*cspan_at(&work, node + layout__SOLVED_STRIP_WIDTH)) > 0.0))
        {
            n1 = tangent_sections__add_piece_t(work, work_t, rolling, at, low, low_t, low_square, low_square_t, low_load, low_load_t, (*cspan_at(&work, node + layout__SOLVED_STRIP_STATION)), (*cspan_at(&work_t, node + layout__SOLVED_STRIP_STATION)), (*cspan_at(&work, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, node + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work_t, node + layout__SOLVED_STRIP_LINE_LOAD)));
            at = n1;
            low_t = (*cspan_at(&work_t, node + layout__SOLVED_STRIP_STATION));
            low = (*cspan_at(&work, node + layout__SOLVED_STRIP_STATION));
            low_square_t = (*cspan_at(&work_t, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
            low_square = (*cspan_at(&work, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
            low_load_t = (*cspan_at(&work_t, node + layout__SOLVED_STRIP_LINE_LOAD));
            low_load = (*cspan_at(&work, node + layout__SOLVED_STRIP_LINE_LOAD));
        }
    }
    tangent_sections__add_piece_t(work, work_t, rolling, at, low, low_t, low_square, low_square_t, low_load, low_load_t, (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)), (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)), 0.0, 0.0, 0.0, 0.0);
    return INT64_C(0);
}

/* Tangent of ``add_piece``. */
static inline int64_t tangent_sections__add_piece_t(array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t at, double low, double low_t, double low_square, double low_square_t, double low_load, double low_load_t, double high, double high_t, double high_square, double high_square_t, double high_load, double high_load_t)
{
    double width_t;
    double width;
    double v1;
    double v2;
    double square_slope_t;
    double square_slope;
    double v3;
    double v4;
    double load_slope_t;
    double load_slope;
    double start_t;
    double start;
    int64_t strip;
    double stop_t;
    double stop;
    double v5;
    double middle_t;
    double middle;
    double v6;
    double v7;
    double v8;
    double v9;
    width_t = high_t - low_t;
    width = high - low;
    v1 = high_square - low_square;
    v2 = v1 / width;
    square_slope_t = (high_square_t - low_square_t - v2 * width_t) / width;
    square_slope = v2;
    v3 = high_load - low_load;
    v4 = v3 / width;
    load_slope_t = (high_load_t - low_load_t - v4 * width_t) / width;
    load_slope = v4;
    start_t = low_t;
    start = low;
    while(start < high)
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * at;
        stop_t = high_t;
        stop = high;
        if (((*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP)) < high) && (at < (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT))) - INT64_C(1)))
        {
            stop_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STOP));
            stop = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP));
        }
        v5 = start + stop;
        middle_t = 0.5 * (start_t + stop_t) - low_t;
        middle = 0.5 * v5 - low;
        v6 = stop - start;
        v7 = low_square + square_slope * middle;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + ((stop_t - start_t) * v7 + v6 * (low_square_t + (square_slope_t * middle + square_slope * middle_t)));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + v6 * v7;
        v8 = stop - start;
        v9 = low_load + load_slope * middle;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) + ((stop_t - start_t) * v9 + v8 * (low_load_t + (load_slope_t * middle + load_slope * middle_t)));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) + v8 * v9;
        if (stop < high)
        {
            at = at + INT64_C(1);
        }
        start_t = stop_t;
        start = stop;
    }
    return at;
}

/* Tangent of ``finish_strips``. */
static inline int64_t tangent_sections__finish_strips_t(array_double_1d work, array_double_1d work_t, int64_t rolling, double centroid, double centroid_t, double slant, double slant_t)
{
    double carried_t;
    double carried;
    int64_t i_end;
    int64_t i;
    double scale_t;
    double scale;
    double v1;
    int64_t strip;
    double v2;
    double v3;
    double v4;
    carried_t = 0.0;
    carried = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        carried_t = carried_t + (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i + layout__ROLLING_STRIP_LINE_LOAD));
        carried = carried + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i + layout__ROLLING_STRIP_LINE_LOAD));
    }
    scale_t = 0.0;
    scale = 0.0;
    if (carried > 0.0)
    {
        v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) / carried;
        scale_t = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD)) - v1 * carried_t) / carried;
        scale = v1;
    }
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)) - centroid_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - centroid;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)) = slant_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) + slant * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) = slant * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
        if ((*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) > 0.0)
        {
            v2 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) / (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
            v3 = sqrt(v2);
            (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = tangent_rates__root_rate(v3, ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) - v2 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH))) / (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)));
            (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = v3;
            v4 = scale / (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
            (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) * v4 + (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) * ((scale_t - v4 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH))) / (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)));
            (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) * v4;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``plane_slips``. */
static inline int64_t tangent_sections__plane_slips_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y)));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
    }
    return INT64_C(0);
}
