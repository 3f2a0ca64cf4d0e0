/* Generated from normal/mean_normal.py by tools/transpile_kernel.py; change that one.
 *
 * The direction along which the force of a region acts, where that is the mean of the rail's normals.
 */

#ifndef WRCONTACT_KERNEL_MEAN_NORMAL_H
#define WRCONTACT_KERNEL_MEAN_NORMAL_H

#include "../native/spans.h"
#include "cubic_table.h"
#include "layout.h"
#include "profile_table.h"
#include "rails.h"

static inline int64_t mean_normal__mean_normal(array_double_1d work, array_double_1d tables, int64_t region, int64_t nodes, double local_penetration);

#endif
