/* Generated from normal/strips.py by tools/transpile_kernel.py; change that one.
 *
 * The strip correction: ANALYN's patch, corrected by the elastic half-space (docs/method.md, section 9).
 *
 * The strips of ANALYN do not feel each other: the displacement of each is that of a Hertz ellipse with its own
 * curvatures.  Here the same strips, each with a pressure p sqrt(1 - (x/a)^2) along the track, press on one
 * half-space, eq. (S1):
 *
 * 1. place the strips over ANALYN's zone (strip_placement), and read gap and curvature there (strip_surfaces),
 * 2. solve sum_j F_ij y_j = penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
 *    (strip_pressures).  F_ij is how a strip j of half-length a_j displaces the middle line of strip i, eqs.
 *    (S2) and (S4) (strip_influence),
 * 3. correct every half-length by what the middle line's curvature along the track demands at its line load,
 *    eqs. (S6)-(S9) (strip_lengths), and cut the outermost strips at the edges of the patch (strip_edges).
 *
 * One round of 2 and 3 is a sweep.  Where the true patch differs from ANALYN's, strips lose their load or are
 * loaded.
 */

#include "strips.h"

/* Correct the described strips in sweeps, under ``force`` [N], or at ANALYN's penetration where
 * ``by_penetration``.
 *
 * Returns the penetration [m], and 1 if every sweep found its pressures, else 0.
 */
static inline int64_t strips__solve_strips(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, double force, int64_t by_penetration)
{
    int64_t i_end;
    int64_t i;
    double penetration;
    int64_t found;
    int64_t sweep_end;
    int64_t sweep;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip_influence__measure_distances(work, i, i);
    }
    penetration = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION));
    found = INT64_C(0);
    sweep_end = (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS)));
    for (sweep = INT64_C(0); sweep < sweep_end; sweep += INT64_C(1))
    {
        strip_influence__fill_influences(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE))));
        strip_pressures__solve_pressures(&penetration, &found, work, tables, state, force, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)), by_penetration);
        if (found == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = found;
            return 0;
        }
        strip_lengths__correct_lengths(work, tables);
        if (sweep < (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS))) - INT64_C(1))
        {
            strip_lengths__adopt_lengths(work);
            strip_edges__fit_edges(work);
        }
    }
    (*result_0) = penetration;
    (*result_1) = found;
    return 0;
}
