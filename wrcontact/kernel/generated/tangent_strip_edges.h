/* Generated from tangent_strip_edges.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_edges.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_EDGES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_EDGES_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_strip_edges__run_edge_t(double* edge, double* edge_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t last, int64_t first, int64_t outward);

#endif
