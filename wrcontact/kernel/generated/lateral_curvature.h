/* Generated from surface/lateral_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Lateral curvatures of wheel and rail profile, prepared once (prepare_curvatures.py) and read off along them.
 *
 * Table at ``base``: count of values, start [m], values per metre, then the curvatures [1/m] at even distances, positive where
 * the profile bulges towards the other body.
 */

#ifndef WRCONTACT_KERNEL_LATERAL_CURVATURE_H
#define WRCONTACT_KERNEL_LATERAL_CURVATURE_H

#include "../native/spans.h"
#include "layout.h"

static const int64_t lateral_curvature__CURVATURE_COUNT = INT64_C(0);
static const int64_t lateral_curvature__CURVATURE_START = INT64_C(1);
static const int64_t lateral_curvature__CURVATURE_PER_METRE = INT64_C(2);
static const int64_t lateral_curvature__CURVATURES = INT64_C(3);

static inline double lateral_curvature__profile_curvature(array_double_1d tables, int64_t base, double y);
static inline double lateral_curvature__relative_curvature(array_double_1d tables, double y, double abscissa);

#endif
