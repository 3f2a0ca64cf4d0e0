/* Generated from tangent_creep_forces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of creep_forces.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CREEP_FORCES_H
#define WRCONTACT_KERNEL_TANGENT_CREEP_FORCES_H

#include "../native/spans.h"
#include "creepage.h"
#include "layout.h"
#include "outlines.h"
#include "tangent_creepage.h"
#include "tangent_friction.h"
#include "tangent_rates.h"
#include "tangent_tangential_contact.h"
#include "tangent_wear_outline.h"

static inline int64_t tangent_creep_forces__set_load_t(array_double_1d work, array_double_1d work_t, int64_t patch, double load, double load_t);
static inline int64_t tangent_creep_forces__open_rolling_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t patch, int64_t to, double mirror, double mirror_t, double friction, double friction_t);
static inline int64_t tangent_creep_forces__write_creep_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t to, double mirror, double mirror_t, double limit, double limit_t);
static inline int64_t tangent_creep_forces__add_creep_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t to, double mirror, double mirror_t);
static inline int64_t tangent_creep_forces__write_side_wear_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_creep_forces__write_side_creep_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, double friction, double friction_t);
static inline int64_t tangent_creep_forces__write_creep_forces_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t);

#endif
