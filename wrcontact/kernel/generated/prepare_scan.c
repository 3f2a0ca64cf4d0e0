/* Generated from prepare/scan.py by tools/transpile_kernel.py; change that one.
 *
 * The search's raster over the wheel, with the bounds that certify it.
 *
 * The table is the record Scan. Scratch holds, for each piece of the profile at work, the smallest and largest
 * second derivative and the largest absolute slope of its samples.
 */

#include "prepare_scan.h"

/* Offset of a profile's first piece. */
static inline int64_t prepare_scan__first_piece(array_double_1d tables, int64_t base)
{
    int64_t result;
    result = base + (int64_t)((*cspan_at(&tables, base + layout__PROFILE_PIECES)));
    return result;
}

/* How many pieces a profile has. */
static inline int64_t prepare_scan__piece_count(array_double_1d tables, int64_t base)
{
    int64_t result;
    result = py_floor_div_int64_t((profile_table__find_piece(tables, base, (*cspan_at(&tables, base + layout__PROFILE_STOP))) - prepare_scan__first_piece(tables, base)), layout__PIECE_SIZE) + INT64_C(1);
    return result;
}

/* Width of the piece at ``at`` [m]. */
static inline double prepare_scan__piece_width(array_double_1d tables, int64_t base, int64_t at)
{
    double stop;
    double result;
    stop = (*cspan_at(&tables, at + layout__PIECE_SIZE));
    if (!(stop < (*cspan_at(&tables, base + layout__PROFILE_STOP))))
    {
        stop = (*cspan_at(&tables, base + layout__PROFILE_STOP));
    }
    result = stop - (*cspan_at(&tables, at));
    return result;
}

/* Slope [-] and second derivative [1/m] of the piece at ``at``, ``u`` [m] from its start. */
static inline int64_t prepare_scan__slope_bend(double* slope, double* bend, array_double_1d tables, int64_t at, double u)
{
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    c1 = (*cspan_at(&tables, at + INT64_C(2)));
    c2 = (*cspan_at(&tables, at + INT64_C(3)));
    c3 = (*cspan_at(&tables, at + INT64_C(4)));
    c4 = (*cspan_at(&tables, at + INT64_C(5)));
    c5 = (*cspan_at(&tables, at + INT64_C(6)));
    (*slope) = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)));
    (*bend) = 2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5));
    return 0;
}

/* Smallest and largest second derivative and largest absolute slope of a piece's samples between
 * ``low`` and ``high``.
 */
static inline int64_t prepare_scan__piece_range(double* least, double* most, double* steepest, array_double_1d tables, int64_t at, double width, double low, double high)
{
    int64_t k;
    double u;
    double y;
    double slope;
    double bend;
    (*least) = prepare_scan__FAR;
    (*most) = -prepare_scan__FAR;
    (*steepest) = 0.0;
    for (k = INT64_C(0); k < prepare_scan__LAST_SAMPLE + INT64_C(1); k += INT64_C(1))
    {
        u = width * ((double)(k) / (double)(prepare_scan__LAST_SAMPLE));
        y = (*cspan_at(&tables, at)) + u;
        if ((low <= y) && (y <= high))
        {
            prepare_scan__slope_bend(&slope, &bend, tables, at, u);
            (*least) = double_min(2, (*least), bend);
            (*most) = double_max(2, (*most), bend);
            (*steepest) = double_max(2, (*steepest), fabs(slope));
        }
    }
    return 0;
}

/* The ranges of all pieces of a profile into scratch. */
static inline int64_t prepare_scan__sample_pieces(array_double_1d tables, int64_t base, array_double_1d work, int64_t scratch)
{
    int64_t first;
    int64_t i;
    int64_t at;
    double least;
    double most;
    double steepest;
    first = prepare_scan__first_piece(tables, base);
    for (i = INT64_C(0); i < prepare_scan__piece_count(tables, base); i += INT64_C(1))
    {
        at = first + layout__PIECE_SIZE * i;
        prepare_scan__piece_range(&least, &most, &steepest, tables, at, prepare_scan__piece_width(tables, base, at), -prepare_scan__FAR, prepare_scan__FAR);
        (*cspan_at(&work, scratch + INT64_C(3) * i)) = least;
        (*cspan_at(&work, scratch + INT64_C(3) * i + INT64_C(1))) = most;
        (*cspan_at(&work, scratch + INT64_C(3) * i + INT64_C(2))) = steepest;
    }
    return INT64_C(0);
}

