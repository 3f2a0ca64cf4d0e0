"""The functions of a native FMU's library as C calls them."""

from ctypes import (
    CDLL,
    CFUNCTYPE,
    Structure,
    byref,
    c_bool,
    c_char_p,
    c_double,
    c_int,
    c_size_t,
    c_uint32,
    c_void_p,
    cast,
)

OK, ERROR = 0, 3
NOWHERE = 0x10  # an address that nothing may look at


class Callbacks(Structure):
    """fmi2CallbackFunctions."""

    _fields_ = [(name, c_void_p) for name in ("logger", "allocate", "free", "finished", "environment")]


class Library:
    """The functions of one version of FMI under common names, and the log of all calls; ``inputs`` are the names of
    the Real ones."""

    def __init__(self, version, file, token, references, inputs):
        self.version, self.token, self.references, self.inputs, self.log = (
            version,
            token,
            references,
            inputs,
            [],
        )
        self.library = CDLL(file)
        if version == 2:
            self.note = CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)(
                lambda environment, name, status, category, line: self.log.append([name, category, line])
            )
        else:
            self.note = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)(
                lambda environment, status, category, line: self.log.append([None, category, line])
            )
        self.callbacks = Callbacks(cast(self.note, c_void_p))

    def function(self, name):
        found = getattr(self.library, f"fmi{self.version}{name}")
        found.restype = (
            c_void_p if name.startswith("Instantiate") else None if name == "FreeInstance" else c_int
        )
        return found

    def instantiate(
        self,
        name=b"instance",
        token=None,
        resources=None,
        logging=True,
        kind=1,
        callbacks=True,
        events=False,
        asked=0,
    ):
        """A component, or None; ``kind`` 1 is co-simulation, 0 model exchange."""
        token = self.token.encode() if token is None else token or None
        if self.version == 2:
            return self.function("Instantiate")(
                name,
                c_int(kind),
                token,
                resources,
                byref(self.callbacks) if callbacks else None,
                c_int(0),
                c_int(logging),
            )
        if kind == 0:
            return self.function("InstantiateModelExchange")(
                name, token, resources, c_bool(False), c_bool(logging), None, self.note if callbacks else None
            )
        return self.function("InstantiateCoSimulation")(
            name,
            token,
            resources,
            c_bool(False),
            c_bool(logging),
            c_bool(events),
            c_bool(False),
            (c_uint32 * 1)(1),
            c_size_t(asked),
            None,
            self.note if callbacks else None,
            None,
        )

    def enter(self, c, start=0.0, stop=None):
        experiment = c_double(start), c_int(stop is not None), c_double(stop or 0.0)
        if self.version == 3:
            return self.function("EnterInitializationMode")(c_void_p(c), c_int(0), c_double(0.0), *experiment)
        return self.function("SetupExperiment")(
            c_void_p(c), c_int(0), c_double(0.0), *experiment
        ) or self.function("EnterInitializationMode")(c_void_p(c))

    def ready(self, stop=None, **options):
        """A component after its initialisation."""
        c = self.instantiate(**options)
        assert c and self.enter(c, stop=stop) == OK and self.plain("ExitInitializationMode", c) == OK
        return c

    def plain(self, name, c):
        return self.function(name)(c_void_p(c))

    def free(self, c):
        self.function("FreeInstance")(c_void_p(c))

    def step(self, c, time=0.0, size=1e-3):
        results = (
            ()
            if self.version == 2
            else (byref(c_bool()), byref(c_bool()), byref(c_bool()), byref(c_double()))
        )
        return self.function("DoStep")(c_void_p(c), c_double(time), c_double(size), c_int(1), *results)

    def values(self, name, c, references, values, count=None):
        """Get or set values; `count` is FMI 3's number of them."""
        counts = () if self.version == 2 else (c_size_t(len(values) if count is None else count),)
        numbers = (c_uint32 * max(1, len(references)))(*references)
        return self.function(name)(c_void_p(c), numbers, c_size_t(len(references)), values, *counts)

    def set(self, c, **values):
        numbers = (c_double * len(values))(*values.values())
        return self.values(self.real("Set"), c, [self.references[name] for name in values], numbers)

    def set_text(self, c, name, value):
        return self.values("SetString", c, [self.references[name]], (c_char_p * 1)(value))

    def get(self, c, *names):
        found = (c_double * len(names))()
        status = self.values(self.real("Get"), c, [self.references[n] for n in names], found)
        return list(found) if status == OK else status

    def outcome(self, c):
        found = (c_int * 1)()
        status = self.values(self.integer("Get"), c, [self.references["status"]], found)
        return found[0] if status == OK else status

    def real(self, verb):
        return verb + ("Real" if self.version == 2 else "Float64")

    def integer(self, verb):
        return verb + ("Integer" if self.version == 2 else "Int32")

    def state(self, verb, c, *arguments):
        """A function for saved states, as FMI 3 calls it."""
        name = verb + "FMUState"
        if self.version == 2:
            name = {"Deserialize": "DeSerialize"}.get(verb, verb) + "FMUstate"
        name = f"Serialized{name.removeprefix('Size')}Size" if verb == "Size" else name
        return self.function(name)(c_void_p(c), *arguments)

    def told(self):
        lines, self.log[:] = (
            [[part if part is None else part.decode() for part in line] for line in self.log],
            [],
        )
        return lines


WORK = ("lateral_shift", "roll", "vertical_shift", "right.penetration", "left.area", "right.max_pressure")


def run(fmi, c, steps=True):
    """Bits of a short run; without ``steps`` values are read at once."""
    seen = []
    for shift in (1e-3, 4e-3, 7e-3):
        assert fmi.set(c, lateral_shift=shift, yaw=2e-3, normal_force=8e4) == OK
        assert not steps or fmi.step(c) == OK
        seen += fmi.get(c, *WORK)
    return [value.hex() for value in seen]


def check_run(fmi, c, wanted):
    """Whether a component works as a fresh one, after a reset."""
    assert fmi.plain("Reset", c) == OK and fmi.enter(c) == OK and fmi.plain("ExitInitializationMode", c) == OK
    return run(fmi, c) == wanted


def switch(fmi, c, on, *names):
    """Turn log categories on or off."""
    words = (c_char_p * max(1, len(names)))(*names)
    return fmi.function("SetDebugLogging")(c_void_p(c), c_int(on), c_size_t(len(names)), words)
