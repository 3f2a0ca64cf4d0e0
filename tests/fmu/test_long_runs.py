"""Long random walks over tread, flange root and flange (walker.py): every step valid, no drift, no
leak, and the same bits when a walk is repeated, when it goes on from saved states at random times,
and when eight walk in eight threads."""

import hashlib
import json
import subprocess
import threading

import numpy as np
import pytest

from tests.helpers.c_host import linked_host
from tests.helpers.fmus import command, needs_glibc, question
from tests.helpers.walker import HOME, RETURN, Walker
from wrcontact import ContactSystem
from wrcontact.interface.variables import FIRST_OUTPUT, FIRST_WEAR, REAL, STATUS, VARIABLES
from wrcontact.kernel.binding.library import default_kernel

SEED = 7
REALS = [v for v in VARIABLES[FIRST_OUTPUT:STATUS] if v.type == REAL]
NOMINAL = np.array([v.nominal for v in REALS])
#: How far an answer at one pose may scatter with the way there [of the nominal value]: the roll search ends
#: within 1e-14 rad and the contact point within 1e-13 m, and both are 1e-3 and more in size.
SCATTER = 1e-9
#: Resident memory after the warm-up, a tenth of the walk, is flat to this share; shorter
#: walks are over before it.
FLAT, WARM = 0.01, 100_000
#: PythonFMU makes a class for every instance and never frees it [bytes]: 180 objects, and
#: what lies between them.
CLASS = 30e3
#: Between the tables of two instances of the Python FMU the heap has holes, 2 MB after 200 instances
#: and after 1000 [bytes].
TABLES = 3e6

pytestmark = pytest.mark.full
complete = pytest.mark.complete
needs_library = pytest.mark.skipif(
    not default_kernel().compiled, reason="the source alone would walk for hours"
)


@pytest.fixture(scope="session")
def hosts(fmus, tmp_path_factory):
    """The C host with the library of each version of FMI."""
    return {
        version: linked_host(fmu, version, tmp_path_factory.mktemp("host")) for version, fmu in fmus.items()
    }


