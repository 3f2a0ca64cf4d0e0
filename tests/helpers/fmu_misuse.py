"""What an instance of an FMU may be asked in the order of its life, what it refuses, and what its log says of that:
one list for the Python FMU and for the native ones (fmu_life.py makes the calls, tests/fmu/test_life_cycle.py
compares the answers)."""

import math
from ctypes import byref, c_char_p, c_double, c_size_t, c_uint32, c_void_p, create_string_buffer
from typing import Any, NamedTuple

TIMES = 1.0, 1.1  # [s] start and stop
NOWHERE = 0x10  # an address that nothing may look at
PYTHON, NATIVE, FMI2, FMI3 = ("python",), (2, 3), ("python", 2), (3,)


class Call(NamedTuple):
    """A call, and the part of the sentence that refuses it, None if it is permitted."""

    name: str
    make: Any
    refused: str | None = None
    kinds: tuple = ("python", 2, 3)  #: of FMUs that are asked this


def calls(kind, rows):
    """The calls for a kind of FMU by name."""
    return {call.name: call for call in (Call(*row) for row in rows) if kind in call.kinds}


def setting(**values):
    return lambda one: one.set(**values)


def getting(*names):
    return lambda one: one.get(*names)


def step(time, size):
    return lambda one: one.do_step(time, size)


def real(*names, count=None):
    """Read as Real: of names, or of value references."""
    return lambda one: one.read(one.fmu.real, references(one, names), count)


def references(one, names):
    return [one.fmu.references.get(name, name) for name in names]


def typed(kind, name, value=None):
    """Read as another type, or set, if there is a value."""
    place = lambda one: one.fmu.references[name]  # noqa: E731
    if value is None:
        return lambda one: one.read(getattr(one.fmu, kind.lower(), kind), [place(one)])
    return lambda one: one.write(getattr(one.fmu, kind.lower(), kind), [place(one)], [value])


def times(*given):
    return lambda one: one.times(*given)


def enter(one):
    """FMI 3 says the times as it enters initialisation mode."""
    one.enter(*(TIMES if one.fmu.version == 3 else ()))


def plain(name, *arguments):
    return lambda one: one.call(name, *arguments)


def categories(*names):
    return plain("SetDebugLogging", True, len(names), (c_char_p * len(names))(*names))


def no_text(one):
    one.write("String", [one.fmu.references["load"]], [None])


