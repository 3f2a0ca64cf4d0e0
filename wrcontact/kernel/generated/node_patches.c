/* Generated from normal/node_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From ANALYN's regions to solved patches: every node becomes a strip, every run of loaded cells a patch.
 *
 * Between the strips the line load and the squares of half-length and pressure follow quadratics
 * (:mod:`quadrature`), so that an ellipse comes out exactly.  A patch may reach over the bound between two
 * regions, and a region may hold two patches.
 */

#include "node_patches.h"

/* Fill the solved patches from ``count`` regions at their local penetrations. */
static inline int64_t node_patches__fill_from_nodes(array_double_1d work, int64_t count)
{
    int64_t strips;
    int64_t index;
    int64_t region;
    double angle;
    int64_t k_end;
    int64_t k;
    filling__clear_patches(work);
    strips = INT64_C(0);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        (*cspan_at(&work, region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_MOMENT)) = 0.0;
        if ((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) > 0.0)
        {
            (*cspan_at(&work, region + layout__REGION_STRIP)) = (double)(strips - (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))));
            node_patches__fill_strips(work, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * index);
            strips += (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) - (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))) + INT64_C(1);
            angle = -atan((*cspan_at(&work, region + layout__REGION_INCLINATION)));
            k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
            for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
            {
                node_patches__add_cell(work, region, index, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * index, k, angle);
            }
        }
    }
    filling__finish_patch(work);
    filling__finish_patches(work);
    return INT64_C(0);
}

/* The strips of a region, one at each node, also where it is not loaded.  Each is as wide as the spacing,
 * the outermost ones half of it; :func:`add_cell` takes away what is not loaded.
 *
 * The pressure on x = 0 is p0 = (2/pi) (E* /(n r)) sqrt(d (1 + alpha) A), with d as in :mod:`analyn`.
 */
static inline int64_t node_patches__fill_strips(array_double_1d work, int64_t region, int64_t nodes)
{
    double deepest;
    int64_t middle;
    double spacing;
    double origin;
    double along;
    double slant;
    int64_t k_end;
    int64_t k;
    int64_t strip;
    double d;
    double load;
    double away;
    deepest = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION));
    middle = (int64_t)((*cspan_at(&work, region + layout__REGION_STRIP)));
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    origin = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    along = (*cspan_at(&work, region + layout__REGION_X_TRACK));
    slant = (*cspan_at(&work, region + layout__REGION_SLANT));
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (middle + k);
        d = deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + k));
        load = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k)) * d;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_LINE_LOAD)) = load;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = d / (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k));
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = 4.0 / (M_PI * M_PI) * (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k)) * load * (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k));
        away = spacing * (double)(k);
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_STATION)) = origin + away;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_WIDTH)) = spacing;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_X)) = along + slant * away;
        (*cspan_at(&work, strip + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k));
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (middle + (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))) + layout__SOLVED_STRIP_WIDTH)) = 0.5 * spacing;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (middle + (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)))) + layout__SOLVED_STRIP_WIDTH)) = 0.5 * spacing;
    return INT64_C(0);
}

/* Add the cell between nodes ``k`` and ``k`` + 1 of region ``number`` to the last patch, or to a
 * new one that begins in it.
 */
static inline int64_t node_patches__add_cell(array_double_1d work, int64_t region, int64_t number, int64_t nodes, int64_t k, double contact_angle)
{
    double spacing;
    double deepest;
    int64_t outward;
    int64_t low;
    int64_t before;
    int64_t high;
    double start;
    double stop;
    int64_t strip;
    int64_t inner;
    int64_t outer;
    double begin;
    double end;
    int64_t index;
    int64_t patch;
    double load;
    double moment;
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
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
    quadrature__cell_part(&start, &stop, deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + before)), deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + low)), deepest - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + high)));
    if ((k == (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))) || (k == (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) - INT64_C(1)))
    {
        stop = analyn__clip_to_bound(work, region, low, outward, stop);
    }
    strip = (int64_t)((*cspan_at(&work, region + layout__REGION_STRIP)));
    inner = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + low);
    outer = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + high);
    if ((start > 0.0) || (stop < 1.0))
    {
        node_patches__narrow_strips(work, inner, outer, start, stop, spacing);
    }
    if (stop > start)
    {
        begin = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) + spacing * start;
        end = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) + spacing * stop;
        if (outward < INT64_C(0))
        {
            begin = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) - spacing * stop;
            end = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION)) - spacing * start;
        }
        index = node_patches__patch_from(work, region, begin, strip + k, contact_angle);
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = end;
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(strip + k + INT64_C(1));
        node_patches__add_load(&load, &moment, work, patch + layout__SOLVED_PATCH_TOTALS, region, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + before), inner, outer, start, stop, spacing * (double)(outward));
        filling__add_part(work, index, number, load, moment);
        node_patches__keep_largest(work, strip + low);
    }
    return INT64_C(0);
}

