"""Runs one scenario with an FMU in a process of its own and prints what it saw as JSON.

    python fmu_process.py <scenario> <FMU> <folder for unpacking> (further arguments: JSON on standard input)

The host's own wrcontact is shut out: what answers is the code in the FMU.
"""

import ctypes
import gc
import json
import locale
import os
import sys
from ctypes import c_double
from pathlib import Path

from shut_out import shut_out

shut_out()      # ahead of all that an FMU could find loaded

import fmpy  # noqa: E402

import fmi2_life  # noqa: E402
import fmi2_states  # noqa: E402
import fmi2_walk  # noqa: E402
import fmi_host  # noqa: E402
from fmi2_host import Fmu  # noqa: E402
from fmi_host import refused  # noqa: E402


def first_instant(fmu, start=None):
    """The first instant, and the modules that answer it."""
    return {**fmi_host.first_instant(fmu, start), "modules": modules()}


def modules():
    """Which wrcontact and which PythonFMU this process runs."""
    ours = ("wrcontact", "wheelset_contact", "pythonfmu")
    return {name: module.__file__ for name, module in sys.modules.items() if name.startswith(ours)}


def trajectory(fmu, rows, names, start=None):
    """Outputs after a step at every row of inputs."""
    instance = fmu.running(**(start or {}))
    seen = []
    for row in rows:
        instance.step(**row)
        seen.append(instance.get(*names))
    return {"seen": seen, "log": instance.told()}


def simulated(fmu, rows, times, names):
    """The same by simulate_fmu: inputs hold from one instant to the next, results are those
    at the end of each step."""
    import numpy as np

    rest = {v.name: float(v.start == "true" if v.type == "Boolean" else v.start)
            for v in fmu.description.modelVariables if v.causality == "input"}
    rows = [{**rest, **row} for row in rows]
    columns = [(name, "f8") for name in ("time", *rows[0])]
    signals = np.array([(time, *row.values()) for time, row in zip(times, rows)], dtype=columns)
    interval = (times[-1] - times[0]) / (len(times) - 1)
    limits = {"start_time": times[0], "stop_time": times[-1], "output_interval": interval}
    result = fmpy.simulate_fmu(fmu.folder, input=signals, output=names, **limits)
    return {"seen": [dict(zip(result.dtype.names[1:], row[1:])) for row in result.tolist()]}


VALID = {"lateral_shift": 1e-3, "yaw": 0.0, "roll_guess": 0.0, "normal_force": 78.5e3, "load_transfer": 0.0,
         "vertical_shift_input": 0.0, "roll_input": 0.0, "speed": 0.0, "lateral_velocity": 0.0,
         "vertical_velocity": 0.0, "yaw_rate": 0.0, "roll_rate": 0.0, "wheel_rate": 0.0,
         "track_curvature": 0.0,
         **{f"{side}.rail_{part}{kind}": 0.0 for side in ("left", "right")
            for part in ("lateral", "vertical", "roll") for kind in ("", "_velocity")},
         "left.friction": 0.3, "right.friction": 0.3}


def outcomes(fmu, cases, start=None, valid=None):
    """Each case on a running instance, between two valid steps: its outputs, its log, and the recovery."""
    instance = fmu.running(**(start or {}))
    valid = {**VALID, **(valid or {})}
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
        answers[name] = {"before": before, "during": during, "log": log, "again": again, "after": after,
                         "rest": rest}
    return answers


def laziness(fmu):
    """How often the kernel ran."""
    instance = fmu.running()
    session = session_of("instance")
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


def session_of(name):
    """The session behind the instance of this name; it lives in this process."""
    slaves = [found for found in gc.get_objects() if type(found).__name__ == "WheelsetContact"]
    return next(slave.session for slave in slaves if slave.instance_name == name)


def localised(fmu, locale_name, inner, arguments):
    """A scenario in a host that has chosen this locale for its numbers."""
    locale.setlocale(locale.LC_NUMERIC, locale_name)
    written = ctypes.create_string_buffer(16)
    ctypes.CDLL(None).snprintf(written, 16, b"%g", c_double(1.5))
    return {"one and a half": written.value.decode(), "answer": scenario_of(inner)(fmu, **arguments)}