NEW = (
    ("step, new", step(0.0, 1e-3), "has not been initialised"),
    ("output, new", getting("roll"), "roll is an output and cannot be read before"),
    ("status, new", getting("status"), ""),
    ("leave, new", plain("ExitInitializationMode"), ""),
    ("terminate, new", plain("Terminate"), ""),
    ("start nan", times(math.nan), "startTime is nan s"),
    ("stop before start", times(1.0, 0.5), ""),
    ("stop nan", times(1.0, math.nan), "stopTime nan s"),
    ("good times", times(*TIMES), None, FMI2),
    ("wrong parameter", setting(gauge=14.35)),
    ("enter with it", enter, "gauge is 14.35;"),
    ("right parameter", setting(gauge=1.435)),
    ("enter", enter),
)
INITIALISING = (
    ("enter twice", enter, " once, "),
    ("times, initialising", times(0.0), ""),
    ("step, initialising", step(1.0, 1e-3), ""),
    ("terminate, initialising", plain("Terminate"), ""),
    ("output, initialising", getting("roll")),
    ("leave", plain("ExitInitializationMode")),
)
#: Of an instance that runs; none of these changes it.
RUNNING = (
    ("leave twice", plain("ExitInitializationMode"), ""),
    ("enter, running", enter, ""),
    ("times, running", times(0.0), ""),
    ("unknown reference", real(4711), "4711 does not exist"),
    ("unknown reference set", lambda one: one.write(one.fmu.real, [4711], [1.0]), "4711"),
    ("largest reference", real(0xFFFFFFFF), "4294967295", NATIVE),
    ("Integer as Real", real("status"), "status"),
    ("String as Real", lambda one: one.write(one.fmu.real, references(one, ["load"]), [1.0]), "load"),
    ("Real as Integer", typed("Integer", "roll"), ""),
    ("Real as String", typed("String", "gauge"), ""),
    ("Real as String set", typed("String", "gauge", "vertical"), ""),
    ("Real as Boolean", typed("Boolean", "roll"), ""),
    ("output set", setting(roll=1.0), "roll"),
    ("Integer output set", setting(status=1), ""),
    ("fixed Real", setting(gauge=1.5), "gauge is fixed at 1.435"),
    ("fixed Real nan", setting(gauge=math.nan), ""),
    (
        "fixed Boolean",
        setting(independent_wheels=True),
        "independent_wheels is fixed at False after initialisation and cannot become True",
    ),
    ("fixed String", setting(load="vertical"), "load is fixed at 'normal'"),
    # the message is a format in FMI 2, and has value references between number signs in both
    ("signs", setting(load="%s%n%%d #7"), "cannot become '%%s%%n%%%%d ##7'", FMI2),
    ("signs", setting(load="%s%n%%d #7"), "cannot become '%s%n%%d ##7'", FMI3),
    ("String without letters", no_text, "load is a NULL pointer", NATIVE),
    ("long String", setting(load="x" * 5000), "load has 5000 bytes", NATIVE),
    ("half a list", setting(lateral_shift=2e-3, roll=0.1), "roll is an output"),
    ("step back", step(1.0, -1.0), "-1.0 s"),
    ("step of nan", step(1.0, math.nan), "a step of nan s"),
    ("step of inf", step(1.0, math.inf), ""),
    ("step at nan", step(math.nan, 1e-3), ""),
    ("step at infinity", step(math.inf, 1.0), ""),
    ("step beyond numbers", step(1e308, 1e308), ""),
    ("step beyond the stop", step(1.05, 0.1), "ends after the stopTime 1.1 s"),
    ("unknown category", categories(b"everything"), "", NATIVE),
    ("no category", categories(None), "", NATIVE),
    ("event mode", plain("EnterEventMode"), "", NATIVE),
    ("continuous time", plain("EnterContinuousTimeMode"), "", NATIVE),
    ("too few values", real("left.station", count=30), "30 values; these variables have 31", FMI3),
    ("too many values", real("left.station", count=40), "", FMI3),
    ("no values", real("lateral_shift", count=0), "", FMI3),
    ("values without references", lambda one: one.write("Float64", [], [1.0]), "", FMI3),
    ("reference zero", real(0), "", FMI3),
    ("time as Int32", typed("Integer", "time"), "", FMI3),
    ("time set", setting(time=1.0), "", FMI3),
    ("time as Boolean", typed("Boolean", "time", True), "", FMI3),
    ("another type", typed("Int64", "status"), "", FMI3),
    ("two texts", lambda one: one.read("String", references(one, ["load"]), 2), "", FMI3),
    ("configuration", plain("EnterConfigurationMode"), "", FMI3),
    ("step without room", plain("DoStep", 1.0, 1e-3, True, None, None, None, None), "", FMI3),
)
LAST = (
    ("step of no length", step(1.0, 0.0)),
    ("step of the smallest number", step(1.0, 5e-324)),
    ("step of a nanosecond", step(1.0, 1e-9)),
    ("step", step(1.0, 0.05)),
    ("last step", step(1.05, 0.05 + 1e-12)),
    ("terminate", plain("Terminate")),
    ("terminate twice", plain("Terminate"), ""),
    ("step, terminated", step(1.1, 0.0), "has been terminated"),
    ("set, terminated", setting(yaw=0.1), "yaw cannot be set"),
    ("output, terminated", getting("roll")),
    ("reset", plain("Reset")),
    ("enter again", lambda one: one.enter()),
    ("leave again", plain("ExitInitializationMode")),
    ("long step", step(0.0, 1e6)),
    ("earlier step", step(-3.0, 1.0)),
)
LIFE = (*NEW, *INITIALISING, *RUNNING, *LAST)


