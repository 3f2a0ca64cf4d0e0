/* Generated from tangent_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strips.py.
 */

#include "tangent_strips.h"

/* Tangent of ``lay_strips``. */
static inline int64_t tangent_strips__lay_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, int64_t wanted)
{
    tangent_strip_layout__divide_cells_t(work, work_t, count, wanted);
    tangent_strip_surfaces__trace_strips_t(work, work_t, tables, state, count);
    tangent_strip_surfaces__place_on_middle_t(work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    tangent_strip_surfaces__incline_strips_t(work, work_t, tables);
    return INT64_C(0);
}

/* Tangent of ``first_layout``. */
static inline int64_t tangent_strips__first_layout_t(double* result_0, double* result_1, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, int64_t by_penetration)
{
    double penetration_t;
    double penetration;
    int64_t found;
    int64_t sweep;
    tangent_strip_layout__zone_cells_t(work, work_t, count);
    tangent_strips__lay_strips_t(work, work_t, tables, state, count, (int64_t)(strip_layout__FIRST_SHARE * (double)((int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS)))) + 0.5));
    tangent_strip_surfaces__first_lengths_t(work, work_t, tables, count);
    penetration_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    found = INT64_C(0);
    for (sweep = INT64_C(0); sweep < strips__FIRST_SWEEPS; sweep += INT64_C(1))
    {
        tangent_strips__solve_strips_t(&penetration, &penetration_t, &found, work, work_t, tables, state, force, force_t, by_penetration);
        if (found == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = penetration_t;
            (*result_2) = found;
            return 0;
        }
        tangent_strip_lengths__correct_lengths_t(work, work_t, tables, penetration, penetration_t, strip_lengths__FIRST_POWER, 0.0, contact_plane__is_yawed(work));
        tangent_strip_lengths__adopt_lengths_t(work, work_t);
    }
    tangent_strip_layout__strip_cells_t(work, work_t);
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    (*result_2) = found;
    return 0;
}

/* Tangent of ``second_layout``. */
static inline int64_t tangent_strips__second_layout_t(double* result_0, double* result_1, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, int64_t by_penetration)
{
    double penetration_t;
    double penetration;
    int64_t found;
    int64_t sweep_end;
    int64_t sweep;
    int64_t last;
    int64_t given;
    tangent_strips__lay_strips_t(work, work_t, tables, state, count, (int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS))));
    tangent_strip_surfaces__lengths_before_t(work, work_t, tables);
    penetration_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    found = INT64_C(0);
    sweep_end = (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS)));
    for (sweep = INT64_C(0); sweep < sweep_end; sweep += INT64_C(1))
    {
        last = INT64_C(0);
        if (sweep == (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS))) - INT64_C(1))
        {
            last = INT64_C(1);
        }
        given = INT64_C(1);
        if ((last == INT64_C(1)) || ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) == 1.0))
        {
            given = by_penetration;
        }
        tangent_strips__solve_strips_t(&penetration, &penetration_t, &found, work, work_t, tables, state, force, force_t, given);
        if (found == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = penetration_t;
            (*result_2) = found;
            return 0;
        }
        if ((last == INT64_C(0)) || ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0))
        {
            tangent_strip_lengths__correct_lengths_t(work, work_t, tables, penetration, penetration_t, strip_lengths__POWER, 0.0, contact_plane__is_yawed(work));
        }
        if (last == INT64_C(0))
        {
            tangent_strip_lengths__adopt_lengths_t(work, work_t);
        }
    }
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    (*result_2) = found;
    return 0;
}

/* Tangent of ``solve_strips``. */
static inline int64_t tangent_strips__solve_strips_t(double* r1, double* r1_t, int64_t* r2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t, int64_t by_penetration)
{
    tangent_strip_surfaces__set_gaps_t(work, work_t);
    tangent_strip_influence__begin_influences_t(work, work_t);
    tangent_strip_pressures__solve_pressures_t(r1, r1_t, r2, work, work_t, tables, state, force, force_t, by_penetration, contact_plane__is_yawed(work));
    return 0;
}
