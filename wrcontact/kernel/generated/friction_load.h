/* Generated from wheelset/friction_load.py by tools/transpile_kernel.py; change that one.
 *
 * Vertical loads of which friction carries a part.
 *
 * With ``load="vertical"`` a wheel's whole force, creep forces included, has the vertical component Q that is
 * prescribed.  The first solution leaves creep forces out; it has the component s Q.  Were all forces
 * proportional to the load, normal forces for the load Q / s would give Q: this is the second solution.  From
 * there on a secant through the last two finds the load of each wheel, with two or three more solutions: what is
 * left would otherwise show as noise in differences of the outputs.
 */

#ifndef WRCONTACT_KERNEL_FRICTION_LOAD_H
#define WRCONTACT_KERNEL_FRICTION_LOAD_H

#include "../native/spans.h"
#include "creep_forces.h"
#include "layout.h"

static const double friction_load__LOAD_MET = 1e-09;
static const double friction_load__LOAD_MISSED = 0.001;
static const int64_t friction_load__LOAD_PASSES = INT64_C(8);
static const int64_t friction_load__LOAD_RATES = INT64_C(6);
static const double friction_load__LARGEST_CHANGE = 2.0;
static const double friction_load__LEAST_CHANGE = 1e-12;

static inline int64_t friction_load__release_friction(array_double_1d work);
static inline int64_t friction_load__carries_friction(array_double_1d tables, array_double_1d work);
static inline double friction_load__carried_share(array_double_1d work, int64_t index);
static inline int64_t friction_load__is_load_met(array_double_1d work, double share);
static inline double friction_load__next_load(array_double_1d work, int64_t support, double share);
static inline int64_t friction_load__share_load(array_double_1d work);

#endif
