/* Generated from wheelset/resultant.py by tools/transpile_kernel.py; change that one.
 *
 * The resultant of the contact forces on the wheelset, in the track's axes.
 *
 * The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left,
 * where a region's load acts: the rail's normal there, or the mean over the region where that is known
 * (mean_normal.py).  The moment is that about the wheelset's centre, which is the nominal radius above the
 * running circles.
 *
 * Forces are summed over the parts of patches: a patch that reaches over the bound between two regions has two
 * normals and two points, one for each.  The force of a patch is the sum over its parts, that of a wheel the sum
 * over its patches, and that of the wheelset the sum over both wheels.
 */

#ifndef WRCONTACT_KERNEL_RESULTANT_H
#define WRCONTACT_KERNEL_RESULTANT_H

#include "../native/spans.h"
#include "arc_length.h"
#include "layout.h"
#include "profile_table.h"
#include "rails.h"

static inline int64_t resultant__clear_resultant(array_double_1d work, int64_t resultant);
static inline int64_t resultant__clear_force(array_double_1d work, int64_t patch);
static inline int64_t resultant__add_part_force(array_double_1d work, array_double_1d tables, int64_t block, int64_t part, int64_t patch, double mirror, int64_t resultant);
static inline int64_t resultant__finish_force(array_double_1d work, int64_t patch, double mirror);
static inline int64_t resultant__add_patches(array_double_1d work, array_double_1d tables, double penetration, double mirror, int64_t resultant);
static inline int64_t resultant__write_resultant(array_double_1d work, array_double_1d tables, int64_t left, int64_t right);

#endif
