/* Generated from wheelset/creep_forces.py by tools/transpile_kernel.py; change that one.
 *
 * Creep forces of a wheelset whose contact is solved and whose creepages are known.
 *
 * For each reported patch: its friction and the creepage of each strip, which has its own rolling radius; then
 * the tangential model, and its force and moment on the wheel in the track frame.  On the right y to the field
 * side is the opposite of the creepages' y_c, and the normal x times y that of the normal n from the rail to the
 * wheel; on the left they are the same:
 *
 *     xi' = xi,   eta' = -+ eta,   phi' = -+ phi,   M = -+ M'       (upper sign: right)
 *
 * Normal forces of a body of revolution go through its axle; the torque about the axle is that of the creep
 * forces.
 */

#ifndef WRCONTACT_KERNEL_CREEP_FORCES_H
#define WRCONTACT_KERNEL_CREEP_FORCES_H

#include "../native/spans.h"
#include "creepage.h"
#include "friction.h"
#include "layout.h"
#include "moving.h"
#include "outlines.h"
#include "tangential_contact.h"
#include "wear_outline.h"

static inline int64_t creep_forces__has_creep_forces(array_double_1d tables, array_double_1d work);
static inline int64_t creep_forces__set_load(array_double_1d work, int64_t patch, double load);
static inline int64_t creep_forces__open_rolling(array_double_1d work, array_double_1d tables, int64_t patch, int64_t to, double mirror, double friction);
static inline int64_t creep_forces__write_creep(array_double_1d work, int64_t patch, int64_t to, double mirror, double limit);
static inline int64_t creep_forces__add_creep(array_double_1d work, int64_t side, int64_t to, double mirror);
static inline int64_t creep_forces__write_side_wear(array_double_1d tables, array_double_1d work, int64_t index);
static inline int64_t creep_forces__write_side_creep(array_double_1d tables, array_double_1d work, int64_t index, double friction);
static inline int64_t creep_forces__write_creep_forces(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work);

#endif
