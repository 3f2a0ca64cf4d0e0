/* Generated from tangent_longitudinal_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of longitudinal_curvature.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_LONGITUDINAL_CURVATURE_H
#define WRCONTACT_KERNEL_TANGENT_LONGITUDINAL_CURVATURE_H

#include "../native/spans.h"
#include "layout.h"
#include "longitudinal_curvature.h"
#include "tangent_locus.h"
#include "tangent_rates.h"

static inline int64_t tangent_longitudinal_curvature__longitudinal_curvature_t(double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double z, double z_t, double slope, double slope_t, double bend, double bend_t);

#endif
