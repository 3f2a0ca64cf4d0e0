"""What is fixed during a simulation, prepared once into the array that the kernel reads.

The kernel's own preparation (kernel/prepare/tables.py) lays it out from the profiles' definitions, in Python
and in a native FMU alike.
"""

import numpy as np

from .fixed_tables import fixed_tables
from .. import layout
from ..prepare import tables as prepare_tables
from .library import default_kernel
from ..prepare.scan import FINE_STEP, TOO_WIDE
from ...interface.parameters import KERNEL_PARAMETERS, PARAMETERS, RAIL_SPRINGS, on_the_left

#: Place in the setup of every parameter that the kernel has.
PLACES = {name: layout.Setup.parameters.offset // 8 + k for k, name in enumerate(KERNEL_PARAMETERS)}


def setup_of(parameters, methods):
    """The kernel's setup (n,) for checked ``parameters`` and the objects of all ``methods``, by name."""
    array = np.full(layout.SETUP_SIZE, np.nan)
    for name, place in PLACES.items():
        value = methods[name].kernel_number if name in methods else parameters[name]
        array[place] = PARAMETERS[name].start if value is None else value
    setup = layout.Setup.at(array)
    setup.resolution[:] = methods["normal_model"].resolution
    left = on_the_left(parameters)
    setup.left_radius, setup.left_inclination = left["nominal_radius"], left["rail_inclination"]
    setup.left_spring[:] = [left[name] for name in RAIL_SPRINGS]
    return array


def prepare_sides(right, left, *, parameters, methods):
    """Settings and tables (n,) of a wheelset.

    Parameters
    ----------
    right, left : (wheel, rail), the upright profiles of each side.
    parameters, methods : as for :func:`setup_of`.

    Raises
    ------
    ValueError
        where profiles and parameters do not fit each other, in a sentence.
    """
    array = setup_of(parameters, methods)
    rolling = array[PLACES["tangential_model"]] != layout.TANGENTIAL_NONE
    definitions = [profile.definition() for profile in (*right, *left)]
    used, tables = default_kernel().prepare(array, *definitions, fixed_tables(bool(rolling)))
    if used >= 0:
        return tables
    setup = layout.Setup.at(array)
    raise ValueError(refusal(used, setup, *(profile.name for profile in (right if setup.side else left))))


def profile_tables(tables, index):
    """What the kernel reads of a side's profiles in its ``tables`` (n,), 0 left and 1 right: wheel (m,) and
    rail (k,) for ``wrcontact.profiles.compiled.evaluate_table``, and the track coordinate of the rail's
    highest point [m], each as those of a right side."""
    pair = layout.Tables.at(tables).pairs[index]
    wheel, wheel_end, rail, rail_end = (
        layout.offset(part, tables)
        for part in (pair.wheel, pair.wheel_curvature, pair.rail, pair.rail_curvature)
    )
    return tables[wheel:wheel_end], tables[rail:rail_end], pair.rail_y


def refusal(reason, setup, wheel, rail):
    """Why the tables could not be prepared, in a sentence."""
    if reason == prepare_tables.GAUGE_TOO_DEEP:
        return (
            f"gauge_depth reaches {setup.depth:.6g} m, but the inner side of the "
            f"rail profile {rail} ends at {setup.reached:.6g} m; permitted are "
            "smaller depths"
        )
    if reason == TOO_WIDE:
        return (
            f"the wheel profile is {setup.width:.4g} m wide; permitted are at "
            f"most {layout.SCAN_LIMIT * FINE_STEP:.4g} m"
        )
    if reason == prepare_tables.WITHOUT_HEAD:
        return (
            f"the profiles {wheel} and {rail} are too steep at y = 0 m, the running circle and the "
            "rail's highest point; permitted are profiles with less slope there"
        )
    return (
        f"the profiles {wheel} and {rail} have too many points for the kernel's tables; permitted are "
        "profiles with fewer points"
    )
