/* Generated from prepare/arcs.py by tools/transpile_kernel.py; change that one.
 *
 * Tables of the rail's arc length over its abscissa, and of the abscissa over the arc length.
 *
 * Cubics of Hermite over even cells: value and slope at the ends of a cell are exact.
 */

#include "prepare_arcs.h"

/* A table of cubics over ``length`` [m] from ``start`` [m] on, at ``base``; its number of cells and the
 * offset after it, or FULL.
 */
static inline int64_t prepare_arcs__open_table(int64_t* cells, int64_t* result_1, array_double_1d tables, int64_t base, double start, double length)
{
    int64_t table;
    int64_t end;
    (*cells) = (int64_t)((int64_t)ceil(length / prepare_arcs__ARC_STEP));
    table = base;
    end = table + layout__CUBIC_TABLE_CELLS + layout__CUBIC_SIZE * (*cells);
    if (end > (int64_t)tables.shape[INT64_C(0)])
    {
        (*result_1) = prepare_pieces__FULL;
        return 0;
    }
    (*cspan_at(&tables, table + layout__CUBIC_TABLE_COUNT)) = (double)((*cells));
    (*cspan_at(&tables, table + layout__CUBIC_TABLE_START)) = start;
    (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)) = (double)((*cells)) / length;
    (*result_1) = end;
    return 0;
}

/* Cell ``cell`` of the table at ``base``, with these values at its ends, and slopes per cell. */
static inline int64_t prepare_arcs__write_cubic(array_double_1d tables, int64_t base, int64_t cell, double low, double high, double low_rise, double high_rise)
{
    int64_t cubic;
    double rise;
    cubic = base + layout__CUBIC_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    rise = high - low;
    (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) = low;
    (*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) = low_rise;
    (*cspan_at(&tables, cubic + layout__CUBIC_BEND)) = 3.0 * rise - 2.0 * low_rise - high_rise;
    (*cspan_at(&tables, cubic + layout__CUBIC_THIRD)) = low_rise + high_rise - 2.0 * rise;
    return INT64_C(0);
}

/* Arc length per abscissa of the rail [-]. */
static inline double prepare_arcs__rail_speed(array_double_1d tables, int64_t rail, double abscissa)
{
    double height;
    double slope;
    profile_table__height_slope(&height, &slope, tables, rail, abscissa);
    return sqrt(1.0 + slope * slope);
}

/* The arc length of the rail over its abscissa, at ``base``; the offset after it, or FULL. */
static inline int64_t prepare_arcs__write_arcs(array_double_1d tables, int64_t base, int64_t rail, array_double_1d work, int64_t scratch)
{
    double start;
    double width;
    int64_t cells;
    int64_t end;
    double total;
    double step;
    double low;
    double low_rise;
    int64_t cell;
    double x;
    double high;
    double high_rise;
    start = (*cspan_at(&tables, rail + layout__PROFILE_START));
    width = (*cspan_at(&tables, rail + layout__PROFILE_STOP)) - start;
    prepare_arcs__open_table(&cells, &end, tables, base, start, width);
    if (end == prepare_pieces__FULL)
    {
        return prepare_pieces__FULL;
    }
    total = prepare_curvatures__write_lengths(tables, rail, work, scratch);
    step = width / (double)(cells);
    low = 0.0;
    low_rise = step * prepare_arcs__rail_speed(tables, rail, start);
    for (cell = INT64_C(0); cell < cells; cell += INT64_C(1))
    {
        x = start + step * (double)(cell + INT64_C(1));
        high = total;
        if (cell + INT64_C(1) < cells)
        {
            high = prepare_curvatures__arc_length(tables, rail, x, work, scratch);
        }
        high_rise = step * prepare_arcs__rail_speed(tables, rail, x);
        prepare_arcs__write_cubic(tables, base, cell, low, high, low_rise, high_rise);
        low = high;
        low_rise = high_rise;
    }
    return end;
}

/* The abscissa of the rail over its arc length, at ``base``; the offset after it, or FULL. */
static inline int64_t prepare_arcs__write_abscissae(array_double_1d tables, int64_t base, int64_t rail, array_double_1d work, int64_t scratch)
{
    double start;
    double total;
    int64_t cells;
    int64_t end;
    double step;
    double low;
    double low_rise;
    int64_t cell;
    double high;
    double high_rise;
    start = (*cspan_at(&tables, rail + layout__PROFILE_START));
    total = prepare_curvatures__write_lengths(tables, rail, work, scratch);
    prepare_arcs__open_table(&cells, &end, tables, base, 0.0, total);
    if (end == prepare_pieces__FULL)
    {
        return prepare_pieces__FULL;
    }
    step = total / (double)(cells);
    low = start;
    low_rise = step / prepare_arcs__rail_speed(tables, rail, start);
    for (cell = INT64_C(0); cell < cells; cell += INT64_C(1))
    {
        high = (*cspan_at(&tables, rail + layout__PROFILE_STOP));
        if (cell + INT64_C(1) < cells)
        {
            high = prepare_curvatures__place_at_length(tables, rail, step * (double)(cell + INT64_C(1)), work, scratch);
        }
        high_rise = step / prepare_arcs__rail_speed(tables, rail, high);
        prepare_arcs__write_cubic(tables, base, cell, low, high, low_rise, high_rise);
        low = high;
        low_rise = high_rise;
    }
    return end;
}