/* Smallest and largest second derivative [1/m] and largest absolute slope [-] between ``low`` and
 * ``high`` [m], clipped to the profile; every piece counts with both its ends, so that a jump of curvature
 * counts with both its sides.
 */
static inline int64_t prepare_scan__bend_range(double* least, double* most, double* steepest, array_double_1d tables, int64_t base, array_double_1d work, int64_t scratch, double low, double high)
{
    double start;
    double stop;
    double z;
    double slope;
    double other;
    double bend;
    int64_t first;
    int64_t last;
    int64_t begin;
    int64_t at;
    double piece_least;
    double piece_most;
    double piece_steepest;
    int64_t i;
    start = (*cspan_at(&tables, base + layout__PROFILE_START));
    stop = (*cspan_at(&tables, base + layout__PROFILE_STOP));
    low = double_min(2, double_max(2, low, start), stop);
    high = double_min(2, double_max(2, high, start), stop);
    profile_table__height_slope_bend(&z, &slope, least, tables, base, low);
    profile_table__height_slope_bend(&z, &other, most, tables, base, high);
    (*steepest) = double_max(2, fabs(slope), fabs(other));
    if ((*most) < (*least))
    {
        bend = (*least);
        (*least) = (*most);
        (*most) = bend;
    }
    first = prepare_scan__first_piece(tables, base);
    last = profile_table__find_piece(tables, base, high);
    begin = profile_table__find_piece(tables, base, low);
    at = int64_t_max(2, begin - layout__PIECE_SIZE, first);
    while(at <= last)
    {
        piece_least = prepare_scan__FAR;
        piece_most = -prepare_scan__FAR;
        piece_steepest = 0.0;
        if ((at > begin) && (at < last - layout__PIECE_SIZE))
        {
            i = py_floor_div_int64_t((at - first), layout__PIECE_SIZE);
            piece_least = (*cspan_at(&work, scratch + INT64_C(3) * i));
            piece_most = (*cspan_at(&work, scratch + INT64_C(3) * i + INT64_C(1)));
            piece_steepest = (*cspan_at(&work, scratch + INT64_C(3) * i + INT64_C(2)));
        }
        else
        {
            prepare_scan__piece_range(&piece_least, &piece_most, &piece_steepest, tables, at, prepare_scan__piece_width(tables, base, at), low, high);
        }
        (*least) = double_min(2, (*least), piece_least);
        (*most) = double_max(2, (*most), piece_most);
        (*steepest) = double_max(2, (*steepest), piece_steepest);
        at += layout__PIECE_SIZE;
    }
    return 0;
}

/* How many coarse steps the wheel is divided into. */
static inline int64_t prepare_scan__coarse_count(double start, double stop)
{
    return (int64_t)((int64_t)ceil((stop - start) / prepare_scan__COARSE_STEP));
}

/* Abscissa [m] of coarse node ``i`` of ``count`` + 1, the ends to the last bit. */
static inline double prepare_scan__raster_place(double start, double stop, int64_t count, int64_t i)
{
    double y;
    y = start + (stop - start) / (double)(count) * (double)(i);
    if (i == count)
    {
        y = stop;
    }
    return y;
}

/* Abscissae of the scan nodes, no more than COARSE_STEP apart from one end of the wheel to the other,
 * half as much where it is not nearly straight; the number of the first node in each coarse step goes to
 * ``work`` at ``firsts``. How many nodes, or TOO_WIDE or FULL.
 */
static inline int64_t prepare_scan__write_raster(array_double_1d tables, int64_t scan, array_double_1d work, int64_t scratch, int64_t firsts)
{
    int64_t wheel;
    double start;
    double stop;
    int64_t count;
    double step;
    int64_t node;
    int64_t i;
    double y;
    double least;
    double most;
    double steepest;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    start = (*cspan_at(&tables, wheel + layout__PROFILE_START));
    stop = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
    count = prepare_scan__coarse_count(start, stop);
    step = (stop - start) / (double)(count);
    if (scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (INT64_C(2) * count + INT64_C(1)) > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    node = INT64_C(0);
    for (i = INT64_C(0); i < count + INT64_C(1); i += INT64_C(1))
    {
        y = prepare_scan__raster_place(start, stop, count, i);
        (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y)) = y;
        (*cspan_at(&work, firsts + i)) = (double)(node);
        node += INT64_C(1);
        if (i < count)
        {
            prepare_scan__bend_range(&least, &most, &steepest, tables, wheel, work, scratch, y, prepare_scan__raster_place(start, stop, count, i + INT64_C(1)));
            if (double_max(2, fabs(least), fabs(most)) > prepare_scan__STRAIGHT)
            {
                (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y)) = y + 0.5 * step;
                node += INT64_C(1);
            }
        }
    }
    if (node > layout__SCAN_LIMIT)
    {
        node = prepare_scan__TOO_WIDE;
    }
    return node;
}

