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

#include "friction_load.h"

/* Friction carries nothing yet. */
static inline int64_t friction_load__release_friction(array_double_1d work)
{
    int64_t index;
    int64_t support;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
        (*cspan_at(&work, support + layout__SUPPORT_FRICTION_LOAD)) = 1.0;
        (*cspan_at(&work, support + layout__SUPPORT_LOAD_BEFORE)) = 0.0;
        (*cspan_at(&work, support + layout__SUPPORT_SHARE_BEFORE)) = 0.0;
    }
    return INT64_C(0);
}

/* 1 if a part of the prescribed load is carried by friction, else 0. */
static inline int64_t friction_load__carries_friction(array_double_1d tables, array_double_1d work)
{
    int64_t carried;
    carried = INT64_C(0);
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL) && ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) != layout__MODE_COMPLIANT))
    {
        carried = creep_forces__has_creep_forces(tables, work);
    }
    return carried;
}

/* The vertical force of a wheel over the load that is wanted of it; 1 for a wheel without load. */
static inline double friction_load__carried_share(array_double_1d work, int64_t index)
{
    double wanted;
    double share;
    share = 1.0;
    wanted = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * (1.0 + (double)(INT64_C(2) * index - INT64_C(1)) * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER)));
    if ((wanted > 0.0) && ((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_NORMAL_PART + INT64_C(2))) < 0.0))
    {
        share = (-(*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_FORCE + INT64_C(2)))) / wanted;
    }
    return share;
}

/* 1 if neither wheel misses the vertical force that is wanted by more than this ``share``, else 0. */
static inline int64_t friction_load__is_load_met(array_double_1d work, double share)
{
    int64_t index;
    int64_t met;
    met = INT64_C(1);
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        if (fabs(friction_load__carried_share(work, index) - 1.0) > share)
        {
            met = INT64_C(0);
        }
    }
    return met;
}

/* Let the normal forces of both sides carry what friction leaves of the load, or adds to it. */
static inline int64_t friction_load__share_load(array_double_1d work)
{
    int64_t index;
    double share;
    int64_t support;
    double load;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        share = friction_load__carried_share(work, index);
        support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
        load = friction_load__next_load(work, support, share);
        (*cspan_at(&work, support + layout__SUPPORT_LOAD_BEFORE)) = (*cspan_at(&work, support + layout__SUPPORT_FRICTION_LOAD));
        (*cspan_at(&work, support + layout__SUPPORT_SHARE_BEFORE)) = share;
        (*cspan_at(&work, support + layout__SUPPORT_FRICTION_LOAD)) = load;
    }
    return INT64_C(0);
}

/* The next load of a side over that of the inputs, where the last one has given ``share`` of what is
 * wanted: from a secant, or in proportion.
 */
static inline double friction_load__next_load(array_double_1d work, int64_t support, double share)
{
    double load;
    double change;
    double slope;
    double secant;
    double following;
    load = (*cspan_at(&work, support + layout__SUPPORT_FRICTION_LOAD));
    change = load - (*cspan_at(&work, support + layout__SUPPORT_LOAD_BEFORE));
    slope = share / load;
    if (((*cspan_at(&work, support + layout__SUPPORT_LOAD_BEFORE)) > 0.0) && (fabs(change) > friction_load__LEAST_CHANGE * load))
    {
        secant = (share - (*cspan_at(&work, support + layout__SUPPORT_SHARE_BEFORE))) / change;
        if ((secant > slope / friction_load__LARGEST_CHANGE) && (secant < slope * friction_load__LARGEST_CHANGE))
        {
            slope = secant;
        }
    }
    following = load - (share - 1.0) / slope;
    if (following > load * friction_load__LARGEST_CHANGE)
    {
        following = load * friction_load__LARGEST_CHANGE;
    }
    if (following < load / friction_load__LARGEST_CHANGE)
    {
        following = load / friction_load__LARGEST_CHANGE;
    }
    return following;
}
