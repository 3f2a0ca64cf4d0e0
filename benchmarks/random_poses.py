"""Random poses on random tracks: ANALYN and strips compared with the complete theory, wheel by
wheel.

    |lateral shift| <= 6.6 mm, 3 ... 200 kN (log-uniform), UIC60, 60E1 or 54E1 at 1:40 or
    1:20, up to 2 deg of yaw in half

Pose i is the same whatever their number, and the half-space's answers are kept in a file: a run that is ended
goes on where it was, a larger one only adds, and a changed model is compared anew within a second.

    python -m benchmarks.random_poses       adds what is missing in data/random_poses.csv
"""

import math
import os
from functools import cache
from math import radians
from pathlib import Path
from typing import NamedTuple

import numpy as np

import data
import wrcontact
from wrcontact.methods import Analyn, Strip
from wrcontact.progress import tracked
from wrcontact.workers import process_pool, results

SEED = 2014
RAILS, INCLINATIONS = ("UIC60", "60E1", "54E1"), (1 / 40, 1 / 20)
SHIFT, YAW = 6.6e-3, radians(2)  # [m, rad] largest
FORCE = 3e3, 200e3  # [N]
TOLERANCE = 0.01  # of the half-space
STORE = Path("out") / "random_poses.csv"  # of a run with another number
STORED = data.FOLDER / "random_poses.csv"
COUNT = 1000  # poses that are stored
SIDES, PATCH = ("left", "right"), ("penetration", "area", "max_pressure")
PERCENTILES = (50, 95, 99, 100)
WORST = 5
WAITING = 2  # poses that are handed out for each process


class Pose(NamedTuple):
    """A wheelset on one of the tracks; SI units."""

    rail: str
    inclination: float
    lateral_shift: float
    yaw: float
    normal_force: float

    def __str__(self):
        return (
            f"{self.rail} 1:{1 / self.inclination:.0f}, lateral_shift={self.lateral_shift:.9f}, "
            f"yaw={self.yaw:.9f}, "
            f"normal_force={self.normal_force:.2f}"
        )


def pose(index):
    """Pose ``index`` of an endless list."""
    random = np.random.default_rng((SEED, index))
    rail, inclination = RAILS[random.integers(len(RAILS))], INCLINATIONS[random.integers(len(INCLINATIONS))]
    shift, yaw, force = random.uniform(
        (-SHIFT, -YAW, np.log(FORCE[0])), (SHIFT, YAW, np.log(FORCE[1]))
    ).tolist()
    return Pose(rail, inclination, shift, yaw if index % 2 else 0.0, math.exp(force))


@cache
def system(rail, inclination, **options):
    return wrcontact.ContactSystem(rail=rail, rail_inclination=inclination, **options)


# -------------------------------------------------------------------------------------------- complete theory


def solve(index):
    """A line of the file: index, pose, penetration, area and peak pressure of both wheels; NaN without
    convergence."""
    where = pose(index)
    model = system(where.rail, where.inclination, normal_model="halfspace", tolerance=TOLERANCE)
    state = model.evaluate(where.lateral_shift, where.yaw, where.normal_force)
    found = [getattr(getattr(state, side), name) for side in SIDES for name in PATCH]
    return [
        *heading(index),
        *(f"{value:.7g}" for value in (found if state.status == 0 else [np.nan] * len(found))),
    ]


def heading(index):
    """The first cells of a line."""
    return [str(index), *map(str, pose(index))]


def references(count, store=STORE, processes=None):
    """Half-space results (count, 6) of the first ``count`` poses; those missing from the file are solved and
    added."""
    store.parent.mkdir(parents=True, exist_ok=True)
    known = {int(row[0]): row for row in stored(store)}
    missing = [index for index in range(count) if index not in known]
    if missing:
        store.write_text("".join(map(line, known.values())), encoding="utf-8")
        workers = processes or os.cpu_count()
        with (
            process_pool(workers) as pool,
            open(store, "a", newline="", encoding="utf-8") as file,
        ):
            tasks = {index: (index,) for index in missing}
            solved = results(pool, WAITING * workers, solve, tasks)
            for _, row in tracked(solved, "random poses with the half-space", len(missing)):
                file.write(line(row))
                file.flush()
                known[int(row[0])] = row
    return np.array([known[index][-6:] for index in range(count)], dtype=float)


def line(row):
    return ",".join(row) + "\n"


def stored(store):
    """Rows of the file, without incomplete lines of an interrupted run and without other poses."""
    lines = store.read_text(encoding="utf-8").splitlines(keepends=True) if store.exists() else []
    rows = [text.strip().split(",") for text in lines if text.endswith("\n")]
    return [row for row in rows if is_known(row)]


def is_known(row):
    """Whether a line of the file has the pose of its index; another processor's logarithm gives other last
    digits."""
    index, rail, *numbers = heading(int(row[0]))
    return row[1] == rail and all(
        math.isclose(float(a), float(b), rel_tol=1e-12) for a, b in zip(row[2:-6], numbers)
    )


# ----------------------------------------------------------------------------------------------------- models


