/* Generated from tangent_strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_lengths.py.
 */

#include "tangent_strip_lengths.h"

/* Tangent of ``correct_lengths``. */
static inline int64_t tangent_strip_lengths__correct_lengths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    int64_t count;
    double scale;
    int64_t i;
    int64_t strip;
    double line_load_t;
    double line_load;
    double square_t;
    double square;
    double pressure_t;
    double pressure;
    double half_t;
    double half;
    double v1;
    double v2;
    double v3;
    double bend_t;
    double bend;
    int64_t row;
    int64_t j;
    int64_t other;
    double away_t;
    double away;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double by_curvature_t;
    double by_curvature;
    double v11;
    double by_load_t;
    double by_load;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    double v17;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        line_load_t = 0.0;
        line_load = 0.0;
        square_t = 0.0;
        square = 0.0;
        pressure_t = 0.0;
        pressure = 0.0;
        if ((*cspan_at(&work, strip + layout__STRIP_Y)) > 0.0)
        {
            half_t = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH));
            half = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
            v1 = scale * half;
            v2 = v1 * (*cspan_at(&work, strip + layout__STRIP_Y));
            v3 = v2 / (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            line_load_t = (scale * half_t * (*cspan_at(&work, strip + layout__STRIP_Y)) + v1 * (*cspan_at(&work_t, strip + layout__STRIP_Y)) - v3 * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH))) / (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            line_load = v3;
            bend_t = 0.0;
            bend = 0.0;
            row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
            for (j = INT64_C(0); j < count; j += INT64_C(1))
            {
                other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
                away_t = (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - (*cspan_at(&work_t, other + layout__STRIP_STATION));
                away = (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, other + layout__STRIP_STATION));
                v4 = (*cspan_at(&work, row + j)) * (*cspan_at(&work, other + layout__STRIP_Y));
                v5 = (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) + away * away;
                v6 = v4 / v5;
                bend_t = bend_t + ((*cspan_at(&work_t, row + j)) * (*cspan_at(&work, other + layout__STRIP_Y)) + (*cspan_at(&work, row + j)) * (*cspan_at(&work_t, other + layout__STRIP_Y)) - v6 * ((*cspan_at(&work_t, other + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) + (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work_t, other + layout__STRIP_HALF_LENGTH)) + (away_t * away + away * away_t))) / v5;
                bend = bend + v6;
            }
            v7 = half * half;
            v8 = v7 * bend;
            v9 = 2.0 * (*cspan_at(&work, strip + layout__STRIP_A));
            v10 = v8 / v9;
            by_curvature_t = ((half_t * half + half * half_t) * bend + v7 * bend_t - v10 * (2.0 * (*cspan_at(&work_t, strip + layout__STRIP_A)))) / v9;
            by_curvature = v10;
            v11 = line_load / (*cspan_at(&work, strip + layout__STRIP_LOAD_PER_SQUARE));
            by_load_t = (line_load_t - v11 * (*cspan_at(&work_t, strip + layout__STRIP_LOAD_PER_SQUARE))) / (*cspan_at(&work, strip + layout__STRIP_LOAD_PER_SQUARE));
            by_load = v11;
            v12 = by_curvature * by_load;
            v13 = sqrt(v12);
            square_t = tangent_rates__root_rate(v13, by_curvature_t * by_load + by_curvature * by_load_t);
            square = v13;
            v14 = 2.0 / M_PI;
            v15 = v14 * line_load;
            v16 = sqrt(square);
            v17 = v15 / v16;
            pressure_t = (v14 * line_load_t - v17 * tangent_rates__root_rate(v16, square_t)) / v16;
            pressure = v17;
        }
        (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) = line_load_t;
        (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) = line_load;
        (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = square_t;
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = square;
        (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE)) = pressure_t;
        (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = pressure;
    }
    return INT64_C(0);
}

/* Tangent of ``adopt_lengths``. */
static inline int64_t tangent_strip_lengths__adopt_lengths_t(array_double_1d work, array_double_1d work_t)
{
    int64_t count;
    double longest_t;
    double longest;
    int64_t i;
    int64_t strip;
    double v1;
    double half_t;
    double half;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    longest_t = 0.0;
    longest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) > 0.0)
        {
            v1 = sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
            half_t = tangent_rates__root_rate(v1, (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
            half = v1;
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = half_t;
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = half;
            if (half > longest)
            {
                longest_t = half_t;
                longest = half;
            }
        }
    }
    tangent_strip_surfaces__limit_lengths_t(work, work_t, count, longest, longest_t);
    return INT64_C(0);
}
