/* Generated from normal/strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * How strips displace each other's middle lines: Phi of eq. (S2), with the mean over the width close by, eq.
 * (S4).
 */

#ifndef WRCONTACT_KERNEL_STRIP_INFLUENCE_H
#define WRCONTACT_KERNEL_STRIP_INFLUENCE_H

#include "../native/spans.h"
#include "interaction.h"
#include "layout.h"

static inline int64_t strip_influence__measure_distances(array_double_1d work, int64_t i, int64_t others);
static inline double strip_influence__line_influence(array_double_1d tables, int64_t table, double abscissa);
static inline double strip_influence__near_share(double share);
static inline int64_t strip_influence__turn_influences(array_double_1d work, int64_t count);
static inline int64_t strip_influence__fill_influences(array_double_1d tables, array_double_1d work, int64_t table);

#endif
