/* Generated from search/roll.py by tools/transpile_kernel.py; change that one.
 *
 * The roll of the wheelset: the angle at which both wheels have the same smallest gap.
 *
 * D(roll) = gap_right - gap_left falls strictly while one flange is less steep than atan(2 arm / radius) (73 deg
 * for 750 mm and 460 mm), so a bracket and Newton's method with the envelope derivative cannot fail. Where it
 * has several roots, first_root.py decides which is the roll.
 *
 * Solve first, certify then: with two minima at hand Newton finds the roll that makes them equal, following each
 * one; at that roll both sides are searched for a smaller one. If there is none, this is the roll; otherwise the
 * smaller minima take over, within a bracket that every search narrows.
 */

#include "roll.h"

/* Both wheels at ``roll``; the left one mirrored into a right one (conventions.MIRROR). */
static inline int64_t roll__place_both(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, double roll)
{
    locus__place_wheelset(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)), roll, (*cspan_at(&right_tables, layout__TABLES_RADIUS)), (*cspan_at(&right_tables, layout__TABLES_HEIGHT)), (*cspan_at(&right_tables, layout__TABLES_ARM)));
    locus__mirror_place(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&left_tables, layout__TABLES_RADIUS)));
    rails__move_rail(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL)));
    rails__move_rail(work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, -(*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL)));
    if (((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL)) != 0.0) || ((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL)) != 0.0))
    {
        roll__lean_both(work, left_tables, right_tables, roll);
    }
    return INT64_C(0);
}

/* Let both rails have their roll below wheels that are placed at ``roll``. */
static inline int64_t roll__lean_both(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, double roll)
{
    rails__lean_rail(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&right_tables, layout__TABLES_RAIL_Y)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL)));
    rails__lean_rail(work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&left_tables, layout__TABLES_RAIL_Y)), -(*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL)));
    roll__turn_both(work, roll);
    return INT64_C(0);
}

/* Both placed wheels at another ``roll``. */
static inline int64_t roll__turn_both(array_double_1d work, double roll)
{
    if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
    {
        roll__restore_yaw(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE);
        roll__restore_yaw(work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    }
    locus__turn_wheelset(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, roll);
    locus__mirror_roll(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
    {
        rails__turn_leaning(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE);
        rails__turn_leaning(work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    }
    return INT64_C(0);
}

/* The yaw in the track, where that in the frame of a rolled rail stood. */
static inline int64_t roll__restore_yaw(array_double_1d work, int64_t place)
{
    (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW));
    return INT64_C(0);
}

/* Search both sides; 1 if both wheels are above their rails, else 0. */
static inline int64_t roll__search_both(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, int64_t known)
{
    int64_t left;
    int64_t right;
    left = smallest_gap__search_side(work, left_tables, layout__WORK_SIDES, state, known);
    right = smallest_gap__search_side(work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1), state, known);
    return left * right;
}

/* Move a side's known smallest gap to this roll's by Newton's method; 1 if it is found near, else 0. */
static inline int64_t roll__follow_side(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state)
{
    int64_t at;
    int64_t wheel;
    double y;
    int64_t i;
    double gap;
    double mismatch;
    double rate;
    double move;
    double abscissa;
    at = side + layout__SIDE_SEARCH_PLACE;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    y = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y));
    for (i = INT64_C(0); i < roll__FOLLOW_STEPS; i += INT64_C(1))
    {
        gap__vertical_gap(&gap, &mismatch, &rate, work, tables, at, y);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (!(rate > 0.0))
        {
            return INT64_C(0);
        }
        move = (-mismatch) / rate;
        if (fabs(move) < cells__SHARP)
        {
            abscissa = raster__rail_below(work, tables, at, y);
            if (gap__above_rail(tables, abscissa) == INT64_C(0))
            {
                return INT64_C(0);
            }
            roll__keep_known(work, side, y, gap, abscissa);
            return INT64_C(1);
        }
        y += move;
        if ((fabs(y - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y))) > roll__FOLLOW_REACH) || (!((y > (*cspan_at(&tables, wheel + layout__PROFILE_START))) && (y < (*cspan_at(&tables, wheel + layout__PROFILE_STOP))))))
        {
            return INT64_C(0);
        }
    }
    return INT64_C(0);
}

