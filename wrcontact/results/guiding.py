"""Guiding forces of results, and how EN 14363 filters what is measured on a track.

>>> import numpy as np, wrcontact
>>> step = 1e-3                                                 # [s] between the rows of a table
>>> time = step * np.arange(2000)
>>> table = wrcontact.ContactSystem().evaluate_many(6e-3 + 3e-4 * np.sin(10.0 * time), yaw=5e-3)
>>> forces = wrcontact.guiding_forces(table)
>>> quotient = wrcontact.low_pass(forces.right_y / forces.right_q, step)
>>> places, mean = wrcontact.sliding_mean(quotient, 20.0 * time)
>>> places[:3], bool(mean.max() > 0.5)
(array([1. , 1.5, 2. ]), True)
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..methods.numbers import is_plain


class GuidingForces(NamedTuple):
    """Forces of the wheels on their rails [N] of one pose, or (n,) of a table.

    left_y, right_y : Y, lateral, positive outwards.
    left_q, right_q : Q, positive downwards.
    sum_y : sum of Y of the wheelset, positive to the right: ``right_y - left_y``.
    """

    left_y: float
    left_q: float
    right_y: float
    right_q: float
    sum_y: float


def guiding_forces(state: Any) -> GuidingForces:
    """Y and Q of EN 14363 of a state or a table: :class:`GuidingForces`.

    They are those of ``left.force`` and ``right.force``, which act on the wheels, in the axes of the track;
    Y/Q is the output ``derailment_quotient``.
    """
    left, right = state.left.force, state.right.force
    return GuidingForces(left.y, -left.z, -right.y, -right.z, -left.y - right.y)


def low_pass(values: ArrayLike, step: float, frequency: float = 20.0) -> NDArray[Any]:
    """What is left of ``values`` (n, ...) below a ``frequency`` [Hz], where rows are ``step`` [s] apart.

    A Butterworth filter of second order runs forwards and backwards, so that nothing is delayed.  Both
    together let 1/sqrt(2) through at ``frequency`` (-3 dB) and fall by 24 dB an octave, as EN 14363 asks for:

        |H(f)| = 1 / (1 + (sqrt(2) - 1) (tan(pi f step) / tan(pi frequency step))^4)

    Raises
    ------
    ValueError
        if ``values`` are not finite, too few, or too far apart for the frequency.
    """
    from scipy import signal  # an FMU does not need it

    given = _finite("values", values)
    _positive("step", step, "s")
    _positive("frequency", frequency, "Hz")
    if frequency * step >= 0.5:
        raise ValueError(
            f"frequency is {frequency:g} Hz; permitted with a step of {step:g} s is less than "
            f"{0.5 / step:g} Hz"
        )
    # both passes have 1/sqrt(2) together, on the warped axis of the bilinear transform
    tangent = math.tan(math.pi * frequency * step) / (math.sqrt(2.0) - 1.0) ** 0.25
    sections = signal.butter(2, math.atan(tangent) / math.pi, fs=1.0, output="sos")
    # ends are mirrored over the time in which the filter forgets
    ends = min(len(given) - 1, math.ceil(3.0 / (frequency * step)))
    return signal.sosfiltfilt(sections, given, axis=0, padlen=ends)


def sliding_mean(
    values: ArrayLike, distance: ArrayLike, length: float = 2.0, step: float = 0.5
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Means of ``values`` (n, ...) over windows of ``length`` [m] along the track, as EN 14363 takes them of
    Y/Q and of the sum of Y: (places, means).

    Parameters
    ----------
    distance : of each row along the track (n,) [m], rising.  Between rows values follow straight lines.
    step : between windows [m].

    Returns
    -------
    places, means : middles of the windows (k,) [m], the first as early as the rows permit, and the means
        (k, ...).

    Raises
    ------
    ValueError
        if the rows are not finite, do not rise, or are shorter than a window.
    """
    given, along = _finite("values", values), _finite("distance", distance)
    _positive("length", length, "m")
    _positive("step", step, "m")
    if along.shape != given.shape[:1]:
        raise ValueError(
            f"distance has the shape {along.shape}; permitted with values of the shape "
            f"{given.shape} is {given.shape[:1]}"
        )
    if not (np.diff(along) > 0.0).all():
        raise ValueError("distance does not rise from row to row; permitted are rising numbers, in m")
    if along[-1] - along[0] < length * (1.0 - 1e-12):
        raise ValueError(
            f"distance covers {along[-1] - along[0]:g} m; permitted with a window of "
            f"{length:g} m is as much at least"
        )
    count = int((along[-1] - along[0] - length) / step * (1.0 + 1e-12) + 1e-9) + 1
    places = along[0] + 0.5 * length + step * np.arange(count)
    ends = [_integral(given, along, places + half) for half in (-0.5 * length, 0.5 * length)]
    return places, (ends[1] - ends[0]) / length


def _integral(values, along, stops):
    """Integrals (k, ...) of the broken lines through ``values`` (n, ...) at ``along`` (n,) up to ``stops``
    (k,)."""
    cells = np.diff(along).reshape(-1, *(1,) * (values.ndim - 1))
    sums = np.concatenate([np.zeros_like(values[:1]), np.cumsum(0.5 * cells * (values[1:] + values[:-1]), 0)])
    cell = np.clip(np.searchsorted(along, stops, side="right") - 1, 0, len(along) - 2)
    way = np.clip(stops - along[cell], 0.0, None).reshape(-1, *(1,) * (values.ndim - 1))
    slope = (values[cell + 1] - values[cell]) / cells[cell]
    return sums[cell] + way * (values[cell] + 0.5 * way * slope)


def _finite(name, values):
    """``values`` as an array of at least two rows of finite numbers."""
    try:
        found = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {values!r}; permitted are numbers") from None
    if found.ndim == 0 or len(found) < 2:
        raise ValueError(f"{name} has the shape {found.shape}; permitted are two rows at least")
    wrong = np.flatnonzero(~np.isfinite(found).reshape(len(found), -1).all(axis=1))
    if len(wrong):
        raise ValueError(
            f"{name} is not finite in row {wrong[0]}; permitted are finite numbers, as in rows with status 0"
        )
    return found


def _positive(name, value, unit):
    """Refuse what is no number above 0."""
    if not is_plain(value) or not 0.0 < value < math.inf:
        raise ValueError(f"{name} is {value!r}; permitted are numbers above 0, in {unit}")
