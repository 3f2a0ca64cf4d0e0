"""Scenarios of fmu_process.py with other numbers of stations."""

import math

import fmpy


def outlines(fmu, stations, rows, start):
    """All outputs after each row of inputs, for each number of stations, with the parameters ``start``; the
    instances step in turn."""
    instances = {number: fmu.running(stations=number, **start) for number in stations}
    seen = {number: [] for number in stations}
    for row in rows:
        for number, instance in instances.items():
            seen[number] += instance.go_on([row])
    return {
        "seen": [seen[number] for number in stations],
        "alone": [fmu.running(stations=number, **start).go_on(rows) for number in stations],
    }


def stations_again(fmu, stations, other, rows):
    """Bits of a run, of the same from a saved state, and of the same in an instance that had another number
    of stations; and an outline before and after a step that is not possible, and after going back to that."""
    one, elsewhere = fmu.running(stations=stations), fmu.running(stations=other)
    one.go_on(rows[:10]), elsewhere.go_on(rows[:10])
    before = one.get("left.station", "right.pressure")
    one.step(lateral_shift=math.nan)
    kept = one.get("left.station", "right.pressure"), one.get("status")
    state = one.take()
    saved = one.pack(state)
    straight = one.go_on(rows[10:])
    one.go_back(state)
    held = one.get("left.station", "right.pressure")
    back = one.go_on(rows[10:])
    elsewhere.restore(saved)
    elsewhere.stations = stations
    one.drop(state)
    return {
        "before": before,
        "kept": kept,
        "held": held,
        "straight": straight,
        "back": back,
        "elsewhere": elsewhere.go_on(rows[10:]),
        "read": elsewhere.get("stations"),
    }


def configuration(fmu):
    """What configuration mode takes and what it refuses, with the log of each; and what there is after it."""
    instance = fmu.instance()
    left = [fmu.references["left.station"]]
    answers = {}

    def attempt(name, call, *arguments, **named):
        answers[name] = instance.status_of(call, *arguments, **named)

    attempt("not entered", instance.set, stations=61)
    attempt("left, not entered", instance.call, "ExitConfigurationMode")
    instance.call("EnterConfigurationMode")
    attempt("entered twice", instance.call, "EnterConfigurationMode")
    for wrong in (0, 2, 202, 2**64 - 1):
        attempt(f"{wrong}", instance.set, stations=wrong)
    attempt("another parameter", instance.set, gauge=1.43)
    attempt("a text", instance.set, load="vertical")
    attempt("an input", instance.set, yaw=0.01)
    attempt("an output", instance.get, "roll")
    attempt("an integer", instance.get, "status")
    attempt("as Float64", instance.read, "Float64", [fmu.references["stations"]])
    attempt("time as UInt64", instance.read, "UInt64", [1])
    attempt("an output as UInt64", instance.read, "UInt64", left)
    attempt("initialisation", instance.enter)
    attempt("a step", instance.do_step)
    kept = instance.get("stations")
    instance.set(stations=7)
    instance.call("ExitConfigurationMode")
    attempt("too early", instance.read, "Float64", left, 7)
    attempt("fixed outside", instance.set, stations=31)
    instance.set(stations=7)
    instance.enter()
    attempt("31 values", instance.read, "Float64", left, 31)
    after = instance.read("Float64", left, 7)
    attempt("while initialising", instance.call, "EnterConfigurationMode")
    instance.leave()
    attempt("while running", instance.call, "EnterConfigurationMode")
    attempt("8 values", instance.read, "Float64", left, 8)
    instance.stations = 7
    running = instance.read("Float64", left, 7)
    instance.terminate()
    attempt("after the end", instance.set, stations=7)
    instance.reset()
    reset, instance.stations = instance.get("stations"), 31
    instance.enter()
    instance.leave()
    again = instance.get()
    instance.reset()
    instance.configure(201)
    instance.reset()
    instance.enter()
    instance.stations = 31
    return {
        "calls": answers,
        "kept": kept,
        "after": after,
        "running": running,
        "reset": reset,
        "again": again,
        "fresh": fmu.running().get(),
        "twice": instance.get("left.station"),
        "log": instance.told(),
    }


def simulated_stations(fmu, stations, row):
    """Outlines by simulate_fmu, with an instance that was configured; fmpy takes the shapes
    from the description."""
    description = fmpy.read_model_description(fmu.folder)
    names = [v.name for v in description.modelVariables if v.dimensions]
    for v in description.modelVariables:
        if v.dimensions:
            v.shape = (stations,)
    slave = fmpy.instantiate_fmu(fmu.folder, description, "CoSimulation")
    slave.enterConfigurationMode()
    slave.setUInt64([fmu.references["stations"]], [stations])
    slave.exitConfigurationMode()
    result = fmpy.simulate_fmu(
        fmu.folder,
        model_description=description,
        fmu_instance=slave,
        output=names,
        start_values=row,
        stop_time=1e-3,
        output_interval=1e-3,
    )
    return {name: result[name][-1].tolist() for name in names}
