"""Frictionless contact of two elastic half-spaces: the complete theory, for any gap
between the undeformed bodies.

>>> import numpy as np
>>> from wrcontact.halfspace import contact
>>> ball = lambda x, s: (x[:, None] ** 2 + s**2) / (2 * 0.3)                       # radius 0.3 m on a flat
>>> found = contact.solve_contact(ball, (-0.1, 0.1, -0.1, 0.1), contact_modulus=1.14e11, force=1e4)
>>> f"{found.penetration:.2e} m, {found.max_pressure:.2e} Pa"
'2.43e-05 m, 6.54e+08 Pa'

The bodies touch where the pressure p is positive; the equations (H1) ... are those of docs/method.md:

    u + h - delta = 0 where p > 0, u + h - delta >= 0 where p = 0, sum of p dx ds = N (H1)

Pressure is constant on each cell of a grid. Its deflection u is a convolution (Love 1929; Johnson 1985,
section 3.3), done by fast Fourier transform; the pressures follow by conjugate gradients that keep p >= 0
(Polonsky and Keer 1999, Wear 231, 206-219). :func:`solve_contact` takes the gap over a plane as a function,
finds the patch and refines the grid until the answer stands. :func:`solve_problem` does this for any
surfaces; those of a wheel and its rail have normals that turn (turning_gap.py), and pressures act on each
other with the cosine of the angle between them.

Lengths in m, pressures in Pa, forces in N; x along the first axis of every array, s along the second.
"""

from .blocks import refine_blocks
from .boxes import are_apart, loaded_boxes, merged
from .flat_gap import FlatGap
from .missed import missed
from .one_grid import check_load, check_number, checked_domain
from .problem import Problem
from .refinement import refine, solve_window

#: Error in penetration (or force), area and peak pressure at which a grid is fine enough.
TOLERANCE = 5e-3
TOLERANCE_RANGE = (3e-4, 0.1)     # the edge is known to EDGE_DOUBT: less would take more than CELL_LIMIT
#: The residual is reduced to this share of the tolerance, so that it does not count in the grid's error.
RESIDUAL_SHARE = 1e-3
LOOK_REPEATS = 7


def solve_contact(gap_function, domain, *, contact_modulus, force=None, penetration=None,
                  tolerance=TOLERANCE):
    """The contact for any gap: finds the patches, fits a grid to them, and refines it
    until the answer stands.

    A solution stands only if the bodies overlap nowhere else in the domain (:func:`missed`).  Each group of
    patches has its own grid where they are far apart, or where patches have been missed at first.

    Parameters
    ----------
    gap_function : called with cell centres x (n,), s (m,) [m]; returns the undeformed distance (n, m) [m],
        infinite where there is no surface.
    domain : (x_low, x_high, s_low, s_high) [m], within which all patches lie; the look for further ones takes
        LOOK samples of it, and along x one minimum for each s.
    contact_modulus : E* [Pa].
    force, penetration : [N], [m]; exactly one of the two.
    tolerance : permitted relative error in penetration (or force), area and peak pressure, 3e-4 ... 0.1.

    Returns
    -------
    HalfspaceContact
        with ``error`` by :func:`estimate_error`.

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and what is permitted.
    ArithmeticError
        if the grid would need more than CELL_LIMIT cells, or the patch reaches the end of the domain.
    """
    check_load(force, penetration)
    check_number("contact_modulus", contact_modulus, "Pa", above=True)
    domain = checked_domain(domain)
    if not TOLERANCE_RANGE[0] <= tolerance <= TOLERANCE_RANGE[1]:
        raise ValueError(f"tolerance is {tolerance!r}; permitted is {TOLERANCE_RANGE[0]:g} ... "
                         f"{TOLERANCE_RANGE[1]:g}")
    return solve_problem(Problem(FlatGap(gap_function), domain, contact_modulus, force, penetration,
                                 RESIDUAL_SHARE * tolerance), tolerance)


def solve_problem(problem, tolerance=TOLERANCE):
    """The contact of a :class:`~wrcontact.halfspace.problem.Problem`, over a plane or where the patches turn;
    as :func:`solve_contact`."""
    found = solve_window(problem, problem.surfaces.window(problem))
    if not found.pressure.any():
        return found
    ridge = problem.surfaces.ridge(problem.domain)
    for _ in range(LOOK_REPEATS):
        boxes = missed(problem, ridge, found)
        if found.error and not boxes:
            return found
        # what a patch that has been missed will carry is not known, but little
        patches = loaded_boxes(found) + [(box, 0.0) for box in boxes]
        found = (refine_blocks(problem, patches, tolerance)
                 if boxes or are_apart(merged([box for box, _ in patches]))
                 else refine(problem, found, tolerance))
    raise ArithmeticError(f"{len(boxes)} places are still missed after {LOOK_REPEATS} looks; permitted is "
                          "none")
