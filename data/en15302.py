"""The benchmark of EN 15302:2021 for the equivalent conicity: its cases, its reference results, and ours
(data/en15302)."""

import csv
import warnings
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

import wrcontact
from wrcontact import ContactSystem, Profile, ProfileWarning
from wrcontact.profiles import standard_profile

FOLDER = Path(__file__).with_name("en15302")
MM = 1e-3
#: Left and right wheel of each case.
WHEELS = {
    **{f"Wheel{letter}RailA": 2 * letter for letter in "ABCHI"},
    **{f"Wheel{letter}modRailA": 2 * letter for letter in "ABHI"},
    "WheelABRailA": "BA",
}
#: Nominal radius of the left wheel [m], where it is not that of the right one.
LEFT_RADIUS = {case: 0.459 for case in WHEELS if "mod" in case}
GAUGE = 1435.16 * MM  # [m] of the standard's rails


class Limits(NamedTuple):
    """Reference conicities at amplitudes (n,) [m] and their limits (n,) [1]."""

    amplitude: np.ndarray
    value: np.ndarray
    lower: np.ndarray
    upper: np.ndarray
    lower_shift: np.ndarray
    upper_shift: np.ndarray

    def inside_value(self, found):
        """Whether conicities (n,) keep the tolerance on the value."""
        return (self.lower <= found) & (found <= self.upper)

    def inside_shift(self, found):
        """Whether they keep the limits that follow from the tolerance on the lateral shift."""
        return (self.lower_shift <= found) & (found <= self.upper_shift)


def wheel_words(case):
    """The wheels of a case, of different ones the left one first."""
    left, right = WHEELS[case]
    if case in LEFT_RADIUS:
        return f"{left}, left of diameter {2e3 * LEFT_RADIUS[case]:g} mm"
    return right if left == right else f"{left} left, {right} right"


def columns(name, case):
    """Columns of numbers of a case in one of the files."""
    with open(FOLDER / name, newline="", encoding="utf-8") as file:
        rows = [row[1:] for row in csv.reader(file) if row[0] == case]
    return np.array(rows, dtype=float).T


@cache
def limits(case):
    """:class:`Limits` of a case."""
    amplitude, *others = columns("conicity.csv", case)
    return Limits(amplitude * MM, *others)


@cache
def radius_difference(case):
    """Lateral shift (n,) [m], rising, and reference rolling radius difference (n,) [m] of a case."""
    shift, difference = columns("radius_difference.csv", case) * MM
    order = np.argsort(shift)
    return shift[order], difference[order]


@cache
def profile(kind, letter):
    """The standard's wheel or rail with this letter, from its points (data/en15302), which are another source
    than the zones of the catalogue."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)  # z is upwards in the files
        # the standard's rail is inclined in its file, and is taken as it is
        given = {"file_inclination": 0.0} if kind == "rail" else {}
        return Profile.from_file(FOLDER / f"{kind}_{letter}.csv", kind, **given)


@cache
def found_curve(case):
    """Our lateral shift (n,) [m] and rolling radius difference (n,) [m], of a wheelset that does not roll."""
    system = ContactSystem(
        wheel=tuple(
            standard_profile("P8" if letter == "C" else f"EN15302-{letter}") for letter in WHEELS[case]
        ),
        rail="EN15302-rail-A",
        rail_inclination=0.0,
        gauge=GAUGE,
        nominal_radius=(LEFT_RADIUS.get(case, 0.46), 0.46),
    )
    return wrcontact.check(system).conicity_curves["level"]


@cache
def found_conicity(case):
    """Our conicities (n,) at the amplitudes of the reference."""
    return wrcontact.conditioning.equivalent_conicity(*found_curve(case), limits(case).amplitude)


def distances(points, curve):
    """Distances (n,) of points (2, n) from a curve (2, m) of straight pieces."""
    first, last = np.transpose(curve)[:-1], np.transpose(curve)[1:]
    along = last - first
    length = np.maximum((along**2).sum(axis=1), np.finfo(float).tiny)
    found = []
    for point in np.transpose(points):
        share = np.clip(((point - first) * along).sum(axis=1) / length, 0.0, 1.0)
        found.append(np.hypot(*(first + share[:, None] * along - point).T).min())
    return np.array(found)
