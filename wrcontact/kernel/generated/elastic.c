/* Generated from wheelset/elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium: the height and roll at which both wheels carry their loads.
 *
 * The wheels sink into their rails.  At a given roll each side has one height at which it carries its load; where these heights
 * are equal the wheelset stands.  Their difference D(roll) = height_right - height_left falls as that of the rigid gaps does
 * (:mod:`roll`), and a small load leaves the gaps themselves.  How a side's height follows the roll,
 *
 *     d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),
 *
 * is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's slope, by the
 * envelope theorem (docs/method.md, section 11).  Both unknowns are found by Broyden's method (Broyden 1965).
 *
 * Regions and nodes are laid where the wheels stand, which is found along with height and roll: a trial lays both wheels down at
 * one pose, and solves their loads; what either lacks of the height that it would carry its load at vanishes in equilibrium.
 * The compliant form is given height and roll,
 * and each wheel's load follows from how deep it stands.
 */

#include "elastic.h"

/* Estimate how far a wheel under ``force`` [N] sinks below its smallest gap; the outcome. */
static OUT_OF_LINE int64_t elastic__first_sink(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    int64_t support;
    int64_t status;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    status = side__rest_side(tables, work, state, index);
    (*cspan_at(&work, support + layout__SUPPORT_FIRST)) = 0.0;
    if (status == layout__UNLOADED)
    {
        status = layout__VALID;
        if (force > 0.0)
        {
            (*cspan_at(&work, support + layout__SUPPORT_FIRST)) = estimate__first_penetration(tables, work, state, force) / (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        }
    }
    return status;
}

/* Find at which height a side carries ``force`` [N], with regions and nodes laid where it stands at ``height`` [m]; its
 * outcome.  Outputs are those of the side under this force.
 */
static OUT_OF_LINE int64_t elastic__carry_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height)
{
    int64_t support;
    double best;
    double sink;
    int64_t count;
    double carried;
    int64_t status;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    best = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(force > 0.0))
    {
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = best;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = side__side_lever(tables, work, index, INT64_C(0));
        status = side__rest_side(tables, work, state, index);
        return status;
    }
    sink = height - best;
    if (sink < elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST)))
    {
        sink = elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST));
    }
    if (sink > elastic__DEEPEST)
    {
        sink = elastic__DEEPEST;
    }
    status = side__press_side(tables, work, state, index, sink);
    if (status == layout__VALID)
    {
        side__load_side(&count, &status, tables, work, state, index, force, (*cspan_at(&tables, layout__TABLES_ABSENT)));
        carried = sink + ((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_PENETRATION)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH))) / (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = best + carried;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = side__side_lever(tables, work, index, count);
    }
    return status;
}

/* Turn the wheelset to ``roll`` [rad] and find both smallest gaps; 1 if both wheels are above their rails, else 0. */
static OUT_OF_LINE int64_t elastic__turn_to(array_double_1d tables, array_double_1d work, array_double_1d state, double roll)
{
    int64_t known;
    int64_t result;
    roll__turn_both(work, roll);
    known = roll__follow_side(tables, work, state, INT64_C(0));
    if (known == INT64_C(1))
    {
        known = roll__follow_side(tables, work, state, INT64_C(1));
    }
    result = roll__search_both(tables, work, state, known);
    return result;
}

/* ``carry_side`` for both, under ``left`` and ``right`` [N]; the worse outcome. */
static OUT_OF_LINE int64_t elastic__carry_both(array_double_1d tables, array_double_1d work, array_double_1d state, double left, double right, double height)
{
    int64_t outcome;
    int64_t status;
    (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
    status = elastic__carry_side(tables, work, state, INT64_C(0), left, height);
    if (status <= layout__UNLOADED)
    {
        outcome = elastic__carry_side(tables, work, state, INT64_C(1), right, height);
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
}

/* 1 if a side carries its load deeper than DEEPEST, which the compliant form refuses too, else 0. */
static OUT_OF_LINE int64_t elastic__too_deep(array_double_1d work, int64_t index)
{
    double best;
    int64_t deep;
    deep = INT64_C(0);
    best = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_HEIGHT)) - best > elastic__DEEPEST)
    {
        deep = INT64_C(1);
    }
    return deep;
}

