/* Generated from contact/moves.py by tools/transpile_kernel.py; change that one.
 *
 * Moves along the two curves of :mod:`curves`: by arc length, by chords, or to a lateral coordinate.
 *
 * A move leaves the new abscissa in the frame's trace, and returns whether the curve reaches that far.
 */

#ifndef WRCONTACT_KERNEL_MOVES_H
#define WRCONTACT_KERNEL_MOVES_H

#include "../native/spans.h"
#include "arc_length.h"
#include "curves.h"
#include "layout.h"

static const double moves__MOVE_SHARP = 1e-13;
static const int64_t moves__MOVE_ITERATIONS = INT64_C(40);

static OUT_OF_LINE int64_t moves__move_arc(array_double_1d work, array_double_1d tables, int64_t curve, double length);
static OUT_OF_LINE int64_t moves__move_chord(array_double_1d work, array_double_1d tables, int64_t curve, double chord);
static OUT_OF_LINE int64_t moves__move_to_station(array_double_1d work, array_double_1d tables, int64_t curve, double station);
static OUT_OF_LINE int64_t moves__move_across(array_double_1d work, array_double_1d tables, double lateral);

#endif
