/* Generated from search/first_root.py by tools/transpile_kernel.py; change that one.
 *
 * Which roll of several: the first root of the difference of both gaps, starting from zero roll.
 *
 * While a flange is less steep than both levers allow, D(roll) = gap_right - gap_left (roll.py) falls
 * and has one root. A large wheel on a steep flange (600 mm on 70 deg), or strong yaw with both flanges
 * on the rails, lets D rise in between, and it has three. The roll is then the first root on the way
 * from zero roll to the side on which the sign of D(0) says that there is one: it depends on nothing but
 * the pose, and D falls through it.
 *
 * That no root lies before a known one is certified. On that way the contact of the wheel that rises
 * moves towards its flange and the other's away from it, since rails are convex; so D' is bounded by the
 * steepest places of the wheels between their contacts at both ends of the way. Where this does not
 * settle it, the way is halved.
 */

#include "first_root.h"

/* Roll [rad] of the wheelset and outcome; the smallest gaps of both sides are known at it.
 *
 * With ``warm`` = 1 ``best_y`` of both sides holds minima to start from. A start from which there is
 * no roll does not decide that.
 */
static inline int64_t first_root__solve_roll(double* roll, int64_t* status, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double guess, int64_t warm)
{
    first_root__certified_roll(roll, status, work, left_tables, right_tables, state, guess, warm);
    if (((*status) != layout__VALID) && ((guess != 0.0) || (warm == INT64_C(1))))
    {
        first_root__certified_roll(roll, status, work, left_tables, right_tables, state, 0.0, INT64_C(0));
    }
    return 0;
}

/* ``solve_roll`` from this start alone. */
static inline int64_t first_root__certified_roll(double* roll, int64_t* status, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double guess, int64_t warm)
{
    roll__any_roll(roll, status, work, left_tables, right_tables, state, guess, warm);
    if (((*status) == layout__VALID) && (first_root__falls_at_zero_roll(work, left_tables, right_tables, (*roll)) == INT64_C(0)))
    {
        if (first_root__is_certainly_first(work, left_tables, right_tables, state, (*roll)) == INT64_C(0))
        {
            first_root__first_root(roll, status, work, left_tables, right_tables, state, (*roll));
        }
    }
    return 0;
}

/* 1 if D falls through its known root at ``roll``, and that is zero roll, else 0. */
static inline int64_t first_root__falls_at_zero_roll(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, double roll)
{
    double difference;
    double move;
    int64_t falls;
    falls = INT64_C(0);
    if (fabs(roll) < first_root__APART)
    {
        roll__newton_move(&difference, &move, work, left_tables, right_tables);
        if (fabs(move) < 0.5)
        {
            falls = INT64_C(1);
        }
    }
    return falls;
}

/* How fast a lever changes with the roll at most [m], where profiles are as steep as ``steep`` [-]. */
static inline double first_root__lever_per_roll(double steep, double radius, double arm)
{
    return first_root__TURNED_SHARE * ((1.0 + steep * steep) * radius + steep * arm + radius);
}

/* The largest lever [m] of a wheel at ``y`` [m] and beyond, towards the field side, for any roll up to
 * ``roll`` [rad] and the yaw whose sine is given.
 */
static inline double first_root__largest_lever_beyond(array_double_1d tables, double y, double roll, double sine)
{
    int64_t scan;
    double lever;
    double radius;
    double arm;
    double steep;
    double yawed;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    lever = (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * raster__node_below(tables, scan, y) + layout__SCAN_NODE_LEVER));
    radius = (*cspan_at(&tables, layout__TABLES_RADIUS));
    arm = (*cspan_at(&tables, layout__TABLES_ARM));
    steep = fabs(lever + arm) / radius;
    yawed = first_root__YAWED_SHARE * 0.5 * steep * (1.0 + steep * steep) * radius * sine * sine;
    return lever + first_root__lever_per_roll(steep, radius, arm) * fabs(roll) + yawed;
}

