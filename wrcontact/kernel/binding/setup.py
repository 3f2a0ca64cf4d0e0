"""What is fixed during a simulation, prepared once into the one array that the kernel reads.

The kernel's own preparation (kernel/prepare/tables.py) lays it out from the profiles' definitions, in Python
and in a native FMU alike.
"""

import numpy as np

from .hertz_table import hertz_table
from .influence_table import influence_table
from .. import layout
from ..prepare import tables as prepare_tables
from .library import default_kernel
from ..prepare.scan import FINE_STEP
from ...interface.parameters import KERNEL_PARAMETERS, PARAMETERS

#: Place in the setup of every parameter that the kernel has.
PLACES = {name: layout.SETUP_PARAMETERS + k for k, name in enumerate(KERNEL_PARAMETERS)}


def setup_of(parameters, methods):
    """The kernel's setup (n,) for checked ``parameters`` and the objects of all ``methods``, by name."""
    setup = np.full(layout.SETUP_SIZE, np.nan)
    for name, place in PLACES.items():
        value = methods[name].kernel_number if name in methods else parameters[name]
        setup[place] = PARAMETERS[name].start if value is None else value
    resolution = methods["normal_model"].resolution
    setup[layout.SETUP_RESOLUTION:][:len(resolution)] = resolution
    return setup


def prepare_tables_of(wheel, rail, *, parameters, methods):
    """Settings and tables (n,) for the upright profiles ``wheel`` and ``rail``; the
    rest as for :func:`setup_of`.

    Raises
    ------
    ValueError
        where profiles and parameters do not fit each other, in a sentence.
    """
    setup = setup_of(parameters, methods)
    outcome, tables, report = default_kernel().prepare(setup, wheel.definition(), rail.definition(),
                                                       hertz_table(), influence_table())
    if outcome == prepare_tables.PREPARED:
        return tables
    raise ValueError(refusal(outcome, report, wheel.name, rail.name))


def refusal(outcome, report, wheel, rail):
    """Why the tables could not be prepared, in a sentence."""
    if outcome == prepare_tables.GAUGE_TOO_DEEP:
        return (f"gauge_depth reaches {report[prepare_tables.REPORT_DEPTH]:.6g} m, but the inner side of the "
                f"rail profile {rail} ends at {report[prepare_tables.REPORT_DEEPEST]:.6g} m; permitted are "
                "smaller depths")
    if outcome == prepare_tables.WHEEL_TOO_WIDE:
        return (f"the wheel profile is {report[prepare_tables.REPORT_WIDTH]:.4g} m wide; permitted are at "
                f"most {layout.SCAN_LIMIT * FINE_STEP:.4g} m")
    if outcome == prepare_tables.WITHOUT_HEAD:
        return (f"the profiles {wheel} and {rail} are too steep at y = 0 m, the running circle and the "
                "rail's highest point; permitted are profiles with less slope there")
    return (f"the profiles {wheel} and {rail} have too many points for the kernel's tables; permitted are "
            "profiles with fewer points")
