"""The strip correction: ANALYN's patch, corrected by the elastic half-space (docs/method.md, section 9).

The strips of ANALYN do not feel each other: the displacement of each is that of a Hertz ellipse with its own
curvatures.  Here the same strips, each with a pressure p sqrt(1 - (x/a)^2) along the track, press on one
half-space, eq. (S1):

1. place the strips over ANALYN's zone (strip_placement), and read gap and curvature there (strip_surfaces),
2. solve sum_j F_ij y_j = penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
   (strip_pressures).  F_ij is how a strip j of half-length a_j displaces the middle line of strip i, eqs.
   (S2) and (S4) (strip_influence),
3. correct every half-length by what the middle line's curvature along the track demands at its line load,
   eqs. (S6)-(S9) (strip_lengths), and cut the outermost strips at the edges of the patch (strip_edges).

One round of 2 and 3 is a sweep.  Where the true patch differs from ANALYN's, strips lose their load or are
loaded.
"""

from ..layout import Equations, NodesOfRegions, Regions, State, StripProblem, Tables
from .strip_edges import fit_edges
from .strip_influence import fill_influences, measure_distances
from .strip_lengths import adopt_lengths, correct_lengths
from .strip_pressures import solve_pressures


def solve_strips(problem: StripProblem, regions: Regions, nodes: NodesOfRegions, equations: Equations,
                 tables: Tables, state: State, force: float, by_penetration: int):
    """Correct the described strips in sweeps, under ``force`` [N], or at ANALYN's penetration where
    ``by_penetration``.

    Returns the penetration [m], and 1 if every sweep found its pressures, else 0.
    """
    for i in range(problem.count):
        measure_distances(problem.distances, problem.strips, regions, i, i)
    penetration = problem.penetration
    found = 0
    for sweep in range(tables.sweeps):
        fill_influences(tables.influence, problem)
        penetration, found = solve_pressures(problem, equations, regions, tables, state, force,
                                             problem.penetration, by_penetration)
        if found == 0:
            return penetration, found
        correct_lengths(tables, problem)
        if sweep < tables.sweeps - 1:
            adopt_lengths(problem)
            fit_edges(problem, regions, nodes)
    return penetration, found
