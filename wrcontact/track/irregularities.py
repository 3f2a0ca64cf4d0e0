"""Irregularities of a track over its distance: generated, or measured."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike, fspath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..methods.numbers import is_plain
from ..storage.atomic import open_atomically
from .spectra import QUANTITIES, Spectrum, spectrum

#: Unit by name, in m.
UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "km": 1e3}
#: Beyond this an irregularity has lost its unit [m]; a gauge beyond WIDE is one itself, not its deviation.
LARGEST, WIDE = 0.15, 0.5
#: A step longer than this times the usual one is a gap, and a step within EVEN of it is the same.
GAP, EVEN = 1.5, 1e-3
#: A heading: a name, and its unit in brackets.
HEADING = re.compile(r"^\s*([\w ]+?)\s*(?:[\[(]\s*(\w+)\s*[\])])?\s*$")


@dataclass(frozen=True)
class Irregularities:
    """Deviations of a track from where it should be, on even steps.

    Attributes
    ----------
    distance : along the track (n,) [m].
    lateral : of the middle of the track, to the right (n,) [m].
    vertical : of the middle, down.
    cross_level : how much lower the right rail is than the left one.
    gauge : how much wider the gauge is than the nominal one.
    """

    distance: NDArray[np.float64]
    lateral: NDArray[np.float64]
    vertical: NDArray[np.float64]
    cross_level: NDArray[np.float64]
    gauge: NDArray[np.float64]

    @cached_property
    def _rails(self):
        """A spline through the displacements (n, 4) of the rails: left and right lateral, left and right vertical."""
        from scipy.interpolate import CubicSpline

        sides = [
            self.lateral - 0.5 * self.gauge,
            self.lateral + 0.5 * self.gauge,
            self.vertical - 0.5 * self.cross_level,
            self.vertical + 0.5 * self.cross_level,
        ]
        return CubicSpline(self.distance, np.transpose(sides), extrapolate=False)

    def inputs(self, distance: ArrayLike, moving_at: float = 0.0) -> dict[str, NDArray[Any]]:
        """Inputs of ``evaluate`` and ``evaluate_many`` at places along the track: ``left_rail_lateral``,
        ``left_rail_vertical`` and so on, by cubic splines through the points.

        Parameters
        ----------
        distance : of the wheelset [m]; any shape.
        moving_at : speed [m/s] at which the rails' velocities are added too, ``left_rail_lateral_velocity`` and so on:
            speed times slope.  These are right for contact damping and for rails that move below a wheelset at
            rest.  An irregularity moves no material, so for creepages leave it at 0
            (docs/reference/conventions.md, rails).

        Raises
        ------
        ValueError
            if a place is outside the track.
        """
        where = np.asarray(distance, dtype=float)
        first, last = self.distance[0], self.distance[-1]
        if not ((where >= first) & (where <= last)).all():
            raise ValueError(
                f"distance is {np.min(where):g} ... {np.max(where):g} m; permitted are {first:g} ... {last:g} m"
            )
        names = [f"{side}_rail_{way}" for way in ("lateral", "vertical") for side in ("left", "right")]
        found = dict(zip(names, np.moveaxis(self._rails(where), -1, 0)))
        if moving_at:
            rates = np.moveaxis(moving_at * self._rails(where, 1), -1, 0)
            found |= {f"{name}_velocity": rate for name, rate in zip(names, rates)}
        return found

    def save(self, path: str | PathLike[str]) -> None:
        """Write a CSV file that :func:`read_irregularities` reads, in mm over m."""
        with open_atomically(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["distance [m]", *(f"{name} [mm]" for name in QUANTITIES)])
            columns = [self.distance, *(1e3 * getattr(self, name) for name in QUANTITIES)]
            writer.writerows([repr(float(value)) for value in row] for row in zip(*columns))


def generate(
    name: str | Spectrum,
    length: float,
    *,
    step: float = 0.25,
    seed: int = 0,
    longest: float | None = None,
    shortest: float | None = None,
) -> Irregularities:
    """Irregularities with a spectrum: cosines with random phases, whose amplitudes are sqrt(2 S dW).

    They repeat themselves after ``length``, with dW = 2 pi / length, and each has the spectrum itself, without scatter
    (Shinozuka and Deodatis, Simulation of stochastic processes by spectral representation, 1991).  The four
    quantities have no correlation.

    Parameters
    ----------
    name : of a spectrum (:func:`spectrum`), or a :class:`Spectrum`.
    length : of the track [m].
    step : between points [m].
    seed : of the phases: the same seed has the same track.
    longest, shortest : waves [m]; None are those for which the spectrum is meant, and the track's length at most.

    Raises
    ------
    ValueError
        if a number is not permitted, or the waves do not fit the track and the step.
    """
    kind = spectrum(name)
    for word, value in (("length", length), ("step", step)):
        if not is_plain(value) or not 0.0 < value < math.inf:
            raise ValueError(f"{word} is {value!r}; permitted are numbers above 0, in m")
    most = min(kind.longest, length) if longest is None else longest
    least = kind.shortest if shortest is None else shortest
    if not 2.0 * step <= least < most <= length * (1.0 + 1e-12):
        raise ValueError(
            f"waves are {least:g} ... {most:g} m long; permitted are those of {2.0 * step:g} m, two steps, to {length:g} m, "
            "the length of the track"
        )
    count = round(length / step)
    period = count * step
    number = np.arange(count // 2 + 1)
    waves = 2.0 * np.pi * number / period
    inside = (
        (number > 0)
        & (waves >= 2.0 * np.pi / most * (1.0 - 1e-9))
        & (waves <= 2.0 * np.pi / least * (1.0 + 1e-9))
    )
    found = {}
    for place, quantity in enumerate(QUANTITIES):
        phases = np.random.default_rng([seed, place]).uniform(0.0, 2.0 * np.pi, len(waves))
        sizes = np.zeros(len(waves))
        sizes[inside] = np.sqrt(2.0 * getattr(kind, quantity)(waves[inside]) * 2.0 * np.pi / period)
        found[quantity] = np.fft.irfft(0.5 * count * sizes * np.exp(1j * phases), count)
    return Irregularities(step * np.arange(count), **found)


# --- measured -----------------------------------------------------------------------------------------------


def read_irregularities(
    path: str | PathLike[str],
    *,
    units: Mapping[str, str] | None = None,
    nominal_gauge: float = 1.435,
    longest_gap: float = 0.0,
) -> Irregularities:
    """Measured irregularities from a CSV file with a line of headings and five columns: ``distance``, ``lateral``,
    ``vertical``, ``cross_level``, ``gauge``, each with its unit in brackets, ``gauge [mm]``.

    Directions are those of :class:`Irregularities`.  A gauge itself, 1437 mm, becomes its deviation.  Points that are not
    on even steps are put there along straight lines.

    Parameters
    ----------
    units : unit of each column whose heading has none: "m", "cm", "mm" or "km".
    nominal_gauge : [m].
    longest_gap : gaps up to this length are filled along straight lines [m].

    Raises
    ------
    ValueError
        if a column or a unit is missing, a number is none or has lost its unit, the distance does not rise, or there is
        a longer gap.
    """
    rows, headings = _rows(path)
    found = {}
    for name in ("distance", *QUANTITIES):
        if name not in headings:
            raise ValueError(
                f"{fspath(path)} has no column {name!r}; it has {', '.join(headings)}, and needs distance, "
                f"{', '.join(QUANTITIES)}"
            )
        place, unit = headings[name]
        unit = unit or (units or {}).get(name)
        if unit not in UNITS:
            raise ValueError(
                f"the column {name!r} of {fspath(path)} has the unit {unit!r}; permitted are {', '.join(UNITS)}, in brackets "
                "behind its name or in units"
            )
        found[name] = UNITS[unit] * rows[:, place]
    if np.median(abs(found["gauge"])) > WIDE:
        found["gauge"] = found["gauge"] - nominal_gauge
    for name in QUANTITIES:
        worst = int(np.argmax(abs(found[name])))
        if abs(found[name][worst]) > LARGEST:
            raise ValueError(
                f"{name} of {fspath(path)} is {found[name][worst]:g} m at {found['distance'][worst]:g} m; permitted are "
                f"{LARGEST:g} m: is its unit right?"
            )
    return _on_even_steps(found, fspath(path), longest_gap)


def _rows(path):
    """Numbers (n, columns) and {name: (place, unit or None)}."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        lines = [line for line in csv.reader(file) if line and not line[0].lstrip().startswith("#")]
    if len(lines) < 4:
        raise ValueError(
            f"{fspath(path)} has {len(lines)} lines; permitted are a heading and three points at least"
        )
    headings = {}
    for place, text in enumerate(lines[0]):
        match = HEADING.match(text)
        if match:
            headings[match[1].strip().lower().replace(" ", "_")] = place, match[2]
    try:
        rows = np.array([[float(value) for value in line] for line in lines[1:]])
    except ValueError as wrong:
        raise ValueError(f"{fspath(path)} has a value that is no number, or a short line: {wrong}") from None
    if not np.isfinite(rows).all():
        raise ValueError(
            f"{fspath(path)} has a value that is not finite in point {np.argwhere(~np.isfinite(rows))[0][0] + 1}"
        )
    return rows, headings


def _on_even_steps(found, path, longest_gap):
    """:class:`Irregularities` on even steps of the usual length."""
    distance = found.pop("distance")
    steps = np.diff(distance)
    if not (steps > 0.0).all():
        worst = int(np.argmax(steps <= 0.0))
        raise ValueError(
            f"the distance of {path} does not rise at {distance[worst]:g} m; permitted are rising numbers"
        )
    usual = float(np.median(steps))
    wide = int(np.argmax(steps))
    if steps[wide] > max(GAP * usual, longest_gap):
        raise ValueError(
            f"{path} has a gap of {steps[wide]:g} m at {distance[wide]:g} m, where steps are {usual:g} m; permitted are "
            f"{max(GAP * usual, longest_gap):g} m, or more with longest_gap"
        )
    if (abs(steps - usual) <= EVEN * usual).all():
        return Irregularities(distance, **found)
    even = distance[0] + usual * np.arange(int((distance[-1] - distance[0]) / usual + 1e-9) + 1)
    return Irregularities(even, **{name: np.interp(even, distance, values) for name, values in found.items()})
