/* Generated from tangent_rates.py by tools/transpile_kernel.py; change that one.
 *
 * How roots and sizes change: helpers of the differentiated kernel.
 */

#include "tangent_rates.h"

/* Rate of a square root whose argument changes by ``rate``; 0 where the root is 0. */
static inline double tangent_rates__root_rate(double root, double rate)
{
    double result;
    result = 0.0;
    if (root != 0.0)
    {
        result = 0.5 * rate / root;
    }
    return result;
}

/* Rate of abs(value). */
static inline double tangent_rates__size_rate(double value, double rate)
{
    double result;
    result = rate;
    if (value < 0.0)
    {
        result = -rate;
    }
    return result;
}

/* Rate of base ** exponent; 0 where the base is 0. */
static inline double tangent_rates__power_rate(double power, double base, double exponent, double rate)
{
    double result;
    result = 0.0;
    if (base != 0.0)
    {
        result = exponent * power / base * rate;
    }
    return result;
}
