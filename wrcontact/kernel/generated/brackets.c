/* Generated from wheelset/brackets.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium by brackets around brackets: slow, and it cannot fail while the
 * flatter wheel carries its load.
 *
 * A steep flange may carry its load at several heights of one roll, or at none that is not too deep; at the
 * height of the other wheel its load has one value at every roll. So the flatter wheel gives the height of each
 * roll, and the steeper one the residual that changes its sign at the roll in equilibrium. Where that jumps,
 * since a region comes or goes, the roll of the jump is taken.
 */

#include "brackets.h"

/* Where to look next for a root in a bracket: on the chord between both values,
 * and every other time half way.
 */
static OUT_OF_LINE double brackets__next_in_bracket(array_double_1d work, int64_t bracket, int64_t i)
{
    double low;
    double high;
    double chord;
    double place;
    low = (*cspan_at(&work, bracket + layout__BRACKET_LOW));
    high = (*cspan_at(&work, bracket + layout__BRACKET_HIGH));
    place = 0.5 * (low + high);
    if (pyc_modulo(i, INT64_C(2)) == INT64_C(0))
    {
        chord = low - (*cspan_at(&work, bracket + layout__BRACKET_AT_LOW)) * (high - low) / ((*cspan_at(&work, bracket + layout__BRACKET_AT_HIGH)) - (*cspan_at(&work, bracket + layout__BRACKET_AT_LOW)));
        if ((chord > low) && (chord < high))
        {
            place = chord;
        }
    }
    return place;
}

/* Let ``place`` be an end of the bracket: the low one if its ``value`` is positive, else the high one. */
static OUT_OF_LINE int64_t brackets__narrow_bracket(array_double_1d work, int64_t bracket, double place, double value)
{
    if (value > 0.0)
    {
        (*cspan_at(&work, bracket + layout__BRACKET_LOW)) = place;
        (*cspan_at(&work, bracket + layout__BRACKET_AT_LOW)) = value;
    }
    else
    {
        (*cspan_at(&work, bracket + layout__BRACKET_HIGH)) = place;
        (*cspan_at(&work, bracket + layout__BRACKET_AT_HIGH)) = value;
    }
    return INT64_C(0);
}

/* What ``count`` regions carry [N], vertically where the prescribed load is vertical. */
static OUT_OF_LINE double brackets__carried_load(array_double_1d work, int64_t count)
{
    int64_t index;
    int64_t region;
    double total;
    total = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        total += (*cspan_at(&work, region + layout__REGION_SHARE)) * (*cspan_at(&work, region + layout__REGION_CARRIED));
    }
    return total;
}

/* How much lower than ``height`` [m] a side carries ``force`` [N], with regions and nodes as they are
 * there [m]; 1 if they can carry it, else 0; and the outcome.
 *
 * The nodes of a deep wheel may carry more than the force at every approach, or less; then what they carry
 * at ``height`` shows whether that is too low or too high, and the residual counts as the whole approach.
 */
static OUT_OF_LINE int64_t brackets__height_residual(double* residual, int64_t* satisfied, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height)
{
    int64_t support;
    double approach;
    int64_t count;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    (*status) = trial__balance_side(tables, work, state, index, force, height);
    (*residual) = (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) - height;
    (*satisfied) = INT64_C(1);
    if ((*status) == layout__NOT_CONVERGED)
    {
        (*satisfied) = INT64_C(0);
        approach = trial__permitted_approach(work, support, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index, height);
        (*status) = side__press_side(tables, work, state, index, approach);
        if ((*status) == layout__VALID)
        {
            side__load_side(&count, status, tables, work, state, index, 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)));
            (*residual) = approach;
            if (brackets__carried_load(work, count) > force)
            {
                (*residual) = -approach;
            }
            (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = height + (*residual);
        }
    }
    return 0;
}

/* Find the height at which a side carries ``force`` [N] with regions and nodes as they
 * are just there; the outcome.
 *
 * The residual is positive where the side is too high, negative where it is too low. Where its load jumps
 * past the force as it comes down, since a region comes or goes, the height of the jump is taken, with the
 * regions just below it, or just above where those cannot carry the force. Where DEEPEST is too high the
 * height is what it would be with regions as they are there.
 */
