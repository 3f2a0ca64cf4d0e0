"""Scenarios of fmu_process.py on the life cycle: the calls of fmu_misuse.py, times, stopTime, the log."""

import contextlib
import io
import math
from ctypes import c_char_p, c_double, c_void_p

import fmpy
from fmpy.fmi1 import FMICallException

from fmi_host import Instance, signatures
from fmu_misuse import (
    INITIALISING,
    LAST,
    MODES,
    NEW,
    RUNNING,
    THERE,
    calls,
    of_exchange,
    of_states,
    with_room,
    without_places,
)

WORK = ("lateral_shift", "roll", "vertical_shift", "right.penetration", "left.area", "right.max_pressure")


def work(instance, steps=True):
    """Bits of a short run; without ``steps`` values are read at once."""
    seen = []
    for shift in (1e-3, 4e-3, 7e-3):
        instance.set(lateral_shift=shift, yaw=2e-3, normal_force=8e4)
        if steps:
            instance.do_step()
        seen += [value.hex() for value in instance.get(*WORK).values()]
    return seen


def again(instance):
    """Bits of a short run after a reset."""
    instance.reset()
    instance.initialise()
    return work(instance, steps=not instance.exchange)


def answers_of(instance, rows):
    """The status and the lines of each call, by name; and which have changed the instance."""
    before, answers, changed = instance.get(*WORK), {}, []
    for name, call in rows.items():
        answers[name] = instance.status_of(call.make, instance)
        if instance.get(*WORK) != before:
            changed.append(name)
    return answers, changed


def life(fmu):
    """Every call of fmu_misuse.py in its order, and what a run is worth before, between and after them."""
    kind = "python" if fmu.python else fmu.version
    instance, answers = fmu.instance(), {}
    for name, call in calls(kind, (*NEW, *INITIALISING)).items():
        answers[name] = instance.status_of(call.make, instance)
    fresh = work(fmu.running("fresh"))
    first = work(instance)
    found, changed = answers_of(instance, calls(kind, RUNNING))
    answers |= found
    second = work(instance)
    for name, call in calls(kind, LAST).items():
        answers[name] = instance.status_of(call.make, instance)
        if name == "last step":
            end = last_time(instance)
    seen = {"answers": answers, "changed": changed, "end": end, "after": instance.get("roll", "yaw", "gauge")}
    return seen | {"equal": first == second == fresh == again(instance)}


def last_time(instance):
    """Where the last step has ended, as each version tells it; PythonFMU does not."""
    if instance.fmu.version == 3:
        return instance.get("time")["time"]
    if instance.fmu.python:
        return None
    found, last_successful = (c_double * 1)(), 2
    instance.call("GetRealStatus", last_successful, found)
    return found[0]


def misused_states(fmu):
    """Every call of fmu_misuse.py with saved states."""
    instance, other = fmu.running(), fmu.running("other")
    first, rows = work(instance), calls(fmu.version, of_states(instance, other))
    answers, changed = answers_of(instance, rows)
    other.free()
    return {
        "answers": answers,
        "parts": {name: call.refused for name, call in rows.items()},
        "changed": changed,
        "equal": first == work(instance) == again(instance),
    }


def every_input(fmu):
    """Numbers that are none, in every input: the status, whether outputs are kept, the lines, and the
    recovery."""
    instance, answers = fmu.running(), {}
    wanted, inputs = work(instance), [v.name for v in fmu.of("input", fmu.real)]
    for name in inputs:
        for value in (math.nan, math.inf, -math.inf):
            kept = instance.get("roll", "right.penetration", "left.area")
            instance.set(**{name: value})
            instance.do_step()
            answers[f"{name} {value}"] = {
                "status": instance.get("status")["status"],
                "lines": instance.told(),
                "kept": instance.get(*kept) == kept,
            }
            instance.set(**dict.fromkeys(inputs, 0.0))
            works = work(instance) == wanted and instance.get("status") == {"status": 0}
            answers[f"{name} {value}"]["again"] = works
            instance.told()
    return answers


PHASES = ("new", "initialising", "running", "terminated")


def phases(fmu):
    """Values read ahead of the step; whether a state saved in one phase and set in another goes on."""
    instance = fmu.running()
    wanted = work(fmu.running())
    instance.set(lateral_shift=4e-3)
    ahead = instance.get("roll")
    instance.do_step()
    answers = {}
    for saved in PHASES:
        for present in PHASES:
            one, other = brought_to(fmu, saved), brought_to(fmu, present)
            other.restore(one.saved())
            answers[f"{saved} into {present}"] = goes_on(other, saved) == wanted
            one.free(), other.free()
    return {"ahead": ahead, "then": instance.get("roll"), "phases": answers}


