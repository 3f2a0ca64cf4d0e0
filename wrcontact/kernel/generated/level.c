/* Generated from search/level.py by tools/transpile_kernel.py; change that one.
 *
 * Where the wheels could stand at several rolls: the first one from level.
 *
 * While a flange is less steep than both levers allow, D(roll) = gap_right - gap_left (roll.py) falls and has one zero.  A large
 * wheel on a steep flange (600 mm on 70 deg), or strong yaw with both flanges on the rails, lets D rise in between, and it has
 * three.
 * The roll is then the first zero on the way from level to the side on which D(0) tells that there is one: it depends on nothing
 * but the pose, and D falls through it.
 *
 * That no zero lies before a known one is certified.  On that way the contact of the wheel that rises moves towards its flange and
 * the other's away from it, since rails are convex; so D' is bounded by the steepest places of the wheels between their contacts
 * at both ends of the way.  Where this does not settle it, the way is halved.
 */

#include "level.h"

/* How fast a lever changes with the roll at most, where profiles are as steep as ``steep`` [m]. */
static inline double level__turned(double steep, double radius, double arm)
{
    return level__TURNED_SHARE * ((1.0 + steep * steep) * radius + steep * arm + radius);
}

/* The largest lever of a wheel at ``y`` [m] and beyond, towards the field side, for any roll up to ``roll`` [rad] and the
 * yaw whose sine is given.
 */
static inline double level__lever_beyond(array_double_1d tables, double y, double roll, double sine)
{
    int64_t scan;
    double lever;
    double radius;
    double arm;
    double steep;
    double yawed;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES;
    lever = (*cspan_at(&tables, scan + search__SCAN_ROW * search__node_below(tables, y) + search__ROW_LEVER));
    radius = (*cspan_at(&tables, layout__TABLES_RADIUS));
    arm = (*cspan_at(&tables, layout__TABLES_ARM));
    steep = fabs(lever + arm) / radius;
    yawed = level__YAWED_SHARE * 0.5 * steep * (1.0 + steep * steep) * radius * sine * sine;
    return lever + level__turned(steep, radius, arm) * fabs(roll) + yawed;
}

/* 1 if all places of a wheel whose levers are not below -``known`` [m] are beside the rail when level, else 0. */
static inline int64_t level__beside_rail(array_double_1d tables, array_double_1d work, int64_t at, double known, double roll, double sine)
{
    int64_t scan;
    int64_t nodes;
    int64_t low;
    int64_t high;
    int64_t middle;
    double reach;
    double furthest;
    int64_t beside;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    nodes = scan + search__SCAN_NODES;
    low = -INT64_C(1);
    high = (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT))) - INT64_C(1);
    while(high - low > INT64_C(1))
    {
        middle = py_floor_div_int64_t((low + high), INT64_C(2));
        if (known + level__lever_beyond(tables, (*cspan_at(&tables, nodes + search__SCAN_ROW * middle + search__ROW_Y)), roll, sine) < 0.0)
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
        reach = search__REACH_SHARE * sine * sine * (*cspan_at(&tables, layout__TABLES_RADIUS)) * (*cspan_at(&tables, scan + search__SCAN_STEEPEST));
        furthest = (*cspan_at(&work, at + layout__PLACE_SHIFT)) + (*cspan_at(&tables, layout__TABLES_ARM)) + (*cspan_at(&tables, nodes + search__SCAN_ROW * high + search__ROW_Y)) + reach;
        if (furthest > (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START)))
        {
            beside = INT64_C(0);
        }
    }
    return beside;
}

/* 1 if D falls all the way from level to its zero at ``roll``, as far as the steepest places tell, else 0.
 *
 * The wheel that stands higher is known there; of the other one what is not beside the rail when level is taken, or what lies
 * beyond its contact when level, for which that one is searched.
 */
