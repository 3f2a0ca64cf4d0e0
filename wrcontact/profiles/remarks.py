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
    estimated ``noise`` and the applied ``smoothing`` [m]; ``remarks``, a tuple of sentences on repairs;
    ``inclination``, the slope from which a rail was turned upright [1].
    """

    points: int
    spacing: float
    widest: float
    noise: float
    smoothing: float
    remarks: tuple
    inclination: float = 0.0


class ProfileWarning(UserWarning):
    """A profile file was repaired before it was used, or looks wrong; the message says what was done or
    found, where and by how much.

    Attributes
    ----------
    kind, name : of the profile: "wheel" or "rail", and its file.
    remarks : tuple of sentences.
    """

    def __init__(self, kind, name, remarks):
        super().__init__(kind, name, remarks)
        self.kind, self.name, self.remarks = kind, name, tuple(remarks)

    def __str__(self):
        return f"{self.kind} profile {self.name}: {'; '.join(self.remarks)}"


class Grave(str):
    """A remark on what makes all results wrong, if it is so; it stands before the others."""


class Refusal(ValueError):
    """Why a file cannot be used, without its name: "has 5 points; permitted are 10 or more"."""


def remark(kind, name, remarks):
    """Give one :class:`ProfileWarning` with all ``remarks`` on a profile, if there are any."""
    if remarks:
        warn_caller(ProfileWarning(kind, name, by_weight(remarks)))


def by_weight(remarks):
    """The ``remarks``, those that are :class:`Grave` first."""
    return sorted(remarks, key=lambda one: not isinstance(one, Grave))


def sentences_of(warning):
    """The sentences of a warning: of a :class:`ProfileWarning` each remark, with the name of the file."""
    if not isinstance(warning, ProfileWarning):
        return [str(warning)]
    return [f"{warning.kind} profile {warning.name}: {one}" for one in warning.remarks]


@contextmanager
def remarks_in_lines(prefix, lines=sentences_of):
    """Inside this context, each ProfileWarning or UnusualValueWarning is printed on the error stream, as
    lines "prefix: sentence"; ``lines(warning)`` are the sentences, of which each is printed once."""
    categories = (ProfileWarning, UnusualValueWarning)
    with warnings.catch_warnings():
        show, said = warnings.showwarning, set()

        def say(message, category, *where, **more):
            if not issubclass(category, categories):
                show(message, category, *where, **more)
                return
            for line in lines(message):
                if line not in said:
                    said.add(line)
                    print(f"{prefix}: {' '.join(line.split())}", file=sys.stderr)

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
