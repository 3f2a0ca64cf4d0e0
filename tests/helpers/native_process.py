"""Runs one scenario with an FMU of FMI 3 in a process of its own and prints what it saw as JSON, as
fmu_process.py for FMI 2.

    python native_process.py <scenario> <FMU> <folder for unpacking> (further
    arguments: JSON on standard input)
"""

import json
import math
import sys
from ctypes import c_double, c_size_t, c_uint32

import fmpy

import fmi3_life
import fmi3_stations
import fmi_host
from damages import damages
from fmi3_host import Fmu, Instance, go_on
from fmi_host import refused


def damaged_states(fmu, rows, seed, count, foreign=()):
    """As in fmu_process.py."""
    one, other = fmu.running(), fmu.running()
    for row in rows[:3]:
        one.step(**row), other.step(**row)
    state = one.slave.getFMUState()
    saved = one.slave.serializeFMUState(state)
    one.slave.freeFMUState(state)
    cases = [*damages(saved, seed, count), *(("foreign", bytes.fromhex(text)) for text in foreign)]
    wrong = []
    for name, bad in cases:
        one.told()
        accepted = not refused(one.slave.deserializeFMUState, bad)
        lines = [line for _, line in one.told()]
        if (accepted or len(lines) != 1 or "the saved state" not in lines[0]
            or "the present state is kept" not in lines[0]):
            wrong.append([name, accepted, lines])
    equal = []
    for instance in (one, other):
        for row in rows[3:]:
            instance.step(**row)
        equal.append(instance.get())
    return {"count": len(cases), "wrong": wrong[:5], "equal": equal[0] == equal[1], "saved": saved.hex()}


def trajectory(fmu, rows, names, start=None):
    """Outputs after a step at every row of inputs."""
    instance = fmu.running(**(start or {}))
    seen = []
    for row in rows:
        instance.step(**row)
        values = instance.get()
        seen.append({name: values[name] for name in names})
    return {"seen": seen}


def simulated(fmu, rows, times, names):
    """The same by simulate_fmu."""
    import numpy as np

    signals = np.array([(time, *row.values()) for time, row in zip(times, rows)],
                       dtype=[(name, "f8") for name in ("time", *rows[0])])
    interval = (times[-1] - times[0]) / (len(times) - 1)
    result = fmpy.simulate_fmu(fmu.folder, input=signals, output=names, start_time=times[0],
                               stop_time=times[-1], output_interval=interval)
    return {"seen": [dict(zip(result.dtype.names[1:], row[1:])) for row in result.tolist()]}


def situations(fmu, start, cases):
    """Each case on a running instance after a valid step: its outputs and its log."""
    instance = fmu.running(**start)
    valid = {v.name: float(v.start) for v in fmu.variables.values()
             if v.causality == "input" and v.type != "Boolean"}
    answers = {}
    for name, case in cases.items():
        instance.step(**valid)
        instance.told()
        instance.step(**case)
        answers[name] = {"seen": instance.get(), "log": instance.told()}
    return answers


def refusals(fmu, cases):
    """Wrong parameters: whether initialisation fails, what the log says, and whether
    the FMU works afterwards."""
    answers = {}
    for name, start in cases.items():
        instance = fmu.instance()
        instance.set(**start)
        answers[name] = {"refused": refused(instance.slave.enterInitializationMode), "log": instance.told()}
        instance.slave.reset()
        instance.slave.enterInitializationMode()
        instance.slave.exitInitializationMode()
        instance.step(lateral_shift=1e-3)
        answers[name]["after"] = instance.get("roll", "status")
        instance.slave.freeInstance()
    return answers


def state_again(fmu, rows):
    """Bits of a run, of the same from a saved state, and of the same in another instance;
    every input is met twice."""
    rows = [row for row in rows for _ in range(2)]
    one, other = fmu.running(), fmu.instance()
    for row in rows[:11]:
        one.step(**row)
    state = one.slave.getFMUState()
    saved = one.slave.serializeFMUState(state)
    straight = go_on(one, rows[10:])
    one.slave.setFMUState(state)
    back = go_on(one, rows[10:])
    one.slave.freeFMUState(state)
    other.slave.setFMUState(other.slave.deserializeFMUState(saved))
    return {"straight": straight, "back": back, "elsewhere": go_on(other, rows[10:])}


