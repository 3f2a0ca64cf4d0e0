/* Generated from wheelset/side.py by tools/transpile_kernel.py; change that one.
 *
 * One side of a wheelset, from where its wheel stands to its outputs: contact, patches, and its share of the resultant.
 */

#include "side.h"

/* Offset in the workspace of the outputs of side ``index`` (0 left, 1 right). */
static inline int64_t side__side_outputs(int64_t index)
{
    return layout__WORK_OUTPUTS + layout__OUT_LEFT + (layout__OUT_RIGHT - layout__OUT_LEFT) * index;
}

/* Offset in the workspace of the force and moment of side ``index``. */
static inline int64_t side__side_resultant(int64_t index)
{
    return layout__WORK_SUPPORT + layout__SUPPORT_BLOCK * index + side__SUPPORT_RESULTANT;
}

/* Zeros in a side's outputs. */
static inline int64_t side__clear_side(array_double_1d tables, array_double_1d work, int64_t out)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__SIDE_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, out + i)) = 0.0;
    }
    outline__fill_apart(tables, work, out, 0.0);
    return INT64_C(0);
}

/* Write what stands for outputs that are not wanted, from a side's output ``first`` on. */
static inline int64_t side__clear_from(array_double_1d tables, array_double_1d work, int64_t out, int64_t first)
{
    int64_t i;
    for (i = first; i < layout__SIDE_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, out + i)) = (*cspan_at(&tables, layout__SET_ABSENT));
    }
    outline__fill_apart(tables, work, out, (*cspan_at(&tables, layout__SET_ABSENT)));
    if (first <= layout__SIDE_PENETRATION)
    {
        (*cspan_at(&work, out + layout__SIDE_PATCH_COUNT)) = (*cspan_at(&tables, layout__SET_ABSENT));
    }
    return INT64_C(0);
}

/* The first of a side's outputs that is not wanted; SIDE_SIZE if all are. */
static inline int64_t side__first_unwanted(array_double_1d tables)
{
    int64_t depth;
    int64_t first;
    depth = (int64_t)((*cspan_at(&tables, layout__SET_DEPTH)));
    first = layout__SIDE_SIZE;
    if (depth == layout__DEPTH_PATCHES)
    {
        first = layout__SIDE_STATION;
    }
    if (depth == layout__DEPTH_GEOMETRY)
    {
        first = layout__SIDE_PENETRATION;
    }
    return first;
}

/* Normal contact of the side whose frame is open, and its part of the resultant; number of its regions and outcome. */
static inline int64_t side__load_side(int64_t* count, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double prescribed)
{
    int64_t met;
    int64_t region;
    (*status) = layout__VALID;
    normal_contact__solve_normal(count, &met, tables, work, state, layout__WORK_SIDE + layout__SIDE_BLOCK * index, side__side_outputs(index), force, prescribed);
    if (met == INT64_C(0))
    {
        (*status) = layout__NOT_CONVERGED;
    }
    else
    {
        for (region = INT64_C(0); region < (*count); region += INT64_C(1))
        {
            resultant__add_region(tables, work, region, (double)(INT64_C(2) * index - INT64_C(1)), side__side_resultant(index));
        }
    }
    return 0;
}

/* Describe the side whose wheel just touches, with the vertical shift of its smallest gap; its outcome, UNLOADED. */
static inline int64_t side__rest_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index)
{
    int64_t side;
    int64_t status;
    side = layout__WORK_SIDE + layout__SIDE_BLOCK * index;
    side__clear_side(tables, work, side__side_outputs(index));
    resultant__clear_resultant(work, side__side_resultant(index));
    status = layout__UNLOADED;
    if (contact_point__describe_contact(tables, work, state, index, (*cspan_at(&work, side + layout__SIDE_BEST_Y)), 0.0, (*cspan_at(&work, side + layout__SIDE_BEST))) == INT64_C(0))
    {
        status = layout__OFF_PROFILE;
    }
    return status;
}

/* Contact and patches of one side of a rigid wheelset, as far as they are wanted; its outcome. */
static inline int64_t side__step_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    double penetration;
    double pressed;
    int64_t count;
    int64_t status;
    status = side__rest_side(tables, work, state, index);
    if (status == layout__UNLOADED)
    {
        penetration = (*cspan_at(&tables, layout__SET_PENETRATION_LEFT + index));
        pressed = force;
        if (isfinite(penetration))
        {
            pressed = penetration;
        }
        if (pressed > 0.0)
        {
            status = layout__VALID;
            if ((int64_t)((*cspan_at(&tables, layout__SET_DEPTH))) != layout__DEPTH_GEOMETRY)
            {
                side__load_side(&count, &status, tables, work, state, index, force, penetration);
            }
        }
    }
    return status;
}

/* Describe the side whose wheel stands ``sink`` [m] below its smallest gap, where it overlaps its rail most; its outcome. */
static inline int64_t side__press_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double sink)
{
    int64_t side;
    int64_t at;
    double height;
    int64_t deepest;
    int64_t deep;
    double aside;
    double shift;
    side = layout__WORK_SIDE + layout__SIDE_BLOCK * index;
    at = layout__WORK_PLACE + layout__PLACE_BLOCK * index;
    height = (*cspan_at(&work, side + layout__SIDE_BEST)) + sink;
    side__clear_side(tables, work, side__side_outputs(index));
    resultant__clear_resultant(work, side__side_resultant(index));
    if (overlaps__find_overlaps(tables, work, state, side, at, height) == INT64_C(0))
    {
        /* it overlaps most at the end of a profile */
        return layout__OFF_PROFILE;
    }
    deepest = overlaps__deepest_entry(work);
    deep = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * deepest;
    overlaps__touching_shift(&aside, &shift, tables, work, at, deepest, height);
    contact_point__describe_contact(tables, work, state, index, (*cspan_at(&work, deep + overlaps__DEEP_WHEEL)), aside, shift);
    overlaps__press_frame(work, height, (*cspan_at(&work, deep + overlaps__DEEP_DEPTH)), 0.0);
    return layout__VALID;
}

/* How the height at which a side carries its load follows the roll [m], from its regions' levers and stiffnesses. */
static inline double side__side_lever(array_double_1d tables, array_double_1d work, int64_t index, int64_t count)
{
    int64_t at;
    double total;
    double weight;
    int64_t region;
    int64_t block;
    double stiffness;
    double lever;
    at = layout__WORK_PLACE + layout__PLACE_BLOCK * index;
    total = 0.0;
    weight = 0.0;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = regions__region_block(region);
        stiffness = (*cspan_at(&work, block + regions__REGION_STIFFNESS)) * (*cspan_at(&work, block + regions__REGION_SHARE)) * (*cspan_at(&work, block + regions__REGION_COS));
        weight += stiffness;
        total += stiffness * gap__gap_per_roll(tables, work, at, (*cspan_at(&work, block + regions__REGION_WHEEL)));
    }
    lever = gap__gap_per_roll(tables, work, at, (*cspan_at(&work, layout__WORK_SIDE + layout__SIDE_BLOCK * index + layout__SIDE_BEST_Y)));
    if (weight > 0.0)
    {
        lever = total / weight;
    }
    return lever;
}
