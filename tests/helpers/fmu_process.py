"""Runs one scenario with an FMU in a process of its own and prints what it saw as JSON.

    python fmu_process.py <scenario> <FMU> <folder for unpacking>   (further arguments: JSON on standard input)

The host's own wrcontact is shut out: what answers is the code in the FMU.
"""

import ctypes
import gc
import hashlib
import json
import locale
import math
import os
import shutil
import subprocess
import sys
import threading
from ctypes import c_double, c_uint
from pathlib import Path


class Shut:
    """An import hook that refuses the packages which an FMU must not need."""

    names = frozenset({"wrcontact", "scipy", "matplotlib", "typer", "rich", "hypothesis", "pyccel"})

    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in self.names:
            raise ImportError(f"{name} is shut out: the FMU has to do without")


sys.meta_path.insert(0, Shut())

import fmpy  # noqa: E402
from damages import damages  # noqa: E402
from walker import HOME, Walker  # noqa: E402
from fmpy.fmi1 import FMICallException  # noqa: E402
from fmpy.fmi2 import (  # noqa: E402
    FMU2Slave,
    fmi2CallbackAllocateMemoryTYPE,
    fmi2CallbackFreeMemoryTYPE,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
)


class Fmu:
    """An unpacked FMU: its description and where its variables are."""

    def __init__(self, file, folder):
        self.file, self.folder = file, str(folder)
        fmpy.extract(file, unzipdir=self.folder)
        self.description = fmpy.read_model_description(self.folder)
        self.variables = {v.name: v for v in self.description.modelVariables}

    def instance(self, name="instance", logging=True):
        return Instance(self, name, logging)

    def running(self, name="instance", logging=True, **start):
        """An instance after initialisation with these values."""
        instance = self.instance(name, logging)
        instance.set(**start)
        instance.slave.enterInitializationMode()
        instance.slave.exitInitializationMode()
        return instance


