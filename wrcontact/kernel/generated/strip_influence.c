/* Generated from normal/strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * How strips displace each other's middle lines: Phi of eq. (S2), with the mean over the width close by, eq.
 * (S4).
 */

#include "strip_influence.h"

/* Logarithms of the distances between strip ``i`` and the first ``others``.
 *
 * The lead of one region over another along the track counts as distance (interaction.region_lead).
 */
static inline int64_t strip_influence__measure_distances(array_double_1d work, int64_t i, int64_t others)
{
    int64_t strip;
    int64_t j;
    int64_t other;
    double apart;
    double lead;
    double distance;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    for (j = INT64_C(0); j < others; j += INT64_C(1))
    {
        if (j != i)
        {
            other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
            apart = fabs((*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, other + layout__STRIP_STATION)));
            if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) != (int64_t)((*cspan_at(&work, other + layout__STRIP_REGION))))
            {
                lead = interaction__region_lead(work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))), layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, other + layout__STRIP_REGION))));
                apart = sqrt(apart * apart + lead * lead);
            }
            distance = log(apart);
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * i + j)) = distance;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * j + i)) = distance;
        }
    }
    return INT64_C(0);
}

/* Phi of eq. (S2) at ``abscissa`` = ln(distance / half-length); at the table's end beyond it. */
static inline double strip_influence__line_influence(array_double_1d tables, int64_t table, double abscissa)
{
    double u;
    int64_t cell;
    int64_t cubic;
    double result;
    u = (abscissa - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_START))) * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_CELLS_PER_UNIT));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_COUNT)))
    {
        u = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_COUNT));
    }
    cell = (int64_t)(u);
    u -= (double)(cell);
    cubic = table + layout__INFLUENCE_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    result = (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) + u * ((*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) + u * ((*cspan_at(&tables, cubic + layout__CUBIC_BEND)) + u * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD))));
    return result;
}

/* What the mean of Phi over a strip's width exceeds its middle value by, eq. (S4); ``share`` is
 * half-width over distance.
 *
 * The series of 2 - [(1 + share) ln(1 + share) - (1 - share) ln(1 - share)] / share, up to the eighth power.
 */
static inline double strip_influence__near_share(double share)
{
    double square;
    double rest;
    square = share * share;
    rest = 1.0 / 42.0 + square * (1.0 / 72.0 + square / 110.0);
    return 2.0 * square * (1.0 / 6.0 + square * (1.0 / 20.0 + square * rest));
}

/* F_ij of all pairs: displacement of middle line i for y_j = 1; eqs. (S2), (S4). */
static inline int64_t strip_influence__fill_influences(array_double_1d tables, array_double_1d work, int64_t table)
{
    int64_t count;
    int64_t i;
    int64_t row;
    int64_t distances;
    int64_t j;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
        distances = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * i;
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            if (j != i)
            {
                (*cspan_at(&work, row + j)) = strip_influence__line_influence(tables, table, (*cspan_at(&work, distances + j)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_LOG_HALF_LENGTH)));
            }
        }
        for (j = i - INT64_C(2); j < i + INT64_C(3); j += INT64_C(1))
        {
            if ((j >= INT64_C(0)) && (j < count) && (j != i))
            {
                (*cspan_at(&work, row + j)) += strip_influence__near_share(0.5 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_WIDTH)) / fabs((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_STATION))));
            }
        }
        (*cspan_at(&work, row + i)) = 2.0 * log(8.0 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)));
    }
    strip_influence__turn_influences(work, count);
    return INT64_C(0);
}

/* Multiply the influence between two strips by the cosine of the angle between their normals. */
static inline int64_t strip_influence__turn_influences(array_double_1d work, int64_t count)
{
    int64_t i;
    int64_t j;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            if (j != i)
            {
                (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) *= (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_COS)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_SIN));
            }
        }
    }
    return INT64_C(0);
}
