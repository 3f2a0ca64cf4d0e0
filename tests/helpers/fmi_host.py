"""A host for FMUs of FMI 2 and 3, which calls their libraries as C does: instances with their logs, addressed by
variable names."""

import re
from ctypes import (
    CDLL,
    CFUNCTYPE,
    Structure,
    byref,
    c_bool,
    c_char_p,
    c_double,
    c_int,
    c_int64,
    c_size_t,
    c_uint32,
    c_uint64,
    c_void_p,
    cast,
    create_string_buffer,
)
from functools import cache
from pathlib import Path

import fmpy

OK, WARNING, DISCARD, ERROR = range(4)
CO_SIMULATION = 1  # the kind of an instance; 0 is model exchange
HEADERS = Path(fmpy.__file__).parent / "c-code"  #: of the standards
#: Values by what a version of FMI calls their type.
VALUES = {
    "Real": c_double,
    "Float64": c_double,
    "Integer": c_int,
    "Int32": c_int,
    "Int64": c_int64,
    "UInt64": c_uint64,
    "String": c_char_p,
}
POINTER = r"[*\[]|fmi2Component|fmi3Instance|fmi\dFMU[sS]tate|fmi\dString|Callback"
NUMBERS = {"fmi2Real": c_double, "fmi3Float64": c_double, "fmi3Boolean": c_bool, "size_t": c_size_t}


@cache
def signatures(version):
    """{function: [types of its arguments]} of the standard's header, without the prefix of the version."""
    functions = Path(HEADERS, f"fmi{version}Functions.h").read_text()
    types = Path(HEADERS, f"fmi{version}FunctionTypes.h").read_text()
    types = re.sub(r"/\*.*?\*/", " ", types, flags=re.DOTALL)
    declared = rf"^ *FMI{version}_Export fmi{version}\w+TYPE +fmi{version}(\w+);"
    names = re.findall(declared, functions, re.MULTILINE)
    assert len(names) == {2: 44, 3: 75}[version]
    found = {}
    for name in names:
        arguments = re.search(rf"typedef\s+[\w ]+\*?\s+fmi{version}{name}TYPE\s*\(([^)]*)\)", types)[1]
        found[name] = [type_of(one) for one in arguments.split(",") if one.strip() != "void"]
    return found


def type_of(argument):
    """The type of an argument, from its declaration."""
    if re.search(POINTER, argument):
        return c_void_p
    return NUMBERS.get(argument.split()[0], c_int)


class Refused(Exception):
    """A call that returned more than a warning."""

    def __init__(self, function, status):
        super().__init__(f"{function} returned {status}")
        self.status = status


class Callbacks(Structure):
    """fmi2CallbackFunctions."""

    _fields_ = [(name, c_void_p) for name in ("logger", "allocate", "free", "finished", "environment")]


class Fmu:
    """An unpacked FMU: its library, its description and where its variables are; ``exchange`` says whether its
    instances are for model exchange, where a step is one that a solver has completed."""

    exchange = False

    def __init__(self, file, folder):
        self.file, self.folder, self.functions = file, str(folder), {}
        fmpy.extract(file, unzipdir=self.folder)
        self.description = fmpy.read_model_description(self.folder)
        self.version = int(self.description.fmiVersion[0])
        self.token = self.description.instantiationToken or self.description.guid
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.references = {name: v.valueReference for name, v in self.variables.items()}
        self.python = Path(self.folder, "resources", "slavemodule.txt").exists()  # by PythonFMU
        self.real, self.integer = ("Real", "Integer") if self.version == 2 else ("Float64", "Int32")
        self.values = VALUES | {"Boolean": c_int if self.version == 2 else c_bool}

    def function(self, name):
        """A function of the library, by its name without prefix, with the types of the header."""
        if name not in self.functions:
            place = fmpy.platform if self.version == 2 else fmpy.platform_tuple
            identifier = self.description.coSimulation.modelIdentifier
            library = Path(self.folder, "binaries", place, identifier + fmpy.sharedLibraryExtension)
            found = getattr(CDLL(str(library.absolute())), f"fmi{self.version}{name}")
            found.argtypes = signatures(self.version)[name]
            made = {"FreeInstance": None, "GetVersion": c_char_p, "GetTypesPlatform": c_char_p}
            found.restype = c_void_p if name.startswith("Instantiate") else made.get(name, c_int)
            self.functions[name] = found
        return self.functions[name]

    def instance(self, name="instance", logging=True, **options):
        """A new instance; see Instance."""
        made = Instance(self, name, logging, **options)
        assert made.component, made.log
        return made

    def running(self, name="instance", logging=True, stations=None, **start):
        """An instance after initialisation with these values, and with outlines of so many stations."""
        instance = self.instance(name, logging)
        if stations not in (None, 31):
            instance.configure(stations)
        instance.set(**start)
        instance.initialise()
        return instance

    def of(self, causality, *types):
        """Variables of a causality, of these types if there are any."""
        found = (v for v in self.variables.values() if v.causality == causality)
        return [v for v in found if not types or v.type in types]


