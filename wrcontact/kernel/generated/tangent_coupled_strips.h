/* Generated from tangent_coupled_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of coupled_strips.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_COUPLED_STRIPS_H
#define WRCONTACT_KERNEL_TANGENT_COUPLED_STRIPS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_correction.h"
#include "tangent_rates.h"
#include "tangent_slip_march.h"
#include "tangent_stick_zone.h"
#include "tangent_stiffness.h"
#include "tangent_tractions.h"

static inline int64_t tangent_coupled_strips__flexibilities_t(double* v4, double* result_1, double* v7, double* result_3, array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_coupled_strips__begin_march_t(array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip, double rate, double rate_t, int64_t index);
static inline int64_t tangent_coupled_strips__finish_marches_t(array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_coupled_strips__add_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);
static inline int64_t tangent_coupled_strips__solve_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);

#endif
