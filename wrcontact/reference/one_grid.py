"""The contact on a given grid, by conjugate gradients that keep the pressure positive.

Polonsky and Keer (1999), Wear 231, 206-219.
"""

import math

import numpy as np

from .checks import check_load, check_number, checked_grid
from .deflection import Deflection
from .edge import loaded_area, peak_pressure
from .solution import HalfspaceContact

#: Remaining residual of the contact condition, rms over the loaded cells, as a share
#: of the largest deflection.
PRECISION = 1e-7
ITERATION_LIMIT = 1000


def solve(x, s, gap, *, contact_modulus, force=None, penetration=None, guess=None, precision=PRECISION):
    """The contact on a given grid, for a prescribed force or a prescribed penetration.

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
    dx, ds = (float(centres[-1] - centres[0]) / (len(centres) - 1) for centres in (x, s))
    lowest = float(gap.min())
    if force == 0.0 or (force is None and penetration <= lowest):
        delta = lowest if force == 0.0 else float(penetration)
        return HalfspaceContact(x, s, np.zeros(gap.shape), gap - delta, delta, 0.0, 0.0, 0.0, 0)
    deflect = Deflection(gap.shape, dx, ds, contact_modulus)
    if guess is None or not np.any(np.asarray(guess) > 0.0):
        level = penetration if force is None else estimate_penetration(gap, dx * ds, contact_modulus, force)
        guess = np.sqrt(np.maximum(level - gap, 0.0))      # the shape of Hertz's pressure
    start = np.where(np.isfinite(gap), np.maximum(guess, 0.0), 0.0)
    mean = None if force is None else force / (dx * ds)
    pressure, clearance, delta, iterations = constrained_gradients(start, gap, deflect, mean, penetration,
                                                                   precision)
    return HalfspaceContact(x, s, pressure, clearance, delta, float(pressure.sum() * dx * ds),
                            float(loaded_area(pressure) * dx * ds), peak_pressure(pressure), iterations)


def constrained_gradients(pressure, gap, deflect, total, penetration, precision):
    """Pressure, clearance, penetration, iterations: Polonsky and Keer (1999), section 3.

    ``total`` is the sum of all pressures [Pa]; None where the penetration [m] is prescribed. Their
    steps: residual on the loaded cells, conjugate direction, exact line search, tension cut off,
    overlapping cells let in, load restored.
    """
    pressure = _scaled(pressure, gap, deflect, total, penetration)
    bent = deflect(pressure)
    direction, last = np.zeros(gap.shape), math.inf
    for iteration in range(ITERATION_LIMIT + 1):
        loaded = pressure > 0.0
        clearance = bent + gap
        delta = penetration if total is None else float(clearance[loaded].mean())
        clearance -= delta
        residual = clearance[loaded]
        square = float(residual @ residual)
        allowed = precision * float(bent.max())
        outside = ~loaded & (clearance < 0.0)
        if square <= allowed**2 * residual.size and not np.any(clearance[outside] < -allowed):
            return pressure, clearance, delta, iteration
        direction = np.where(loaded, clearance + (square / last) * direction, 0.0)
        change = deflect(direction)
        along, answer = direction[loaded], change[loaded]
        if total is not None:
            answer = answer - answer.mean()
        step = float(residual @ along) / float(answer @ along)
        if not step > 0.0:      # the direction has lost its meaning: restart
            direction, last = np.zeros(gap.shape), math.inf
            continue
        pressure = pressure - step * direction
        cut = pressure < 0.0
        pressure[cut] = 0.0
        pressure[outside] = -step * clearance[outside]
        last = math.inf if outside.any() else square
        share = 1.0 if total is None else total / pressure.sum()
        pressure *= share
        bent = deflect(pressure) if cut.any() or outside.any() else share * (bent - step * change)
        if not math.isfinite(share):
            break
    raise ArithmeticError(f"the contact condition is met to {math.sqrt(square / max(residual.size, 1)):.3g} "
                          f"m after {ITERATION_LIMIT} iterations; permitted is {allowed:.3g} m")


def _scaled(pressure, gap, deflect, total, penetration):
    """``pressure`` with the right sum, or with the scale of least energy where the
    penetration is prescribed."""
    if total is not None:
        return pressure * (total / pressure.sum())
    loaded = pressure > 0.0
    p = pressure[loaded]
    work = float(p @ (penetration - gap[loaded]))
    return pressure * (max(work, 0.0) / float(p @ deflect(pressure)[loaded]) or 1.0)


def estimate_penetration(gap, cell, contact_modulus, force):
    """Penetration [m] at which the interpenetration's volume V and area A carry ``force`` [N].

    ``N = 8 E* V / (3 sqrt(2 pi A))``, exact for a ball on a flat; right within a factor of two for other
    shapes. ``gap`` is sampled on cells of the area ``cell`` [m^2].
    """
    heights = np.sort(gap[np.isfinite(gap)])
    count = np.arange(1, len(heights) + 1)
    sums = np.cumsum(heights)
    stiffness = 8.0 / (3.0 * math.sqrt(2.0 * math.pi)) * contact_modulus * math.sqrt(cell)
    carried = stiffness * (count * heights - sums) / np.sqrt(count)
    k = max(int(np.searchsorted(carried, force)), 1) - 1
    return float((force * math.sqrt(count[k]) / stiffness + sums[k]) / count[k])
