/* Generated from tangent_strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_lengths.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_LENGTHS_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_LENGTHS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_rates.h"
#include "tangent_strip_surfaces.h"

static inline int64_t tangent_strip_lengths__correct_lengths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_strip_lengths__adopt_lengths_t(array_double_1d work, array_double_1d work_t);

#endif
