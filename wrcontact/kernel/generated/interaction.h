/* Generated from normal/interaction.py by tools/transpile_kernel.py; change that one.
 *
 * How the regions of one side press on each other: one half-space, planes of their own (docs/method.md,
 * (8.4)).
 */

#ifndef WRCONTACT_KERNEL_INTERACTION_H
#define WRCONTACT_KERNEL_INTERACTION_H

#include "../native/spans.h"
#include "layout.h"

static const double interaction__ELONGATED = 0.3;
static const double interaction__INCLINED = 0.9659258262890683;

static inline double interaction__planes_cosine(array_double_1d work, int64_t one, int64_t other);
static inline double interaction__region_lead(array_double_1d work, int64_t one, int64_t other);
static inline double interaction__region_influence(array_double_1d work, array_double_1d tables, int64_t one, int64_t other);

#endif
