/* Generated from patch/patches.py by tools/transpile_kernel.py; change that one.
 *
 * From solved regions to contact patches: loads, areas, pressures, centroids, and the outline at evenly spaced stations.
 *
 * A patch is a connected run of loaded strips.  Between nodes the line load and the squares of half-length and pressure
 * are the quadratics through the cell's nodes and its inner neighbour, so that an ellipse comes out exact.
 */

#include "patches.h"

/* Integral over [start, stop] of x times the quadratic of ``bend_of``. */
static inline double patches__quadratic_moment(double before, double low, double high, double start, double stop)
{
    double bend;
    double slope;
    double upper;
    double lower;
    bend = analyn__bend_of(before, low, high);
    slope = high - low - bend;
    upper = stop * stop * (low / 2.0 + stop * (slope / 3.0 + stop * bend / 4.0));
    lower = start * start * (low / 2.0 + start * (slope / 3.0 + start * bend / 4.0));
    return upper - lower;
}

/* Integral over [start, stop] of sqrt(low + slope x + bend x^2) for bend < 0, in closed form.
 *
 * The angle between both ends is taken from the roots themselves, not from how far x has come: at the end of a loaded
 * stretch the rounding of root and angle then cancels.
 */
static inline double patches__bent_integral(double low, double slope, double bend, double start, double stop)
{
    double first;
    double last;
    double spread;
    double first_root;
    double last_root;
    double first_rate;
    double last_rate;
    double across;
    double height;
    double height_before;
    double angle;
    first = low + start * (slope + start * bend);
    last = low + stop * (slope + stop * bend);
    if (first < 0.0)
    {
        first = 0.0;
    }
    if (last < 0.0)
    {
        last = 0.0;
    }
    spread = slope * slope - 4.0 * bend * low;
    if (!(spread > 0.0))
    {
        return 0.0;
    }
    first_root = sqrt(first);
    last_root = sqrt(last);
    first_rate = 2.0 * bend * start + slope;
    last_rate = 2.0 * bend * stop + slope;
    across = sqrt(-bend);
    height = 2.0 * across * last_root;
    height_before = 2.0 * across * first_root;
    angle = atan2(height * first_rate - height_before * last_rate, height * height_before + last_rate * first_rate);
    return (last_rate * last_root - first_rate * first_root) / (4.0 * bend) + spread / (8.0 * (-bend) * across) * angle;
}

/* Integral over [start, stop] of the square root of the quadratic of ``bend_of``, which is not negative there.
 *
 * In closed form where the quadratic bends down noticeably.  Otherwise with the roots p, q of the end values and the
 * width w, expanded about the chord: w [2/3 (p^2 + p q + q^2)/(p + q) - 2/15 bend w^2 (p^2 + 3 p q + q^2)/(p + q)^3].
 */
static inline double patches__root_integral(double before, double low, double high, double start, double stop)
{
    double bend;
    double slope;
    double first;
    double last;
    double p;
    double q;
    double total;
    double width;
    double chord;
    bend = analyn__bend_of(before, low, high);
    slope = high - low - bend;
    if (bend < (-patches__STRAIGHT) * (fabs(low) + fabs(high)))
    {
        return patches__bent_integral(low, slope, bend, start, stop);
    }
    first = low + start * (slope + start * bend);
    last = low + stop * (slope + stop * bend);
    if (first < 0.0)
    {
        first = 0.0;
    }
    if (last < 0.0)
    {
        last = 0.0;
    }
    p = sqrt(first);
    q = sqrt(last);
    total = p + q;
    if (!(total > 0.0))
    {
        return 0.0;
    }
    width = stop - start;
    chord = 2.0 / 3.0 * (first + p * q + last) / total;
    return width * (chord - 2.0 / 15.0 * bend * width * width * (first + 3.0 * p * q + last) / (total * total * total));
}

/* Line load, square of half-length and of pressure at the region's nodes for its ``level`` [m]. */
static inline int64_t patches__load_nodes(array_double_1d work, int64_t region, double level)
{
    int64_t block;
    int64_t rises;
    int64_t lines;
    int64_t lengths;
    int64_t loads;
    int64_t squares;
    int64_t pressures;
    int64_t k_end;
    int64_t k;
    double d;
    double load;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    rises = nodes__node_field(region, nodes__NODE_RISE);
    lines = nodes__node_field(region, nodes__NODE_LINE);
    lengths = nodes__node_field(region, nodes__NODE_LENGTH);
    loads = nodes__node_field(region, nodes__NODE_LOAD);
    squares = nodes__node_field(region, nodes__NODE_SQUARE);
    pressures = nodes__node_field(region, nodes__NODE_PRESSURE);
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        d = level - (*cspan_at(&work, rises + k));
        load = (*cspan_at(&work, lines + k)) * d;
        (*cspan_at(&work, loads + k)) = load;
        (*cspan_at(&work, squares + k)) = d / (*cspan_at(&work, lengths + k));
        /* p0 = (2/pi) (E* /(n r)) sqrt(d (1 + alpha) A) */
        (*cspan_at(&work, pressures + k)) = 4.0 / (M_PI * M_PI) * (*cspan_at(&work, lines + k)) * load * (*cspan_at(&work, lengths + k));
    }
    return INT64_C(0);
}

