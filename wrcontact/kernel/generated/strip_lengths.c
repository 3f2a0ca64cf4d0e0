/* Generated from normal/strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Half-lengths and middles of the strips from what they displace near their ends; eqs. (S6)-(S8).
 */

#include "strip_lengths.h"

/* Rise of the gap [m] at a distance ``x`` from the ridge. */
static inline double strip_lengths__gap_beside(array_double_1d work, int64_t strip, double x)
{
    double result;
    result = x * x * ((*cspan_at(&work, strip + layout__STRIP_A)) + (*cspan_at(&work, strip + layout__STRIP_SKEW)) * x);
    return result;
}

/* ``ratio`` to a ``power`` near it, without ends: Pade's quotient, (1 + power) / (1 - power) at most. */
static inline double strip_lengths__corrected(double ratio, double power)
{
    double more;
    double less;
    more = 1.0 + power;
    less = 1.0 - power;
    return (less + more * ratio) / (more + less * ratio);
}

/* Half-length [m] of the loaded strip ``i`` by how much less the surfaces are displaced towards its ends
 * than the gap rises; its middle moves to where both ends are alike.
 */
static inline double strip_lengths__correct_strip(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double penetration, double power, int64_t yawed)
{
    int64_t strip;
    double half;
    double away;
    double own;
    double needed;
    double front;
    double back;
    double front_gap;
    double back_gap;
    double move;
    double rise;
    double ratio;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    half = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
    away = strip_lengths__TESTED * half;
    own = strip_lengths__gap_beside(work, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)));
    needed = (*cspan_at(&work, strip + layout__STRIP_SHARE)) * penetration - (*cspan_at(&work, strip + layout__STRIP_GAP));
    front = strip_influence__end_displacement(tables, work, table, i, away);
    back = front;
    front_gap = strip_lengths__gap_beside(work, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)) + away) - own;
    back_gap = front_gap;
    if (yawed == INT64_C(1))
    {
        back = strip_influence__end_displacement(tables, work, table, i, -away);
        back_gap = strip_lengths__gap_beside(work, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)) - away) - own;
        move = (-strip_lengths__MOVED) * (front + front_gap - back - back_gap) / (4.0 * (*cspan_at(&work, strip + layout__STRIP_A)) * away);
        if (move > strip_lengths__FARTHEST_MOVE * half)
        {
            move = strip_lengths__FARTHEST_MOVE * half;
        }
        if (move < (-strip_lengths__FARTHEST_MOVE) * half)
        {
            move = (-strip_lengths__FARTHEST_MOVE) * half;
        }
        (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_LEAD)) + move;
    }
    rise = 0.5 * (front_gap + back_gap);
    if (rise < strip_lengths__FLATTEST * (*cspan_at(&work, strip + layout__STRIP_A)) * away * away)
    {
        rise = strip_lengths__FLATTEST * (*cspan_at(&work, strip + layout__STRIP_A)) * away * away;
    }
    ratio = (needed - 0.5 * (front + back)) / rise;
    if (!(ratio > 0.0))
    {
        ratio = 0.0;
    }
    return half * strip_lengths__corrected(ratio, power);
}

/* Line load, square of the corrected half-length, pressure and lead of every strip.
 *
 * The line load stays, and the pressure follows from the corrected half-length.
 */
static inline int64_t strip_lengths__correct_lengths(array_double_1d work, array_double_1d tables, double penetration, double power, int64_t yawed)
{
    int64_t count;
    double scale;
    double largest;
    int64_t i;
    int64_t strip;
    double half;
    double share;
    double beside;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    largest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_LEAD));
        if ((*cspan_at(&work, strip + layout__STRIP_Y)) > 0.0)
        {
            half = strip_lengths__correct_strip(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE))), i, penetration, power, yawed);
            (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) = scale * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__STRIP_Y)) / (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = half * half;
            (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = (*cspan_at(&work, strip + layout__STRIP_Y)) / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
            if ((*cspan_at(&work, strip + layout__STRIP_PRESSURE)) > largest)
            {
                largest = (*cspan_at(&work, strip + layout__STRIP_PRESSURE));
            }
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        share = (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) / (strip_lengths__LIGHT * largest);
        if (share < 1.0)
        {
            beside = strip_lengths__neighbouring_length(work, count, i);
            half = share * sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE))) + (1.0 - share) * beside;
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = half * half;
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_Y)) > 0.0)
        {
            (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = 2.0 / M_PI * (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) / ((*cspan_at(&work, strip + layout__STRIP_BREADTH)) * sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE))));
        }
    }
    return INT64_C(0);
}

/* Half-length [m] of the strips beside ``i``, weighted by their pressures; its own where they have
 * none.
 */
static inline double strip_lengths__neighbouring_length(array_double_1d work, int64_t count, int64_t i)
{
    double total;
    double weight;
    int64_t before;
    int64_t after;
    double half;
    total = 0.0;
    weight = 0.0;
    if (i > INT64_C(0))
    {
        before = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1));
        weight += (*cspan_at(&work, before + layout__STRIP_PRESSURE));
        total += (*cspan_at(&work, before + layout__STRIP_PRESSURE)) * sqrt((*cspan_at(&work, before + layout__STRIP_HALF_LENGTH_SQUARE)));
    }
    if (i < count - INT64_C(1))
    {
        after = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1));
        weight += (*cspan_at(&work, after + layout__STRIP_PRESSURE));
        total += (*cspan_at(&work, after + layout__STRIP_PRESSURE)) * sqrt((*cspan_at(&work, after + layout__STRIP_HALF_LENGTH_SQUARE)));
    }
    half = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
    if (weight > 0.0)
    {
        half = total / weight;
    }
    return half;
}

/* Give the strips their corrected half-lengths and leads, for the next sweep. */
static inline int64_t strip_lengths__adopt_lengths(array_double_1d work)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
        (*cspan_at(&work, strip + layout__STRIP_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD));
    }
    strip_lengths__limit_lengths(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}

/* Raise half-lengths to their smallest. */
static inline int64_t strip_lengths__limit_lengths(array_double_1d work, int64_t count)
{
    double longest;
    int64_t i;
    int64_t strip;
    longest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH)) > longest)
        {
            longest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_lengths__SHORTEST * longest)
        {
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_lengths__SHORTEST * longest;
        }
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_lengths__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH)))
        {
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_lengths__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        }
    }
    return INT64_C(0);
}
