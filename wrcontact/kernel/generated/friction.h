/* Generated from wheelset/friction.py by tools/transpile_kernel.py; change that one.
 *
 * Friction in a patch: its coefficient, and how steeply the creep force begins.
 *
 *     mu = mu_side f(gamma) [(1 - A) exp(-B w) + A]                 Polach (2005)
 *     k  = k0 [alpha + (1 - alpha) / (1 + beta epsilon)]            Spiryagin, Polach, Cole (2013)
 *
 * with f from 1 on the tread to ``flange_friction_ratio`` on the flange over the contact angle gamma, the
 * sliding velocity w = V_ref sqrt(xi^2 + eta^2), and epsilon = G pi a b k0 C11 sqrt(xi^2 + (eta + phi a)^2) / (4
 * mu N). The flexibility of the contact is divided by k; as the models know it only beside the creepages, these
 * are multiplied by k.
 */

#ifndef WRCONTACT_KERNEL_FRICTION_H
#define WRCONTACT_KERNEL_FRICTION_H

#include "../native/spans.h"
#include "layout.h"
#include "shapes.h"

static const double friction__PI = 3.141592653589793;
static const double friction__FLANGE_RANGE = 0.2;

static inline double friction__flange_share(array_double_1d tables, double angle);
static inline double friction__patch_friction(array_double_1d tables, double friction, double angle, double sliding);
static inline int64_t friction__multiply_creepages(array_double_1d work, int64_t patch, double factor);
static inline int64_t friction__reduce_slope(array_double_1d work, array_double_1d tables, int64_t patch);
static inline int64_t friction__is_frictional(double friction, double limit);

#endif
