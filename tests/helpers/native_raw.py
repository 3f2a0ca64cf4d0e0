"""Calls a native FMU's library as C does, past the checks of an importer's own wrappers, and
prints what it saw as JSON.

    python native_raw.py <version of FMI> <library> <folder of FMI headers> (JSON on standard input: "token",
                                                                                the "references" of variables by
                                                                                name, and the Real "inputs")

Every answer is what one call returned, and the lines that it left in the log.
"""

import json
import math
import re
import sys
from ctypes import byref, c_double, c_size_t, c_uint32, c_void_p, create_string_buffer
from pathlib import Path

from raw_bad_input import bad_input, every_input, order
from raw_exchange import exchange_modes, exchange_pointers
from raw_library import ERROR, OK, Library, check_run, run, switch


def signatures(version, headers):
    """[(function, types of its arguments)] of the standard's header: p pointer, d number, i anything else."""
    functions = Path(headers, f"fmi{version}Functions.h").read_text()
    types = re.sub(
        r"/\*.*?\*/", " ", Path(headers, f"fmi{version}FunctionTypes.h").read_text(), flags=re.DOTALL
    )
    found = []
    for name in re.findall(
        rf"^ *FMI{version}_Export fmi{version}\w+TYPE +fmi{version}(\w+);", functions, re.MULTILINE
    ):
        arguments = re.search(rf"typedef\s+[\w ]+\*?\s+fmi{version}{name}TYPE\s*\(([^)]*)\)", types)[1].split(
            ","
        )
        found.append(
            (name, "".join(kind_of(argument) for argument in arguments if argument.strip() != "void"))
        )
    return found


def kind_of(argument):
    pointers = r"[*\[]|fmi2Component|fmi3Instance|fmi\dFMU[sS]tate|fmi\dString|Callback"
    return (
        "p" if re.search(pointers, argument) else "d" if re.search(r"fmi2Real|fmi3Float64", argument) else "i"
    )


#: The variable that a function's values have; there is one of it in its arguments.
TYPED = {
    "GetInteger": "status",
    "SetInteger": "status",
    "GetInt32": "status",
    "SetInt32": "status",
    "GetString": "load",
    "SetString": "load",
}


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
            answers[f"{name}, {place}"] = call(
                fmi, name, c, kinds, TYPED.get(name, "lateral_shift"), none=place
            )
    fmi.function("FreeInstance")(None)
    refused = {
        name: call(fmi, name, c, kinds, "lateral_shift", none=-1)
        for name, kinds in signatures(fmi.version, headers)
        if name not in THERE and not name.startswith("Instantiate")
    }
    return {"answers": answers, "refused": refused, "after": check_run(fmi, c, wanted)}


#: Functions that do something; all others are refused, with whatever arguments.
THERE = {
    "GetVersion",
    "GetTypesPlatform",
    "FreeInstance",
    "SetDebugLogging",
    "SetupExperiment",
    "EnterInitializationMode",
    "ExitInitializationMode",
    "Terminate",
    "Reset",
    "DoStep",
    "GetReal",
    "SetReal",
    "GetInteger",
    "SetInteger",
    "GetString",
    "SetString",
    "GetFloat64",
    "SetFloat64",
    "GetInt32",
    "SetInt32",
    "GetRealStatus",
    "GetBooleanStatus",
    *(
        f"{verb}FMU{word}"
        for verb in ("Get", "Set", "Free", "Serialize", "DeSerialize", "Deserialize", "Serialized")
        for word in ("state", "State", "stateSize", "StateSize")
    ),
    "GetDirectionalDerivative",
    "GetAdjointDerivative",
    "EnterConfigurationMode",
    "ExitConfigurationMode",
}


