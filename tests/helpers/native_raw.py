"""Calls a native FMU's library as C does, past the checks of an importer's own wrappers, and prints what it saw as JSON.

    python native_raw.py <version of FMI> <library> <folder of FMI headers>     (JSON on standard input: "token", and the
                                                                                "references" of the variables by name)

Every answer is what one call returned, and the lines that it left in the log.
"""

import gc
import json
import math
import re
import sys
import threading
from ctypes import (CDLL, CFUNCTYPE, Structure, byref, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p, cast,
                    create_string_buffer, memmove)
from pathlib import Path

OK, ERROR = 0, 3
INPUTS = ("lateral_shift", "yaw", "roll_guess", "normal_force", "load_transfer", "vertical_shift_input", "roll_input")
NOWHERE = 0x10      # an address that nothing may look at


class Callbacks(Structure):
    """fmi2CallbackFunctions."""

    _fields_ = [(name, c_void_p) for name in ("logger", "allocate", "free", "finished", "environment")]


class Library:
    """The functions of one version of FMI under common names, and the log of all calls."""

    def __init__(self, version, file, token, references):
        self.version, self.token, self.references, self.log = version, token, references, []
        self.library = CDLL(file)
        if version == 2:
            self.note = CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)(
                lambda environment, name, status, category, line: self.log.append([name, category, line]))
        else:
            self.note = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)(
                lambda environment, status, category, line: self.log.append([None, category, line]))
        self.callbacks = Callbacks(cast(self.note, c_void_p))

    def function(self, name):
        found = getattr(self.library, f"fmi{self.version}{name}")
        found.restype = c_void_p if name.startswith("Instantiate") else None if name == "FreeInstance" else c_int
        return found

    def instantiate(self, name=b"instance", token=None, resources=None, logging=True, kind=1, callbacks=True):
        """A component, or None."""
        token = self.token.encode() if token is None else token or None
        if self.version == 2:
            return self.function("Instantiate")(name, c_int(kind), token, resources,
                                                byref(self.callbacks) if callbacks else None, c_int(0), c_int(logging))
        return self.function("InstantiateCoSimulation")(
            name, token, resources, c_bool(False), c_bool(logging), c_bool(False), c_bool(False), None, c_size_t(0), None,
            self.note if callbacks else None, None)

    def enter(self, c, start=0.0, stop=None):
        experiment = c_double(start), c_int(stop is not None), c_double(stop or 0.0)
        if self.version == 3:
            return self.function("EnterInitializationMode")(c_void_p(c), c_int(0), c_double(0.0), *experiment)
        return (self.function("SetupExperiment")(c_void_p(c), c_int(0), c_double(0.0), *experiment)
                or self.function("EnterInitializationMode")(c_void_p(c)))

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
        results = () if self.version == 2 else (byref(c_bool()), byref(c_bool()), byref(c_bool()), byref(c_double()))
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
        name = {"Deserialize": "DeSerialize"}.get(verb, verb) + "FMUstate" if self.version == 2 else verb + "FMUState"
        name = f"Serialized{name.removeprefix('Size')}Size" if verb == "Size" else name
        return self.function(name)(c_void_p(c), *arguments)

    def told(self):
        lines, self.log[:] = [[part if part is None else part.decode() for part in line] for line in self.log], []
        return lines


WORK = ("lateral_shift", "roll", "vertical_shift", "right.penetration", "left.area", "right.max_pressure")


def run(fmi, c):
    """Bits of a short run."""
    seen = []
    for shift in (1e-3, 4e-3, 7e-3):
        assert fmi.set(c, lateral_shift=shift, yaw=2e-3, normal_force=8e4) == OK and fmi.step(c) == OK
        seen += fmi.get(c, *WORK)
    return [value.hex() for value in seen]


def check_run(fmi, c, wanted):
    """Whether a component works as a fresh one, after a reset."""
    assert fmi.plain("Reset", c) == OK and fmi.enter(c) == OK and fmi.plain("ExitInitializationMode", c) == OK
    return run(fmi, c) == wanted


# --- NULL pointers ------------------------------------------------------------------------------------------


