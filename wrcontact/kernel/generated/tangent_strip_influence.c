/* Generated from tangent_strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_influence.py.
 */

#include "tangent_strip_influence.h"

/* Tangent of ``nearness``. */
static inline int64_t tangent_strip_influence__nearness_t(double* v3, double* result_1, double distance, double distance_t, double half_length, double half_length_t)
{
    double v1;
    double v2;
    v1 = distance + half_length;
    v2 = distance / v1;
    (*v3) = sqrt(v2);
    (*result_1) = tangent_rates__root_rate((*v3), (distance_t - v2 * (distance_t + half_length_t)) / v1);
    return 0;
}

/* Tangent of ``apartness``. */
static inline int64_t tangent_strip_influence__apartness_t(double* v2, double* result_1, double x, double x_t, double half_length, double half_length_t)
{
    double square_t;
    double square;
    double v1;
    square_t = x_t * x + x * x_t;
    square = x * x;
    v1 = square + half_length * half_length;
    (*v2) = square / v1;
    (*result_1) = (square_t - (*v2) * (square_t + (half_length_t * half_length + half_length * half_length_t))) / v1;
    return 0;
}

/* Tangent of ``influence_at``. */
static inline int64_t tangent_strip_influence__influence_at_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t first, double u, double u_t, double v, double v_t)
{
    double v1;
    double place_t;
    double place;
    int64_t cell;
    double v2;
    double along_t;
    double along;
    int64_t column;
    double x_t;
    double x;
    double share_t;
    double share;
    int64_t at;
    int64_t to;
    double v3;
    double low_t;
    double low;
    double v4;
    double high_t;
    double high;
    double v5;
    v1 = (double)(layout__INFLUENCE_CELLS);
    place_t = u_t * v1;
    place = u * v1;
    cell = strip_influence__cell_at(place, layout__INFLUENCE_CELLS);
    v2 = (double)(layout__INFLUENCE_COLUMNS);
    along_t = v_t * v2;
    along = v * v2;
    column = strip_influence__cell_at(along, layout__INFLUENCE_COLUMNS);
    x_t = place_t;
    x = place - (double)(cell);
    share_t = along_t;
    share = along - (double)(column);
    at = first + layout__INFLUENCE_COLUMN * column + INT64_C(3) * cell;
    to = at + layout__INFLUENCE_COLUMN;
    v3 = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))) + x * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2))));
    low_t = x_t * v3 + x * (x_t * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))));
    low = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)) + x * v3;
    v4 = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(1)))) + x * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(2))));
    high_t = x_t * v4 + x * (x_t * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (to + INT64_C(2)))));
    high = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + to)) + x * v4;
    v5 = high - low;
    (*result_0) = low + share * v5;
    (*result_1) = low_t + (share_t * v5 + share * (high_t - low_t));
    return 0;
}

/* Tangent of ``middle_influence``. */
static inline int64_t tangent_strip_influence__middle_influence_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t first, double u, double u_t)
{
    double v1;
    double place_t;
    double place;
    int64_t cell;
    double x_t;
    double x;
    int64_t at;
    double v2;
    v1 = (double)(layout__INFLUENCE_CELLS);
    place_t = u_t * v1;
    place = u * v1;
    cell = strip_influence__cell_at(place, layout__INFLUENCE_CELLS);
    x_t = place_t;
    x = place - (double)(cell);
    at = first + INT64_C(3) * cell;
    v2 = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(1)))) + x * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2))));
    (*result_0) = (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + at)) + x * v2;
    (*result_1) = x_t * v2 + x * (x_t * (*cspan_at(&tables, table + layout__INFLUENCE_TABLE_NUMBERS + (at + INT64_C(2)))));
    return 0;
}