/* Roll [rad] at which the wheelset stands under ``left`` and ``right`` [N], and the outcome; outputs are those of the two
 * sides.  Starts at the rigid ``roll``, whose smallest gaps are known; where Broyden's method finds nothing, brackets do.
 */
static OUT_OF_LINE int64_t elastic__solve_elastic(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right)
{
    int64_t status;
    int64_t second;
    double rigid_roll;
    double lever_left;
    double lever_right;
    double turn;
    double height;
    double arm;
    double lack_left;
    double lack_right;
    double left_height;
    double left_roll;
    double right_height;
    double right_roll;
    double move_height;
    double move_roll;
    int64_t trial;
    double before_left;
    double before_right;
    double size;
    double off_left;
    double off_right;
    double determinant;
    status = elastic__first_sink(tables, work, state, INT64_C(0), left);
    if (status == layout__VALID)
    {
        status = elastic__first_sink(tables, work, state, INT64_C(1), right);
    }
    if (status != layout__VALID)
    {
        (*result_0) = roll;
        (*result_1) = status;
        return 0;
    }
    second = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1);
    rigid_roll = roll;
    /* where both would stand if each had sunk as estimated */
    lever_left = side__side_lever(tables, work, INT64_C(0), INT64_C(0));
    lever_right = side__side_lever(tables, work, INT64_C(1), INT64_C(0));
    turn = 0.0;
    if (lever_left + lever_right < -elastic__LEAST_LEVER)
    {
        turn = ((*cspan_at(&work, second + layout__SUPPORT_FIRST)) - (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_FIRST))) / (-(lever_left + lever_right));
    }
    turn = touching__limited(turn, elastic__LONGEST / (*cspan_at(&tables, layout__TABLES_ARM)));
    /* in one order for a wheelset and its mirror image */
    height = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST)) + 0.5 * ((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_FIRST)) - lever_left * turn + ((*cspan_at(&work, second + layout__SUPPORT_FIRST)) + lever_right * turn));
    roll += turn;
    if (elastic__turn_to(tables, work, state, roll) == INT64_C(0))
    {
        (*result_0) = roll;
        (*result_1) = layout__OFF_PROFILE;
        return 0;
    }
    /* Broyden's (1965) method for what both sides lack of the height, over height and roll; the roll in metres at the wheels */
    arm = (*cspan_at(&tables, layout__TABLES_ARM));
    lack_left = 0.0;
    lack_right = 0.0;
    left_height = -1.0;
    left_roll = 0.0;
    right_height = -1.0;
    right_roll = 0.0;
    move_height = 0.0;
    move_roll = 0.0;
    for (trial = INT64_C(0); trial < elastic__TRIALS; trial += INT64_C(1))
    {
        status = elastic__carry_both(tables, work, state, left, right, height);
        if (status > layout__UNLOADED)
        {
            break;
        }
        before_left = lack_left;
        before_right = lack_right;
        lack_left = (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) - height;
        lack_right = (*cspan_at(&work, second + layout__SUPPORT_HEIGHT)) - height;
        size = move_height * move_height + move_roll * move_roll;
        if (trial == INT64_C(0))
        {
            left_roll = (-(*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_LEVER))) / arm;
            right_roll = (*cspan_at(&work, second + layout__SUPPORT_LEVER)) / arm;
        }
        else if (size > 0.0)
        {
            off_left = (lack_left - before_left - left_height * move_height - left_roll * move_roll) / size;
            off_right = (lack_right - before_right - right_height * move_height - right_roll * move_roll) / size;
            left_height += off_left * move_height;
            left_roll += off_left * move_roll;
            right_height += off_right * move_height;
            right_roll += off_right * move_roll;
        }
        determinant = left_height * right_roll - right_height * left_roll;
        if (!(fabs(determinant) > elastic__SINGULAR))
        {
            left_height = -1.0;
            right_height = -1.0;
            left_roll = (-(*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_LEVER))) / arm;
            right_roll = (*cspan_at(&work, second + layout__SUPPORT_LEVER)) / arm;
            determinant = left_height * right_roll - right_height * left_roll;
            if (!(fabs(determinant) > elastic__SINGULAR))
            {
                break;
            }
        }
        move_height = (lack_right * left_roll - lack_left * right_roll) / determinant;
        move_roll = (lack_left * right_height - lack_right * left_height) / determinant;
        if ((fabs(move_height) < elastic__ELASTIC_SHARP) && (fabs(move_roll) < elastic__ELASTIC_SHARP))
        {
            if ((elastic__too_deep(work, INT64_C(0)) == INT64_C(1)) || (elastic__too_deep(work, INT64_C(1)) == INT64_C(1)))
            {
                status = layout__OFF_PROFILE;
            }
            (*result_0) = roll;
            (*result_1) = status;
            return 0;
        }
        move_height = touching__limited(move_height, elastic__LONGEST);
        move_roll = touching__limited(move_roll, elastic__LONGEST);
        height += move_height;
        roll += move_roll / arm;
        if (!(fabs(roll) < layout__ROLL_LIMIT))
        {
            break;
        }
        if (elastic__turn_to(tables, work, state, roll) == INT64_C(0))
        {
            break;
        }
    }
    elastic__bracket_roll(&roll, &status, tables, work, state, rigid_roll, left, right);
    (*result_0) = roll;
    (*result_1) = status;
    return 0;
}

