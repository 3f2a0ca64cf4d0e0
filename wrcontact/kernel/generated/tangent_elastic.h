/* Generated from tangent_elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of elastic.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ELASTIC_H
#define WRCONTACT_KERNEL_TANGENT_ELASTIC_H

#include "../native/spans.h"
#include "elastic.h"
#include "layout.h"
#include "tangent_side.h"

static inline int64_t tangent_elastic__carry_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t, double height, double height_t);
static inline int64_t tangent_elastic__bear_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double height, double height_t);

#endif
