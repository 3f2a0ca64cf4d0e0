"""Scenarios of fmu_process.py with instances for model exchange."""

import fmpy
import numpy as np


def points(fmu, rows, names, start=None):
    """Outputs at every row of inputs, read in continuous-time mode and in event mode without any other
    call."""
    instance = fmu.running(**(start or {}))
    seen = []
    for row in rows:
        instance.set(**row)
        seen.append(instance.get(*names))
    instance.call("EnterEventMode")
    ended = []
    for row in rows:
        instance.set(**row)
        ended.append(instance.get(*names))
    return {"continuous": seen, "event": ended, "log": instance.told()}


def tries(fmu, accepted, tried, invalid, names):
    """An accepted point, one that a solver tries behind it, one without valid outputs, and what follows."""
    instance, other = fmu.running(), fmu.running("other")
    instance.step(**accepted)
    seen = {"accepted": instance.get(*names)}
    instance.set(**tried)
    seen["tried"] = instance.get(*names)
    instance.set(**invalid)
    seen["invalid"], seen["silent"] = instance.get(*names), instance.told()
    other.restore(instance.saved())
    seen["elsewhere"] = other.get(*names)
    other.set(**{name: 2 * value for name, value in invalid.items()})
    seen["still invalid elsewhere"] = other.get(*names)
    instance.step(), instance.step()
    seen["told"] = instance.told()
    instance.step(**tried)
    seen["again"], seen["rest"] = instance.get(*names), instance.told()
    return seen


def foreign_states(fmu, rows):
    """A state of co-simulation in an instance for model exchange, and the other way about."""
    answers = {}
    for exchange in (False, True):
        fmu.exchange = exchange
        one = fmu.running("one")
        one.go_on(rows)
        saved, before = one.saved(), one.get()
        fmu.exchange = not exchange
        other = fmu.running("other")
        other.told()
        answers[str(exchange)] = (
            other.refuses(other.restore, saved),
            other.told(),
            other.go_on(rows)[-1] == before,
        )
    return answers


def simulated_exchange(fmu, rows, times, names, solver):
    """simulate_fmu for model exchange: inputs are linear between the rows, whose times are those of the
    answer."""
    columns = [(name, "f8") for name in ("time", *rows[0])]
    signals = np.array([(time, *row.values()) for time, row in zip(times, rows)], dtype=columns)
    interval = times[1] - times[0]
    result = fmpy.simulate_fmu(
        fmu.folder,
        fmi_type="ModelExchange",
        solver=solver,
        input=signals,
        output=names,
        start_time=times[0],
        stop_time=times[-1],
        output_interval=interval,
        step_size=interval,
    )
    return {
        "times": result["time"].tolist(),
        "seen": [dict(zip(result.dtype.names[1:], row[1:])) for row in result.tolist()],
    }
