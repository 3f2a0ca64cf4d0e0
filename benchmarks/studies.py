"""Studies of single pages: equivalent conicity of standard profiles, also with measurement noise, and the
benchmark of EN 15302 (docs/guides/check.md); the effect of noise on ANALYN's contacts after smoothing
(docs/guides/profiles.md), of profiles that data/noisy_profiles.py makes; and the source's searches side by
side (docs/evidence/source_study.md): error, steps and cost over a set of poses, and where they fail.

    python -m benchmarks source_searches

Errors of the searches are against the exact search (kernel/search/smallest_gap.py), which a brute-force
search confirms.
"""

import math
import tempfile
import timeit
import warnings
from collections import Counter, namedtuple
from functools import partial
from pathlib import Path

import numpy as np

import wrcontact
from data import en15302
from data.noisy_profiles import NAMES, SEEDS, case, noisy_points
from wrcontact import ContactSystem, ProfileWarning
from wrcontact.conventions import MILLIMETRE as MM
from wrcontact.conventions import SIDES
from wrcontact.progress import tracked
from wrcontact.study import AdaptiveSearch, ConstraintSearch, DenserSearch, Search2D, Search3D, exact_result
from wrcontact.study.search import jump_to_flange, lever_share, longitudinal_limit

from .record import clock, cost, unit

#: Rows of the table: rail, its inclination, and the curve of the check.
PAIRS = {
    "60E1 1:40, without roll": ("60E1", "level"),
    "60E1 1:40, with roll": ("60E1", "rolled"),
    "UIC60 1:40, without roll": ("UIC60", "level"),
}
NOISE = 0.01  # [mm] in y and z
SPACING = 0.2  # [mm]
SEED = 0
NOISY = {
    "UIC60 1:40, without roll, with noise, smoothed": None,
    "UIC60 1:40, without roll, with noise, not smoothed": 0.0,
}
#: Spacing [mm], noise [mm], and whether y has noise too.
NOISE_CASES = [(spacing, noise, True) for noise in (1e-3, 1e-2, 5e-2) for spacing in (0.1, 0.2, 0.5)] + [
    (0.2, noise, False) for noise in (1e-3, 1e-2, 5e-2)
]
RAW_NOISE = (1e-3, 1e-2)  # [mm] noise in z that is not smoothed

# --------------------------------------------------------------------------------------------------- conicity


def conicities():
    """Conicities at 1 ... 8 mm of S1002 on each of PAIRS; nominal radius 460 mm, gauge 1435 mm."""
    reports = {rail: wrcontact.check(ContactSystem(rail=rail)) for rail in ("60E1", "UIC60")}
    return {
        name: {"conicity": getattr(reports[rail].conicity, curve)} for name, (rail, curve) in PAIRS.items()
    }


def noisy_conicities():
    """The same of NOISY: both profiles from points every SPACING with NOISE."""
    found = {}
    for name, smoothing in NOISY.items():
        report = wrcontact.check(ContactSystem(**noisy_profiles(smoothing)))
        found[name] = {"conicity": report.conicity.level}
    return found


def noisy_profiles(smoothing):
    """Wheel and rail from points with noise, read as files are."""
    profiles = {}
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        for kind in NAMES:
            path = Path(folder, f"{kind}.txt")
            np.savetxt(path, np.transpose(noisy_points(kind, SPACING, NOISE, SEED)), fmt="%.9f")
            profiles[kind] = wrcontact.Profile.from_file(path, kind, smoothing)
    return profiles


def en15302_rows():
    """Rows by case of EN 15302: amplitudes, how many of them keep the tolerance on the value and either
    tolerance, deviation of the conicity, and distance of the curves [mm]."""
    rows = {}
    for name in en15302.WHEELS:
        limits, found = en15302.limits(name), en15302.found_conicity(name)
        off = np.abs(found - limits.value)
        curve = 1e3 * en15302.distances(en15302.radius_difference(name), en15302.found_curve(name))
        value, shift = limits.inside_value(found), limits.inside_shift(found)
        rows[name] = {
            "wheel": en15302.wheel_words(name),
            "amplitudes": len(found),
            "value": int(value.sum()),
            "either": int((value | shift).sum()),
            "mean": off.mean(),
            "worst": off.max(),
            "curve mean": curve.mean(),
            "curve worst": curve.max(),
        }
    return rows


