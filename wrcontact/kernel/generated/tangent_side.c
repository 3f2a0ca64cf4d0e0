/* Generated from tangent_side.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of side.py.
 */

#include "tangent_side.h"

/* Tangent of ``clear_side``. */
static inline int64_t tangent_side__clear_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index)
{
    int64_t out;
    int64_t i;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    for (i = INT64_C(0); i < layout__SIDE_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, out + i)) = 0.0;
        (*cspan_at(&work, out + i)) = 0.0;
    }
    (*cspan_at(&work_t, layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index + layout__ROLLING_SIDE_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index + layout__ROLLING_SIDE_COUNT)) = 0.0;
    tangent_outlines__fill_apart_t(tables, work, work_t, index, 0.0, 0.0);
    return INT64_C(0);
}

/* Tangent of ``load_side``. */
static inline int64_t tangent_side__load_side_t(int64_t* count, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t out;
    double penetration;
    double penetration_t;
    int64_t satisfied;
    int64_t outline;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    tangent_normal_contact__solve_normal_t(&penetration, &penetration_t, count, &satisfied, work, work_t, tables, state, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index, out, force, force_t, prescribed, prescribed_t);
    (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_PENETRATION)) = penetration_t;
    (*cspan_at(&work, out + layout__SIDE_OUTPUTS_PENETRATION)) = penetration;
    if ((satisfied == INT64_C(0)) && ((*count) == INT64_C(0)))
    {
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
        tangent_resultant__add_patches_t(work, work_t, tables, penetration, penetration_t, (double)(INT64_C(2) * index - INT64_C(1)), 0.0, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
        tangent_totals__write_patches_t(work, work_t, out);
        tangent_rolling_patches__keep_rolling_t(work, work_t, tables, layout__WORK_ROLLING_SIDES + layout__ROLLING_SIDE_SIZE * index, (double)(INT64_C(2) * index - INT64_C(1)), 0.0);
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_ALL)
        {
            outline = outlines__outline_place(tables, work, index);
            tangent_outline__write_outline_t(work, work_t, outline, (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))), (*count));
        }
    }
    (*result_1) = layout__VALID;
    return 0;
}

/* Tangent of ``touch_side``. */
static inline int64_t tangent_side__touch_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index)
{
    int64_t side;
    int64_t n1;
    int64_t status;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    tangent_side__clear_side_t(tables, work, work_t, index);
    tangent_resultant__clear_resultant_t(work, work_t, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    status = layout__UNLOADED;
    n1 = tangent_contact_point__describe_contact_t(tables, work, work_t, state, index, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST_Y)), 0.0, 0.0, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)), (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST)));
    if (n1 == INT64_C(0))
    {
        status = layout__OFF_PROFILE;
    }
    return status;
}

/* Tangent of ``solve_side``. */
static inline int64_t tangent_side__solve_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t)
{
    int64_t n1;
    double penetration;
    double pressed_t;
    double pressed;
    int64_t count;
    int64_t status;
    n1 = tangent_side__touch_side_t(tables, work, work_t, state, index);
    status = n1;
    if (status == layout__UNLOADED)
    {
        penetration = (*cspan_at(&tables, layout__TABLES_PENETRATION + index));
        pressed_t = force_t;
        pressed = force;
        if (isfinite(penetration))
        {
            pressed_t = 0.0;
            pressed = penetration;
        }
        if (pressed > 0.0)
        {
            status = layout__VALID;
            if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) != layout__DEPTH_GEOMETRY)
            {
                tangent_side__load_side_t(&count, &status, tables, work, work_t, state, index, force, force_t, penetration, 0.0);
            }
        }
    }
    return status;
}