def call(fmi, name, c, kinds, variable, none):
    """One call with room for everything but the argument number `none`."""
    buffers = [create_string_buffer(4096) for _ in kinds]
    for buffer in buffers:
        c_uint32.from_buffer(buffer).value = fmi.references[variable]
    arguments = [
        None if k == none else buffers[k] if kind == "p" else c_double(0.0) if kind == "d" else c_size_t(1)
        for k, kind in enumerate(kinds)
    ]
    arguments[0] = None if c is None else c_void_p(c)
    return fmi.function(name)(*arguments), fmi.told()


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
            assert fmi.state("Get", one, byref(state)) == OK
            assert fmi.state("Size", one, state, byref(size)) == OK
            data = create_string_buffer(size.value)
            assert fmi.state("Serialize", one, state, data, size) == OK
            other, taken = brought_to(fmi, present), c_void_p()
            assert fmi.state("Deserialize", other, data, size, byref(taken)) == OK
            assert fmi.state("Set", other, taken) == OK
            answers[f"{saved} into {present}"] = goes_on(fmi, other, saved) == wanted
            fmi.free(one), fmi.free(other)
    return {"ahead": ahead, "then": fmi.get(c, "roll"), "phases": answers}


PHASES = ("new", "initialising", "running", "terminated")


def brought_to(fmi, phase):
    """A component in a phase of its life."""
    c = fmi.instantiate()
    calls = (
        fmi.enter,
        *(lambda c, name=name: fmi.plain(name, c) for name in ("ExitInitializationMode", "Terminate")),
    )
    for call in calls[: PHASES.index(phase)]:
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
        "empty name": {"name": b""},
        "no name": {"name": None},
        "wrong token": {"token": b"{0}"},
        "no token": {"token": b""},
        "empty name, exchange": {"name": b"", "kind": 0},
        "wrong token, exchange": {"token": b"{0}", "kind": 0},
        **(
            {"another type": {"kind": 2}}
            if fmi.version == 2
            else {"events": {"events": True}, "intermediate": {"asked": 1}}
        ),
    }
    answers = {name: (fmi.instantiate(**options), fmi.told()) for name, options in refused.items()}
    wanted = run(fmi, fmi.ready())
    places = (
        None,
        b"",
        b"/nowhere/at all",
        "file:///R\u00e4der & Schienen/\u8f6e\u8f68".encode(),
        b"%s%n",
        b"x" * 5000,
    )
    odd = {f"resources {place!r:.30}": {"resources": place} for place in places}
    odd |= {
        "other letters": {"name": "Radsatz \u00e4 \u8f6e\u5bf9 %s".encode()},
        "long name": {"name": b"x" * 5000},
        "silent": {"logging": False},
    }
    made = {}
    for name, options in odd.items():
        c = fmi.ready(**options)
        fmi.told()
        fmi.step(c, 0.0, -1.0)
        made[name] = run(fmi, c) == wanted, fmi.told()
        fmi.free(c)
    silent = fmi.instantiate(callbacks=False)  # FMI 2 cannot do without the callbacks, FMI 3 can
    return {"refused": answers, "made": made, "without_log": bool(silent) and check_run(fmi, silent, wanted)}


def categories(fmi):
    """Lines of a step with a status and of a call that fails, by what has been switched on."""
    c = fmi.ready()
    fmi.told()

    def lines():
        assert fmi.set(c, lateral_shift=math.nan) == OK and fmi.step(c) == OK
        assert fmi.step(c, 0.0, -1.0) == ERROR
        assert fmi.set(c, lateral_shift=0.0) == OK and fmi.step(c) == OK
        return [category for _, category, _ in fmi.told()]

    def after(on, *names):
        return switch(fmi, c, on, *names), len(fmi.told()), lines()

    return {
        "first": lines(),
        "all off": after(0),
        "errors off": after(0, b"logStatusError"),
        "warnings on": after(1, b"logStatusWarning"),
        "unknown": after(0, b"logStatusWarning", b"logAll"),
        "errors on, too": after(1, b"logStatusError"),
        "warnings off": after(0, b"logStatusWarning"),
        "all on": after(1),
    }


if __name__ == "__main__":
    fmi_version, library_file, header_folder = sys.argv[1:]
    given = json.load(sys.stdin)
    library = Library(int(fmi_version), library_file, **given)
    parts = (bad_input, every_input, order, legal, creation, categories, exchange_modes, exchange_pointers)
    found = {}
    for part in parts:
        found[part.__name__] = part(library)
        library.told()
    print(json.dumps({**found, "null_pointers": null_pointers(library, header_folder)}), flush=True)
