/* Generated from tangent_strip_pressures.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_pressures.py.
 */

#include "tangent_strip_pressures.h"

/* Tangent of ``solve_pressures``. */
static inline int64_t tangent_strip_pressures__solve_pressures_t(double* result_0, double* result_1, int64_t* result_2_0001, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t, int64_t by_penetration, int64_t yawed)
{
    double penetration_t;
    double penetration;
    int64_t exchange;
    int64_t n1;
    int64_t size;
    double v2;
    double v2_t;
    int64_t single;
    int64_t n3;
    penetration_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    for (exchange = INT64_C(0); exchange < strip_pressures__EXCHANGE_LIMIT; exchange += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_STRIP_COUNT)) = (*cspan_at(&state, layout__STATE_STRIP_COUNT)) + 1.0;
        tangent_strip_influence__know_influences_t(tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE))), yawed);
        n1 = tangent_strip_pressures__list_loaded_t(work, work_t);
        size = n1;
        tangent_strip_pressures__write_equations_t(work, work_t, size);
        tangent_elimination__eliminate_t(work, work_t, size);
        if (by_penetration == INT64_C(0))
        {
            tangent_strip_pressures__equilibrium_penetration_t(&v2, &v2_t, work, work_t, tables, size, force, force_t);
            penetration_t = v2_t;
            penetration = v2;
        }
        tangent_strip_pressures__read_solution_t(work, work_t, size, penetration, penetration_t);
        single = INT64_C(0);
        if (exchange >= strip_pressures__EXCHANGES)
        {
            single = INT64_C(1);
        }
        n3 = tangent_strip_pressures__exchange_strips_t(work, work_t, penetration, penetration_t, single);
        if (n3 == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = penetration_t;
            (*result_2_0001) = INT64_C(1);
            return 0;
        }
    }
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    (*result_2_0001) = INT64_C(0);
    return 0;
}

/* Tangent of ``list_loaded``. */
static inline int64_t tangent_strip_pressures__list_loaded_t(array_double_1d work, array_double_1d work_t)
{
    int64_t i_end;
    int64_t i;
    int64_t size;
    size = INT64_C(0);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LOADED)) == 1.0)
        {
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + size)) = 0.0;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + size)) = (double)(i);
            size = size + INT64_C(1);
        }
    }
    return size;
}

/* Tangent of ``write_equations``. */
static inline int64_t tangent_strip_pressures__write_equations_t(array_double_1d work, array_double_1d work_t, int64_t size)
{
    int64_t rank;
    int64_t row;
    int64_t i;
    int64_t influences;
    int64_t other;
    int64_t k1;
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        i = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank)));
        influences = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
        for (other = INT64_C(0); other < size; other += INT64_C(1))
        {
            k1 = influences + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + other)));
            (*cspan_at(&work_t, row + other)) = (*cspan_at(&work_t, k1));
            (*cspan_at(&work, row + other)) = (*cspan_at(&work, k1));
        }
        (*cspan_at(&work_t, row + size)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SHARE));
        (*cspan_at(&work, row + size)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SHARE));
        (*cspan_at(&work_t, row + (size + INT64_C(1)))) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_GAP));
        (*cspan_at(&work, row + (size + INT64_C(1)))) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_GAP));
    }
    return INT64_C(0);
}

/* Tangent of ``equilibrium_penetration``. */
static inline int64_t tangent_strip_pressures__equilibrium_penetration_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t size, double force, double force_t)
{
    double unit_load_t;
    double unit_load;
    double rest_load_t;
    double rest_load;
    int64_t rank;
    int64_t row;
    int64_t strip;
    double half_t;
    double half;
    double v1;
    double v2;
    unit_load_t = 0.0;
    unit_load = 0.0;
    rest_load_t = 0.0;
    rest_load = 0.0;
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank)));
        half_t = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__STRIP_COUNTED)) + (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work_t, strip + layout__STRIP_COUNTED));
        half = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__STRIP_COUNTED));
        unit_load_t = unit_load_t + (half_t * (*cspan_at(&work, row + size)) + half * (*cspan_at(&work_t, row + size)));
        unit_load = unit_load + half * (*cspan_at(&work, row + size));
        rest_load_t = rest_load_t + (half_t * (*cspan_at(&work, row + (size + INT64_C(1)))) + half * (*cspan_at(&work_t, row + (size + INT64_C(1)))));
        rest_load = rest_load + half * (*cspan_at(&work, row + (size + INT64_C(1))));
    }
    v1 = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    v2 = force / v1 + rest_load;
    (*v3) = v2 / unit_load;
    (*result_1) = (force_t / v1 + rest_load_t - (*v3) * unit_load_t) / unit_load;
    return 0;
}

/* Tangent of ``read_solution``. */
static inline int64_t tangent_strip_pressures__read_solution_t(array_double_1d work, array_double_1d work_t, int64_t size, double penetration, double penetration_t)
{
    int64_t i_end;
    int64_t i;
    int64_t rank;
    int64_t row;
    int64_t k1;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_Y)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_Y)) = 0.0;
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        k1 = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank))) + layout__STRIP_Y;
        (*cspan_at(&work_t, k1)) = penetration_t * (*cspan_at(&work, row + size)) + penetration * (*cspan_at(&work_t, row + size)) - (*cspan_at(&work_t, row + (size + INT64_C(1))));
        (*cspan_at(&work, k1)) = penetration * (*cspan_at(&work, row + size)) - (*cspan_at(&work, row + (size + INT64_C(1))));
    }
    return INT64_C(0);
}

/* Tangent of ``exchange_strips``. */
static inline int64_t tangent_strip_pressures__exchange_strips_t(array_double_1d work, array_double_1d work_t, double penetration, double penetration_t, int64_t single)
{
    int64_t count;
    int64_t back;
    int64_t i;
    int64_t strip;
    double v1;
    double pushed_t;
    double pushed;
    int64_t row;
    int64_t j;
    int64_t changed;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    changed = INT64_C(0);
    for (back = INT64_C(0); back < count; back += INT64_C(1))
    {
        i = count - INT64_C(1) - back;
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((single == INT64_C(0)) || (changed == INT64_C(0)))
        {
            if ((*cspan_at(&work, strip + layout__STRIP_LOADED)) == 1.0)
            {
                if ((*cspan_at(&work, strip + layout__STRIP_Y)) < 0.0)
                {
                    (*cspan_at(&work_t, strip + layout__STRIP_LOADED)) = 0.0;
                    (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(0);
                    changed = changed + INT64_C(1);
                }
            }
            else
            {
                v1 = (*cspan_at(&work, strip + layout__STRIP_SHARE)) - strip_pressures__TOUCH;
                pushed_t = (*cspan_at(&work_t, strip + layout__STRIP_SHARE)) * penetration + v1 * penetration_t - (*cspan_at(&work_t, strip + layout__STRIP_GAP));
                pushed = v1 * penetration - (*cspan_at(&work, strip + layout__STRIP_GAP));
                row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
                for (j = INT64_C(0); j < count; j += INT64_C(1))
                {
                    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_Y)) != 0.0)
                    {
                        pushed_t = pushed_t - ((*cspan_at(&work_t, row + j)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_Y)) + (*cspan_at(&work, row + j)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_Y)));
                        pushed = pushed - (*cspan_at(&work, row + j)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_Y));
                    }
                }
                if (pushed > 0.0)
                {
                    (*cspan_at(&work_t, strip + layout__STRIP_LOADED)) = 0.0;
                    (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(1);
                    changed = changed + INT64_C(1);
                }
            }
        }
    }
    return changed;
}
