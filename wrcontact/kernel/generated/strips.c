/* Generated from normal/strips.py by tools/transpile_kernel.py; change that one.
 *
 * The strip model: strips of the rail that press on each other through the elastic half-space
 * (docs/method.md, section 9).
 *
 * Each strip has a place s_j along the rail, a middle x_j and a half-length a_j along the track, and the
 * pressure p_j sqrt(1 - ((x - x_j) / a_j)^2).  What it displaces is eq. (S1).  One round of
 *
 * 1. solve sum_j F_ij y_j = c_i penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
 *    (strip_pressures); F_ij is how strip j displaces the middle of strip i, eqs. (S2) and (S4)
 *    (strip_influence),
 * 2. correct every half-length by how much less the surface is displaced towards the ends of the strip than the
 *    gap rises, and let the middle move to where both ends are alike, eqs. (S6) and (S7) (strip_lengths)
 *
 * is a sweep.  Strips are laid twice (strip_layout): evenly over the overlap, and by the pressures that were
 * found.
 */

#include "strips.h"

/* Divide the cells into about ``wanted`` strips, with the surfaces at each. */
static inline int64_t strips__lay_strips(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, int64_t wanted)
{
    strip_layout__divide_cells(work, count, wanted);
    strip_surfaces__trace_strips(work, tables, state, count);
    strip_surfaces__place_on_middle(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    strip_surfaces__incline_strips(work, tables);
    return INT64_C(0);
}

/* Strips that lie evenly over the zones of ``count`` regions, as the cells of the second layout; their
 * penetration [m] under ``force`` [N], or the problem's where ``by_penetration``, and 1 if found, else 0.
 */
static inline int64_t strips__first_layout(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, int64_t by_penetration)
{
    double penetration;
    int64_t found;
    int64_t sweep;
    strip_layout__zone_cells(work, count);
    strips__lay_strips(work, tables, state, count, (int64_t)(strip_layout__FIRST_SHARE * (double)((int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS)))) + 0.5));
    strip_surfaces__first_lengths(work, tables, count);
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    found = INT64_C(0);
    for (sweep = INT64_C(0); sweep < strips__FIRST_SWEEPS; sweep += INT64_C(1))
    {
        strips__solve_strips(&penetration, &found, work, tables, state, force, by_penetration);
        if (found == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = found;
            return 0;
        }
        strip_lengths__correct_lengths(work, tables, penetration, strip_lengths__FIRST_POWER, contact_plane__is_yawed(work));
        strip_lengths__adopt_lengths(work);
    }
    strip_layout__strip_cells(work);
    (*result_0) = penetration;
    (*result_1) = found;
    return 0;
}

/* Strips that are laid by the pressures of the first layout, solved; results as there.
 *
 * Of a wheel that stands where it is pressed, the force counts in the last sweep only: where it carries
 * that, the strips are those of a wheel that is pressed so deep.  The last correction is for the patches
 * alone.
 */
static inline int64_t strips__second_layout(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, int64_t by_penetration)
{
    double penetration;
    int64_t found;
    int64_t sweep_end;
    int64_t sweep;
    int64_t last;
    int64_t given;
    strips__lay_strips(work, tables, state, count, (int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS))));
    strip_surfaces__lengths_before(work, tables);
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
        strips__solve_strips(&penetration, &found, work, tables, state, force, given);
        if (found == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = found;
            return 0;
        }
        if ((last == INT64_C(0)) || ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0))
        {
            strip_lengths__correct_lengths(work, tables, penetration, strip_lengths__POWER, contact_plane__is_yawed(work));
        }
        if (last == INT64_C(0))
        {
            strip_lengths__adopt_lengths(work);
        }
    }
    (*result_0) = penetration;
    (*result_1) = found;
    return 0;
}

/* Pressures of the strips as they lie; penetration [m], and 1 if found, else 0. */
static inline int64_t strips__solve_strips(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, double force, int64_t by_penetration)
{
    strip_surfaces__set_gaps(work);
    strip_influence__begin_influences(work);
    strip_pressures__solve_pressures(result_0, result_1, work, tables, state, force, by_penetration, contact_plane__is_yawed(work));
    return 0;
}
