"""Scenarios of native_process.py on the life cycle: what a state holds, and the log without debug logging."""

import contextlib
import io
import math

import fmpy
from fmpy.fmi1 import FMICallException

from fmi_host import refused


def foreign_stop(fmu):
    """A state of a run up to 1 s, set in an instance with another stopTime; as in fmi2_life.py."""
    runs = {}
    for stop in (1.0, 10.0):
        runs[stop] = instance = fmu.instance()
        instance.slave.enterInitializationMode(startTime=0.0, stopTime=stop)
        instance.slave.exitInitializationMode()
        instance.slave.doStep(0.0, 0.5)
    instance, slave = runs[10.0], runs[10.0].slave
    own, state = slave.getFMUState(), runs[1.0].slave.getFMUState()
    foreign = slave.deserializeFMUState(runs[1.0].slave.serializeFMUState(state))
    answers = {"before": (refused(slave.doStep, 0.5, 2.0), instance.told())}
    slave.setFMUState(foreign)
    answers["foreign"] = refused(slave.doStep, 0.5, 2.0), instance.told()
    answers["up to its stop"] = refused(slave.doStep, 0.5, 0.5), instance.told()
    slave.setFMUState(own)
    answers["own again"] = refused(slave.doStep, 0.5, 2.0), instance.told()
    return answers


def unlogged(fmu):
    """The log of a wrong parameter and of a status, with debug logging off, and what fmpy prints of it."""
    instance = fmu.instance(logging=False)
    instance.set(gauge=14.35)
    assert refused(instance.slave.enterInitializationMode)
    seen = {"parameter": instance.told()}
    instance.set(gauge=1.435, lateral_shift=math.nan)
    instance.slave.enterInitializationMode()
    instance.slave.exitInitializationMode()
    instance.slave.doStep(0.0, 1e-3)
    seen["status"] = instance.told()
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.suppress(FMICallException):
        fmpy.simulate_fmu(fmu.folder, start_values={"gauge": 14.35}, stop_time=1.0, output=["roll"])
    return {**seen, "printed": printed.getvalue()}
