/* Generated from normal/strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From corrected strips to solved patches: each run of loaded strips that touch each other is a patch.
 */

#include "strip_patches.h"

/* Fill the solved patches from the runs of loaded strips, which lie in ``count`` regions. */
static inline int64_t strip_patches__fill_from_strips(array_double_1d work, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t first;
    int64_t last;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        strip_patches__load_region(work, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index, index);
    }
    filling__clear_patches(work);
    first = INT64_C(0);
    while((first < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)))) && ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) < layout__SOLVED_PATCH_LIMIT))
    {
        last = first;
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_LINE_LOAD)) > 0.0)
        {
            last = strip_edges__run_end(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))), first);
            strip_patches__fill_run(work, first, last);
        }
        first = last + INT64_C(1);
    }
    filling__finish_patches(work);
    return INT64_C(0);
}

/* Fill the next patch from the loaded strips ``first`` ... ``last``. */
static inline int64_t strip_patches__fill_run(array_double_1d work, int64_t first, int64_t last)
{
    double start;
    double stop;
    int64_t region;
    int64_t index;
    int64_t patch;
    int64_t i;
    double load;
    double pressure;
    if (last > first)
    {
        strip_patches__end_like_ellipse(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (first + INT64_C(1)));
        strip_patches__end_like_ellipse(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (last - INT64_C(1)));
    }
    start = strip_edges__run_edge(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))), first, last, -INT64_C(1));
    stop = strip_edges__run_edge(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))), last, first, INT64_C(1));
    region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_REGION)));
    index = filling__begin_patch(work, region, start, first, layout__RULE_STRAIGHT, -atan((*cspan_at(&work, region + layout__REGION_INCLINATION))));
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        strip_patches__add_strip(work, patch, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * i);
        load = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH));
        filling__add_part(work, index, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION))), load, load * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)));
    }
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = stop;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(last);
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA)) = strip_patches__run_area(work, first, last, start, stop);
    pressure = strip_patches__largest_pressure(work, first, last);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = pressure * pressure;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = strip_patches__largest_square(work, first, last);
    filling__finish_patch(work);
    return INT64_C(0);
}

/* Shorten the strip ``edge`` at the end of a run as the strip ``inner`` beside it asks for; its load
 * stays.
 *
 * Where a patch ends like an ellipse, the squares of the half-lengths fall like the line loads.  A strip
 * that has just begun to carry has had the half-length of its neighbour, which is too long; eq. (S9).
 */
static inline int64_t strip_patches__end_like_ellipse(array_double_1d work, int64_t edge, int64_t inner)
{
    double square;
    square = (*cspan_at(&work, inner + layout__STRIP_HALF_LENGTH_SQUARE)) * (*cspan_at(&work, edge + layout__STRIP_LINE_LOAD)) / (*cspan_at(&work, inner + layout__STRIP_LINE_LOAD));
    if (square < (*cspan_at(&work, edge + layout__STRIP_HALF_LENGTH_SQUARE)))
    {
        (*cspan_at(&work, edge + layout__STRIP_PRESSURE)) *= sqrt((*cspan_at(&work, edge + layout__STRIP_HALF_LENGTH_SQUARE)) / square);
        (*cspan_at(&work, edge + layout__STRIP_HALF_LENGTH_SQUARE)) = square;
    }
    return INT64_C(0);
}

/* Add a strip to a patch, as the solved strip ``to``. */
static inline int64_t strip_patches__add_strip(array_double_1d work, int64_t patch, int64_t strip, int64_t to)
{
    double load;
    load = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) += load;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) += load * (*cspan_at(&work, strip + layout__STRIP_STATION));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_STATION)) = (*cspan_at(&work, strip + layout__STRIP_STATION));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work, strip + layout__STRIP_WIDTH));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_X)) = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work, strip + layout__STRIP_A));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_LINE_LOAD)) = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) * (*cspan_at(&work, strip + layout__STRIP_PRESSURE));
    return INT64_C(0);
}

/* What the strips of the region with number ``index`` carry: load, moment, the mean direction of the
 * force, and the slant of the line through their middles.
 */
static inline int64_t strip_patches__load_region(array_double_1d work, array_double_1d tables, int64_t region, int64_t index)
{
    double load;
    double moment;
    double cosines;
    double sines;
    double x;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double own;
    load = 0.0;
    moment = 0.0;
    cosines = 0.0;
    sines = 0.0;
    x = 0.0;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
        {
            own = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            load += own;
            moment += own * (*cspan_at(&work, strip + layout__STRIP_STATION));
            cosines += own * (*cspan_at(&work, strip + layout__STRIP_COS));
            sines += own * (*cspan_at(&work, strip + layout__STRIP_SIN));
            x += own * ((*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)));
        }
    }
    (*cspan_at(&work, region + layout__REGION_CARRIED)) = load;
    (*cspan_at(&work, region + layout__REGION_MOMENT)) = moment;
    (*cspan_at(&work, region + layout__REGION_SLANT)) = 0.0;
    if (load > 0.0)
    {
        (*cspan_at(&work, region + layout__REGION_COS)) = cosines / load;
        (*cspan_at(&work, region + layout__REGION_SIN)) = sines / load;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            (*cspan_at(&work, region + layout__REGION_SHARE)) = rails__upright_share(work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_COS)), (*cspan_at(&work, region + layout__REGION_SIN)));
        }
        strip_patches__slant_region(work, region, index, moment / load, x / load);
    }
    return INT64_C(0);
}

/* Slant of the line through the middles of a region's strips, whose load has its centre at ``station``
 * and ``x`` [m].
 */
