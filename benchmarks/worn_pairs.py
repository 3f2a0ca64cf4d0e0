"""Worn and measured wheels and rails: all models compared with the complete theory, wheel by wheel.

    wheels: three designs and three measured ones (data/foreign, data/measured); rails: four and three
    |lateral shift| <= 7 mm, 20 ... 160 kN (log-uniform), up to 1.7 deg of yaw in two poses of five

A quarter of the poses each has both profiles new, the wheel worn, the rail worn, and both.  Pose i is the same
whatever their number.  Of the first poses one wheel rolls, with random yaw, lateral velocity and rotation of
the wheels, so that creep forces are between a few per cent and all of what friction permits.  The answers of
the half-space are kept in data/worn_pairs.csv and data/worn_rolling.csv.

    python -m benchmarks.worn_pairs       adds what is missing there
"""

import math
import warnings
from functools import cache
from typing import NamedTuple

import numpy as np

import data
import wrcontact
from wrcontact.profiles.catalogue import find_profile
from wrcontact.progress import tracked

SEED = 1895
FOREIGN, MEASURED = data.FOLDER / "foreign", data.FOLDER / "measured"
NEW_WHEELS = ("S1002", "P8", "1-40/h28/e32.5/6.7%")
WORN_WHEELS = (FOREIGN / "avg_wheel_points.whl", FOREIGN / "Car7216_0001r.whl", MEASURED / "worn.whl")
#: With their inclination; a measured rail stands inclined in its file.
NEW_RAILS = (("UIC60", 1 / 40), ("60E1", 1 / 20), ("54E1", 1 / 20), ("56E1", 1 / 20))
WORN_RAILS = (
    (FOREIGN / "avg_HR_points.ban", 0.0),
    (MEASURED / "worn.ban", 0.0),
    (FOREIGN / "r300_wide.prr", 1 / 40),
)
KINDS = ("new", "worn wheel", "worn rail", "both worn")
SHIFT, YAW = 7e-3, 0.03  # [m, rad] largest
YAWED = 0.4  # share of the poses with yaw
FORCE = 20e3, 160e3  # [N]
SPEED, FRICTION = 20.0, 0.3  # [m/s], [-]
#: Of rolling wheels, largest yaw [rad], lateral velocity over speed [-] and change of the rotation [-].
ROLLING_YAW, DRIFT, SLIP = 8e-3, 2e-3, 3e-3
TOLERANCE = 0.01  # of the half-space
SIDES, PATCH = ("left", "right"), ("penetration", "area", "max_pressure")
NORMAL = ("hertz", "analyn", "auto", "analyn_strip")
CREEP = ("polach", "fastsim", "fastrip", "strips")
#: Models of normal contact for creep forces.
UNDER = ("analyn", "analyn_strip")
STORED, ROLLING = data.FOLDER / "worn_pairs.csv", data.FOLDER / "worn_rolling.csv"
COUNT, ROLLING_COUNT = 300, 80  # poses that are stored
#: Classes of the estimate model_error.
CLASSES = (0.0, 0.01, 0.02, 0.04, 1.0)


class Pose(NamedTuple):
    """A wheelset on its track, and how it rolls; SI units."""

    kind: int
    wheel: object
    rail: object
    inclination: float
    lateral_shift: float
    yaw: float
    normal_force: float
    right: bool  # the wheel that rolls
    rolling_yaw: float
    lateral_velocity: float
    wheel_rate: float


def pose(index):
    """Pose ``index`` of an endless list."""
    random = np.random.default_rng((SEED, index))
    kind = index % 4
    wheels, rails = (WORN_WHEELS if kind in (1, 3) else NEW_WHEELS), (WORN_RAILS if kind > 1 else NEW_RAILS)
    wheel = wheels[random.integers(len(wheels))]
    rail, inclination = rails[random.integers(len(rails))]
    shift, yaw, force, yawed, side, turn, drift, slip = random.uniform(
        (-SHIFT, -YAW, math.log(FORCE[0]), 0.0, 0.0, -1.0, -1.0, -1.0),
        (SHIFT, YAW, math.log(FORCE[1]), 1.0, 1.0, 1.0, 1.0, 1.0),
    ).tolist()
    return Pose(
        kind,
        wheel,
        rail,
        inclination,
        shift,
        yaw if yawed < YAWED else 0.0,
        math.exp(force),
        side < 0.5,
        ROLLING_YAW * turn**3,
        SPEED * DRIFT * drift**3,
        SPEED / 0.46 * (1.0 + SLIP * slip**3),
    )


#: A profile as a system reads it, once for all models.
profile = cache(lambda source, kind, track: find_profile(source, kind, track=track))


