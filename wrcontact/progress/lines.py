"""The display of :mod:`wrcontact.progress` without a terminal: a line of text now and then."""

import sys
import threading
import time


class Lines:
    """Lines of work, of which one line "prefix: ..." tells every ``interval`` [s] on the error stream."""

    def __init__(self, interval, prefix):
        self._prefix, self._begun = prefix, time.monotonic()
        self._works, self._numbers = {}, 0  # [words, steps done, total] by number
        self._lock, self._closed = threading.Lock(), threading.Event()
        threading.Thread(target=self._tell, args=(interval,), daemon=True).start()

    def add(self, words, total):
        """A new work; its number."""
        with self._lock:
            self._numbers += 1
            self._works[self._numbers] = [words, 0, total]
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
        parts = [words if not total else f"{words} {done / total:.0%}" for words, done, total in works]
        share = next((done / total for _, done, total in works if total and done), 0.0)
        left = f", about {elapsed * (1.0 / share - 1.0):.0f} s left" if share else ""
        return f"{self._prefix}: {', '.join(parts)} after {elapsed:.0f} s{left}"

    def _tell(self, interval):
        while not self._closed.wait(interval):
            if self._works:
                print(self.line(time.monotonic() - self._begun), file=sys.stderr, flush=True)
