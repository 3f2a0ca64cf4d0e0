/* Generated from tangent_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strips.py.
 */

#include "tangent_strips.h"

/* Tangent of ``solve_strips``. */
static inline int64_t tangent_strips__solve_strips_t(double* result_0, double* result_1, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t, int64_t by_penetration)
{
    int64_t i_end;
    int64_t i;
    double penetration_t;
    double penetration;
    int64_t found;
    int64_t sweep_end;
    int64_t sweep;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        tangent_strip_influence__measure_distances_t(work, work_t, i, i);
    }
    penetration_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    found = INT64_C(0);
    sweep_end = (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS)));
    for (sweep = INT64_C(0); sweep < sweep_end; sweep += INT64_C(1))
    {
        tangent_strip_influence__fill_influences_t(tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE))));
        tangent_strip_pressures__solve_pressures_t(&penetration, &penetration_t, &found, work, work_t, tables, state, force, force_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)), by_penetration);
        if (found == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = penetration_t;
            (*result_2) = found;
            return 0;
        }
        tangent_strip_lengths__correct_lengths_t(work, work_t, tables);
        if (sweep < (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS))) - INT64_C(1))
        {
            tangent_strip_lengths__adopt_lengths_t(work, work_t);
            tangent_strip_edges__fit_edges_t(work, work_t);
        }
    }
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    (*result_2) = found;
    return 0;
}
