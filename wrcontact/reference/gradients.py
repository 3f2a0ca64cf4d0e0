"""The contact on given cells, by conjugate gradients that keep the pressure positive.

Polonsky and Keer (1999), Wear 231, 206-219.
"""

import math

import numpy as np

#: Remaining residual of the contact condition, rms over the loaded cells, as a share
#: of the largest deflection.
PRECISION = 1e-7
ITERATION_LIMIT = 1000


def constrained_gradients(pressure, gap, deflect, problem, *, cell, share=1.0, weight=1.0):
    """Pressure, clearance, penetration, iterations: Polonsky and Keer (1999), section 3.

    Their steps: residual on the loaded cells, conjugate direction, exact line search, tension cut off,
    overlapping cells let in, load restored.  A penetration takes ``share`` of itself from the gap of a cell,
    and a pressure counts with ``weight`` in the force; both are 1 over a plane. (C6)

    Parameters
    ----------
    pressure : to start from, any shape [Pa].
    gap : at no penetration [m]; infinite where there is no surface.
    deflect : called with pressures [Pa]; the deflection [m].
    problem : with force or penetration, and the precision.
    cell : area of a cell [m^2].
    share, weight : arrays that broadcast against the gap.

    Raises
    ------
    ArithmeticError
        if the residual does not fall to the precision within ITERATION_LIMIT iterations.
    """
    share, weight = (np.broadcast_to(each, gap.shape) for each in (share, weight))
    total = None if problem.force is None else problem.force / cell
    pressure = _scaled(pressure, gap, deflect, total, problem.penetration, share, weight)
    bent = deflect(pressure)
    direction, last, scale = np.zeros(gap.shape), math.inf, 1.0
    for iteration in range(ITERATION_LIMIT + 1):
        loaded = pressure > 0.0
        clearance = bent + gap
        part = share[loaded]
        delta = problem.penetration if total is None else float(part @ clearance[loaded] / (part @ part))
        clearance -= delta * share
        residual = clearance[loaded]
        square = float(residual @ residual)
        allowed = problem.precision * float(bent.max())
        outside = ~loaded & (clearance < 0.0)
        if (square <= allowed**2 * residual.size and not np.any(clearance[outside] < -allowed)
                and abs(scale - 1.0) <= problem.precision):
            return pressure, clearance, delta, iteration
        direction = np.where(loaded, clearance + (square / last) * direction, 0.0)
        change = deflect(direction)
        along, answer = direction[loaded], change[loaded]
        if total is not None:
            answer = answer - part * float(part @ answer / (part @ part))
        step = float(residual @ along) / float(answer @ along)
        if not step > 0.0:      # the direction has lost its meaning: restart
            direction, last = np.zeros(gap.shape), math.inf
            continue
        pressure = pressure - step * direction
        cut = pressure < 0.0
        pressure[cut] = 0.0
        pressure[outside] = -step * clearance[outside]
        last = math.inf if outside.any() else square
        scale = 1.0 if total is None else total / float((weight * pressure).sum())
        pressure *= scale
        bent = deflect(pressure) if cut.any() or outside.any() else scale * (bent - step * change)
        if not math.isfinite(scale):
            break
    raise ArithmeticError(f"the contact condition is met to {math.sqrt(square / max(residual.size, 1)):.3g} "
                          f"m after {ITERATION_LIMIT} iterations; permitted is {allowed:.3g} m")


def _scaled(pressure, gap, deflect, total, penetration, share, weight):
    """``pressure`` with the right sum, or with the scale of least energy where the
    penetration is prescribed."""
    if total is not None:
        return pressure * (total / (weight * pressure).sum())
    loaded = pressure > 0.0
    p = pressure[loaded]
    work = float(p @ (penetration * share[loaded] - gap[loaded]))
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
