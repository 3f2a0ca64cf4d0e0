"""What is fixed during a simulation, prepared once into the one array that the kernel reads.

The kernel's own preparation (kernel/prepare_tables.py) lays it out from the profiles' definitions, in Python and in a native
FMU alike.  ``build_tables`` does the same in numpy from exact profiles: the witness of that, and for profiles placed by hand.
"""

import numpy as np

from .curvature_table import empty_curvature_table, rough_curvature_table, smooth_curvature_table
from .hertz_table import hertz_table
from .influence_table import influence_table
from .kernel import layout, prepare_tables, starts
from .kernel.library import default_kernel
from .profiles.compiled import compile_profile
from .profiles.definition import definition
from .profiles.scan import FINE_STEP, scan_table

LATERAL_LIMIT, YAW_LIMIT, START_STEP = prepare_tables.LATERAL_LIMIT, prepare_tables.YAW_LIMIT, prepare_tables.START_STEP

#: Where the kernel keeps the number of each method.
METHOD_SETTINGS = {"contact_mode": layout.SET_MODE, "load": layout.SET_LOAD, "normal_model": layout.SET_NORMAL_MODEL,
                   "separation": layout.SET_SEPARATION, "longitudinal_curvature": layout.SET_LONGITUDINAL,
                   "lateral_curvature": layout.SET_LATERAL}


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
    outcome, tables, report = default_kernel().prepare(setup, definition(wheel), definition(rail), hertz_table(),
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
                "permitted are profiles that can be read there")
    return (f"the profiles {wheel} and {rail} have too many points for the kernel's tables; permitted are profiles with fewer "
            "points")


def build_tables(wheel, placed_rail, *, nominal_radius, running_circle_distance, contact_modulus, methods, resolution,
                 curvature_step=0.2e-3, curvature_reach=3e-3):
    """Settings and tables (n,) for a readable wheel Profile and a PlacedRail; SI units.

    ``methods`` holds the kernel's number MODE_..., LOAD_..., MODEL_... of each method by its parameter's name (those left
    out are 0, the first choice), ``resolution`` is a :class:`~wrcontact.resolution.Resolution`.
    """
    lateral_curvature = methods.get("lateral_curvature", layout.LATERAL_ADAPTIVE)
    wheel_table, rail_table = compile_profile(wheel), compile_profile(placed_rail.profile)
    parts = {
        layout.SET_WHEEL: wheel_table,
        layout.SET_RAIL: rail_table,
        layout.SET_SCAN: scan_table(wheel_table, rail_table),
        layout.SET_HERTZ: hertz_table(),
        layout.SET_INFLUENCE: influence_table(),
        layout.SET_STARTS: empty_starts(),
        layout.SET_WHEEL_CURVATURE: curvature_table(wheel_table, -1.0, lateral_curvature, curvature_step, curvature_reach),
        layout.SET_RAIL_CURVATURE: curvature_table(rail_table, 1.0, lateral_curvature, curvature_step, curvature_reach),
    }
    settings = np.zeros(layout.SETTING_COUNT)
    settings[layout.SET_RADIUS] = nominal_radius
    settings[layout.SET_ARM] = 0.5 * running_circle_distance
    settings[layout.SET_RAIL_Y] = placed_rail.y_track
    settings[layout.SET_CONTACT_MODULUS] = contact_modulus
    settings[layout.SET_LATERAL_LIMIT] = LATERAL_LIMIT
    settings[layout.SET_YAW_LIMIT] = YAW_LIMIT
    settings[[layout.SET_NODES, layout.SET_STRIDE, layout.SET_STRIPS, layout.SET_SWEEPS]] = resolution
    settings[[layout.SET_PENETRATION_LEFT, layout.SET_PENETRATION_RIGHT]] = np.nan
    settings[layout.SET_SIDES], settings[layout.SET_DEPTH] = layout.SIDES_BOTH, layout.DEPTH_ALL
    settings[layout.SET_ABSENT] = np.nan
    settings[layout.SET_STATIONS] = layout.STATION_COUNT
    offset = len(settings)
    for setting, table in parts.items():
        settings[setting] = offset
        offset += len(table)
    tables = np.concatenate([settings, *parts.values()])
    fill_starts(tables)
    for name, number in methods.items():
        tables[METHOD_SETTINGS[name]] = number
    return tables


def curvature_table(profile, sign, kind, step, reach):
    """What the lateral curvature ``kind``, one of LATERAL_..., reads of a compiled profile; ``sign`` as in
    curvature_table.py."""
    if kind == layout.LATERAL_SMOOTH:
        return smooth_curvature_table(profile, sign, reach)
    if kind == layout.LATERAL_ROUGH:
        return rough_curvature_table(profile, sign, step)
    return empty_curvature_table()


def empty_starts():
    """Table of starts with nothing known; layout in wrcontact/kernel/starts.py."""
    count = 2 * round(LATERAL_LIMIT / START_STEP) + 1
    table = np.zeros(starts.START_ROWS + starts.START_ROW * count)
    table[starts.START_COUNT] = count
    table[starts.START_FIRST], table[starts.START_PER_METRE] = -LATERAL_LIMIT, 1.0 / START_STEP
    return table


def fill_starts(tables):
    """Roll and contacts at the table of starts' lateral shifts, from the kernel itself, in one sweep without load."""
    base = int(tables[layout.SET_STARTS])
    count, first, per_metre = tables[base:base + starts.START_ROWS]
    state, inputs, outputs = (np.zeros(size) for size in (layout.STATE_SIZE, layout.INPUT_COUNT, layout.OUTPUT_COUNT))
    bound = default_kernel().bind(tables, state, np.zeros(layout.WORK_SIZE), inputs, outputs)
    rows = tables[base + starts.START_ROWS:][:starts.START_ROW * int(count)].reshape(-1, starts.START_ROW)
    found = np.zeros_like(rows)
    for row, shift in zip(found, first + np.arange(count) / per_metre):
        inputs[layout.IN_LATERAL_SHIFT] = shift
        if bound.step() <= layout.UNLOADED:
            row[[starts.START_KNOWN, starts.START_ROLL]] = 1.0, outputs[layout.OUT_ROLL]
            row[starts.START_LEFT] = outputs[layout.OUT_LEFT + layout.SIDE_Y_WHEEL]
            row[starts.START_RIGHT] = outputs[layout.OUT_RIGHT + layout.SIDE_Y_WHEEL]
    rows[:] = found
