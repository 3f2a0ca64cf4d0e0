"""The display of :mod:`wrcontact.progress` without a terminal: a line of text now and then."""

import sys
import threading
import time

from .left import TimeLeft


class Lines:
    """Lines of work, of which one line "prefix: ..." tells every ``interval`` [s] on the error stream."""

    def __init__(self, interval, prefix):
        self._prefix, self._begun = prefix, time.monotonic()
        self._works, self._numbers = {}, 0  # [words, steps done, total, its TimeLeft] by number
        self._lock, self._closed = threading.Lock(), threading.Event()
        threading.Thread(target=self._tell, args=(interval,), daemon=True).start()

    def add(self, words, total):
        """A new work; its number."""
        with self._lock:
            self._numbers += 1
            self._works[self._numbers] = [words, 0, total, TimeLeft()]
            return self._numbers

    def advance(self, work, steps, words):
        """Move a work on by ``steps``, and change its ``words`` unless None."""
        with self._lock:
            known = self._works[work]
            known[0], known[1] = known[0] if words is None else words, known[1] + steps

    def remove(self, work):
        """Remove a work; the number of works that are left."""
        with self._lock:
            del self._works[work]
            return len(self._works)

    def close(self):
        """Write no more."""
        self._closed.set()

    def line(self, elapsed):
        """What is written after ``elapsed`` [s]: the works from the outermost on, and the time."""
        with self._lock:
            works = list(self._works.values())
        parts = [words if not total else f"{words} {done / total:.0%}" for words, done, total, _ in works]
        seconds = next(
            (left.after(done / total, elapsed) for _, done, total, left in works if total and done), None
        )
        said = "" if seconds is None else f", about {seconds:.0f} s left"
        return f"{self._prefix}: {', '.join(parts)} after {elapsed:.0f} s{said}"

    def _tell(self, interval):
        while not self._closed.wait(interval):
            if self._works:
                print(self.line(time.monotonic() - self._begun), file=sys.stderr, flush=True)
