/* Generated from contact/planes.py by tools/transpile_kernel.py; change that one.
 *
 * Frames that are set aside: every region of a pressed wheel beside the contact point's has its own, at its
 * deepest point.
 */

#ifndef WRCONTACT_KERNEL_PLANES_H
#define WRCONTACT_KERNEL_PLANES_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"

static OUT_OF_LINE int64_t planes__keep_frame(array_double_1d work, int64_t slot);
static OUT_OF_LINE int64_t planes__use_frame(array_double_1d work, int64_t slot);
static OUT_OF_LINE int64_t planes__locate_along_track(array_double_1d work, array_double_1d tables, int64_t count);
static OUT_OF_LINE int64_t planes__enter_plane(array_double_1d work, int64_t region, int64_t slot);
static OUT_OF_LINE int64_t planes__leave_plane(array_double_1d work, int64_t region);

#endif
