"""A host for FMUs of FMI 2 and 3, by fmpy: instances with their logs, addressed by variable names."""

import re
from pathlib import Path

import fmpy
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import (
    FMU2Model,
    FMU2Slave,
    fmi2CallbackAllocateMemoryTYPE,
    fmi2CallbackFreeMemoryTYPE,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
)
from fmpy.fmi3 import FMU3Model, FMU3Slave

#: What fmpy calls the functions for saved states.
STATES = {
    2: {
        "take": "getFMUstate",
        "set": "setFMUstate",
        "free": "freeFMUstate",
        "pack": "serializeFMUstate",
        "unpack": "deSerializeFMUstate",
    },
    3: {
        "take": "getFMUState",
        "set": "setFMUState",
        "free": "freeFMUState",
        "pack": "serializeFMUState",
        "unpack": "deserializeFMUState",
    },
}


class Fmu:
    """An unpacked FMU: its description and where its variables are; ``exchange`` says whether its instances
    are for model exchange, where a step is one that a solver has completed."""

    exchange = False

    def __init__(self, file, folder):
        self.file, self.folder = file, str(folder)
        fmpy.extract(file, unzipdir=self.folder)
        self.description = fmpy.read_model_description(self.folder)
        self.version = int(self.description.fmiVersion[0])
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.references = {name: v.valueReference for name, v in self.variables.items()}

    def instance(self, name="instance", logging=True):
        return Instance(self, name, logging)

    def running(self, name="instance", logging=True, stations=None, **start):
        """An instance after initialisation with these values, and with outlines of so many stations."""
        instance = self.instance(name, logging)
        if stations not in (None, 31):
            instance.configure(stations)
        instance.set(**start)
        instance.initialise()
        return instance

    def of(self, causality):
        """Variables of a causality."""
        return [v for v in self.variables.values() if v.causality == causality]


class Instance:
    """One slave with its log of [status, category, sentence], addressed by variable names."""

    def __init__(self, fmu, name, logging):
        self.fmu, self.log, self.time, self.stations = fmu, [], 0.0, 31
        described = {
            "unzipDirectory": fmu.folder,
            "instanceName": name,
            "modelIdentifier": fmu.description.coSimulation.modelIdentifier,
        }
        self.exchange = fmu.exchange
        if fmu.version == 3:
            made = FMU3Model if self.exchange else FMU3Slave
            self.slave = made(guid=fmu.description.instantiationToken, **described)
            self.slave.instantiate(loggingOn=logging, logMessage=lambda _, *line: self._note(*line))
            return
        self.slave = (FMU2Model if self.exchange else FMU2Slave)(guid=fmu.description.guid, **described)
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(lambda _, instance, *line: self._note(*line))
        self.callbacks.allocateMemory = fmi2CallbackAllocateMemoryTYPE(fmpy.calloc)
        self.callbacks.freeMemory = fmi2CallbackFreeMemoryTYPE(fmpy.free)
        self.slave.instantiate(callbacks=self.callbacks, loggingOn=logging)
        self.slave.setupExperiment(startTime=0.0)

    def _note(self, status, category, message):
        self.log.append([status, (category or b"").decode(), message.decode()])

    def enter(self, start=None, stop=None):
        """Enter initialisation mode, with a stopTime if one is given."""
        if self.fmu.version == 3:
            self.slave.enterInitializationMode(startTime=start or 0.0, stopTime=stop)
            return
        if stop is not None:
            self.slave.setupExperiment(startTime=start or 0.0, stopTime=stop)
        self.slave.enterInitializationMode()

    def initialise(self, start=None, stop=None):
        self.enter(start, stop)
        self.slave.exitInitializationMode()
        if self.exchange:
            self.update()
            self.slave.enterContinuousTimeMode()

    def update(self):
        """End an event, after which nothing is wanted."""
        update = self.slave.newDiscreteStates if self.fmu.version == 2 else self.slave.updateDiscreteStates
        assert not any(update()[:5])

    def event(self, **inputs):
        """Set inputs in event mode."""
        self.slave.enterEventMode()
        self.set(**inputs)
        self.update()
        self.slave.enterContinuousTimeMode()

    def configure(self, stations):
        """Give the outlines another number of stations."""
        self.slave.enterConfigurationMode()
        self.set(stations=stations)
        self.slave.exitConfigurationMode()
        self.stations = stations

    def set(self, **values):
        kinds = {}
        for name, value in values.items():
            kinds.setdefault(self.fmu.variables[name].type, {})[self.fmu.references[name]] = value
        for kind, chosen in kinds.items():
            getattr(self.slave, f"set{kind}")(list(chosen), list(chosen.values()))

    def get(self, *names):
        """Values of the named variables, of all outputs if there is no name; elements of arrays under their
        own names."""
        known = self.fmu.variables
        if any(name not in known for name in names):  # elements
            found = self.get(*dict.fromkeys(n if n in known else re.sub(r"\[\d+\]$", "", n) for n in names))
            return {name: found[name] for name in names}
        kinds = {}
        for v in [known[name] for name in names] or self.fmu.of("output"):
            kinds.setdefault(v.type, []).append(v)
        found = {}
        for kind, some in kinds.items():
            words = [name for v in some for name in self.elements(v)]
            count = {"nValues": len(words)} if self.fmu.version == 3 else {}
            values = getattr(self.slave, f"get{kind}")([v.valueReference for v in some], **count)
            found.update(zip(words, (v.decode() if isinstance(v, bytes) else v for v in values), strict=True))
        return found

    def elements(self, variable):
        """Names of the values of a variable."""
        if not variable.dimensions:
            return [variable.name]
        return [f"{variable.name}[{k + 1}]" for k in range(self.stations)]

    def step(self, size=1e-3, **inputs):
        if self.exchange:
            self.slave.setTime(self.time + size)
            self.set(**inputs)
            assert self.slave.completedIntegratorStep() == (False, False)
        else:
            self.set(**inputs)
            self.slave.doStep(self.time, size)
        self.time += size

    def go_on(self, rows, *names):
        """Outputs after a step at each row of inputs."""
        seen = []
        for row in rows:
            self.step(**row)
            seen.append(self.get(*names))
        return seen

    def state(self, action, *arguments):
        """One of the functions for saved states, by its name in STATES."""
        return getattr(self.slave, STATES[self.fmu.version][action])(*arguments)

    def saved(self):
        """The bytes of the present state."""
        state = self.state("take")
        data = bytes(self.state("pack", state))
        self.state("free", state)
        return data

    def restore(self, data):
        """Go on from the state that the bytes hold."""
        self.state("set", self.state("unpack", data))

    def told(self):
        """The log lines since the last call."""
        lines, self.log[:] = list(self.log), []
        return lines

    def refuses(self, call, *arguments):
        """Whether a call is refused: it fails, or the log has an error, if PythonFMU has no status for it."""
        lines = len(self.log)
        return refused(call, *arguments) or any(
            category == "logStatusError" for _, category, _ in self.log[lines:]
        )


def refused(call, *arguments, **named):
    """Whether a call fails with an FMI error."""
    try:
        call(*arguments, **named)
    except FMICallException:
        return True
    return False


def resident():
    """Resident memory of this process [bytes], counted page by page; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/smaps_rollup").read_text().split("Rss:")[1].split()[0]) * 1024
    except OSError:
        return 0
