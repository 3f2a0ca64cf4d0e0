/* Generated from normal/strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Half-lengths of the strips from their line loads; eqs. (S6)-(S9).
 */

#ifndef WRCONTACT_KERNEL_STRIP_LENGTHS_H
#define WRCONTACT_KERNEL_STRIP_LENGTHS_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_surfaces.h"

static inline int64_t strip_lengths__correct_lengths(array_double_1d work, array_double_1d tables);
static inline int64_t strip_lengths__adopt_lengths(array_double_1d work);

#endif
