/* Generated from tangent_widths.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of widths.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_WIDTHS_H
#define WRCONTACT_KERNEL_TANGENT_WIDTHS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_rates.h"
#include "tangent_zone_width.h"
#include "widths.h"

static inline int64_t tangent_widths__side_curvature_t(double* curvature, double* curvature_t, double reached, double reached_t, double own, double own_t, double mean, double mean_t);
static inline int64_t tangent_widths__measure_widths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, double local_penetration, double local_penetration_t);

#endif