/* Tangent of ``mean_at``. */
static inline int64_t tangent_strip_influence__mean_at_t(double* v6, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t strip, double distance, double distance_t, double v, double v_t)
{
    double half_t;
    double half;
    double near_t;
    double near;
    double far_t;
    double far;
    double v2;
    double v2_t;
    double v1;
    double v1_t;
    double inner_t;
    double inner;
    double v4;
    double v4_t;
    double v3;
    double v3_t;
    double outer_t;
    double outer;
    double v5;
    half_t = 0.5 * (*cspan_at(&work_t, strip + layout__STRIP_BREADTH));
    half = 0.5 * (*cspan_at(&work, strip + layout__STRIP_BREADTH));
    near_t = distance_t - half_t;
    near = distance - half;
    if (near < 0.0)
    {
        near_t = 0.0;
        near = 0.0;
    }
    far_t = distance_t + half_t;
    far = distance + half;
    tangent_strip_influence__nearness_t(&v2, &v2_t, near, near_t, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)), (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)));
    tangent_strip_influence__influence_at_t(&v1, &v1_t, tables, table, layout__INFLUENCE_MAP, v2, v2_t, v, v_t);
    inner_t = v1_t;
    inner = v1;
    tangent_strip_influence__nearness_t(&v4, &v4_t, far, far_t, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)), (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)));
    tangent_strip_influence__influence_at_t(&v3, &v3_t, tables, table, layout__INFLUENCE_MAP, v4, v4_t, v, v_t);
    outer_t = v3_t;
    outer = v3;
    v5 = far * outer - near * inner;
    (*v6) = v5 / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
    (*result_1) = (far_t * outer + far * outer_t - (near_t * inner + near * inner_t) - (*v6) * (*cspan_at(&work_t, strip + layout__STRIP_BREADTH))) / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
    return 0;
}

/* Tangent of ``begin_influences``. */
static inline int64_t tangent_strip_influence__begin_influences_t(array_double_1d work, array_double_1d work_t)
{
    int64_t j_end;
    int64_t j;
    j_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (j = INT64_C(0); j < j_end; j += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_KNOWN)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_KNOWN)) = (double)(0);
    }
    return INT64_C(0);
}

/* Tangent of ``know_influences``. */
static inline int64_t tangent_strip_influence__know_influences_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t yawed)
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
            tangent_strip_influence__fill_column_t(tables, work, work_t, table, j, yawed);
            (*cspan_at(&work_t, strip + layout__STRIP_KNOWN)) = 0.0;
            (*cspan_at(&work, strip + layout__STRIP_KNOWN)) = (double)(1);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``fill_column``. */