def signatures(version, headers):
    """[(function, types of its arguments)] of the standard's header: p pointer, d number, i anything else."""
    functions = Path(headers, f"fmi{version}Functions.h").read_text()
    types = re.sub(r"/\*.*?\*/", " ", Path(headers, f"fmi{version}FunctionTypes.h").read_text(), flags=re.DOTALL)
    found = []
    for name in re.findall(rf"^ *FMI{version}_Export fmi{version}\w+TYPE +fmi{version}(\w+);", functions, re.MULTILINE):
        arguments = re.search(rf"typedef\s+[\w ]+\*?\s+fmi{version}{name}TYPE\s*\(([^)]*)\)", types)[1].split(",")
        found.append((name, "".join(kind_of(argument) for argument in arguments if argument.strip() != "void")))
    return found


def kind_of(argument):
    pointers = r"[*\[]|fmi2Component|fmi3Instance|fmi\dFMU[sS]tate|fmi\dString|Callback"
    return "p" if re.search(pointers, argument) else "d" if re.search(r"fmi2Real|fmi3Float64", argument) else "i"


#: The variable that a function's values have; there is one of it in its arguments.
TYPED = {"GetInteger": "status", "SetInteger": "status", "GetInt32": "status", "SetInt32": "status", "GetString": "load",
         "SetString": "load"}


def null_pointers(fmi, headers):
    """Every function without a component, and without each of its other pointers in turn."""
    c = fmi.ready()
    wanted = run(fmi, c)
    fmi.told()
    answers, skipped = {}, ("GetVersion", "GetTypesPlatform", "FreeInstance")
    for name, kinds in signatures(fmi.version, headers):
        if name in skipped or name.startswith("Instantiate"):
            continue
        answers[f"{name}, no component"] = call(fmi, name, None, kinds, "lateral_shift", none=0)
        for place in (k for k, kind in enumerate(kinds) if kind == "p" and k > 0):
            answers[f"{name}, {place}"] = call(fmi, name, c, kinds, TYPED.get(name, "lateral_shift"), none=place)
    fmi.function("FreeInstance")(None)
    refused = {name: call(fmi, name, c, kinds, "lateral_shift", none=-1) for name, kinds in signatures(fmi.version, headers)
               if name not in THERE and not name.startswith("Instantiate")}
    return {"answers": answers, "refused": refused, "after": check_run(fmi, c, wanted)}


#: Functions that do something; all others are refused, with whatever arguments.
THERE = {"GetVersion", "GetTypesPlatform", "FreeInstance", "SetDebugLogging", "SetupExperiment", "EnterInitializationMode",
         "ExitInitializationMode", "Terminate", "Reset", "DoStep", "GetReal", "SetReal", "GetInteger", "SetInteger", "GetString",
         "SetString", "GetFloat64", "SetFloat64", "GetInt32", "SetInt32", "GetRealStatus", "GetBooleanStatus",
         *(f"{verb}FMU{word}" for verb in ("Get", "Set", "Free", "Serialize", "DeSerialize", "Deserialize", "Serialized")
           for word in ("state", "State", "stateSize", "StateSize")),
         "GetDirectionalDerivative", "GetAdjointDerivative", "EnterConfigurationMode", "ExitConfigurationMode"}


def call(fmi, name, c, kinds, variable, none):
    """One call with room for everything but the argument number `none`."""
    buffers = [create_string_buffer(4096) for _ in kinds]
    for buffer in buffers:
        c_uint32.from_buffer(buffer).value = fmi.references[variable]
    arguments = [None if k == none else buffers[k] if kind == "p" else c_double(0.0) if kind == "d" else c_size_t(1)
                 for k, kind in enumerate(kinds)]
    arguments[0] = None if c is None else c_void_p(c)
    return fmi.function(name)(*arguments), fmi.told()


# --- bad input ----------------------------------------------------------------------------------------------


def switch(fmi, c, on, *names):
    """Turn log categories on or off."""
    words = (c_char_p * max(1, len(names)))(*names)
    return fmi.function("SetDebugLogging")(c_void_p(c), c_int(on), c_size_t(len(names)), words)


