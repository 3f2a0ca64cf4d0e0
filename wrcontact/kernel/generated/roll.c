/* Generated from roll.py by tools/transpile_kernel.py; change that one.
 *
 * The roll of the wheelset: the angle at which both wheels have the same smallest gap.
 *
 * D(roll) = gap_right - gap_left falls strictly while flanges are less steep than atan(2 arm / radius) (73 deg for
 * 750 mm and 460 mm), so a bracket and Newton with the envelope derivative cannot fail.  D has kinks where minima exchange
 * rank; there the bracket takes over.
 */

#include "roll.h"

/* Both wheels at ``roll``; the left one mirrored into a right one (conventions.MIRROR). */
static int64_t roll__place_both(array_double_1d tables, array_double_1d work, double roll)
{
    double shift;
    double yaw;
    shift = (*cspan_at(&work, layout__WORK_INPUTS + layout__IN_LATERAL_SHIFT));
    yaw = (*cspan_at(&work, layout__WORK_INPUTS + layout__IN_YAW));
    locus__place_wheelset(work, layout__WORK_PLACE, -shift, -yaw, -roll, (*cspan_at(&tables, layout__SET_RADIUS)), (*cspan_at(&tables, layout__SET_ARM)));
    locus__place_wheelset(work, layout__WORK_PLACE + locus__PLACE_SIZE, shift, yaw, roll, (*cspan_at(&tables, layout__SET_RADIUS)), (*cspan_at(&tables, layout__SET_ARM)));
    return INT64_C(0);
}

/* Scan and refine both sides; 1 if both wheels are above their rails, else 0. */
static int64_t roll__search_both(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    int64_t i;
    int64_t side;
    int64_t at;
    int64_t found;
    found = INT64_C(1);
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        side = layout__WORK_SIDE + layout__WORK_SIDE_SIZE * i;
        at = layout__WORK_PLACE + locus__PLACE_SIZE * i;
        if (search__scan_side(tables, work, side, work, at, state) == INT64_C(0))
        {
            found = INT64_C(0);
        }
        else
        {
            search__find_minima(tables, work, side, work, at, state);
        }
    }
    return found;
}

/* Refine the known minima of both sides; 1 if all were found again, else 0. */
static int64_t roll__follow_both(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    int64_t i;
    int64_t found;
    found = INT64_C(1);
    for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
    {
        if (found == INT64_C(1))
        {
            found = search__follow_minima(tables, work, layout__WORK_SIDE + layout__WORK_SIDE_SIZE * i, work, layout__WORK_PLACE + locus__PLACE_SIZE * i, state);
        }
    }
    return found;
}

/* Roll [rad] and outcome; the sides' minima stay in the workspace. */
static int64_t roll__solve_roll(double* result_0, int64_t* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, double guess)
{
    int64_t left;
    int64_t right;
    double low;
    double high;
    double roll;
    double scanned;
    int64_t retried;
    int64_t i;
    int64_t known;
    double difference;
    double rate;
    double following;
    double move;
    left = layout__WORK_SIDE;
    right = layout__WORK_SIDE + layout__WORK_SIDE_SIZE;
    low = -roll__ROLL_LIMIT;
    high = roll__ROLL_LIMIT;
    roll = guess;
    if (!((roll > low) && (roll < high)))
    {
        roll = 0.0;
    }
    scanned = 1.0;
    retried = INT64_C(0);
    for (i = INT64_C(0); i < roll__ROLL_ITERATIONS; i += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
        roll__place_both(tables, work, roll);
        known = INT64_C(0);
        if (fabs(roll - scanned) < search__REACH)
        {
            known = roll__follow_both(tables, work, state);
        }
        if (known == INT64_C(0))
        {
            if (roll__search_both(tables, work, state) == INT64_C(0))
            {
                if ((retried == INT64_C(1)) || (roll == 0.0))
                {
                    (*result_0) = roll;
                    (*result_1_0001) = layout__OFF_PROFILE;
                    return 0;
                }
                retried = INT64_C(1);
                roll = 0.0;
                low = -roll__ROLL_LIMIT;
                high = roll__ROLL_LIMIT;
                continue;
            }
            scanned = roll;
        }
        difference = (*cspan_at(&work, right + layout__SIDE_BEST)) - (*cspan_at(&work, left + layout__SIDE_BEST));
        rate = gap__gap_per_roll(tables, work, layout__WORK_PLACE + locus__PLACE_SIZE, (*cspan_at(&work, right + layout__SIDE_BEST_Y))) + gap__gap_per_roll(tables, work, layout__WORK_PLACE, (*cspan_at(&work, left + layout__SIDE_BEST_Y)));
        if (difference > 0.0)
        {
            low = roll;
        }
        else
        {
            high = roll;
        }
        following = 0.5 * (low + high);
        if (rate < 0.0)
        {
            move = (-difference) / rate;
            if (fabs(move) < roll__ROLL_SHARP)
            {
                (*result_0) = roll;
                (*result_1_0001) = layout__VALID;
                return 0;
            }
            if ((roll + move > low) && (roll + move < high))
            {
                following = roll + move;
            }
        }
        if (fabs(following - roll) < roll__ROLL_SHARP)
        {
            (*result_0) = roll;
            (*result_1_0001) = layout__VALID;
            return 0;
        }
        roll = following;
    }
    (*result_0) = roll;
    (*result_1_0001) = layout__NOT_CONVERGED;
    return 0;
}
