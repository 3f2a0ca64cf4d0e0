/* Generated from tangent_elimination.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of elimination.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ELIMINATION_H
#define WRCONTACT_KERNEL_TANGENT_ELIMINATION_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_elimination__eliminate_t(array_double_1d work, array_double_1d work_t, int64_t size);

#endif
