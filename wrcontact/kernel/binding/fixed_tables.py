"""The tables that depend on no profile, as one array: the kernel's preparation reads it (prepare/tables.py),
and a native FMU holds it.

They are stored, so that they have the same bits on every machine: numpy's functions differ from processor to
processor.  tools/tables says how they are made, tools/make_fixed_tables.py stores them.
Numpy alone, because an FMU reads them on a machine that may have nothing else.
"""

from functools import lru_cache
from pathlib import Path

import numpy as np

#: The tables but for the corrections, which are whole numbers of their unit.
FIXED = Path(__file__).parents[1] / "data" / "fixed_tables.npz"
#: What exact forces differ from those of the strips by (tools/make_rolling_correction.py).
CORRECTION = Path(__file__).parents[1] / "data" / "rolling_correction.npz"
#: Unit of their numbers, of mu N and of mu N sqrt(ab).
CORRECTION_UNIT = 2e-5


@lru_cache(maxsize=1)
def stored_tables():
    """The stored arrays (n,), ``hertz``, ``influence`` and ``rolling``, by name."""
    with np.load(FIXED) as found:
        return {name: found[name] for name in found.files}


def hertz_table():
    """The table of Hertz coefficients as the kernel reads it (n,)."""
    return stored_tables()["hertz"]


def influence_table():
    """The table of influences as the kernel reads it (n,)."""
    return stored_tables()["influence"]


@lru_cache(maxsize=1)
def rolling_table():
    """The table of rolling as the kernel's preparation reads it (n,)."""
    return np.concatenate([stored_tables()["rolling"], corrections()])


def corrections():
    """The corrections for all Poisson's ratios, none for no creepage and for an infinite one, then their slopes
    at no creepage (n,)."""
    with np.load(CORRECTION) as found:
        values, slopes = found["correction"] * CORRECTION_UNIT, found["slopes"]
    values = np.pad(values, [(0, 0)] * 4 + [(1, 1), (0, 0)])
    return np.concatenate([values.ravel(), slopes.ravel()])


@lru_cache(maxsize=2)
def fixed_tables(rolling=True):
    """Sizes of the tables, then the tables (n,); without ``rolling`` the table of rolling is empty."""
    tables = hertz_table(), influence_table(), rolling_table() if rolling else np.zeros(0)
    return np.concatenate([[float(len(table)) for table in tables], *tables])
