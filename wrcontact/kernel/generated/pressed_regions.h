/* Generated from contact/pressed_regions.py by tools/transpile_kernel.py; change that one.
 *
 * The regions of a pressed wheel, from its overlaps: each has a frame of its own at its deepest point.
 */

#ifndef WRCONTACT_KERNEL_PRESSED_REGIONS_H
#define WRCONTACT_KERNEL_PRESSED_REGIONS_H

#include "../native/spans.h"
#include "arc_length.h"
#include "contact_plane.h"
#include "deep_points.h"
#include "layout.h"
#include "locus.h"
#include "overlaps.h"
#include "planes.h"
#include "pressed.h"
#include "profile_table.h"
#include "regions.h"
#include "traces.h"

static OUT_OF_LINE int64_t pressed_regions__touching_shift(double* result_0, double* result_1, array_double_1d work, array_double_1d tables, int64_t place, int64_t point);
static OUT_OF_LINE int64_t pressed_regions__press_frame(array_double_1d work, double height, double depth, double gap);
static OUT_OF_LINE int64_t pressed_regions__sink_wheel(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double penetration);
static OUT_OF_LINE int64_t pressed_regions__sink_deeper(array_double_1d work, int64_t count, double penetration);
static OUT_OF_LINE int64_t pressed_regions__open_pressed_region(array_double_1d work, array_double_1d tables, int64_t region, int64_t point);
static OUT_OF_LINE int64_t pressed_regions__give_own_frame(array_double_1d work, array_double_1d tables, int64_t region, int64_t point);
static OUT_OF_LINE int64_t pressed_regions__gather_overlaps(array_double_1d work, array_double_1d tables, array_double_1d state);

#endif
