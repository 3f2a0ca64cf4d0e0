"""Model exchange of native_raw.py: which function is permitted in which mode, lists of states, pointers that
are none."""

from ctypes import byref, c_bool, c_double, c_int, c_size_t, c_void_p, create_string_buffer

from raw_library import ERROR, OK, run

MODES = ("new", "initialising", "event", "continuous", "terminated")


def exchange_modes(fmi):
    """The outcome and the lines of each function of model exchange, by its name and the mode in which it is
    called; and of the same in co-simulation."""
    answers = {
        f"{name}, {mode}": (call(c), fmi.told())
        for name, call in calls(fmi).items()
        for mode in MODES
        for c in [brought_to(fmi, mode)]
    }
    steps = {name: (call(c), fmi.told()) for name, call in calls(fmi).items() for c in [fmi.ready()]}
    wanted, c = run(fmi, fmi.ready()), brought_to(fmi, "continuous")
    assert fmi.set(c, lateral_shift=3e-3) == OK
    return {
        "exchange": answers,
        "steps": steps,
        "reset": fmi.plain("Reset", c) == OK,
        "again": same_run(fmi, c, wanted),
    }


def brought_to(fmi, mode):
    """A component for model exchange in a mode of its life."""
    c, place = fmi.instantiate(kind=0), MODES.index(mode)
    assert c
    if place >= 1:
        assert fmi.enter(c) == OK
    if place >= 2:
        assert fmi.plain("ExitInitializationMode", c) == OK
    if place >= 3:
        assert fmi.plain("EnterContinuousTimeMode", c) == OK
    if place >= 4:
        assert fmi.plain("Terminate", c) == OK
    fmi.told()
    return c


def same_run(fmi, c, wanted):
    """Whether a component for model exchange that has been reset gives the bits of a run in co-simulation."""
    assert fmi.enter(c) == OK and fmi.plain("ExitInitializationMode", c) == OK
    assert fmi.plain("EnterContinuousTimeMode", c) == OK
    return run(fmi, c, steps=False) == wanted


def events(fmi, c):
    """The function that ends an event: its status, or a word if it wants something."""
    if fmi.version == 2:
        place = create_string_buffer(b"\xff" * 64)
        status = fmi.function("NewDiscreteStates")(c_void_p(c), place)
        return status if status or not any(place.raw[:20]) else "wants something"
    flags = [c_bool(True) for _ in range(5)]
    status = fmi.function("UpdateDiscreteStates")(c_void_p(c), *map(byref, flags), byref(c_double()))
    return status if status or not any(flag.value for flag in flags) else "wants something"


def completed(fmi, c):
    """A completed step of the solver, after which nothing is wanted."""
    flags = [c_int(-1) if fmi.version == 2 else c_bool(True) for _ in range(2)]
    status = fmi.function("CompletedIntegratorStep")(c_void_p(c), c_int(1), *map(byref, flags))
    return status if status or not any(flag.value for flag in flags) else "wants something"


def calls(fmi):
    """The functions of model exchange, and steps, by name."""
    numbers, boolean = (c_double * 3)(), (c_int if fmi.version == 2 else c_bool) * 1
    found = {
        "enter event mode": lambda c: fmi.plain("EnterEventMode", c),
        "end event": lambda c: events(fmi, c),
        "enter continuous-time mode": lambda c: fmi.plain("EnterContinuousTimeMode", c),
        "completed step": lambda c: completed(fmi, c),
        "time": lambda c: fmi.function("SetTime")(c_void_p(c), c_double(0.5)),
        "time nan": lambda c: fmi.function("SetTime")(c_void_p(c), c_double(float("nan"))),
        "step": lambda c: fmi.step(c),
        "free_rolling": lambda c: fmi.values("SetBoolean", c, [fmi.references["free_rolling"]], boolean(0)),
        "free_rolling as it is": lambda c: fmi.values(
            "SetBoolean", c, [fmi.references["free_rolling"]], boolean(1)
        ),
    }
    derivatives = "GetDerivatives" if fmi.version == 2 else "GetContinuousStateDerivatives"
    for name in (
        "SetContinuousStates",
        "GetContinuousStates",
        derivatives,
        "GetNominalsOfContinuousStates",
        "GetEventIndicators",
    ):
        function = fmi.function(name)
        found[f"{name} of none"] = lambda c, function=function: function(c_void_p(c), None, c_size_t(0))
        found[f"{name} of one"] = lambda c, function=function: function(c_void_p(c), numbers, c_size_t(1))
    for name in ("ContinuousStates", "EventIndicators") if fmi.version == 3 else ():
        found[f"number of {name}"] = lambda c, name=name: number(fmi, name, c)
    return found


def number(fmi, name, c):
    """Of states or event indicators: the outcome, or a word if there are any."""
    found = c_size_t(7)
    status = fmi.function(f"GetNumberOf{name}")(c_void_p(c), byref(found))
    return status if status or found.value == 0 else "there are some"


def exchange_pointers(fmi):
    """Answers that have no place: an error and a sentence, and a component that works."""
    wanted, c = run(fmi, fmi.ready()), brought_to(fmi, "event")
    place = create_string_buffer(64)
    cases = {"end event": lambda: fmi.function("NewDiscreteStates")(c_void_p(c), None)}
    if fmi.version == 3:
        cases = {
            f"end event, {k}": lambda k=k: fmi.function("UpdateDiscreteStates")(
                c_void_p(c), *(None if k == i else place for i in range(6))
            )
            for k in range(6)
        }
        cases |= {
            f"number of {name}": lambda name=name: fmi.function(f"GetNumberOf{name}")(c_void_p(c), None)
            for name in ("ContinuousStates", "EventIndicators")
        }
    cases |= {
        f"completed step, {k}": lambda k=k: fmi.function("CompletedIntegratorStep")(
            c_void_p(c), c_int(1), *(None if k == i else place for i in range(2))
        )
        for k in range(2)
    }
    answers = {name: (case(), fmi.told()) for name, case in cases.items()}
    without = [fmi.function(name)(None) for name in ("EnterEventMode", "EnterContinuousTimeMode")]
    assert without == [ERROR, ERROR]
    assert fmi.plain("EnterContinuousTimeMode", c) == OK
    return {"answers": answers, "after": run(fmi, c, steps=False) == wanted}