/* D [m] and Newton's move of the roll [rad] at the known minima; a move of 1 where D does not fall. */
static inline int64_t roll__newton_move(double* difference, double* move, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables)
{
    double rate;
    (*difference) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)) - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST));
    rate = gap__gap_per_roll(work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y))) + gap__gap_per_roll(work, left_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)));
    (*move) = 1.0;
    if (rate < 0.0)
    {
        (*move) = (-(*difference)) / rate;
    }
    return 0;
}

/* Roll [rad] at which the two known minima are equal, following them; second value 1 if found, else 0.
 *
 * Newton's method for three unknowns at once: the roll and the minima's places, where the slopes of wheel
 * and rail agree. It starts with the minima known near ``roll`` and stays between ``low`` and ``high``.
 * Between nearly conformal profiles a minimum can run away or vanish.
 */
static inline int64_t roll__equalize_minima(double* result_0_0001, int64_t* result_1_0001, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll, double low, double high)
{
    double left;
    double right;
    int64_t i;
    double gap_left;
    double mismatch_left;
    double rate_left;
    double lever_left;
    double turn_left;
    double rail_left;
    double gap_right;
    double mismatch_right;
    double rate_right;
    double lever_right;
    double turn_right;
    double rail_right;
    double move_left;
    double move_right;
    double difference;
    double lever;
    double move;
    left = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    right = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    for (i = INT64_C(0); i < roll__NEWTON_STEPS; i += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
        roll__turn_both(work, roll);
        gap__gap_jet(&gap_left, &mismatch_left, &rate_left, &lever_left, &turn_left, &rail_left, work, left_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, left);
        gap__gap_jet(&gap_right, &mismatch_right, &rate_right, &lever_right, &turn_right, &rail_right, work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, right);
        if (!((rate_left > 0.0) && (rate_right > 0.0)))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = INT64_C(0);
            return 0;
        }
        move_left = (-mismatch_left) / rate_left;
        move_right = (-mismatch_right) / rate_right;
        /* gaps and levers at the minima next to these places, to second and first order */
        difference = gap_right - gap_left + 0.5 * (mismatch_right * move_right - mismatch_left * move_left);
        lever = lever_right + lever_left + turn_right * move_right + turn_left * move_left;
        if (!(lever < 0.0))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = INT64_C(0);
            return 0;
        }
        move = (-difference) / lever;
        move_left += turn_left * move / rate_left;
        move_right -= turn_right * move / rate_right;
        if ((fabs(move) < roll__ROLL_SHARP) && (fabs(move_left) < cells__SHARP) && (fabs(move_right) < cells__SHARP))
        {
            if ((roll__on_profiles(left_tables, left, rail_left) == INT64_C(0)) || (roll__on_profiles(right_tables, right, rail_right) == INT64_C(0)))
            {
                (*result_0_0001) = roll;
                (*result_1_0001) = INT64_C(0);
                return 0;
            }
            roll__keep_known(work, layout__WORK_SIDES, left, gap_left, rail_left);
            roll__keep_known(work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1), right, gap_right, rail_right);
            (*result_0_0001) = roll;
            (*result_1_0001) = INT64_C(1);
            return 0;
        }
        if (!((fabs(move) < roll__LONGEST_TURN) && (fabs(move_left) < roll__LONGEST_MOVE) && (fabs(move_right) < roll__LONGEST_MOVE)))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = INT64_C(0);
            return 0;
        }
        left += move_left;
        right += move_right;
        roll += move;
        if (!((roll > low) && (roll < high)))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = INT64_C(0);
            return 0;
        }
    }
    (*result_0_0001) = roll;
    (*result_1_0001) = INT64_C(0);
    return 0;
}

/* 1 if there is a wheel at ``y`` and a rail at ``abscissa`` [m], else 0. */
static inline int64_t roll__on_profiles(array_double_1d tables, double y, double abscissa)
{
    int64_t wheel;
    int64_t on;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    on = gap__above_rail(tables, abscissa);
    if ((y < (*cspan_at(&tables, wheel + layout__PROFILE_START))) || (y > (*cspan_at(&tables, wheel + layout__PROFILE_STOP))))
    {
        on = INT64_C(0);
    }
    return on;
}

