/* Generated from wheelset/step.py by tools/transpile_kernel.py; change that one.
 *
 * One step of a wheelset: from pose and load to contact positions, roll and patches.
 *
 * The recipe: check the inputs, find the roll at which both wheels touch, describe each contact and
 * solve its normal contact; for an elastic wheelset, find the height and roll at which both wheels carry
 * their loads; add up the forces. If the wheelset rolls, creepages follow, and from them the creep forces; where
 * the load is a vertical one, friction carries some of it, and the wheelset is solved again.
 */

#include "step.h"

/* Evaluate the wheelset at the workspace's inputs into its outputs; the status. */
static inline int64_t step__evaluate(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state)
{
    int64_t status;
    status = requested__check_inputs(work, right_tables);
    if (status != layout__VALID)
    {
        return status;
    }
    friction_load__release_friction(work);
    status = step__solve_wheelset(left_tables, right_tables, work, state);
    if ((status <= layout__UNLOADED) && (friction_load__carries_friction(right_tables, work) == INT64_C(1)))
    {
        status = step__solve_with_friction(left_tables, right_tables, work, state, status);
    }
    if (status <= layout__UNLOADED)
    {
        requested__omit_outputs(right_tables, work);
    }
    return status;
}

/* Vertical loads of which friction carries a part: the wheelset again, until both are met; the status,
 * NOT_CONVERGED where friction jams a wheel.
 */
static inline int64_t step__solve_with_friction(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, int64_t status)
{
    int64_t i;
    int64_t outcome;
    outcome = status;
    for (i = INT64_C(0); i < friction_load__LOAD_PASSES; i += INT64_C(1))
    {
        if ((outcome > layout__UNLOADED) || (friction_load__is_load_met(work, friction_load__LOAD_MET) == INT64_C(1)))
        {
            break;
        }
        friction_load__share_load(work);
        outcome = step__solve_wheelset(left_tables, right_tables, work, state);
    }
    if ((outcome <= layout__UNLOADED) && (friction_load__is_load_met(work, friction_load__LOAD_MISSED) == INT64_C(0)))
    {
        outcome = layout__NOT_CONVERGED;
    }
    return outcome;
}

/* Contact of both wheels, resultant, creepages and creep forces; the status. */
static inline int64_t step__solve_wheelset(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state)
{
    double roll;
    int64_t status;
    status = layout__VALID;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) = (double)(1);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) = (double)(0);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) = (double)(0);
    if ((int64_t)((*cspan_at(&right_tables, layout__TABLES_MODE))) == layout__MODE_COMPLIANT)
    {
        status = compliant__solve_compliant(left_tables, right_tables, work, state);
    }
    else
    {
        rigid__find_roll(&roll, &status, left_tables, right_tables, work, state);
        if (status != layout__VALID)
        {
            return status;
        }
        if ((int64_t)((*cspan_at(&right_tables, layout__TABLES_MODE))) == layout__MODE_RIGID)
        {
            status = rigid__solve_rigid(left_tables, right_tables, work, state, roll);
        }
        if (status <= layout__UNLOADED)
        {
            rigid__keep_roll(work, state, roll);
        }
        if ((int64_t)((*cspan_at(&right_tables, layout__TABLES_MODE))) == layout__MODE_ELASTIC)
        {
            status = step__elastic_from_rigid(left_tables, right_tables, work, state, roll);
        }
    }
    resultant__write_resultant(work, right_tables, layout__WORK_SUPPORTS + layout__SUPPORT_RESULTANT, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_RESULTANT);
    if (moving__is_rolling(work) == INT64_C(1))
    {
        moving__write_creepages(left_tables, right_tables, work, state);
    }
    if (creep_forces__has_creep_forces(right_tables, work) == INT64_C(1))
    {
        creep_forces__write_creep_forces(left_tables, right_tables, work);
    }
    return status;
}

/* Elastic contact: the height and roll at which both wheels carry their loads; the outcome. */
static inline int64_t step__elastic_from_rigid(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double rigid_roll)
{
    double roll;
    int64_t status;
    elastic__solve_elastic(&roll, &status, left_tables, right_tables, work, state, rigid_roll, requested__side_force(work, INT64_C(0)), requested__side_force(work, INT64_C(1)));
    if ((status <= layout__UNLOADED) && (leaning__is_leaning(work) == INT64_C(1)))
    {
        step__meet_leaning(&roll, &status, left_tables, right_tables, work, state, rigid_roll);
    }
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = step__support_height(work);
    return status;
}

