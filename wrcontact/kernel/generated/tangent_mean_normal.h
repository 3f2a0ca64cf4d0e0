/* Generated from tangent_mean_normal.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of mean_normal.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_MEAN_NORMAL_H
#define WRCONTACT_KERNEL_TANGENT_MEAN_NORMAL_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_cubic_table.h"
#include "tangent_profile_table.h"
#include "tangent_rails.h"
#include "tangent_rates.h"

static inline int64_t tangent_mean_normal__mean_normal_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t nodes, double local_penetration, double local_penetration_t);

#endif
