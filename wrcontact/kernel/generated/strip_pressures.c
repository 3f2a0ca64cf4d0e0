/* Generated from normal/strip_pressures.py by tools/transpile_kernel.py; change that one.
 *
 * Pressures of the strips: no strip pulls, none without load penetrates, and together they carry the force;
 * eq. (S5).
 *
 * A linear complementarity problem: elimination for the strips that are taken as loaded, then an exchange of
 * those that pull or penetrate, until none does.
 */

#include "strip_pressures.h"

/* y of all strips, and which are loaded, under ``force`` [N], or at the problem's penetration where
 * ``by_penetration``; the penetration [m], and 1 if found, else 0.
 */
static inline int64_t strip_pressures__solve_pressures(double* result_0, int64_t* result_1_0001, array_double_1d work, array_double_1d tables, array_double_1d state, double force, int64_t by_penetration, int64_t yawed)
{
    double penetration;
    int64_t exchange;
    int64_t size;
    int64_t single;
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    for (exchange = INT64_C(0); exchange < strip_pressures__EXCHANGE_LIMIT; exchange += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_STRIP_COUNT)) += 1.0;
        strip_influence__know_influences(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE))), yawed);
        size = strip_pressures__list_loaded(work);
        strip_pressures__write_equations(work, size);
        elimination__eliminate(work, size);
        if (by_penetration == INT64_C(0))
        {
            penetration = strip_pressures__equilibrium_penetration(work, tables, size, force);
        }
        strip_pressures__read_solution(work, size, penetration);
        single = INT64_C(0);
        if (exchange >= strip_pressures__EXCHANGES)
        {
            single = INT64_C(1);
        }
        if (strip_pressures__exchange_strips(work, penetration, single) == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1_0001) = INT64_C(1);
            return 0;
        }
    }
    (*result_0) = penetration;
    (*result_1_0001) = INT64_C(0);
    return 0;
}

/* List the loaded strips; their number. */
static inline int64_t strip_pressures__list_loaded(array_double_1d work)
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
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + size)) = (double)(i);
            size += INT64_C(1);
        }
    }
    return size;
}

/* sum_j F_ij y_j = right-hand side, for the loaded strips: once the displacement for a penetration of 1,
 * once the gap.
 */
static inline int64_t strip_pressures__write_equations(array_double_1d work, int64_t size)
{
    int64_t rank;
    int64_t row;
    int64_t i;
    int64_t influences;
    int64_t other;
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        i = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank)));
        influences = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
        for (other = INT64_C(0); other < size; other += INT64_C(1))
        {
            (*cspan_at(&work, row + other)) = (*cspan_at(&work, influences + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + other)))));
        }
        (*cspan_at(&work, row + size)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_SHARE));
        (*cspan_at(&work, row + (size + INT64_C(1)))) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_GAP));
    }
    return INT64_C(0);
}

/* Penetration [m] at which the solved strips carry ``force`` [N]: (pi^2/2) E* sum_j a_j y_j, as far
 * as it counts.
 */
static inline double strip_pressures__equilibrium_penetration(array_double_1d work, array_double_1d tables, int64_t size, double force)
{
    double unit_load;
    double rest_load;
    int64_t rank;
    int64_t row;
    int64_t strip;
    double half;
    double result;
    unit_load = 0.0;
    rest_load = 0.0;
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank)));
        half = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__STRIP_COUNTED));
        unit_load += half * (*cspan_at(&work, row + size));
        rest_load += half * (*cspan_at(&work, row + (size + INT64_C(1))));
    }
    result = (force / (0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS))) + rest_load) / unit_load;
    return result;
}

/* y of every strip at the ``penetration`` [m]. */
static inline int64_t strip_pressures__read_solution(array_double_1d work, int64_t size, double penetration)
{
    int64_t i_end;
    int64_t i;
    int64_t rank;
    int64_t row;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_Y)) = 0.0;
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank))) + layout__STRIP_Y)) = penetration * (*cspan_at(&work, row + size)) - (*cspan_at(&work, row + (size + INT64_C(1))));
    }
    return INT64_C(0);
}

/* Unload strips that pull and load strips that penetrate, where ``single`` only the last one of all; how
 * many.
 */
static inline int64_t strip_pressures__exchange_strips(array_double_1d work, double penetration, int64_t single)
{
    int64_t count;
    int64_t back;
    int64_t i;
    int64_t strip;
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
                    (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(0);
                    changed += INT64_C(1);
                }
            }
            else
            {
                pushed = ((*cspan_at(&work, strip + layout__STRIP_SHARE)) - strip_pressures__TOUCH) * penetration - (*cspan_at(&work, strip + layout__STRIP_GAP));
                row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
                for (j = INT64_C(0); j < count; j += INT64_C(1))
                {
                    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_Y)) != 0.0)
                    {
                        pushed -= (*cspan_at(&work, row + j)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j + layout__STRIP_Y));
                    }
                }
                if (pushed > 0.0)
                {
                    (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(1);
                    changed += INT64_C(1);
                }
            }
        }
    }
    return changed;
}