/* Take from the strips at the ends of a cell what of it is not loaded, so that the widths of a patch's
 * strips add up to its own: the loaded part [start, stop] belongs to the strip that is inside the patch,
 * which has half the cell so far.
 */
static inline int64_t node_patches__narrow_strips(array_double_1d work, int64_t inner, int64_t outer, double start, double stop, double spacing)
{
    double inner_share;
    double outer_share;
    inner_share = 0.0;
    outer_share = 0.0;
    if (stop > start)
    {
        if (start > 0.0)
        {
            outer_share = stop - start;
        }
        else
        {
            inner_share = stop - start;
        }
    }
    (*cspan_at(&work, inner + layout__SOLVED_STRIP_WIDTH)) += (inner_share - 0.5) * spacing;
    (*cspan_at(&work, outer + layout__SOLVED_STRIP_WIDTH)) += (outer_share - 0.5) * spacing;
    return INT64_C(0);
}

/* Index of the patch that a loaded part that begins at station ``start`` [m], beside ``strip``, belongs
 * to: the last one if that ends there, else a new one.
 */
static inline int64_t node_patches__patch_from(array_double_1d work, int64_t region, double start, int64_t strip, double contact_angle)
{
    int64_t joined;
    int64_t last;
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
        filling__finish_patch(work);
        index = filling__begin_patch(work, region, start, strip, layout__RULE_QUADRATIC, contact_angle);
    }
    return index;
}

/* Add load, moment and area of the loaded part [start, stop] of a cell to its patch and its region; the
 * load [N] and the moment [N m].
 *
 * ``low`` and ``high`` are the strips at its inner and outer end, ``step`` [m] from each other, and
 * ``before`` the next one further in.
 */
static inline int64_t node_patches__add_load(double* load, double* moment, array_double_1d work, int64_t totals, int64_t region, int64_t before, int64_t low, int64_t high, double start, double stop, double step)
{
    double width;
    double area;
    width = fabs(step);
    (*load) = quadrature__quadratic_integral((*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), stop);
    (*moment) = quadrature__quadratic_moment((*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), stop);
    if (start > 0.0)
    {
        (*load) -= quadrature__quadratic_integral((*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), start);
        (*moment) -= quadrature__quadratic_moment((*cspan_at(&work, before + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, low + layout__SOLVED_STRIP_LINE_LOAD)), (*cspan_at(&work, high + layout__SOLVED_STRIP_LINE_LOAD)), start);
    }
    (*load) *= width;
    area = quadrature__root_integral((*cspan_at(&work, before + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, low + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, high + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), start, stop);
    (*moment) = (*cspan_at(&work, low + layout__SOLVED_STRIP_STATION)) * (*load) + width * step * (*moment);
    (*cspan_at(&work, region + layout__REGION_CARRIED)) += (*load);
    (*cspan_at(&work, region + layout__REGION_MOMENT)) += (*moment);
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) += (*load);
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) += (*moment);
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) += 2.0 * width * area;
    return 0;
}

/* Let the last patch have the squares of half-length and pressure at ``strip``, if they are its largest
 * ones so far.
 */
static inline int64_t node_patches__keep_largest(array_double_1d work, int64_t strip)
{
    int64_t low;
    int64_t here;
    int64_t high;
    low = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip - INT64_C(1));
    here = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * strip;
    high = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (strip + INT64_C(1));
    if ((*cspan_at(&work, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = node_patches__peak_square((*cspan_at(&work, low + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, high + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)));
    }
    if ((*cspan_at(&work, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = node_patches__peak_square((*cspan_at(&work, low + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, high + layout__SOLVED_STRIP_PRESSURE_SQUARE)));
    }
    return INT64_C(0);
}

/* Square of the largest value of the parabola through the roots of three squares, where the middle one is
 * a peak and both others are loaded; else the middle one.
 */
static inline double node_patches__peak_square(double before, double square, double after)
{
    double top;
    double left;
    double right;
    double bend;
    if ((before > 0.0) && (after > 0.0) && (square >= before) && (square >= after))
    {
        top = sqrt(square);
        left = sqrt(before);
        right = sqrt(after);
        bend = left - 2.0 * top + right;
        if (bend < 0.0)
        {
            top -= (right - left) * (right - left) / (8.0 * bend);
            square = top * top;
        }
    }
    return square;
}