static inline int64_t tangent_strip_influence__fill_column_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t j, int64_t yawed)
{
    int64_t other;
    double x_t;
    double x;
    double half_t;
    double half;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v2;
    double v1;
    double v1_t;
    double u_t;
    double u;
    double v4;
    double v4_t;
    double v3;
    double v3_t;
    double influence_t;
    double influence;
    double v5;
    double v5_t;
    double v6;
    double v8;
    double v9;
    double v9_t;
    double v7;
    double v7_t;
    double v10;
    double v11;
    double v11_t;
    double v12;
    double v12_t;
    other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
    x_t = (*cspan_at(&work_t, other + layout__STRIP_X)) + (*cspan_at(&work_t, other + layout__STRIP_LEAD));
    x = (*cspan_at(&work, other + layout__STRIP_X)) + (*cspan_at(&work, other + layout__STRIP_LEAD));
    half_t = (*cspan_at(&work_t, other + layout__STRIP_HALF_LENGTH));
    half = (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH));
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if (i != j)
        {
            v2 = (*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE));
            tangent_strip_influence__nearness_t(&v1, &v1_t, fabs(v2), tangent_rates__size_rate(v2, (*cspan_at(&work_t, strip + layout__STRIP_PLACE)) - (*cspan_at(&work_t, other + layout__STRIP_PLACE))), half, half_t);
            u_t = v1_t;
            u = v1;
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + j)) = u_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + j)) = u;
            if (yawed == INT64_C(1))
            {
                tangent_strip_influence__apartness_t(&v4, &v4_t, (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) - x, (*cspan_at(&work_t, strip + layout__STRIP_X)) + (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) - x_t, half, half_t);
                tangent_strip_influence__influence_at_t(&v3, &v3_t, tables, table, INT64_C(0), u, u_t, v4, v4_t);
                influence_t = v3_t;
                influence = v3;
            }
            else
            {
                tangent_strip_influence__middle_influence_t(&v5, &v5_t, tables, table, INT64_C(0), u, u_t);
                influence_t = v5_t;
                influence = v5;
            }
            v6 = (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN));
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = influence_t * v6 + influence * ((*cspan_at(&work_t, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work_t, other + layout__STRIP_COS)) + ((*cspan_at(&work_t, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work_t, other + layout__STRIP_SIN))));
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = influence * v6;
        }
    }
    for (i = j - INT64_C(1); i < j + INT64_C(2); i += INT64_C(2))
    {
        if ((i >= INT64_C(0)) && (i < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)))))
        {
            strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
            v8 = (*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE));
            tangent_strip_influence__apartness_t(&v9, &v9_t, (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) - x, (*cspan_at(&work_t, strip + layout__STRIP_X)) + (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) - x_t, half, half_t);
            tangent_strip_influence__mean_at_t(&v7, &v7_t, tables, work, work_t, table, other, fabs(v8), tangent_rates__size_rate(v8, (*cspan_at(&work_t, strip + layout__STRIP_PLACE)) - (*cspan_at(&work_t, other + layout__STRIP_PLACE))), v9, v9_t);
            influence_t = v7_t;
            influence = v7;
            v10 = (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN));
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = influence_t * v10 + influence * ((*cspan_at(&work_t, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work_t, other + layout__STRIP_COS)) + ((*cspan_at(&work_t, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work_t, other + layout__STRIP_SIN))));
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i + j)) = influence * v10;
        }
    }
    tangent_strip_influence__nearness_t(&v11, &v11_t, 0.5 * (*cspan_at(&work, other + layout__STRIP_BREADTH)), 0.5 * (*cspan_at(&work_t, other + layout__STRIP_BREADTH)), half, half_t);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * j + j)) = v11_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * j + j)) = v11;
    tangent_strip_influence__middle_influence_t(&v12, &v12_t, tables, table, layout__INFLUENCE_MAP, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * j + j)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * j + j)));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * j + j)) = v12_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * j + j)) = v12;
    return INT64_C(0);
}

/* Tangent of ``far_displacement``. */
static inline int64_t tangent_strip_influence__far_displacement_t(double* total, double* total_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t i, double x, double x_t, int64_t first, int64_t last)
{
    int64_t near;
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    int64_t j;
    int64_t other;
    double v1;
    double v1_t;
    double v_t;
    double v;
    double v2;
    double v2_t;
    double v3;
    double v4;
    near = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i;
    cosine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS));
    cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_COS));
    sine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN));
    sine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SIN));
    (*total_t) = 0.0;
    (*total) = 0.0;
    for (j = first; j < last; j += INT64_C(1))
    {
        other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
        if ((*cspan_at(&work, other + layout__STRIP_Y)) > 0.0)
        {
            tangent_strip_influence__apartness_t(&v1, &v1_t, x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD)), x_t - (*cspan_at(&work_t, other + layout__STRIP_X)) - (*cspan_at(&work_t, other + layout__STRIP_LEAD)), (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)), (*cspan_at(&work_t, other + layout__STRIP_HALF_LENGTH)));
            v_t = v1_t;
            v = v1;
            tangent_strip_influence__influence_at_t(&v2, &v2_t, tables, table, INT64_C(0), (*cspan_at(&work, near + j)), (*cspan_at(&work_t, near + j)), v, v_t);
            v3 = v2 * (*cspan_at(&work, other + layout__STRIP_Y));
            v4 = cosine * (*cspan_at(&work, other + layout__STRIP_COS)) + sine * (*cspan_at(&work, other + layout__STRIP_SIN));
            (*total_t) = (*total_t) + ((v2_t * (*cspan_at(&work, other + layout__STRIP_Y)) + v2 * (*cspan_at(&work_t, other + layout__STRIP_Y))) * v4 + v3 * (cosine_t * (*cspan_at(&work, other + layout__STRIP_COS)) + cosine * (*cspan_at(&work_t, other + layout__STRIP_COS)) + (sine_t * (*cspan_at(&work, other + layout__STRIP_SIN)) + sine * (*cspan_at(&work_t, other + layout__STRIP_SIN)))));
            (*total) = (*total) + v3 * v4;
        }
    }
    return 0;
}

