/* Generated from tangential/sections.py by tools/transpile_kernel.py; change that one.
 *
 * From a solved patch to the strips that roll: the patch cut along the rolling direction.
 *
 * The cuts are closer together near both ends of the patch, like Gauss-Chebyshev points:
 *
 *     e_k = middle - half cos(k pi / n),   k = 0 ... n                                            (C1)
 *
 * A strip has the mean of a^2 over its width as the square of its half-length, and the mean line load.  Both are
 * exact for an ellipse.  Between the strips of the normal model they follow straight lines, to zero at the
 * patch's edges.  The line loads are scaled so that they carry the load of the patch.
 *
 * All places are taken from the patch's centre of load, for which its creepages hold.  The middles of a yawed
 * wheel's strips lie on a slanted line through it.
 */

#ifndef WRCONTACT_KERNEL_SECTIONS_H
#define WRCONTACT_KERNEL_SECTIONS_H

#include "../native/spans.h"
#include "layout.h"

static const double sections__COSINE = 0.9807852804032304;
static const double sections__SHORTEST = 0.05;
static const double sections__LONGEST = 40.0;

static inline int64_t sections__describe_ellipse(array_double_1d work, int64_t totals, int64_t rolling);
static inline int64_t sections__lay_strips(array_double_1d work, int64_t rolling, double start, double stop);
static inline int64_t sections__cut_ellipse(array_double_1d work, int64_t totals, int64_t rolling);
static inline int64_t sections__add_piece(array_double_1d work, int64_t rolling, int64_t at, double low, double low_square, double low_load, double high, double high_square, double high_load);
static inline int64_t sections__cut_strips(array_double_1d work, int64_t patch, int64_t rolling);
static inline int64_t sections__finish_strips(array_double_1d work, int64_t rolling, double centroid, double slant);
static inline int64_t sections__plane_slips(array_double_1d work, int64_t rolling);
static inline int64_t sections__cut_patch(array_double_1d work, int64_t index, int64_t rolling);

#endif
