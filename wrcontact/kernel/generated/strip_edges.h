/* Generated from normal/strip_edges.py by tools/transpile_kernel.py; change that one.
 *
 * Edges of the patches that loaded strips form.
 *
 * Near the edge of a patch the line load falls to zero in proportion to the distance, so the edge is where the
 * straight line through the line loads of the last two strips ends.
 */

#ifndef WRCONTACT_KERNEL_STRIP_EDGES_H
#define WRCONTACT_KERNEL_STRIP_EDGES_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t strip_edges__run_end(array_double_1d work, int64_t count, int64_t first);
static inline double strip_edges__run_edge(array_double_1d work, int64_t count, int64_t last, int64_t first, int64_t outward);

#endif