/* Tangent of ``end_displacement``. */
static inline int64_t tangent_strip_influence__end_displacement_t(double* total, double* total_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t i, double away, double away_t)
{
    int64_t count;
    int64_t strip;
    double x_t;
    double x;
    double v2;
    double v2_t;
    double v1;
    double v1_t;
    int64_t first;
    int64_t last;
    int64_t j;
    int64_t other;
    double v4;
    double v5;
    double v5_t;
    double v3;
    double v3_t;
    double influence_t;
    double influence;
    double v6;
    double v7;
    double v8;
    double v8_t;
    double v9;
    double v9_t;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    x_t = (*cspan_at(&work_t, strip + layout__STRIP_X)) + (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) + away_t;
    x = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_LEAD)) + away;
    tangent_strip_influence__apartness_t(&v2, &v2_t, away, away_t, (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)), (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)));
    tangent_strip_influence__influence_at_t(&v1, &v1_t, tables, table, layout__INFLUENCE_MAP, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + i)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_NEAR + INT64_C(104) * i + i)), v2, v2_t);
    (*total_t) = (*cspan_at(&work_t, strip + layout__STRIP_Y)) * v1 + (*cspan_at(&work, strip + layout__STRIP_Y)) * v1_t;
    (*total) = (*cspan_at(&work, strip + layout__STRIP_Y)) * v1;
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
                v4 = (*cspan_at(&work, strip + layout__STRIP_PLACE)) - (*cspan_at(&work, other + layout__STRIP_PLACE));
                tangent_strip_influence__apartness_t(&v5, &v5_t, x - (*cspan_at(&work, other + layout__STRIP_X)) - (*cspan_at(&work, other + layout__STRIP_LEAD)), x_t - (*cspan_at(&work_t, other + layout__STRIP_X)) - (*cspan_at(&work_t, other + layout__STRIP_LEAD)), (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)), (*cspan_at(&work_t, other + layout__STRIP_HALF_LENGTH)));
                tangent_strip_influence__mean_at_t(&v3, &v3_t, tables, work, work_t, table, other, fabs(v4), tangent_rates__size_rate(v4, (*cspan_at(&work_t, strip + layout__STRIP_PLACE)) - (*cspan_at(&work_t, other + layout__STRIP_PLACE))), v5, v5_t);
                influence_t = v3_t;
                influence = v3;
                v6 = influence * (*cspan_at(&work, other + layout__STRIP_Y));
                v7 = (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN));
                (*total_t) = (*total_t) + ((influence_t * (*cspan_at(&work, other + layout__STRIP_Y)) + influence * (*cspan_at(&work_t, other + layout__STRIP_Y))) * v7 + v6 * ((*cspan_at(&work_t, strip + layout__STRIP_COS)) * (*cspan_at(&work, other + layout__STRIP_COS)) + (*cspan_at(&work, strip + layout__STRIP_COS)) * (*cspan_at(&work_t, other + layout__STRIP_COS)) + ((*cspan_at(&work_t, strip + layout__STRIP_SIN)) * (*cspan_at(&work, other + layout__STRIP_SIN)) + (*cspan_at(&work, strip + layout__STRIP_SIN)) * (*cspan_at(&work_t, other + layout__STRIP_SIN)))));
                (*total) = (*total) + v6 * v7;
            }
        }
    }
    tangent_strip_influence__far_displacement_t(&v8, &v8_t, tables, work, work_t, table, i, x, x_t, INT64_C(0), first);
    (*total_t) = (*total_t) + v8_t;
    (*total) = (*total) + v8;
    tangent_strip_influence__far_displacement_t(&v9, &v9_t, tables, work, work_t, table, i, x, x_t, last, count);
    (*total_t) = (*total_t) + v9_t;
    (*total) = (*total) + v9;
    return 0;
}
