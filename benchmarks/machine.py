"""Cost of a call, in seconds and in a unit that can be compared between machines: ``np.sqrt`` of 2000
doubles."""

import os
import platform
import timeit
from typing import NamedTuple

import numpy as np

from wrcontact.kernel.binding.library import default_kernel

_VALUES = np.linspace(1.0, 2.0, 2000)


class Cost(NamedTuple):
    """Cost of one call."""

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
    """:class:`Cost` of one of the ``calls`` that ``work()`` makes: the smallest of several ``rounds``.

    The unit is measured alternately with the work, so that a busy machine slows both.
    """
    work()  # the first call is slower
    found = [(timeit.timeit(work, number=1) / calls, unit()) for _ in range(rounds)]
    return Cost(min(seconds for seconds, _ in found), min(seconds / one for seconds, one in found))


def load_average():
    """Load average of the last minute; NaN if the system has none."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")


def description():
    """One line on the machine, for below a table."""
    kernel = "compiled" if default_kernel().compiled else "UNCOMPILED"
    return (f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}, numpy "
            f"{np.__version__}, "
            f"kernel {kernel}, load average {load_average():.1f}; the unit, np.sqrt of 2000 doubles, "
            f"{unit() * 1e6:.2f} µs")
