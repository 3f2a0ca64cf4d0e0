/* Generated from tangent_leaning.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of leaning.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_LEANING_H
#define WRCONTACT_KERNEL_TANGENT_LEANING_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_leaning__set_reference_t(array_double_1d work, array_double_1d work_t, double height, double height_t);

#endif