def misuse(fmu):
    """What an importer should not do."""
    instance = fmu.running()
    reference = {name: v.valueReference for name, v in fmu.variables.items()}
    slave, fresh = instance.slave, fmu.instance()
    two, one, values = (c_uint32 * 2)(1, 3), (c_uint32 * 1)(reference["left.station"]), (c_double * 40)()

    def raw(function, *arguments):
        """A call past fmpy's checks; fmpy's own wrapper raises for its status."""
        getattr(slave, function)(slave.component, *arguments)

    calls = {
        "fixed parameter": lambda: instance.set(gauge=1.5),
        "fixed string": lambda: instance.set(load="vertical"),
        "output": lambda: instance.set(roll=1.0),
        "integer output": lambda: instance.set(status=1),
        "time": lambda: instance.set(time=1.0),
        "unknown reference": lambda: slave.getFloat64([4711]),
        "reference zero": lambda: slave.getFloat64([0]),
        "wrong type": lambda: slave.getFloat64([reference["status"]]),
        "text as number": lambda: slave.getFloat64([reference["load"]]),
        "time as integer": lambda: slave.getInt32([1]),
        "other type": lambda: slave.getInt64([reference["status"]]),
        "boolean": lambda: slave.setBoolean([1], [True]),
        "count too small": lambda: raw("fmi3GetFloat64", one, c_size_t(1), values, c_size_t(30)),
        "count too large": lambda: raw("fmi3GetFloat64", one, c_size_t(1), values, c_size_t(40)),
        "null values": lambda: raw("fmi3GetFloat64", one, c_size_t(1), None, c_size_t(31)),
        "null references": lambda: raw("fmi3GetFloat64", None, c_size_t(1), values, c_size_t(1)),
        "null state": lambda: raw("fmi3GetFMUState", None),
        "no state": lambda: raw("fmi3SetFMUState", None),
        "backwards": lambda: slave.doStep(0.0, -1.0),
        "step nan": lambda: slave.doStep(0.0, math.nan),
        "time infinite": lambda: slave.doStep(math.inf, 1.0),
        "initialised twice": lambda: slave.enterInitializationMode(),
        "left twice": lambda: slave.exitInitializationMode(),
        "configuration": lambda: raw("fmi3EnterConfigurationMode"),
        "events": lambda: raw("fmi3EnterEventMode"),
        "derivative": lambda: raw("fmi3GetDirectionalDerivative", two, c_size_t(1), two, c_size_t(1), values,
                                  c_size_t(1), values, c_size_t(1)),
        "output derivative": lambda: raw("fmi3GetOutputDerivatives", two, c_size_t(1), None, values,
                                         c_size_t(1)),
        "category": lambda: slave.setDebugLogging(True, ["everything"]),
    }
    instance.told()
    answers = {name: (refused(call), instance.told()) for name, call in calls.items()}
    answers["not initialised"] = refused(fresh.slave.doStep, 0.0, 1e-3), fresh.told()
    answers["long text"] = refused(lambda: fresh.set(load="x" * 300)), fresh.told()
    instance.slave.terminate()
    answers["terminated"] = refused(slave.doStep, 0.0, 1e-3), instance.told()
    answers["set after the end"] = refused(lambda: instance.set(yaw=0.1)), instance.told()
    answers["terminated twice"] = refused(slave.terminate), instance.told()
    slave.reset()
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    instance.step(lateral_shift=1e-3)
    return {"calls": answers, "after": instance.get("status", "roll"), "not_made": not_made(fmu)}


