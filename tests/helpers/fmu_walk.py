"""Scenarios of fmu_process.py with very many steps."""

import gc
import hashlib
import math
import sys
from ctypes import c_double, c_uint

from fmi_host import resident
from walker import HOME, Walker


def endurance(fmu, steps):
    """Memory before and after many steps with all their reading, and saved states now and then."""
    instance = fmu.running()
    reals = [v.valueReference for v in fmu.of("output", "Real")]
    references, values = (c_uint * len(reals))(*reals), (c_double * len(reals))()

    def run(count):
        for k in range(count):
            instance.write("Real", [0, 1], [5e-3 * (k % 101 - 50) / 50, 1e-4 * (k % 7)])
            instance.do_step()
            instance.call("GetReal", references, len(reals), values)
            if k % 100 == 0:
                state = instance.take()
                instance.go_back(state)
                instance.drop(state)

    run(steps // 10)
    gc.collect()
    before = resident(), sys.getallocatedblocks()
    run(steps)
    gc.collect()
    return {"resident": resident() - before[0], "blocks": sys.getallocatedblocks() - before[1]}


def walk(fmu, seed, steps, resumed=False):
    """A random walk, now and then going on from a saved state: what was seen on it, as
    the C host's walks (tests/fmu/native/host.c)."""
    instance, elsewhere = fmu.running(logging=False), Walker(~seed % 2**64)
    reference, outputs = fmu.references, fmu.of("output", "Real")
    reals = [v.valueReference for v in outputs if not v.name.startswith("equilibrium.")]
    references, values = (c_uint * len(reals))(*reals), (c_double * len(reals))()
    angle, place, twin = (
        reals.index(reference[f"right.{name}"])
        for name in ("contact_angle", "contact.y_wheel", "patch[2].normal_force")
    )
    seen = dict.fromkeys(("bad", "flange", "jumps", "twins", "partings", "made", "homes", "same_bits"), 0)
    digest, sizes, first_bad, last_place, home = hashlib.blake2b(digest_size=8), [], [], 0.0, None
    lowest, highest = [list(values) for _ in range(2)], [list(values) for _ in range(2)]
    walker = Walker(seed)
    for k, row in enumerate(walker.rows(steps)):
        if resumed and elsewhere.draw() > 1.0 - 2.0 / PARTING:
            before, instance = instance, part(fmu, instance, elsewhere)
            seen["partings"] += 1
            seen["made"] += instance is not before
        instance.write("Real", [0, 1, 2, 3, 4], row)
        instance.do_step()
        instance.call("GetReal", references, len(reals), values)
        digest.update(values)
        if instance.read("Integer", [reference["status"]]) != [0] or not math.isfinite(math.fsum(values)):
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
    kept = {
        "home": list((c_double * len(reals)).from_buffer_copy(home)),
        "low": lowest[0],
        "high": highest[0],
        "late_low": lowest[1],
        "late_high": highest[1],
    }
    return {
        **seen,
        **kept,
        "steps": steps,
        "first_bad": first_bad,
        "last": walker.at,
        "digest": digest.hexdigest(),
        "resident": [sizes[0], min(sizes), max(sizes)],
    }


PARTING = 500  # steps from one saved state of a walk to the next, in the mean


def part(fmu, instance, elsewhere):
    """The instance that goes on from the saved state: this one after steps elsewhere or a
    reset, or another one."""
    kind = int(1.5 + 1.5 * elsewhere.draw())
    state = instance.take()
    if kind < 2:
        for k in range(4):
            elsewhere.move()
            instance.write("Real", [0, 1, 2, 3, 4], [math.nan] * 5 if k == 2 else elsewhere.at)
            instance.do_step()
            instance.get("roll")
        if kind == 1:
            instance.reset()
    else:
        saved = instance.pack(state)
        instance.drop(state)
        instance.free()
        instance = fmu.instance(logging=False)
        state = instance.unpack(saved)
    instance.go_back(state)
    instance.drop(state)
    return instance
