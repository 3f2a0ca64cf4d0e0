"""The benchmark of EN 15302 for the equivalent conicity: its cases, its reference results, and ours
(data/en15302)."""

import csv
import warnings
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

import wrcontact
from wrcontact import ContactSystem, Profile, ProfileWarning
from wrcontact.profiles.zones import Arc, Polynomial

FOLDER = Path(__file__).with_name("en15302")
MM = 1e-3
#: Left and right wheel of each case.
WHEELS = {"E1": "AA", "E2": "BB", "E3": "HH", "E4": "II", "E5": "AA", "E7": "HH", "E9": "BA"}
#: Nominal radius of the left wheel [m], where it is not that of the right one.
LEFT_RADIUS = {"E5": 0.459, "E7": 0.459}
GAUGE = 1435.16 * MM  # [m] of the standard's rails


class Limits(NamedTuple):
    """Reference conicities at amplitudes (n,) [m] and their limits (n,) [1]."""

    amplitude: np.ndarray
    value: np.ndarray
    upper: np.ndarray
    lower: np.ndarray
    upper_shift: np.ndarray
    lower_shift: np.ndarray

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
    """Lateral shift (n,) [m] and reference rolling radius difference (n,) [m] of a case."""
    return tuple(columns("radius_difference.csv", case) * MM)


@cache
def profile(kind, letter):
    """The standard's wheel or rail with this letter."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)  # z is upwards in the files
        # the standard's rail is inclined in its file, and is taken as it is
        given = {"file_inclination": 0.0} if kind == "rail" else {}
        return Profile.from_file(FOLDER / f"{kind}_{letter}.csv", kind, **given)


@cache
def found_curve(case):
    """Our lateral shift (n,) [m] and rolling radius difference (n,) [m], of a wheelset that does not roll."""
    wheels = tuple(profile("wheel", letter) for letter in WHEELS[case])
    system = ContactSystem(
        wheel=wheels,
        rail=profile("rail", "A"),
        rail_inclination=0.0,
        gauge=GAUGE,
        nominal_radius=(LEFT_RADIUS.get(case, 0.46), 0.46),
    )
    return wrcontact.check(system).conicity_curves["level"]


@cache
def found_conicity(case):
    """Our conicities (n,) at the amplitudes of the reference."""
    return wrcontact.conditioning.equivalent_conicity(*found_curve(case), limits(case).amplitude)


def exact_profile(name):
    """ "wheel_H" or "rail_A" from the zones of the edition of 2021."""
    with open(FOLDER / "exact_zones.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["profile"] == name]
    return Profile(name, name.split("_")[0], meeting([zone_of(row) for row in rows]), smooth=False)


def zone_of(row):
    """The zone of a row of the file."""
    row = {key: float(value) for key, value in row.items() if value and key not in ("profile", "family")}
    if "radius" in row:
        side = int(row["side"])
        return Arc(row["start"], row["stop"], row["radius"], row["y_centre"], row["z_centre"], side)
    return Polynomial(row["start"], row["stop"], (row["z"], row["slope"]), row["origin"])


def meeting(zones):
    """The zones of a wheel, each of which is moved down so that it meets the next one: printed numbers of
    flanges leave steps of up to 1.5 um, more than a profile may have."""
    kept = [zones[-1]]
    for zone in zones[-2::-1]:
        rise = float(kept[0](kept[0].start)[0] - zone(kept[0].start)[0])
        if isinstance(zone, Arc):
            kept.insert(0, replace(zone, z_centre=zone.z_centre + rise))
        else:
            first, *others = zone.coefficients
            kept.insert(0, replace(zone, coefficients=(first + rise, *others)))
    return tuple(kept)


def exact_conicity():
    """Conicities of wheel H on rail A of the edition of 2021 (33, 6): amplitude [m], value, the limits of the
    value, and those that follow from the tolerance on the lateral shift; and ours (33,)."""
    with open(FOLDER / "exact_conicity.csv", newline="", encoding="utf-8") as file:
        table = np.array([row[1:] for row in csv.reader(file)][1:], dtype=float)
    table[:, 0] *= MM
    system = ContactSystem(
        exact_profile("wheel_H"),
        exact_profile("rail_A"),
        rail_inclination=0.0,
        gauge=GAUGE,
        nominal_radius=0.46,
    )
    curve = wrcontact.check(system).conicity_curves["level"]
    return table, wrcontact.conditioning.equivalent_conicity(*curve, table[:, 0])


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
