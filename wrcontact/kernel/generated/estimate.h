/* Generated from normal/estimate.py by tools/transpile_kernel.py; change that one.
 *
 * First estimates of penetrations, from pose and force alone; they are smooth in both, and so is the
 * result.
 */

#ifndef WRCONTACT_KERNEL_ESTIMATE_H
#define WRCONTACT_KERNEL_ESTIMATE_H

#include "../native/spans.h"
#include "hertz.h"
#include "layout.h"
#include "node_coefficients.h"
#include "regions.h"
#include "widths.h"

static const double estimate__TYPICAL_RATIO = 2.0;
static const double estimate__CEILING = 1000.0;
static const double estimate__LEAST_SHARE = 0.1;

static inline double estimate__guess_penetration(double force, double A, double contact_modulus);
static inline double estimate__estimate_penetration(array_double_1d work, array_double_1d tables, array_double_1d state, double force);
static inline double estimate__first_penetration(array_double_1d work, array_double_1d tables, array_double_1d state, double force);
static inline int64_t estimate__start_penetrations(array_double_1d work, int64_t count, double penetration);

#endif
