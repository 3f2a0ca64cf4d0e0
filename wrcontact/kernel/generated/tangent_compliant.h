/* Generated from tangent_compliant.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of compliant.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_COMPLIANT_H
#define WRCONTACT_KERNEL_TANGENT_COMPLIANT_H

#include "../native/spans.h"
#include "compliant.h"
#include "damping.h"
#include "layout.h"
#include "tangent_damping.h"
#include "tangent_side.h"
#include "tangent_totals.h"
#include "trial.h"

static inline int64_t tangent_compliant__load_at_height_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double height, double height_t);

#endif
