/* Generated from normal/strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * How strips displace each other: Phi of eq. (S2), with the mean over the width close by, eq. (S4).
 */

#include "strip_influence.h"

/* The cubic between two values with their slopes, at 0 <= ``x`` <= 1. */
static inline double strip_influence__cubic_through_slopes(double low, double low_slope, double high, double high_slope, double x)
{
    double rise;
    double rest;
    rise = high - low;
    rest = 1.0 - x;
    return low + x * (rise + rest * (rest * (low_slope - rise) - x * (high_slope - rise)));
}

/* Phi, or its mean, at x = 0 and ``u`` = sqrt(t / (1 + t)); the map begins at number ``first``. */
static inline double strip_influence__middle_influence(array_double_1d tables, int64_t table, int64_t first, double u)
{
    double place;
    int64_t cell;
    int64_t at;
    double result;
    place = u * (double)(layout__INFLUENCE_CELLS);
    cell = (int64_t)(place);
    if (cell > layout__INFLUENCE_CELLS - INT64_C(1))
    {
        cell = layout__INFLUENCE_CELLS - INT64_C(1);
    }
    at = first + INT64_C(2) * cell;
    result = strip_influence__cubic_through_slopes((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)), (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))), (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))), (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(3)))), place - (double)(cell));
    return result;
}

/* The same at x / half-length with this ``square``. */
static inline double strip_influence__influence_at(array_double_1d tables, int64_t table, int64_t first, double u, double square)
{
    double place;
    int64_t cell;
    double along;
    int64_t column;
    double share;
    int64_t at;
    int64_t to;
    double low;
    double low_slope;
    double high;
    double high_slope;
    place = u * (double)(layout__INFLUENCE_CELLS);
    cell = (int64_t)(place);
    if (cell > layout__INFLUENCE_CELLS - INT64_C(1))
    {
        cell = layout__INFLUENCE_CELLS - INT64_C(1);
    }
    along = square / (1.0 + square) * (double)(layout__INFLUENCE_COLUMNS);
    column = (int64_t)(along);
    if (column > layout__INFLUENCE_COLUMNS - INT64_C(1))
    {
        column = layout__INFLUENCE_COLUMNS - INT64_C(1);
    }
    share = along - (double)(column);
    at = first + layout__INFLUENCE_COLUMN * column + INT64_C(2) * cell;
    to = at + layout__INFLUENCE_COLUMN;
    low = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + to)) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)));
    low_slope = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(1)))) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))));
    high = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(2)))) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))));
    high_slope = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(3)))) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(3)))) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(3)))));
    return strip_influence__cubic_through_slopes(low, low_slope, high, high_slope, place - (double)(cell));
}

/* sqrt(t / (1 + t)) with t = ``distance`` / ``half_length``. */
static inline double strip_influence__nearness(double distance, double half_length)
{
    return sqrt(distance / (distance + half_length));
}

/* The mean of Phi over the width of ``strip`` at a ``distance`` of more than half of that [m]. */
static inline double strip_influence__mean_at(array_double_1d tables, array_double_1d work, int64_t table, int64_t strip, double distance, double square)
{
    double half;
    double near;
    double far;
    double inner;
    double outer;
    double result;
    half = 0.5 * (*cspan_at(&work, strip + layout__STRIP_BREADTH));
    near = distance - half;
    if (near < 0.0)
    {
        near = 0.0;
    }
    far = distance + half;
    inner = strip_influence__influence_at(tables, table, layout__INFLUENCE_MAP, strip_influence__nearness(near, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH))), square);
    outer = strip_influence__influence_at(tables, table, layout__INFLUENCE_MAP, strip_influence__nearness(far, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH))), square);
    result = (far * outer - near * inner) / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
    return result;
}

/* Phi of the strips ``first`` ... ``last`` - 1 at the middle of strip ``i``, and how near they are. */
static inline int64_t strip_influence__fill_row(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, int64_t first, int64_t last, int64_t near, int64_t row)
{
    int64_t strip;
    double x;
    int64_t j;
    int64_t other;
    double u;
    double apart;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    x = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD));
    for (j = first; j < last; j += INT64_C(1))
    {
        other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
        u = strip_influence__nearness(fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)));
        (*cspan_at(&work, near + j)) = u;
        apart = (x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD))) / (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH));
        (*cspan_at(&work, row + j)) = strip_influence__influence_at(tables, table, INT64_C(0), u, apart * apart);
    }
    return INT64_C(0);
}

/* ``fill_row`` without yaw: all middles lie on one line. */
static inline int64_t strip_influence__fill_straight_row(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, int64_t first, int64_t last, int64_t near, int64_t row)
{
    int64_t strip;
    int64_t j;
    int64_t other;
    double u;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    for (j = first; j < last; j += INT64_C(1))
    {
        other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
        u = strip_influence__nearness(fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)));
        (*cspan_at(&work, near + j)) = u;
        (*cspan_at(&work, row + j)) = strip_influence__middle_influence(tables, table, INT64_C(0), u);
    }
    return INT64_C(0);
}