/* The height of a wheelset in equilibrium [m]: both sides' mean, which differ by rounding. */
static inline double step__support_height(array_double_1d work)
{
    double result;
    result = 0.5 * ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) + (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_HEIGHT)));
    return result;
}

/* Roll [rad] and outcome in elastic equilibrium over rolled rails, sought together with the vertical
 * shift; the equilibrium for the rigid height as reference is known.
 */
static inline int64_t step__meet_leaning(double* result_0, int64_t* result_1_0001, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double rigid_roll)
{
    double roll;
    int64_t i;
    double height;
    int64_t status;
    roll = rigid_roll;
    leaning__open_reference(work, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)), step__support_height(work));
    for (i = INT64_C(0); i < leaning__MEETINGS; i += INT64_C(1))
    {
        height = leaning__next_reference(work, leaning__ELASTIC_MET);
        leaning__set_reference(work, height);
        roll__place_both(work, left_tables, right_tables, rigid_roll);
        if (trial__turn_to(left_tables, right_tables, work, state, rigid_roll) == INT64_C(0))
        {
            (*result_0) = roll;
            (*result_1_0001) = layout__OFF_PROFILE;
            return 0;
        }
        elastic__solve_elastic(&roll, &status, left_tables, right_tables, work, state, rigid_roll, requested__side_force(work, INT64_C(0)), requested__side_force(work, INT64_C(1)));
        if (status > layout__UNLOADED)
        {
            (*result_0) = roll;
            (*result_1_0001) = status;
            return 0;
        }
        if (leaning__note_reference(work, height, step__support_height(work), leaning__ELASTIC_MET) == INT64_C(1))
        {
            (*result_0) = roll;
            (*result_1_0001) = status;
            return 0;
        }
    }
    (*result_0) = roll;
    (*result_1_0001) = layout__NOT_CONVERGED;
    return 0;
}

/* Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status. Inputs as
 * before are not evaluated again.
 */
static inline int64_t step__step_row(array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, int64_t row)
{
    int64_t changed;
    int64_t i;
    int64_t size;
    int64_t status;
    changed = INT64_C(1);
    if ((*cspan_at(&workspace, layout__WORK_KNOWN)) == 1.0)
    {
        changed = INT64_C(0);
    }
    for (i = INT64_C(0); i < layout__INPUT_COUNT; i += INT64_C(1))
    {
        if (!((*cspan_at(&workspace, layout__WORK_INPUTS + i)) == (*cspan_at(&inputs, layout__INPUT_COUNT * row + i))))
        {
            changed = INT64_C(1);
        }
        (*cspan_at(&workspace, layout__WORK_INPUTS + i)) = (*cspan_at(&inputs, layout__INPUT_COUNT * row + i));
    }
    status = (int64_t)((*cspan_at(&workspace, layout__WORK_STATUS)));
    if (changed == INT64_C(1))
    {
        (*cspan_at(&workspace, layout__WORK_KNOWN)) = (double)(0);
        status = step__evaluate(left_tables, right_tables, workspace, state);
    }
    if (status <= layout__UNLOADED)
    {
        (*cspan_at(&workspace, layout__WORK_KNOWN)) = (double)(1);
        (*cspan_at(&workspace, layout__WORK_STATUS)) = (double)(status);
        size = outline__row_size(right_tables);
        for (i = INT64_C(0); i < size; i += INT64_C(1))
        {
            (*cspan_at(&outputs, size * row + i)) = (*cspan_at(&workspace, layout__WORK_OUTPUTS + i));
        }
    }
    return status;
}

/* Evaluate one wheelset at ``inputs`` into ``outputs``; the status.
 *
 * Outputs keep their values unless the status is VALID or UNLOADED. ``state`` holds where the next roll
 * search starts; it never changes an answer.
 */
static inline int64_t step__step(array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs)
{
    int64_t result;
    result = step__step_row(left_tables, right_tables, state, workspace, inputs, outputs, INT64_C(0));
    return result;
}

/* Evaluate ``count`` rows of inputs, one after the other. */
static inline int64_t step__step_many(int64_t count, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, array_double_1d statuses)
{
    int64_t row;
    for (row = INT64_C(0); row < count; row += INT64_C(1))
    {
        (*cspan_at(&statuses, row)) = (double)(step__step_row(left_tables, right_tables, state, workspace, inputs, outputs, row));
    }
    return INT64_C(0);
}
