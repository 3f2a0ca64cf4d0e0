/* Generated from tangent_cubic.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of cubic.py.
 */

#include "tangent_cubic.h"

/* Tangent of ``cubic_through``. */
static inline int64_t tangent_cubic__cubic_through_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double after, double after_t, double x, double x_t)
{
    double v1;
    double bend_t;
    double bend;
    double v2;
    double third_t;
    double third;
    double v3;
    double v4;
    double v5;
    double v6;
    v1 = before - 2.0 * low + high;
    bend_t = 0.5 * (before_t - 2.0 * low_t + high_t);
    bend = 0.5 * v1;
    v2 = after - 3.0 * high + 3.0 * low - before;
    third_t = (after_t - 3.0 * high_t + 3.0 * low_t - before_t) / 6.0;
    third = v2 / 6.0;
    v3 = x - 1.0;
    v4 = x + 1.0;
    v5 = bend + v4 * third;
    v6 = high - low + v3 * v5;
    (*result_0) = low + x * v6;
    (*result_1) = low_t + (x_t * v6 + x * (high_t - low_t + (x_t * v5 + v3 * (bend_t + (x_t * third + v4 * third_t)))));
    return 0;
}
