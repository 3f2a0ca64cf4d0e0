"""The contact on one grid of equal cells."""

import numpy as np

from .checks import check_load, check_number, checked_grid
from .edge import loaded_area, peak_pressure
from .flat_gap import FlatGap
from .gradients import PRECISION, constrained_gradients, estimate_penetration
from .problem import Problem
from .solution import HalfspaceContact


def solve(x, s, gap, *, contact_modulus, force=None, penetration=None, guess=None, precision=PRECISION):
    """The contact on a given grid over a plane, for a prescribed force or a prescribed penetration.

    Parameters
    ----------
    x, s : cell centres (n,), (m,) [m], rising and evenly spaced, two or more each.
    gap : undeformed distance h of the bodies (n, m) [m]; infinite where there is no surface.
    contact_modulus : E*, 1/E* = (1 - nu1**2)/E1 + (1 - nu2**2)/E2 [Pa].
    force : N [N], zero or more; or
    penetration : delta [m], against the zero of ``gap``; exactly one of the two.
    guess : pressure to start from (n, m) [Pa]; changes the cost, never the answer beyond ``precision``.
    precision : residual of the contact condition, rms over the loaded cells, as a
    share of the largest deflection.

    Returns
    -------
    HalfspaceContact

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and what is permitted.
    ArithmeticError
        if the residual does not fall to ``precision`` within ITERATION_LIMIT iterations.
    """
    x, s, gap = checked_grid(x, s, gap)
    check_load(force, penetration)
    check_number("contact_modulus", contact_modulus, "Pa", above=True)
    check_number("precision", precision, "1", above=True)
    return solve_grid(Problem(FlatGap(lambda *_: gap), None, contact_modulus, force, penetration, precision),
                      x, s, guess)


def solve_grid(problem, x, s, guess=None):
    """The contact of a :class:`Problem` on evenly spaced cell centres x (n,), s (m,) [m]."""
    gap, angle, share = problem.surfaces.gap(x, s), problem.surfaces.angle(s), problem.surfaces.share(s)
    if not np.isfinite(gap).any():
        raise ArithmeticError(f"there are no surfaces between x = {x[0]:g} ... {x[-1]:g} m and s = "
                              f"{s[0]:g} ... {s[-1]:g} m; permitted are grids with a finite gap")
    force, penetration = problem.force, problem.penetration
    dx, ds = (float(centres[-1] - centres[0]) / (len(centres) - 1) for centres in (x, s))
    lowest = float((gap / share).min())
    if force == 0.0 or (force is None and penetration <= lowest):
        delta = lowest if force == 0.0 else float(penetration)
        return HalfspaceContact(x, s, np.zeros(gap.shape), gap - delta * share, delta, 0.0, 0.0, 0.0, 0,
                                angle=angle)
    deflect = problem.deflection(gap.shape, dx, ds, angle)
    if guess is None or not np.any(np.asarray(guess) > 0.0):
        level = penetration if force is None else estimate_penetration(
            gap / share, dx * ds, problem.contact_modulus, force)
        guess = np.sqrt(np.maximum(level * share - gap, 0.0))      # the shape of Hertz's pressure
    start = np.where(np.isfinite(gap), np.maximum(guess, 0.0), 0.0)
    pressure, clearance, delta, iterations = constrained_gradients(
        start, gap, deflect, problem, cell=dx * ds, share=share, weight=problem.weight(angle))
    return HalfspaceContact(x, s, pressure, clearance, delta, float(pressure.sum() * dx * ds),
                            float(loaded_area(pressure) * dx * ds), peak_pressure(pressure), iterations,
                            angle=angle)
