/* Generated from wheelset/compliant.py by tools/transpile_kernel.py; change that one.
 *
 * Compliant contact: height and roll of the wheelset are given, and each wheel's load follows from
 * how deep it is in its rail.
 */

#include "compliant.h"

/* Both sides of the wheelset at the height and roll of the inputs; the outcome. */
static OUT_OF_LINE int64_t compliant__solve_compliant(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state)
{
    double roll;
    double height;
    int64_t status;
    int64_t outcome;
    roll = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL));
    height = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_SHIFT));
    leaning__set_reference(work, height);
    roll__place_both(work, left_tables, right_tables, roll);
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height;
    if (damping__is_damped(right_tables) == INT64_C(1))
    {
        moving__open_given_motion(left_tables, right_tables, work);
    }
    if (roll__search_both(work, left_tables, right_tables, state, compliant__follow_starts(left_tables, right_tables, work, state)) == INT64_C(0))
    {
        return layout__OFF_PROFILE;
    }
    status = compliant__load_at_height(left_tables, work, state, INT64_C(0), height);
    outcome = compliant__load_at_height(right_tables, work, state, INT64_C(1), height);
    if (outcome > status)
    {
        status = outcome;
    }
    return status;
}

/* 1 if both smallest gaps could be followed from where they are known near the lateral shift, else 0. */
static OUT_OF_LINE int64_t compliant__follow_starts(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state)
{
    int64_t row;
    int64_t start;
    int64_t known;
    row = starts__nearest_start(right_tables, (int64_t)((*cspan_at(&right_tables, layout__TABLES_STARTS))), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT)));
    known = INT64_C(0);
    if (row >= INT64_C(0))
    {
        start = (int64_t)((*cspan_at(&right_tables, layout__TABLES_STARTS))) + layout__STARTS_ROWS + layout__START_SIZE * row;
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&right_tables, start + layout__START_LEFT));
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&right_tables, start + layout__START_RIGHT));
        known = roll__follow_side(work, left_tables, layout__WORK_SIDES, state);
        if (known == INT64_C(1))
        {
            known = roll__follow_side(work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1), state);
        }
    }
    return known;
}

/* The load of a side whose wheelset has the vertical shift ``height`` [m]; its
 * outcome, UNLOADED if lifted.
 */
static OUT_OF_LINE int64_t compliant__load_at_height(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double height)
{
    double approach;
    int64_t status;
    int64_t count;
    int64_t result;
    approach = height - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(approach > compliant__GRAZING))
    {
        result = side__touch_side(tables, work, state, index);
        return result;
    }
    if (approach > trial__DEEPEST)
    {
        return layout__OFF_PROFILE;
    }
    status = side__press_side(tables, work, state, index, approach);
    if (status == layout__VALID)
    {
        side__load_side(&count, &status, tables, work, state, index, 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)));
    }
    if ((status == layout__VALID) && (damping__is_damped(tables) == INT64_C(1)))
    {
        damping__damp_patches(work, tables, index, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
        totals__write_patches(work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index);
    }
    return status;
}