def derivatives(fmu, rows, outputs, inputs, stations, start):
    """Directional and adjoint derivatives after steps and in initialisation mode, each with whether the
    instance stayed as it was; and which calls are refused, each with its log lines."""
    unknowns, knowns = ([fmu.variables[name].valueReference for name in names] for names in (outputs, inputs))
    count = sum(stations if fmu.variables[name].dimensions else 1 for name in outputs)

    def matrix(slave):
        return [slave.getDirectionalDerivative(unknowns, [known], [1.0], nSensitivity=count)
                for known in knowns]

    def saved(slave):
        state = slave.getFMUState()
        data = list(slave.serializeFMUState(state))
        slave.freeFMUState(state)
        return data

    instance, seen = fmu.running(stations, **start), []
    for row in rows:
        instance.step(**row)
        before, values = saved(instance.slave), instance.get()
        found = matrix(instance.slave)
        together = instance.slave.getDirectionalDerivative(unknowns, knowns, [1.0] * len(knowns),
                                                           nSensitivity=count)
        adjoint = instance.slave.getAdjointDerivative(unknowns, knowns, [1.0] * count,
                                                      nSensitivity=len(knowns))
        kept = saved(instance.slave) == before and instance.get() == values
        seen.append({"matrix": found, "together": together, "adjoint": adjoint, "kept": kept})
    early = fmu.instance()
    early.configure(stations)
    early.set(**start)
    early.slave.enterInitializationMode()
    early.set(**rows[0])
    inside = matrix(early.slave)
    slave, reference = instance.slave, {v.name: v.valueReference for v in fmu.variables.values()}
    fresh = fmu.instance(log=instance.log).slave
    calls = {
        "parameter": lambda: slave.getDirectionalDerivative(unknowns, [reference["gauge"]], [1.0],
                                                            nSensitivity=count),
        "output as known": lambda: slave.getDirectionalDerivative(unknowns, [reference["roll"]], [1.0],
                                                                  nSensitivity=count),
        "input as unknown": lambda: slave.getDirectionalDerivative([reference["yaw"]], knowns[:1], [1.0]),
        "integer": lambda: slave.getDirectionalDerivative([reference["status"]], knowns[:1], [1.0]),
        "time": lambda: slave.getDirectionalDerivative(unknowns, [1], [1.0], nSensitivity=count),
        "stations": lambda: slave.getDirectionalDerivative(unknowns, [2], [1.0], nSensitivity=count),
        "unknown reference": lambda: slave.getDirectionalDerivative([4711], knowns[:1], [1.0]),
        "too few sensitivities": lambda: slave.getDirectionalDerivative(unknowns, knowns[:1], [1.0],
                                                                        nSensitivity=count - 1),
        "too many seeds": lambda: slave.getAdjointDerivative(unknowns, knowns[:1], [1.0] * (count + 1)),
        "not a number": lambda: slave.getDirectionalDerivative(unknowns, knowns[:1], [math.nan],
                                                               nSensitivity=count),
        "too early": lambda: fresh.getDirectionalDerivative(unknowns, knowns[:1], [1.0], nSensitivity=count),
    }
    instance.told()
    answers = {name: (refused(call), instance.told()) for name, call in calls.items()}
    return {"seen": seen, "inside": inside, "calls": answers, "after": matrix(slave) == seen[-1]["matrix"]}


def not_made(fmu):
    """How many lines each instance that cannot be made leaves in the log."""
    answers = {}
    for name, options in {"token": {"token": "{0}"}, "name": {"name": ""}, "events": {"eventModeUsed": True},
                          "intermediate": {"requiredIntermediateVariables": [1]}}.items():
        log = []
        try:
            Instance(fmu, True, log, **options)
            log = ["made"] * 9
        except Exception as refusal:
            assert "Failed to instantiate" in str(refusal)
        answers[name] = len(log)
    return answers


if __name__ == "__main__":
    scenario, file, folder = sys.argv[1:]
    scenarios = {**vars(fmi_host), **vars(fmi3_stations), **vars(fmi3_life), **globals()}
    answer = scenarios[scenario](Fmu(file, folder), **json.load(sys.stdin))
    print(json.dumps(answer), flush=True)
