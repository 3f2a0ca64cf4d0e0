/* Generated from normal/strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * How strips displace each other: Phi of eq. (S2), with the mean over the width close by, eq. (S4).
 */

#ifndef WRCONTACT_KERNEL_STRIP_INFLUENCE_H
#define WRCONTACT_KERNEL_STRIP_INFLUENCE_H

#include "../native/spans.h"
#include "layout.h"

static inline double strip_influence__nearness(double distance, double half_length);
static inline double strip_influence__apartness(double x, double half_length);
static inline int64_t strip_influence__cell_at(double place, int64_t count);
static inline double strip_influence__influence_at(array_double_1d tables, int64_t table, int64_t first, double u, double v);
static inline double strip_influence__middle_influence(array_double_1d tables, int64_t table, int64_t first, double u);
static inline double strip_influence__mean_at(array_double_1d tables, array_double_1d work, int64_t table, int64_t strip, double distance, double v);
static inline int64_t strip_influence__begin_influences(array_double_1d work);
static inline int64_t strip_influence__fill_column(array_double_1d tables, array_double_1d work, int64_t table, int64_t j, int64_t yawed);
static inline int64_t strip_influence__know_influences(array_double_1d tables, array_double_1d work, int64_t table, int64_t yawed);
static inline double strip_influence__far_displacement(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double x, int64_t first, int64_t last);
static inline double strip_influence__end_displacement(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double away);

#endif
