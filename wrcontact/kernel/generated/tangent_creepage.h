/* Generated from tangent_creepage.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of creepage.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CREEPAGE_H
#define WRCONTACT_KERNEL_TANGENT_CREEPAGE_H

#include "../native/spans.h"
#include "creepage.h"
#include "layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_creepage__write_creepage_t(array_double_1d work, array_double_1d work_t, int64_t rail, int64_t patch, double mirror, double mirror_t);
static inline int64_t tangent_creepage__write_side_creepages_t(array_double_1d work, array_double_1d work_t, int64_t rail, int64_t side, double mirror, double mirror_t);

#endif