/* Where to look next for a zero between two values of opposite sign: on their chord, and every other time half way. */
static OUT_OF_LINE double elastic__within_bracket(double low, double high, double at_low, double at_high, int64_t i)
{
    double chord;
    double place;
    place = 0.5 * (low + high);
    if (pyc_modulo(i, INT64_C(2)) == INT64_C(0))
    {
        chord = low - at_low * (high - low) / (at_high - at_low);
        if ((chord > low) && (chord < high))
        {
            place = chord;
        }
    }
    return place;
}

/* What ``count`` regions carry [N], vertically where the prescribed load is vertical. */
static OUT_OF_LINE double elastic__carried_load(array_double_1d work, int64_t count)
{
    int64_t region;
    int64_t block;
    double total;
    total = 0.0;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        total += (*cspan_at(&work, block + layout__REGION_SHARE)) * (*cspan_at(&work, block + layout__REGION_CARRIED));
    }
    return total;
}

/* What a side that is laid down at ``height`` lacks of the height at which it carries ``force`` [m]; 1 if it is carried
 * there, else 0; and the outcome.
 *
 * The nodes of a deep stand may carry more than the force at every level, or less; then what they carry at ``height``
 * tells whether that is too low or too high, and the lack counts as the whole depth.
 */
static OUT_OF_LINE int64_t elastic__lay_side(double* lack, int64_t* met, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height)
{
    int64_t support;
    double sink;
    int64_t count;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    (*status) = elastic__carry_side(tables, work, state, index, force, height);
    (*lack) = (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) - height;
    (*met) = INT64_C(1);
    if ((*status) == layout__NOT_CONVERGED)
    {
        (*met) = INT64_C(0);
        sink = height - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
        if (sink > elastic__DEEPEST)
        {
            sink = elastic__DEEPEST;
        }
        if (sink < elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST)))
        {
            sink = elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST));
        }
        (*status) = side__press_side(tables, work, state, index, sink);
        if ((*status) == layout__VALID)
        {
            side__load_side(&count, status, tables, work, state, index, 0.0, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)));
            (*lack) = sink;
            if (elastic__carried_load(work, count) > force)
            {
                (*lack) = -sink;
            }
            (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = height + (*lack);
        }
    }
    return 0;
}

/* Find the height at which a side carries ``force`` [N] when it is laid down just there; the outcome.
 *
 * Laid down too high it lacks height, too low it has too much.  Where its load jumps past the force as it comes down, since
 * a region comes or goes, the height of the jump is taken, with the regions just below it, or just above where those cannot
 * carry the force.  Where DEEPEST is too high the height is what it would be with regions as they are there.
 */
