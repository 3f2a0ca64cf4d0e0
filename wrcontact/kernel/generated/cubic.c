/* Generated from surface/cubic.py by tools/transpile_kernel.py; change that one.
 *
 * A cubic through four evenly spaced values.
 */

#include "cubic.h"

/* The cubic through values at -1, 0, 1, 2, at x. */
static inline double cubic__cubic_through(double before, double low, double high, double after, double x)
{
    double bend;
    double third;
    bend = 0.5 * (before - 2.0 * low + high);
    third = (after - 3.0 * high + 3.0 * low - before) / 6.0;
    return low + x * (high - low + (x - 1.0) * (bend + (x + 1.0) * third));
}
