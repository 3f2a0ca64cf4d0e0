"""Wrong calls of native_raw.py: values, states, order."""

import math
from ctypes import byref, c_bool, c_char_p, c_double, c_int, c_int64, c_size_t, c_void_p, create_string_buffer

from raw_library import NOWHERE, OK, WORK, check_run, run, switch


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
        "fixed Boolean": lambda: fmi.values(
            "SetBoolean",
            c,
            [reference["independent_wheels"]],
            ((c_int if fmi.version == 2 else c_bool) * 1)(1),
        ),
        "fixed String": lambda: fmi.set_text(c, "load", b"vertical"),
        "fixed String with signs": lambda: fmi.set_text(c, "load", b"%s%n%%d #7"),
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
            c_void_p(c), c_int(0), c_double(0.0), c_double(0.0), c_int(0), c_double(0.0)
        )
    else:
        cases |= {
            "too few values": lambda: fmi.values(get, c, [reference["left.station"]], (c_double * 40)(), 30),
            "too many values": lambda: fmi.values(get, c, [reference["left.station"]], (c_double * 40)(), 40),
            "reference zero": lambda: fmi.values(get, c, [0], one),
            "time as Int32": lambda: fmi.values("GetInt32", c, [reference["time"]], whole),
            "time set": lambda: fmi.values(put, c, [reference["time"]], one),
            "Boolean set": lambda: fmi.values("SetBoolean", c, [reference["time"]], (c_bool * 1)(True)),
            "another type": lambda: fmi.values("GetInt64", c, [reference["status"]], (c_int64 * 1)()),
            "configuration": lambda: fmi.plain("EnterConfigurationMode", c),
            "no values": lambda: fmi.values(get, c, [reference["lateral_shift"]], one, 0),
            "values without references": lambda: fmi.values(put, c, [], one, 1),
            "two texts": lambda: fmi.values("GetString", c, [reference["load"]], (c_char_p * 2)(), 2),
            "step without room": lambda: fmi.function("DoStep")(
                c_void_p(c), c_double(0.0), c_double(1.0), c_int(1), None, None, None, None
            ),
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
        return saved.raw[:place] + bytes([saved.raw[place] ^ 1]) + saved.raw[place + 1 :]

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
    """Numbers that are none, in every input: the status, whether outputs are kept,
    the lines, and the recovery."""
    c = fmi.ready()
    wanted = run(fmi, c)
    answers = {}
    for name in fmi.inputs:
        for value in (math.nan, math.inf, -math.inf):
            fmi.told()
            kept = fmi.get(c, "roll", "right.penetration", "left.area")
            accepted = fmi.set(c, **{name: value}), fmi.step(c)
            answers[f"{name} {value}"] = {
                "calls": accepted,
                "status": fmi.outcome(c),
                "lines": fmi.told(),
                "kept": fmi.get(c, "roll", "right.penetration", "left.area") == kept,
            }
            assert fmi.set(c, **dict.fromkeys(fmi.inputs, 0.0)) == OK
            answers[f"{name} {value}"]["again"] = run(fmi, c) == wanted and fmi.outcome(c) == 0
    return answers


def order(fmi):
    """Sizes of steps up to the stopTime, the end of the last one, and what is possible after it; then a
    component is reset and works."""
    c, wanted = fmi.instantiate(), run(fmi, fmi.ready())
    assert fmi.enter(c, 1.0, 1.1) == OK and fmi.plain("ExitInitializationMode", c) == OK
    sizes = [fmi.step(c, 1.0, size) for size in (0.0, 5e-324, 1e-9, 0.05, 0.1, 0.1 + 1e-12)]
    last = last_time(fmi, c)
    at_the_end = fmi.step(c, 1.05, 0.05), fmi.plain("Terminate", c), fmi.get(c, "lateral_shift")
    long_steps = fmi.ready()
    sizes += [fmi.step(long_steps, time, size) for time, size in ((0.0, 1e6), (-3.0, 1.0), (7.0, 0.0))]
    return {"sizes": sizes, "at_the_end": at_the_end, "last": last, "after": check_run(fmi, c, wanted)}


def last_time(fmi, c):
    """Where the last step has ended, as each version tells it."""
    found = (c_double * 1)()
    if fmi.version == 3:
        assert fmi.values("GetFloat64", c, [fmi.references["time"]], found) == OK
    else:
        last_successful = 2
        assert fmi.function("GetRealStatus")(c_void_p(c), c_int(last_successful), found) == OK
    return found[0]
