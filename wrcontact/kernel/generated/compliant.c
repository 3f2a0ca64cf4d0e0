/* Generated from wheelset/compliant.py by tools/transpile_kernel.py; change that one.
 *
 * Compliant contact: height and roll of the wheelset are given, and each wheel's load follows from
 * how deep it is in its rail.
 */

#include "compliant.h"

/* Both sides of the wheelset at the height and roll of the inputs; the outcome. */
static OUT_OF_LINE int64_t compliant__solve_compliant(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    double roll;
    double height;
    int64_t status;
    int64_t index;
    int64_t outcome;
    roll = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL));
    height = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_SHIFT));
    roll__place_both(work, tables, roll);
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height;
    status = layout__VALID;
    if (roll__search_both(work, tables, state, INT64_C(0)) == INT64_C(0))
    {
        return layout__OFF_PROFILE;
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        outcome = compliant__load_at_height(tables, work, state, index, height);
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
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
    return status;
}
