/* Generated from tangent_moves.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of moves.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_MOVES_H
#define WRCONTACT_KERNEL_TANGENT_MOVES_H

#include "../native/spans.h"
#include "curves.h"
#include "layout.h"
#include "moves.h"
#include "tangent_arc_length.h"
#include "tangent_curves.h"
#include "tangent_rates.h"

static inline int64_t tangent_moves__arc_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double length, double length_t);
static inline int64_t tangent_moves__chord_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double chord, double chord_t);
static inline int64_t tangent_moves__move_to_station_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double station, double station_t);
static inline int64_t tangent_moves__across_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, double lateral, double lateral_t);

#endif