# ------------------------------------------------------------------------------------------------------ noise


def noise_study(quick=False):
    """Rows by case: position [mm], area and pressure [%], median and 90 % of each, and poses that are not
    valid; without smoothing the pressure's median [%] alone."""
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        seeds = range(1 if quick else SEEDS)
        for spacing, noise, both in tracked(NOISE_CASES[:1] if quick else NOISE_CASES, "noisy profiles"):
            off, bad = case(spacing, noise, both, folder, seeds)
            position, area, pressure = np.nanquantile(off, [0.5, 0.9], axis=1).T
            rows[f"{1e3 * noise:g}, {'y, z' if both else 'z'}, {spacing:g}"] = {
                "position": position,
                "area": 100 * area,
                "pressure": 100 * pressure,
                "not valid": bad,
            }
        for noise in RAW_NOISE:
            off, _ = case(0.2, noise, False, folder, seeds, smoothing=0.0)
            rows[f"{1e3 * noise:g}, z, 0.2, not smoothed"] = {"pressure": 100 * np.nanmedian(off[2])}
    return rows


# ------------------------------------------------------------------------------------- the source's searches


#: [mm] and [deg]: tread, both sides of every jump, flange root, flange.
SHIFTS = (0, 1, 2, 3, 4, 4.7, 4.9, 5, 5.5, 6, 6.1, 6.2, 6.3, 6.5, 7, 8)
YAWS = (0, 1, 2, 3)
QUICK_SHIFTS, QUICK_YAWS = (1, 5, 6.2, 6.5), (0, 2)

#: A contact further than this from the exact one, on the wheel profile [m], is in another minimum.
ELSEWHERE = 1e-3
GAINS = (0.5, 0.8, 1.0, 1.2, 1.5, 1.9, 2.0, 3.0)
GAIN_SHIFTS, LIMIT_SHIFTS = (3, 6, 6.3, 6.5, 8), (1, 3, 5, 6, 6.2, 6.5, 8)  # [mm]

#: A method at one pose; errors of roll [rad], y_wheel and x_wheel [m], of the worse side.
Trial = namedtuple("Trial", "shift yaw roll y x result units seconds")
#: A method over poses with or without yaw: medians and largest values of the poses that did not fail,
#: and the failed trials.
Row = namedtuple(
    "Row", "method yawed poses failed roll roll_worst y y_worst x x_worst steps evaluations units seconds"
)


class FromPlane:
    """The equations with the 2-D search for a start."""

    def __init__(self, system):
        self.plane, self.equations = Search2D(system), ConstraintSearch(system)

    def solve(self, lateral_shift, yaw):
        first = self.plane.solve(lateral_shift)
        return self.equations.solve(
            lateral_shift, yaw, start=(first.roll, first.left.y_wheel, first.right.y_wheel)
        )


class FromLevel:
    """The equations with a level wheelset on its running circles for a start."""

    def __init__(self, system):
        self.equations = ConstraintSearch(system)

    def solve(self, lateral_shift, yaw):
        return self.equations.solve(lateral_shift, yaw, start=(0.0, 0.0, 0.0))