static OUT_OF_LINE int64_t brackets__bracket_height(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    int64_t support;
    double best;
    double height;
    double residual;
    int64_t satisfied;
    int64_t i;
    int64_t status;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    best = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(force > 0.0))
    {
        status = trial__balance_side(tables, work, state, index, force, best);
        return status;
    }
    height = best + trial__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_APPROACH));
    brackets__height_residual(&residual, &satisfied, &status, tables, work, state, index, force, height);
    if (status > layout__UNLOADED)
    {
        return status;
    }
    if (residual <= 0.0)
    {
        if (satisfied == INT64_C(0))
        {
            status = layout__NOT_CONVERGED;
        }
        return status;
    }
    (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH)) = height;
    (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_AT_HIGH)) = residual;
    while((*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_AT_HIGH)) > 0.0)
    {
        if ((*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH)) >= best + trial__DEEPEST)
        {
            return status;
        }
        (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_LOW)) = (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH));
        (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_AT_LOW)) = (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_AT_HIGH));
        height = best + brackets__DEEPER * ((*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH)) - best);
        if (height > best + trial__DEEPEST)
        {
            height = best + trial__DEEPEST;
        }
        brackets__height_residual(&residual, &satisfied, &status, tables, work, state, index, force, height);
        (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH)) = height;
        (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_AT_HIGH)) = residual;
        if (status > layout__UNLOADED)
        {
            return status;
        }
    }
    for (i = INT64_C(0); i < brackets__BRACKETINGS; i += INT64_C(1))
    {
        height = brackets__next_in_bracket(work, layout__WORK_HEIGHT_BRACKET, i);
        brackets__height_residual(&residual, &satisfied, &status, tables, work, state, index, force, height);
        if ((status > layout__UNLOADED) || (fabs(residual) < brackets__BRACKET_SHARP))
        {
            return status;
        }
        brackets__narrow_bracket(work, layout__WORK_HEIGHT_BRACKET, height, residual);
        if ((*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH)) - (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_LOW)) < brackets__BRACKET_SHARP)
        {
            break;
        }
    }
    status = trial__balance_side(tables, work, state, index, force, (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH)));
    if (status == layout__NOT_CONVERGED)
    {
        status = trial__balance_side(tables, work, state, index, force, (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_LOW)));
    }
    (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work, layout__WORK_HEIGHT_BRACKET + layout__BRACKET_HIGH));
    return status;
}

/* The side whose wheel touches at the smaller angle, by the outputs of both sides; the left one
 * where they are equal.
 */
static OUT_OF_LINE int64_t brackets__flatter_side(array_double_1d work)
{
    int64_t flat;
    flat = INT64_C(0);
    if (fabs((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_CONTACT_ANGLE))) < fabs((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_CONTACT_ANGLE))))
    {
        flat = INT64_C(1);
    }
    return flat;
}

/* Let side ``flat`` carry its load at ``roll``, and move the other one to this height;
 * how much lower the right one carries its load than the left one [m], 1 if both can carry
 * their loads, else 0, and the outcome.
 */
static OUT_OF_LINE int64_t brackets__roll_residual(double* residual, int64_t* satisfied, int64_t* result_2, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right, int64_t flat)
{
    int64_t status;
    if (trial__turn_to(left_tables, right_tables, work, state, roll) == INT64_C(0))
    {
        (*residual) = 0.0;
        (*satisfied) = INT64_C(0);
        (*result_2) = layout__OFF_PROFILE;
        return 0;
    }
    (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
    if (flat == INT64_C(1))
    {
        brackets__level_residual(residual, satisfied, &status, right_tables, left_tables, work, state, INT64_C(1), right, left);
        (*residual) = -(*residual);
    }
    else
    {
        brackets__level_residual(residual, satisfied, &status, left_tables, right_tables, work, state, INT64_C(0), left, right);
    }
    (*result_2) = status;
    return 0;
}

/* Let side ``flat`` carry ``flat_force`` [N], and move the other one to this height; how much lower the
 * other one carries ``steep_force`` [N] [m], 1 if both can carry their loads, else 0, and the outcome.
 */
static OUT_OF_LINE int64_t brackets__level_residual(double* residual, int64_t* satisfied, int64_t* status, array_double_1d flat_tables, array_double_1d steep_tables, array_double_1d work, array_double_1d state, int64_t flat, double flat_force, double steep_force)
{
    double height;
    int64_t outcome;
    (*status) = brackets__bracket_height(flat_tables, work, state, flat, flat_force);
    if ((*status) > layout__UNLOADED)
    {
        (*residual) = 0.0;
        (*satisfied) = INT64_C(0);
        return 0;
    }
    height = (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * flat + layout__SUPPORT_HEIGHT));
    brackets__height_residual(residual, satisfied, &outcome, steep_tables, work, state, INT64_C(1) - flat, steep_force, height);
    (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * (INT64_C(1) - flat) + layout__SUPPORT_HEIGHT)) = height;
    if (outcome > (*status))
    {
        (*status) = outcome;
    }
    return 0;
}

