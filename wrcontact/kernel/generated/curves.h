/* Generated from contact/curves.py by tools/transpile_kernel.py; change that one.
 *
 * Rail and wheel as two curves across the track, each over its profile's abscissa, for separations measured
 * along them.
 *
 * The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
 * ``curve`` is RAIL or WHEEL, and its present abscissa is that of the frame's trace.  Coordinates are those from
 * the origin of the region.
 */

#ifndef WRCONTACT_KERNEL_CURVES_H
#define WRCONTACT_KERNEL_CURVES_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static OUT_OF_LINE int64_t curves__curve_profile(array_double_1d tables, int64_t curve);
static OUT_OF_LINE int64_t curves__curve_jet(double* across, double* down, double* slope, double* stretch, double* bend, array_double_1d work, array_double_1d tables, int64_t curve, double u);
static OUT_OF_LINE double curves__curve_speed(array_double_1d work, array_double_1d tables, int64_t curve, double u);
static OUT_OF_LINE double curves__within(array_double_1d tables, int64_t curve, double u);
static OUT_OF_LINE int64_t curves__open_curve(array_double_1d work, array_double_1d tables, int64_t curve, double u);
static OUT_OF_LINE int64_t curves__open_origin(array_double_1d work, array_double_1d tables, int64_t region, double spacing);

#endif
