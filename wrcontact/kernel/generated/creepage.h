/* Generated from motion/creepage.py by tools/transpile_kernel.py; change that one.
 *
 * Creepages of the patches: how the wheel slides and turns on the rail, over the rolling speed.
 *
 * At a patch's centre of load P the wheel's surface has the velocity
 *
 *     v = (V, y', z') + W x (P - C) - w e2 x (P - C)
 *
 * with the velocity of the wheelset's centre C, its rotation W but for that about the axle, and its rotation w
 * about the axle e2, positive when it rolls forward.  With the normal n from the rail to the wheel and
 * y_c = n x e_x, which points to the left on both sides,
 *
 *     V_ref = (|V| + |w e2 x (P - C)|_x) / 2
 *     xi = v . e_x / V_ref,   eta = v . y_c / V_ref,   phi = (W - w e2) . n / V_ref
 *
 * The distance of P from the axle counts as the rolling radius there: an elastic wheel turns with the
 * circumference that it has when it carries nothing, however deep it is pressed.
 */

#ifndef WRCONTACT_KERNEL_CREEPAGE_H
#define WRCONTACT_KERNEL_CREEPAGE_H

#include "../native/spans.h"
#include "layout.h"

static const double creepage__STANDSTILL = 1e-06;

static inline int64_t creepage__rolling_velocity(double* result_0, double* result_1, double* result_2, array_double_1d work, double x, double y, double z, double radius);
static inline double creepage__velocity_along(array_double_1d work, double y, double z, double rolling_x);
static inline double creepage__reference_speed(array_double_1d work, double rolling_x);
static inline int64_t creepage__write_creepage(array_double_1d work, int64_t rail, int64_t patch, double mirror);
static inline int64_t creepage__write_side_creepages(array_double_1d work, int64_t rail, int64_t side, double mirror);
static inline double creepage__patch_speed(array_double_1d work, int64_t patch);

#endif