/* Tangent of ``press_side``. */
static inline int64_t tangent_side__press_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double approach, double approach_t)
{
    int64_t side;
    double height_t;
    double height;
    int64_t n1;
    int64_t deepest;
    double aside;
    double aside_t;
    double shift;
    double shift_t;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    height_t = (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST)) + approach_t;
    height = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) + approach;
    tangent_side__clear_side_t(tables, work, work_t, index);
    tangent_resultant__clear_resultant_t(work, work_t, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    n1 = tangent_side__find_points_t(work, work_t, tables, state, side, index, height, height_t);
    if (n1 == INT64_C(0))
    {
        return layout__OFF_PROFILE;
    }
    deepest = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work);
    tangent_pressed_regions__touching_shift_t(&aside, &aside_t, &shift, &shift_t, work, work_t, tables, side + layout__SIDE_SEARCH_PLACE, deepest);
    tangent_contact_point__describe_contact_t(tables, work, work_t, state, index, (*cspan_at(&work, deepest + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, deepest + layout__DEEP_POINT_WHEEL)), aside, aside_t, shift, shift_t);
    tangent_pressed_regions__press_frame_t(work, work_t, height, height_t, (*cspan_at(&work, deepest + layout__DEEP_POINT_DEPTH)), (*cspan_at(&work_t, deepest + layout__DEEP_POINT_DEPTH)), 0.0, 0.0);
    return layout__VALID;
}

/* Tangent of ``find_points``. */
static inline int64_t tangent_side__find_points_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, int64_t index, double height, double height_t)
{
    int64_t kept;
    int64_t n1;
    int64_t n2;
    int64_t count;
    kept = layout__WORK_CONTACT + layout__CONTACT_DEEP_POINTS + layout__DEEP_POINTS_SIZE * index;
    count = INT64_C(0);
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) == 1.0) && ((int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT))) > INT64_C(0)))
    {
        n1 = tangent_followed_overlaps__follow_overlaps_t(work, work_t, tables, kept, side + layout__SIDE_SEARCH_PLACE, height, height_t);
        count = n1;
    }
    if (count == INT64_C(0))
    {
        n2 = tangent_overlaps__overlaps_rule_t(work, work_t, tables, side, state, height, height_t);
        count = n2;
    }
    tangent_followed_overlaps__keep_points_t(work, work_t, kept);
    return count;
}

/* Tangent of ``side_lever``. */
static inline int64_t tangent_side__side_lever_t(double* lever, double* lever_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, int64_t count)
{
    int64_t at;
    double total_t;
    double total;
    double weight_t;
    double weight;
    int64_t region;
    int64_t block;
    double v1;
    double stiffness_t;
    double stiffness;
    double v2;
    double v2_t;
    double v3;
    double v3_t;
    double v4;
    at = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_PLACE;
    total_t = 0.0;
    total = 0.0;
    weight_t = 0.0;
    weight = 0.0;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * region;
        v1 = (*cspan_at(&work, block + layout__REGION_STIFFNESS)) * (*cspan_at(&work, block + layout__REGION_SHARE));
        stiffness_t = ((*cspan_at(&work_t, block + layout__REGION_STIFFNESS)) * (*cspan_at(&work, block + layout__REGION_SHARE)) + (*cspan_at(&work, block + layout__REGION_STIFFNESS)) * (*cspan_at(&work_t, block + layout__REGION_SHARE))) * (*cspan_at(&work, block + layout__REGION_COS)) + v1 * (*cspan_at(&work_t, block + layout__REGION_COS));
        stiffness = v1 * (*cspan_at(&work, block + layout__REGION_COS));
        weight_t = weight_t + stiffness_t;
        weight = weight + stiffness;
        tangent_gap__gap_per_roll_t(&v2, &v2_t, work, work_t, tables, at, (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work_t, block + layout__REGION_WHEEL)));
        total_t = total_t + (stiffness_t * v2 + stiffness * v2_t);
        total = total + stiffness * v2;
    }
    tangent_gap__gap_per_roll_t(&v3, &v3_t, work, work_t, tables, at, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST_Y)), (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST_Y)));
    (*lever_t) = v3_t;
    (*lever) = v3;
    if (weight > 0.0)
    {
        v4 = total / weight;
        (*lever_t) = (total_t - v4 * weight_t) / weight;
        (*lever) = v4;
    }
    return 0;
}