@cache
def system(wheel, rail, inclination, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what the readers remark on measured files
        profiles = profile(wheel, "wheel", inclination), profile(rail, "rail", inclination)
        return wrcontact.ContactSystem(*profiles, rail_inclination=inclination, **options)


def standing(where, **options):
    """The wheelset at a pose."""
    model = system(where.wheel, where.rail, where.inclination, **options)
    return model.evaluate(where.lateral_shift, where.yaw, where.normal_force)


def rolling(where, tangential_model, **options):
    """Creep force (x, y, z) [N] and load [N] of the wheel that rolls; NaN where nothing is found."""
    model = system(where.wheel, where.rail, where.inclination, tangential_model=tangential_model, **options)
    state = model.evaluate(
        where.lateral_shift,
        where.rolling_yaw,
        where.normal_force,
        speed=SPEED,
        lateral_velocity=where.lateral_velocity,
        wheel_rate=where.wheel_rate,
        left_friction=FRICTION,
        right_friction=FRICTION,
        side="right" if where.right else "left",
    )
    if state.status != 0:
        return [math.nan] * 4
    side = state.right if where.right else state.left
    return [*(np.array(side.force) - np.array(side.normal.force)), side.normal_force]


# -------------------------------------------------------------------------------------------- complete theory


def half_space(index):
    """Penetration, area and peak pressure of both wheels; NaN without convergence."""
    state = standing(pose(index), normal_model="halfspace", tolerance=TOLERANCE)
    if state.status != 0:
        return [math.nan] * 6
    return [getattr(getattr(state, side), name) for side in SIDES for name in PATCH]


def half_space_rolling(index):
    """Creep force and load of the wheel that rolls; NaN without convergence."""
    return rolling(pose(index), "halfspace", normal_model="halfspace", tolerance=TOLERANCE)


def references(count, store, solve):
    """Results (count, n) of the first ``count`` poses; those missing from the file are solved and added."""
    known = {}
    if store.exists():
        known = {int(row[0]): row[1:] for row in np.loadtxt(store, delimiter=",", ndmin=2)}
    missing = [index for index in range(count) if index not in known]
    if missing:
        with open(store, "a", encoding="utf-8") as file:
            for index in tracked(missing, f"half-space, {store.name}"):
                try:
                    found = solve(index)
                except ArithmeticError:
                    found = [math.nan] * (6 if solve is half_space else 4)
                known[index] = np.array(found)
                file.write(",".join([str(index), *(f"{value:.7g}" for value in found)]) + "\n")
                file.flush()
    return np.array([known[index] for index in range(count)])


# ----------------------------------------------------------------------------------------------------- models


def spread(errors):
    """Mean, 95 % and largest of errors (n, ...)."""
    return [np.mean(errors, axis=0), np.percentile(errors, 95, axis=0), np.max(errors, axis=0)]


def normal_errors(count=COUNT):
    """Rows by kind and model: [mean, 95 %, worst] (3, 3) of the errors [%]; wheels; and of auto the share of
    wheels with strips, and the mean error of ANALYN by class of its estimate."""
    truth = references(count, STORED, half_space)
    found = {name: np.full((count, 2, 3), np.nan) for name in NORMAL}
    estimate = np.full((count, 2), np.nan)
    for index in range(count):
        where = pose(index)
        for name in NORMAL:
            options = {"error_outputs": True} if name == "analyn" else {}
            state = standing(where, normal_model=name, **options)
            if state.status == 0:
                wheels = [getattr(state, side) for side in SIDES]
                found[name][index] = [[getattr(wheel, part) for part in PATCH] for wheel in wheels]
                if name == "analyn":
                    estimate[index] = [wheel.model_error for wheel in wheels]
    kinds = np.arange(count) % 4
    errors = {name: 100 * np.abs(values / truth.reshape(-1, 2, 3) - 1) for name, values in found.items()}
    solved = np.all([np.isfinite(each).all(axis=(1, 2)) for each in errors.values()], axis=0)
    rows = {}
    for kind, label in enumerate(KINDS):
        here = solved & (kinds == kind)
        rows[label] = {"wheels": 2 * int(here.sum()), "strips": float(np.mean(estimate[here] > 0.04))}
        rows[label] |= {name: spread(each[here].reshape(-1, 3)) for name, each in errors.items()}
    own, peak = estimate[solved].ravel(), errors["analyn"][solved][..., 2].ravel()
    rows["estimate"] = {}
    for low, high in zip(CLASSES[:-1], CLASSES[1:]):
        here = (own >= low) & (own < high)
        rows["estimate"][f"{100 * low:g} … {100 * high:g} %" if high < 1 else f"above {100 * low:g} %"] = {
            "wheels": int(here.sum()),
            "estimate": 100 * float(own[here].mean()),
            "error": spread(peak[here]),
        }
    return rows


def creep_errors(count=ROLLING_COUNT):
    """Rows by model of normal contact and of creep forces: [mean, 95 %, worst] of |dF| / (friction load) [%],
    the number of wheels, and the mean of the signed error of |F|."""
    truth = references(count, ROLLING, half_space_rolling)
    bound = FRICTION * truth[:, 3]
    rows = {}
    for under in UNDER:
        for name in CREEP:
            found = np.array([rolling(pose(index), name, normal_model=under) for index in range(count)])
            here = np.isfinite(found).all(axis=1) & np.isfinite(truth).all(axis=1)
            apart = np.linalg.norm(found[here, :3] - truth[here, :3], axis=1) / bound[here]
            signed = (
                np.linalg.norm(found[here, :3], axis=1) - np.linalg.norm(truth[here, :3], axis=1)
            ) / bound[here]
            rows[f"{name}, {under}"] = {
                "wheels": int(here.sum()),
                "force": spread(100 * apart),
                "signed": 100 * float(signed.mean()),
            }
    return rows


def worn_pairs(effort=None):
    """Rows of both tables, from the stored poses; of a quick run from few."""
    quick = effort is not None and effort.passes == 1
    return {
        "normal": normal_errors(40 if quick else COUNT),
        "creep": creep_errors(12 if quick else ROLLING_COUNT),
    }


def main():
    references(COUNT, STORED, half_space)
    references(ROLLING_COUNT, ROLLING, half_space_rolling)


if __name__ == "__main__":
    main()
