"""What is fixed during a simulation, prepared once into the one array that the kernel reads.

The kernel's own preparation (kernel/prepare/tables.py) lays it out from the profiles' definitions, in Python and in a native
FMU alike.
"""

import numpy as np

from .hertz_table import hertz_table
from .influence_table import influence_table
from .. import layout
from ..prepare import tables as prepare_tables
from .library import default_kernel
from ..prepare.scan import FINE_STEP

#: Where the setup of the kernel's preparation keeps parameters and methods.
SETUP = {"rail_inclination": prepare_tables.SETUP_INCLINATION, "gauge": prepare_tables.SETUP_GAUGE,
         "gauge_depth": prepare_tables.SETUP_GAUGE_DEPTH, "running_circle_distance": prepare_tables.SETUP_CIRCLE_DISTANCE,
         "nominal_radius": prepare_tables.SETUP_RADIUS, "youngs_modulus": prepare_tables.SETUP_YOUNGS_MODULUS,
         "poisson_ratio": prepare_tables.SETUP_POISSON_RATIO, "curvature_step": prepare_tables.SETUP_CURVATURE_STEP,
         "curvature_reach": prepare_tables.SETUP_CURVATURE_REACH}
SETUP_METHODS = {"contact_mode": prepare_tables.SETUP_MODE, "load": prepare_tables.SETUP_LOAD,
                 "normal_model": prepare_tables.SETUP_NORMAL_MODEL, "separation": prepare_tables.SETUP_SEPARATION,
                 "longitudinal_curvature": prepare_tables.SETUP_LONGITUDINAL,
                 "lateral_curvature": prepare_tables.SETUP_LATERAL}
SETUP_RESOLUTION = slice(prepare_tables.SETUP_NODES, prepare_tables.SETUP_SWEEPS + 1)


def prepare_tables_of(wheel, rail, *, parameters, methods, resolution):
    """Settings and tables (n,) for the upright profiles ``wheel`` and ``rail``.

    ``parameters`` holds numbers by the names of :data:`SETUP` (others are not read), ``methods`` the kernel's number of every
    method, ``resolution`` is a :class:`~wrcontact.resolution.Resolution`.

    Raises
    ------
    ValueError
        where profiles and parameters do not fit each other, in a sentence.
    """
    setup = np.zeros(prepare_tables.SETUP_SIZE)
    for name, at in SETUP.items():
        setup[at] = parameters[name]
    for name, at in SETUP_METHODS.items():
        setup[at] = methods[name]
    setup[SETUP_RESOLUTION], setup[prepare_tables.SETUP_NAN] = resolution, np.nan
    outcome, tables, report = default_kernel().prepare(setup, wheel.definition(), rail.definition(), hertz_table(),
                                                       influence_table())
    if outcome == prepare_tables.PREPARED:
        return tables
    raise ValueError(refusal(outcome, report, wheel.name, rail.name))


def refusal(outcome, report, wheel, rail):
    """Why the tables could not be prepared, in a sentence."""
    if outcome == prepare_tables.GAUGE_TOO_DEEP:
        return (f"gauge_depth reaches {report[prepare_tables.REPORT_DEPTH]:.6g} m, but the inner side of the rail profile {rail} "
                f"ends at {report[prepare_tables.REPORT_DEEPEST]:.6g} m; permitted are smaller depths")
    if outcome == prepare_tables.WHEEL_TOO_WIDE:
        return (f"the wheel profile is {report[prepare_tables.REPORT_WIDTH]:.4g} m wide; permitted are at most "
                f"{layout.SCAN_LIMIT * FINE_STEP:.4g} m")
    if outcome == prepare_tables.WITHOUT_HEAD:
        return (f"the profiles {wheel} and {rail} are too steep at y = 0 m, the running circle and the rail's highest point; "
                "permitted are profiles with less slope there")
    return (f"the profiles {wheel} and {rail} have too many points for the kernel's tables; permitted are profiles with fewer "
            "points")
