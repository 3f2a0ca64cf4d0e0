/* Generated from tangent_rates.py by tools/transpile_kernel.py; change that one.
 *
 * How roots and sizes change: helpers of the differentiated kernel.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_RATES_H
#define WRCONTACT_KERNEL_TANGENT_RATES_H

#include "../native/spans.h"

static inline double tangent_rates__root_rate(double root, double rate);
static inline double tangent_rates__size_rate(double value, double rate);
static inline double tangent_rates__power_rate(double power, double base, double exponent, double rate);

#endif