/* 1 if all places of a wheel whose levers are not below -``known`` [m] are beside the
 * rail at zero roll, else 0.
 */
static inline int64_t first_root__is_beside_rail(array_double_1d work, array_double_1d tables, int64_t at, double known, double roll, double sine)
{
    int64_t scan;
    int64_t low;
    int64_t high;
    int64_t middle;
    double reach;
    double furthest;
    int64_t beside;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    low = -INT64_C(1);
    high = (int64_t)((*cspan_at(&tables, scan + layout__SCAN_COUNT))) - INT64_C(1);
    while(high - low > INT64_C(1))
    {
        middle = py_floor_div_int64_t((low + high), INT64_C(2));
        if (known + first_root__largest_lever_beyond(tables, (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * middle + layout__SCAN_NODE_Y)), roll, sine) < 0.0)
        {
            high = middle;
        }
        else
        {
            low = middle;
        }
    }
    beside = INT64_C(1);
    if (low >= INT64_C(0))
    {
        reach = raster__REACH_SHARE * sine * sine * (*cspan_at(&tables, layout__TABLES_RADIUS)) * (*cspan_at(&tables, scan + layout__SCAN_STEEPEST));
        reach += first_root__LEANING_SHARE * (*cspan_at(&tables, layout__TABLES_RADIUS)) * fabs((*cspan_at(&work, at + layout__PLACE_RAIL_SIN)));
        furthest = (*cspan_at(&work, at + layout__PLACE_SHIFT)) + (*cspan_at(&tables, layout__TABLES_ARM)) + (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * high + layout__SCAN_NODE_Y)) + reach;
        if (furthest > (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START)))
        {
            beside = INT64_C(0);
        }
    }
    return beside;
}

/* 1 if D falls all the way from zero roll to its root at ``roll``, as far as the
 * steepest places tell, else 0.
 *
 * The contact of the wheel that stands higher is known there. Of the other wheel count the
 * places that are not beside the rail at zero roll; or those beyond its contact at zero
 * roll, for which that one is searched.
 */
static inline int64_t first_root__is_certainly_first(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll)
{
    double sine;
    double turned;
    double known;
    int64_t certain;
    sine = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_SIN_YAW));
    turned = fabs(roll) + first_root__LEANING_SHARE * double_max(2, fabs((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_RAIL_SIN))), fabs((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_RAIL_SIN))));
    certain = INT64_C(0);
    if (roll < 0.0)
    {
        known = first_root__largest_lever_beyond(right_tables, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)), turned, sine);
        certain = first_root__is_beside_rail(work, left_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, known, turned, sine);
        if (certain == INT64_C(0))
        {
            certain = first_root__falls_from_zero_roll(work, left_tables, INT64_C(0), state, known, roll, turned);
        }
    }
    else
    {
        known = first_root__largest_lever_beyond(left_tables, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)), turned, sine);
        certain = first_root__is_beside_rail(work, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, known, turned, sine);
        if (certain == INT64_C(0))
        {
            certain = first_root__falls_from_zero_roll(work, right_tables, INT64_C(1), state, known, roll, turned);
        }
    }
    return certain;
}

/* 1 if D falls from zero roll to ``roll`` [rad] by the places of the lower wheel, that of side
 * ``index``, beyond its contact at zero roll; the levers of the higher one are not above ``known`` [m], and
 * either wheel is rolled against its rail by up to ``turned`` [rad].
 */
static inline int64_t first_root__falls_from_zero_roll(array_double_1d work, array_double_1d tables, int64_t index, array_double_1d state, double known, double roll, double turned)
{
    int64_t lower;
    double gap;
    double y;
    double abscissa;
    int64_t followed;
    int64_t certain;
    lower = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    gap = (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST));
    y = (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_Y));
    abscissa = (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_RAIL));
    certain = INT64_C(0);
    roll__turn_both(work, 0.0);
    followed = roll__follow_side(work, tables, lower, state);
    if (smallest_gap__search_side(work, tables, lower, state, followed) == INT64_C(1))
    {
        if (known + first_root__largest_lever_beyond(tables, (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_Y)), turned, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_SIN_YAW))) < 0.0)
        {
            certain = INT64_C(1);
        }
    }
    roll__turn_both(work, roll);
    (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST)) = gap;
    (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_Y)) = y;
    (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_RAIL)) = abscissa;
    return certain;
}

