/* Generated from wheelset/step.py by tools/transpile_kernel.py; change that one.
 *
 * One step of a wheelset: from pose and load to contact positions, roll and patches.
 *
 * The recipe: check the inputs, find the roll at which both wheels touch, describe each contact, solve its normal contact.
 */

#include "step.h"

/* 1 if all inputs are finite, the force is not negative and the load transfer within -1 ... 1, else 0. */
static inline int64_t step__inputs_valid(array_double_1d work)
{
    int64_t i;
    int64_t valid;
    valid = INT64_C(1);
    for (i = INT64_C(0); i < layout__INPUT_COUNT; i += INT64_C(1))
    {
        if (!isfinite((*cspan_at(&work, layout__WORK_INPUTS + i))))
        {
            valid = INT64_C(0);
        }
    }
    if (valid == INT64_C(1))
    {
        if (((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) < 0.0) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER))) > 1.0))
        {
            valid = INT64_C(0);
        }
    }
    return valid;
}

/* 1 if shift and yaw are within the range of the profiles, else 0. */
static inline int64_t step__inputs_in_range(array_double_1d tables, array_double_1d work)
{
    int64_t inside;
    inside = INT64_C(1);
    if (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT))) > (*cspan_at(&tables, layout__TABLES_LATERAL_LIMIT)))
    {
        inside = INT64_C(0);
    }
    if (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW))) > (*cspan_at(&tables, layout__TABLES_YAW_LIMIT)))
    {
        inside = INT64_C(0);
    }
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_COMPLIANT) && (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL))) > layout__ROLL_LIMIT))
    {
        inside = INT64_C(0);
    }
    return inside;
}

/* Roll [rad] and outcome; starts at the given guess, or at the last roll and contacts if the wheelset has moved little,
 * or at those known near its lateral shift.
 */
static inline int64_t step__find_roll(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state)
{
    double shift;
    double guess;
    int64_t warm;
    int64_t row;
    shift = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    guess = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL_GUESS));
    warm = INT64_C(0);
    if (guess == 0.0)
    {
        row = starts__nearest_start(tables, shift);
        if (((*cspan_at(&state, layout__STATE_WARM)) == 1.0) && ((row < INT64_C(0)) || (fabs(shift - (*cspan_at(&state, layout__STATE_SHIFT))) < step__NEAR_SHIFT)))
        {
            guess = (*cspan_at(&state, layout__STATE_ROLL));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&state, layout__STATE_Y_LEFT));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&state, layout__STATE_Y_RIGHT));
            warm = INT64_C(1);
        }
        else if (row >= INT64_C(0))
        {
            guess = (*cspan_at(&tables, row + starts__START_ROLL));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&tables, row + starts__START_LEFT));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&tables, row + starts__START_RIGHT));
            warm = INT64_C(1);
        }
    }
    level__solve_roll(result_0, result_1, tables, work, state, guess, warm);
    return 0;
}

/* The prescribed force of side ``index`` [N], with load transfer. */
static inline double step__side_force(array_double_1d work, int64_t index)
{
    double sign;
    double result;
    sign = (double)(INT64_C(2) * index - INT64_C(1));
    result = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * (1.0 + sign * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER)));
    return result;
}

/* 1 if the outputs of side ``index`` are wanted, else 0. */
static inline int64_t step__is_wanted(array_double_1d tables, int64_t index)
{
    int64_t wanted;
    wanted = INT64_C(0);
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) == layout__SIDES_BOTH) || ((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) == layout__SIDES_LEFT + index))
    {
        wanted = INT64_C(1);
    }
    return wanted;
}

/* Rigid contact: both wheels touch at ``roll``, and each carries its load there; the outcome. */
static inline int64_t step__stand_rigid(array_double_1d tables, array_double_1d work, array_double_1d state, double roll)
{
    int64_t index;
    int64_t outcome;
    int64_t status;
    status = layout__VALID;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST));
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        resultant__clear_resultant(work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        if (step__is_wanted(tables, index) == INT64_C(1))
        {
            outcome = side__step_side(tables, work, state, index, step__side_force(work, index));
            if (outcome > status)
            {
                status = outcome;
            }
        }
    }
    return status;
}

/* Elastic contact: the height and roll at which both wheels carry their loads; the outcome. */
static inline int64_t step__stand_elastic(array_double_1d tables, array_double_1d work, array_double_1d state, double rigid_roll)
{
    double roll;
    int64_t status;
    elastic__solve_elastic(&roll, &status, tables, work, state, rigid_roll, step__side_force(work, INT64_C(0)), step__side_force(work, INT64_C(1)));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = 0.5 * ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) + (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_HEIGHT)));
    return status;
}