/* Let the side's known minimum be at ``y``, ``abscissa`` on the rail [m]. */
static inline int64_t roll__keep_known(array_double_1d work, int64_t side, double y, double gap, double abscissa)
{
    (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
    (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = y;
    (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_RAIL)) = abscissa;
    return INT64_C(0);
}

/* A roll [rad] between ``first`` and ``last`` at which both smallest gaps are equal, and the outcome;
 * both gaps are known at it. D has to be positive at ``first`` and negative at ``last``.
 *
 * With ``known`` = 1 the sides hold local minima that are equal at ``roll``.
 */
static inline int64_t roll__roll_between(double* result_0_0001, int64_t* result_1_0001, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll, double first, double last, int64_t known)
{
    double low;
    double high;
    double width;
    double difference;
    int64_t i;
    double before_left;
    double before_right;
    int64_t found;
    double move;
    bool slow;
    double balanced;
    int64_t status;
    low = first;
    high = last;
    width = high - low;
    difference = 0.0;
    for (i = INT64_C(0); i < roll__SEARCHES; i += INT64_C(1))
    {
        if (known == INT64_C(0))
        {
            roll__turn_both(work, roll);
        }
        before_left = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
        before_right = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
        found = roll__search_both(work, left_tables, right_tables, state, known);
        if ((known == INT64_C(1)) && (before_left == (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y))) && (before_right == (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y))))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__VALID;
            return 0;
        }
        known = INT64_C(0);
        /* a wheel beside its rail has a large gap */
        difference = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)) - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST));
        if ((found == INT64_C(0)) && (difference == 0.0))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__OFF_PROFILE;
            return 0;
        }
        move = 1.0;
        if (found == INT64_C(1))
        {
            roll__newton_move(&difference, &move, work, left_tables, right_tables);
            if (fabs(move) < roll__ROLL_SHARP)
            {
                (*result_0_0001) = roll;
                (*result_1_0001) = layout__VALID;
                return 0;
            }
        }
        if (difference > 0.0)
        {
            low = roll;
        }
        else
        {
            high = roll;
        }
        if (high - low < roll__ROLL_SHARP)
        {
            break;
        }
        /* between flange and tread Newton can creep along one side: halve where it did not */
        slow = (low > first) && (high < last) && (high - low > 0.5 * width);
        width = high - low;
        if (slow || (!((roll + move > low) && (roll + move < high))))
        {
            roll = 0.5 * (low + high);
        }
        else if (fabs(move) > roll__LONGEST_TURN)
        {
            roll += move;
        }
        else
        {
            roll__equalize_minima(&balanced, &known, work, left_tables, right_tables, state, roll + move, low, high);
            roll += move;
            if (known == INT64_C(1))
            {
                roll = balanced;
            }
        }
    }
    status = layout__NOT_CONVERGED;
    if (high - low < roll__ROLL_SHARP)
    {
        status = layout__VALID;
        if (fabs(difference) > roll__EQUAL)
        {
            /* an end of a profile comes above or leaves the rail there */
            status = layout__OFF_PROFILE;
        }
    }
    (*result_0_0001) = roll;
    (*result_1_0001) = status;
    return 0;
}

/* A roll [rad] at which both smallest gaps are equal, and the outcome; both gaps are known at it.
 *
 * With ``warm`` = 1 ``best_y`` of both sides holds minima to start from.
 */
static inline int64_t roll__any_roll(double* roll, int64_t* status, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double guess, int64_t warm)
{
    double start;
    int64_t known;
    double balanced;
    start = guess;
    if (!((start > -layout__ROLL_LIMIT) && (start < layout__ROLL_LIMIT)))
    {
        start = 0.0;
    }
    known = INT64_C(0);
    roll__place_both(work, left_tables, right_tables, start);
    if (warm == INT64_C(1))
    {
        roll__equalize_minima(&balanced, &known, work, left_tables, right_tables, state, start, -layout__ROLL_LIMIT, layout__ROLL_LIMIT);
        if (known == INT64_C(1))
        {
            start = balanced;
        }
    }
    roll__roll_between(roll, status, work, left_tables, right_tables, state, start, -layout__ROLL_LIMIT, layout__ROLL_LIMIT, known);
    if (((*status) != layout__VALID) && (start != 0.0))
    {
        /* far from zero roll a wheel may be beside its rail, and D without a sign */
        roll__roll_between(roll, status, work, left_tables, right_tables, state, 0.0, -layout__ROLL_LIMIT, layout__ROLL_LIMIT, INT64_C(0));
    }
    return 0;
}