static inline int64_t level__certainly_first(array_double_1d tables, array_double_1d work, array_double_1d state, double roll)
{
    double sine;
    int64_t higher;
    int64_t lower;
    int64_t lower_place;
    int64_t index;
    double known;
    double gap;
    double y;
    double abscissa;
    int64_t followed;
    int64_t certain;
    sine = (*cspan_at(&work, layout__WORK_PLACES + layout__PLACE_SIZE * INT64_C(1) + layout__PLACE_SIN_YAW));
    higher = layout__WORK_SIDES;
    lower = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1);
    lower_place = layout__WORK_PLACES + layout__PLACE_SIZE * INT64_C(1);
    index = INT64_C(1);
    if (roll < 0.0)
    {
        higher = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1);
        lower = layout__WORK_SIDES;
        lower_place = layout__WORK_PLACES;
        index = INT64_C(0);
    }
    known = level__lever_beyond(tables, (*cspan_at(&work, higher + layout__SIDE_SEARCH_BEST_Y)), roll, sine);
    if (level__beside_rail(tables, work, lower_place, known, roll, sine) == INT64_C(1))
    {
        return INT64_C(1);
    }
    gap = (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST));
    y = (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_Y));
    abscissa = (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_RAIL));
    certain = INT64_C(0);
    roll__turn_both(work, 0.0);
    followed = roll__follow_side(tables, work, state, index);
    if (search__search_side(tables, work, lower, work, lower_place, state, followed) == INT64_C(1))
    {
        if (known + level__lever_beyond(tables, (*cspan_at(&work, lower + layout__SIDE_SEARCH_BEST_Y)), roll, sine) < 0.0)
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

/* 1 if D falls through its known zero at ``roll``, and that is level, else 0. */
static inline int64_t level__falls_at_level(array_double_1d tables, array_double_1d work, double roll)
{
    double difference;
    double move;
    int64_t falls;
    falls = INT64_C(0);
    if (fabs(roll) < level__APART)
    {
        roll__newton_move(&difference, &move, tables, work);
        if (fabs(move) < 0.5)
        {
            falls = INT64_C(1);
        }
    }
    return falls;
}

/* How the gap at ``y`` [m] would change with the roll if the rail there were parallel to the wheel [m]. */
static inline double level__lever_at(array_double_1d tables, array_double_1d work, int64_t at, double y)
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
static inline int64_t level__lever_range(double* least, double* most, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t at, double one, double other)
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
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES;
    y = one;
    last = other;
    if (other < one)
    {
        y = other;
        last = one;
    }
    node = search__node_below(tables, y);
    before = level__lever_at(tables, work, at, y);
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
    (*least) = before;
    (*most) = before;
    while(y < last)
    {
        bend = (*cspan_at(&tables, scan + search__SCAN_ROW * node + search__ROW_STEEPEST_BENDS));
        node += INT64_C(1);
        following = (*cspan_at(&tables, scan + search__SCAN_ROW * node + search__ROW_Y));
        if ((following > last) || (following <= y))
        {
            following = last;
        }
        lever = level__lever_at(tables, work, at, following);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        beyond = 0.5 * level__FASTER * bend * (following - y) * ((*cspan_at(&work, at + layout__PLACE_RADIUS)) + (*cspan_at(&work, at + layout__PLACE_ARM)));
        (*least) = double_min(2, (*least), double_min(2, lever, before) - beyond);
        (*most) = double_max(2, (*most), double_max(2, lever, before) + beyond);
        before = lever;
        y = following;
    }
    return 0;
}

