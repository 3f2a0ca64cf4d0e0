/* Generated from normal/widths.py by tools/transpile_kernel.py; change that one.
 *
 * How wide the interpenetration of a region is, and the lateral curvatures that follow from it.
 */

#ifndef WRCONTACT_KERNEL_WIDTHS_H
#define WRCONTACT_KERNEL_WIDTHS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "locus.h"
#include "zone_width.h"

static const double widths__NARROWER = 4.0;
static const double widths__LEAST_BEND = 1.0;
static const double widths__MOST_BEND = 100.0;

static inline double widths__side_curvature(double reached, double own, double mean);
static inline int64_t widths__measure_widths(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, double local_penetration);

#endif
