"""Scenarios of fmu_process.py on directional derivatives."""

import math


def rates(fmu, row, outputs, inputs):
    """Derivatives at one row, a list for each input."""
    instance = fmu.running()
    instance.step(**row)
    unknowns = [fmu.references[name] for name in outputs]
    return [instance.derivative(unknowns, [fmu.references[name]], [1.0]) for name in inputs]


def derivatives(fmu, rows, outputs, inputs, start, stations=31):
    """Derivatives after steps and in initialisation mode, those of FMI 3 adjoint too, each with whether the
    instance stayed as it was; and which calls are refused, each with its log lines."""
    unknowns, knowns = ([fmu.references[name] for name in names] for names in (outputs, inputs))
    count = sum(stations if fmu.variables[name].dimensions else 1 for name in outputs)

    def along(instance, knowns, seed, unknowns=unknowns, count=count):
        return instance.derivative(unknowns, knowns, seed, count)

    def matrix(instance):
        return [along(instance, [known], [1.0]) for known in knowns]

    def adjoint(instance, knowns, seed):
        return instance.derivative(unknowns, knowns, seed, len(knowns), adjoint=True)

    instance, seen = fmu.running(stations=stations, **start), []
    for row in rows:
        instance.step(**row)
        values, before = instance.get(), instance.saved()
        found = {"matrix": matrix(instance), "together": along(instance, knowns, [1.0] * len(knowns))}
        if fmu.version == 3:
            found["adjoint"] = adjoint(instance, knowns, [1.0] * count)
        found["kept"] = instance.saved() == before and instance.get() == values
        seen.append(found)
    early, fresh = fmu.instance(), fmu.instance()
    if stations != 31:
        early.configure(stations)
    early.set(**start)
    early.enter()
    early.set(**rows[0])
    one, number = knowns[:1], fmu.references
    calls = {
        "parameter": ([number["gauge"]], [1.0]),
        "output as known": ([number["roll"]], [1.0]),
        "input as unknown": (one, [1.0], [number["yaw"]], 1),
        "integer": (one, [1.0], [number["status"]], 1),
        "unknown reference": (one, [1.0], [4711], 1),
        "not a number": (one, [math.nan]),
    }
    if fmu.version == 3:
        calls |= {
            "time": ([1], [1.0]),
            "stations": ([2], [1.0]),
            "too few sensitivities": (one, [1.0], unknowns, count - 1),
        }
    instance.told()
    answers = {name: instance.status_of(along, instance, *call) for name, call in calls.items()}
    if fmu.version == 3:
        answers["too many seeds"] = instance.status_of(adjoint, instance, one, [1.0] * (count + 1))
    answers["too early"] = fresh.status_of(along, fresh, one, [1.0])
    return {
        "seen": seen,
        "inside": matrix(early),
        "calls": answers,
        "after": matrix(instance) == seen[-1]["matrix"],
    }
