"""A host for FMUs of FMI 3.0, by fmpy: instances with their logs, addressed by variable names."""

import fmpy
from fmpy.fmi3 import FMU3Slave

from fmi_host import Stepping

TYPES = {"Float64": ("setFloat64", "getFloat64"), "Int32": ("setInt32", "getInt32"),
         "Boolean": ("setBoolean", "getBoolean"),
         "String": ("setString", "getString"), "UInt64": ("setUInt64", "getUInt64")}


class Fmu:
    """An unpacked FMU: its description and where its variables are."""

    def __init__(self, file, folder):
        self.folder = str(folder)
        fmpy.extract(file, unzipdir=self.folder)
        self.description = fmpy.read_model_description(self.folder)
        self.variables = {v.name: v for v in self.description.modelVariables}

    def instance(self, logging=True, **changed):
        return Instance(self, logging, **changed)

    def running(self, stations=None, **start):
        """An instance after initialisation with these values, and with outlines of so many stations."""
        instance = self.instance()
        if stations is not None:
            instance.configure(stations)
        instance.set(**start)
        instance.slave.enterInitializationMode()
        instance.slave.exitInitializationMode()
        return instance


class Instance(Stepping):
    """One slave with its log, addressed by variable names."""

    def __init__(self, fmu, logging, log=None, token=None, name="instance", **options):
        self.fmu, self.log, self.time = fmu, [] if log is None else log, 0.0
        self.stations = int(fmu.variables["stations"].start)
        self.slave = FMU3Slave(guid=fmu.description.guid, unzipDirectory=fmu.folder, instanceName=name,
                               modelIdentifier=fmu.description.coSimulation.modelIdentifier)
        self.slave.guid = fmu.description.instantiationToken if token is None else token
        self.slave.instantiate(loggingOn=logging, logMessage=self._note, **options)

    def _note(self, environment, status, category, message):
        self.log.append([category.decode(), message.decode()])

    def configure(self, stations):
        """Give the outlines another number of stations."""
        self.slave.enterConfigurationMode()
        self.set(stations=stations)
        self.slave.exitConfigurationMode()
        self.stations = stations

    def set(self, **values):
        for name, value in values.items():
            variable = self.fmu.variables[name]
            getattr(self.slave, TYPES[variable.type][0])([variable.valueReference], [value])

    def get(self, *names):
        """Values of the named variables, elements of arrays under their own names; of all
        outputs if there is no name."""
        chosen = ([self.fmu.variables[n] for n in names]
                  or [v for v in self.fmu.variables.values() if v.causality == "output"])
        found = {}
        for v in chosen:
            count = self.stations if v.dimensions else 1
            values = getattr(self.slave, TYPES[v.type][1])([v.valueReference], nValues=count)
            values = [value.decode() if isinstance(value, bytes) else value for value in values]
            found.update({f"{v.name}[{k + 1}]": value for k, value in enumerate(values)} if v.dimensions
                         else {v.name: values[0]})
        return found


def go_on(instance, rows):
    seen = []
    for row in rows:
        instance.step(**row)
        seen.append({name: value if isinstance(value, str) else float(value).hex()
                     for name, value in instance.get().items()})
    return seen
