"""Scenarios of fmu_process.py with saved states, resets, and several instances."""

import json
import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

from damages import damages
from fmi_host import Fmu


def saved_states(fmu, rows, start, taken=5):
    """Go on from a state that was taken, from its bytes in another instance, and after damaged bytes."""
    one = fmu.running("one", **start)
    one.go_on(rows[:taken])
    before = one.get()
    state = one.take()
    saved = one.pack(state)
    straight = one.go_on(rows[taken:])
    one.go_back(state)
    restored = one.get()
    back = one.go_on(rows[taken:])
    one.drop(state)
    other = fmu.instance("other")
    other.restore(saved)
    elsewhere = other.go_on(rows[taken:])
    damaged = bytearray(saved)
    damaged[len(damaged) // 2] ^= 1
    present = other.get()
    other.told()
    refusals = [other.refuses(other.restore, bytes(bad)) for bad in (damaged, saved[:-8], b"", saved + b"x")]
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


def damaged_states(fmu, rows, seed, count, foreign=()):
    """Bytes that are no state of this FMU, each offered to a running instance: how many, which were accepted
    or told in other than one sentence, and whether the instance went on as one that was left alone."""
    one, other = fmu.running("one"), fmu.running("other")
    one.go_on(rows[:3]), other.go_on(rows[:3])
    saved = one.saved()
    cases = [*damages(saved, seed, count), *(("foreign", bytes.fromhex(text)) for text in foreign)]
    wrong = []
    for name, bad in cases:
        one.told()
        if not one.refuses(one.restore, bad):
            wrong.append([name, "accepted"])
        lines = [line[-1] for line in one.told()]
        if len(lines) != 1 or not all(
            "the saved state" in line and "the present state is kept" in line for line in lines
        ):
            wrong.append([name, lines])
    return {
        "count": len(cases),
        "wrong": wrong[:5],
        "equal": one.go_on(rows[3:]) == other.go_on(rows[3:]),
        "saved": saved.hex(),
    }


def saved(fmu, rows):
    """The bytes of a state after these rows, as hexadecimal digits."""
    instance = fmu.running()
    instance.go_on(rows)
    return instance.saved().hex()


def forked(fmu, rows):
    """An instance of before a fork goes on in both processes, and in a spawned one from its bytes."""
    instance = fmu.running()
    instance.go_on(rows[:3])
    saved = instance.saved()
    inlet, outlet = os.pipe()
    if os.fork() == 0:
        with open(outlet, "w") as pipe:
            json.dump(instance.go_on(rows[3:]), pipe)
        os._exit(0)
    os.close(outlet)
    with open(inlet) as pipe:
        child = json.load(pipe)
    command = [
        sys.executable,
        str(Path(__file__).with_name("fmu_process.py")),
        str(fmu.file),
        fmu.folder + " spawned",
    ]
    question = json.dumps({"scenario": "spawned", "rows": rows[3:], "saved": saved.hex()})
    spawned = subprocess.run(command, input=question, text=True, capture_output=True, check=True)
    return {
        "parent": instance.go_on(rows[3:]),
        "child": child,
        "spawned": json.loads(spawned.stdout)["answer"],
    }


def spawned(fmu, rows, saved):
    """Go on from the bytes of a state."""
    instance = fmu.instance()
    instance.restore(bytes.fromhex(saved))
    return instance.go_on(rows)


def reset(fmu, start):
    """Values before and after a reset, and a second run that repeats the first."""
    instance = fmu.running(**start)
    instance.step(lateral_shift=5e-3)
    first = instance.get()
    instance.reset()
    values = instance.get(*start, "lateral_shift")
    instance.set(**start)
    instance.initialise()
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
            found += instance.go_on([row])
    alone = [fmu.running(f"alone {k}", **start).go_on(rows) for k, start in enumerate(parameters)]
    threaded = [fmu.running(f"thread {k}", **start) for k, start in enumerate(parameters)]
    parallel = [None] * len(threaded)

    def work(k):
        parallel[k] = threaded[k].go_on(rows)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(len(threaded))]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    for k in range(30):
        one = fmu.running(f"one of many {k}")
        one.step(lateral_shift=1e-3)
        one.terminate()
        one.free()
    return {"together": seen, "alone": alone, "parallel": parallel}


def vanished_folder(fmu, again, elsewhere):
    """An instance is refused, its folder removed, and the FMU unpacked again elsewhere."""
    instance = fmu.instance()
    instance.set(contact_mode="nonsense")
    assert instance.refuses(instance.enter)
    shutil.rmtree(fmu.folder)
    return Fmu(again, elsewhere).running("second").get("status", "roll")