def brought_to(fmu, phase, exchange=False):
    """An instance in one of PHASES, or one for model exchange in one of MODES."""
    one, known = fmu.instance(kind=0 if exchange else None), MODES if exchange else PHASES
    steps = one.enter, one.leave, lambda: one.call("EnterContinuousTimeMode"), one.terminate
    for step in (steps if exchange else (*steps[:2], one.terminate))[: known.index(phase)]:
        step()
    one.told()
    return one


def goes_on(instance, phase):
    """Bits of a run from a phase on."""
    if phase == "terminated":
        assert instance.refuses(instance.do_step)
        return again(instance)
    for call in (instance.enter, instance.leave)[PHASES.index(phase) :]:
        call()
    return work(instance)


def creation(fmu):
    """Instances that cannot be made, and some that can with odd arguments, with the lines of a wrong step."""
    refused = {
        "empty name": {"name": ""},
        "no name": {"name": None},
        "wrong token": {"token": "{0}"},
        "no token": {"token": ""},
        "empty name, exchange": {"name": "", "kind": 0},
        "wrong token, exchange": {"token": "{0}", "kind": 0},
        **({"another type": {"kind": 2}} if fmu.version == 2 else {"events": {"events": True}}),
        **({} if fmu.version == 2 else {"intermediate": {"intermediate": 1}}),
    }
    answers = {name: Instance(fmu, **options) for name, options in refused.items()}
    places = None, "", "/nowhere/at all", "file:///R\u00e4der & Schienen/\u8f6e\u8f68", "%s%n", "x" * 5000
    odd = {f"resources {place!r:.30}": {"resources": place} for place in places}
    odd |= {
        "other letters": {"name": "Radsatz \u00e4 \u8f6e\u5bf9 %s"},
        "long name": {"name": "x" * 5000},
        "silent": {"logging": False},
    }
    wanted, made = work(fmu.running()), {}
    for name, options in odd.items():
        one = fmu.instance(**options)
        one.initialise()
        _, lines = one.status_of(one.do_step, 0.0, -1.0)
        made[name] = work(one) == wanted, lines, one.speaker
        one.free()
    silent = Instance(fmu, callbacks=False)  # FMI 2 cannot do without the callbacks, FMI 3 can
    return {
        "refused": {name: (one.component, one.told()) for name, one in answers.items()},
        "made": made,
        "without_log": bool(silent.component) and again(silent) == wanted,
    }


def log_categories(fmu):
    """Lines of a step with a status and of a call that fails, by what has been switched on."""
    one = fmu.running()

    def lines():
        one.set(lateral_shift=math.nan)
        one.do_step()
        assert one.refuses(one.do_step, 0.0, -1.0)
        one.set(lateral_shift=0.0)
        one.do_step()
        return [category for _, category, _ in one.told()]

    def after(on, *names):
        words = (c_char_p * len(names))(*names)
        return *one.status_of(one.call, "SetDebugLogging", on, len(names), words), lines()

    return {
        "first": lines(),
        "all off": after(False),
        "errors off": after(False, b"logStatusError"),
        "warnings on": after(True, b"logStatusWarning"),
        "unknown": after(False, b"logStatusWarning", b"logAll"),
        "errors on, too": after(True, b"logStatusError"),
        "warnings off": after(False, b"logStatusWarning"),
        "all on": after(True),
    }


def null_pointers(fmu):
    """Every function without an instance, and without each of its other pointers in turn; and those that do
    nothing."""
    one = fmu.running()
    wanted, without, answers, refused = work(one), {}, {}, {}
    for name, types in signatures(fmu.version).items():
        if name in ("GetVersion", "GetTypesPlatform", "FreeInstance") or name.startswith("Instantiate"):
            continue
        without[name] = fmu.function(name)(None, *with_room(fmu, name, types, none=0))
        for place in (k for k, kind in enumerate(types) if kind is c_void_p and k > 0):
            given = with_room(fmu, name, types, place)
            answers[f"{name}, {place}"] = one.status_of(one.call, name, *given)
        if name not in THERE:
            refused[name] = one.status_of(one.call, name, *with_room(fmu, name, types, none=0))
    fmu.function("FreeInstance")(None)
    return {
        "without": without,
        "answers": answers,
        "refused": refused,
        "equal": again(one) == wanted,
    }


