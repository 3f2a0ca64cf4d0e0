"""Everything that is measured, in parts: what is measured at once, kept in one file of benchmarks/measured,
and written into tables (tables.py).

    errors    quick, the same numbers in every run
    times     seconds of calls, a few minutes on a quiet machine
    studies   errors that need long computations of the half-space or of other searches
"""

import tempfile
from collections.abc import Callable
from typing import NamedTuple

from wrcontact.progress import tracked
from wrcontact.study import figures
from wrcontact.study.figure import Study

from . import (
    creep,
    errors,
    random_poses,
    realtime,
    record,
    rows,
    studies,
    sweeps,
    times,
    worn_pairs,
    worst,
)

ERRORS, TIMES, STUDIES = KINDS = "errors", "times", "studies"
COUNTED = 500  # poses of a count
STEPS = 10_000  # of which the costliest are counted
TOLERANCES = 500  # random poses on which tolerances are examined


class Part(NamedTuple):
    """``measure(effort)`` returns rows by name, each a dict of numbers, lists and words."""

    kind: str
    measure: Callable


def measured(name, effort):
    """Measure a part and return what is kept of it: rows, and conditions in words."""
    part = PARTS[name]
    record.restart()
    found = part.measure(effort)
    if part.kind != TIMES:
        return found, {}
    return found, {
        "machine": record.machine(),
        "noise": record.noise(),
        "time": "elapsed time" if name == "threads" else "processor time",
    }


def named(words):
    """Names of the parts that ``words`` mean: kinds or names; all without any.

    Raises
    ------
    ValueError
        with the known names.
    """
    if unknown := [word for word in words if word not in (*KINDS, *PARTS)]:
        raise ValueError(f"{unknown[0]!r} is not known; known are {', '.join((*KINDS, *PARTS))}")
    return [name for name, part in PARTS.items() if not words or name in words or part.kind in words]


def write(names, effort):
    """Measure parts and keep their numbers; an interrupted run keeps the parts that are done."""
    for name in tracked(names, "measurements"):
        record.save(name, *measured(name, effort))


# -------------------------------------------------------------------------------------------- model by model


def model_errors(effort):
    """Of all rows but the half-space's."""
    return {row.name: row.errors() for row in rows.all_rows(effort) if row.kind != "halfspace"}


def halfspace_errors(effort):
    found = list(rows.halfspace(effort))
    return {row.name: row.errors() for row in tracked(found, "half-space")}


def model_times(effort):
    """All rows in turn, so that a disturbance of some seconds does not slow all rounds of one."""
    with tempfile.TemporaryDirectory() as folder:
        chosen = [*rows.all_rows(effort), *rows.hosted(folder, effort)]
        later = [row for row in chosen if row.kind != "halfspace"]  # which takes minutes
        best = {}
        for row in tracked(chosen + later * (effort.passes - 1), "times of models"):
            best[row.name] = row.cost().least(best.get(row.name))
    return timed({row.name: best[row.name] for row in chosen})


def timed(costs):
    """Costs by name as they are kept."""
    return {name: cost.kept() for name, cost in costs.items()}


def skip_times(effort):
    found = list(times.all_skips(effort))
    for skip in tracked(found * effort.passes, "times of what can be skipped"):
        skip.measure(effort.rounds)
    return {
        skip.name: {"units": skip.less.units, "full": skip.more.units, "answer": skip.answer}
        for skip in found
    }


def elastic_times(effort):
    return {model: timed(modes) for model, modes in times.elastic_times(effort).items()}


def growth_times(effort):
    numbers = times.GROWTH[:4] if effort.passes == 1 else times.GROWTH
    return timed(
        {f"{number:,}": cost for number, cost in times.wheelsets(numbers, effort.passes * effort.rounds)}
    )


def thread_times(effort):
    found = times.threads(10 * effort.count, effort.passes * effort.rounds)
    return {str(count): {"µs": 1e6 * seconds, "gain": gain} for count, seconds, gain in found}


# ------------------------------------------------------------------------------------------------- the others


def random_errors(effort):
    """Of the stored random poses."""
    return random_poses.compared(random_poses.references(random_poses.COUNT, random_poses.STORED))


def source_searches(effort):
    return {
        name: {"header": header, "rows": cells}
        for name, (header, cells) in studies.tables(quick=effort is rows.QUICK).items()
    }


def source_figures(effort):
    study = Study()
    numbers = figures.known()[:2] if effort is rows.QUICK else figures.known()
    found = [figures.compute(number, study) for number in tracked(numbers, "figures of the source")]
    return {
        each.number: {"claim": each.claim, "verdict": each.verdict, "finding": each.finding, "key": each.key}
        for each in found
    }


PARTS = {
    "model_errors": Part(ERRORS, model_errors),
    "skip_errors": Part(ERRORS, lambda effort: times.skip_answers()),
    "tolerances": Part(ERRORS, lambda effort: random_poses.numerics(min(effort.count, TOLERANCES))),
    "random_poses": Part(ERRORS, random_errors),
    "worn_pairs": Part(ERRORS, worn_pairs.worn_pairs),
    "zones": Part(ERRORS, lambda effort: random_poses.by_zone()),
    "counts": Part(ERRORS, lambda effort: times.count_table(min(effort.count, COUNTED))),
    "worst_steps": Part(ERRORS, lambda effort: worst.worst_steps(100 if effort is rows.QUICK else STEPS)),
    "choices": Part(ERRORS, lambda effort: errors.choice_changes()),
    "stations": Part(ERRORS, lambda effort: errors.station_errors()),
    "conicity": Part(ERRORS, lambda effort: studies.conicities()),
    "en15302": Part(ERRORS, lambda effort: studies.en15302_rows()),
    "manchester": Part(ERRORS, lambda effort: errors.manchester()),
    "elastic_trials": Part(ERRORS, lambda effort: errors.all_trials()),
    "table_errors": Part(ERRORS, lambda effort: sweeps.table_errors(quick=effort is rows.QUICK)),
    "tangential_errors": Part(ERRORS, lambda effort: creep.errors()),
    "model_times": Part(TIMES, model_times),
    "skip_times": Part(TIMES, skip_times),
    "growth": Part(TIMES, growth_times),
    "threads": Part(TIMES, thread_times),
    "sweep": Part(TIMES, sweeps.sweep_times),
    "value_times": Part(TIMES, lambda effort: timed(sweeps.value_times(effort))),
    "station_times": Part(TIMES, lambda effort: timed(times.station_times(effort))),
    "elastic_times": Part(TIMES, elastic_times),
    "trajectory": Part(TIMES, lambda effort: times.trajectory_times(quick=effort is rows.QUICK)),
    "derivative_times": Part(TIMES, lambda effort: timed(times.derivative_times(effort))),
    "train": Part(TIMES, lambda effort: realtime.train_times(quick=effort is rows.QUICK)),
    "instructions": Part(TIMES, lambda effort: realtime.instructions(quick=effort is rows.QUICK)),
    "tangential_times": Part(TIMES, creep.tangential_times),
    "conformal": Part(STUDIES, lambda effort: errors.turning_patches(quick=effort is rows.QUICK)),
    "halfspace": Part(STUDIES, halfspace_errors),
    "conicity_noise": Part(STUDIES, lambda effort: studies.noisy_conicities()),
    "elastic_roll": Part(STUDIES, lambda effort: errors.roll_steps(quick=effort is rows.QUICK)),
    "profile_noise": Part(STUDIES, lambda effort: studies.noise_study(quick=effort is rows.QUICK)),
    "source_searches": Part(STUDIES, source_searches),
    "source_figures": Part(STUDIES, source_figures),
}