/* Keep where the rigid wheelset stood, for the next search. */
static inline int64_t step__remember(array_double_1d work, array_double_1d state, double roll)
{
    (*cspan_at(&state, layout__STATE_ROLL)) = roll;
    (*cspan_at(&state, layout__STATE_Y_LEFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    (*cspan_at(&state, layout__STATE_Y_RIGHT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    (*cspan_at(&state, layout__STATE_SHIFT)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    (*cspan_at(&state, layout__STATE_WARM)) = 1.0;
    return INT64_C(0);
}

/* Take back what is not wanted of the outputs; the resultant needs both sides and their loads. */
static inline int64_t step__withhold(array_double_1d tables, array_double_1d work)
{
    int64_t index;
    int64_t first;
    bool partial;
    int64_t i;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        first = side__first_unwanted(tables);
        if (step__is_wanted(tables, index) == INT64_C(0))
        {
            first = INT64_C(0);
        }
        if (first < layout__SIDE_SIZE)
        {
            side__clear_from(tables, work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index, first);
        }
    }
    partial = ((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) != layout__SIDES_BOTH) || ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_GEOMETRY);
    if (partial && ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_RIGID))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
        }
    }
    return INT64_C(0);
}

/* Evaluate the wheelset at the workspace's inputs into its outputs; the status. */
static inline int64_t step__evaluate(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    int64_t mode;
    int64_t status;
    double roll;
    if (step__inputs_valid(work) == INT64_C(0))
    {
        return layout__INVALID_INPUT;
    }
    if (step__inputs_in_range(tables, work) == INT64_C(0))
    {
        return layout__OFF_PROFILE;
    }
    mode = (int64_t)((*cspan_at(&tables, layout__TABLES_MODE)));
    status = layout__VALID;
    if (mode == layout__MODE_COMPLIANT)
    {
        status = elastic__stand_compliant(tables, work, state);
    }
    else
    {
        step__find_roll(&roll, &status, tables, work, state);
        if (status != layout__VALID)
        {
            return status;
        }
        if (mode == layout__MODE_RIGID)
        {
            status = step__stand_rigid(tables, work, state, roll);
        }
        if (status <= layout__UNLOADED)
        {
            step__remember(work, state, roll);
        }
        if (mode == layout__MODE_ELASTIC)
        {
            status = step__stand_elastic(tables, work, state, roll);
        }
    }
    resultant__write_resultant(tables, work, layout__WORK_SUPPORTS + layout__SUPPORT_RESULTANT, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_RESULTANT);
    step__withhold(tables, work);
    return status;
}

/* Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status.  Inputs as before are not evaluated again. */
static inline int64_t step__step_row(array_double_1d tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, int64_t row)
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
        (*cspan_at(&workspace, layout__WORK_KNOWN)) = 0.0;
        status = step__evaluate(tables, workspace, state);
    }
    if (status <= layout__UNLOADED)
    {
        (*cspan_at(&workspace, layout__WORK_KNOWN)) = 1.0;
        (*cspan_at(&workspace, layout__WORK_STATUS)) = (double)(status);
        size = outline__row_size(tables);
        for (i = INT64_C(0); i < size; i += INT64_C(1))
        {
            (*cspan_at(&outputs, size * row + i)) = (*cspan_at(&workspace, layout__WORK_OUTPUTS + i));
        }
    }
    return status;
}

/* Evaluate one wheelset at ``inputs`` into ``outputs``; the status.
 *
 * Outputs keep their values unless the status is VALID or UNLOADED.  ``state`` holds where the next roll search
 * starts; it never changes an answer.
 */
static inline int64_t step__step(array_double_1d tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs)
{
    int64_t result;
    result = step__step_row(tables, state, workspace, inputs, outputs, INT64_C(0));
    return result;
}

/* Evaluate ``count`` rows of inputs, one after the other. */
static inline int64_t step__step_many(int64_t count, array_double_1d tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, array_double_1d statuses)
{
    int64_t row;
    for (row = INT64_C(0); row < count; row += INT64_C(1))
    {
        (*cspan_at(&statuses, row)) = (double)(step__step_row(tables, state, workspace, inputs, outputs, row));
    }
    return INT64_C(0);
}