def exchange_modes(fmu):
    """The outcome and the lines of each function of model exchange, by its name and the mode in which it is
    called; and of the same in co-simulation."""
    rows, answers, steps = of_exchange(fmu.version), {}, {}
    for name, (call, _) in rows.items():
        for mode in MODES:
            one = brought_to(fmu, mode, exchange=True)
            answers[f"{name}, {mode}"] = one.status_of(call, one)
        one = fmu.running()
        steps[name] = one.status_of(call, one)
    wanted, one = work(fmu.running()), brought_to(fmu, "continuous", exchange=True)
    one.set(lateral_shift=3e-3)
    return {"exchange": answers, "steps": steps, "again": again(one) == wanted}


def exchange_pointers(fmu):
    """Answers that have no place, and a run after them."""
    wanted, one = work(fmu.running()), brought_to(fmu, "event", exchange=True)
    answers = {name: one.status_of(call, one) for name, call in without_places(fmu.version).items()}
    one.call("EnterContinuousTimeMode")
    return {"answers": answers, "equal": work(one, steps=False) == wanted}


#: Start and size [s] of steps that do not follow each other: back to the start and before it, a leap, the
#: same one again, one of no length, up to the stop.
JUMPING = ((1.0, 0.1), (1.0, 0.25), (-4.0, 0.5), (7.0, 1.0), (7.0, 1.0), (3.0, 0.0), (9.5, 0.5))


def jumping_times(fmu, rows):
    """Outputs at rows of inputs with steps that follow each other, and with the times of JUMPING; statuses
    and log lines of these, and, in FMI 3, the time and the last successful time behind each."""
    straight, jumping = fmu.instance("straight"), fmu.instance("jumping")
    for instance in (straight, jumping):
        instance.initialise(1.0, 10.0)
    straight.time = 1.0
    seen = {"straight": straight.go_on(rows), "jumping": [], "answers": [], "times": []}
    for row, (time, size) in zip(rows, JUMPING, strict=True):
        jumping.set(**row)
        found = []
        seen["answers"].append(jumping.status_of(lambda: found.append(jumping.do_step(time, size))))
        seen["jumping"].append(jumping.get())
        if fmu.version == 3:
            seen["times"].append([time + size, jumping.get("time")["time"], found[0]])
    return seen


def foreign_stop(fmu):
    """A state of a run up to 1 s, set in an instance with another stopTime."""
    runs = {}
    for stop in (1.0, 10.0):
        runs[stop] = instance = fmu.instance(f"up to {stop} s")
        instance.initialise(0.0, stop)
        instance.do_step(0.0, 0.5)
    run = runs[10.0]
    own = run.take()
    answers = {"before": run.status_of(run.do_step, 0.5, 2.0)}
    run.restore(runs[1.0].saved())
    answers["foreign"] = run.status_of(run.do_step, 0.5, 2.0)
    answers["up to its stop"] = run.status_of(run.do_step, 0.5, 0.5)
    run.go_back(own)
    answers["own again"] = run.status_of(run.do_step, 0.5, 2.0)
    return answers


def unlogged(fmu):
    """What the log and the console have of a wrong parameter and of a status, with debug logging off; and
    what fmpy's simulate_fmu makes of the parameter."""
    instance = fmu.instance(logging=False)
    instance.set(gauge=14.35)
    seen = {"parameter": instance.status_of(instance.enter)[1]}
    instance.set(gauge=1.435, lateral_shift=math.nan)
    instance.initialise()
    seen["status"] = instance.status_of(instance.do_step)[1]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        try:
            result = fmpy.simulate_fmu(
                fmu.folder, start_values={"gauge": 14.35}, stop_time=1.0, output=["roll", "status"]
            )
            seen["simulated"] = [list(map(str, row)) for row in result.tolist()]
        except FMICallException as failure:
            seen["simulated"] = failure.status
    return {**seen, "printed": printed.getvalue()}


def pointers(fmu):
    """Statuses of calls with nothing in them: empty lists and a text that is no text."""
    one = fmu.running()
    one.write("Real", [], []), one.read("Real", [])
    return {"text": one.status_of(one.write, "String", [fmu.references["load"]], [None])[0]}
