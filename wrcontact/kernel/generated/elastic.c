/* Generated from wheelset/elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium: the height and roll at which both wheels carry their loads.
 *
 * The wheels are pressed into their rails. At a given roll each side has one height at which it carries its
 * load; where these heights are equal the wheelset is in equilibrium. Their difference D(roll) = height_right -
 * height_left falls as that of the rigid gaps does (:mod:`roll`), and a small load leaves the gaps themselves.
 * How a side's height follows the roll,
 *
 *     d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),
 *
 * is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's
 * slope, by the envelope theorem (docs/method.md, section 11).
 *
 * Both unknowns are found by Broyden's method (Broyden 1965), in trials (trial.py); where it finds
 * nothing, by brackets (brackets.py).
 */

#include "elastic.h"

/* Roll [rad] of the wheelset in equilibrium under ``left`` and ``right`` [N], and the outcome; outputs
 * are those of the two sides. Starts at the rigid ``roll``, whose smallest gaps are known.
 */
static OUT_OF_LINE int64_t elastic__solve_elastic(double* result_0, int64_t* result_1, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right)
{
    int64_t status;
    double height;
    double move;
    double rigid_roll;
    status = trial__estimate_approach(left_tables, work, state, INT64_C(0), left);
    if (status == layout__VALID)
    {
        status = trial__estimate_approach(right_tables, work, state, INT64_C(1), right);
    }
    if (status != layout__VALID)
    {
        (*result_0) = roll;
        (*result_1) = status;
        return 0;
    }
    elastic__first_estimate(&height, &move, left_tables, right_tables, work);
    rigid_roll = roll;
    roll += move;
    if (trial__turn_near(left_tables, right_tables, work, state, roll) == INT64_C(0))
    {
        (*result_0) = roll;
        (*result_1) = layout__OFF_PROFILE;
        return 0;
    }
    elastic__iterate(&roll, &status, left_tables, right_tables, work, state, roll, height, left, right);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) = (double)(1);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) = (double)(0);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) = (double)(0);
    if (status == layout__NOT_CONVERGED)
    {
        brackets__bracket_roll(&roll, &status, left_tables, right_tables, work, state, rigid_roll, left, right);
    }
    (*result_0) = roll;
    (*result_1) = status;
    return 0;
}

/* Height [m] and move of the roll [rad] in equilibrium, if each wheel approaches
 * its rail as far as estimated.
 */
static OUT_OF_LINE int64_t elastic__first_estimate(double* height, double* move, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work)
{
    int64_t right;
    double lever_left;
    double lever_right;
    right = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1);
    lever_left = side__side_lever(left_tables, work, INT64_C(0), INT64_C(0));
    lever_right = side__side_lever(right_tables, work, INT64_C(1), INT64_C(0));
    (*move) = 0.0;
    if (lever_left + lever_right < -elastic__LEAST_LEVER)
    {
        (*move) = ((*cspan_at(&work, right + layout__SUPPORT_APPROACH)) - (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_APPROACH))) / (-(lever_left + lever_right));
    }
    (*move) = touching__limited((*move), elastic__LONGEST / (*cspan_at(&right_tables, layout__TABLES_ARM)));
    /* in one order for a wheelset and its mirror image */
    (*height) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST)) + 0.5 * ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_APPROACH)) - lever_left * (*move) + ((*cspan_at(&work, right + layout__SUPPORT_APPROACH)) + lever_right * (*move)));
    return 0;
}

/* Roll [rad] in equilibrium by Broyden's method from ``roll`` and ``height`` on, and the outcome;
 * NOT_CONVERGED where it finds nothing.
 */