def together(*commands, given=None):
    """What programs print as JSON, all at once."""
    running = [
        subprocess.Popen(
            list(map(str, command)),
            text=True,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        for command in commands
    ]
    if given:
        for program, text in zip(running, given):  # before the first is waited for
            program.stdin.write(text)
            program.stdin.close()
            program.stdin = None
    answers = [program.communicate(timeout=7200) for program in running]
    for program, (out, errors) in zip(running, answers):
        assert program.returncode == 0, (
            f"{program.args} ended with {program.returncode}:\n{out[-2000:]}\n{errors[-2000:]}"
        )
    return [json.loads(out) for out, _ in answers]


def assert_sound(walk):
    """Every step is valid; the walk came over flanges, jumps and second patches; home is
    home; memory is flat."""
    assert walk["bad"] == 0, f"{walk['bad']} steps are not valid, the first at {walk['first_bad']}"
    assert min(walk["flange"], walk["jumps"], walk["twins"]) > 0.01 * walk["steps"]
    assert walk["homes"] == -(-walk["steps"] // RETURN) and walk["same_bits"] > 0.9 * walk["homes"]
    home, lowest, highest = (np.array(walk[name]) for name in ("home", "low", "high"))
    scatter = np.maximum(highest - home, home - lowest)
    late = np.maximum(np.array(walk["late_high"]) - home, home - np.array(walk["late_low"]))
    assert len(home) == len(NOMINAL) and np.max(np.maximum(scatter, late) / NOMINAL) < SCATTER
    if walk["steps"] >= WARM:
        before, least, most = walk["resident"]
        room = CLASS * walk["made"] + TABLES if walk.get("made") else 0.0
        assert least > (1.0 - FLAT) * before - room and most < (1.0 + FLAT) * before + room, (
            walk["resident"],
            room,
        )
    return walk["digest"]


def assert_home(walk):
    """The first answer is the package's, which took no other way."""
    fresh = ContactSystem().evaluate(*HOME[:2], *HOME[3:])
    values = np.append(fresh.values, np.zeros(STATUS - FIRST_WEAR))  # no outputs of wear are asked for
    assert np.max(np.abs(walk["home"] - values[[v.index for v in REALS]]) / NOMINAL) < SCATTER


# --- native -------------------------------------------------------------------------------------------------


@needs_glibc
@pytest.mark.parametrize(
    "version, steps", [(2, 100_000), (3, 10_000), pytest.param(2, 10_000_000, marks=complete)]
)
@pytest.mark.turns(2)
def test_a_native_walk_repeats_itself_and_resumes(hosts, version, steps):
    [walk], [resumed] = together(*([hosts[version], way, SEED, steps, 0] for way in ("walk", "resumed")))
    assert assert_sound(walk) == assert_sound(resumed)
    assert resumed["partings"] > steps / 1000
    assert_home(walk)
    if steps <= 100_000:
        assert walk["last"] == resumed["last"] == walked(SEED, steps)


def walked(seed, steps):
    """Where a walk ends."""
    walker = Walker(seed)
    for _ in range(steps):
        walker.move()
    return walker.at


#: Variants of the C host, with vertical loads and creep forces by strips: elastic strips, rigid ANALYN.
ELASTIC, RIGID = 1, 21


@needs_glibc
@pytest.mark.parametrize(
    "variant, steps",
    [
        (ELASTIC, 3_000),
        (RIGID, 5_000),
        pytest.param(ELASTIC, 30_000, marks=complete),
        pytest.param(RIGID, 1_000_000, marks=complete),
    ],
)
@pytest.mark.turns(2)
def test_a_native_walk_with_motion_and_creep_forces(hosts, variant, steps):
    """Two different sides, rails that are displaced, lean and move, speeds of either sign, friction.

    Some steps have no solution here, 44 of 3 000 elastic and 9 of 5 000 rigid ones, where friction jams a
    wheel or a flange has 250 kN and more: they keep the outputs.
    """
    [walk], [resumed] = together(*([hosts[2], way, SEED, steps, variant] for way in ("walk", "resumed")))
    assert walk["bad"] == resumed["bad"] < 0.02 * steps, walk["first_bad"]
    assert walk["digest"] == resumed["digest"] and resumed["partings"] > steps / 1000
    assert walk["same_bits"] == 1  # no two motions are alike, at the same place


@needs_glibc
@pytest.mark.parametrize("steps", [5_000, pytest.param(1_250_000, marks=complete)])
def test_eight_native_walks_in_eight_threads(hosts, steps):
    [threads], *alone = (
        together([hosts[2], "walks", SEED, steps, 8]),
        *(together([hosts[2], "walk", SEED + k, steps, 0])[0] for k in range(8)),
    )
    assert [walk["digest"] for walk in threads] == [walk["digest"] for [walk] in alone]
    assert len({walk["digest"] for walk in threads}) == 8 and not any(walk["bad"] for walk in threads)


# --- Python -------------------------------------------------------------------------------------------------


@needs_library
@pytest.mark.parametrize("steps", [10_000, pytest.param(1_000_000, marks=complete)])
def test_a_walk_of_the_python_fmu_repeats_itself_and_resumes(fmu, tmp_path, steps):
    ways = [{"seed": SEED, "steps": steps, "resumed": resumed} for resumed in (False, True)]
    commands = [command(fmu, tmp_path / f"unpacked {k}") for k in range(2)]
    walk, resumed = (
        answer["answer"] for answer in together(*commands, given=[question("walk", way) for way in ways])
    )
    assert assert_sound(walk) == assert_sound(resumed)
    assert resumed["partings"] > steps / 1000
    assert_home(walk)


@needs_library
@pytest.mark.parametrize("steps", [2_000, pytest.param(125_000, marks=complete)])
@pytest.mark.parametrize("way", ["stepper", "evaluate"])
def test_eight_walks_of_the_package_in_eight_threads(way, steps):
    """Steppers of their own, and one system whose threads evaluate."""
    system = ContactSystem()
    alone = (
        [digest_of(system, way, SEED + k, steps) for k in range(8)]
        if way == "stepper"
        else [in_threads(system, way, 1, steps, SEED + k)[0] for k in range(8)]
    )
    assert in_threads(system, way, 8, steps, SEED) == alone and len(set(alone)) == 8


def in_threads(system, way, count, steps, seed):
    """Digests of walks, each in a thread of its own."""
    found = [None] * count

    def walk(k):
        found[k] = digest_of(system, way, seed + k, steps)

    threads = [threading.Thread(target=walk, args=(k,)) for k in range(count)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    return found


def digest_of(system, way, seed, steps):
    """All outputs of a walk as a few digits."""
    digest, stepper = hashlib.blake2b(digest_size=8), system.stepper()
    for lateral_shift, yaw, roll_guess, normal_force, load_transfer in Walker(seed).rows(steps):
        if way == "evaluate":
            state = system.evaluate(lateral_shift, yaw, normal_force, load_transfer, roll_guess=roll_guess)
            status, values = state.status, state.values
        else:
            stepper.inputs[:5] = lateral_shift, yaw, roll_guess, normal_force, load_transfer
            status, values = stepper.step(), stepper.outputs
        assert status == 0, (lateral_shift, yaw, roll_guess, normal_force, load_transfer)
        digest.update(values)
    return digest.hexdigest()
