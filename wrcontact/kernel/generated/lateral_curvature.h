/* Generated from surface/lateral_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Lateral curvatures of wheel and rail profile, prepared once (prepare/curvatures.py) and read off along
 * them.
 */

#ifndef WRCONTACT_KERNEL_LATERAL_CURVATURE_H
#define WRCONTACT_KERNEL_LATERAL_CURVATURE_H

#include "../native/spans.h"
#include "layout.h"
#include "table_cell.h"

static inline double lateral_curvature__profile_curvature(array_double_1d tables, int64_t table, double y);
static inline double lateral_curvature__relative_curvature(array_double_1d tables, double y, double abscissa);

#endif