class Instance:
    """One slave with its log, addressed by variable names."""

    def __init__(self, fmu, name, logging):
        self.fmu, self.log, self.time = fmu, [], 0.0
        self.slave = FMU2Slave(
            guid=fmu.description.guid,
            unzipDirectory=fmu.folder,
            modelIdentifier=fmu.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(self._note)
        self.callbacks.allocateMemory = fmi2CallbackAllocateMemoryTYPE(fmpy.calloc)
        self.callbacks.freeMemory = fmi2CallbackFreeMemoryTYPE(fmpy.free)
        self.slave.instantiate(callbacks=self.callbacks, loggingOn=logging)
        self.slave.setupExperiment(startTime=0.0)

    def _note(self, environment, instance, status, category, message):
        self.log.append([status, (category or b"").decode(), message.decode()])

    def set(self, **values):
        variables = self.fmu.variables
        for kind, set_values in (("Real", self.slave.setReal), ("String", self.slave.setString)):
            chosen = {variables[n].valueReference: v for n, v in values.items() if variables[n].type == kind}
            if chosen:
                set_values(list(chosen), list(chosen.values()))

    def get(self, *names):
        """Values of the named variables; of all outputs if there is no name."""
        variables, slave = self.fmu.variables, self.slave
        chosen = [variables[n] for n in names] or [v for v in variables.values() if v.causality == "output"]
        found = {}
        for kind, get_values in (("Real", slave.getReal), ("Integer", slave.getInteger), ("String", slave.getString)):
            some = [v for v in chosen if v.type == kind]
            if some:
                found.update(zip((v.name for v in some), get_values([v.valueReference for v in some])))
        return {name: value.decode() if isinstance(value, bytes) else value for name, value in found.items()}

    def step(self, size=1e-3, **inputs):
        self.set(**inputs)
        self.slave.doStep(self.time, size)
        self.time += size

    def told(self):
        """The log lines since the last call."""
        lines, self.log[:] = list(self.log), []
        return lines


def refused(call, *arguments):
    """Whether a call fails with an FMI error."""
    try:
        call(*arguments)
    except FMICallException:
        return True
    return False


# --- scenarios ------------------------------------------------------------------------------------


def first_instant(fmu, start=None):
    """Outputs before any step, at the default inputs and at others."""
    plain = fmu.running().get()
    instance = fmu.instance()
    instance.slave.enterInitializationMode()
    instance.set(**(start or {}))
    inside = instance.get()
    instance.slave.exitInitializationMode()
    return {"default": plain, "in_initialisation": inside, "after_initialisation": instance.get(), "modules": modules()}


def modules():
    """Which wrcontact and which PythonFMU this process runs."""
    ours = ("wrcontact", "wheelset_contact", "pythonfmu")
    return {name: module.__file__ for name, module in sys.modules.items() if name.startswith(ours)}


def trajectory(fmu, rows, names, start=None):
    """Outputs after a step at every row of inputs."""
    instance = fmu.running(**(start or {}))
    seen = []
    for row in rows:
        instance.step(**row)
        seen.append(instance.get(*names))
    return {"seen": seen, "log": instance.told()}


def simulated(fmu, rows, times, names):
    """The same by simulate_fmu: inputs hold from one instant to the next, results are those at the end of each step."""
    import numpy as np

    rest = {v.name: float(v.start) for v in fmu.description.modelVariables if v.causality == "input"}
    rows = [{**rest, **row} for row in rows]
    columns = [(name, "f8") for name in ("time", *rows[0])]
    signals = np.array([(time, *row.values()) for time, row in zip(times, rows)], dtype=columns)
    interval = (times[-1] - times[0]) / (len(times) - 1)
    limits = {"start_time": times[0], "stop_time": times[-1], "output_interval": interval}
    result = fmpy.simulate_fmu(fmu.folder, input=signals, output=names, **limits)
    return {"seen": [dict(zip(result.dtype.names[1:], row[1:])) for row in result.tolist()]}


VALID = {"lateral_shift": 1e-3, "yaw": 0.0, "roll_guess": 0.0, "normal_force": 78.5e3, "load_transfer": 0.0,
         "vertical_shift_input": 0.0, "roll_input": 0.0}


def outcomes(fmu, cases, start=None, valid=None):
    """Each case on a running instance, between two valid steps: its outputs, its log, and the recovery."""
    instance = fmu.running(**(start or {}))
    valid = {**VALID, **(valid or {})}
    answers = {}
    for name, case in cases.items():
        instance.step(**valid)
        before = instance.get()
        instance.told()
        instance.step(**case)
        during, log = instance.get(), instance.told()
        instance.step()
        again = instance.told()
        instance.step(**valid)
        after, rest = instance.get(), instance.told()
        answers[name] = {"before": before, "during": during, "log": log, "again": again, "after": after, "rest": rest}
    return answers


def laziness(fmu):
    """How often the kernel ran."""
    instance = fmu.running()
    session = session_of("instance")
    counts = [session.evaluations]
    instance.get(), instance.step(), instance.step(), instance.get()
    counts.append(session.evaluations)
    instance.step(lateral_shift=2e-3)
    instance.get(), instance.get("roll"), instance.step()
    counts.append(session.evaluations)
    instance.set(lateral_shift=3e-3)
    ahead = instance.get("roll")
    instance.step()
    counts.append(session.evaluations)
    instance.set(lateral_shift=2e-3), instance.set(lateral_shift=3e-3, yaw=0.0)
    return {"counts": counts, "ahead": ahead, "after": instance.get("roll")}


def session_of(name):
    """The session behind the instance of this name; it lives in this process."""
    slaves = [found for found in gc.get_objects() if type(found).__name__ == "WheelsetContact"]
    return next(slave.session for slave in slaves if slave.instance_name == name)


def saved_states(fmu, rows, names, start):
    """Go on from a state that was taken, from its bytes in another instance, and after damaged bytes."""
    one = fmu.running("one", **start)
    for row in rows[:5]:
        one.step(**row)
    before = one.get()
    state = one.slave.getFMUstate()
    saved = one.slave.serializeFMUstate(state)
    straight = _go_on(one, rows[5:])
    one.slave.setFMUstate(state)
    restored = one.get()
    back = _go_on(one, rows[5:])
    one.slave.freeFMUstate(state)
    other = fmu.instance("other")
    set_state_from(other.slave, saved)
    elsewhere = _go_on(other, rows[5:])
    damaged = bytearray(saved)
    damaged[len(damaged) // 2] ^= 1
    present = other.get()
    other.told()
    refusals = [refused(set_state_from, other.slave, bytes(bad)) for bad in (damaged, saved[:-8], b"", saved + b"x")]
    kept = other.get() == present
    other.step(**rows[0])
    return {
        "before": before,
        "restored": restored,
        "straight": straight,
        "back": back,
        "elsewhere": elsewhere,
        "refusals": refusals,
        "kept": kept,
        "log": [line for line in other.told() if line[1]],
        "after": other.get(),
    }


def set_state_from(slave, saved):
    """Set the state that the bytes hold."""
    slave.setFMUstate(slave.deSerializeFMUstate(saved))


def _go_on(instance, rows):
    seen = []
    for row in rows:
        instance.step(**row)
        seen.append(instance.get())
    return seen


def damaged_states(fmu, rows, seed, count, foreign=()):
    """Bytes that are no state of this FMU, each offered to a running instance: how many, which were accepted or told in other
    than one sentence, and whether the instance went on as one that was left alone."""
    one, other = fmu.running("one"), fmu.running("other")
    for row in rows[:3]:
        one.step(**row), other.step(**row)
    state = one.slave.getFMUstate()
    saved = one.slave.serializeFMUstate(state)
    one.slave.freeFMUstate(state)
    cases = [*damages(saved, seed, count), *(("foreign", bytes.fromhex(text)) for text in foreign)]
    wrong = []
    for name, bad in cases:
        one.told()
        if not refused(set_state_from, one.slave, bad):
            wrong.append([name, "accepted"])
        lines = [line[-1] for line in one.told() if line[1]]
        if len(lines) > 1 or not all("the saved state" in line and "the present state is kept" in line for line in lines):
            wrong.append([name, lines])
    return {"count": len(cases), "wrong": wrong[:5], "equal": _go_on(one, rows[3:]) == _go_on(other, rows[3:]),
            "saved": saved.hex()}


def localised(fmu, locale_name, inner, arguments):
    """A scenario in a host that has chosen this locale for its numbers."""
    locale.setlocale(locale.LC_NUMERIC, locale_name)
    written = ctypes.create_string_buffer(16)
    ctypes.CDLL(None).snprintf(written, 16, b"%g", c_double(1.5))
    return {"one and a half": written.value.decode(), "answer": globals()[inner](fmu, **arguments)}


def forked(fmu, rows):
    """An instance of before a fork goes on in both processes, and in a spawned one from its bytes."""
    instance = fmu.running()
    for row in rows[:3]:
        instance.step(**row)
    state = instance.slave.getFMUstate()
    saved = instance.slave.serializeFMUstate(state)
    inlet, outlet = os.pipe()
    if os.fork() == 0:
        with open(outlet, "w") as pipe:
            json.dump(_go_on(instance, rows[3:]), pipe)
        os._exit(0)
    os.close(outlet)
    with open(inlet) as pipe:
        child = json.load(pipe)
    command = [sys.executable, __file__, "spawned", str(fmu.file), fmu.folder + " spawned"]
    spawned = subprocess.run(command, input=json.dumps({"rows": rows[3:], "saved": saved.hex()}), text=True,
                             capture_output=True, check=True)
    return {"parent": _go_on(instance, rows[3:]), "child": child, "spawned": json.loads(spawned.stdout)}


def spawned(fmu, rows, saved):
    """Go on from the bytes of a state."""
    instance = fmu.instance()
    set_state_from(instance.slave, bytes.fromhex(saved))
    return _go_on(instance, rows)


def derivatives(fmu, rows, outputs, inputs, start):
    """Directional derivatives after steps, with whether the instance stayed as it was; and which calls are refused."""
    instance, seen = fmu.running(**start), []
    slave, reference = instance.slave, {v.name: v.valueReference for v in fmu.variables.values()}
    unknowns, knowns = ([reference[name] for name in names] for names in (outputs, inputs))
    for row in rows:
        instance.step(**row)
        state = slave.getFMUstate()
        before = slave.serializeFMUstate(state)
        found = [list(slave.getDirectionalDerivative(unknowns, [known], [1.0])) for known in knowns]
        again = slave.getFMUstate()
        seen.append({"matrix": found, "kept": slave.serializeFMUstate(again) == before})
        slave.freeFMUstate(state)
        slave.freeFMUstate(again)
    calls = {"parameter": (unknowns, [reference["gauge"]]), "output as known": (unknowns, [reference["roll"]]),
             "input as unknown": ([reference["yaw"]], knowns[:1]), "integer": ([reference["status"]], knowns[:1]),
             "unknown reference": ([4711], knowns[:1])}
    del instance.log[:]
    answers = {}
    for name, (one, other) in calls.items():
        answers[name] = refused(slave.getDirectionalDerivative, one, other, [1.0]), list(instance.log)
        del instance.log[:]
    return {"seen": seen, "calls": answers}


def reset(fmu, start):
    """Values before and after a reset, and a second run that repeats the first."""
    instance = fmu.running(**start)
    instance.step(lateral_shift=5e-3)
    first = instance.get()
    instance.slave.reset()
    values = instance.get(*start, "lateral_shift")
    instance.set(**start)
    instance.slave.enterInitializationMode()
    instance.slave.exitInitializationMode()
    fresh = instance.get()
    instance.step(lateral_shift=5e-3)
    second, other = instance.get(), fmu.running("new", **start).get()
    return {"first": first, "values": values, "fresh": fresh, "second": second, "fresh_instance": other}


def instances(fmu, parameters, rows):
    """Several instances stepped in turn, alone, and in threads; then many one after the other."""
    together = [fmu.running(f"instance {k}", **start) for k, start in enumerate(parameters)]
    seen = [[] for _ in together]
    for row in rows:
        for instance, found in zip(together, seen):
            instance.step(**row)
            found.append(instance.get())
    alone = [_go_on(fmu.running(f"alone {k}", **start), rows) for k, start in enumerate(parameters)]
    threaded = [fmu.running(f"thread {k}", **start) for k, start in enumerate(parameters)]
    parallel = [None] * len(threaded)

    def work(k):
        parallel[k] = _go_on(threaded[k], rows)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(len(threaded))]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    for k in range(30):
        one = fmu.running(f"one of many {k}")
        one.step(lateral_shift=1e-3)
        one.slave.terminate()
        one.slave.fmi2FreeInstance(one.slave.component)
    return {"together": seen, "alone": alone, "parallel": parallel}


def neighbours(fmu, other, other_folder):
    """Two different FMUs in one process, both ways round."""
    second = Fmu(other, other_folder)
    one, two = fmu.running("one"), second.running("two")
    one.step(lateral_shift=1e-3), two.step(lateral_shift=1e-3)
    wheels = [one.get("wheel_profile"), two.get("wheel_profile")]
    return {"one": one.get(), "two": two.get(), "wheels": wheels, "modules": modules()}


def several(fmu, others, rows, shared):
    """Several FMUs in one process, stepped in turn, with two instances of the first."""
    fmus = {"first": fmu, **{name: Fmu(*where) for name, where in others.items()}, "again": fmu}
    for one in fmus.values() if shared else ():
        for library in Path(one.folder, "binaries").glob("*/*.so"):
            ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)
    made = {name: one.running(name) for name, one in fmus.items()}
    seen = {name: {"seen": [], "rail": instance.get("rail_profile")["rail_profile"]} for name, instance in made.items()}
    for row in rows:
        for name, instance in made.items():
            instance.step(**row)
            seen[name]["seen"].append(instance.get())
    return seen


