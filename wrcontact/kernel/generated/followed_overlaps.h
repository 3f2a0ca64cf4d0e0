/* Generated from contact/followed_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Deepest points that are followed from one trial of an elastic wheelset to the next, which stands a few
 * micrometres away: a search for them costs as much as the rest of a trial.
 */

#ifndef WRCONTACT_KERNEL_FOLLOWED_OVERLAPS_H
#define WRCONTACT_KERNEL_FOLLOWED_OVERLAPS_H

#include "../native/spans.h"
#include "deep_points.h"
#include "layout.h"
#include "touching.h"

static const double followed_overlaps__FOLLOWED = 0.0005;

static inline int64_t followed_overlaps__keep_points(array_double_1d work, int64_t kept);
static inline int64_t followed_overlaps__follow_saddle(array_double_1d work, array_double_1d tables, int64_t place, int64_t point, int64_t following, double height);
static inline int64_t followed_overlaps__follow_overlaps(array_double_1d work, array_double_1d tables, int64_t kept, int64_t place, double height);

#endif
