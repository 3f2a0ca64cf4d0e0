/* Generated from tangent_rails.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rails.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_RAILS_H
#define WRCONTACT_KERNEL_TANGENT_RAILS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_rates.h"

static inline int64_t tangent_rails__move_rail_t(array_double_1d work, array_double_1d work_t, int64_t place, double lateral, double lateral_t, double vertical, double vertical_t);
static inline int64_t tangent_rails__lean_rail_t(array_double_1d work, array_double_1d work_t, int64_t place, double rail_y, double rail_y_t, double angle, double angle_t);
static inline int64_t tangent_rails__turn_leaning_t(array_double_1d work, array_double_1d work_t, int64_t place);
static inline int64_t tangent_rails__pitch_of_frame_t(double* sine, double* sine_t, double* cosine, double* cosine_t, array_double_1d work, array_double_1d work_t, int64_t place);
static inline int64_t tangent_rails__upright_share_t(double* share, double* share_t, array_double_1d work, array_double_1d work_t, int64_t place, double cosine, double cosine_t, double sine, double sine_t);
static inline int64_t tangent_rails__on_track_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t place, double rail_y, double rail_y_t, double y, double y_t, double z, double z_t);

#endif
