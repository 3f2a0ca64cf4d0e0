"""The sign of life: on a terminal after a while, with the time left; nowhere else, and never in a result."""

import io
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from tests.helpers.command_line import OUTSIDE
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem, Stepper, progress
from wrcontact.progress.board import Lines
from wrcontact.progress.left import TimeLeft


class Terminal(io.StringIO):
    """A stream that says it is a terminal."""

    def isatty(self):
        return True


@pytest.fixture
def opened(monkeypatch):
    """A function that makes the error stream a terminal, and the delay zero; a test calls it, since pytest
    sets the stream after the fixtures."""

    def opened():
        for name, value in (("TERM", "xterm"), ("COLUMNS", "100")):
            monkeypatch.setenv(name, value)
        monkeypatch.setattr(sys, "stderr", Terminal())
        monkeypatch.setattr(progress, "DELAY", 0.0)
        return sys.stderr

    return opened


def wait_for(stream, *words):
    """Until the stream has these words; a busy machine may take its time."""
    end = time.monotonic() + 120
    while not all(word in stream.getvalue() for word in words):
        assert time.monotonic() < end, stream.getvalue()
        time.sleep(0.01)


def test_work_is_shown_with_its_share_and_removed(opened):
    terminal = opened()
    with progress.working("sweep [m]", 4) as advance:
        wait_for(terminal, "sweep [m]", "0%")
        advance(3)
        wait_for(terminal, "75%")
        advance(words="the rest")
        wait_for(terminal, "the rest", "100%")
    assert terminal.getvalue().endswith("\x1b[2K\x1b[?25h\r")  # the line is erased
    assert progress._board is None


def test_the_time_left_is_shown(opened):
    """It is known once two steps are done, and goes down."""
    terminal = opened()
    with progress.working("long work", 8) as advance:
        for _ in range(4):
            time.sleep(0.1)
            advance(1)
        wait_for(terminal, "long work", ":0")


def test_inner_work_has_a_line_of_its_own(opened):
    terminal = opened()
    with progress.working("outer"), progress.working("inner", 2):
        wait_for(terminal, "outer", "inner")
        with progress.working("hidden", alone=True):
            time.sleep(0.3)
    assert "hidden" not in terminal.getvalue() and progress._board is None


def test_an_error_removes_it(opened):
    terminal = opened()
    with pytest.raises(ValueError), progress.working("work"):
        wait_for(terminal, "work")
        raise ValueError
    assert progress._board is None


def test_threads_share_one_display(opened):
    terminal = opened()

    def work(number):
        for _ in progress.tracked(range(3), f"thread {number}"):
            wait_for(terminal, f"thread {number}")

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    [thread.start() for thread in threads], [thread.join() for thread in threads]
    assert progress._board is None


def test_short_work_shows_nothing(opened, monkeypatch):
    terminal = opened()
    monkeypatch.setattr(progress, "DELAY", 2.0)
    assert list(progress.tracked("abc", "work")) == ["a", "b", "c"]
    assert terminal.getvalue() == ""


@pytest.mark.parametrize("name, value", [("WRCONTACT_PROGRESS", "off"), ("TERM", "dumb")])
def test_it_can_be_switched_off(opened, monkeypatch, name, value):
    terminal = opened()
    monkeypatch.setenv(name, value)
    with progress.working("work"):
        time.sleep(0.2)
    assert terminal.getvalue() == ""


def test_a_stream_that_is_no_terminal_gets_nothing(monkeypatch):
    for stream in (io.StringIO(), None):
        monkeypatch.setattr(sys, "stderr", stream)
        monkeypatch.setattr(progress, "DELAY", 0.0)
        with progress.working("work"):
            time.sleep(0.1)
        assert stream is None or stream.getvalue() == ""


def test_a_command_writes_lines_where_there_is_no_terminal(monkeypatch):
    """Not before the interval, and not when it is switched off; no bars."""
    for setting, interval in (("on", 0.05), ("on", 60.0), ("off", 0.05)):
        monkeypatch.setattr(sys, "stderr", io.StringIO())
        monkeypatch.setattr(progress, "INTERVAL", interval)
        monkeypatch.setenv("WRCONTACT_PROGRESS", setting)
        with progress.in_lines("wrcontact"), progress.working("sweep", 4) as advance:
            advance(1)
            with progress.working("compiling"):
                if setting == "on" and interval < 1.0:
                    wait_for(sys.stderr, "wrcontact: sweep 25%, compiling after ", " s left\n")
                else:
                    time.sleep(0.2)
        seen = sys.stderr.getvalue()
        assert bool(seen) == (setting == "on" and interval < 1.0)
        assert all(line.startswith("wrcontact: sweep 25%") for line in seen.splitlines())
        assert "\x1b" not in seen
    assert progress._board is None and progress._prefix is None


def test_a_line_has_the_time_left():
    lines = Lines(60.0, "wrcontact")
    lines.advance(lines.add("sweep", 10), 2, None)
    assert lines.line(20.0) == "wrcontact: sweep 20% after 20 s, about 80 s left"
    lines.advance(lines.add("part", None), 1, "another")
    assert lines.line(20.0) == "wrcontact: sweep 20%, another after 20 s, about 80 s left"
    lines.close()


def test_evaluate_many_shows_how_far_it_is(opened, monkeypatch):
    terminal = opened()
    step_many = Stepper.step_many

    def slow(self, inputs, outputs, status):
        time.sleep(0.3)
        step_many(self, inputs, outputs, status)

    monkeypatch.setattr(Stepper, "step_many", slow)
    table = ContactSystem().evaluate_many(np.linspace(0, 1e-3, 20))
    assert "evaluating poses" in terminal.getvalue() and "00:0" in terminal.getvalue() and len(table) == 20


@pytest.mark.full
def test_rich_is_not_imported_without_a_terminal(tmp_path):
    script = (
        "import sys, wrcontact; wrcontact.ContactSystem().evaluate_many([0.0])\n"
        "assert not {'rich', 'matplotlib', 'pandas', 'scipy.interpolate'} & set(sys.modules)\n"
        "wrcontact.plots.pose_figure"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script],
        env=OUTSIDE,
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    assert done.returncode == 0, done.stderr


def test_the_kernel_shows_nothing():
    for file in (ROOT / "wrcontact" / "kernel").rglob("*.py"):
        assert "progress" not in file.read_text(encoding="utf-8"), file


LONG_WORK = (
    "benchmarks/__main__.py",
    "benchmarks/parts.py",
    "benchmarks/random_poses.py",
    "benchmarks/errors.py",
    "benchmarks/studies.py",
    "wrcontact/cli/commands.py",
    "wrcontact/cli/demo.py",
    "wrcontact/study/figures.py",
    "wrcontact/fmu/native.py",
    "wrcontact/fmu/online.py",
    "wrcontact/halfspace/stepping.py",
)


@pytest.mark.parametrize("name", LONG_WORK)
def test_long_work_is_shown(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    assert "tracked(" in text or "working(" in text


def test_the_time_left_never_grows():
    """Ten steps: each takes a second, then one takes a minute, then a second again."""
    left, told = TimeLeft(), []
    ends = [0, 1, 2, 3, 63, 64, 65]
    assert left.after(0.0, 0.5) is None
    for now in range(1, 66):
        done = sum(end <= now for end in ends) - 1
        told.append(left.after(done / 10, float(now)))
    assert told[:3] == [9.0, 8.0, pytest.approx(7.0)]
    assert all(after <= before for before, after in zip(told, told[1:])) and told[-1] == 0.0
    assert told[5] == pytest.approx(4.0)  # it falls with the time meanwhile
