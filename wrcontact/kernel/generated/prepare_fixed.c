/* Generated from prepare/fixed.py by tools/transpile_kernel.py; change that one.
 *
 * Tables that do not depend on the profiles, from the array ``fixed`` (binding/fixed_tables.py).
 *
 * It begins with the sizes of its tables: Hertz's, that of influences, and that of rolling for all Poisson's
 * ratios (binding/rolling_table.py).  The tables follow one after the other.
 */

#include "prepare_fixed.h"

/* Where table ``index`` begins. */
static inline int64_t prepare_fixed__fixed_table(array_double_1d fixed, int64_t index)
{
    int64_t i;
    int64_t at;
    at = prepare_fixed__FIXED_COUNT;
    for (i = INT64_C(0); i < index; i += INT64_C(1))
    {
        at += (int64_t)((*cspan_at(&fixed, i)));
    }
    return at;
}

/* Copy table ``index`` to ``at``; the offset after it, or FULL. */
static inline int64_t prepare_fixed__append_fixed(array_double_1d tables, int64_t at, array_double_1d fixed, int64_t index)
{
    int64_t size;
    int64_t first;
    int64_t i;
    size = (int64_t)((*cspan_at(&fixed, index)));
    if (at + size > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    first = prepare_fixed__fixed_table(fixed, index);
    for (i = INT64_C(0); i < size; i += INT64_C(1))
    {
        (*cspan_at(&tables, at + i)) = (*cspan_at(&fixed, first + i));
    }
    return at + size;
}

/* Weights of the values at three nodes in the parabola through them at ``x``. */
static inline int64_t prepare_fixed__parabola_weights(double* result_0, double* result_1, double* result_2, double low, double middle, double high, double x)
{
    (*result_0) = (x - middle) * (x - high) / ((low - middle) * (low - high));
    (*result_1) = (x - low) * (x - high) / ((middle - low) * (middle - high));
    (*result_2) = (x - low) * (x - middle) / ((high - low) * (high - middle));
    return 0;
}

/* The table of rolling at ``at`` for a Poisson's ratio, which ``tables`` already point to; the offset
 * after it, or FULL.
 */
static inline int64_t prepare_fixed__append_rolling(array_double_1d tables, int64_t at, array_double_1d fixed, double poisson_ratio)
{
    int64_t first;
    int64_t i;
    if (at + layout__ROLLING_TABLE_SIZE > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    first = prepare_fixed__fixed_table(fixed, prepare_fixed__FIXED_ROLLING);
    for (i = INT64_C(0); i < layout__POINT_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))) + layout__ROLLING_TABLE_COSINES + i)) = (*cspan_at(&fixed, first + i));
        (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))) + layout__ROLLING_TABLE_SINES + i)) = (*cspan_at(&fixed, first + layout__POINT_LIMIT + i));
    }
    first = prepare_fixed__write_shapes(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), fixed, first + INT64_C(2) * layout__POINT_LIMIT, poisson_ratio);
    first = prepare_fixed__write_reaches(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), fixed, first, poisson_ratio);
    prepare_fixed__write_corrections(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), fixed, first, poisson_ratio);
    return at + layout__ROLLING_TABLE_SIZE;
}

/* The shapes, parabolas of Poisson's ratio, from ``first`` on; the place behind them. */
static inline int64_t prepare_fixed__write_shapes(array_double_1d tables, int64_t table, array_double_1d fixed, int64_t first, double poisson_ratio)
{
    int64_t size;
    double low;
    double middle;
    double high;
    int64_t i;
    size = layout__SHAPE_ROW * layout__SHAPE_CELLS;
    prepare_fixed__parabola_weights(&low, &middle, &high, prepare_fixed__LOW_RATIO, prepare_fixed__MIDDLE_RATIO, prepare_fixed__HIGH_RATIO, poisson_ratio);
    for (i = INT64_C(0); i < size; i += INT64_C(1))
    {
        (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + i)) = low * (*cspan_at(&fixed, first + i)) + middle * (*cspan_at(&fixed, first + size + i)) + high * (*cspan_at(&fixed, first + INT64_C(2) * size + i));
    }
    return first + INT64_C(3) * size;
}

/* The reaches, eq. (K5) of binding/reach_table.py, from ``first`` on; the place behind them. */
static inline int64_t prepare_fixed__write_reaches(array_double_1d tables, int64_t table, array_double_1d fixed, int64_t first, double poisson_ratio)
{
    int64_t size;
    int64_t i;
    double weight;
    size = layout__REACH_ROW * (layout__REACH_CELLS + INT64_C(1));
    for (i = INT64_C(0); i < size; i += INT64_C(1))
    {
        weight = poisson_ratio;
        if (pyc_modulo(py_floor_div_int64_t(i, INT64_C(4)), layout__REACH_COLUMNS) == INT64_C(0))
        {
            weight = poisson_ratio / (1.0 - poisson_ratio);
        }
        (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + i)) = (*cspan_at(&fixed, first + i)) + weight * (*cspan_at(&fixed, first + size + i));
    }
    return first + INT64_C(2) * size;
}

/* The corrections, parabolas of Poisson's ratio, from ``first`` on. */
static inline int64_t prepare_fixed__write_corrections(array_double_1d tables, int64_t table, array_double_1d fixed, int64_t first, double poisson_ratio)
{
    double ratio;
    int64_t i;
    double low;
    double middle;
    double high;
    int64_t at;
    ratio = poisson_ratio;
    if (ratio < prepare_fixed__FIRST_CORRECTION)
    {
        ratio = prepare_fixed__FIRST_CORRECTION;
    }
    if (ratio > prepare_fixed__THIRD_CORRECTION)
    {
        ratio = prepare_fixed__THIRD_CORRECTION;
    }
    for (i = INT64_C(0); i < layout__CORRECTION_RADII; i += INT64_C(1))
    {
        (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + i)) = (*cspan_at(&fixed, first + i));
    }
    prepare_fixed__parabola_weights(&low, &middle, &high, prepare_fixed__FIRST_CORRECTION, prepare_fixed__SECOND_CORRECTION, prepare_fixed__THIRD_CORRECTION, ratio);
    at = first + layout__CORRECTION_RADII;
    for (i = INT64_C(0); i < layout__CORRECTION_SCALES; i += INT64_C(1))
    {
        (*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + i)) = low * (*cspan_at(&fixed, at + i)) + middle * (*cspan_at(&fixed, at + layout__CORRECTION_SCALES + i)) + high * (*cspan_at(&fixed, at + INT64_C(2) * layout__CORRECTION_SCALES + i));
    }
    at += INT64_C(3) * layout__CORRECTION_SCALES;
    for (i = INT64_C(0); i < layout__CORRECTION_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&tables, table + layout__ROLLING_TABLE_CORRECTIONS + i)) = low * (*cspan_at(&fixed, at + i)) + middle * (*cspan_at(&fixed, at + layout__CORRECTION_SIZE + i)) + high * (*cspan_at(&fixed, at + INT64_C(2) * layout__CORRECTION_SIZE + i));
    }
    return INT64_C(0);
}
