"""Tables over a grid: what keeping them costs beside solving, and errors of values between their states."""

import tempfile
import time
from pathlib import Path

import numpy as np

import wrcontact
from wrcontact.sweeps.interpolation import METHODS, PERCENTILE
from wrcontact.sweeps.run import BLOCK

from .record import costs, unit
from .tables import decimals, figure, listed

#: Outputs of the tables.
KEPT = [
    "roll",
    "right.force.y",
    "right.area",
    "right.max_pressure",
    "right.contact.y_wheel",
    "right.contact_angle",
]
#: A grid of blocks of the default size, each of WIDTH shifts.
BLOCKS, WIDTH, THREADS = 4, BLOCK // 5000, (1, 2)
YAWS, LOADS = np.linspace(-8e-3, 8e-3, 100), np.linspace(30e3, 110e3, 50)
#: Tables of an elastic wheelset over these lateral shifts and yaws [m, rad], at one load, by their numbers.
SHIFT, YAW = 7e-3, 8e-3
SIZES = ((71, 17), (141, 17), (281, 33), (561, 65))
#: Outputs whose errors are shown, with the factor to the unit that is shown.
SHOWN = {
    "roll [µrad]": ("roll", 1e6),
    "F_y [N]": ("right.force.y", 1.0),
    "contact on the wheel [mm]": ("right.contact.y_wheel", 1e3),
    "area [mm²]": ("right.area", 1e6),
    "largest pressure [MPa]": ("right.max_pressure", 1e-6),
}
#: Random poses at which a table is compared with direct evaluation.
POSES = 20_000
#: Calls with one state each that are timed.
ALONE = 200


def sweep_times(effort):
    """Rows by number of threads: microseconds of a state in a store, and by evaluate_many block by block; of
    processors, in turn, the smallest of several rounds."""
    count = BLOCKS if effort.passes > 1 else 1
    axes = {"lateral_shift": np.linspace(-SHIFT, SHIFT, WIDTH * count), "yaw": YAWS, "normal_force": LOADS}
    system, best = wrcontact.ContactSystem(), {}
    with tempfile.TemporaryDirectory() as folder:
        for turn in range(effort.rounds):
            unit()
            for threads in THREADS:
                asked = {"store": Path(folder, f"{turn}_{threads}.zarr"), "workers": threads}
                kept = spent(lambda: wrcontact.sweep(system, axes, KEPT, progress=False, **asked))
                alone = spent(lambda: in_blocks(system, axes, threads))
                found = kept / (count * BLOCK), alone / (count * BLOCK)
                best[threads] = np.fmin(found, best.get(threads, found))
    return {
        str(threads): {"kept": 1e6 * kept, "alone": 1e6 * alone, "rate": alone / kept}
        for threads, (kept, alone) in best.items()
    }


def in_blocks(system, axes, threads):
    """The same states by evaluate_many, as many at once as a block has."""
    for some in axes["lateral_shift"].reshape(-1, WIDTH):
        grid = np.meshgrid(some, *[*axes.values()][1:], indexing="ij")
        system.evaluate_many(outputs=KEPT, threads=threads, **dict(zip(axes, (one.ravel() for one in grid))))


def spent(work):
    """Seconds of all this process's threads."""
    began = time.process_time()
    work()
    return time.process_time() - began


def value_times(effort):
    """:class:`~benchmarks.record.Cost` by name of a state: by direct evaluation, and from a table."""
    system, elastic = (wrcontact.ContactSystem(contact_mode=mode) for mode in ("rigid", "elastic"))
    shifts, yaws = SIZES[2]
    table = wrcontact.sweep(
        elastic,
        {"lateral_shift": np.linspace(-SHIFT, SHIFT, shifts), "yaw": np.linspace(-YAW, YAW, yaws)},
        KEPT,
        progress=False,
    )
    linear, cubic = (wrcontact.interpolate(table, method=method) for method in METHODS)
    many, some = random_poses(effort.count), random_poses(ALONE)
    return costs(
        {
            "direct, rigid": (lambda: system.evaluate_many(outputs=KEPT, threads=1, **many), effort.count),
            "direct, elastic": (lambda: elastic.evaluate_many(outputs=KEPT, threads=1, **many), effort.count),
            f"table {shifts} × {yaws}, linear": (lambda: linear(**many), effort.count),
            f"table {shifts} × {yaws}, cubic": (lambda: cubic(**many), effort.count),
            "direct, elastic, one state in a call": (lambda: one_by_one(elastic.evaluate, some), ALONE),
            f"table {shifts} × {yaws}, linear, one state in a call": (
                lambda: one_by_one(linear, some),
                ALONE,
            ),
        },
        effort,
    )


def one_by_one(call, poses):
    """A call for each of the ``poses``."""
    for values in zip(*poses.values()):
        call(**dict(zip(poses, values)))


def random_poses(count):
    """Inputs (count,) by name, within the tables."""
    rng = np.random.default_rng(0)
    return {"lateral_shift": rng.uniform(-SHIFT, SHIFT, count), "yaw": rng.uniform(-YAW, YAW, count)}


def table_errors(quick=False):
    """Rows by table and method: the errors of SHOWN that 95 of 100 random poses do not exceed, and the
    worst."""
    system = wrcontact.ContactSystem(contact_mode="elastic")
    poses, rows = random_poses(1000 if quick else POSES), {}
    direct = system.evaluate_many(outputs=KEPT, **poses)  # once for all tables
    for shifts, yaws in SIZES[:1] if quick else SIZES:
        axes = {"lateral_shift": np.linspace(-SHIFT, SHIFT, shifts), "yaw": np.linspace(-YAW, YAW, yaws)}
        table = wrcontact.sweep(system, axes, KEPT, progress=False)
        for method in METHODS:
            found = wrcontact.interpolate(table, method=method)(**poses)
            rows[f"{shifts} × {yaws} {method}"] = {
                words: most_and_worst(factor * np.abs(found[name] - direct[name]))
                for words, (name, factor) in SHOWN.items()
            }
    return rows


def most_and_worst(errors):
    """The error that 95 of 100 do not exceed, and the largest; poses without a result have no part in it."""
    errors = errors[np.isfinite(errors)]
    return [float(np.percentile(errors, PERCENTILE)), float(errors.max())]


def pair(values):
    """Two numbers as "0.12 / 3.4", with two digits or all before the point."""
    return " / ".join(f"{value:,.0f}" if value >= 99.5 else f"{value:.2g}" for value in values)


rate_table = listed(
    "sweep",
    ["threads", "µs a state in a store", "µs by `evaluate_many`", "rate"],
    {"kept": figure, "alone": figure, "rate": decimals(2)},
)
value_table = listed(
    "value_times", ["six outputs of a state", "units", "µs"], {"units": figure, "µs": figure}
)
error_table = listed("table_errors", ["table, 95 % / worst", *SHOWN], dict.fromkeys(SHOWN, pair))