def bad_input(fmi):
    """Each misuse on a component that is ready, and what it is worth afterwards."""
    c, other = fmi.ready(), fmi.ready()
    wanted = run(fmi, c)
    reference = fmi.references
    two, one = (c_double * 2)(2e-3, 1.0), (c_double * 1)(1.0)
    text, whole = (c_char_p * 1)(b"vertical"), (c_int * 1)(1)
    get, put = fmi.real("Get"), fmi.real("Set")
    cases = {
        "unknown reference": lambda: fmi.values(get, c, [4711], one),
        "unknown reference set": lambda: fmi.values(put, c, [4711], one),
        "largest reference": lambda: fmi.values(get, c, [0xFFFFFFFF], one),
        "Integer as Real": lambda: fmi.values(get, c, [reference["status"]], one),
        "String as Real": lambda: fmi.values(put, c, [reference["load"]], one),
        "Real as Integer": lambda: fmi.values(fmi.integer("Get"), c, [reference["roll"]], whole),
        "Real as String": lambda: fmi.values("GetString", c, [reference["gauge"]], text),
        "Real as String set": lambda: fmi.values("SetString", c, [reference["gauge"]], text),
        "Boolean": lambda: fmi.values("GetBoolean", c, [reference["roll"]], whole),
        "output": lambda: fmi.set(c, roll=1.0),
        "Integer output": lambda: fmi.values(fmi.integer("Set"), c, [reference["status"]], whole),
        "fixed Real": lambda: fmi.set(c, gauge=1.5),
        "fixed Real nan": lambda: fmi.set(c, gauge=math.nan),
        "fixed String": lambda: fmi.set_text(c, "load", b"vertical"),
        "fixed String with signs": lambda: fmi.set_text(c, "load", b"%s%n%%d"),
        "String without letters": lambda: fmi.set_text(c, "load", None),
        "long String": lambda: fmi.set_text(c, "load", b"x" * 5000),
        "half a list": lambda: fmi.values(put, c, [reference["lateral_shift"], reference["roll"]], two),
        "step of -1 s": lambda: fmi.step(c, 0.0, -1.0),
        "step of nan": lambda: fmi.step(c, 0.0, math.nan),
        "step of inf": lambda: fmi.step(c, 0.0, math.inf),
        "step at nan": lambda: fmi.step(c, math.nan),
        "step beyond numbers": lambda: fmi.step(c, 1e308, 1e308),
        "initialised twice": lambda: fmi.enter(c),
        "left twice": lambda: fmi.plain("ExitInitializationMode", c),
        "category": lambda: switch(fmi, c, 1, b"everything"),
        "no category": lambda: switch(fmi, c, 1, None),
        "events": lambda: fmi.plain("EnterEventMode", c),
        "continuous time": lambda: fmi.plain("EnterContinuousTimeMode", c),
    }
    if fmi.version == 2:
        cases["set up twice"] = lambda: fmi.function("SetupExperiment")(
            c_void_p(c), c_int(0), c_double(0.0), c_double(0.0), c_int(0), c_double(0.0))
    else:
        cases |= {
            "too few values": lambda: fmi.values(get, c, [reference["left.station"]], (c_double * 40)(), 30),
            "too many values": lambda: fmi.values(get, c, [reference["left.station"]], (c_double * 40)(), 40),
            "no values": lambda: fmi.values(get, c, [reference["lateral_shift"]], one, 0),
            "values without references": lambda: fmi.values(put, c, [], one, 1),
            "two texts": lambda: fmi.values("GetString", c, [reference["load"]], (c_char_p * 2)(), 2),
            "step without room": lambda: fmi.function("DoStep")(c_void_p(c), c_double(0.0), c_double(1.0), c_int(1), None, None,
                                                               None, None),
        }
    cases |= {f"state: {name}": case for name, case in state_cases(fmi, c, other).items()}
    before = fmi.get(c, *WORK)
    fmi.told()
    answers = {}
    for name, case in cases.items():
        answers[name] = case(), fmi.told(), fmi.get(c, *WORK) == before
    good = run(fmi, c) == wanted
    fmi.free(other)
    return {"answers": answers, "good_inputs_after": good, "after_a_reset": check_run(fmi, c, wanted)}


