/* Generated from tangent_touching.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of touching.py.
 */

#include "tangent_touching.h"

/* Tangent of ``limited``. */
static inline int64_t tangent_touching__limited_t(double* result_0, double* result_1, double step, double step_t, double limit, double limit_t)
{
    if (step > limit)
    {
        step_t = limit_t;
        step = limit;
    }
    if (step < -limit)
    {
        step_t = -limit_t;
        step = -limit;
    }
    (*result_0) = step;
    (*result_1) = step_t;
    return 0;
}