def refusals(fmu, cases):
    """Wrong parameters: whether initialisation fails, what the log says, and whether the FMU works afterwards."""
    answers = {}
    for name, start in cases.items():
        instance = fmu.instance(name)
        instance.set(**start)
        failed = refused(instance.slave.enterInitializationMode)
        answers[name] = {"refused": failed, "log": instance.told()}
        instance.slave.reset()
        instance.slave.enterInitializationMode()
        instance.slave.exitInitializationMode()
        instance.step(lateral_shift=1e-3)
        answers[name]["after"] = instance.get("roll", "status")
        instance.slave.freeInstance()
    return answers


def misuse(fmu):
    """What an importer should not do must not bring the process down."""
    instance = fmu.running()
    variables = fmu.variables
    calls = {
        "fixed parameter": lambda: instance.set(gauge=1.5),
        "same value": lambda: instance.set(gauge=1.435),
        "output": lambda: instance.slave.setReal([variables["roll"].valueReference], [1.0]),
        "integer output": lambda: instance.slave.setInteger([variables["status"].valueReference], [1]),
        "unknown reference": lambda: instance.slave.getReal([4711]),
        "wrong type": lambda: instance.slave.getReal([variables["status"].valueReference]),
    }
    answers = {name: refused(call) for name, call in calls.items()}
    unready = fmu.instance("unready")
    unready.step()
    instance.step(lateral_shift=1e-3)
    after = instance.get("status", "roll")
    return {"refused": answers, "unready": unready.get("status"), "unready_log": unready.told(), "after": after}


