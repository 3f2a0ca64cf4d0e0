/* Generated from contact/zone_width.py by tools/transpile_kernel.py; change that one.
 *
 * How far the interpenetration of a region reaches to either side.
 */

#ifndef WRCONTACT_KERNEL_ZONE_WIDTH_H
#define WRCONTACT_KERNEL_ZONE_WIDTH_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "curves.h"
#include "layout.h"
#include "separation.h"
#include "traces.h"

static const double zone_width__TRACE_OF_WIDTH = 0.01;
static const double zone_width__WIDTH_TRACE = 5e-06;
static const int64_t zone_width__WIDTH_ITERATIONS = INT64_C(60);
static const double zone_width__HALVED_SHARP = 1e-09;
static const double zone_width__WIDTH_SHARP = 0.01;
static const double zone_width__PRESSED_SHARP = 1e-05;

static inline double zone_width__width_limit(array_double_1d work, int64_t region, double direction);
static inline double zone_width__width_tolerance(double estimate);
static inline double zone_width__zone_width(array_double_1d work, array_double_1d tables, int64_t region, array_double_1d state, double direction, double level, double estimate);

#endif
