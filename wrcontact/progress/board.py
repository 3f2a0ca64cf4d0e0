"""The display of :mod:`wrcontact.progress`: lines of work, drawn by rich."""

import threading

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

    def __init__(self):
        super().__init__()
        self._left = {}

    def render(self, task):
        """The text of one line."""
        left = self._left.setdefault(task.id, TimeLeft())
        seconds = left.after(task.completed / task.total, task.elapsed or 0.0) if task.total else None
        if seconds is None:
            return Text("--:--")
        minutes, seconds = divmod(round(seconds), 60)
        return Text(f"{minutes:02d}:{seconds:02d}")


class Board:
    """Lines of work; drawn ``delay`` [s] after it was made, removed without a trace by :meth:`close`.

    What is printed on the error stream meanwhile goes above the lines; so does what is printed on the output
    stream, if they have a ``shared`` terminal.
    """

    def __init__(self, delay, shared):
        console = Console(stderr=True)
        columns = (
            SpinnerColumn("line"),
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TaskProgressColumn(),
            LeftColumn(),
        )
        self._progress = Progress(
            *columns, console=console, transient=True, refresh_per_second=4, redirect_stdout=shared
        )
        self._lock, self._closed = threading.Lock(), False
        self._timer = threading.Timer(delay, self._show)
        self._timer.daemon = True
        self._timer.start()

    def add(self, words, total):
        """A new line; its number."""
        return self._progress.add_task(words, total=total)

    def advance(self, line, steps, words):
        """Move a line on by ``steps``, and change its ``words`` unless None."""
        self._progress.update(line, advance=steps, **({} if words is None else {"description": words}))

    def remove(self, line):
        """Remove a line; the number of lines that are left."""
        self._progress.remove_task(line)
        return len(self._progress.task_ids)

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
