/* Generated from surface/longitudinal_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Curvature of the wheel along the track.
 */

#ifndef WRCONTACT_KERNEL_LONGITUDINAL_CURVATURE_H
#define WRCONTACT_KERNEL_LONGITUDINAL_CURVATURE_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"

static const double longitudinal_curvature__CURVATURE_FLOOR = 0.05;

static inline double longitudinal_curvature__longitudinal_curvature(array_double_1d work, array_double_1d tables, int64_t place, double z, double slope, double bend);

#endif