def state_cases(fmi, c, other):
    """Saved states that are freed, another's, or no state at all, and bytes that are damaged."""
    mine, gone, theirs, size = c_void_p(), c_void_p(), c_void_p(), c_size_t()
    for component, place in ((c, mine), (c, gone), (other, theirs)):
        assert fmi.state("Get", component, byref(place)) == OK
    assert fmi.state("Size", c, mine, byref(size)) == OK
    saved = create_string_buffer(size.value)
    assert fmi.state("Serialize", c, mine, saved, size) == OK
    freed = c_void_p(gone.value)
    assert fmi.state("Free", c, byref(gone)) == OK and gone.value is None

    def take(data):
        made = c_void_p()
        status = fmi.state("Deserialize", c, data, c_size_t(len(data)), byref(made))
        assert (status == OK) == bool(made.value)
        return status

    def damaged(place):
        return saved.raw[:place] + bytes([saved.raw[place] ^ 1]) + saved.raw[place + 1:]

    places = [0, 15, 16, 63, 64, 72, 80, *range(97, size.value, size.value // 12), size.value - 1]
    ends = (0, 1, 15, 64, size.value // 2, size.value - 1)
    return {
        "freed": lambda: fmi.state("Set", c, freed),
        "freed, size": lambda: fmi.state("Size", c, freed, byref(c_size_t())),
        "freed, as bytes": lambda: fmi.state("Serialize", c, freed, create_string_buffer(size.value), size),
        "freed twice": lambda: fmi.state("Free", c, byref(c_void_p(freed.value))),
        "another's": lambda: fmi.state("Set", c, theirs),
        "another's, freed": lambda: fmi.state("Free", c, byref(c_void_p(theirs.value))),
        "none": lambda: fmi.state("Set", c, None),
        "nowhere": lambda: fmi.state("Set", c, c_void_p(NOWHERE)),
        "saved nowhere": lambda: fmi.state("Get", c, byref(c_void_p(NOWHERE))),
        "little room": lambda: fmi.state("Serialize", c, mine, saved, c_size_t(size.value - 1)),
        "no room": lambda: fmi.state("Serialize", c, mine, None, size),
        "no bytes": lambda: fmi.state("Deserialize", c, None, size, byref(c_void_p())),
        **{f"damaged at {place}": lambda place=place: take(damaged(place)) for place in places},
        **{f"cut at {end}": lambda end=end: take(saved.raw[:end]) for end in ends},
        "too long": lambda: take(saved.raw + b"x"),
    }


def every_input(fmi):
    """Numbers that are none, in every input: the status, whether outputs are kept, the lines, and the recovery."""
    c = fmi.ready()
    wanted = run(fmi, c)
    answers = {}
    for name in INPUTS:
        for value in (math.nan, math.inf, -math.inf):
            fmi.told()
            kept = fmi.get(c, "roll", "right.penetration", "left.area")
            accepted = fmi.set(c, **{name: value}), fmi.step(c)
            answers[f"{name} {value}"] = {
                "calls": accepted, "status": fmi.outcome(c), "lines": fmi.told(),
                "kept": fmi.get(c, "roll", "right.penetration", "left.area") == kept}
            assert fmi.set(c, **dict.fromkeys(INPUTS, 0.0)) == OK
            answers[f"{name} {value}"]["again"] = run(fmi, c) == wanted and fmi.outcome(c) == 0
    return answers


def order(fmi):
    """Calls before and after their time; then a component is reset and works."""
    c, wanted = fmi.instantiate(), run(fmi, fmi.ready())
    fmi.told()
    answers = {
        "step before": (fmi.step(c), fmi.told()),
        "output before": (fmi.get(c, "roll"), fmi.told()),
        "status before": (fmi.outcome(c), fmi.told()),
        "leave before": (fmi.plain("ExitInitializationMode", c), fmi.told()),
        "terminate before": (fmi.plain("Terminate", c), fmi.told()),
        "start nan": (fmi.enter(c, math.nan), fmi.told()),
        "stop before start": (fmi.enter(c, 1.0, 0.5), fmi.told()),
        "stop nan": (fmi.enter(c, 1.0, math.nan), fmi.told()),
    }
    input_before = fmi.get(c, "lateral_shift", "gauge")
    assert fmi.enter(c, 1.0, 1.1) == OK
    answers["step inside"] = fmi.step(c), fmi.told()
    answers["terminate inside"] = fmi.plain("Terminate", c), fmi.told()
    inside = fmi.get(c, "roll"), fmi.set(c, gauge=1.435), fmi.plain("ExitInitializationMode", c)
    sizes = [fmi.step(c, 1.0, size) for size in (0.0, 5e-324, 1e-9, 0.05, 0.1, 0.1 + 1e-12)]
    answers["beyond the stop"] = fmi.step(c, 1.05, 0.1), fmi.told()
    last = last_time(fmi, c)
    at_the_end = fmi.step(c, 1.05, 0.05), fmi.plain("Terminate", c), fmi.get(c, "lateral_shift")
    answers |= {
        "step after": (fmi.step(c), fmi.told()),
        "set after": (fmi.set(c, yaw=0.1), fmi.told()),
        "terminate after": (fmi.plain("Terminate", c), fmi.told()),
    }
    long_steps = fmi.ready()
    sizes += [fmi.step(long_steps, time, size) for time, size in ((0.0, 1e6), (-3.0, 1.0), (7.0, 0.0))]
    return {"answers": answers, "input_before": input_before, "inside": inside, "sizes": sizes, "at_the_end": at_the_end,
            "last": last, "after": check_run(fmi, c, wanted)}


def last_time(fmi, c):
    """Where the last step has ended, as each version tells it."""
    found = (c_double * 1)()
    if fmi.version == 3:
        assert fmi.values("GetFloat64", c, [fmi.references["time"]], found) == OK
    else:
        last_successful = 2
        assert fmi.function("GetRealStatus")(c_void_p(c), c_int(last_successful), found) == OK
    return found[0]


def legal(fmi):
    """Values read ahead of the step, and states saved in one phase and set in another."""
    c, wanted = fmi.ready(), run(fmi, fmi.ready())
    assert fmi.set(c, lateral_shift=4e-3) == OK
    ahead = fmi.get(c, "roll")
    assert fmi.step(c) == OK
    answers = {}
    for saved in PHASES:
        for present in PHASES:
            one = brought_to(fmi, saved)
            state, size = c_void_p(), c_size_t()
            assert fmi.state("Get", one, byref(state)) == OK and fmi.state("Size", one, state, byref(size)) == OK
            data = create_string_buffer(size.value)
            assert fmi.state("Serialize", one, state, data, size) == OK
            other, taken = brought_to(fmi, present), c_void_p()
            assert fmi.state("Deserialize", other, data, size, byref(taken)) == OK and fmi.state("Set", other, taken) == OK
            answers[f"{saved} into {present}"] = goes_on(fmi, other, saved) == wanted
            fmi.free(one), fmi.free(other)
    return {"ahead": ahead, "then": fmi.get(c, "roll"), "phases": answers}


PHASES = ("new", "initialising", "running", "terminated")


def brought_to(fmi, phase):
    """A component in a phase of its life."""
    c = fmi.instantiate()
    calls = fmi.enter, *(lambda c, name=name: fmi.plain(name, c) for name in ("ExitInitializationMode", "Terminate"))
    for call in calls[:PHASES.index(phase)]:
        assert call(c) == OK
    return c


def goes_on(fmi, c, phase):
    """Bits of a run from a phase on."""
    if phase == "new":
        assert fmi.enter(c) == OK
    if phase in ("new", "initialising"):
        assert fmi.plain("ExitInitializationMode", c) == OK
    if phase == "terminated":
        assert fmi.step(c) == ERROR and fmi.plain("Reset", c) == OK
        return goes_on(fmi, c, "new")
    return run(fmi, c)


def creation(fmi):
    """Instances that cannot be made, and some that can with odd arguments."""
    refused = {
        "empty name": {"name": b""}, "no name": {"name": None}, "wrong token": {"token": b"{0}"}, "no token": {"token": b""},
        **({"model exchange": {"kind": 0}} if fmi.version == 2 else {}),
    }
    answers = {name: (fmi.instantiate(**options), fmi.told()) for name, options in refused.items()}
    wanted = run(fmi, fmi.ready())
    places = (None, b"", b"/nowhere/at all", "file:///R\u00e4der & Schienen/\u8f6e\u8f68".encode(), b"%s%n", b"x" * 5000)
    odd = {f"resources {place!r:.30}": {"resources": place} for place in places}
    odd |= {"other letters": {"name": "Radsatz \u00e4 \u8f6e\u5bf9 %s".encode()}, "long name": {"name": b"x" * 5000},
            "silent": {"logging": False}}
    made = {}
    for name, options in odd.items():
        c = fmi.ready(**options)
        fmi.told()
        fmi.step(c, 0.0, -1.0)
        made[name] = run(fmi, c) == wanted, fmi.told()
        fmi.free(c)
    silent = fmi.instantiate(callbacks=False)       # FMI 2 cannot do without the callbacks, FMI 3 can
    return {"refused": answers, "made": made, "without_log": bool(silent) and check_run(fmi, silent, wanted)}


def categories(fmi):
    """Lines of a step with a status and of a call that fails, by what has been switched on."""
    c = fmi.ready()
    fmi.told()

    def lines():
        assert fmi.set(c, lateral_shift=math.nan) == OK and fmi.step(c) == OK and fmi.step(c, 0.0, -1.0) == ERROR
        assert fmi.set(c, lateral_shift=0.0) == OK and fmi.step(c) == OK
        return [category for _, category, _ in fmi.told()]

    def after(on, *names):
        return switch(fmi, c, on, *names), len(fmi.told()), lines()

    return {"first": lines(), "all off": after(0), "warnings on": after(1, b"logStatusWarning"),
            "unknown": after(0, b"logStatusWarning", b"logAll"), "errors on, too": after(1, b"logStatusError"),
            "warnings off": after(0, b"logStatusWarning"), "all on": after(1)}


# --- instances, threads, memory -------------------------------------------------------------------------------


def threads(fmi, count=4, rounds=40):
    """Bits of runs in threads; calls through ctypes leave Python's lock, so they run at once."""
    alone = [run(fmi, fmi.ready()) for _ in range(rounds)]
    found = [[] for _ in range(count)]

    def work(seen):
        c = fmi.ready()
        seen.extend(run(fmi, c) for _ in range(rounds))
        fmi.free(c)

    running = [threading.Thread(target=work, args=(seen,)) for seen in found]
    [thread.start() for thread in running]
    [thread.join() for thread in running]
    return {"equal": [[one == two for one, two in zip(seen, alone, strict=True)] for seen in found]}


def memory(fmi, rounds=300):
    """Growth of the process [bytes] over instances that are made, misused, and freed with states that nobody has freed."""
    if sys.platform != "linux":
        return {}

    def resident():
        gc.collect()
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096

    def use():
        for arguments in ({}, {"name": b""}, {"token": b"{0}"}):
            c = fmi.instantiate(**arguments)
            if c is None:
                continue
            fmi.set_text(c, "wheel_profile", b"nothing")
            assert fmi.enter(c) == ERROR and fmi.plain("Reset", c) == OK and fmi.enter(c) == OK
            assert fmi.plain("ExitInitializationMode", c) == OK
            state, size = c_void_p(), c_size_t()
            for _ in range(3):
                state.value = None
                assert fmi.state("Get", c, byref(state)) == OK
            assert fmi.state("Size", c, state, byref(size)) == OK
            data = create_string_buffer(size.value)
            assert fmi.state("Serialize", c, state, data, size) == OK
            assert fmi.state("Deserialize", c, data, size, byref(c_void_p())) == OK
            memmove(data, b"x", 1)
            assert fmi.state("Deserialize", c, data, size, byref(c_void_p())) == ERROR
            fmi.free(c)
        fmi.told()

    for _ in range(50):
        use()
    before = resident()
    for _ in range(rounds):
        use()
    return {"growth": resident() - before}


if __name__ == "__main__":
    fmi_version, library_file, header_folder = sys.argv[1:]
    given = json.load(sys.stdin)
    library = Library(int(fmi_version), library_file, given["token"], given["references"])
    parts = (bad_input, every_input, order, legal, creation, categories, threads, memory)
    found = {}
    for part in parts:
        found[part.__name__] = part(library)
        library.told()
    print(json.dumps({**found, "null_pointers": null_pointers(library, header_folder)}), flush=True)