def derivatives(fmu, rows, outputs, inputs, start):
    """Directional derivatives after steps, with whether the instance stayed as it was; and
    which calls are refused."""
    instance, seen = fmu.running(**start), []
    slave, reference = instance.slave, {v.name: v.valueReference for v in fmu.variables.values()}
    unknowns, knowns = ([reference[name] for name in names] for names in (outputs, inputs))
    for row in rows:
        instance.step(**row)
        state = slave.getFMUstate()
        before = slave.serializeFMUstate(state)
        found = [list(slave.getDirectionalDerivative(unknowns, [known], [1.0])) for known in knowns]
        again = slave.getFMUstate()
        seen.append({"matrix": found, "kept": slave.serializeFMUstate(again) == before})
        slave.freeFMUstate(state)
        slave.freeFMUstate(again)
    calls = {"parameter": (unknowns, [reference["gauge"]]),
             "output as known": (unknowns, [reference["roll"]]),
             "input as unknown": ([reference["yaw"]], knowns[:1]),
             "integer": ([reference["status"]], knowns[:1]), "unknown reference": ([4711], knowns[:1])}
    del instance.log[:]
    answers = {}
    for name, (one, other) in calls.items():
        answers[name] = refused(slave.getDirectionalDerivative, one, other, [1.0]), list(instance.log)
        del instance.log[:]
    return {"seen": seen, "calls": answers}


def neighbours(fmu, other, other_folder):
    """Two different FMUs in one process, both ways round."""
    second = Fmu(other, other_folder)
    one, two = fmu.running("one"), second.running("two")
    one.step(lateral_shift=1e-3), two.step(lateral_shift=1e-3)
    wheels = [one.get("wheel_profile"), two.get("wheel_profile")]
    return {"one": one.get(), "two": two.get(), "wheels": wheels, "modules": modules()}


def several(fmu, others, rows, shared):
    """Several FMUs in one process, stepped in turn, with two instances of the first."""
    fmus = {"first": fmu, **{name: Fmu(*where) for name, where in others.items()}, "again": fmu}
    for one in fmus.values() if shared else ():
        for library in Path(one.folder, "binaries").glob("*/*.so"):
            ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)
    made = {name: one.running(name) for name, one in fmus.items()}
    seen = {name: {"seen": [], "rail": instance.get("rail_profile")["rail_profile"]}
            for name, instance in made.items()}
    for row in rows:
        for name, instance in made.items():
            instance.step(**row)
            seen[name]["seen"].append(instance.get())
    return seen


def refusals(fmu, cases):
    """Wrong parameters: whether initialisation fails, what the log says, and whether
    the FMU works afterwards."""
    answers = {}
    for name, start in cases.items():
        instance = fmu.instance(name)
        instance.set(**start)
        failed = instance.refuses(instance.slave.enterInitializationMode)
        answers[name] = {"refused": failed, "log": instance.told()}
        instance.slave.reset()
        instance.slave.enterInitializationMode()
        instance.slave.exitInitializationMode()
        instance.step(lateral_shift=1e-3)
        answers[name]["after"] = instance.get("roll", "status")
        instance.slave.freeInstance()
    return answers


def illegal(fmu, cases):
    """Single calls that are refused, whether each fails and its log; and a step before initialisation."""
    instance, variables = fmu.running(), fmu.variables
    calls = {
        "same value": lambda: instance.set(gauge=1.435),
        "fixed parameter": lambda: instance.set(gauge=1.5),
        "output": lambda: instance.slave.setReal([variables["roll"].valueReference], [1.0]),
        "integer output": lambda: instance.slave.setInteger([variables["status"].valueReference], [1]),
        "unknown reference": lambda: instance.slave.getReal([4711]),
        "wrong type": lambda: instance.slave.getReal([variables["status"].valueReference]),
    }
    instance.told()
    answers = {name: (refused(calls[name]), instance.told()) for name in cases}
    unready = fmu.instance("unready")
    early = refused(unready.step), unready.told()
    instance.step(lateral_shift=1e-3)
    return {"calls": answers, "unready": early, "after": instance.get("status", "roll")}


def scenario_of(name):
    """The function of this file, or of those that it imports."""
    return {**vars(fmi2_life), **vars(fmi2_states), **vars(fmi2_walk), **globals()}[name]


if __name__ == "__main__":
    scenario, file, folder = sys.argv[1:]
    answer = scenario_of(scenario)(Fmu(file, folder), **json.load(sys.stdin))
    print(json.dumps(answer), flush=True)
    # PythonFMU's binary reads and writes memory that it has freed when the process ends (its exit handler
    # follows the destructor of what it uses; PythonFMU issue 228), which now and then aborts the process
    # after all is done. Every check is in the answer, so leave without exit handlers.
    sys.stderr.flush()
    os._exit(0)
