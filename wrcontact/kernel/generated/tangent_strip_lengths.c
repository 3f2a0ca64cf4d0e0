/* Generated from tangent_strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_lengths.py.
 */

#include "tangent_strip_lengths.h"

/* Tangent of ``gap_beside``. */
static inline int64_t tangent_strip_lengths__gap_beside_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t strip, double x, double x_t)
{
    double v1;
    double v2;
    v1 = x * x;
    v2 = (*cspan_at(&work, strip + layout__STRIP_A)) + (*cspan_at(&work, strip + layout__STRIP_SKEW)) * x;
    (*result_0) = v1 * v2;
    (*result_1) = (x_t * x + x * x_t) * v2 + v1 * ((*cspan_at(&work_t, strip + layout__STRIP_A)) + ((*cspan_at(&work_t, strip + layout__STRIP_SKEW)) * x + (*cspan_at(&work, strip + layout__STRIP_SKEW)) * x_t));
    return 0;
}

/* Tangent of ``corrected``. */
static inline int64_t tangent_strip_lengths__corrected_t(double* v3, double* result_1, double ratio, double ratio_t, double power, double power_t)
{
    double more_t;
    double more;
    double less_t;
    double less;
    double v1;
    double v2;
    more_t = power_t;
    more = 1.0 + power;
    less_t = -power_t;
    less = 1.0 - power;
    v1 = less + more * ratio;
    v2 = more + less * ratio;
    (*v3) = v1 / v2;
    (*result_1) = (less_t + (more_t * ratio + more * ratio_t) - (*v3) * (more_t + (less_t * ratio + less * ratio_t))) / v2;
    return 0;
}

/* Tangent of ``correct_strip``. */
static inline int64_t tangent_strip_lengths__correct_strip_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t i, double penetration, double penetration_t, double power, double power_t, int64_t yawed)
{
    int64_t strip;
    double half_t;
    double half;
    double away_t;
    double away;
    double v1;
    double v1_t;
    double own_t;
    double own;
    double needed_t;
    double needed;
    double v2;
    double v2_t;
    double front_t;
    double front;
    double back_t;
    double back;
    double v3;
    double v3_t;
    double front_gap_t;
    double front_gap;
    double back_gap_t;
    double back_gap;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double move_t;
    double move;
    double v12;
    double v13;
    double rise_t;
    double rise;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double ratio_t;
    double ratio;
    double v19;
    double v19_t;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    half_t = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH));
    half = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
    away_t = strip_lengths__TESTED * half_t;
    away = strip_lengths__TESTED * half;
    tangent_strip_lengths__gap_beside_t(&v1, &v1_t, work, work_t, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)), (*cspan_at(&work_t, strip + layout__STRIP_LEAD)));
    own_t = v1_t;
    own = v1;
    needed_t = (*cspan_at(&work_t, strip + layout__STRIP_SHARE)) * penetration + (*cspan_at(&work, strip + layout__STRIP_SHARE)) * penetration_t - (*cspan_at(&work_t, strip + layout__STRIP_GAP));
    needed = (*cspan_at(&work, strip + layout__STRIP_SHARE)) * penetration - (*cspan_at(&work, strip + layout__STRIP_GAP));
    tangent_strip_influence__end_displacement_t(&v2, &v2_t, tables, work, work_t, table, i, away, away_t);
    front_t = v2_t;
    front = v2;
    back_t = front_t;
    back = front;
    tangent_strip_lengths__gap_beside_t(&v3, &v3_t, work, work_t, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)) + away, (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) + away_t);
    front_gap_t = v3_t - own_t;
    front_gap = v3 - own;
    back_gap_t = front_gap_t;
    back_gap = front_gap;
    if (yawed == INT64_C(1))
    {
        tangent_strip_influence__end_displacement_t(&v4, &v4_t, tables, work, work_t, table, i, -away, -away_t);
        back_t = v4_t;
        back = v4;
        tangent_strip_lengths__gap_beside_t(&v5, &v5_t, work, work_t, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)) - away, (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) - away_t);
        back_gap_t = v5_t - own_t;
        back_gap = v5 - own;
        v6 = -strip_lengths__MOVED;
        v7 = front + front_gap - back - back_gap;
        v8 = v6 * v7;
        v9 = 4.0 * (*cspan_at(&work, strip + layout__STRIP_A));
        v10 = v9 * away;
        v11 = v8 / v10;
        move_t = (v6 * (front_t + front_gap_t - back_t - back_gap_t) - v11 * (4.0 * (*cspan_at(&work_t, strip + layout__STRIP_A)) * away + v9 * away_t)) / v10;
        move = v11;
        if (move > strip_lengths__FARTHEST_MOVE * half)
        {
            move_t = strip_lengths__FARTHEST_MOVE * half_t;
            move = strip_lengths__FARTHEST_MOVE * half;
        }
        if (move < (-strip_lengths__FARTHEST_MOVE) * half)
        {
            v12 = -strip_lengths__FARTHEST_MOVE;
            move_t = v12 * half_t;
            move = v12 * half;
        }
        (*cspan_at(&work_t, strip + layout__STRIP_NEXT_LEAD)) = (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) + move_t;
        (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_LEAD)) + move;
    }
    v13 = front_gap + back_gap;
    rise_t = 0.5 * (front_gap_t + back_gap_t);
    rise = 0.5 * v13;
    if (rise < strip_lengths__FLATTEST * (*cspan_at(&work, strip + layout__STRIP_A)) * away * away)
    {
        v14 = strip_lengths__FLATTEST * (*cspan_at(&work, strip + layout__STRIP_A));
        v15 = v14 * away;
        rise_t = (strip_lengths__FLATTEST * (*cspan_at(&work_t, strip + layout__STRIP_A)) * away + v14 * away_t) * away + v15 * away_t;
        rise = v15 * away;
    }
    v16 = front + back;
    v17 = needed - 0.5 * v16;
    v18 = v17 / rise;
    ratio_t = (needed_t - 0.5 * (front_t + back_t) - v18 * rise_t) / rise;
    ratio = v18;
    if (!(ratio > 0.0))
    {
        ratio_t = 0.0;
        ratio = 0.0;
    }
    tangent_strip_lengths__corrected_t(&v19, &v19_t, ratio, ratio_t, power, power_t);
    (*result_0) = half * v19;
    (*result_1) = half_t * v19 + half * v19_t;
    return 0;
}