def answers(poses, **options):
    """Results (n, 6) of a model, in the order of the half-space's, and status (n,)."""
    found, status = np.full((len(poses), 6), np.nan), np.full(len(poses), -1)
    tracks = np.array([(RAILS.index(each.rail), each.inclination) for each in poses])
    for track in np.unique(tracks, axis=0):
        here = np.flatnonzero((tracks == track).all(axis=1))
        moving = np.array([each[2:] for each in poses])[here].T
        table = system(RAILS[int(track[0])], float(track[1]), **options).evaluate_many(*moving)
        found[here] = np.column_stack(
            [getattr(getattr(table, side), name) for side in SIDES for name in PATCH]
        )
        status[here] = table.status
    return found, status


def compared(truth, models=("analyn", "analyn_strip")):
    """Rows: the number of poses, of those left out since the half-space does not converge (results ``truth``,
    (n, 6)); and by model its errors [%] by percentile, poses that it does not solve, and the worst wheels."""
    poses = [pose(index) for index in range(len(truth))]
    lost = np.isnan(truth).any(axis=1)
    rows = {"poses": {"count": len(poses), "lost": int(lost.sum())}}
    for model in models:
        found, status = answers(poses, normal_model=model)
        refused = np.isin(status, (2, 3, 4)) & ~lost
        kept = np.flatnonzero(~lost & ~refused)
        shares = 100 * np.abs(found[kept] / truth[kept] - 1).reshape(-1, 2, 3)
        rows[model] = {
            **dict(quantiles(shares.reshape(-1, 3))),
            "refused": int(refused.sum()),
            "wheels": list(worst(poses, kept, shares)),
        }
    return rows


def quantiles(wheels):
    """Yield name and values (3,) of the mean and the percentiles of errors (n, 3)."""
    yield "mean", wheels.mean(axis=0)
    for percentile in PERCENTILES:
        yield percentile_name(percentile), np.percentile(wheels, percentile, axis=0)


def percentile_name(percentile):
    return "worst" if percentile == 100 else f"{percentile} of 100"


def worst(poses, kept, shares):
    """Yield the errors (3,) of each of the wheels with the largest, and which wheel it is."""
    largest = shares.max(axis=2)
    for place in np.argsort(largest, axis=None)[::-1][:WORST]:
        row, side = np.unravel_index(place, largest.shape)
        yield {
            "errors": shares[row, side],
            "wheel": f"{SIDES[side]} wheel, pose {kept[row]}: {poses[kept[row]]}",
        }


# ------------------------------------------------------------------------------------------------- tolerances


def numerics(count):
    """Rows by model and tolerance: difference from the same model at its finest [%] by percentile, S1002 on
    UIC60 1:40."""
    poses = [pose(index)._replace(rail="UIC60", inclination=1 / 40) for index in range(count)]
    rows = {}
    for model in (Analyn, Strip):
        finest = {name: known.high for name, known in model.numbers().items() if known.whole}
        truth, _ = answers(poses, normal_model=model(**finest))
        for tolerance in model.ladder:
            found, _ = answers(poses, normal_model=model(tolerance=tolerance))
            wheels = 100 * np.abs(found / truth - 1).reshape(-1, 3)
            wheel = int(np.nanargmax(wheels.max(axis=1)))
            rows[f"{model.name}, tolerance {tolerance:g}"] = {
                **dict(quantiles(wheels[~np.isnan(wheels).any(axis=1)])),
                "count": count,
                "where": f"{SIDES[wheel % 2]}, pose {wheel // 2}",
            }
    return rows


# --------------------------------------------------------------------------------- by where the wheel touches


#: tread: one patch, contact angle up to 15 degrees; flange root: one patch, up to 45 degrees; flange: one
#: patch, more than that; two places: two patches or more.  Each wheel is sorted by ANALYN's answer.
ZONES = "tread", "flange root", "flange", "two places"
ANGLES = np.radians([15.0, 45.0])  # where the flange root and the flange begin
KINDS = "mean", "95 of 100", "worst"  # what the table shows of them


def by_zone(count=COUNT):
    """Rows by zone: the number of wheels, and by model the KINDS of their errors (3,) [%]."""
    truth = references(count, STORED).reshape(-1, 3)
    poses = [pose(index) for index in range(count)]
    zone = zones(poses)
    rows = {name: {"wheels": 0} for name in ZONES}
    for model in ("analyn", "analyn_strip"):
        found, _ = answers(poses, normal_model=model)
        errors = 100 * np.abs(found.reshape(-1, 3) / truth - 1)
        for number, name in enumerate(ZONES):
            here = errors[(zone == number) & np.isfinite(errors).all(axis=1)]
            rows[name]["wheels"] = len(here)
            if len(here):
                kinds = dict(quantiles(here))
                rows[name][model] = {kind: kinds[kind] for kind in KINDS}
    return rows


def zones(poses):
    """The number of each wheel's zone (2 n,), left and right of every pose."""
    found = np.zeros((len(poses), 2), dtype=int)
    for row, pose in enumerate(poses):
        state = system(pose.rail, pose.inclination).evaluate(*pose[2:])
        for side, wheel in enumerate((state.left, state.right)):
            angle = max((abs(patch.contact_angle) for patch in wheel.patches), default=0.0)
            found[row, side] = 3 if len(wheel.patches) > 1 else int(np.searchsorted(ANGLES, angle))
    return found.ravel()


if __name__ == "__main__":
    references(COUNT, STORED)