/* Height, slope and bounds of the nodes; stretches end with the table.
 *
 * Stretches that are steeper than the search's bounds allow get a second derivative with
 * which they are not skipped.
 */
static inline int64_t prepare_scan__write_wheel_bounds(array_double_1d tables, int64_t scan, int64_t count, array_double_1d work, int64_t scratch)
{
    int64_t wheel;
    int64_t i;
    int64_t node;
    double y;
    double z;
    double slope;
    int64_t cells;
    int64_t exponent;
    int64_t end;
    double least;
    double most;
    double steepest;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        node = scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * i;
        y = (*cspan_at(&tables, node + layout__SCAN_NODE_Y));
        profile_table__height_slope(&z, &slope, tables, wheel, y);
        (*cspan_at(&tables, node + layout__SCAN_NODE_HEIGHT)) = z;
        (*cspan_at(&tables, node + layout__SCAN_NODE_SLOPE)) = slope;
        cells = INT64_C(1);
        for (exponent = INT64_C(0); exponent < layout__EXPONENTS; exponent += INT64_C(1))
        {
            end = int64_t_min(2, i + cells, count - INT64_C(1));
            prepare_scan__bend_range(&least, &most, &steepest, tables, wheel, work, scratch, y, (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * end + layout__SCAN_NODE_Y)));
            (*cspan_at(&tables, node + layout__SCAN_NODE_STEEPEST_BENDS + exponent)) = double_max(2, fabs(least), fabs(most));
            if (!(steepest < bounds__STEEP))
            {
                most = prepare_scan__TOO_STEEP;
            }
            (*cspan_at(&tables, node + layout__SCAN_NODE_MOST_BENDS + exponent)) = most;
            if (exponent == INT64_C(0))
            {
                (*cspan_at(&tables, node + layout__SCAN_NODE_LEAST_BEND)) = least;
            }
            cells += cells;
        }
    }
    return INT64_C(0);
}

/* The largest lever of each node and all beyond it: by how much the gap there would change with the roll
 * of a wheelset at zero roll, if wheel and rail were parallel there.
 */
static inline int64_t prepare_scan__write_levers(array_double_1d tables, int64_t scan, int64_t count)
{
    double largest;
    int64_t i;
    int64_t node;
    double width;
    int64_t k;
    double y;
    double z;
    double slope;
    largest = -prepare_scan__FAR;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        node = scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (count - INT64_C(1) - i);
        width = 0.0;
        if (i > INT64_C(0))
        {
            width = (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (count - i) + layout__SCAN_NODE_Y)) - (*cspan_at(&tables, node + layout__SCAN_NODE_Y));
        }
        for (k = INT64_C(0); k < prepare_scan__LAST_SAMPLE; k += INT64_C(1))
        {
            y = (*cspan_at(&tables, node + layout__SCAN_NODE_Y)) + width * ((double)(k) / (double)(prepare_scan__LAST_SAMPLE));
            profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
            largest = double_max(2, largest, (-slope) * ((*cspan_at(&tables, layout__TABLES_RADIUS)) + z) - ((*cspan_at(&tables, layout__TABLES_ARM)) + y));
        }
        (*cspan_at(&tables, node + layout__SCAN_NODE_LEVER)) = largest;
    }
    return INT64_C(0);
}

/* Bounds of the rail's raster.
 *
 * A stretch starts in a raster cell and is as long as 1, 2, 4 ... FINE_STEPs of the
 * wheel, stretched by WIDEST.
 */
