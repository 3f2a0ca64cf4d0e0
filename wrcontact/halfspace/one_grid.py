"""The contact on one grid of equal cells, and checks of what is given."""

import math

import numpy as np

from .edge import loaded_area, peak_pressure
from .flat_gap import FlatGap
from .gradients import PRECISION, constrained_gradients, estimate_penetration
from .problem import HalfspaceContact, Problem


def check_number(name, value, unit, above=False):
    """ValueError unless ``value`` is a finite number >= 0, or > 0 where ``above``."""
    try:
        good = math.isfinite(value) and (value > 0.0 if above else value >= 0.0)
    except TypeError:
        good = False
    if not good:
        raise ValueError(
            f"{name} is {value!r} {unit}; permitted is {name} {'>' if above else '>='} 0 {unit}, finite"
        )


def check_load(force, penetration):
    if (force is None) == (penetration is None):
        raise ValueError(
            f"force is {force!r} N and penetration is {penetration!r} m; permitted is exactly one of them"
        )
    if force is not None:
        check_number("force", force, "N")
    elif not (isinstance(penetration, (int, float, np.number)) and math.isfinite(penetration)):
        raise ValueError(f"penetration is {penetration!r} m; permitted are finite numbers")


def checked_domain(domain):
    try:
        x_low, x_high, s_low, s_high = (float(side) for side in domain)
        good = (
            x_low < x_high
            and s_low < s_high
            and math.isfinite(x_high - x_low)
            and math.isfinite(s_high - s_low)
        )
    except (TypeError, ValueError):
        good = False
    if not good:
        raise ValueError(
            f"domain is {domain!r} m; permitted is (x_low, x_high, s_low, s_high), finite, low below high"
        )
    return x_low, x_high, s_low, s_high


def checked_grid(x, s, gap):
    x, s, gap = (np.asarray(array, dtype=float) for array in (x, s, gap))
    for name, centres in (("x", x), ("s", s)):
        steps = np.diff(centres) if centres.ndim == 1 else np.zeros(0)
        if (
            len(steps) == 0
            or not steps[0] > 0.0
            or not np.all(np.abs(steps - steps.mean()) <= 1e-6 * steps.mean())
        ):
            raise ValueError(
                f"{name} has shape {centres.shape}; permitted are two or more rising, evenly "
                "spaced values in m"
            )
    if gap.shape != (len(x), len(s)):
        raise ValueError(
            f"gap has shape {gap.shape}; permitted is {(len(x), len(s))}, one value in m per cell"
        )
    if np.isnan(gap).any() or not np.isfinite(gap).any() or np.any(gap == -math.inf):
        raise ValueError(
            "gap holds nan or no finite value in m; permitted are finite values, and inf without a surface"
        )
    return x, s, gap


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
    return solve_grid(
        Problem(FlatGap(lambda *_: gap), None, contact_modulus, force, penetration, precision), x, s, guess
    )


def solve_grid(problem, x, s, guess=None):
    """The contact of a :class:`Problem` on evenly spaced cell centres x (n,), s (m,) [m]."""
    gap, angle, share = problem.surfaces.gap(x, s), problem.surfaces.angle(s), problem.surfaces.share(s)
    if not np.isfinite(gap).any():
        raise ArithmeticError(
            f"there are no surfaces between x = {x[0]:g} ... {x[-1]:g} m and s = "
            f"{s[0]:g} ... {s[-1]:g} m; permitted are grids with a finite gap"
        )
    force, penetration = problem.force, problem.penetration
    dx, ds = (float(centres[-1] - centres[0]) / (len(centres) - 1) for centres in (x, s))
    lowest = float((gap / share).min())
    if force == 0.0 or (force is None and penetration <= lowest):
        delta = lowest if force == 0.0 else float(penetration)
        return HalfspaceContact(
            x, s, np.zeros(gap.shape), gap - delta * share, delta, 0.0, 0.0, 0.0, 0, angle=angle
        )
    deflect = problem.deflection(gap.shape, dx, ds, angle)
    if guess is None or not np.any(np.asarray(guess) > 0.0):
        level = (
            penetration
            if force is None
            else estimate_penetration(gap / share, dx * ds, problem.contact_modulus, force)
        )
        guess = np.sqrt(np.maximum(level * share - gap, 0.0))  # the shape of Hertz's pressure
    start = np.where(np.isfinite(gap), np.maximum(guess, 0.0), 0.0)
    pressure, clearance, delta, iterations = constrained_gradients(
        start, gap, deflect, problem, cell=dx * ds, share=share, weight=problem.weight(angle)
    )
    return HalfspaceContact(
        x,
        s,
        pressure,
        clearance,
        delta,
        float(pressure.sum() * dx * ds),
        float(loaded_area(pressure) * dx * ds),
        peak_pressure(pressure),
        iterations,
        angle=angle,
    )
