/* Generated from tangent_strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_influence.py.
 */

#include "tangent_strip_influence.h"

/* Tangent of ``measure_distances``. */
static inline int64_t tangent_strip_influence__measure_distances_t(array_double_1d work, array_double_1d work_t, int64_t i, int64_t others)
{
    int64_t strip;
    int64_t j;
    int64_t other;
    double v1;
    double apart_t;
    double apart;
    double v2;
    double v2_t;
    double lead_t;
    double lead;
    double v3;
    double v4;
    double distance_t;
    double distance;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    for (j = INT64_C(0); j < others; j += INT64_C(1))
    {
        if (j != i)
        {
            other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
            v1 = (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, other + layout__STRIP_STATION));
            apart_t = tangent_rates__size_rate(v1, (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - (*cspan_at(&work_t, other + layout__STRIP_STATION)));
            apart = fabs(v1);
            if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) != (int64_t)((*cspan_at(&work, other + layout__STRIP_REGION))))
            {
                tangent_interaction__region_lead_t(&v2, &v2_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))), layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, other + layout__STRIP_REGION))));
                lead_t = v2_t;
                lead = v2;
                v3 = apart * apart + lead * lead;
                v4 = sqrt(v3);
                apart_t = tangent_rates__root_rate(v4, apart_t * apart + apart * apart_t + (lead_t * lead + lead * lead_t));
                apart = v4;
            }
            distance_t = apart_t / apart;
            distance = log(apart);
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * i + j)) = distance_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * i + j)) = distance;
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * j + i)) = distance_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * j + i)) = distance;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``line_influence``. */
static inline int64_t tangent_strip_influence__line_influence_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double abscissa, double abscissa_t)
{
    double v1;
    double u_t;
    double u;
    int64_t cell;
    int64_t cubic;
    double v2;
    double v3;
    v1 = abscissa - (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_START));
    u_t = abscissa_t * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_CELLS_PER_UNIT));
    u = v1 * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_CELLS_PER_UNIT));
    if (!(u > 0.0))
    {
        u_t = 0.0;
        u = 0.0;
    }
    if (u > (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_COUNT)))
    {
        u_t = 0.0;
        u = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_COUNT));
    }
    cell = (int64_t)(u);
    u = u - (double)(cell);
    cubic = table + layout__INFLUENCE_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    v2 = (*cspan_at(&tables, cubic + layout__CUBIC_BEND)) + u * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD));
    v3 = (*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) + u * v2;
    (*result_0) = (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) + u * v3;
    (*result_1) = u_t * v3 + u * (u_t * v2 + u * (u_t * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD))));
    return 0;
}

/* Tangent of ``near_share``. */
static inline int64_t tangent_strip_influence__near_share_t(double* result_0, double* result_1, double share, double share_t)
{
    double square_t;
    double square;
    double v1;
    double rest_t;
    double rest;
    double v2;
    double v3;
    double v4;
    square_t = share_t * share + share * share_t;
    square = share * share;
    v1 = 1.0 / 72.0 + square / 110.0;
    rest_t = square_t * v1 + square * (square_t / 110.0);
    rest = 1.0 / 42.0 + square * v1;
    v2 = 2.0 * square;
    v3 = 1.0 / 20.0 + square * rest;
    v4 = 1.0 / 6.0 + square * v3;
    (*result_0) = v2 * v4;
    (*result_1) = 2.0 * square_t * v4 + v2 * (square_t * v3 + square * (square_t * rest + square * rest_t));
    return 0;
}

/* Tangent of ``fill_influences``. */
static inline int64_t tangent_strip_influence__fill_influences_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table)
{
    int64_t count;
    int64_t i;
    int64_t row;
    int64_t distances;
    int64_t j;
    double v1;
    double v1_t;
    double v3;
    double v4;
    double v5;
    double v6;
    double v2;
    double v2_t;
    double v7;
    double v8;
    double v9;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
        distances = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_DISTANCES + INT64_C(104) * i;
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            if (j != i)
            {
                tangent_strip_influence__line_influence_t(&v1, &v1_t, tables, table, (*cspan_at(&work, distances + j)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_LOG_HALF_LENGTH)), (*cspan_at(&work_t, distances + j)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_LOG_HALF_LENGTH)));
                (*cspan_at(&work_t, row + j)) = v1_t;
                (*cspan_at(&work, row + j)) = v1;
            }
        }
        for (j = i - INT64_C(2); j < i + INT64_C(3); j += INT64_C(1))
        {
            if ((j >= INT64_C(0)) && (j < count) && (j != i))
            {
                v3 = 0.5 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_WIDTH));
                v4 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_STATION));
                v5 = fabs(v4);
                v6 = v3 / v5;
                tangent_strip_influence__near_share_t(&v2, &v2_t, v6, (0.5 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_WIDTH)) - v6 * tangent_rates__size_rate(v4, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_STATION)))) / v5);
                (*cspan_at(&work_t, row + j)) = (*cspan_at(&work_t, row + j)) + v2_t;
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) + v2;
            }
        }
        v7 = 8.0 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
        v8 = v7 / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH));
        v9 = log(v8);
        (*cspan_at(&work_t, row + i)) = 2.0 * ((8.0 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH)) - v8 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) / v8);
        (*cspan_at(&work, row + i)) = 2.0 * v9;
    }
    tangent_strip_influence__turn_influences_t(work, work_t, count);
    return INT64_C(0);
}

/* Tangent of ``turn_influences``. */
static inline int64_t tangent_strip_influence__turn_influences_t(array_double_1d work, array_double_1d work_t, int64_t count)
{
    int64_t i;
    int64_t j;
    double v1;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            if (j != i)
            {
                v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_COS)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_SIN));
                (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) * v1 + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) * ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_COS)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_COS)) + ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_SIN)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_SIN))));
                (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) * v1;
            }
        }
    }
    return INT64_C(0);
}