def methods(system, quick=False):
    """Name, search (with ``solve(lateral_shift, yaw)``), and whether with yaw, of all that is compared."""
    both, none, yawed = (False, True), (False,), (True,)
    yield "2-D, dy 0.1 mm", Search2D(system), both
    yield "3-D, dx 0.1 mm", Search3D(system), yawed
    yield "3-D, dx 0.1 mm, 201 profiles", Search3D(system, profiles=201), yawed
    yield "3-D, dx 0.1 mm, eq. (5.12) as printed", Search3D(system, as_printed=True), yawed
    yield "adaptive dx, 2 to 0.01 mm", AdaptiveSearch(system), both
    yield "denser nodes, dx and dy to 0.01 mm", DenserSearch(system), both
    yield "equations, from the 2-D search", FromPlane(system), both
    if quick:
        return
    yield "equations, from a level wheelset", FromLevel(system), both
    yield "2-D, dy 0.01 mm", Search2D(system, spacing=1e-5), none
    yield "2-D, dy 1 mm", Search2D(system, spacing=1e-3), none
    yield "3-D, dx 0.01 mm", Search3D(system, dx=1e-5), yawed
    yield "3-D, dx 0.01 mm, 201 profiles", Search3D(system, dx=1e-5, profiles=201), yawed
    yield "3-D, dx 0.05 mm", Search3D(system, dx=5e-5), yawed
    yield "3-D, dx 1 mm", Search3D(system, dx=1e-3), yawed
    yield "3-D, dx 10 mm", Search3D(system, dx=1e-2), yawed
    yield "3-D, dx 1 mm, 67 profiles", Search3D(system, dx=1e-3, profiles=67), yawed
    yield "3-D, dx 0.1 mm, dy 0.01 mm", Search3D(system, spacing=1e-5), yawed
    yield "3-D, dx 0.1 mm, dy 1 mm", Search3D(system, spacing=1e-3), yawed


def trials(system, search, poses, timed=2):
    """A :class:`Trial` of ``search`` at each of ``poses``, (shift [m], yaw [rad]); the time is the
    smallest of ``timed``."""
    one = unit()
    for shift, yaw in poses:
        exact = exact_result(system, shift, yaw)
        found = search.solve(shift, yaw)
        seconds = (
            min(timeit.repeat(lambda: search.solve(shift, yaw), timer=clock, number=1, repeat=timed))
            if timed
            else math.nan
        )
        y, x = (
            max(
                abs(getattr(getattr(found, side), name) - getattr(getattr(exact, side), name))
                for side in SIDES
            )
            for name in ("y_wheel", "x_wheel")
        )
        yield Trial(shift, yaw, abs(found.roll - exact.roll), y, x, found, seconds / one, seconds)


def has_failed(trial):
    """Whether a trial did not converge, or did in another minimum."""
    return not (trial.result.converged and trial.y < ELSEWHERE)


def comparison(system, quick=False):
    """A :class:`Row` for each method, without yaw, with it, or both."""
    shifts, yaws = (QUICK_SHIFTS, QUICK_YAWS) if quick else (SHIFTS, YAWS)
    rows = []
    for name, search, groups in tracked(list(methods(system, quick)), "searches"):
        for yawed in groups:
            poses = [
                (shift * MM, math.radians(yaw)) for yaw in yaws for shift in shifts if (yaw != 0) == yawed
            ]
            rows.append(summary(name, yawed, list(trials(system, search, poses))))
    return rows


def summary(name, yawed, done):
    """The :class:`Row` of ``done``, a list of trials."""
    good = [trial for trial in done if not has_failed(trial)]

    def middle(values):
        values = list(values)
        return float(np.median(values)) if values else math.nan

    def worst(values):
        return max(values, default=math.nan)

    errors = [
        of(getattr(trial, name) for trial in good) for name in ("roll", "y", "x") for of in (middle, worst)
    ]
    return Row(
        name,
        yawed,
        len(done),
        [trial for trial in done if has_failed(trial)],
        *errors,
        middle(trial.result.steps for trial in done),
        middle(trial.result.gap_evaluations for trial in done),
        middle(trial.units for trial in done),
        middle(trial.seconds for trial in done),
    )


def tables(quick=False):
    """Header and rows of cells by the table's name."""
    system = ContactSystem()
    rows = comparison(system, quick)
    return {
        "searches": error_table(rows),
        "failures": failure_table(rows),
        "gains": gain_table(system),
        "limits": limit_table(system),
        "flange": jump_table(system),
        "cost": cost_table(system),
    }