/* How the gap at ``y`` [m] would change with the roll if the rail there were
 * parallel to the wheel [m].
 */
static inline double first_root__lever_at(array_double_1d work, array_double_1d tables, int64_t at, double y)
{
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double sin_phi;
    double cos_phi;
    double arm;
    double height;
    double sin_roll;
    double cos_roll;
    double result;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, y, z, slope);
    locus__around_wheel(&sin_phi, &cos_phi, work, at, slope);
    arm = (*cspan_at(&work, at + layout__PLACE_ARM)) + y;
    height = ((*cspan_at(&work, at + layout__PLACE_RADIUS)) + z) * cos_phi;
    sin_roll = (*cspan_at(&work, at + layout__PLACE_SIN_ROLL));
    cos_roll = (*cspan_at(&work, at + layout__PLACE_COS_ROLL));
    result = (-outline_slope) * (*cspan_at(&work, at + layout__PLACE_COS_YAW)) * (arm * sin_roll + height * cos_roll) - arm * cos_roll + height * sin_roll;
    return result;
}

/* Smallest and largest ``lever_at`` between two places of the wheel [m]. */
static inline int64_t first_root__lever_range(double* least, double* most, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t at, double one, double other)
{
    int64_t scan;
    double y;
    double last;
    int64_t node;
    double before;
    double bend;
    double following;
    double lever;
    double beyond;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    y = one;
    last = other;
    if (other < one)
    {
        y = other;
        last = one;
    }
    node = raster__node_below(tables, scan, y);
    before = first_root__lever_at(work, tables, at, y);
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
    (*least) = before;
    (*most) = before;
    while(y < last)
    {
        bend = (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_STEEPEST_BENDS + INT64_C(0)));
        node += INT64_C(1);
        following = (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y));
        if ((following > last) || (following <= y))
        {
            following = last;
        }
        lever = first_root__lever_at(work, tables, at, following);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        beyond = 0.5 * first_root__FASTER * bend * (following - y) * ((*cspan_at(&work, at + layout__PLACE_RADIUS)) + (*cspan_at(&work, at + layout__PLACE_ARM)));
        (*least) = double_min(2, (*least), double_min(2, lever, before) - beyond);
        (*most) = double_max(2, (*most), double_max(2, lever, before) + beyond);
        before = lever;
        y = following;
    }
    return 0;
}

