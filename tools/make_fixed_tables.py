"""Store the tables that depend on no profile: ``python tools/make_fixed_tables.py``, after a change of
tools/tables/exact_tables.py, rolling_table.py or wrcontact/creep/kalker_table.py.

Made on another processor they differ in their last bits, so they are made once, for all.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tools.tables import exact_tables, rolling_table  # noqa: E402
from wrcontact.kernel.binding import fixed_tables  # noqa: E402


def made_tables():
    """The arrays (n,) to be stored, by name."""
    rolling = rolling_table.made_table()
    return {
        "hertz": exact_tables.hertz_table(),
        "influence": exact_tables.influence_table(),
        "rolling": rolling[: len(rolling) - len(fixed_tables.corrections())],
    }


if __name__ == "__main__":
    np.savez_compressed(fixed_tables.FIXED, **made_tables())
    print(fixed_tables.FIXED)