/* Bracket the roll in equilibrium by looking further and further from ``roll`` on; the outcome,
 * NOT_CONVERGED if there is none within ROLL_LIMIT.
 */
static OUT_OF_LINE int64_t brackets__enclose_roll(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right, int64_t flat)
{
    double residual;
    int64_t satisfied;
    int64_t status;
    double reach;
    double value;
    brackets__roll_residual(&residual, &satisfied, &status, left_tables, right_tables, work, state, roll, left, right, flat);
    if (status > layout__UNLOADED)
    {
        return status;
    }
    (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW)) = roll;
    (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH)) = roll;
    (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_LOW)) = residual;
    (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_HIGH)) = residual;
    reach = brackets__FIRST_REACH;
    while((*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_LOW)) * (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_HIGH)) > 0.0)
    {
        if (reach > layout__ROLL_LIMIT)
        {
            return layout__NOT_CONVERGED;
        }
        if (residual > 0.0)
        {
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW)) = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH));
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_LOW)) = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_HIGH));
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH)) = roll + reach;
            brackets__roll_residual(&value, &satisfied, &status, left_tables, right_tables, work, state, (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH)), left, right, flat);
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_HIGH)) = value;
        }
        else
        {
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH)) = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW));
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_HIGH)) = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_LOW));
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW)) = roll - reach;
            brackets__roll_residual(&value, &satisfied, &status, left_tables, right_tables, work, state, (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW)), left, right, flat);
            (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_AT_LOW)) = value;
        }
        if (status > layout__UNLOADED)
        {
            return status;
        }
        reach *= 2.0;
    }
    return status;
}

/* Roll [rad] of the wheelset in equilibrium under ``left`` and ``right`` [N], and the outcome,
 * from the rigid ``roll``.
 */
static OUT_OF_LINE int64_t brackets__bracket_roll(double* result_0, int64_t* status, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right)
{
    int64_t flat;
    double residual;
    int64_t satisfied;
    int64_t i;
    double end;
    double other;
    flat = brackets__flatter_side(work);
    (*status) = brackets__enclose_roll(left_tables, right_tables, work, state, roll, left, right, flat);
    if ((*status) > layout__UNLOADED)
    {
        (*result_0) = roll;
        return 0;
    }
    residual = 0.0;
    satisfied = INT64_C(0);
    for (i = INT64_C(0); i < brackets__BRACKETINGS; i += INT64_C(1))
    {
        roll = brackets__next_in_bracket(work, layout__WORK_ROLL_BRACKET, i);
        brackets__roll_residual(&residual, &satisfied, status, left_tables, right_tables, work, state, roll, left, right, flat);
        if ((*status) > layout__UNLOADED)
        {
            (*result_0) = roll;
            return 0;
        }
        brackets__narrow_bracket(work, layout__WORK_ROLL_BRACKET, roll, residual);
        if ((fabs(residual) < brackets__BRACKET_SHARP) || ((*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH)) - (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW)) < brackets__BRACKET_SHARP))
        {
            break;
        }
    }
    if (fabs(residual) >= brackets__BRACKET_SHARP)
    {
        /* of both ends of a jump always the same, at which the steeper wheel carries no less than its load */
        end = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH));
        if (flat == INT64_C(1))
        {
            end = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW));
        }
        if (roll != end)
        {
            roll = end;
            brackets__roll_residual(&residual, &satisfied, status, left_tables, right_tables, work, state, roll, left, right, flat);
        }
    }
    if (satisfied == INT64_C(0))
    {
        /* or the one whose nodes can carry the force */
        other = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW));
        if (roll == (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_LOW)))
        {
            other = (*cspan_at(&work, layout__WORK_ROLL_BRACKET + layout__BRACKET_HIGH));
        }
        roll = other;
        brackets__roll_residual(&residual, &satisfied, status, left_tables, right_tables, work, state, roll, left, right, flat);
    }
    if ((*status) <= layout__UNLOADED)
    {
        if (satisfied == INT64_C(0))
        {
            (*status) = layout__NOT_CONVERGED;
        }
        (*status) = trial__depth_outcome(work, (*status));
    }
    (*result_0) = roll;
    return 0;
}