/* Tangent of ``correct_lengths``. */
static inline int64_t tangent_strip_lengths__correct_lengths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, double penetration, double penetration_t, double power, double power_t, int64_t yawed)
{
    int64_t count;
    double scale;
    double largest_t;
    double largest;
    int64_t i;
    int64_t strip;
    double v1;
    double v1_t;
    double half_t;
    double half;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    double share_t;
    double share;
    double v8;
    double v8_t;
    double beside_t;
    double beside;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    largest_t = 0.0;
    largest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) = 0.0;
        (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = 0.0;
        (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = 0.0;
        (*cspan_at(&work_t, strip + layout__STRIP_NEXT_LEAD)) = (*cspan_at(&work_t, strip + layout__STRIP_LEAD));
        (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_LEAD));
        if ((*cspan_at(&work, strip + layout__STRIP_Y)) > 0.0)
        {
            tangent_strip_lengths__correct_strip_t(&v1, &v1_t, tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE))), i, penetration, penetration_t, power, power_t, yawed);
            half_t = v1_t;
            half = v1;
            v2 = scale * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
            v3 = v2 * (*cspan_at(&work, strip + layout__STRIP_Y));
            v4 = v3 / (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) = (scale * (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__STRIP_Y)) + v2 * (*cspan_at(&work_t, strip + layout__STRIP_Y)) - v4 * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH))) / (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) = v4;
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = half_t * half + half * half_t;
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = half * half;
            v5 = (*cspan_at(&work, strip + layout__STRIP_Y)) / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
            (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE)) = ((*cspan_at(&work_t, strip + layout__STRIP_Y)) - v5 * (*cspan_at(&work_t, strip + layout__STRIP_BREADTH))) / (*cspan_at(&work, strip + layout__STRIP_BREADTH));
            (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = v5;
            if ((*cspan_at(&work, strip + layout__STRIP_PRESSURE)) > largest)
            {
                largest_t = (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE));
                largest = (*cspan_at(&work, strip + layout__STRIP_PRESSURE));
            }
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        v6 = strip_lengths__LIGHT * largest;
        v7 = (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) / v6;
        share_t = ((*cspan_at(&work_t, strip + layout__STRIP_PRESSURE)) - v7 * (strip_lengths__LIGHT * largest_t)) / v6;
        share = v7;
        if (share < 1.0)
        {
            tangent_strip_lengths__neighbouring_length_t(&v8, &v8_t, work, work_t, count, i);
            beside_t = v8_t;
            beside = v8;
            v9 = sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
            v10 = 1.0 - share;
            half_t = share_t * v9 + share * tangent_rates__root_rate(v9, (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE))) + ((-share_t) * beside + v10 * beside_t);
            half = share * v9 + v10 * beside;
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = half_t * half + half * half_t;
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = half * half;
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_Y)) > 0.0)
        {
            v11 = 2.0 / M_PI;
            v12 = v11 * (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD));
            v13 = v12 * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            v14 = sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
            v15 = (*cspan_at(&work, strip + layout__STRIP_BREADTH)) * v14;
            v16 = v13 / v15;
            (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE)) = (v11 * (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) + v12 * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH)) - v16 * ((*cspan_at(&work_t, strip + layout__STRIP_BREADTH)) * v14 + (*cspan_at(&work, strip + layout__STRIP_BREADTH)) * tangent_rates__root_rate(v14, (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE))))) / v15;
            (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = v16;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``neighbouring_length``. */
static inline int64_t tangent_strip_lengths__neighbouring_length_t(double* half, double* half_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t i)
{
    double total_t;
    double total;
    double weight_t;
    double weight;
    int64_t before;
    double v1;
    int64_t after;
    double v2;
    double v3;
    total_t = 0.0;
    total = 0.0;
    weight_t = 0.0;
    weight = 0.0;
    if (i > INT64_C(0))
    {
        before = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1));
        weight_t = weight_t + (*cspan_at(&work_t, before + layout__STRIP_PRESSURE));
        weight = weight + (*cspan_at(&work, before + layout__STRIP_PRESSURE));
        v1 = sqrt((*cspan_at(&work, before + layout__STRIP_HALF_LENGTH_SQUARE)));
        total_t = total_t + ((*cspan_at(&work_t, before + layout__STRIP_PRESSURE)) * v1 + (*cspan_at(&work, before + layout__STRIP_PRESSURE)) * tangent_rates__root_rate(v1, (*cspan_at(&work_t, before + layout__STRIP_HALF_LENGTH_SQUARE))));
        total = total + (*cspan_at(&work, before + layout__STRIP_PRESSURE)) * v1;
    }
    if (i < count - INT64_C(1))
    {
        after = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1));
        weight_t = weight_t + (*cspan_at(&work_t, after + layout__STRIP_PRESSURE));
        weight = weight + (*cspan_at(&work, after + layout__STRIP_PRESSURE));
        v2 = sqrt((*cspan_at(&work, after + layout__STRIP_HALF_LENGTH_SQUARE)));
        total_t = total_t + ((*cspan_at(&work_t, after + layout__STRIP_PRESSURE)) * v2 + (*cspan_at(&work, after + layout__STRIP_PRESSURE)) * tangent_rates__root_rate(v2, (*cspan_at(&work_t, after + layout__STRIP_HALF_LENGTH_SQUARE))));
        total = total + (*cspan_at(&work, after + layout__STRIP_PRESSURE)) * v2;
    }
    (*half_t) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
    (*half) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
    if (weight > 0.0)
    {
        v3 = total / weight;
        (*half_t) = (total_t - v3 * weight_t) / weight;
        (*half) = v3;
    }
    return 0;
}

/* Tangent of ``adopt_lengths``. */
static inline int64_t tangent_strip_lengths__adopt_lengths_t(array_double_1d work, array_double_1d work_t)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v1;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        v1 = sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
        (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = tangent_rates__root_rate(v1, (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = v1;
        (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) = (*cspan_at(&work_t, strip + layout__STRIP_NEXT_LEAD));
        (*cspan_at(&work, strip + layout__STRIP_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD));
    }
    tangent_strip_lengths__limit_lengths_t(work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}

/* Tangent of ``limit_lengths``. */
static inline int64_t tangent_strip_lengths__limit_lengths_t(array_double_1d work, array_double_1d work_t, int64_t count)
{
    double longest_t;
    double longest;
    int64_t i;
    int64_t strip;
    longest_t = 0.0;
    longest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH)) > longest)
        {
            longest_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
            longest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH));
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_lengths__SHORTEST * longest)
        {
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = strip_lengths__SHORTEST * longest_t;
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_lengths__SHORTEST * longest;
        }
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) < strip_lengths__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH)))
        {
            (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = strip_lengths__SQUARE * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = strip_lengths__SQUARE * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        }
    }
    return INT64_C(0);
}