def illegal(fmu, cases):
    """Single calls that a native FMU refuses, each with its log; and a step before initialisation."""
    instance, variables = fmu.running(), fmu.variables
    calls = {
        "fixed parameter": lambda: instance.set(gauge=1.5),
        "output": lambda: instance.slave.setReal([variables["roll"].valueReference], [1.0]),
        "integer output": lambda: instance.slave.setInteger([variables["status"].valueReference], [1]),
        "unknown reference": lambda: instance.slave.getReal([4711]),
        "wrong type": lambda: instance.slave.getReal([variables["status"].valueReference]),
    }
    instance.told()
    answers = {name: (refused(calls[name]), instance.told()) for name in cases}
    unready = fmu.instance("unready")
    early = refused(unready.step), unready.told()
    instance.step(lateral_shift=1e-3)
    return {"calls": answers, "unready": early, "after": instance.get("status", "roll")}


def vanished_folder(fmu, again, elsewhere):
    """An instance is refused, its folder removed, and the FMU unpacked again elsewhere."""
    instance = fmu.instance()
    instance.set(contact_mode="nonsense")
    refused(instance.slave.enterInitializationMode)
    shutil.rmtree(fmu.folder)
    return Fmu(again, elsewhere).running("second").get("status", "roll")


def endurance(fmu, steps):
    """Memory before and after many steps with all their reading, and saved states now and then."""
    slave = fmu.running().slave
    reals = [v.valueReference for v in fmu.variables.values() if v.causality == "output" and v.type == "Real"]
    references, values = (c_uint * len(reals))(*reals), (c_double * len(reals))()

    def run(count):
        for k in range(count):
            slave.setReal([0, 1], [5e-3 * (k % 101 - 50) / 50, 1e-4 * (k % 7)])
            slave.doStep(0.0, 1e-3)
            slave.fmi2GetReal(slave.component, references, len(reals), values)
            if k % 100 == 0:
                state = slave.getFMUstate()
                slave.setFMUstate(state)
                slave.freeFMUstate(state)

    run(steps // 10)
    gc.collect()
    before = resident(), sys.getallocatedblocks()
    run(steps)
    gc.collect()
    return {"resident": resident() - before[0], "blocks": sys.getallocatedblocks() - before[1]}


def walk(fmu, seed, steps, resumed=False):
    """A random walk, now and then going on from a saved state: what was seen on it, as native_host.c's walks."""
    instance, elsewhere = fmu.running(logging=False), Walker(~seed % 2**64)
    reference = {name: variable.valueReference for name, variable in fmu.variables.items()}
    reals = [v.valueReference for v in fmu.variables.values() if v.causality == "output" and v.type == "Real"]
    references, values = (c_uint * len(reals))(*reals), (c_double * len(reals))()
    angle, place, twin = (reals.index(reference[f"right.{name}"])
                          for name in ("contact_angle", "contact.y_wheel", "patch[2].normal_force"))
    seen = dict.fromkeys(("bad", "flange", "jumps", "twins", "partings", "made", "homes", "same_bits"), 0)
    digest, sizes, first_bad, last_place, home = hashlib.blake2b(digest_size=8), [], [], 0.0, None
    lowest, highest = [list(values) for _ in range(2)], [list(values) for _ in range(2)]
    walker = Walker(seed)
    for k, row in enumerate(walker.rows(steps)):
        if resumed and elsewhere.draw() > 1.0 - 2.0 / PARTING:
            before, instance = instance, part(fmu, instance, elsewhere)
            seen["partings"] += 1
            seen["made"] += instance is not before
        slave = instance.slave
        slave.setReal([0, 1, 2, 3, 4], row)
        slave.doStep(0.0, 1e-3)
        slave.fmi2GetReal(slave.component, references, len(reals), values)
        digest.update(values)
        if slave.getInteger([reference["status"]]) != [0] or not math.isfinite(math.fsum(values)):
            first_bad = first_bad or list(row)
            seen["bad"] += 1
        seen["flange"] += values[angle] > 1.0  # [rad]
        seen["jumps"] += abs(values[place] - last_place) > 5e-3  # [m]
        seen["twins"] += values[twin] > 0.0
        last_place = values[place]
        if row is HOME:
            home, half = home or bytes(values), int(2 * k >= steps)
            seen["homes"] += 1
            seen["same_bits"] += bytes(values) == home
            first = seen["homes"] == 1 or not any(lowest[half])
            lowest[half] = list(values) if first else list(map(min, lowest[half], values))
            highest[half] = list(values) if first else list(map(max, highest[half], values))
        if 10 * k >= steps and k % 1000 == 0:
            sizes.append(resident())
    kept = {"home": list((c_double * len(reals)).from_buffer_copy(home)), "low": lowest[0], "high": highest[0],
            "late_low": lowest[1], "late_high": highest[1]}
    return {**seen, **kept, "steps": steps, "first_bad": first_bad, "last": walker.at, "digest": digest.hexdigest(),
            "resident": [sizes[0], min(sizes), max(sizes)]}


PARTING = 500  # steps from one saved state of a walk to the next, in the mean


def part(fmu, instance, elsewhere):
    """The instance that goes on from the saved state: this one after steps elsewhere or a reset, or another one."""
    slave, kind = instance.slave, int(1.5 + 1.5 * elsewhere.draw())
    state = slave.getFMUstate()
    if kind < 2:
        for k in range(4):
            elsewhere.move()
            slave.setReal([0, 1, 2, 3, 4], [math.nan] * 5 if k == 2 else elsewhere.at)
            slave.doStep(0.0, 1e-3)
            slave.getReal([fmu.variables["roll"].valueReference])
        if kind == 1:
            slave.reset()
    else:
        saved = slave.serializeFMUstate(state)
        slave.freeFMUstate(state)
        slave.fmi2FreeInstance(slave.component)  # fmpy's own also unloads the library
        instance = fmu.instance(logging=False)
        slave = instance.slave
        state = slave.deSerializeFMUstate(saved)
    slave.setFMUstate(state)
    slave.freeFMUstate(state)
    return instance


def resident():
    """Resident memory of this process [bytes], counted page by page; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/smaps_rollup").read_text().split("Rss:")[1].split()[0]) * 1024
    except OSError:
        return 0


if __name__ == "__main__":
    scenario, file, folder = sys.argv[1:]
    answer = globals()[scenario](Fmu(file, folder), **json.load(sys.stdin))
    print(json.dumps(answer), flush=True)
    # PythonFMU's binary reads and writes memory that it has freed when the process ends (its exit handler follows the
    # destructor of what it uses; PythonFMU issue 228), which now and then aborts the process after all is done.  Every
    # check is in the answer, so leave without exit handlers.
    sys.stderr.flush()
    os._exit(0)