static OUT_OF_LINE int64_t elastic__bracket_height(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    int64_t support;
    double best;
    double low;
    double lack_low;
    int64_t met;
    double high;
    double lack_high;
    int64_t i;
    double height;
    double lack;
    int64_t status;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    best = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(force > 0.0))
    {
        status = elastic__carry_side(tables, work, state, index, force, best);
        return status;
    }
    low = best + elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST));
    elastic__lay_side(&lack_low, &met, &status, tables, work, state, index, force, low);
    if (status > layout__UNLOADED)
    {
        return status;
    }
    if (lack_low <= 0.0)
    {
        if (met == INT64_C(0))
        {
            status = layout__NOT_CONVERGED;
        }
        return status;
    }
    high = low;
    lack_high = lack_low;
    while(lack_high > 0.0)
    {
        if (high >= best + elastic__DEEPEST)
        {
            return status;
        }
        low = high;
        lack_low = lack_high;
        high = best + 1.5 * (high - best);
        if (high > best + elastic__DEEPEST)
        {
            high = best + elastic__DEEPEST;
        }
        elastic__lay_side(&lack_high, &met, &status, tables, work, state, index, force, high);
        if (status > layout__UNLOADED)
        {
            return status;
        }
    }
    for (i = INT64_C(0); i < elastic__BRACKETINGS; i += INT64_C(1))
    {
        height = elastic__within_bracket(low, high, lack_low, lack_high, i);
        elastic__lay_side(&lack, &met, &status, tables, work, state, index, force, height);
        if (status > layout__UNLOADED)
        {
            return status;
        }
        if (fabs(lack) < elastic__BRACKET_SHARP)
        {
            return status;
        }
        if (lack > 0.0)
        {
            low = height;
            lack_low = lack;
        }
        else
        {
            high = height;
            lack_high = lack;
        }
        if (high - low < elastic__BRACKET_SHARP)
        {
            break;
        }
    }
    status = elastic__carry_side(tables, work, state, index, force, high);
    if (status == layout__NOT_CONVERGED)
    {
        status = elastic__carry_side(tables, work, state, index, force, low);
    }
    (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = high;
    return status;
}

/* The side whose wheel touches at the smaller angle, by the outputs of both sides; the left one where they are equal. */
static OUT_OF_LINE int64_t elastic__flatter_side(array_double_1d work)
{
    int64_t flat;
    flat = INT64_C(0);
    if (fabs((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_CONTACT_ANGLE))) < fabs((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_CONTACT_ANGLE))))
    {
        flat = INT64_C(1);
    }
    return flat;
}

/* Let side ``flat`` carry its load at ``roll``, and lay down the other one at this height; how much lower the right one
 * would stand than the left one [m], 1 if either load is carried, else 0, and the outcome.
 */
static OUT_OF_LINE int64_t elastic__stand_at(double* lack, int64_t* met, int64_t* result_2, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right, int64_t flat)
{
    double flat_force;
    double steep_force;
    int64_t status;
    double height;
    int64_t outcome;
    if (elastic__turn_to(tables, work, state, roll) == INT64_C(0))
    {
        (*lack) = 0.0;
        (*met) = INT64_C(0);
        (*result_2) = layout__OFF_PROFILE;
        return 0;
    }
    (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
    flat_force = left;
    steep_force = right;
    if (flat == INT64_C(1))
    {
        flat_force = right;
        steep_force = left;
    }
    status = elastic__bracket_height(tables, work, state, flat, flat_force);
    if (status > layout__UNLOADED)
    {
        (*lack) = 0.0;
        (*met) = INT64_C(0);
        (*result_2) = status;
        return 0;
    }
    height = (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * flat + layout__SUPPORT_HEIGHT));
    elastic__lay_side(lack, met, &outcome, tables, work, state, INT64_C(1) - flat, steep_force, height);
    (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * (INT64_C(1) - flat) + layout__SUPPORT_HEIGHT)) = height;
    if (outcome > status)
    {
        status = outcome;
    }
    if (flat == INT64_C(1))
    {
        (*lack) = -(*lack);
    }
    (*result_2) = status;
    return 0;
}

/* ``solve_elastic`` by brackets around brackets: slow, and it cannot fail while the flatter wheel carries its load.
 *
 * A steep flange may carry its load at several heights of one roll, or at none that is not too deep; at the
 * height of the other wheel its load has one value at every roll.  Where that jumps past the force, since a region comes or
 * goes, the roll of the jump is taken.
 */
