/* Generated from tangent_strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_surfaces.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_SURFACES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_SURFACES_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "strip_lengths.h"
#include "strip_surfaces.h"
#include "tangent_curves.h"
#include "tangent_hertz.h"
#include "tangent_locus.h"
#include "tangent_longitudinal_curvature.h"
#include "tangent_planes.h"
#include "tangent_profile_table.h"
#include "tangent_rails.h"
#include "tangent_rates.h"
#include "tangent_separation.h"
#include "tangent_strip_layout.h"
#include "tangent_strip_lengths.h"
#include "tangent_touching.h"
#include "tangent_traces.h"

static inline int64_t tangent_strip_surfaces__trace_strip_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t strip);
static inline int64_t tangent_strip_surfaces__trace_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count);
static inline int64_t tangent_strip_surfaces__place_on_middle_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_surfaces__incline_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_strip_surfaces__profile_within_t(double* z, double* z_t, array_double_1d tables, double y, double y_t);
static inline int64_t tangent_strip_surfaces__measure_ridge_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, int64_t strip, double away, double away_t);
static inline int64_t tangent_strip_surfaces__zone_curvature_t(double* B, double* B_t, double depth, double depth_t, double width, double width_t, double A, double A_t);
static inline int64_t tangent_strip_surfaces__ridge_slant_t(double* slant, double* slant_t, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_strip_surfaces__first_length_t(array_double_1d work, array_double_1d work_t, int64_t strip, double depth, double depth_t, double one_alpha, double one_alpha_t, double one_beta, double one_beta_t);
static inline int64_t tangent_strip_surfaces__first_lengths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count);
static inline int64_t tangent_strip_surfaces__lengths_before_t(array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_strip_surfaces__set_gaps_t(array_double_1d work, array_double_1d work_t);

#endif
