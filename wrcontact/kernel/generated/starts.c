/* Generated from search/starts.py by tools/transpile_kernel.py; change that one.
 *
 * Where the roll search starts without a near pose before: contacts without yaw, known for a row of lateral shifts.
 *
 * A start sets the cost and never the answer, which is certified.
 */

#include "starts.h"

/* Offset in ``tables`` of the row nearest to the lateral ``shift`` [m]; -1 if nothing is known there. */
static inline int64_t starts__nearest_start(array_double_1d tables, double shift)
{
    int64_t base;
    double u;
    int64_t row;
    base = (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS)));
    u = (shift - (*cspan_at(&tables, base + starts__START_FIRST))) * (*cspan_at(&tables, base + starts__START_PER_METRE)) + 0.5;
    if (!((u >= 0.0) && (u < (*cspan_at(&tables, base + starts__START_COUNT)))))
    {
        return -INT64_C(1);
    }
    row = base + starts__START_ROWS + starts__START_ROW * (int64_t)(u);
    if ((*cspan_at(&tables, row + starts__START_KNOWN)) == 0.0)
    {
        row = -INT64_C(1);
    }
    return row;
}
