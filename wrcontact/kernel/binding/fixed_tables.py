"""The tables that depend on no profile, as one array: the kernel's preparation reads it (prepare/fixed.py),
and a native FMU holds it."""

from functools import lru_cache

import numpy as np

from .hertz_table import hertz_table
from .influence_table import influence_table
from .rolling_table import rolling_table


@lru_cache(maxsize=1)
def fixed_tables():
    """Sizes of the tables, then the tables (n,)."""
    tables = hertz_table(), influence_table(), rolling_table()
    return np.concatenate([[float(len(table)) for table in tables], *tables])
