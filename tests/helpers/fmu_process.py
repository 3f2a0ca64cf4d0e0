"""Answers scenarios with an FMU of FMI 2 or 3, one after the other, in a process of its own.

    python fmu_process.py <FMU> <folder for unpacking>

Each line of standard input is a scenario and its arguments as JSON, each line of standard output what it saw.
The host's own wrcontact is shut out: what answers is the code in the FMU.
"""

import ctypes
import gc
import json
import locale
import os
import sys
import traceback
from ctypes import c_double
from pathlib import Path

from shut_out import shut_out

shut_out()  # ahead of all that an FMU could find loaded

import fmpy  # noqa: E402

import fmu_derivatives  # noqa: E402
import fmu_exchange  # noqa: E402
import fmu_life  # noqa: E402
import fmu_states  # noqa: E402
import fmu_stations  # noqa: E402
import fmu_walk  # noqa: E402
from fmi_host import Fmu  # noqa: E402


def modules(fmu):
    """Which wrcontact and which PythonFMU this process runs."""
    fmu.running()
    ours = ("wrcontact", "wheelset_contact", "pythonfmu")
    return {name: module.__file__ for name, module in sys.modules.items() if name.startswith(ours)}


def first_instant(fmu, start=None):
    """Outputs before any step, at the default inputs and at others."""
    plain = fmu.running().get()
    instance = fmu.instance()
    instance.enter()
    instance.set(**(start or {}))
    inside = instance.get()
    instance.leave()
    return {"default": plain, "in_initialisation": inside, "after_initialisation": instance.get()}


def trajectory(fmu, rows, names, start=None):
    """Outputs after a step at every row of inputs."""
    instance = fmu.running(**(start or {}))
    return {"seen": instance.go_on(rows, *names), "log": instance.told()}


def starts(fmu):
    """Start values of all inputs as numbers."""
    return {v.name: float(v.start == "true" if v.type == "Boolean" else v.start) for v in fmu.of("input")}


def simulated(fmu, rows, times, names):
    """The same by simulate_fmu: inputs hold from one instant to the next, results are those
    at the end of each step."""
    import numpy as np

    rows = [{**starts(fmu), **row} for row in rows]
    columns = [(name, "f8") for name in ("time", *rows[0])]
    signals = np.array([(time, *row.values()) for time, row in zip(times, rows)], dtype=columns)
    interval = (times[-1] - times[0]) / (len(times) - 1)
    limits = {"start_time": times[0], "stop_time": times[-1], "output_interval": interval}
    result = fmpy.simulate_fmu(fmu.folder, input=signals, output=names, **limits)
    return {"seen": [dict(zip(result.dtype.names[1:], row[1:])) for row in result.tolist()]}


def outcomes(fmu, cases, valid, start=None):
    """Each case on a running instance, between ``valid`` steps: its outputs, its log, and the recovery."""
    instance = fmu.running(**(start or {}))
    answers = {}
    for name, case in cases.items():
        instance.step(**valid)
        before = instance.get()
        instance.told()
        instance.step(**case)
        during, log = instance.get(), instance.told()
        instance.step()
        again = instance.told()
        instance.step(**valid)
        after, rest = instance.get(), instance.told()
        answers[name] = {
            "before": before,
            "during": during,
            "log": log,
            "again": again,
            "after": after,
            "rest": rest,
        }
    return answers


def laziness(fmu):
    """How often the kernel ran."""
    instance = fmu.running("lazy")
    session = next(
        slave.session
        for slave in gc.get_objects()
        if type(slave).__name__ == "WheelsetContact" and slave.instance_name == "lazy"
    )  # it lives in this process
    counts = [session.evaluations]
    instance.get(), instance.step(), instance.step(), instance.get()
    counts.append(session.evaluations)
    instance.step(lateral_shift=2e-3)
    instance.get(), instance.get("roll"), instance.step()
    counts.append(session.evaluations)
    instance.set(lateral_shift=3e-3)
    ahead = instance.get("roll")
    instance.step()
    counts.append(session.evaluations)
    instance.set(lateral_shift=2e-3), instance.set(lateral_shift=3e-3, yaw=0.0)
    return {"counts": counts, "ahead": ahead, "after": instance.get("roll")}


def localised(fmu, locale_name, inner, arguments):
    """A scenario in a host that has chosen this locale for its numbers."""
    locale.setlocale(locale.LC_NUMERIC, locale_name)
    written = ctypes.create_string_buffer(16)
    ctypes.CDLL(None).snprintf(written, 16, b"%g", c_double(1.5))
    return {"one and a half": written.value.decode(), "answer": scenario_of(inner)(fmu, **arguments)}


def several(fmu, others, rows, shared):
    """Several FMUs in one process, stepped in turn, with two instances of the first."""
    fmus = {"first": fmu, **{name: Fmu(*where) for name, where in others.items()}, "again": fmu}
    for one in fmus.values() if shared else ():
        for library in Path(one.folder, "binaries").glob("*/*.so"):
            ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)
    made = {name: one.running(name) for name, one in fmus.items()}
    seen = {
        name: {"seen": [], "rail": instance.get("rail_profile")["rail_profile"]}
        for name, instance in made.items()
    }
    for row in rows:
        for name, instance in made.items():
            seen[name]["seen"] += instance.go_on([row])
    return seen


def refusals(fmu, cases):
    """Wrong parameters: whether initialisation fails, what the log says, and whether
    the FMU works afterwards."""
    answers = {}
    for name, start in cases.items():
        instance = fmu.instance(name)
        instance.set(**start)
        failed = instance.refuses(instance.enter)
        answers[name] = {"refused": failed, "log": instance.told()}
        instance.reset()
        instance.initialise()
        instance.step(lateral_shift=1e-3)
        answers[name]["after"] = instance.get("roll", "status")
    return answers


def scenario_of(name):
    """The function of this file, or of those that it imports."""
    files = fmu_life, fmu_states, fmu_walk, fmu_derivatives, fmu_stations, fmu_exchange
    return {name: value for file in files for name, value in vars(file).items()}.get(name) or globals()[name]


def answer(fmu, line):
    """What a scenario has seen, as one line; or the error that ended it."""
    asked = json.loads(line)
    fmu.exchange = asked.pop("exchange", False)
    try:
        seen = {"answer": scenario_of(asked.pop("scenario"))(fmu, **asked)}
    except BaseException:
        seen = {"error": traceback.format_exc()}
    return json.dumps(seen)


if __name__ == "__main__":
    with os.fdopen(os.dup(1), "w", encoding="utf-8") as answers:
        os.dup2(2, 1)  # what others print is not an answer
        opened = Fmu(*sys.argv[1:])
        for question in sys.stdin:
            print(answer(opened, question), file=answers, flush=True)
    # PythonFMU's binary reads and writes memory that it has freed when the process ends (its exit handler
    # follows the destructor of what it uses; PythonFMU issue 228), which now and then aborts the process
    # after all is done. Every check is in the answer, so leave without exit handlers.
    sys.stderr.flush()
    os._exit(0)
