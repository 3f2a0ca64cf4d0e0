/* Generated from wheelset/resultant.py by tools/transpile_kernel.py; change that one.
 *
 * The resultant of the contact forces on the wheelset, in the track's axes.
 *
 * The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left,
 * where a region's load acts: the rail's normal there, or the mean over the region where that is known
 * (mean_normal.py).  The moment is that about the wheelset's centre, which is the nominal radius above the
 * running circles.
 *
 * Forces are summed over regions and not over patches: a patch that reaches over the bound between two regions
 * has two normals and two points, one for each.  Load and moment of a region are those that its strips carry in
 * the solved patches.
 */

#ifndef WRCONTACT_KERNEL_RESULTANT_H
#define WRCONTACT_KERNEL_RESULTANT_H

#include "../native/spans.h"
#include "layout.h"
#include "profile_table.h"

static inline int64_t resultant__clear_resultant(array_double_1d work, int64_t resultant);
static inline int64_t resultant__add_region(array_double_1d tables, array_double_1d work, int64_t region, double mirror, int64_t resultant);
static inline int64_t resultant__write_resultant(array_double_1d work, array_double_1d tables, int64_t left, int64_t right);

#endif
