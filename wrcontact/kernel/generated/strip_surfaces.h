/* Generated from normal/strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * What wheel and rail are at each strip: overlap, inclination, ridge, and the gap beside it.
 */

#ifndef WRCONTACT_KERNEL_STRIP_SURFACES_H
#define WRCONTACT_KERNEL_STRIP_SURFACES_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "curves.h"
#include "hertz.h"
#include "layout.h"
#include "locus.h"
#include "longitudinal_curvature.h"
#include "planes.h"
#include "profile_table.h"
#include "rails.h"
#include "separation.h"
#include "strip_layout.h"
#include "strip_lengths.h"
#include "touching.h"
#include "traces.h"

static const double strip_surfaces__STRIP_TRACE = 1e-09;
static const double strip_surfaces__FLATTEST_ZONE = 0.02;
static const double strip_surfaces__SHARPEST_ZONE = 1000.0;
static const double strip_surfaces__INSIDE = 0.25;
static const double strip_surfaces__LEAST_OVERLAP = 0.05;
static const double strip_surfaces__FIRST_LEAD = 0.5;

static inline int64_t strip_surfaces__trace_strip(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t strip);
static inline int64_t strip_surfaces__trace_strips(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count);
static inline int64_t strip_surfaces__place_on_middle(array_double_1d work, int64_t count);
static inline int64_t strip_surfaces__incline_strips(array_double_1d work, array_double_1d tables);
static inline double strip_surfaces__profile_within(array_double_1d tables, double y);
static inline int64_t strip_surfaces__measure_ridge(array_double_1d work, array_double_1d tables, int64_t place, int64_t strip, double away);
static inline double strip_surfaces__zone_curvature(double depth, double width, double A);
static inline double strip_surfaces__ridge_slant(array_double_1d work, int64_t index);
static inline int64_t strip_surfaces__first_length(array_double_1d work, int64_t strip, double depth, double one_alpha, double one_beta);
static inline int64_t strip_surfaces__first_lengths(array_double_1d work, array_double_1d tables, int64_t count);
static inline int64_t strip_surfaces__lengths_before(array_double_1d work, array_double_1d tables);
static inline int64_t strip_surfaces__set_gaps(array_double_1d work);

#endif
