"""Scenarios of fmu_process.py on the life cycle: calls out of order, times that are none, stopTime."""

import contextlib
import ctypes
import io
import math

import fmpy
from fmpy.fmi1 import FMICallException


def answer_of(instance, call, *arguments):
    """(Status of a call, the log's lines of status, category and sentence)."""
    try:
        call(*arguments)
        status = 0
    except FMICallException as failure:
        status = failure.status
    return status, instance.told()


def life(fmu):
    """Every call out of its order, and every step that is none; then a reset and a step.  FMI 3 is told the
    times as it enters initialisation mode, FMI 2 before."""
    instance = fmu.instance()
    slave, reference = instance.slave, fmu.references
    read, told = (
        (slave.getReal, slave.setupExperiment)
        if fmu.version == 2
        else (slave.getFloat64, slave.enterInitializationMode)
    )
    times = (None, 1.0, 1.1)
    enter = slave.enterInitializationMode, *(times if fmu.version == 3 else ())
    calls = (
        ("step before", slave.doStep, 0.0, 1e-3),
        ("output before", instance.get, "roll"),
        ("status before", instance.get, "status"),
        ("leave before", slave.exitInitializationMode),
        ("terminate before", slave.terminate),
        ("start nan", told, None, math.nan),
        ("stop before start", told, None, 1.0, 0.5),
        ("stop nan", told, None, 1.0, math.nan),
        *([("good times", told, *times)] if fmu.version == 2 else ()),
        ("wrong parameter", instance.set, "gauge", 14.35),
        ("enter refused", *enter),
        ("right parameter", instance.set, "gauge", 1.435),
        ("enter", *enter),
        ("enter twice", *enter),
        ("times inside", told, None, 0.0),
        ("step inside", slave.doStep, 1.0, 1e-3),
        ("terminate inside", slave.terminate),
        ("output inside", instance.get, "roll"),
        ("leave", slave.exitInitializationMode),
        ("leave twice", slave.exitInitializationMode),
        ("fixed parameter", instance.set, "gauge", 1.5),
        ("fixed text", instance.set, "load", "a #7 %s"),
        ("half a list", lambda: instance.set(yaw=0.1, roll=0.1)),
        ("integer output", instance.set, "status", 1),
        ("unknown reference", read, [4711]),
        ("wrong type", read, [reference["status"]]),
        ("step back", slave.doStep, 1.0, -1.0),
        ("step nan", slave.doStep, 1.0, math.nan),
        ("step at infinity", slave.doStep, math.inf, 1.0),
        ("beyond the stop", slave.doStep, 1.05, 0.1),
        ("step", slave.doStep, 1.0, 0.05),
        ("last step", slave.doStep, 1.05, 0.05 + 1e-12),
        ("unset", instance.get, "yaw"),
        ("terminate", slave.terminate),
        ("terminate twice", slave.terminate),
        ("step after", slave.doStep, 1.1, 0.0),
        ("set after", instance.set, "yaw", 0.1),
        ("read after", instance.get, "roll"),
        ("reset", slave.reset),
        ("enter again", slave.enterInitializationMode),
        ("leave again", slave.exitInitializationMode),
        ("step again", slave.doStep, 0.0, 5.0),
    )
    answers = {}
    for name, call, *arguments in calls:
        if call == instance.set:
            variable, value = arguments
            answers[name] = answer_of(instance, lambda: instance.set(**{variable: value}))
        else:
            answers[name] = answer_of(instance, call, *arguments)
    return {"answers": answers, "after": instance.get("roll", "yaw", "status", "gauge")}


#: Start and size [s] of steps that do not follow each other: back to the start and before it, a leap, the
#: same one again, one of no length, up to the stop.
JUMPING = ((1.0, 0.1), (1.0, 0.25), (-4.0, 0.5), (7.0, 1.0), (7.0, 1.0), (3.0, 0.0), (9.5, 0.5))


def jumping_times(fmu, rows):
    """Outputs at rows of inputs with steps that follow each other, and with the times of JUMPING; statuses
    and log lines of these, and, in FMI 3, the time and the last successful time behind each."""
    straight, jumping = fmu.instance("straight"), fmu.instance("jumping")
    for instance in (straight, jumping):
        instance.initialise(1.0, 10.0)
    straight.time = 1.0
    seen = {"straight": straight.go_on(rows), "jumping": [], "answers": [], "times": []}
    for row, (time, size) in zip(rows, JUMPING, strict=True):
        jumping.set(**row)
        found = []
        seen["answers"].append(answer_of(jumping, lambda: found.append(jumping.slave.doStep(time, size))))
        seen["jumping"].append(jumping.get())
        if fmu.version == 3:
            seen["times"].append([time + size, jumping.get("time")["time"], found[0][-1]])
    return seen


def foreign_stop(fmu):
    """A state of a run up to 1 s, set in an instance with another stopTime."""
    runs = {}
    for stop in (1.0, 10.0):
        runs[stop] = instance = fmu.instance(f"up to {stop} s")
        instance.initialise(0.0, stop)
        instance.slave.doStep(0.0, 0.5)
    run = runs[10.0]
    own, step = run.state("take"), run.slave.doStep
    answers = {"before": answer_of(run, step, 0.5, 2.0)}
    run.restore(runs[1.0].saved())
    answers["foreign"] = answer_of(run, step, 0.5, 2.0)
    answers["up to its stop"] = answer_of(run, step, 0.5, 0.5)
    run.state("set", own)
    answers["own again"] = answer_of(run, step, 0.5, 2.0)
    return answers


def unlogged(fmu):
    """What the log and the console have of a wrong parameter and of a status, with debug logging off; and
    what fmpy's simulate_fmu makes of the parameter."""
    instance = fmu.instance(logging=False)
    instance.set(gauge=14.35)
    seen = {"parameter": answer_of(instance, instance.slave.enterInitializationMode)[1]}
    instance.set(gauge=1.435, lateral_shift=math.nan)
    instance.initialise()
    seen["status"] = answer_of(instance, instance.slave.doStep, 0.0, 1e-3)[1]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        try:
            result = fmpy.simulate_fmu(
                fmu.folder, start_values={"gauge": 14.35}, stop_time=1.0, output=["roll", "status"]
            )
            seen["simulated"] = [list(map(str, row)) for row in result.tolist()]
        except FMICallException as failure:
            seen["simulated"] = failure.status
    return {**seen, "printed": printed.getvalue()}


def pointers(fmu):
    """Statuses of calls with nothing in them: empty lists and a text that is no text."""
    slave, text = fmu.running().slave, fmu.references["load"]
    references, nothing = (ctypes.c_uint * 1)(text), (ctypes.c_char_p * 1)(None)
    try:
        status = slave.fmi2SetString(slave.component, references, 1, nothing) or 0
    except FMICallException as failure:
        status = failure.status
    slave.setReal([], []), slave.getReal([])
    return {"text": status}
