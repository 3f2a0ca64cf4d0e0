/* Generated from elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium: the height and roll at which both wheels carry their loads.
 *
 * The wheels sink into their rails.  At a given roll each side has one height at which it carries its load; where these heights
 * are equal the wheelset stands.  Their difference D(roll) = height_right - height_left falls as that of the rigid gaps does
 * (:mod:`roll`), and a small load leaves the gaps themselves.  How a side's height follows the roll,
 *
 *     d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),
 *
 * is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's slope.
 *
 * Regions and nodes are laid for the depth that a side has sunk to, which is found along with the roll: every trial of the
 * roll presses each wheel as deep as the one before found, and solves its load.  The compliant form is given height and roll,
 * and each wheel's load follows from how deep it stands.
 */

#include "elastic.h"

/* How far [m] a wheel under ``force`` [N] is estimated to sink below its smallest gap, and the outcome. */
static inline int64_t elastic__first_sink(double* sink, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    (*status) = side__rest_side(tables, work, state, index);
    (*sink) = 0.0;
    if ((*status) == layout__UNLOADED)
    {
        (*sink) = normal_contact__first_penetration(tables, work, state, force) / (*cspan_at(&work, contact_plane__FRAME_COS));
        (*status) = layout__VALID;
    }
    return 0;
}

/* Find the height at which a side carries ``force`` [N], from where it was laid down; its outcome.  Outputs are those of
 * the side under this force.
 */
static inline int64_t elastic__carry_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force)
{
    int64_t support;
    double best;
    double sink;
    int64_t count;
    double carried;
    int64_t status;
    support = layout__WORK_SUPPORT + layout__SUPPORT_BLOCK * index;
    best = (*cspan_at(&work, layout__WORK_SIDE + layout__SIDE_BLOCK * index + layout__SIDE_BEST));
    if (!(force > 0.0))
    {
        (*cspan_at(&work, support + side__SUPPORT_SINK)) = 0.0;
        (*cspan_at(&work, support + side__SUPPORT_CARRIED)) = 0.0;
        (*cspan_at(&work, support + side__SUPPORT_HEIGHT)) = best;
        (*cspan_at(&work, support + side__SUPPORT_LEVER)) = side__side_lever(tables, work, index, INT64_C(0));
        status = side__rest_side(tables, work, state, index);
        return status;
    }
    sink = (*cspan_at(&work, support + side__SUPPORT_SINK));
    if (!(sink > 0.0))
    {
        elastic__first_sink(&sink, &status, tables, work, state, index, force);
        if (status != layout__VALID)
        {
            return status;
        }
        (*cspan_at(&work, support + side__SUPPORT_SINK)) = sink;
    }
    status = side__press_side(tables, work, state, index, sink);
    if (status == layout__VALID)
    {
        side__load_side(&count, &status, tables, work, state, index, force, (*cspan_at(&tables, layout__SET_ABSENT)));
        carried = sink + ((*cspan_at(&work, side__side_outputs(index) + layout__SIDE_PENETRATION)) - (*cspan_at(&work, contact_plane__FRAME_DEPTH))) / (*cspan_at(&work, contact_plane__FRAME_COS));
        if (!(carried > 0.0))
        {
            carried = 0.5 * sink;
        }
        (*cspan_at(&work, support + side__SUPPORT_CARRIED)) = carried;
        (*cspan_at(&work, support + side__SUPPORT_HEIGHT)) = best + carried;
        (*cspan_at(&work, support + side__SUPPORT_LEVER)) = side__side_lever(tables, work, index, count);
    }
    return status;
}

/* 1 if a side stands as deep as it was laid down, else 0. */
static inline int64_t elastic__settled_side(array_double_1d work, int64_t index)
{
    int64_t support;
    double off;
    int64_t settled;
    support = layout__WORK_SUPPORT + layout__SUPPORT_BLOCK * index;
    off = fabs((*cspan_at(&work, support + side__SUPPORT_CARRIED)) - (*cspan_at(&work, support + side__SUPPORT_SINK)));
    settled = INT64_C(0);
    if ((off <= elastic__SETTLED * (*cspan_at(&work, support + side__SUPPORT_CARRIED))) || (off <= elastic__SMALLEST))
    {
        settled = INT64_C(1);
    }
    return settled;
}

