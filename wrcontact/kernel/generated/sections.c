/* Generated from tangential/sections.py by tools/transpile_kernel.py; change that one.
 *
 * From a solved patch to the strips that roll: the patch cut along the rolling direction.
 *
 * The cuts are closer together near both ends of the patch, like Gauss-Chebyshev points:
 *
 *     e_k = middle - half cos(k pi / n),   k = 0 ... n                                            (C1)
 *
 * A strip has the mean of a^2 over its width as the square of its half-length, and the mean line load.  Both are
 * exact for an ellipse.  Between the strips of the normal model they follow straight lines, to zero at the
 * patch's edges.  The line loads are scaled so that they carry the load of the patch.
 *
 * All places are taken from the patch's centre of load, for which its creepages hold.  The middles of a yawed
 * wheel's strips lie on a slanted line through it.
 */

#include "sections.h"

/* Cut the solved patch ``index`` into the strips of ``rolling``, and describe it there; creepages and
 * friction stay.
 */
static inline int64_t sections__cut_patch(array_double_1d work, int64_t index, int64_t rolling)
{
    int64_t patch;
    int64_t totals;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    totals = patch + layout__SOLVED_PATCH_TOTALS;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
    sections__describe_ellipse(work, totals, rolling);
    sections__lay_strips(work, rolling, (*cspan_at(&work, totals + layout__PATCH_TOTALS_START)), (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)));
    if ((*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) > 0.0)
    {
        if ((int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_RULE))) == layout__RULE_ELLIPSE)
        {
            sections__cut_ellipse(work, totals, rolling);
        }
        else
        {
            sections__cut_strips(work, patch, rolling);
        }
    }
    sections__finish_strips(work, rolling, (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID)), (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)));
    sections__plane_slips(work, rolling);
    return INT64_C(0);
}

/* Semi-axes of the ellipse with the patch's area and length over width. */
static inline int64_t sections__describe_ellipse(array_double_1d work, int64_t totals, int64_t rolling)
{
    double ratio;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = 0.0;
    if (((*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) > 0.0) && ((*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) > 0.0))
    {
        ratio = 2.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        if (ratio < sections__SHORTEST)
        {
            ratio = sections__SHORTEST;
        }
        if (ratio > sections__LONGEST)
        {
            ratio = sections__LONGEST;
        }
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = sqrt((*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) / M_PI * ratio);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = sqrt((*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) / M_PI / ratio);
    }
    return INT64_C(0);
}

/* Edges of the strips between both stations [m]; eq. (C1).  The cosines follow from each other:
 * cos((k + 1) t) = 2 cos t cos(k t) - cos((k - 1) t).
 */
static inline int64_t sections__lay_strips(array_double_1d work, int64_t rolling, double start, double stop)
{
    double middle;
    double half;
    double before;
    double here;
    double edge;
    int64_t i;
    int64_t strip;
    double after;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)) = (double)(layout__ROLLING_STRIP_LIMIT);
    middle = 0.5 * (start + stop);
    half = 0.5 * (stop - start);
    before = sections__COSINE;
    here = 1.0;
    edge = start;
    for (i = INT64_C(0); i < layout__ROLLING_STRIP_LIMIT; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        after = 2.0 * sections__COSINE * here - before;
        before = here;
        here = after;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_START)) = edge;
        edge = middle - half * here;
        if (i == layout__ROLLING_STRIP_LIMIT - INT64_C(1))
        {
            edge = stop;
        }
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP)) = edge;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) = 0.5 * ((*cspan_at(&work, strip + layout__ROLLING_STRIP_START)) + edge);
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) = edge - (*cspan_at(&work, strip + layout__ROLLING_STRIP_START));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) = 0.0;
    }
    return INT64_C(0);
}

/* Integrals over each strip of a^2 and of a shape of the line load, 1 - (s/b)^2, into its half-length
 * and its line load; the ellipse is around station zero.
 */
static inline int64_t sections__cut_ellipse(array_double_1d work, int64_t totals, int64_t rolling)
{
    double square;
    double third;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double low;
    double high;
    double share;
    square = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    third = 1.0 / (3.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)) * (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)));
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        low = (*cspan_at(&work, strip + layout__ROLLING_STRIP_START));
        high = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP));
        share = (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) * (1.0 - third * (low * low + low * high + high * high));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = square * share;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = share;
    }
    return INT64_C(0);
}

/* Integrals over each strip of a^2 and of the line load, into its half-length and its line load, from the
 * patch's strips in the normal model.
 */
static inline int64_t sections__cut_strips(array_double_1d work, int64_t patch, int64_t rolling)
{
    double low;
    double low_square;
    double low_load;
    int64_t at;
    int64_t k_end;
    int64_t k;
    int64_t node;
    bool inside;
    bool loaded;
    low = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    low_square = 0.0;
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
            at = sections__add_piece(work, rolling, at, low, low_square, low_load, (*cspan_at(&work, node + layout__SOLVED_STRIP_STATION)), (*cspan_at(&work, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, node + layout__SOLVED_STRIP_LINE_LOAD)));
            low = (*cspan_at(&work, node + layout__SOLVED_STRIP_STATION));
            low_square = (*cspan_at(&work, node + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
            low_load = (*cspan_at(&work, node + layout__SOLVED_STRIP_LINE_LOAD));
        }
    }
    sections__add_piece(work, rolling, at, low, low_square, low_load, (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)), 0.0, 0.0);
    return INT64_C(0);
}

/* Add a piece between two stations [m], over which a^2 and the line load follow straight lines, to the
 * strips from ``at`` on; the strip in which it ends.
 */
static inline int64_t sections__add_piece(array_double_1d work, int64_t rolling, int64_t at, double low, double low_square, double low_load, double high, double high_square, double high_load)
{
    double width;
    double square_slope;
    double load_slope;
    double start;
    int64_t strip;
    double stop;
    double middle;
    width = high - low;
    square_slope = (high_square - low_square) / width;
    load_slope = (high_load - low_load) / width;
    start = low;
    while(start < high)
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * at;
        stop = high;
        if (((*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP)) < high) && (at < (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT))) - INT64_C(1)))
        {
            stop = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STOP));
        }
        middle = 0.5 * (start + stop) - low;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) += (stop - start) * (low_square + square_slope * middle);
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) += (stop - start) * (low_load + load_slope * middle);
        if (stop < high)
        {
            at += INT64_C(1);
        }
        start = stop;
    }
    return at;
}

/* Half-lengths and line loads from their integrals, and places from the centre of load at the station
 * ``centroid`` [m].
 */
static inline int64_t sections__finish_strips(array_double_1d work, int64_t rolling, double centroid, double slant)
{
    double carried;
    int64_t i_end;
    int64_t i;
    double scale;
    int64_t strip;
    carried = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        carried += (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i + layout__ROLLING_STRIP_LINE_LOAD));
    }
    scale = 0.0;
    if (carried > 0.0)
    {
        scale = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) / carried;
    }
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - centroid;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) = slant * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
        if ((*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) > 0.0)
        {
            (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = sqrt((*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) / (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)));
            (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) *= scale / (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        }
    }
    return INT64_C(0);
}

/* Longitudinal creepage of each strip where the patch is plane and all of it turns at one rate. */
static inline int64_t sections__plane_slips(array_double_1d work, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
    }
    return INT64_C(0);
}
