"""The native FMUs from a C host, host.c: random calls, threads, memory."""

import os
import re
import shutil
import signal
import subprocess
from collections import Counter
from pathlib import Path

import pytest

from tests.helpers.c_host import RACES, SANITIZERS, answer_of, fuzz, needs_race_detector, needs_sanitizers
from tests.helpers.fmus import needs_compiler, needs_glibc
from wrcontact.interface.variables import VARIABLES

pytestmark = needs_compiler


@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
def test_random_calls(linked_host, version):
    """Among them are outlines of other numbers of stations where there are any: 141 with this seed."""
    counted = fuzz(linked_host(version), version, 5, 15_000)
    assert counted["other_outlines"] > 50 if version == 3 else counted["other_outlines"] == 0


@pytest.mark.full
@needs_sanitizers
@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.turns(2)
def test_a_million_random_calls_under_sanitizers(host, version):
    """Ten runs in which every contact mode meets every normal model, or one short one in which each is met."""
    calls = int(os.environ.get("WRCONTACT_FUZZ_CALLS", 1_000_000))
    program, started, runs = host(version, *SANITIZERS), Counter(), -(-calls // 100_000)
    for seed in range(runs):
        started.update(fuzz(program, version, seed, calls // runs)["started"])
    modes, models = (
        next(v for v in VARIABLES if v.name == name).choices for name in ("contact_mode", "normal_model")
    )
    assert set(started) == {f"{mode} {model}" for mode in modes for model in models}
    if calls >= 100_000:
        assert min(started.values()) >= 2 * runs, started
    for one in (*modes, *models):
        assert sum(count for methods, count in started.items() if one in methods.split()) >= 5, started


@needs_glibc
def test_a_call_that_ends_the_program_is_reported(linked_host, tmp_path):
    """With its seed and number, which repeat it."""
    running = subprocess.Popen(
        [str(linked_host(2)), "fuzz", "11", "100000000"], text=True, stderr=subprocess.PIPE
    )
    children = Path(f"/proc/{running.pid}/task/{running.pid}/children")
    while not (child := children.read_text().split()):
        pass
    os.kill(int(child[0]), signal.SIGSEGV)
    _, told = running.communicate(timeout=600)
    assert running.returncode == 1 and re.match(r"host fuzz 11 \d+ fails: ended by signal 11", told), told


@needs_glibc
@pytest.mark.parametrize("variant", (0, 1, 5), ids=["alike", "two sides, moving rails, elastic", "compliant"])
@pytest.mark.parametrize("version", (2, 3))
def test_no_allocation_between_initialisation_and_end(linked_host, version, variant, rows_file):
    """Nor in any other part of the process; but the first of the states that are
    saved has to be somewhere."""
    counted = answer_of(linked_host(version), "allocations", variant, rows_file())
    assert counted["rows"] > 100 and counted["wrong"] == 0
    assert counted["steps"] == counted["states"] == 0 and counted["first_state"] == 1


@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.turns(2)
def test_eight_instances_in_eight_threads(linked_host, version, rows_file):
    """Of different methods, each with the bits of its run alone."""
    assert answer_of(linked_host(version), "threads", 8, rows_file()) == {
        "equal": 8,
        "variants": 8,
        "wrong": 0,
    }


@pytest.mark.full
@needs_race_detector
@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.turns(2)
def test_threads_share_nothing(host, version, rows_file):
    """On the last swing over a flange: what threads share they share there, too."""
    assert answer_of(host(version, *RACES), "threads", 8, rows_file(24)) == {
        "equal": 8,
        "variants": 8,
        "wrong": 0,
    }


@needs_glibc
@pytest.mark.complete
@pytest.mark.skipif(not shutil.which("valgrind"), reason="valgrind is not installed")
@pytest.mark.parametrize("version", (2, 3))
def test_valgrind_finds_nothing(host, version):
    """In the program as it is packed, without a sanitizer's help."""
    command = ["valgrind", "-q", "--error-exitcode=9", "--leak-check=full", "--trace-children=yes"]
    done = subprocess.run(
        [*command, str(host(version)), "fuzz", "3", "3000"], text=True, capture_output=True, timeout=900
    )
    assert done.returncode == 0, done.stderr[-3000:]