static OUT_OF_LINE int64_t elastic__iterate(double* result_0_0001, int64_t* result_1_0001, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double height, double left, double right)
{
    double arm;
    int64_t trial;
    double moved;
    bool followed;
    int64_t status;
    int64_t index;
    arm = (*cspan_at(&right_tables, layout__TABLES_ARM));
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT)) = 0.0;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT)) = 0.0;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)) = 0.0;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) = (double)((int64_t)((*cspan_at(&right_tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP);
    for (trial = INT64_C(0); trial < elastic__TRIALS; trial += INT64_C(1))
    {
        moved = fabs((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT))) + fabs((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) = (double)(0);
        followed = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) == 1.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) = (double)(trial > INT64_C(0));
        if ((trial > INT64_C(0)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) == 1.0) && (moved < elastic__COARSE))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) = (double)(0);
            /* the change to the whole model does not show how residuals follow a move */
            (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)) = 0.0;
            (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) = 0.0;
        }
        else if ((trial > INT64_C(0)) && (moved < elastic__NOT_LAST))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) = (double)(1);
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FOLLOWING)) = (double)(0);
            if (followed)
            {
                /* nor does the change from points that are followed to those of a search */
                (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)) = 0.0;
                (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) = 0.0;
            }
            /* the same place again, with patches, or with the smaller gap that was found */
        }
        status = trial__balance_both(left_tables, right_tables, work, state, left, right, height);
        if (status > layout__UNLOADED)
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__NOT_CONVERGED;
            return 0;
        }
        if (trial == INT64_C(0))
        {
            elastic__begin_derivatives(work, arm);
        }
        elastic__update(work, height);
        if (elastic__find_move(work, arm) == INT64_C(0))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__NOT_CONVERGED;
            return 0;
        }
        if ((fabs((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT))) < elastic__ELASTIC_SHARP) && (fabs((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL))) < elastic__ELASTIC_SHARP))
        {
            if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0) && (elastic__gaps_hold(left_tables, right_tables, work, state, roll) == INT64_C(1)))
            {
                for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
                {
                    (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_HEIGHT)) = height + (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT));
                }
                (*result_0_0001) = roll + (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) / arm;
                (*result_1_0001) = trial__depth_outcome(work, status);
                return 0;
            }
            (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)) = 0.0;
            (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) = 0.0;
        }
        (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)) = touching__limited((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)), elastic__LONGEST);
        (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) = touching__limited((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)), elastic__LONGEST);
        height += (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT));
        roll += (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) / arm;
        if (!(fabs(roll) < layout__ROLL_LIMIT))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__NOT_CONVERGED;
            return 0;
        }
        if (trial__turn_near(left_tables, right_tables, work, state, roll) == INT64_C(0))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__NOT_CONVERGED;
            return 0;
        }
    }
    (*result_0_0001) = roll;
    (*result_1_0001) = layout__NOT_CONVERGED;
    return 0;
}

/* 1 if both sides' known gaps are the smallest at ``roll`` [rad], else 0; then smaller ones are known.
 *
 * Between trials they are only followed: an answer is certified once.
 */
static OUT_OF_LINE int64_t elastic__gaps_hold(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll)
{
    double left;
    double right;
    int64_t hold;
    left = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    right = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    hold = trial__turn_to(left_tables, right_tables, work, state, roll);
    if (((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)) != left) || ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)) != right))
    {
        hold = INT64_C(0);
    }
    return hold;
}

/* The residuals' derivatives from both levers [m]. */
static OUT_OF_LINE int64_t elastic__begin_derivatives(array_double_1d work, double arm)
{
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_HEIGHT)) = -1.0;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_HEIGHT)) = -1.0;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_ROLL)) = (-(*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_LEVER))) / arm;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_ROLL)) = (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_LEVER)) / arm;
    return INT64_C(0);
}

/* The residuals of a trial at ``height`` [m], and the derivatives that the last move has
 * shown (Broyden 1965).
 */
static OUT_OF_LINE int64_t elastic__update(array_double_1d work, double height)
{
    double before_left;
    double before_right;
    double move_height;
    double move_roll;
    double size;
    double off_left;
    double off_right;
    before_left = (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT));
    before_right = (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT));
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT)) = (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) - height;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT)) = (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_HEIGHT)) - height;
    move_height = (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT));
    move_roll = (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL));
    size = move_height * move_height + move_roll * move_roll;
    if (size > 0.0)
    {
        off_left = ((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT)) - before_left - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_HEIGHT)) * move_height - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_ROLL)) * move_roll) / size;
        off_right = ((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT)) - before_right - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_HEIGHT)) * move_height - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_ROLL)) * move_roll) / size;
        (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_HEIGHT)) += off_left * move_height;
        (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_ROLL)) += off_left * move_roll;
        (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_HEIGHT)) += off_right * move_height;
        (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_ROLL)) += off_right * move_roll;
    }
    return INT64_C(0);
}

/* The move of height and roll that lets the residuals vanish; 1 if there is one, else 0. */
static OUT_OF_LINE int64_t elastic__find_move(array_double_1d work, double arm)
{
    double determinant;
    determinant = (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_HEIGHT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_ROLL)) - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_HEIGHT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_ROLL));
    if (!(fabs(determinant) > elastic__SINGULAR))
    {
        elastic__begin_derivatives(work, arm);
        determinant = (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_HEIGHT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_ROLL)) - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_HEIGHT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_ROLL));
        if (!(fabs(determinant) > elastic__SINGULAR))
        {
            return INT64_C(0);
        }
    }
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_HEIGHT)) = ((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_ROLL)) - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_ROLL))) / determinant;
    (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_MOVE_ROLL)) = ((*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT_HEIGHT)) - (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_RIGHT)) * (*cspan_at(&work, layout__WORK_BROYDEN + layout__BROYDEN_LEFT_HEIGHT))) / determinant;
    return INT64_C(1);
}
