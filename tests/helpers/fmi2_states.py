"""Scenarios of fmu_process.py with saved states, resets, and several instances."""

import json
import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

from damages import damages
from fmi2_host import Fmu
from fmi_host import refused


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
    refusals = [other.refuses(set_state_from, other.slave, bytes(bad))
                for bad in (damaged, saved[:-8], b"", saved + b"x")]
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
        "log": other.told(),
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
    """Bytes that are no state of this FMU, each offered to a running instance: how many, which were accepted
    or told in other than one sentence, and whether the instance went on as one that was left alone."""
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
        if not one.refuses(set_state_from, one.slave, bad):
            wrong.append([name, "accepted"])
        lines = [line[-1] for line in one.told()]
        if (len(lines) != 1
            or not all("the saved state" in line and "the present state is kept" in line for line in lines)):
            wrong.append([name, lines])
    return {"count": len(cases), "wrong": wrong[:5],
            "equal": _go_on(one, rows[3:]) == _go_on(other, rows[3:]), "saved": saved.hex()}


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
    command = [sys.executable, str(Path(__file__).with_name("fmu_process.py")), "spawned", str(fmu.file),
               fmu.folder + " spawned"]
    spawned = subprocess.run(command, input=json.dumps({"rows": rows[3:], "saved": saved.hex()}), text=True,
                             capture_output=True, check=True)
    return {"parent": _go_on(instance, rows[3:]), "child": child, "spawned": json.loads(spawned.stdout)}


def spawned(fmu, rows, saved):
    """Go on from the bytes of a state."""
    instance = fmu.instance()
    set_state_from(instance.slave, bytes.fromhex(saved))
    return _go_on(instance, rows)


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


def vanished_folder(fmu, again, elsewhere):
    """An instance is refused, its folder removed, and the FMU unpacked again elsewhere."""
    instance = fmu.instance()
    instance.set(contact_mode="nonsense")
    refused(instance.slave.enterInitializationMode)
    shutil.rmtree(fmu.folder)
    return Fmu(again, elsewhere).running("second").get("status", "roll")
