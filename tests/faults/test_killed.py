"""Processes that are killed or interrupted: what they were writing is whole or as it was before."""

import contextlib
import os
import random
import signal
import sys
import time
from pathlib import Path

import pytest

from tests.helpers.command_line import start
from tests.helpers.faults import assert_files_are_whole, building, cli, loaded_cli, needs_linux, parts_in
from tests.helpers.fmus import needs_compiler
from wrcontact.cli.demo import apart
from wrcontact.cli.errors import Refused
from wrcontact.fmu import native
from wrcontact.kernel.binding.compiler import linked
from wrcontact.storage.atomic import ABANDONED, write_atomically

pytestmark = needs_linux


def wait_for_part(program, folder):
    """Until a process is writing to a folder."""
    while not parts_in(folder):
        assert program.poll() is None, program.communicate()
        time.sleep(0.002)


@pytest.mark.parametrize("blow, code", [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129), ("SIGKILL", -9)])
def test_a_sweep_that_is_ended_while_it_writes(tmp_path, blow, code):
    target = tmp_path / "sweep.csv"
    target.write_text("before\n")
    program = cli("sweep", "--step-mm", "0.0002", "--csv", target)
    wait_for_part(program, tmp_path)
    program.send_signal(getattr(signal, blow))
    out, errors = program.communicate(timeout=600)
    assert (program.returncode, out, target.read_text()) == (code, "", "before\n")
    words = {130: "interrupted", 143: "terminated", 129: "terminated"}.get(code)
    assert errors.startswith(f"wrcontact: {target} will have about 0.68 GB, for 80001 rows; a .parquet file")
    if words:
        assert errors.splitlines()[1:] == [f"wrcontact: {words}; no file is half written"]
    else:
        for part in parts_in(tmp_path):
            os.utime(part, (time.time() - ABANDONED - 60.0,) * 2)
        write_atomically(tmp_path / "next", b"whole")
    assert parts_in(tmp_path) == []


@pytest.mark.full
@pytest.mark.parametrize(
    "words, rounds",
    [
        (("demo", "--output", "{}"), 1),
        *(
            pytest.param(words, 4, marks=pytest.mark.complete)
            for words in (
                ("sweep", "--step-mm", "0.0005", "--csv", "{}/a.csv"),
                ("figures", "--output", "{}"),
                ("demo", "--output", "{}"),
            )
        ),
    ],
)
def test_ctrl_c_ends_a_command_in_one_line(tmp_path, words, rounds):
    """Of the group of processes, as a terminal sends it; the helper of the demo is in it too."""
    chance = random.Random(rounds)
    for _ in range(rounds):
        program = loaded_cli(*(word.format(tmp_path) for word in words), start_new_session=True)
        time.sleep(chance.uniform(0.2, 3.0))
        os.killpg(program.pid, signal.SIGINT)
        _, errors = program.communicate(timeout=120)
        lines = [line for line in errors.splitlines() if "WARNING" not in line]
        if program.returncode == 0:
            assert lines == []  # it had ended
        else:
            assert lines == ["wrcontact: interrupted; no file is half written"] and program.returncode == 130
        assert_files_are_whole(tmp_path)


@pytest.mark.complete
def test_a_demo_that_is_killed(tmp_path):
    """At random times: each of its files is whole or not there, and the next run is
    undisturbed by what was left."""
    chance = random.Random(12)
    for _ in range(12):
        program = cli("demo", "--output", tmp_path, start_new_session=True)
        time.sleep(chance.uniform(1.0, 12.0))
        with contextlib.suppress(ProcessLookupError):
            os.killpg(program.pid, signal.SIGKILL)
        program.communicate()
        assert_files_are_whole(tmp_path)
    done = start(
        "-c", "from wrcontact.cli import main; main()", "demo", "--output", str(tmp_path), folder=tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert assert_files_are_whole(tmp_path) == 3


@pytest.mark.full
@needs_compiler
@pytest.mark.parametrize("rounds", [2, pytest.param(25, marks=pytest.mark.complete)])
def test_a_build_that_is_killed(tmp_path, fmus, compiled, rounds):
    """At random times while it compiles, packs and writes; what it kept for the next build is whole too."""
    chance, cache = random.Random(rounds), tmp_path / "cache" if rounds > 4 else compiled
    for _ in range(rounds):
        program = building(tmp_path / "out", cache, start_new_session=True)
        time.sleep(chance.uniform(0.2, 8.0 if rounds > 4 else 2.5))
        with contextlib.suppress(ProcessLookupError):
            os.killpg(program.pid, signal.SIGKILL)
        program.communicate()
        for file in (tmp_path / "out").glob("*.fmu"):
            assert file.read_bytes() == fmus[int(file.stem[-1])].read_bytes()
    again = native.build_native_fmus(tmp_path / "out", cache=cache)
    assert [file.read_bytes() for file in again] == [file.read_bytes() for file in fmus.values()]


def test_a_helper_that_is_killed_is_reported_in_a_sentence():
    with pytest.raises(Refused, match="the process that runs the FMU ended before it returned its results"):
        apart(os._exit, 9)


SLOW_COMPILER = """
import subprocess, sys, time
later = "import time, pathlib; time.sleep(20); pathlib.Path('later').touch()"
child = subprocess.Popen([sys.executable, "-c", later])
open("begun", "w").close()
child.wait()
"""


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="there are no groups of processes")
def test_an_interrupt_ends_compilers_and_what_they_have_started(tmp_path):
    """A compiler's driver starts programs of its own; of the sources behind it none is begun."""
    begun = tmp_path / "begun"

    def interrupted(made, total):
        while not begun.exists():
            time.sleep(0.01)
        raise KeyboardInterrupt

    (tmp_path / "compiler.py").write_text(SLOW_COMPILER)
    for name in ("a.c", "b.c", "c.c", "d.c"):
        (tmp_path / name).write_text("")
    command, sources = [sys.executable, "compiler.py"], ["a.c", "b.c", "c.c", "d.c"]
    with pytest.raises(KeyboardInterrupt):
        linked(command, tmp_path, sources, "library.so", watch=interrupted)
    time.sleep(0.1)
    assert not (tmp_path / "later").exists() and not running_in(tmp_path)


def running_in(folder):
    """Processes that run in a folder; none where that is not known."""
    found = []
    for link in Path("/proc").glob("[0-9]*/cwd"):
        with contextlib.suppress(OSError):
            if link.resolve() == folder.resolve() and (link.parent / "cmdline").read_bytes():
                found.append(link.parent.name)
    return found
