/* Generated from tangent_arc_length.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of arc_length.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ARC_LENGTH_H
#define WRCONTACT_KERNEL_TANGENT_ARC_LENGTH_H

#include "../native/spans.h"
#include "arc_length.h"
#include "curves.h"
#include "layout.h"
#include "profile_table.h"
#include "tangent_cubic_table.h"
#include "tangent_curves.h"

static inline int64_t tangent_arc_length__panel_length_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double low, double low_t, double high, double high_t);
static inline int64_t tangent_arc_length__arc_length_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_arc_length__rail_length_t(double* result_0, double* result_1, array_double_1d tables, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_arc_length__rail_abscissa_t(double* x, double* x_t, array_double_1d tables, double start, double start_t, double length, double length_t);

#endif
