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
    overlapping cells let in, load restored.  The residual is first turned into pressures by the half-space's
    stiffness (Vollebergt 2014, H15), which takes a third of the iterations.  A penetration takes ``share`` of
    itself from the gap of a cell, and a pressure counts with ``weight`` in the force; both are 1 over a
    plane. (H14)

    Parameters
    ----------
    pressure : to start from, any shape [Pa].
    gap : at no penetration [m]; infinite where there is no surface.
    deflect : a :class:`~wrcontact.halfspace.deflection.Deflection`.
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
    bent, before, scale = deflect(pressure), None, 1.0
    for iteration in range(ITERATION_LIMIT + 1):
        loaded = pressure > 0.0
        part = np.where(loaded, share, 0.0)
        clearance, delta = _clearance(bent + gap, loaded, part, share, problem)
        residual = np.where(loaded, clearance, 0.0)
        allowed = problem.precision * float(bent.max())
        outside = ~loaded & (clearance < 0.0)
        met = math.sqrt(_inner(residual, residual) / max(np.count_nonzero(loaded), 1))
        if (
            met <= allowed
            and not np.any(clearance[outside] < -allowed)
            and abs(scale - 1.0) <= problem.precision
        ):
            return pressure, clearance, delta, iteration
        direction, before = _direction(residual, part if total is not None else None, loaded, deflect, before)
        change = deflect(direction)
        step = _inner(residual, direction) / _inner(change, direction)
        if not step > 0.0:  # the direction has lost its meaning: restart
            before = None
            continue
        pressure = pressure - step * direction
        moved = bool(np.any(pressure < 0.0) or outside.any())
        pressure = np.maximum(pressure, 0.0)
        if outside.any():
            pressure[outside] = np.maximum(deflect.stiff(np.where(outside, -clearance, 0.0))[outside], 0.0)
            before = None
        scale = 1.0 if total is None else total / _inner(weight, pressure)
        pressure *= scale
        bent = deflect(pressure) if moved else scale * (bent - step * change)
        if not math.isfinite(scale):
            break
    raise ArithmeticError(
        f"the contact condition is met to {met:.3g} m after {ITERATION_LIMIT} iterations; "
        f"permitted is {allowed:.3g} m"
    )


def _clearance(apart, loaded, part, share, problem):
    """Clearances [m] of surfaces that are ``apart`` [m] at no penetration, and the penetration [m]: the
    prescribed one, or that which leaves no clearance to the loaded cells in the mean."""
    delta = problem.penetration
    if delta is None:
        delta = _inner(part[loaded], apart[loaded]) / _inner(part, part)
    return apart - delta * share, delta


def _direction(residual, part, loaded, deflect, before):
    """The next direction of pressures, and what the one after it needs: (residual, its product with the stiff
    one, direction).  ``part`` are the shares of the loaded cells, on which a direction adds up to nothing;
    None where the penetration is prescribed."""
    stiff = np.where(loaded, deflect.stiff(residual), 0.0)
    if part is not None:
        even = np.where(loaded, deflect.stiff(part), 0.0)
        stiff = stiff - even * (_inner(part, stiff) / _inner(part, even))
    product = _inner(residual, stiff)
    direction = stiff
    if before is not None:
        last, last_product, last_direction = before
        # Polak and Ribiere's, since the loaded cells change
        turn = max((product - _inner(last, stiff)) / last_product, 0.0)
        direction = np.where(loaded, stiff + turn * last_direction, 0.0)
    return direction, (residual, product, direction)


def _inner(one, other):
    return float((one * other).sum())


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
