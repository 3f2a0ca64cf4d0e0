/* Generated from wheelset/wear_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Shear and slip over the outline of a wheel, for models of wear.
 *
 * Of a strip with the creep force F_i and the power P_i per width and the half-length a_i
 *
 *     shear = |F_i| / (2 a_i),   slip = P_i / |F_i|,   P_i = -V_ref (w_x F_x + eta F_y + phi M_z)
 *
 * so that shear times slip is the friction power per area, as the strip has it from its leading to its trailing
 * edge.  Elastic deformation takes and gives back power within a strip and is no part of P_i.  Between the
 * middles of strips both follow straight lines; a strip that would gain power counts as one that sticks.
 */

#ifndef WRCONTACT_KERNEL_WEAR_OUTLINE_H
#define WRCONTACT_KERNEL_WEAR_OUTLINE_H

#include "../native/spans.h"
#include "layout.h"

static inline double wear_outline__strip_shear(array_double_1d work, int64_t strip);
static inline double wear_outline__strip_slip(array_double_1d work, int64_t patch, int64_t strip);
static inline int64_t wear_outline__write_patch_wear(array_double_1d work, int64_t outline, int64_t stations, int64_t patch);
static inline int64_t wear_outline__write_wear(array_double_1d work, int64_t outline, int64_t stations, int64_t rolling);

#endif