def of_states(one, other):
    """Calls with saved states that are freed, another's, or no state at all, and with bytes that are damaged."""
    mine, gone, theirs = one.take(), one.take(), other.take()
    saved, freed = one.pack(mine), c_void_p(gone.value)
    one.drop(gone)
    assert gone.value is None
    room, size = create_string_buffer(len(saved)), len(saved)

    def state(verb, *arguments):
        return lambda one: one.state(verb, *arguments)

    def unpacking(data):
        return lambda one: one.unpack(data)

    def damaged(place):
        return saved[:place] + bytes([saved[place] ^ 1]) + saved[place + 1 :]

    places = [0, 15, 16, 63, 64, 72, 80, *range(97, size, size // 12), size - 1]
    ends = (0, 1, 15, 64, size // 2, size - 1)
    return (
        ("freed", state("Set", freed), "saved state is not one of this instance"),
        ("freed, size", state("Size", freed, byref(c_size_t())), ""),
        ("freed, as bytes", state("Serialize", freed, room, size), ""),
        ("freed twice", state("Free", byref(c_void_p(freed.value))), ""),
        ("another's", state("Set", theirs), ""),
        ("another's, freed", state("Free", byref(c_void_p(theirs.value))), ""),
        ("none", state("Set", None), ""),
        ("nowhere", state("Set", c_void_p(NOWHERE)), ""),
        ("saved nowhere", state("Get", byref(c_void_p(NOWHERE))), ""),
        ("little room", state("Serialize", mine, room, size - 1), ""),
        ("no room", state("Serialize", mine, None, size), ""),
        ("no bytes", state("Deserialize", None, size, byref(c_void_p())), ""),
        *(
            (f"damaged at {place}", unpacking(damaged(place)), "comes from another FMU" * (place == 16))
            for place in places
        ),
        *((f"cut at {end}", unpacking(saved[:end]), "holds 64 bytes" * (end == 64)) for end in ends),
        ("too long", unpacking(saved + b"x"), ""),
    )


#: Modes of an instance for model exchange.
MODES = ("new", "initialising", "event", "continuous", "terminated")
#: Functions of model exchange and steps: the call, and the modes in which it is permitted.
EXCHANGE = {
    "enter event mode": (plain("EnterEventMode"), {"event", "continuous"}),
    "end event": (lambda one: one.update(), {"event"}),
    "enter continuous-time mode": (plain("EnterContinuousTimeMode"), {"event"}),
    "completed step": (lambda one: one.complete(), {"continuous"}),
    "time": (plain("SetTime", 0.5), {"event", "continuous"}),
    "time nan": (plain("SetTime", math.nan), set()),
    "step": (step(0.0, 1e-3), set()),
    "free_rolling": (setting(free_rolling=False), {"new", "initialising", "event"}),
    "free_rolling as it is": (setting(free_rolling=True), {"new", "initialising", "event", "continuous"}),
}
#: Lists of states and of event indicators, by version of FMI; those of none are permitted in all modes.
LISTS = {
    version: (
        "SetContinuousStates",
        "GetContinuousStates",
        derivatives,
        "GetNominalsOfContinuousStates",
        "GetEventIndicators",
    )
    for version, derivatives in ((2, "GetDerivatives"), (3, "GetContinuousStateDerivatives"))
}
COUNTED = {2: (), 3: ("GetNumberOfContinuousStates", "GetNumberOfEventIndicators")}


def of_exchange(version):
    """{name: (call, modes in which it is permitted)} of model exchange in a version of FMI."""
    numbers, found = create_string_buffer(24), dict(EXCHANGE)
    for name in LISTS[version]:
        found[f"{name} of none"] = plain(name, None, 0), set(MODES)
        found[f"{name} of one"] = plain(name, numbers, 1), set()
    return found | {
        name: (lambda one, name=name: counted(one, name), set(MODES)) for name in COUNTED[version]
    }


def counted(one, name):
    """There are no states and no event indicators."""
    found = c_size_t(7)
    one.call(name, byref(found))
    assert found.value == 0


def without_places(version):
    """Calls in event mode whose answers have no place."""
    place = create_string_buffer(64)

    def each(name, count, *arguments):
        return {
            f"{name}, {k}": plain(name, *arguments, *(None if k == i else place for i in range(count)))
            for k in range(count)
        }

    event = each("NewDiscreteStates", 1) if version == 2 else each("UpdateDiscreteStates", 6)
    return (
        event
        | {name: plain(name, None) for name in COUNTED[version]}
        | each("CompletedIntegratorStep", 2, True)
    )


#: The variable that a function's values have; there is one of it in its arguments.
TYPED = {"Integer": "status", "Int32": "status", "String": "load"}
#: Functions that do something; all others are refused, with whatever arguments.
THERE = {
    "GetVersion",
    "GetTypesPlatform",
    "FreeInstance",
    "SetDebugLogging",
    "SetupExperiment",
    "EnterInitializationMode",
    "ExitInitializationMode",
    "EnterConfigurationMode",
    "ExitConfigurationMode",
    "Terminate",
    "Reset",
    "DoStep",
    "GetRealStatus",
    "GetBooleanStatus",
    "GetDirectionalDerivative",
    "GetAdjointDerivative",
    *(
        f"{verb}{kind}"
        for verb in ("Get", "Set")
        for kind in ("Real", "Float64", "Integer", "Int32", "String")
    ),
    *(
        f"{verb}FMU{word}"
        for verb in ("Get", "Set", "Free", "Serialize", "DeSerialize", "Deserialize", "Serialized")
        for word in ("state", "State", "stateSize", "StateSize")
    ),
}


def with_room(fmu, name, types, none):
    """Arguments of a function behind the instance, with room for everything but the argument number ``none``."""
    variable = TYPED.get(name[3:], "lateral_shift")
    found = []
    for place, kind in enumerate(types[1:], 1):
        room = create_string_buffer(4096)
        c_uint32.from_buffer(room).value = fmu.references[variable]
        one = room if kind is c_void_p else 0.0 if kind is c_double else 1
        found.append(None if place == none else one)
    return found