/* Move a side's known smallest gap to this roll's by Newton's method; 1 if it is found near, else 0. */
static inline int64_t elastic__follow_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index)
{
    int64_t side;
    int64_t at;
    int64_t wheel;
    double y;
    int64_t i;
    double gap;
    double mismatch;
    double rate;
    double move;
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    side = layout__WORK_SIDE + layout__SIDE_BLOCK * index;
    at = layout__WORK_PLACE + layout__PLACE_BLOCK * index;
    wheel = (int64_t)((*cspan_at(&tables, layout__SET_WHEEL)));
    y = (*cspan_at(&work, side + layout__SIDE_BEST_Y));
    for (i = INT64_C(0); i < elastic__FOLLOW_STEPS; i += INT64_C(1))
    {
        gap__vertical_gap(&gap, &mismatch, &rate, tables, work, at, y);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (!(rate > 0.0))
        {
            return INT64_C(0);
        }
        move = (-mismatch) / rate;
        if (fabs(move) < search__SHARP)
        {
            profile_table__height_slope(&z, &slope, tables, wheel, y);
            locus__outline_point(&y_track, &z_track, &outline_slope, work, at, y, z, slope);
            (*cspan_at(&work, side + layout__SIDE_BEST)) = gap;
            (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = y;
            (*cspan_at(&work, side + layout__SIDE_BEST_RAIL)) = y_track - (*cspan_at(&tables, layout__SET_RAIL_Y));
            return INT64_C(1);
        }
        y += move;
        if ((fabs(y - (*cspan_at(&work, side + layout__SIDE_BEST_Y))) > elastic__FOLLOW_REACH) || (!((y > (*cspan_at(&tables, wheel + profile_table__START))) && (y < (*cspan_at(&tables, wheel + profile_table__STOP))))))
        {
            return INT64_C(0);
        }
    }
    return INT64_C(0);
}

/* Turn the wheelset to ``roll`` [rad] and find both smallest gaps; 1 if both wheels are above their rails, else 0. */
static inline int64_t elastic__turn_to(array_double_1d tables, array_double_1d work, array_double_1d state, double roll)
{
    int64_t known;
    int64_t result;
    roll__turn_both(work, roll);
    known = elastic__follow_side(tables, work, state, INT64_C(0));
    if (known == INT64_C(1))
    {
        known = elastic__follow_side(tables, work, state, INT64_C(1));
    }
    result = roll__search_both(tables, work, state, known);
    return result;
}

/* ``carry_side`` for both, under ``left`` and ``right`` [N]; the worse outcome. */
static inline int64_t elastic__carry_both(array_double_1d tables, array_double_1d work, array_double_1d state, double left, double right)
{
    int64_t outcome;
    int64_t status;
    resultant__clear_resultant(work);
    status = elastic__carry_side(tables, work, state, INT64_C(0), left);
    if (status <= layout__UNLOADED)
    {
        outcome = elastic__carry_side(tables, work, state, INT64_C(1), right);
        if (outcome > status)
        {
            status = outcome;
        }
    }
    return status;
}

/* Roll [rad] at which the wheelset stands under ``left`` and ``right`` [N], and the outcome; outputs are those of the two
 * sides.  Starts at the rigid ``roll``, whose smallest gaps are known.
 */
static inline int64_t elastic__solve_elastic(double* result_0_0001, int64_t* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right)
{
    int64_t first;
    int64_t second;
    double low;
    double high;
    double before;
    double difference_before;
    int64_t trial;
    int64_t status;
    double difference;
    double slope;
    int64_t settled;
    double found;
    double move;
    first = layout__WORK_SUPPORT;
    second = layout__WORK_SUPPORT + layout__SUPPORT_BLOCK;
    (*cspan_at(&work, first + side__SUPPORT_SINK)) = 0.0;
    (*cspan_at(&work, second + side__SUPPORT_SINK)) = 0.0;
    low = -roll__ROLL_LIMIT;
    high = roll__ROLL_LIMIT;
    before = 0.0;
    difference_before = 0.0;
    for (trial = INT64_C(0); trial < elastic__TRIALS; trial += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_ROLL_COUNT)) += 1.0;
        status = elastic__carry_both(tables, work, state, left, right);
        if (status > layout__UNLOADED)
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = status;
            return 0;
        }
        difference = (*cspan_at(&work, second + side__SUPPORT_HEIGHT)) - (*cspan_at(&work, first + side__SUPPORT_HEIGHT));
        slope = (*cspan_at(&work, second + side__SUPPORT_LEVER)) + (*cspan_at(&work, first + side__SUPPORT_LEVER));
        settled = INT64_C(1);
        if (trial < elastic__FROZEN)
        {
            settled = elastic__settled_side(work, INT64_C(0)) * elastic__settled_side(work, INT64_C(1));
            (*cspan_at(&work, first + side__SUPPORT_SINK)) = (*cspan_at(&work, first + side__SUPPORT_CARRIED));
            (*cspan_at(&work, second + side__SUPPORT_SINK)) = (*cspan_at(&work, second + side__SUPPORT_CARRIED));
        }
        if ((trial > INT64_C(0)) && (fabs(roll - before) > elastic__SLOPE_APART))
        {
            found = (difference - difference_before) / (roll - before);
            if ((found < slope / elastic__SLOPE_FACTOR) && (found > slope * elastic__SLOPE_FACTOR))
            {
                slope = found;
            }
        }
        move = 0.0;
        if (slope < 0.0)
        {
            move = (-difference) / slope;
        }
        else if (difference > 0.0)
        {
            move = elastic__ELASTIC_TURN;
        }
        else
        {
            move = -elastic__ELASTIC_TURN;
        }
        if ((settled == INT64_C(1)) && (fabs(move) < elastic__ELASTIC_SHARP))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = status;
            return 0;
        }
        if ((settled == INT64_C(1)) && (trial >= elastic__FROZEN))
        {
            if (difference > 0.0)
            {
                low = roll;
            }
            else
            {
                high = roll;
            }
            if (high - low < elastic__JUMP_SHARP)
            {
                (*result_0_0001) = roll;
                (*result_1_0001) = status;
                return 0;
            }
        }
        before = roll;
        difference_before = difference;
        if (move > elastic__ELASTIC_TURN)
        {
            move = elastic__ELASTIC_TURN;
        }
        if (move < -elastic__ELASTIC_TURN)
        {
            move = -elastic__ELASTIC_TURN;
        }
        roll += move;
        if (!((roll > low) && (roll < high)))
        {
            roll = 0.5 * (low + high);
        }
        if (elastic__turn_to(tables, work, state, roll) == INT64_C(0))
        {
            (*result_0_0001) = roll;
            (*result_1_0001) = layout__OFF_PROFILE;
            return 0;
        }
    }
    (*result_0_0001) = roll;
    (*result_1_0001) = layout__NOT_CONVERGED;
    return 0;
}

/* The load of a side whose wheelset stands at the vertical shift ``height`` [m]; its outcome, UNLOADED if lifted. */
static inline int64_t elastic__bear_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double height)
{
    double sink;
    int64_t status;
    int64_t count;
    int64_t result;
    sink = height - (*cspan_at(&work, layout__WORK_SIDE + layout__SIDE_BLOCK * index + layout__SIDE_BEST));
    if (!(sink > 0.0))
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
        side__load_side(&count, &status, tables, work, state, index, 0.0, (*cspan_at(&work, contact_plane__FRAME_DEPTH)));
    }
    return status;
}

/* Compliant contact: the wheelset stands at the height and roll of the inputs; the outcome. */
static inline int64_t elastic__stand_compliant(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    double roll;
    double height;
    int64_t status;
    int64_t index;
    int64_t outcome;
    roll = (*cspan_at(&work, layout__WORK_INPUTS + layout__IN_ROLL));
    height = (*cspan_at(&work, layout__WORK_INPUTS + layout__IN_VERTICAL_SHIFT));
    roll__place_both(tables, work, roll);
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUT_ROLL)) = roll;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUT_VERTICAL_SHIFT)) = height;
    resultant__clear_resultant(work);
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