static inline int64_t strip_patches__slant_region(array_double_1d work, int64_t region, int64_t index, double station, double x)
{
    double along;
    double spread;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double own;
    double away;
    along = 0.0;
    spread = 0.0;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
        {
            own = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            away = (*cspan_at(&work, strip + layout__STRIP_STATION)) - station;
            along += own * away * ((*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)) - x);
            spread += own * away * away;
        }
    }
    if (spread > strip_patches__CLOSE * strip_patches__CLOSE * (*cspan_at(&work, region + layout__REGION_CARRIED)))
    {
        (*cspan_at(&work, region + layout__REGION_SLANT)) = along / spread;
    }
    return INT64_C(0);
}

/* How the load of each region follows the penetration [N/m], from the last equations that were
 * solved.
 */
static inline int64_t strip_patches__add_stiffness(array_double_1d work, array_double_1d tables, int64_t count)
{
    int64_t index;
    double scale;
    int64_t size;
    int64_t i_end;
    int64_t i;
    int64_t rank;
    int64_t row;
    int64_t strip;
    int64_t region;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_STIFFNESS)) = 0.0;
    }
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    size = INT64_C(0);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LOADED)) == 1.0)
        {
            size += INT64_C(1);
        }
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank)));
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        (*cspan_at(&work, region + layout__REGION_STIFFNESS)) += scale * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, row + size));
    }
    return INT64_C(0);
}

/* Second divided difference of a quantity with these values at the strips ``i`` - 1, ``i``, ``i`` + 1. */
static inline double strip_patches__divided_bend(array_double_1d work, int64_t i, double before, double value, double after)
{
    double left;
    double right;
    double upper;
    double lower;
    left = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
    right = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION));
    upper = (after - value) / right;
    lower = (value - before) / left;
    return (upper - lower) / (left + right);
}

/* Second divided difference of the square of the half-length at strip ``i`` [-]. */
static inline double strip_patches__square_bend(array_double_1d work, int64_t i)
{
    double before;
    double result;
    before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE));
    result = strip_patches__divided_bend(work, i, before, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)));
    return result;
}

/* Second coefficient of the square of the half-length between strips ``i`` and ``i`` + 1 of the run first
 * ... last [-].
 */
static inline double strip_patches__cell_bend(array_double_1d work, int64_t i, int64_t first, int64_t last)
{
    double found;
    double bend;
    bend = 0.0;
    found = 0.0;
    if ((i > first) && (i < last))
    {
        bend += strip_patches__square_bend(work, i);
        found += 1.0;
    }
    if ((i + INT64_C(1) < last) && (i + INT64_C(1) > first))
    {
        bend += strip_patches__square_bend(work, i + INT64_C(1));
        found += 1.0;
    }
    if (found > 0.0)
    {
        bend /= found;
    }
    return bend;
}

/* Integral over a cell of the root of the quadratic with end values ``low``, ``high`` [m^2] and second
 * coefficient ``bend``.
 */
static inline double strip_patches__cell_area(double low, double high, double bend, double width)
{
    return width * quadrature__root_integral(2.0 * low - high + 2.0 * bend * width * width, low, high, 0.0, 1.0);
}

/* Area [m^2] of the run first ... last between its edges ``start`` and ``stop`` [m]. */
static inline double strip_patches__run_area(array_double_1d work, int64_t first, int64_t last, double start, double stop)
{
    double bend;
    double half;
    int64_t i;
    bend = strip_patches__cell_bend(work, first, first, last);
    half = strip_patches__cell_area(0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_HALF_LENGTH_SQUARE)), bend, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_STATION)) - start);
    for (i = first; i < last; i += INT64_C(1))
    {
        bend = strip_patches__cell_bend(work, i, first, last);
        half += strip_patches__cell_area((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)), bend, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)));
    }
    bend = strip_patches__cell_bend(work, last - INT64_C(1), first, last);
    half += strip_patches__cell_area((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_HALF_LENGTH_SQUARE)), 0.0, bend, stop - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)));
    return 2.0 * half;
}

/* Largest value of the parabola through a quantity at strip ``i``, where it is largest, and at both
 * neighbours.
 */
static inline double strip_patches__summit(array_double_1d work, int64_t i, double before, double value, double after)
{
    double bend;
    double left;
    double slope;
    bend = strip_patches__divided_bend(work, i, before, value, after);
    if (bend < 0.0)
    {
        left = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
        slope = (value - before) / left + bend * left;
        value -= slope * slope / (4.0 * bend);
    }
    return value;
}

/* Largest pressure [Pa] on the middle lines of a run, also between strips. */
static inline double strip_patches__largest_pressure(array_double_1d work, int64_t first, int64_t last)
{
    int64_t best;
    int64_t i;
    double before;
    double pressure;
    best = first;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_PRESSURE)))
        {
            best = i;
        }
    }
    pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_PRESSURE));
    if ((best > first) && (best < last))
    {
        before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best - INT64_C(1)) + layout__STRIP_PRESSURE));
        pressure = strip_patches__summit(work, best, before, pressure, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best + INT64_C(1)) + layout__STRIP_PRESSURE)));
    }
    return pressure;
}

/* Square of the largest half-length [m^2] of a run, also between strips. */
static inline double strip_patches__largest_square(array_double_1d work, int64_t first, int64_t last)
{
    int64_t best;
    int64_t i;
    double before;
    double square;
    best = first;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_HALF_LENGTH_SQUARE)))
        {
            best = i;
        }
    }
    square = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_HALF_LENGTH_SQUARE));
    if ((best > first) && (best < last))
    {
        before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best - INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE));
        square = strip_patches__summit(work, best, before, square, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)));
    }
    return square;
}