/* Square of the largest value of the parabola through the roots at nodes ``k`` - 1, ``k``, ``k`` + 1 of a field of
 * squares, where node ``k`` is a peak and both neighbours are loaded; else the node's own.
 */
static inline double patches__peak_square(array_double_1d work, int64_t field, int64_t k)
{
    double before;
    double after;
    double top;
    double left;
    double right;
    double bend;
    double square;
    square = (*cspan_at(&work, field + k));
    before = (*cspan_at(&work, field + k - INT64_C(1)));
    after = (*cspan_at(&work, field + k + INT64_C(1)));
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

/* Begin island ``count`` at station ``start``. */
static inline int64_t patches__open_island(array_double_1d work, int64_t count, double start, double angle)
{
    int64_t at;
    int64_t i;
    at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * count;
    for (i = INT64_C(0); i < patches__ISLAND_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, at + i)) = 0.0;
    }
    (*cspan_at(&work, at + patches__ISLAND_START)) = start;
    (*cspan_at(&work, at + patches__ISLAND_STOP)) = start;
    (*cspan_at(&work, at + patches__ISLAND_ANGLE)) = angle;
    return INT64_C(0);
}

/* Walk over all regions by rising station and collect the islands; their number. */
static inline int64_t patches__gather_islands(array_double_1d tables, array_double_1d work, int64_t count)
{
    int64_t region;
    int64_t block;
    double level;
    double angle;
    int64_t k_end;
    int64_t k;
    int64_t islands;
    islands = INT64_C(0);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        level = (*cspan_at(&work, block + layout__REGION_LEVEL));
        (*cspan_at(&work, block + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_MOMENT)) = 0.0;
        if (level > 0.0)
        {
            angle = -atan((*cspan_at(&work, block + layout__REGION_LEAN)));
            patches__load_nodes(work, region, level);
            k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
            for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
            {
                islands = patches__gather_cell(work, region, level, k, islands, angle);
            }
        }
    }
    return islands;
}

/* Add the cell between nodes ``k`` and ``k`` + 1 to the last island, or to a new one; the number of islands. */
static inline int64_t patches__gather_cell(array_double_1d work, int64_t region, double level, int64_t k, int64_t islands, double angle)
{
    int64_t block;
    double spacing;
    int64_t outward;
    int64_t low;
    int64_t before;
    int64_t high;
    int64_t rises;
    double start;
    double stop;
    double inner;
    double begin;
    double end;
    int64_t joined;
    int64_t at;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    outward = INT64_C(1);
    low = k;
    if (k < INT64_C(0))
    {
        outward = -INT64_C(1);
        low = k + INT64_C(1);
    }
    before = low - outward;
    high = low + outward;
    rises = nodes__node_field(region, nodes__NODE_RISE);
    analyn__cell_part(&start, &stop, level - (*cspan_at(&work, rises + before)), level - (*cspan_at(&work, rises + low)), level - (*cspan_at(&work, rises + high)));
    if ((k == (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)))) || (k == (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) - INT64_C(1)))
    {
        stop = analyn__clip_to_bound(work, block, low, outward, stop);
    }
    if (stop > start)
    {
        inner = (*cspan_at(&work, block + layout__REGION_OFFSET)) + (*cspan_at(&work, block + layout__REGION_STATION)) + spacing * (double)(low);
        begin = inner + spacing * start;
        end = inner + spacing * stop;
        if (outward < INT64_C(0))
        {
            begin = inner - spacing * stop;
            end = inner - spacing * start;
        }
        joined = INT64_C(0);
        if (islands > INT64_C(0))
        {
            if (begin - (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1)) + patches__ISLAND_STOP)) < patches__JOINED * spacing)
            {
                joined = INT64_C(1);
            }
        }
        if ((joined == INT64_C(0)) && (islands < patches__ISLAND_LIMIT))
        {
            patches__open_island(work, islands, begin, angle);
            islands += INT64_C(1);
        }
        at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1));
        (*cspan_at(&work, at + patches__ISLAND_STOP)) = end;
        patches__add_cell(work, region, before, low, high, start, stop, at, inner, spacing * (double)(outward));
    }
    return islands;
}

