"""A host for FMUs of FMI 2.0, by fmpy: instances with their logs, addressed by variable names."""

from pathlib import Path

import fmpy
from fmpy.fmi2 import (
    FMU2Slave,
    fmi2CallbackAllocateMemoryTYPE,
    fmi2CallbackFreeMemoryTYPE,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
)

from fmi_host import Stepping, refused


class Fmu:
    """An unpacked FMU: its description and where its variables are."""

    def __init__(self, file, folder):
        self.file, self.folder = file, str(folder)
        fmpy.extract(file, unzipdir=self.folder)
        self.description = fmpy.read_model_description(self.folder)
        self.variables = {v.name: v for v in self.description.modelVariables}

    def instance(self, name="instance", logging=True):
        return Instance(self, name, logging)

    def running(self, name="instance", logging=True, **start):
        """An instance after initialisation with these values."""
        instance = self.instance(name, logging)
        instance.set(**start)
        instance.slave.enterInitializationMode()
        instance.slave.exitInitializationMode()
        return instance


class Instance(Stepping):
    """One slave with its log, addressed by variable names."""

    def __init__(self, fmu, name, logging):
        self.fmu, self.log, self.time = fmu, [], 0.0
        self.slave = FMU2Slave(
            guid=fmu.description.guid,
            unzipDirectory=fmu.folder,
            modelIdentifier=fmu.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(self._note)
        self.callbacks.allocateMemory = fmi2CallbackAllocateMemoryTYPE(fmpy.calloc)
        self.callbacks.freeMemory = fmi2CallbackFreeMemoryTYPE(fmpy.free)
        self.slave.instantiate(callbacks=self.callbacks, loggingOn=logging)
        self.slave.setupExperiment(startTime=0.0)

    def _note(self, environment, instance, status, category, message):
        self.log.append([status, (category or b"").decode(), message.decode()])

    def set(self, **values):
        variables = self.fmu.variables
        for kind, set_values in (("Real", self.slave.setReal), ("Boolean", self.slave.setBoolean),
                                 ("String", self.slave.setString)):
            chosen = {variables[n].valueReference: v for n, v in values.items() if variables[n].type == kind}
            if chosen:
                set_values(list(chosen), list(chosen.values()))

    def get(self, *names):
        """Values of the named variables; of all outputs if there is no name."""
        variables, slave = self.fmu.variables, self.slave
        chosen = [variables[n] for n in names] or [v for v in variables.values() if v.causality == "output"]
        found = {}
        for kind, get_values in (("Real", slave.getReal), ("Integer", slave.getInteger),
                                 ("Boolean", slave.getBoolean),
                                 ("String", slave.getString)):
            some = [v for v in chosen if v.type == kind]
            if some:
                found.update(zip((v.name for v in some), get_values([v.valueReference for v in some])))
        return {name: value.decode() if isinstance(value, bytes) else value for name, value in found.items()}

    def refuses(self, call, *arguments):
        """Whether a call is refused: it fails, or the log has an error, if PythonFMU has no status for it."""
        lines = len(self.log)
        return (refused(call, *arguments)
                or any(category == "logStatusError" for _, category, _ in self.log[lines:]))


def resident():
    """Resident memory of this process [bytes], counted page by page; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/smaps_rollup").read_text().split("Rss:")[1].split()[0]) * 1024
    except OSError:
        return 0
