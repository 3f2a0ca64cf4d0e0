/* Generated from wheelset/step.py by tools/transpile_kernel.py; change that one.
 *
 * One step of a wheelset: from pose and load to contact positions, roll and patches.
 *
 * The recipe: check the inputs, find the roll at which both wheels touch, describe each contact and
 * solve its normal contact; for an elastic wheelset, find the height and roll at which both wheels carry
 * their loads; add up the forces.
 */

#include "step.h"

/* Evaluate the wheelset at the workspace's inputs into its outputs; the status. */
static inline int64_t step__evaluate(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    double roll;
    int64_t status;
    status = requested__check_inputs(work, tables);
    if (status != layout__VALID)
    {
        return status;
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) = (double)(1);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) = (double)(0);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_COMPLIANT)
    {
        status = compliant__solve_compliant(tables, work, state);
    }
    else
    {
        rigid__find_roll(&roll, &status, tables, work, state);
        if (status != layout__VALID)
        {
            return status;
        }
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_RIGID)
        {
            status = rigid__solve_rigid(tables, work, state, roll);
        }
        if (status <= layout__UNLOADED)
        {
            rigid__keep_roll(work, state, roll);
        }
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_ELASTIC)
        {
            status = step__elastic_from_rigid(tables, work, state, roll);
        }
    }
    resultant__write_resultant(work, tables, layout__WORK_SUPPORTS + layout__SUPPORT_RESULTANT, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_RESULTANT);
    if (moving__is_rolling(work) == INT64_C(1))
    {
        moving__write_creepages(tables, work, state);
    }
    requested__omit_outputs(tables, work);
    return status;
}

/* Elastic contact: the height and roll at which both wheels carry their loads; the outcome. */
static inline int64_t step__elastic_from_rigid(array_double_1d tables, array_double_1d work, array_double_1d state, double rigid_roll)
{
    double roll;
    int64_t status;
    elastic__solve_elastic(&roll, &status, tables, work, state, rigid_roll, requested__side_force(work, INT64_C(0)), requested__side_force(work, INT64_C(1)));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = 0.5 * ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) + (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_HEIGHT)));
    return status;
}

/* Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status. Inputs as
 * before are not evaluated again.
 */
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
        (*cspan_at(&workspace, layout__WORK_KNOWN)) = (double)(0);
        status = step__evaluate(tables, workspace, state);
    }
    if (status <= layout__UNLOADED)
    {
        (*cspan_at(&workspace, layout__WORK_KNOWN)) = (double)(1);
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
 * Outputs keep their values unless the status is VALID or UNLOADED. ``state`` holds where the next roll
 * search starts; it never changes an answer.
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
