"""What a call costs, in seconds and in a unit that can be compared between machines, ``np.sqrt`` of 2000
doubles; and measured numbers as they are kept in benchmarks/measured, one file per part, with their commit.

Seconds are those of the processor in this thread, so what other programs take does not count; that they slow
the memory and the processor does.  Disturbances only add time, so a cost is the smallest of several rounds.
The unit is measured between them, and how much it varied during the run tells how noisy the machine was
(:func:`spread`).
"""

import json
import os
import platform
import subprocess
import time
import timeit
from pathlib import Path
from typing import NamedTuple

import numpy as np

from wrcontact.kernel.binding.library import default_kernel

#: Times are those of the processor, which other programs disturb less; Windows counts them in steps of 16 ms.
clock = time.perf_counter if os.name == "nt" else time.thread_time
UNIT = "`np.sqrt` of 2000 doubles"
_VALUES = np.linspace(1.0, 2.0, 2000)
_units = []  # every measurement of the unit in this process [s]


class Cost(NamedTuple):
    """Cost of one call: smallest time of the processor in several rounds, and that of the unit between them
    [s]."""

    seconds: float
    unit: float

    @property
    def microseconds(self):
        return 1e6 * self.seconds

    @property
    def units(self):
        return self.seconds / self.unit

    def kept(self):
        """What is kept of it."""
        return {"units": self.units, "µs": self.microseconds}

    def least(self, other):
        """The smaller of each; ``other`` may be None."""
        return Cost(min(self.seconds, other.seconds), min(self.unit, other.unit)) if other else self


def unit():
    """Seconds of ``np.sqrt`` of 2000 doubles."""
    found = min(timeit.repeat(lambda: np.sqrt(_VALUES), timer=clock, number=100, repeat=5)) / 100
    _units.append(found)
    return found


def cost(work, calls, rounds):
    """:class:`Cost` of one of the ``calls`` that ``work()`` makes: the smallest of several ``rounds``, each
    after a measurement of the unit; of more than one, after a call that does not count."""
    if rounds > 1:
        work()  # the first call is slower
    best = None
    for _ in range(rounds):
        one = unit()
        best = Cost(timeit.timeit(work, timer=clock, number=1) / calls, one).least(best)
    return best


def costs(works, effort):
    """:class:`Cost` by name of ``works``, each a call and how many evaluations it makes: the smallest of
    several passes over all of them, so that a disturbance of some seconds does not slow all rounds of one."""
    best = {}
    for name, (work, calls) in [*works.items()] * effort.passes:
        best[name] = cost(work, calls, effort.rounds).least(best.get(name))
    return best


def restart():
    """Forget the measurements of the unit so far."""
    _units.clear()


def spread():
    """The unit since :func:`restart`: number of measurements, smallest, median and 95 % [s]."""
    if not _units:
        unit()
    return len(_units), min(_units), float(np.median(_units)), float(np.percentile(_units, 95))


def load_average():
    """Load average of the last minute; NaN if the system has none."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")


def machine():
    """Cores, processor and programs, in words."""
    kernel = "compiled" if default_kernel().compiled else "UNCOMPILED"
    return (
        f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}, numpy "
        f"{np.__version__}, kernel {kernel}"
    )


def noise():
    """How fast and how quiet the machine was since :func:`restart`, in words."""
    count, least, median, high = spread()
    return (
        f"{1e6 * least:.2f} µs at best, {percentage(median / least)} more in the median and "
        f"{percentage(high / least)} more at the 95th percentile of {count} measurements between the "
        f"rounds; load average {load_average():.1f}"
    )


def percentage(ratio):
    return f"{100 * (ratio - 1):.0f} %"


# ----------------------------------------------------------------------------------------------- what is kept


ROOT = Path(__file__).parents[1]
FOLDER = Path(__file__).with_name("measured")
DIGITS = 4  # significant digits that are kept
#: What decides about the numbers; changes elsewhere do not count as changes.
SOURCES = ("wrcontact", "fmu_src", "benchmarks/*.py", "data")


def commit():
    """Short name of the commit that is checked out, with "and changes" if the sources differ from it."""
    try:
        name = git("rev-parse", "--short=7", "HEAD").strip()
        changed = git("status", "--porcelain", "--", *SOURCES).strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return f"{name} and changes" if changed else name


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def path(part):
    return FOLDER / f"{part.replace(' ', '_')}.json"


def headed(rows, conditions):
    """What is kept of a part: its ``rows`` (a dict of dicts), their commit, and the ``conditions`` in
    words."""
    return {"commit": commit(), **conditions, "rows": short(rows)}


def save(part, rows, conditions):
    """Write what is kept of a part."""
    head = headed(rows, conditions)
    rows = head.pop("rows")
    lines = [f"{json.dumps(name)}: {json.dumps(value, ensure_ascii=False)}" for name, value in head.items()]
    body = ",\n".join(
        f"  {json.dumps(name, ensure_ascii=False)}: {json.dumps(row, ensure_ascii=False)}"
        for name, row in rows.items()
    )
    FOLDER.mkdir(exist_ok=True)
    text = "{" + ",\n".join([*lines, '"rows": {\n' + body + "\n}"]) + "}\n"
    path(part).write_text(text, encoding="utf-8")


def load(part):
    """What :func:`save` wrote: a dict with "commit", the conditions, and "rows"."""
    return json.loads(path(part).read_text(encoding="utf-8"))


def short(value, digits=DIGITS):
    """Numbers with so many significant digits, also within lists and dicts; numpy's become Python's."""
    if isinstance(value, dict):
        return {name: short(each, digits) for name, each in value.items()}
    if isinstance(value, str | bool | int):
        return value
    if hasattr(value, "__iter__"):
        return [short(each, digits) for each in value]
    return float(f"{float(value):.{digits}g}")