static inline int64_t prepare_scan__write_rail_bounds(array_double_1d tables, int64_t scan, array_double_1d work, int64_t scratch)
{
    int64_t rail;
    int64_t i_end;
    int64_t i;
    int64_t cell;
    double edge;
    double least;
    double most;
    double steepest;
    double cells;
    int64_t exponent;
    double length;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    i_end = (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        cell = scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL))) + layout__RAIL_CELL_SIZE * i;
        edge = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START)) + prepare_scan__FINE_STEP * (double)(i);
        prepare_scan__bend_range(&least, &most, &steepest, tables, rail, work, scratch, edge - prepare_scan__FINE_STEP, edge + prepare_scan__FINE_STEP + 1.5 * prepare_scan__COARSE_STEP);
        (*cspan_at(&tables, cell + layout__RAIL_CELL_LEAST_BEND)) = least;
        (*cspan_at(&tables, cell + layout__RAIL_CELL_MOST_BEND)) = most;
        cells = 1.0;
        for (exponent = INT64_C(0); exponent < layout__EXPONENTS + INT64_C(1); exponent += INT64_C(1))
        {
            length = prepare_scan__FINE_STEP * (1.01 + (1.0 + bounds__WIDEST) * 1.01 * cells);
            prepare_scan__bend_range(&least, &most, &steepest, tables, rail, work, scratch, edge - 0.01 * prepare_scan__FINE_STEP, edge + length);
            (*cspan_at(&tables, cell + layout__RAIL_CELL_LEAST_BENDS + exponent)) = least;
            cells += cells;
        }
    }
    return INT64_C(0);
}

/* The raster over wheel and rail, where the settings say that it begins; the offset after
 * it, or TOO_WIDE or FULL.
 */
static inline int64_t prepare_scan__write_scan(array_double_1d tables, array_double_1d work, int64_t scratch)
{
    int64_t scan;
    int64_t wheel;
    int64_t rail;
    int64_t pieces;
    int64_t firsts;
    int64_t count;
    int64_t bins;
    int64_t cells;
    int64_t end;
    double least;
    double most;
    double steepest;
    int64_t i;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    pieces = int64_t_max(2, prepare_scan__piece_count(tables, wheel), prepare_scan__piece_count(tables, rail));
    firsts = scratch + INT64_C(3) * pieces;
    prepare_scan__sample_pieces(tables, wheel, work, scratch);
    count = prepare_scan__write_raster(tables, scan, work, scratch, firsts);
    if (count < INT64_C(0))
    {
        return count;
    }
    bins = prepare_scan__coarse_count((*cspan_at(&tables, wheel + layout__PROFILE_START)), (*cspan_at(&tables, wheel + layout__PROFILE_STOP)));
    cells = (int64_t)((int64_t)ceil(((*cspan_at(&tables, rail + layout__PROFILE_STOP)) - (*cspan_at(&tables, rail + layout__PROFILE_START))) / prepare_scan__FINE_STEP));
    (*cspan_at(&tables, scan + layout__SCAN_COUNT)) = (double)(count);
    (*cspan_at(&tables, scan + layout__SCAN_RAIL_COUNT)) = (double)(cells);
    (*cspan_at(&tables, scan + layout__SCAN_RAIL_START)) = (*cspan_at(&tables, rail + layout__PROFILE_START));
    (*cspan_at(&tables, scan + layout__SCAN_RAIL_PER_METRE)) = 1.0 / prepare_scan__FINE_STEP;
    (*cspan_at(&tables, scan + layout__SCAN_RAIL)) = (double)(scan + layout__SCAN_NODES - scan + layout__SCAN_NODE_SIZE * count);
    (*cspan_at(&tables, scan + layout__SCAN_BINS)) = (double)(scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL))) - scan + layout__RAIL_CELL_SIZE * cells);
    (*cspan_at(&tables, scan + layout__SCAN_BIN_COUNT)) = (double)(bins);
    (*cspan_at(&tables, scan + layout__SCAN_BINS_PER_METRE)) = (double)(bins) / ((*cspan_at(&tables, wheel + layout__PROFILE_STOP)) - (*cspan_at(&tables, wheel + layout__PROFILE_START)));
    end = scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_BINS))) + bins;
    if (end > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    prepare_scan__write_wheel_bounds(tables, scan, count, work, scratch);
    prepare_scan__write_levers(tables, scan, count);
    prepare_scan__bend_range(&least, &most, &steepest, tables, wheel, work, scratch, (*cspan_at(&tables, wheel + layout__PROFILE_START)), (*cspan_at(&tables, wheel + layout__PROFILE_STOP)));
    (*cspan_at(&tables, scan + layout__SCAN_STEEPEST)) = steepest;
    prepare_scan__sample_pieces(tables, rail, work, scratch);
    prepare_scan__write_rail_bounds(tables, scan, work, scratch);
    for (i = INT64_C(0); i < bins; i += INT64_C(1))
    {
        (*cspan_at(&tables, scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_BINS))) + i)) = (*cspan_at(&work, firsts + i));
    }
    return end;
}
