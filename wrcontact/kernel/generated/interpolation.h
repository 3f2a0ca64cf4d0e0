/* Generated from patch/interpolation.py by tools/transpile_kernel.py; change that one.
 *
 * Half-length and pressure of a solved patch between its strips, by the rule of the model that filled it.
 */

#ifndef WRCONTACT_KERNEL_INTERPOLATION_H
#define WRCONTACT_KERNEL_INTERPOLATION_H

#include "../native/spans.h"
#include "layout.h"
#include "quadrature.h"

static inline int64_t interpolation__between_strips(double* half_length, double* pressure, array_double_1d work, int64_t region, double own);
static inline int64_t interpolation__quadratic_at(double* half_length, double* pressure, array_double_1d work, int64_t count, double station);
static inline int64_t interpolation__straight_at(double* half_length, double* pressure, array_double_1d work, int64_t patch, int64_t after, double station);

#endif
