/* Generated from tangent_resultant.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of resultant.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_RESULTANT_H
#define WRCONTACT_KERNEL_TANGENT_RESULTANT_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_arc_length.h"
#include "tangent_profile_table.h"
#include "tangent_rails.h"
#include "tangent_rates.h"

static inline int64_t tangent_resultant__clear_resultant_t(array_double_1d work, array_double_1d work_t, int64_t resultant);
static inline int64_t tangent_resultant__clear_force_t(array_double_1d work, array_double_1d work_t, int64_t patch);
static inline int64_t tangent_resultant__add_part_force_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t block, int64_t part, int64_t patch, double mirror, double mirror_t, int64_t resultant);
static inline int64_t tangent_resultant__finish_force_t(array_double_1d work, array_double_1d work_t, int64_t patch, double mirror, double mirror_t);
static inline int64_t tangent_resultant__add_patches_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, double penetration, double penetration_t, double mirror, double mirror_t, int64_t resultant);
static inline int64_t tangent_resultant__write_resultant_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t left, int64_t right);

#endif