/* Keep what is known of D at ``roll`` [rad]. */
static inline int64_t level__note_entry(array_double_1d work, int64_t entry, double roll)
{
    (*cspan_at(&work, entry + level__ENTRY_ROLL)) = roll;
    (*cspan_at(&work, entry + level__ENTRY_DIFFERENCE)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)) - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST));
    (*cspan_at(&work, entry + level__ENTRY_LEFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    (*cspan_at(&work, entry + level__ENTRY_RIGHT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    return INT64_C(0);
}

/* 1 if D certainly has no zero between the entries ``near`` and ``far``, where it has the sign of ``sign`` or, at ``far``, is
 * zero; else 0.
 */
static inline int64_t level__is_clear(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t near, int64_t far, double sign)
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
    width = fabs((*cspan_at(&work, far + level__ENTRY_ROLL)) - (*cspan_at(&work, near + level__ENTRY_ROLL)));
    roll__turn_both(work, 0.5 * ((*cspan_at(&work, far + level__ENTRY_ROLL)) + (*cspan_at(&work, near + level__ENTRY_ROLL))));
    level__lever_range(&left_least, &left_most, tables, work, state, layout__WORK_PLACES, (*cspan_at(&work, near + level__ENTRY_LEFT)), (*cspan_at(&work, far + level__ENTRY_LEFT)));
    level__lever_range(&right_least, &right_most, tables, work, state, layout__WORK_PLACES + layout__PLACE_SIZE * INT64_C(1), (*cspan_at(&work, near + level__ENTRY_RIGHT)), (*cspan_at(&work, far + level__ENTRY_RIGHT)));
    arm = (*cspan_at(&tables, layout__TABLES_ARM));
    radius = (*cspan_at(&tables, layout__TABLES_RADIUS));
    steep = (double_max(2, double_max(2, fabs(left_least), fabs(left_most)), double_max(2, fabs(right_least), fabs(right_most))) + arm) / radius;
    margin = width * level__turned(steep, radius, arm);
    least = left_least + right_least - margin;
    most = left_most + right_most + margin;
    if ((least >= 0.0) || (most <= 0.0))
    {
        return INT64_C(1);
    }
    at_near = sign * (*cspan_at(&work, near + level__ENTRY_DIFFERENCE));
    at_far = sign * (*cspan_at(&work, far + level__ENTRY_DIFFERENCE));
    /* the lines that bound D from below, from either end */
    meet = (at_far - most * width - at_near) / (least - most);
    clear = INT64_C(0);
    if ((meet >= width) || (at_near + least * meet > 0.0))
    {
        clear = INT64_C(1);
    }
    return clear;
}

/* The first zero [rad] of D from level, and the outcome; D has a zero at ``roll``. */
static inline int64_t level__first_from_level(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, double roll)
{
    double difference;
    double sign;
    double first;
    double last;
    int64_t status;
    int64_t end;
    int64_t trial;
    int64_t far;
    double width;
    int64_t i;
    double middle;
    double near;
    level__note_entry(work, level__ENDS, roll);
    (*cspan_at(&work, level__ENDS + level__ENTRY_DIFFERENCE)) = 0.0;
    roll__turn_both(work, 0.0);
    if (roll__search_both(tables, work, state, INT64_C(0)) == INT64_C(0))
    {
        (*result_0) = 0.0;
        (*result_1) = layout__OFF_PROFILE;
        return 0;
    }
    level__note_entry(work, level__LEVEL, 0.0);
    difference = (*cspan_at(&work, level__LEVEL + level__ENTRY_DIFFERENCE));
    if (difference == 0.0)
    {
        (*result_0) = 0.0;
        (*result_1) = layout__VALID;
        return 0;
    }
    sign = 1.0;
    first = 0.0;
    last = layout__ROLL_LIMIT;
    if (difference < 0.0)
    {
        sign = -1.0;
        first = -layout__ROLL_LIMIT;
        last = 0.0;
    }
    status = layout__VALID;
    if (sign * roll < 0.0)
    {
        roll__close_in(&roll, &status, tables, work, state, 0.5 * (first + last), first, last, INT64_C(0));
        level__note_entry(work, level__ENDS, roll);
        (*cspan_at(&work, level__ENDS + level__ENTRY_DIFFERENCE)) = 0.0;
    }
    end = INT64_C(0);
    trial = INT64_C(0);
    while((end >= INT64_C(0)) && (status == layout__VALID))
    {
        far = level__ENDS + level__ENTRY_SIZE * end;
        width = fabs((*cspan_at(&work, far + level__ENTRY_ROLL)) - (*cspan_at(&work, level__LEVEL + level__ENTRY_ROLL)));
        if ((width < level__APART) || (level__is_clear(tables, work, state, level__LEVEL, far, sign) == INT64_C(1)))
        {
            for (i = INT64_C(0); i < level__ENTRY_SIZE; i += INT64_C(1))
            {
                (*cspan_at(&work, level__LEVEL + i)) = (*cspan_at(&work, far + i));
            }
            end -= INT64_C(1);
        }
        else
        {
            middle = 0.5 * ((*cspan_at(&work, far + level__ENTRY_ROLL)) + (*cspan_at(&work, level__LEVEL + level__ENTRY_ROLL)));
            roll__turn_both(work, middle);
            if (roll__search_both(tables, work, state, INT64_C(0)) == INT64_C(0))
            {
                status = layout__OFF_PROFILE;
            }
            else if (sign * ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST)) - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST))) > 0.0)
            {
                end += INT64_C(1);
                level__note_entry(work, level__ENDS + level__ENTRY_SIZE * end, middle);
            }
            else
            {
                /* a zero before: it is the known one now */
                near = (*cspan_at(&work, level__LEVEL + level__ENTRY_ROLL));
                end = INT64_C(0);
                if (sign > 0.0)
                {
                    roll__close_in(&roll, &status, tables, work, state, middle, near, middle + level__APART, INT64_C(0));
                }
                else
                {
                    roll__close_in(&roll, &status, tables, work, state, middle, middle - level__APART, near, INT64_C(0));
                }
                level__note_entry(work, level__ENDS, roll);
                (*cspan_at(&work, level__ENDS + level__ENTRY_DIFFERENCE)) = 0.0;
            }
        }
        trial += INT64_C(1);
        if ((trial == level__TRIALS) || (end >= level__ENTRY_LIMIT - INT64_C(2)))
        {
            status = layout__NOT_CONVERGED;
        }
    }
    if (status == layout__VALID)
    {
        roll__turn_both(work, roll);
        roll__search_both(tables, work, state, INT64_C(0));
    }
    (*result_0) = roll;
    (*result_1) = status;
    return 0;
}

/* ``solve_roll`` from this start alone. */
static inline int64_t level__certified_roll(double* roll, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, double guess, int64_t warm)
{
    roll__some_roll(roll, status, tables, work, state, guess, warm);
    if (((*status) == layout__VALID) && (level__falls_at_level(tables, work, (*roll)) == INT64_C(0)))
    {
        if (level__certainly_first(tables, work, state, (*roll)) == INT64_C(0))
        {
            level__first_from_level(roll, status, tables, work, state, (*roll));
        }
    }
    return 0;
}

/* Roll [rad] of the wheelset and outcome; the sides' smallest gaps stay in the workspace.
 *
 * With ``warm`` = 1 SIDE_BEST_Y holds minima to start from.  A start from which there is no roll does not decide that.
 */
static inline int64_t level__solve_roll(double* roll, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, double guess, int64_t warm)
{
    level__certified_roll(roll, status, tables, work, state, guess, warm);
    if (((*status) != layout__VALID) && ((guess != 0.0) || (warm == INT64_C(1))))
    {
        level__certified_roll(roll, status, tables, work, state, 0.0, INT64_C(0));
    }
    return 0;
}