/* Add load, moment and area of a cell's loaded part to the island at ``at``, and its inner node's extremes. */
static inline int64_t patches__add_cell(array_double_1d work, int64_t region, int64_t before, int64_t low, int64_t high, double start, double stop, int64_t at, double inner, double step)
{
    int64_t loads;
    int64_t squares;
    int64_t pressures;
    double width;
    double load;
    double moment;
    double area;
    loads = nodes__node_field(region, nodes__NODE_LOAD);
    squares = nodes__node_field(region, nodes__NODE_SQUARE);
    pressures = nodes__node_field(region, nodes__NODE_PRESSURE);
    width = fabs(step);
    load = width * analyn__quadratic_integral((*cspan_at(&work, loads + before)), (*cspan_at(&work, loads + low)), (*cspan_at(&work, loads + high)), start, stop);
    moment = patches__quadratic_moment((*cspan_at(&work, loads + before)), (*cspan_at(&work, loads + low)), (*cspan_at(&work, loads + high)), start, stop);
    area = patches__root_integral((*cspan_at(&work, squares + before)), (*cspan_at(&work, squares + low)), (*cspan_at(&work, squares + high)), start, stop);
    moment = inner * load + width * step * moment;
    (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) += load;
    (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) += moment;
    (*cspan_at(&work, at + patches__ISLAND_LOAD)) += load;
    (*cspan_at(&work, at + patches__ISLAND_MOMENT)) += moment;
    (*cspan_at(&work, at + patches__ISLAND_AREA)) += 2.0 * width * area;
    if ((*cspan_at(&work, squares + low)) > (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)))
    {
        (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)) = patches__peak_square(work, squares, low);
    }
    if ((*cspan_at(&work, pressures + low)) > (*cspan_at(&work, at + patches__ISLAND_PRESSURE)))
    {
        (*cspan_at(&work, at + patches__ISLAND_PRESSURE)) = patches__peak_square(work, pressures, low);
    }
    return INT64_C(0);
}

/* The side's totals and its heaviest patches, from the islands, into the outputs at ``side``. */
static inline int64_t patches__write_patches(array_double_1d work, int64_t side, int64_t islands)
{
    double load;
    double area;
    double moment;
    double pressure;
    double half;
    int64_t i;
    int64_t at;
    int64_t last;
    int64_t rank;
    int64_t heaviest;
    load = 0.0;
    area = 0.0;
    moment = 0.0;
    pressure = 0.0;
    half = 0.0;
    for (i = INT64_C(0); i < islands; i += INT64_C(1))
    {
        at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * i;
        load += (*cspan_at(&work, at + patches__ISLAND_LOAD));
        area += (*cspan_at(&work, at + patches__ISLAND_AREA));
        moment += (*cspan_at(&work, at + patches__ISLAND_MOMENT));
        if ((*cspan_at(&work, at + patches__ISLAND_PRESSURE)) > pressure)
        {
            pressure = (*cspan_at(&work, at + patches__ISLAND_PRESSURE));
        }
        if ((*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)) > half)
        {
            half = (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH));
        }
    }
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_COUNT)) = (double)(islands);
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_FORCE)) = load;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_AREA)) = area;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)) = sqrt(pressure);
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)) = 2.0 * sqrt(half);
    if (islands > INT64_C(0))
    {
        last = layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1));
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_WIDTH)) = (*cspan_at(&work, last + patches__ISLAND_STOP)) - (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_START));
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_CENTROID)) = moment / load;
    }
    for (rank = INT64_C(0); rank < layout__PATCH_LIMIT; rank += INT64_C(1))
    {
        heaviest = -INT64_C(1);
        for (i = INT64_C(0); i < islands; i += INT64_C(1))
        {
            at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * i;
            if ((*cspan_at(&work, at + patches__ISLAND_LOAD)) > 0.0)
            {
                if (heaviest < INT64_C(0))
                {
                    heaviest = at;
                }
                else if ((*cspan_at(&work, at + patches__ISLAND_LOAD)) > (*cspan_at(&work, heaviest + patches__ISLAND_LOAD)))
                {
                    heaviest = at;
                }
            }
        }
        if (heaviest >= INT64_C(0))
        {
            patches__write_patch(work, side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * rank, heaviest);
            (*cspan_at(&work, heaviest + patches__ISLAND_LOAD)) = 0.0;
        }
    }
    return INT64_C(0);
}

