"""The tables that depend on no profile, as one array: the kernel's preparation reads it (prepare/tables.py),
and a native FMU holds it."""

from functools import lru_cache

import numpy as np

from .hertz_table import hertz_table
from .influence_table import influence_table
from .rolling_table import rolling_table


@lru_cache(maxsize=2)
def fixed_tables(rolling=True):
    """Sizes of the tables, then the tables (n,); without ``rolling`` the table of rolling is empty."""
    tables = hertz_table(), influence_table(), rolling_table() if rolling else np.zeros(0)
    return joined(*tables)


def joined(*tables):
    """Sizes, then the tables (n,)."""
    return np.concatenate([[float(len(table)) for table in tables], *tables])
