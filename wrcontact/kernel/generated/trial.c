/* Generated from wheelset/trial.py by tools/transpile_kernel.py; change that one.
 *
 * One trial of an elastic wheelset: both wheels pressed into their rails at one height and roll.
 *
 * Regions and nodes are placed where the wheel is at the height of the trial. With them the height
 * follows at which the side carries its force; the residual, how much lower than the trial that is,
 * vanishes in equilibrium.
 */

#include "trial.h"

/* Estimate how far a wheel under ``force`` [N] comes down below its smallest gap; the outcome. */
static OUT_OF_LINE int64_t trial__estimate_approach(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    int64_t support;
    int64_t status;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    status = side__touch_side(tables, work, state, index);
    (*cspan_at(&work, support + layout__SUPPORT_APPROACH)) = 0.0;
    if (status == layout__UNLOADED)
    {
        status = layout__VALID;
        if (force > 0.0)
        {
            (*cspan_at(&work, support + layout__SUPPORT_APPROACH)) = estimate__first_penetration(work, tables, state, force) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        }
    }
    return status;
}

/* How far a wheel at ``height`` is below its smallest gap [m], within the range
 * in which it is pressed.
 */
static OUT_OF_LINE double trial__permitted_approach(array_double_1d work, int64_t support, int64_t side, double height)
{
    double approach;
    approach = height - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST));
    if (approach < trial__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_APPROACH)))
    {
        approach = trial__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_APPROACH));
    }
    if (approach > trial__DEEPEST)
    {
        approach = trial__DEEPEST;
    }
    return approach;
}

/* Find the height at which a side carries ``force`` [N], with regions and nodes as they are at ``height``
 * [m]; its outcome. Outputs are those of the side under this force.
 */
static OUT_OF_LINE int64_t trial__balance_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height)
{
    int64_t support;
    int64_t side;
    double approach;
    int64_t count;
    double carried;
    int64_t status;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    if (!(force > 0.0))
    {
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST));
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = side__side_lever(tables, work, index, INT64_C(0));
        status = side__touch_side(tables, work, state, index);
        return status;
    }
    approach = trial__permitted_approach(work, support, side, height);
    status = side__press_side(tables, work, state, index, approach);
    if (status == layout__VALID)
    {
        side__load_side(&count, &status, tables, work, state, index, force, (*cspan_at(&tables, layout__TABLES_ABSENT)));
        carried = approach + ((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_PENETRATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) + carried;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = side__side_lever(tables, work, index, count);
    }
    return status;
}

/* ``balance_side`` for both, under ``left`` and ``right`` [N]; the worse outcome. */
static OUT_OF_LINE int64_t trial__balance_both(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double left, double right, double height)
{
    int64_t outcome;
    int64_t status;
    (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
    status = trial__balance_side(left_tables, work, state, INT64_C(0), left, height);
    if (status <= layout__UNLOADED)
    {
        outcome = trial__balance_side(right_tables, work, state, INT64_C(1), right, height);
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
}

/* Turn the wheelset to ``roll`` [rad] and find both smallest gaps; 1 if both wheels are
 * above their rails, else 0.
 */
static OUT_OF_LINE int64_t trial__turn_to(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll)
{
    int64_t known;
    int64_t result;
    roll__turn_both(work, roll);
    known = roll__follow_side(work, left_tables, layout__WORK_SIDES, state);
    if (known == INT64_C(1))
    {
        known = roll__follow_side(work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1), state);
    }
    result = roll__search_both(work, left_tables, right_tables, state, known);
    return result;
}

/* Turn the wheelset to a near ``roll`` [rad] and follow both smallest gaps, or search where they cannot
 * be followed; 1 if both wheels are above their rails, else 0.  Whether there is a smaller gap is left
 * open.
 */
static OUT_OF_LINE int64_t trial__turn_near(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll)
{
    int64_t known;
    roll__turn_both(work, roll);
    known = roll__follow_side(work, left_tables, layout__WORK_SIDES, state);
    if (known == INT64_C(1))
    {
        known = roll__follow_side(work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1), state);
    }
    if (known == INT64_C(0))
    {
        known = roll__search_both(work, left_tables, right_tables, state, INT64_C(0));
    }
    return known;
}

/* ``status``, or OFF_PROFILE if a side carries its load deeper than DEEPEST, which the
 * compliant form refuses too.
 */
static OUT_OF_LINE int64_t trial__depth_outcome(array_double_1d work, int64_t status)
{
    int64_t index;
    double best;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        best = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
        if ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_HEIGHT)) - best > trial__DEEPEST)
        {
            status = layout__OFF_PROFILE;
        }
    }
    return status;
}