def error_table(rows):
    """Errors: median and largest of the poses that do not fail; steps, gaps and units: median of all."""
    header = (
        "search",
        "yaw",
        "fails",
        "roll error [rad]",
        "y error [mm]",
        "x error [mm]",
        "steps",
        "gaps taken",
        "units",
    )
    return header, [
        (
            row.method,
            "1 ... 3 deg" if row.yawed else "none",
            f"{len(row.failed)} of {row.poses}",
            f"{row.roll:.1e} / {row.roll_worst:.1e}",
            f"{row.y / MM:.3f} / {row.y_worst / MM:.3f}",
            f"{row.x / MM:.3f} / {row.x_worst / MM:.3f}",
            f"{row.steps:.0f}",
            f"{row.evaluations:.1e}",
            f"{row.units:.0f}",
        )
        for row in rows
    ]


def failure_table(rows):
    """Where each search fails; the 2-D search with yaw is left out."""
    header = ("fails", "at (lateral shift [mm], yaw [deg]): how far off y_wheel [mm], roll [rad]")
    cells = []
    for row in rows:
        if row.failed and not (row.yawed and row.method.startswith("2-D")):
            elsewhere = [
                f"({trial.shift / MM:g}, {math.degrees(trial.yaw):.0f}): {trial.y / MM:.1f}, {trial.roll:.1e}"
                for trial in row.failed
                if trial.result.converged
            ]
            unsolved = Counter(trial.result.remark for trial in row.failed if not trial.result.converged)
            reasons = [f"{remark}: {count} poses" for remark, count in unsolved.items()]
            cells.append(
                (f"{row.method}, {'with' if row.yawed else 'without'} yaw", "; ".join(elsewhere + reasons))
            )
    return header, cells


def gain_table(system):
    """Steps of the 2-D search at GAIN_SHIFTS by its factor K, and the lever that it should have."""
    cells = []
    for gain in GAINS:
        search = Search2D(system, gain=gain)
        found = [search.solve(shift * MM) for shift in GAIN_SHIFTS]
        cells.append(
            (str(gain), *(str(result.steps) if result.converged else "does not converge" for result in found))
        )
    levers = [f"{lever_share(system, shift * MM):.2f}" for shift in GAIN_SHIFTS]
    return ("K", *(f"steps at {shift} mm" for shift in GAIN_SHIFTS)), [
        *cells,
        ("true lever / assumed", *levers),
    ]


def limit_table(system):
    """Where a yawed wheel touches, and where the source's search ends."""
    header = (
        "lateral shift [mm]",
        "yaw [deg]",
        "the right wheel touches at x [mm]",
        "limit of source eq. (5.8) [mm]",
    )
    search, cells = Search2D(system), []
    for shift in LIMIT_SHIFTS:
        plane = search.solve(shift * MM)
        height, slope = search.surfaces.wheel(np.array(plane.right.y_wheel))
        for yaw in YAWS[1:]:
            limit = longitudinal_limit(
                search.surfaces.radius + float(height), -float(slope), roll=plane.roll, yaw=math.radians(yaw)
            )
            x = exact_result(system, shift * MM, math.radians(yaw)).right.x_wheel
            cells.append((f"{shift:g}", str(yaw), f"{x / MM:.2f}", f"{limit / MM:.2f}"))
    return header, cells


def jump_table(system):
    """Lateral shift at which the right wheel comes to its flange."""
    header = ("yaw [deg]", "flange contact from lateral shift [mm], exact", "by the 3-D search")
    searches = partial(exact_result, system), Search3D(system).solve
    return header, [
        (
            str(yaw),
            *(
                f"{jump_to_flange(lambda shift: solve(shift, math.radians(yaw))) / MM:.3f}"
                for solve in searches
            ),
        )
        for yaw in YAWS
    ]


def cost_table(system):
    """The exact search."""
    took = cost(lambda: [exact_result(system, 6e-3, yaw) for yaw in (0.0, 0.01, 0.02)], 3, 10)
    return ("search", "units"), [
        ("the exact search from Python, alternating between yaws", f"{took.units:.0f}")
    ]
