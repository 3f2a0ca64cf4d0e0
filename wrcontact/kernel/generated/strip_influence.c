/* Generated from normal/strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * How strips displace each other: Phi of eq. (S2), with the mean over the width close by, eq. (S4).
 */

#include "strip_influence.h"

/* u = sqrt(t / (1 + t)) with t = ``distance`` / ``half_length``. */
static inline double strip_influence__nearness(double distance, double half_length)
{
    return sqrt(distance / (distance + half_length));
}

/* v = e^2 / (1 + e^2) with e = ``x`` / ``half_length``. */
static inline double strip_influence__apartness(double x, double half_length)
{
    double square;
    square = x * x;
    return square / (square + half_length * half_length);
}

/* The cell that holds ``place``, 0 ... ``count``; the last one has its end too. */
static inline int64_t strip_influence__cell_at(double place, int64_t count)
{
    int64_t cell;
    cell = (int64_t)(place);
    if (cell > count - INT64_C(1))
    {
        cell = count - INT64_C(1);
    }
    return cell;
}

/* Phi, or its mean, at ``u`` and ``v``; the map begins at number ``first``.
 *
 * Parabolas along u, smoothly joined: with straight lines there, derivatives would jump by 1e-5 between any
 * two poses.
 */
static inline double strip_influence__influence_at(array_double_1d tables, int64_t table, int64_t first, double u, double v)
{
    double place;
    int64_t cell;
    double along;
    int64_t column;
    double x;
    double share;
    int64_t at;
    int64_t to;
    double low;
    double high;
    place = u * (double)(layout__INFLUENCE_CELLS);
    cell = strip_influence__cell_at(place, layout__INFLUENCE_CELLS);
    along = v * (double)(layout__INFLUENCE_COLUMNS);
    column = strip_influence__cell_at(along, layout__INFLUENCE_COLUMNS);
    x = place - (double)(cell);
    share = along - (double)(column);
    at = first + layout__INFLUENCE_COLUMN * column + INT64_C(3) * cell;
    to = at + layout__INFLUENCE_COLUMN;
    low = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)) + x * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))) + x * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))));
    high = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + to)) + x * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(1)))) + x * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(2)))));
    return low + share * (high - low);
}

/* The same at v = 0. */
static inline double strip_influence__middle_influence(array_double_1d tables, int64_t table, int64_t first, double u)
{
    double place;
    int64_t cell;
    double x;
    int64_t at;
    double result;
    place = u * (double)(layout__INFLUENCE_CELLS);
    cell = strip_influence__cell_at(place, layout__INFLUENCE_CELLS);
    x = place - (double)(cell);
    at = first + INT64_C(3) * cell;
    result = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)) + x * ((*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))) + x * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))));
    return result;
}

/* The mean of Phi over the width of ``strip`` at a ``distance`` of more than half of that [m]. */
static inline double strip_influence__mean_at(array_double_1d tables, array_double_1d work, int64_t table, int64_t strip, double distance, double v)
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
    inner = strip_influence__influence_at(tables, table, layout__INFLUENCE_MAP, strip_influence__nearness(near, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH))), v);
    outer = strip_influence__influence_at(tables, table, layout__INFLUENCE_MAP, strip_influence__nearness(far, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH))), v);
    result = (far * outer - near * inner) / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
    return result;
}

/* No influence is known yet of strips that lie as they do now. */
static inline int64_t strip_influence__begin_influences(array_double_1d work)
{
    int64_t j_end;
    int64_t j;
    j_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (j = INT64_C(0); j < j_end; j += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_KNOWN)) = (double)(0);
    }
    return INT64_C(0);
}

/* Find the influences of all loaded strips of which they are not known yet. */
static inline int64_t strip_influence__know_influences(array_double_1d tables, array_double_1d work, int64_t table, int64_t yawed)
{
    int64_t j_end;
    int64_t j;
    int64_t strip;
    j_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (j = INT64_C(0); j < j_end; j += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
        if (((*cspan_at(&work, strip + layout__STRIP_LOADED)) == 1.0) && (!((*cspan_at(&work, strip + layout__STRIP_KNOWN)) == 1.0)))
        {
            strip_influence__fill_column(tables, work, table, j, yawed);
            (*cspan_at(&work, strip + layout__STRIP_KNOWN)) = (double)(1);
        }
    }
    return INT64_C(0);
}

/* F_ij of strip j for all i: displacement of the middle of i for y_j = 1, along the normal of i; eqs.
 * (S2), (S4).
 */
static inline int64_t strip_influence__fill_column(array_double_1d tables, array_double_1d work, int64_t table, int64_t j, int64_t yawed)
{
    int64_t other;
    double x;
    double half;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double u;
    double influence;
    other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
    x = (*cspan_at(&work, other + layout__STRIP_X)) + (*cspan_at(&work, other + layout__STRIP_LEAD));
    half = (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH));
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if (i != j)
        {
            u = strip_influence__nearness(fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), half);
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + j)) = u;
            if (yawed == INT64_C(1))
            {
                influence = strip_influence__influence_at(tables, table, INT64_C(0), u, strip_influence__apartness((*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) - x, half));
            }
            else
            {
                /* all middles lie on one line */
                influence = strip_influence__middle_influence(tables, table, INT64_C(0), u);
            }
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = influence * ((*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)));
        }
    }
    for (i = j - INT64_C(1); i < j + INT64_C(2); i += INT64_C(2))
    {
        if ((i >= INT64_C(0)) && (i < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)))))
        {
            strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
            influence = strip_influence__mean_at(tables, work, table, other, fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), strip_influence__apartness((*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) - x, half));
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = influence * ((*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)));
        }
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * j + j)) = strip_influence__nearness(0.5 * (*cspan_at(&work, other + layout__STRIP_BREADTH)), half);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * j + j)) = strip_influence__middle_influence(tables, table, layout__INFLUENCE_MAP, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * j + j)));
    return INT64_C(0);
}

/* What the loaded strips ``first`` ... ``last`` - 1 displace at the place of strip ``i`` and ``x`` [m],
 * along its normal.
 */
static inline double strip_influence__far_displacement(array_double_1d tables, array_double_1d work, int64_t table, int64_t i, double x, int64_t first, int64_t last)
{
    int64_t near;
    double cosine;
    double sine;
    int64_t j;
    int64_t other;
    double v;
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
            v = strip_influence__apartness(x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD)), (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)));
            total += strip_influence__influence_at(tables, table, INT64_C(0), (*cspan_at(&work, near + j)), v) * (*cspan_at(&work, other + layout__STRIP_Y)) * (cosine * (*cspan_at(&work, other + layout__STRIP_COS)) + sine * (*cspan_at(&work, other + layout__STRIP_SIN)));
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
    int64_t first;
    int64_t last;
    int64_t j;
    int64_t other;
    double influence;
    double total;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    x = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) + away;
    total = (*cspan_at(&work, strip + layout__STRIP_Y)) * strip_influence__influence_at(tables, table, layout__INFLUENCE_MAP, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + i)), strip_influence__apartness(away, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH))));
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
                influence = strip_influence__mean_at(tables, work, table, other, fabs((*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE))), strip_influence__apartness(x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD)), (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH))));
                total += influence * (*cspan_at(&work, other + layout__STRIP_Y)) * ((*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)));
            }
        }
    }
    total += strip_influence__far_displacement(tables, work, table, i, x, INT64_C(0), first);
    total += strip_influence__far_displacement(tables, work, table, i, x, last, count);
    return total;
}