static OUT_OF_LINE int64_t elastic__bracket_roll(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right)
{
    int64_t flat;
    double difference;
    int64_t met;
    int64_t status;
    double low;
    double high;
    double at_low;
    double at_high;
    double reach;
    int64_t i;
    double end;
    double other;
    flat = elastic__flatter_side(work);
    elastic__stand_at(&difference, &met, &status, tables, work, state, roll, left, right, flat);
    if (status > layout__UNLOADED)
    {
        (*result_0) = roll;
        (*result_1) = status;
        return 0;
    }
    low = roll;
    high = roll;
    at_low = difference;
    at_high = difference;
    reach = elastic__FIRST_REACH;
    while(at_low * at_high > 0.0)
    {
        if (reach > layout__ROLL_LIMIT)
        {
            (*result_0) = roll;
            (*result_1) = layout__NOT_CONVERGED;
            return 0;
        }
        if (difference > 0.0)
        {
            low = high;
            at_low = at_high;
            high = roll + reach;
            elastic__stand_at(&at_high, &met, &status, tables, work, state, high, left, right, flat);
        }
        else
        {
            high = low;
            at_high = at_low;
            low = roll - reach;
            elastic__stand_at(&at_low, &met, &status, tables, work, state, low, left, right, flat);
        }
        if (status > layout__UNLOADED)
        {
            (*result_0) = roll;
            (*result_1) = status;
            return 0;
        }
        reach *= 2.0;
    }
    for (i = INT64_C(0); i < elastic__BRACKETINGS; i += INT64_C(1))
    {
        roll = elastic__within_bracket(low, high, at_low, at_high, i);
        elastic__stand_at(&difference, &met, &status, tables, work, state, roll, left, right, flat);
        if (status > layout__UNLOADED)
        {
            (*result_0) = roll;
            (*result_1) = status;
            return 0;
        }
        if (difference > 0.0)
        {
            low = roll;
            at_low = difference;
        }
        else
        {
            high = roll;
            at_high = difference;
        }
        if ((fabs(difference) < elastic__BRACKET_SHARP) || (high - low < elastic__BRACKET_SHARP))
        {
            break;
        }
    }
    if (fabs(difference) >= elastic__BRACKET_SHARP)
    {
        /* of both ends of a jump always the same, at which the steeper wheel carries no less than its load */
        end = high;
        if (flat == INT64_C(1))
        {
            end = low;
        }
        if (roll != end)
        {
            roll = end;
            elastic__stand_at(&difference, &met, &status, tables, work, state, roll, left, right, flat);
        }
    }
    if (met == INT64_C(0))
    {
        /* or the one whose nodes can carry the force */
        other = low;
        if (roll == low)
        {
            other = high;
        }
        roll = other;
        elastic__stand_at(&difference, &met, &status, tables, work, state, roll, left, right, flat);
    }
    if (status <= layout__UNLOADED)
    {
        if (met == INT64_C(0))
        {
            status = layout__NOT_CONVERGED;
        }
        if ((elastic__too_deep(work, INT64_C(0)) == INT64_C(1)) || (elastic__too_deep(work, INT64_C(1)) == INT64_C(1)))
        {
            status = layout__OFF_PROFILE;
        }
    }
    (*result_0) = roll;
    (*result_1) = status;
    return 0;
}

/* The load of a side whose wheelset stands at the vertical shift ``height`` [m]; its outcome, UNLOADED if lifted. */
static OUT_OF_LINE int64_t elastic__bear_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double height)
{
    double sink;
    int64_t status;
    int64_t count;
    int64_t result;
    sink = height - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(sink > elastic__GRAZING))
    {
        result = side__rest_side(tables, work, state, index);
        return result;
    }
    if (sink > elastic__DEEPEST)
    {
        return layout__OFF_PROFILE;
    }
    status = side__press_side(tables, work, state, index, sink);
    if (status == layout__VALID)
    {
        side__load_side(&count, &status, tables, work, state, index, 0.0, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)));
    }
    return status;
}

/* Compliant contact: the wheelset stands at the height and roll of the inputs; the outcome. */
static OUT_OF_LINE int64_t elastic__stand_compliant(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    double roll;
    double height;
    int64_t status;
    int64_t index;
    int64_t outcome;
    roll = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL));
    height = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_SHIFT));
    roll__place_both(tables, work, roll);
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height;
    status = layout__VALID;
    if (roll__search_both(tables, work, state, INT64_C(0)) == INT64_C(0))
    {
        return layout__OFF_PROFILE;
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        outcome = elastic__bear_side(tables, work, state, index, height);
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
}