class Instance:
    """One instance with its log of [status, category, sentence], addressed by variable names. ``component`` is
    None if it could not be made; ``kind`` is CO_SIMULATION, 0 or something wrong; without ``callbacks`` there is
    no log; FMI 3 may be asked for ``events`` and for so many ``intermediate`` variables."""

    def __init__(self, fmu, name="instance", logging=True, kind=None, callbacks=True, **options):
        self.fmu, self.log, self.time, self.stations, self.speaker = fmu, [], 0.0, 31, None
        kind = (0 if fmu.exchange else CO_SIMULATION) if kind is None else kind
        self.exchange = kind == 0
        folder = Path(fmu.folder, "resources").absolute()
        resources = options.get("resources", folder.as_uri() if fmu.version == 2 else f"{folder}/")
        token = options.get("token", fmu.token)
        name, token, resources = (
            text.encode() if isinstance(text, str) else text for text in (name, token, resources)
        )
        if fmu.version == 2:
            self.note = CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)(self._note2)
            self.callbacks = Callbacks(cast(self.note, c_void_p))
            arguments = kind, token, resources, byref(self.callbacks) if callbacks else None, 0, logging
            function = "Instantiate"
        else:
            self.note = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)(self._note)
            asked = options.get("intermediate", 0)
            steps = options.get("events", False), False, (c_uint32 * 1)(1), asked
            note = self.note if callbacks else None
            arguments = token, resources, False, logging, *(() if self.exchange else steps), None, note
            arguments += () if self.exchange else (None,)
            function = f"Instantiate{'ModelExchange' if self.exchange else 'CoSimulation'}"
        self.component = fmu.function(function)(name, *arguments)
        if self.component and fmu.version == 2:
            self.times()

    def _note(self, _, status, category, message):
        self.log.append([status, (category or b"").decode(), message.decode()])

    def _note2(self, environment, name, *line):
        self.speaker = name and name.decode()
        self._note(environment, *line)

    def call(self, name, *arguments):
        """A function of the standard, by its name without prefix; raises Refused."""
        status = self.fmu.function(name)(self.component, *arguments)
        if status > WARNING:
            raise Refused(name, status)

    def status_of(self, call, *arguments, **named):
        """(Status of a call, the lines of the log since the last that were read)."""
        try:
            call(*arguments, **named)
            return OK, self.told()
        except Refused as failure:
            return failure.status, self.told()

    def told(self):
        """The log lines since the last call."""
        lines, self.log[:] = list(self.log), []
        return lines

    def refuses(self, call, *arguments, **named):
        """Whether a call is refused: it fails, or the log has an error, if PythonFMU has no status for it."""
        lines = len(self.log)
        try:
            call(*arguments, **named)
        except Refused:
            return True
        return any(category == "logStatusError" for _, category, _ in self.log[lines:])

    # --- life -----------------------------------------------------------------------------------------

    def times(self, start=0.0, stop=None):
        """Say the times of a run: FMI 2 ahead of initialisation mode, FMI 3 as it enters this mode."""
        name = "SetupExperiment" if self.fmu.version == 2 else "EnterInitializationMode"
        self.call(name, False, 0.0, start, stop is not None, 0.0 if stop is None else stop)

    def enter(self, *times):
        """Enter initialisation mode, with a start and a stop if they are given."""
        if times or self.fmu.version == 3:
            self.times(*times)
        if self.fmu.version == 2:
            self.call("EnterInitializationMode")

    def leave(self):
        self.call("ExitInitializationMode")

    def initialise(self, *times):
        self.enter(*times)
        self.leave()
        if self.exchange:
            self.update()
            self.call("EnterContinuousTimeMode")

    def terminate(self):
        self.call("Terminate")

    def reset(self):
        self.call("Reset")

    def free(self):
        self.fmu.function("FreeInstance")(self.component)

    def update(self):
        """End an event, after which nothing is wanted."""
        if self.fmu.version == 2:
            flags = (c_int * 8)(*[-1] * 8)
            self.call("NewDiscreteStates", flags)
        else:
            flags = (c_bool * 5)(*[True] * 5)
            self.call("UpdateDiscreteStates", *(byref(flags, k) for k in range(5)), byref(c_double()))
        assert not any(flags[:5])

    def complete(self):
        """Complete a step of a solver, after which nothing is wanted."""
        flags = [c_int(-1) if self.fmu.version == 2 else c_bool(True) for _ in range(2)]
        self.call("CompletedIntegratorStep", True, *map(byref, flags))
        assert not any(flag.value for flag in flags)

    def configure(self, stations):
        """Give the outlines another number of stations."""
        self.call("EnterConfigurationMode")
        self.set(stations=stations)
        self.call("ExitConfigurationMode")
        self.stations = stations

    def do_step(self, time=0.0, size=1e-3):
        """A step of co-simulation; in FMI 3 the last successful time [s]."""
        if self.fmu.version == 2:
            return self.call("DoStep", time, size, True)
        flags, last = (c_bool * 3)(), c_double()
        self.call("DoStep", time, size, True, *(byref(flags, k) for k in range(3)), byref(last))
        assert not any(flags)
        return last.value

    def step(self, size=1e-3, **inputs):
        """A step that follows the one before, with these inputs."""
        if self.exchange:
            self.call("SetTime", self.time + size)
            self.set(**inputs)
            self.complete()
        else:
            self.set(**inputs)
            self.do_step(self.time, size)
        self.time += size

    def go_on(self, rows, *names):
        """Outputs after a step at each row of inputs."""
        seen = []
        for row in rows:
            self.step(**row)
            seen.append(self.get(*names))
        return seen

    # --- values ---------------------------------------------------------------------------------------

    def read(self, kind, references, count=None):
        """Values of a type; ``count`` is FMI 3's number of them."""
        values = (self.fmu.values[kind] * (len(references) if count is None else count))()
        self._move(f"Get{kind}", references, values)
        return list(values)

    def write(self, kind, references, values):
        """Set values of a type."""
        values = [value.encode() if isinstance(value, str) else value for value in values]
        self._move(f"Set{kind}", references, (self.fmu.values[kind] * len(values))(*values))

    def _move(self, name, references, values):
        counts = (len(values),) if self.fmu.version == 3 else ()
        self.call(name, (c_uint32 * len(references))(*references), len(references), values, *counts)

    def set(self, **values):
        kinds = {}
        for name, value in values.items():
            kinds.setdefault(self.fmu.variables[name].type, {})[self.fmu.references[name]] = value
        for kind, chosen in kinds.items():
            self.write(kind, list(chosen), list(chosen.values()))

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
            values = self.read(kind, [v.valueReference for v in some], len(words))
            found.update(zip(words, (v.decode() if isinstance(v, bytes) else v for v in values), strict=True))
        return found

    def elements(self, variable):
        """Names of the values of a variable."""
        if not variable.dimensions:
            return [variable.name]
        return [f"{variable.name}[{k + 1}]" for k in range(self.stations)]

    def derivative(self, unknowns, knowns, seed, count=None, adjoint=False):
        """Directional derivatives of the unknowns, or adjoint ones of the knowns, by value references; ``count``
        is FMI 3's number of them."""
        found = (c_double * (len(unknowns) if count is None else count))()
        sizes = ((len(seed),), (len(found),)) if self.fmu.version == 3 else ((), ())
        self.call(
            f"Get{'Adjoint' if adjoint else 'Directional'}Derivative",
            (c_uint32 * len(unknowns))(*unknowns),
            len(unknowns),
            (c_uint32 * len(knowns))(*knowns),
            len(knowns),
            (c_double * len(seed))(*seed),
            *sizes[0],
            found,
            *sizes[1],
        )
        return list(found)

    # --- saved states ---------------------------------------------------------------------------------

    def state(self, verb, *arguments):
        """A function for saved states, as FMI 3 calls it; its size by "Size"."""
        word = "FMUState" if self.fmu.version == 3 else "FMUstate"
        if self.fmu.version == 2 and verb == "Deserialize":
            verb = "DeSerialize"
        self.call(f"Serialized{word}Size" if verb == "Size" else f"{verb}{word}", *arguments)

    def take(self):
        """The present state."""
        state = c_void_p()
        self.state("Get", byref(state))
        return state

    def go_back(self, state):
        """Go on from a state."""
        self.state("Set", state)

    def pack(self, state):
        """The bytes of a state."""
        size = c_size_t()
        self.state("Size", state, byref(size))
        data = create_string_buffer(size.value)
        self.state("Serialize", state, data, size)
        return data.raw

    def unpack(self, data):
        """The state that the bytes hold."""
        state = c_void_p()
        try:
            self.state("Deserialize", data, len(data), byref(state))
        except Refused:
            assert not state.value
            raise
        return state

    def drop(self, state):
        """Free a state."""
        self.state("Free", byref(state))

    def saved(self):
        """The bytes of the present state."""
        state = self.take()
        data = self.pack(state)
        self.drop(state)
        return data

    def restore(self, data):
        """Go on from the state that the bytes hold."""
        state = self.unpack(data)
        self.go_back(state)
        self.drop(state)


def resident():
    """Resident memory of this process [bytes], counted page by page; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/smaps_rollup").read_text().split("Rss:")[1].split()[0]) * 1024
    except OSError:
        return 0