/* F_ij of all pairs: displacement of the middle of i for y_j = 1, along the normal of i; eqs. (S2),
 * (S4).
 */
static inline int64_t strip_influence__fill_influences(array_double_1d tables, array_double_1d work, int64_t table, int64_t yawed)
{
    int64_t count;
    int64_t i;
    int64_t strip;
    int64_t row;
    int64_t near;
    int64_t j;
    int64_t other;
    double apart;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
        near = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i;
        if (yawed == INT64_C(1))
        {
            strip_influence__fill_row(tables, work, table, i, INT64_C(0), i, near, row);
            strip_influence__fill_row(tables, work, table, i, i + INT64_C(1), count, near, row);
        }
        else
        {
            strip_influence__fill_straight_row(tables, work, table, i, INT64_C(0), i, near, row);
            strip_influence__fill_straight_row(tables, work, table, i, i + INT64_C(1), count, near, row);
        }
        for (j = i - INT64_C(1); j < i + INT64_C(2); j += INT64_C(2))
        {
            if ((j >= INT64_C(0)) && (j < count))
            {
                other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
                apart = ((*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD))) / (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH));
                (*cspan_at(&work, row + j)) = strip_influence__mean_at(tables, work, table, other, fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), apart * apart);
            }
        }
        (*cspan_at(&work, near + i)) = strip_influence__nearness(0.5 * (*cspan_at(&work, strip + layout__STRIP_BREADTH)), (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)));
        (*cspan_at(&work, row + i)) = strip_influence__middle_influence(tables, table, layout__INFLUENCE_MAP, (*cspan_at(&work, near + i)));
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            (*cspan_at(&work, row + j)) *= (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_SIN));
        }
    }
    return INT64_C(0);
}

/* What the loaded strips ``first`` ... ``last`` - 1 displace at the place of strip ``i`` and ``x`` [m],
 * along its normal: ``influence_at`` for each.
 */
static inline double strip_influence__far_displacement(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double x, int64_t first, int64_t last)
{
    int64_t near;
    double cosine;
    double sine;
    int64_t j;
    int64_t other;
    double apart;
    double square;
    double along;
    int64_t column;
    double share;
    double place;
    int64_t cell;
    int64_t at;
    int64_t to;
    double low;
    double low_slope;
    double high;
    double high_slope;
    double influence;
    double total;
    near = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i;
    cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS));
    sine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN));
    total = 0.0;
    for (j = first; j < last; j += INT64_C(1))
    {
        other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
        if ((*cspan_at(&work, other + layout__STRIP_Y)) > 0.0)
        {
            apart = x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD));
            square = apart * apart;
            along = square / (square + (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH))) * (double)(layout__INFLUENCE_COLUMNS);
            column = (int64_t)(along);
            share = along - (double)(column);
            place = (*cspan_at(&work, near + j)) * (double)(layout__INFLUENCE_CELLS);
            cell = (int64_t)(place);
            at = layout__INFLUENCE_COLUMN * column + INT64_C(2) * cell;
            to = at + layout__INFLUENCE_COLUMN;
            low = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + to)) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)));
            low_slope = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(1)))) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))));
            high = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(2)))) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))));
            high_slope = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(3)))) + share * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(3)))) - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(3)))));
            influence = strip_influence__cubic_through_slopes(low, low_slope, high, high_slope, place - (double)(cell));
            total += influence * (*cspan_at(&work, other + layout__STRIP_Y)) * (cosine * (*cspan_at(&work, other + layout__STRIP_COS)) + sine * (*cspan_at(&work, other + layout__STRIP_SIN)));
        }
    }
    return total;
}

/* Displacement [m] at a distance ``away`` along x from the middle of strip ``i``, along its normal. */
static inline double strip_influence__end_displacement(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double away)
{
    int64_t count;
    int64_t strip;
    double x;
    double apart;
    int64_t first;
    int64_t last;
    int64_t j;
    int64_t other;
    double influence;
    double total;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    x = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) + away;
    apart = away / (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
    total = (*cspan_at(&work, strip + layout__STRIP_Y)) * strip_influence__influence_at(tables, table, layout__INFLUENCE_MAP, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + i)), apart * apart);
    first = i;
    last = i + INT64_C(1);
    for (j = i - INT64_C(1); j < i + INT64_C(2); j += INT64_C(2))
    {
        if ((j >= INT64_C(0)) && (j < count))
        {
            other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
            if (j < i)
            {
                first = j;
            }
            else
            {
                last = j + INT64_C(1);
            }
            if ((*cspan_at(&work, other + layout__STRIP_Y)) > 0.0)
            {
                apart = (x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD))) / (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH));
                influence = strip_influence__mean_at(tables, work, table, other, fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), apart * apart);
                total += influence * (*cspan_at(&work, other + layout__STRIP_Y)) * ((*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)));
            }
        }
    }
    total += strip_influence__far_displacement(tables, work, table, i, x, INT64_C(0), first);
    total += strip_influence__far_displacement(tables, work, table, i, x, last, count);
    return total;
}
