/* Generated from search/starts.py by tools/transpile_kernel.py; change that one.
 *
 * Where the roll search starts without a near pose before: contacts without yaw,
 * known for a row of lateral shifts.
 *
 * A start sets the cost and never the answer, which is certified.
 */

#include "starts.h"

/* The row of the table that is nearest to the lateral ``shift`` [m]; -1 if nothing is known there. */
static inline int64_t starts__nearest_start(array_double_1d tables, int64_t starts, double shift)
{
    double u;
    int64_t row;
    u = (shift - (*cspan_at(&tables, starts + layout__STARTS_FIRST_SHIFT))) * (*cspan_at(&tables, starts + layout__STARTS_PER_METRE)) + 0.5;
    if (!((u >= 0.0) && (u < (*cspan_at(&tables, starts + layout__STARTS_COUNT)))))
    {
        return -INT64_C(1);
    }
    row = (int64_t)(u);
    if (!((*cspan_at(&tables, starts + layout__STARTS_ROWS + layout__START_SIZE * row + layout__START_KNOWN)) == 1.0))
    {
        row = -INT64_C(1);
    }
    return row;
}