/* Note what is known of D at ``roll`` [rad]. */
static inline int64_t first_root__note_trial(array_double_1d work, int64_t trial, double roll)
{
    (*cspan_at(&work, trial + layout__ROLL_TRIAL_ROLL)) = roll;
    (*cspan_at(&work, trial + layout__ROLL_TRIAL_DIFFERENCE)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)) - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST));
    (*cspan_at(&work, trial + layout__ROLL_TRIAL_LEFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    (*cspan_at(&work, trial + layout__ROLL_TRIAL_RIGHT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    return INT64_C(0);
}

/* Note a root of D at ``roll`` [rad]. */
static inline int64_t first_root__note_root(array_double_1d work, int64_t trial, double roll)
{
    first_root__note_trial(work, trial, roll);
    (*cspan_at(&work, trial + layout__ROLL_TRIAL_DIFFERENCE)) = 0.0;
    return INT64_C(0);
}

/* Copy what is known of D at a roll. */
static inline int64_t first_root__copy_trial(array_double_1d work, int64_t trial, int64_t to)
{
    (*cspan_at(&work, to + layout__ROLL_TRIAL_ROLL)) = (*cspan_at(&work, trial + layout__ROLL_TRIAL_ROLL));
    (*cspan_at(&work, to + layout__ROLL_TRIAL_DIFFERENCE)) = (*cspan_at(&work, trial + layout__ROLL_TRIAL_DIFFERENCE));
    (*cspan_at(&work, to + layout__ROLL_TRIAL_LEFT)) = (*cspan_at(&work, trial + layout__ROLL_TRIAL_LEFT));
    (*cspan_at(&work, to + layout__ROLL_TRIAL_RIGHT)) = (*cspan_at(&work, trial + layout__ROLL_TRIAL_RIGHT));
    return INT64_C(0);
}

/* 1 if D certainly has no root between the rolls ``near`` and ``far``, where it has the sign of ``sign``
 * or, at ``far``, is zero; else 0.
 */
static inline int64_t first_root__has_no_root(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, int64_t near, int64_t far, double sign)
{
    double width;
    double left_least;
    double left_most;
    double right_least;
    double right_most;
    double arm;
    double radius;
    double steep;
    double margin;
    double least;
    double most;
    double at_near;
    double at_far;
    double meet;
    int64_t clear;
    width = fabs((*cspan_at(&work, far + layout__ROLL_TRIAL_ROLL)) - (*cspan_at(&work, near + layout__ROLL_TRIAL_ROLL)));
    roll__turn_both(work, 0.5 * ((*cspan_at(&work, far + layout__ROLL_TRIAL_ROLL)) + (*cspan_at(&work, near + layout__ROLL_TRIAL_ROLL))));
    first_root__lever_range(&left_least, &left_most, work, left_tables, state, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, near + layout__ROLL_TRIAL_LEFT)), (*cspan_at(&work, far + layout__ROLL_TRIAL_LEFT)));
    first_root__lever_range(&right_least, &right_most, work, right_tables, state, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, near + layout__ROLL_TRIAL_RIGHT)), (*cspan_at(&work, far + layout__ROLL_TRIAL_RIGHT)));
    arm = (*cspan_at(&right_tables, layout__TABLES_ARM));
    radius = double_max(2, (*cspan_at(&left_tables, layout__TABLES_RADIUS)), (*cspan_at(&right_tables, layout__TABLES_RADIUS)));
    steep = (double_max(2, double_max(2, fabs(left_least), fabs(left_most)), double_max(2, fabs(right_least), fabs(right_most))) + arm) / double_min(2, (*cspan_at(&left_tables, layout__TABLES_RADIUS)), (*cspan_at(&right_tables, layout__TABLES_RADIUS)));
    margin = width * first_root__lever_per_roll(steep, radius, arm);
    least = left_least + right_least - margin;
    most = left_most + right_most + margin;
    if ((least >= 0.0) || (most <= 0.0))
    {
        return INT64_C(1);
    }
    at_near = sign * (*cspan_at(&work, near + layout__ROLL_TRIAL_DIFFERENCE));
    at_far = sign * (*cspan_at(&work, far + layout__ROLL_TRIAL_DIFFERENCE));
    /* the lines that bound D from below, from either end */
    meet = (at_far - most * width - at_near) / (least - most);
    clear = INT64_C(0);
    if ((meet >= width) || (at_near + least * meet > 0.0))
    {
        clear = INT64_C(1);
    }
    return clear;
}

