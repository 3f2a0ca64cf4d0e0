"""What a call costs on this machine, in seconds and in a unit that another machine has too: ``np.sqrt`` of 2000 doubles."""

import os
import platform
import timeit
from typing import NamedTuple

import numpy as np

from wrcontact.kernel.binding.library import default_kernel

_VALUES = np.linspace(1.0, 2.0, 2000)


class Cost(NamedTuple):
    """Of one call."""

    seconds: float
    units: float

    @property
    def microseconds(self):
        return 1e6 * self.seconds

    def least(self, other):
        """The smaller of each; ``other`` may be None."""
        return Cost(min(self.seconds, other.seconds), min(self.units, other.units)) if other else self


def unit():
    """Seconds of ``np.sqrt`` of 2000 doubles."""
    return min(timeit.repeat(lambda: np.sqrt(_VALUES), number=300, repeat=5)) / 300


def cost(work, calls, rounds):
    """:class:`Cost` of one of the ``calls`` that ``work()`` makes: the smallest of ``rounds``, since noise only adds.

    The unit is measured in turn with the work, so that a machine that is busy for a while slows both.
    """
    work()  # first times are another matter
    found = [(timeit.timeit(work, number=1) / calls, unit()) for _ in range(rounds)]
    return Cost(min(seconds for seconds, _ in found), min(seconds / one for seconds, one in found))


def load_average():
    """Processes that wanted a core in the last minute; not a number where the system does not tell."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")


def description():
    """One line for below a table."""
    kernel = "compiled" if default_kernel().compiled else "UNCOMPILED"
    return (f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}, numpy {np.__version__}, "
            f"kernel {kernel}, load average {load_average():.1f}; the unit, np.sqrt of 2000 doubles, {unit() * 1e6:.2f} µs")
