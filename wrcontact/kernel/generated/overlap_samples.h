/* Generated from contact/overlap_samples.py by tools/transpile_kernel.py; change that one.
 *
 * Samples of the overlap of a pressed wheel at the scan nodes where the wheel is below the rail.
 *
 * The overlap is taken straight down there and converted to the rail's normal.
 */

#ifndef WRCONTACT_KERNEL_OVERLAP_SAMPLES_H
#define WRCONTACT_KERNEL_OVERLAP_SAMPLES_H

#include "../native/spans.h"
#include "bounds.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static OUT_OF_LINE int64_t overlap_samples__sample_overlap(double* gap, double* result_1, double* abscissa, array_double_1d work, array_double_1d tables, int64_t place, int64_t node, double height, int64_t entry);
static OUT_OF_LINE int64_t overlap_samples__sample_end(array_double_1d work, array_double_1d tables, int64_t direction, int64_t entry);
static OUT_OF_LINE int64_t overlap_samples__walk_overlap(array_double_1d work, array_double_1d tables, int64_t place, array_double_1d state, int64_t node, int64_t direction, double height, int64_t first);

#endif
