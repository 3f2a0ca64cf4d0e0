"""Reports on files of points: what they are, and their repair, in one warning per file and one line on the
command line."""

import sys
import warnings
from contextlib import contextmanager
from dataclasses import dataclass

from ..methods.caller import warn_caller
from ..methods.numbers import UnusualValueWarning


@dataclass(frozen=True)
class Reading:
    """Properties of a file of points, found when it was read.

    ``points``, the number of points used; their median ``spacing`` and the ``widest`` one [m]; their
    estimated ``noise`` and the applied ``smoothing`` [m]; ``remarks``, a tuple of sentences on repairs.
    """

    points: int
    spacing: float
    widest: float
    noise: float
    smoothing: float
    remarks: tuple


class ProfileWarning(UserWarning):
    """A profile file was repaired before it was used; the message says what was done, where and by how
    much."""


class Refusal(ValueError):
    """Why a file cannot be used, without its name: "has 5 points; permitted are 10 or more"."""


def remark(kind, name, remarks):
    """Give one :class:`ProfileWarning` with all ``remarks`` on a profile, if there are any."""
    if remarks:
        warn_caller(f"{kind} profile {name}: {'; '.join(remarks)}", ProfileWarning)


@contextmanager
def remarks_in_lines(prefix, words=str):
    """Inside this context, each different ProfileWarning or UnusualValueWarning is printed once, as one line
    "prefix: message" on the error stream; ``words(warning)`` is the message."""
    categories = (ProfileWarning, UnusualValueWarning)
    with warnings.catch_warnings():
        show, said = warnings.showwarning, set()

        def say(message, category, *where, **more):
            if not issubclass(category, categories):
                show(message, category, *where, **more)
            elif words(message) not in said:
                said.add(words(message))
                print(f"{prefix}: {' '.join(words(message).split())}", file=sys.stderr)

        for category in categories:
            warnings.simplefilter("always", category)
        warnings.showwarning = say
        yield


def stretch(y):
    """The range of ``y`` (n,) [mm] as text: "y = -3.2 mm" or "y = -3.2 ... 4.1 mm"."""
    low, high = min(y), max(y)
    return f"y = {low:.4g} mm" if high - low < 1e-3 else f"y = {low:.4g} ... {high:.4g} mm"


def counted(count, word):
    """A count with its noun: "1 point", "3 points"."""
    return f"{count} {word}" if count == 1 else f"{count} {word}s"
