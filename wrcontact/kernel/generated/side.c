/* Generated from wheelset/side.py by tools/transpile_kernel.py; change that one.
 *
 * One side of a wheelset, from where its wheel is to its outputs: contact, patches, and its
 * share of the resultant.
 */

#include "side.h"

/* Zeros in a side's outputs. */
static inline int64_t side__clear_side(array_double_1d tables, array_double_1d work, int64_t index)
{
    int64_t out;
    int64_t i;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    for (i = INT64_C(0); i < layout__SIDE_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, out + i)) = 0.0;
    }
    (*cspan_at(&work, layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index + layout__ROLLING_SIDE_COUNT)) = 0.0;
    outlines__fill_apart(tables, work, index, 0.0);
    return INT64_C(0);
}

/* Normal contact of the side whose frame is open, and its part of the resultant if patches are filled in;
 * number of its regions and outcome.
 */
static inline int64_t side__load_side(int64_t* count, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double prescribed)
{
    int64_t out;
    double penetration;
    int64_t satisfied;
    int64_t outline;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    normal_contact__solve_normal(&penetration, count, &satisfied, work, tables, state, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index, out, force, prescribed);
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_PENETRATION)) = penetration;
    if ((satisfied == INT64_C(0)) && ((*count) == INT64_C(0)))
    {
        /* it overlaps most at the end of a profile */
        (*result_1) = layout__OFF_PROFILE;
        return 0;
    }
    if (satisfied == INT64_C(0))
    {
        (*result_1) = layout__NOT_CONVERGED;
        return 0;
    }
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0)
    {
        resultant__add_patches(work, tables, penetration, (double)(INT64_C(2) * index - INT64_C(1)), layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
        totals__write_patches(work, out);
        rolling_patches__keep_rolling(work, tables, layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index, (double)(INT64_C(2) * index - INT64_C(1)));
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_ALL)
        {
            outline = outlines__outline_place(tables, work, index);
            outline__write_outline(work, outline, (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))), (*count));
        }
    }
    (*result_1) = layout__VALID;
    return 0;
}

/* Describe the side whose wheel just touches, with the vertical shift of its smallest
 * gap; its outcome, UNLOADED.
 */
static inline int64_t side__touch_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index)
{
    int64_t side;
    int64_t status;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    side__clear_side(tables, work, index);
    resultant__clear_resultant(work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    status = layout__UNLOADED;
    if (contact_point__describe_contact(tables, work, state, index, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), 0.0, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST))) == INT64_C(0))
    {
        status = layout__OFF_PROFILE;
    }
    return status;
}

/* Contact and patches of one side of a rigid wheelset, as far as they are requested; its outcome. */
static inline int64_t side__solve_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    double penetration;
    double pressed;
    int64_t count;
    int64_t status;
    status = side__touch_side(tables, work, state, index);
    if (status == layout__UNLOADED)
    {
        penetration = (*cspan_at(&tables, layout__TABLES_PENETRATION + index));
        pressed = force;
        if (isfinite(penetration))
        {
            pressed = penetration;
        }
        if (pressed > 0.0)
        {
            status = layout__VALID;
            if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) != layout__DEPTH_GEOMETRY)
            {
                side__load_side(&count, &status, tables, work, state, index, force, penetration);
            }
        }
    }
    return status;
}

/* Describe the side whose wheel is ``approach`` [m] below its smallest gap, where it overlaps its
 * rail most; its outcome.
 */
static inline int64_t side__press_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double approach)
{
    int64_t side;
    double height;
    int64_t deepest;
    double aside;
    double shift;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    height = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) + approach;
    side__clear_side(tables, work, index);
    resultant__clear_resultant(work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    if (side__find_points(work, tables, state, side, index, height) == INT64_C(0))
    {
        /* it overlaps most at the end of a profile */
        return layout__OFF_PROFILE;
    }
    deepest = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work);
    pressed_regions__touching_shift(&aside, &shift, work, tables, side + layout__SIDE_SEARCH_PLACE, deepest);
    contact_point__describe_contact(tables, work, state, index, (*cspan_at(&work, deepest + layout__DEEP_POINT_WHEEL)), aside, shift);
    pressed_regions__press_frame(work, height, (*cspan_at(&work, deepest + layout__DEEP_POINT_DEPTH)), 0.0);
    return layout__VALID;
}

/* List the deepest points of a wheel moved down by ``height`` [m]; how many.  Those of the last search
 * are followed where the contact's ``following`` permits it.
 */
static inline int64_t side__find_points(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, int64_t index, double height)
{
    int64_t kept;
    int64_t count;
    kept = layout__WORK_CONTACT + layout__CONTACT_DEEP_POINTS + layout__DEEP_POINTS_SIZE * index;
    count = INT64_C(0);
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) == 1.0) && ((int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT))) > INT64_C(0)))
    {
        count = followed_overlaps__follow_overlaps(work, tables, kept, side + layout__SIDE_SEARCH_PLACE, height);
    }
    if (count == INT64_C(0))
    {
        count = overlaps__find_overlaps(work, tables, side, state, height);
    }
    followed_overlaps__keep_points(work, kept);
    return count;
}

/* How the height at which a side carries its load follows the roll [m], from its regions'
 * levers and stiffnesses.
 */
static inline double side__side_lever(array_double_1d tables, array_double_1d work, int64_t index, int64_t count)
{
    int64_t at;
    double total;
    double weight;
    int64_t region;
    int64_t block;
    double stiffness;
    double lever;
    at = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_PLACE;
    total = 0.0;
    weight = 0.0;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * region;
        stiffness = (*cspan_at(&work, block + layout__REGION_STIFFNESS)) * (*cspan_at(&work, block + layout__REGION_SHARE)) * (*cspan_at(&work, block + layout__REGION_COS));
        weight += stiffness;
        total += stiffness * gap__gap_per_roll(work, tables, at, (*cspan_at(&work, block + layout__REGION_WHEEL)));
    }
    lever = gap__gap_per_roll(work, tables, at, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST_Y)));
    if (weight > 0.0)
    {
        lever = total / weight;
    }
    return lever;
}
