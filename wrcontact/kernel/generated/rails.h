/* Generated from surface/rails.py by tools/transpile_kernel.py; change that one.
 *
 * Rails that are moved from their nominal place.
 *
 * Seen from its rail the wheelset moves the other way. Search and contact therefore work in the frame that moves
 * with the rail, in which the rail is in its nominal place; only what is reported is taken back to the track.
 *
 * A rail rolls about its highest point in its nominal place, after it was displaced. In its frame the wheelset's
 * axle has another yaw and roll, its centre is elsewhere, and down is not the frame's vertical: how far the
 * wheelset has come down moves it sideways too. A place therefore holds for one vertical shift, its
 * ``reference``; the frame's vertical gap is the way down from there to first order only, and where the gap is
 * sought, the reference follows it (wheelset/leaning.py).
 */

#ifndef WRCONTACT_KERNEL_RAILS_H
#define WRCONTACT_KERNEL_RAILS_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"

static inline int64_t rails__move_rail(array_double_1d work, int64_t place, double lateral, double vertical);
static inline int64_t rails__lean_rail(array_double_1d work, int64_t place, double rail_y, double angle);
static inline int64_t rails__turn_leaning(array_double_1d work, int64_t place);
static inline int64_t rails__pitch_of_frame(double* sine, double* cosine, array_double_1d work, int64_t place);
static inline double rails__upright_share(array_double_1d work, int64_t place, double cosine, double sine);
static inline int64_t rails__on_track(double* result_0, double* result_1, array_double_1d work, int64_t place, double rail_y, double y, double z);

#endif
