"""What is fixed during a simulation, prepared once into the arrays that the kernel reads: one for each side,
or one for both where they are equal.

The kernel's own preparation (kernel/prepare/tables.py) lays it out from the profiles' definitions, in Python
and in a native FMU alike.
"""

import numpy as np

from .fixed_tables import fixed_tables
from .. import layout
from ..prepare import tables as prepare_tables
from .library import default_kernel
from ..prepare.scan import FINE_STEP
from ...interface.parameters import KERNEL_PARAMETERS, PARAMETERS, on_the_left

#: Place in the setup of every parameter that the kernel has.
PLACES = {name: layout.SETUP_PARAMETERS + k for k, name in enumerate(KERNEL_PARAMETERS)}


def setup_of(parameters, methods):
    """The kernel's setup (n,) of the right side for checked ``parameters`` and the objects of all
    ``methods``, by name; that of the left side for those of :func:`on_the_left`."""
    setup = np.full(layout.SETUP_SIZE, np.nan)
    for name, place in PLACES.items():
        value = methods[name].kernel_number if name in methods else parameters[name]
        setup[place] = PARAMETERS[name].start if value is None else value
    resolution = methods["normal_model"].resolution
    setup[layout.SETUP_RESOLUTION:][:len(resolution)] = resolution
    radii = parameters["nominal_radius"], on_the_left(parameters)["nominal_radius"]
    setup[layout.SETUP_HEIGHT] = 0.5 * (radii[0] + radii[1])
    return setup


def prepare_sides(right, left, *, parameters, methods):
    """Settings and tables (n,) of the right and of the left side, the same array where both are equal.

    Parameters
    ----------
    right, left : (wheel, rail), the upright profiles of each side.
    parameters, methods : as for :func:`setup_of`.

    Raises
    ------
    ValueError
        where profiles and parameters do not fit each other, in a sentence.
    """
    setups = setup_of(parameters, methods), left_setup(parameters, methods)
    definitions = [[profile.definition() for profile in side] for side in (right, left)]
    tables = prepare_side(setups[0], *definitions[0], *right)
    equal = all(np.array_equal(*both, equal_nan=True) for both in (setups, *zip(*definitions)))
    left_tables = tables if equal else prepare_side(setups[1], *definitions[1], *left)
    default_kernel().complete(setups[0], left_tables, tables)
    return tables, left_tables


def left_setup(parameters, methods):
    """The kernel's setup (n,) of the left side; the rest as for :func:`setup_of`."""
    setup = setup_of(on_the_left(parameters), methods)
    setup[layout.SETUP_HEIGHT] = setup_of(parameters, methods)[layout.SETUP_HEIGHT]
    return setup


def prepare_side(setup, wheel_definition, rail_definition, wheel, rail):
    """The tables (n,) of one side without starts and methods, for definitions of the profiles ``wheel`` and
    ``rail``."""
    rolling = setup[PLACES["tangential_model"]] != layout.TANGENTIAL_NONE
    outcome, tables, report = default_kernel().prepare(setup, wheel_definition, rail_definition,
                                                       fixed_tables(bool(rolling)))
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