/* The first root [rad] of D from zero roll, and the outcome; D has a root at ``roll``. */
static inline int64_t first_root__first_root(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll)
{
    double sign;
    double first;
    double last;
    int64_t status;
    int64_t end;
    int64_t trial;
    int64_t far;
    double width;
    double middle;
    first_root__note_root(work, layout__WORK_TRIALS + layout__ROLL_TRIALS_FAR, roll);
    roll__turn_both(work, 0.0);
    if (roll__search_both(work, left_tables, right_tables, state, INT64_C(0)) == INT64_C(0))
    {
        (*result_0) = 0.0;
        (*result_1) = layout__OFF_PROFILE;
        return 0;
    }
    first_root__note_trial(work, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR, 0.0);
    if ((*cspan_at(&work, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR + layout__ROLL_TRIAL_DIFFERENCE)) == 0.0)
    {
        (*result_0) = 0.0;
        (*result_1) = layout__VALID;
        return 0;
    }
    sign = 1.0;
    first = 0.0;
    last = layout__ROLL_LIMIT;
    if ((*cspan_at(&work, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR + layout__ROLL_TRIAL_DIFFERENCE)) < 0.0)
    {
        sign = -1.0;
        first = -layout__ROLL_LIMIT;
        last = 0.0;
    }
    status = layout__VALID;
    if (sign * roll < 0.0)
    {
        roll__roll_between(&roll, &status, work, left_tables, right_tables, state, 0.5 * (first + last), first, last, INT64_C(0));
        first_root__note_root(work, layout__WORK_TRIALS + layout__ROLL_TRIALS_FAR, roll);
    }
    end = INT64_C(0);
    trial = INT64_C(0);
    while((end >= INT64_C(0)) && (status == layout__VALID))
    {
        far = layout__WORK_TRIALS + layout__ROLL_TRIALS_FAR + layout__ROLL_TRIAL_SIZE * end;
        width = fabs((*cspan_at(&work, far + layout__ROLL_TRIAL_ROLL)) - (*cspan_at(&work, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR + layout__ROLL_TRIAL_ROLL)));
        if ((width < first_root__APART) || (first_root__has_no_root(work, left_tables, right_tables, state, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR, far, sign) == INT64_C(1)))
        {
            first_root__copy_trial(work, far, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR);
            end -= INT64_C(1);
        }
        else
        {
            middle = 0.5 * ((*cspan_at(&work, far + layout__ROLL_TRIAL_ROLL)) + (*cspan_at(&work, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR + layout__ROLL_TRIAL_ROLL)));
            roll__turn_both(work, middle);
            if (roll__search_both(work, left_tables, right_tables, state, INT64_C(0)) == INT64_C(0))
            {
                status = layout__OFF_PROFILE;
            }
            else if (sign * ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)) - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST))) > 0.0)
            {
                end += INT64_C(1);
                first_root__note_trial(work, layout__WORK_TRIALS + layout__ROLL_TRIALS_FAR + layout__ROLL_TRIAL_SIZE * end, middle);
            }
            else
            {
                /* a root before: it is the known one now */
                end = INT64_C(0);
                first_root__root_before(&roll, &status, work, left_tables, right_tables, state, (*cspan_at(&work, layout__WORK_TRIALS + layout__ROLL_TRIALS_NEAR + layout__ROLL_TRIAL_ROLL)), middle, sign);
                first_root__note_root(work, layout__WORK_TRIALS + layout__ROLL_TRIALS_FAR, roll);
            }
        }
        trial += INT64_C(1);
        if ((trial == first_root__TRIALS) || (end >= layout__TRIAL_LIMIT - INT64_C(2)))
        {
            status = layout__NOT_CONVERGED;
        }
    }
    if (status == layout__VALID)
    {
        roll__turn_both(work, roll);
        roll__search_both(work, left_tables, right_tables, state, INT64_C(0));
    }
    (*result_0) = roll;
    (*result_1) = status;
    return 0;
}

/* A root [rad] of D between the rolls ``near``, where D has the sign of ``sign``, and ``middle``, where
 * it has not; and the outcome.
 */
static inline int64_t first_root__root_before(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double near, double middle, double sign)
{
    double first;
    double last;
    first = near;
    last = middle + first_root__APART;
    if (sign < 0.0)
    {
        first = middle - first_root__APART;
        last = near;
    }
    roll__roll_between(result_0, result_1, work, left_tables, right_tables, state, middle, first, last, INT64_C(0));
    return 0;
}
