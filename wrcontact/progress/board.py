"""The displays of :mod:`wrcontact.progress`: lines of work, drawn by rich on a terminal, written now and then
elsewhere."""

import sys
import threading
import time

from rich.console import Console
from rich.progress import (
    BarColumn,
    Progress,
    ProgressColumn,
    SpinnerColumn,
    TaskProgressColumn,
    TextColumn,
)
from rich.text import Text

from .left import TimeLeft


class LeftColumn(ProgressColumn):
    """The time that each line of work still needs, "01:05"."""

    def render(self, task):
        """The text of one line."""
        seconds = left_of(task, task.elapsed or 0.0)
        if seconds is None:
            return Text("--:--")
        minutes, seconds = divmod(round(seconds), 60)
        return Text(f"{minutes:02d}:{seconds:02d}")


def left_of(task, elapsed):
    """The time left [s] of rich's ``task`` after ``elapsed`` [s]; None where it is not known."""
    return task.fields["left"].after(task.completed / task.total, elapsed) if task.total else None


class Board:
    """Lines of work."""

    def __init__(self, **options):
        columns = (
            SpinnerColumn("line"),
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TaskProgressColumn(),
            LeftColumn(),
        )
        console = Console(stderr=True)
        self._progress = Progress(*columns, console=console, transient=True, refresh_per_second=4, **options)

    def add(self, words, total):
        """A new line; its number."""
        return self._progress.add_task(words, total=total, left=TimeLeft())

    def advance(self, line, steps, words):
        """Move a line on by ``steps``, and change its ``words`` unless None."""
        self._progress.update(line, advance=steps, **({} if words is None else {"description": words}))

    def remove(self, line):
        """Remove a line; the number of lines that are left."""
        self._progress.remove_task(line)
        return len(self._progress.task_ids)


class Screen(Board):
    """Lines on a terminal: drawn ``delay`` [s] after it was made, removed without a trace by :meth:`close`.

    What is printed on the error stream meanwhile goes above the lines; so does what is printed on the output
    stream, if they have a ``shared`` terminal.
    """

    def __init__(self, delay, shared):
        super().__init__(redirect_stdout=shared)
        self._lock, self._closed = threading.Lock(), False
        self._timer = threading.Timer(delay, self._show)
        self._timer.daemon = True
        self._timer.start()

    def close(self):
        """Remove the display."""
        self._timer.cancel()
        with self._lock:
            self._closed = True
            self._progress.stop()

    def _show(self):
        with self._lock:
            if not self._closed:
                self._progress.start()


class Lines(Board):
    """The same without a terminal: one line "prefix: ..." every ``interval`` [s] on the error stream."""

    def __init__(self, interval, prefix):
        super().__init__(disable=True)
        self._prefix, self._begun, self._closed = prefix, time.monotonic(), threading.Event()
        threading.Thread(target=self._write, args=(interval,), daemon=True).start()

    def close(self):
        """Write no more."""
        self._closed.set()

    def line(self, elapsed):
        """What is written after ``elapsed`` [s]: the works from the outermost on, and the time."""
        works = self._progress.tasks
        parts = [
            f"{one.description} {one.completed / one.total:.0%}" if one.total else one.description
            for one in works
        ]
        left = next((left_of(one, elapsed) for one in works if one.total and one.completed), None)
        words = "" if left is None else f", about {left:.0f} s left"
        return f"{self._prefix}: {', '.join(parts)} after {elapsed:.0f} s{words}"

    def _write(self, interval):
        while not self._closed.wait(interval):
            if self._progress.tasks:
                print(self.line(time.monotonic() - self._begun), file=sys.stderr, flush=True)
