/* Generated from wheelset/rigid.py by tools/transpile_kernel.py; change that one.
 *
 * Rigid contact: the roll at which both wheels touch, and the load that each carries there.
 */

#include "rigid.h"

/* Roll [rad] and outcome; starts at the given guess, or at the last roll and contacts if the wheelset has
 * moved little, or at those known near its lateral shift.
 */
static inline int64_t rigid__find_roll(double* roll, int64_t* status, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state)
{
    double shift;
    double guess;
    int64_t warm;
    int64_t row;
    int64_t start;
    shift = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    guess = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL_GUESS));
    warm = INT64_C(0);
    if (guess == 0.0)
    {
        row = starts__nearest_start(right_tables, (int64_t)((*cspan_at(&right_tables, layout__TABLES_STARTS))), shift);
        if (((*cspan_at(&state, layout__STATE_WARM)) == 1.0) && ((row < INT64_C(0)) || (fabs(shift - (*cspan_at(&state, layout__STATE_SHIFT))) < rigid__NEAR_SHIFT)))
        {
            guess = (*cspan_at(&state, layout__STATE_ROLL));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&state, layout__STATE_Y_LEFT));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&state, layout__STATE_Y_RIGHT));
            warm = INT64_C(1);
        }
        else if (row >= INT64_C(0))
        {
            start = (int64_t)((*cspan_at(&right_tables, layout__TABLES_STARTS))) + layout__STARTS_ROWS + layout__START_SIZE * row;
            guess = (*cspan_at(&right_tables, start + layout__START_ROLL));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&right_tables, start + layout__START_LEFT));
            (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&right_tables, start + layout__START_RIGHT));
            warm = INT64_C(1);
        }
    }
    leaning__set_reference(work, 0.0);
    first_root__solve_roll(roll, status, work, left_tables, right_tables, state, guess, warm);
    if (((*status) == layout__VALID) && (leaning__is_leaning(work) == INT64_C(1)))
    {
        rigid__find_leaning_roll(roll, status, left_tables, right_tables, work, state, (*roll));
    }
    return 0;
}

/* Roll [rad] and outcome over rolled rails, from the ``roll`` that was found for a reference of zero
 * on: both are sought together with the vertical shift.
 */
static inline int64_t rigid__find_leaning_roll(double* result_0_0001, int64_t* result_1_0001, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll)
{
    int64_t i;
    double height;
    int64_t status;
    leaning__open_reference(work, 0.0, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)));
    for (i = INT64_C(0); i < leaning__MEETINGS; i += INT64_C(1))
    {
        height = leaning__next_reference(work, leaning__RIGID_MET);
        leaning__set_reference(work, height);
        first_root__solve_roll(&roll, &status, work, left_tables, right_tables, state, roll, INT64_C(1));
        if (status != layout__VALID)
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = status;
            return 0;
        }
        if (leaning__note_reference(work, height, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)), leaning__RIGID_MET) == INT64_C(1))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__VALID;
            return 0;
        }
    }
    (*result_0_0001) = roll;
    (*result_1_0001) = layout__NOT_CONVERGED;
    return 0;
}

/* Both wheels touch at ``roll``, and each carries its load there; the outcome. */
static inline int64_t rigid__solve_rigid(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll)
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
    if (requested__is_requested(right_tables, INT64_C(0)) == INT64_C(1))
    {
        status = side__solve_side(left_tables, work, state, INT64_C(0), requested__side_force(work, INT64_C(0)));
    }
    if (requested__is_requested(right_tables, INT64_C(1)) == INT64_C(1))
    {
        outcome = side__solve_side(right_tables, work, state, INT64_C(1), requested__side_force(work, INT64_C(1)));
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
}

/* Keep where both wheels touched, for the next search. */
static inline int64_t rigid__keep_roll(array_double_1d work, array_double_1d state, double roll)
{
    (*cspan_at(&state, layout__STATE_ROLL)) = roll;
    (*cspan_at(&state, layout__STATE_Y_LEFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    (*cspan_at(&state, layout__STATE_Y_RIGHT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    (*cspan_at(&state, layout__STATE_SHIFT)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    (*cspan_at(&state, layout__STATE_WARM)) = (double)(1);
    return INT64_C(0);
}