/* One patch from the island at ``at`` to the outputs at ``to``. */
static inline int64_t patches__write_patch(array_double_1d work, int64_t to, int64_t at)
{
    (*cspan_at(&work, to + layout__PATCH_NORMAL_FORCE)) = (*cspan_at(&work, at + patches__ISLAND_LOAD));
    (*cspan_at(&work, to + layout__PATCH_AREA)) = (*cspan_at(&work, at + patches__ISLAND_AREA));
    (*cspan_at(&work, to + layout__PATCH_MAX_PRESSURE)) = sqrt((*cspan_at(&work, at + patches__ISLAND_PRESSURE)));
    (*cspan_at(&work, to + layout__PATCH_LENGTH)) = 2.0 * sqrt((*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)));
    (*cspan_at(&work, to + layout__PATCH_WIDTH)) = (*cspan_at(&work, at + patches__ISLAND_STOP)) - (*cspan_at(&work, at + patches__ISLAND_START));
    (*cspan_at(&work, to + layout__PATCH_CENTROID)) = (*cspan_at(&work, at + patches__ISLAND_MOMENT)) / (*cspan_at(&work, at + patches__ISLAND_LOAD));
    (*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)) = (*cspan_at(&work, at + patches__ISLAND_ANGLE));
    return INT64_C(0);
}

/* Half-length and pressure at ``stations`` stations from the first loaded station to the last, to ``place``. */
static inline int64_t patches__write_outline(array_double_1d work, int64_t side, int64_t place, int64_t stations, int64_t count, int64_t islands)
{
    double start;
    double stop;
    int64_t j;
    double station;
    double half;
    double pressure;
    int64_t region;
    int64_t block;
    double own;
    if (islands > INT64_C(0))
    {
        start = (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_START));
        stop = (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1)) + patches__ISLAND_STOP));
        for (j = INT64_C(0); j < stations; j += INT64_C(1))
        {
            station = start + (stop - start) * (double)(j) / (double)(stations - INT64_C(1));
            half = 0.0;
            pressure = 0.0;
            if ((j > INT64_C(0)) && (j < stations - INT64_C(1)))
            {
                for (region = INT64_C(0); region < count; region += INT64_C(1))
                {
                    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
                    own = station - (*cspan_at(&work, block + layout__REGION_OFFSET));
                    if ((own >= (*cspan_at(&work, block + layout__REGION_LOW))) && (own <= (*cspan_at(&work, block + layout__REGION_HIGH))) && (half == 0.0))
                    {
                        patches__strip_at(&half, &pressure, work, region, own);
                    }
                }
            }
            /* between nodes a root can overshoot at a kink */
            if (half > 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)))
            {
                half = 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH));
            }
            if (pressure > (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)))
            {
                pressure = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE));
            }
            (*cspan_at(&work, place + j)) = station;
            (*cspan_at(&work, place + stations + j)) = half;
            (*cspan_at(&work, place + INT64_C(2) * stations + j)) = pressure;
        }
    }
    return INT64_C(0);
}

/* Half-length [m] and pressure [Pa] of ``region`` at ``station``; zeros where it is not loaded. */
static inline int64_t patches__strip_at(double* half, double* pressure, array_double_1d work, int64_t region, double station)
{
    int64_t block;
    double level;
    double u;
    bool inside;
    int64_t outward;
    int64_t low;
    double x;
    int64_t squares;
    int64_t pressures;
    double length;
    double square;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    level = (*cspan_at(&work, block + layout__REGION_LEVEL));
    (*half) = 0.0;
    (*pressure) = 0.0;
    u = (station - (*cspan_at(&work, block + layout__REGION_STATION))) / (*cspan_at(&work, block + layout__REGION_SPACING));
    inside = (u > (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)))) && (u < (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))));
    if ((level > 0.0) && inside)
    {
        outward = INT64_C(1);
        if (u < 0.0)
        {
            outward = -INT64_C(1);
            u = -u;
        }
        low = (int64_t)(u);
        x = u - (double)(low);
        low = outward * low;
        squares = nodes__node_field(region, nodes__NODE_SQUARE) + low;
        pressures = nodes__node_field(region, nodes__NODE_PRESSURE) + low;
        length = patches__quadratic_value((*cspan_at(&work, squares - outward)), (*cspan_at(&work, squares)), (*cspan_at(&work, squares + outward)), x);
        square = patches__quadratic_value((*cspan_at(&work, pressures - outward)), (*cspan_at(&work, pressures)), (*cspan_at(&work, pressures + outward)), x);
        if ((length > 0.0) && (square > 0.0))
        {
            (*half) = sqrt(length);
            (*pressure) = sqrt(square);
        }
    }
    return 0;
}

/* The quadratic of ``bend_of`` at x. */
static inline double patches__quadratic_value(double before, double low, double high, double x)
{
    double bend;
    bend = analyn__bend_of(before, low, high);
    return low + x * (high - low - bend + x * bend);
}
