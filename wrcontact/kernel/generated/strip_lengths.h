/* Generated from normal/strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Half-lengths and middles of the strips from what they displace near their ends; eqs. (S6)-(S8).
 */

#ifndef WRCONTACT_KERNEL_STRIP_LENGTHS_H
#define WRCONTACT_KERNEL_STRIP_LENGTHS_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_influence.h"

static const double strip_lengths__TESTED = 0.9;
static const double strip_lengths__FIRST_POWER = 0.6;
static const double strip_lengths__POWER = 0.53;
static const double strip_lengths__MOVED = 0.6;
static const double strip_lengths__FARTHEST_MOVE = 0.3;
static const double strip_lengths__FLATTEST = 0.1;
static const double strip_lengths__LIGHT = 0.02;
static const double strip_lengths__SHORTEST = 0.1;
static const double strip_lengths__SQUARE = 0.5;

static inline double strip_lengths__gap_beside(array_double_1d work, int64_t strip, double x);
static inline double strip_lengths__corrected(double ratio, double power);
static inline double strip_lengths__correct_strip(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double penetration, double power, int64_t yawed);
static inline double strip_lengths__neighbouring_length(array_double_1d work, int64_t count, int64_t i);
static inline int64_t strip_lengths__correct_lengths(array_double_1d work, array_double_1d tables, double penetration, double power, int64_t yawed);
static inline int64_t strip_lengths__limit_lengths(array_double_1d work, int64_t count);
static inline int64_t strip_lengths__adopt_lengths(array_double_1d work);

#endif
