"""The kernel's tables by numpy from exact profiles: the witness of the kernel's own preparation
(kernel/prepare/tables.py)."""

import numpy as np

from tests.helpers.numpy_arcs import arc_tables
from tests.helpers.numpy_curvatures import (
    empty_curvature_table,
    rough_curvature_table,
    smooth_curvature_table,
)
from tests.helpers.numpy_profiles import compile_profile
from tests.helpers.numpy_scan import scan_table
from wrcontact.interface.inputs import LATERAL_LIMIT, YAW_LIMIT
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import hertz_table, influence_table
from wrcontact.kernel.binding.library import default_kernel
from wrcontact.kernel.prepare.tables import START_STEP

#: Where the kernel keeps the number of each method.
METHOD_SETTINGS = {"contact_mode": layout.SET_MODE, "load": layout.SET_LOAD,
                   "normal_model": layout.SET_NORMAL_MODEL, "separation": layout.SET_SEPARATION,
                   "longitudinal_curvature": layout.SET_LONGITUDINAL, "lateral_curvature": layout.SET_LATERAL,
                   "tangential_model": layout.SET_TANGENTIAL}


def build_tables(wheel, placed_rail, *, nominal_radius, running_circle_distance, contact_modulus, methods,
                 resolution, curvature_step=0.2e-3, curvature_reach=3e-3, shear_modulus=8e10):
    """Settings and tables (n,) for a readable wheel Profile and a PlacedRail; SI units.

    ``methods`` holds the kernel's number MODE_..., LOAD_..., MODEL_... of each method by its parameter's name
    (those left out are 0, the first choice), ``resolution`` is a :class:`~wrcontact.methods.Resolution`.
    """
    lateral_curvature = methods.get("lateral_curvature", layout.LATERAL_ADAPTIVE)
    wheel_table, rail_table = compile_profile(wheel), compile_profile(placed_rail.profile)
    arc, at_arc = arc_tables(rail_table)
    parts = {
        layout.SET_WHEEL: wheel_table,
        layout.SET_RAIL: rail_table,
        layout.SET_SCAN: scan_table(wheel_table, rail_table, nominal_radius, 0.5 * running_circle_distance),
        layout.SET_HERTZ: hertz_table(),
        layout.SET_INFLUENCE: influence_table(),
        layout.SET_STARTS: empty_starts(),
        layout.SET_WHEEL_CURVATURE: curvature_table(wheel_table, -1.0, lateral_curvature, curvature_step,
                                                    curvature_reach),
        layout.SET_RAIL_CURVATURE: curvature_table(rail_table, 1.0, lateral_curvature, curvature_step,
                                                   curvature_reach),
        layout.SET_RAIL_ARC: arc, layout.SET_RAIL_AT_ARC: at_arc,
    }
    settings = np.zeros(layout.SETTING_COUNT)
    settings[layout.SET_RADIUS] = settings[layout.SET_HEIGHT] = nominal_radius
    settings[layout.SET_ARM] = 0.5 * running_circle_distance
    settings[layout.SET_RAIL_Y] = placed_rail.y_track
    settings[layout.SET_CONTACT_MODULUS] = contact_modulus
    settings[layout.SET_SHEAR_MODULUS] = shear_modulus
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
    numpy_curvatures.py."""
    if kind == layout.LATERAL_SMOOTH:
        return smooth_curvature_table(profile, sign, reach)
    if kind == layout.LATERAL_ROUGH:
        return rough_curvature_table(profile, sign, step)
    return empty_curvature_table()


def empty_starts():
    """The record Starts with nothing known."""
    table = np.zeros(layout.STARTS_SIZE)
    starts = layout.Starts.at(table)
    assert layout.START_COUNT == 2 * round(LATERAL_LIMIT / START_STEP) + 1
    starts.count, starts.first_shift, starts.per_metre = layout.START_COUNT, -LATERAL_LIMIT, 1.0 / START_STEP
    return table


def fill_starts(tables):
    """Roll and contacts at the table of starts' lateral shifts, from the kernel itself, in
    one sweep without load."""
    starts = layout.Tables.at(tables).starts
    state, inputs, outputs = (np.zeros(size)
                              for size in (layout.STATE_SIZE, layout.INPUT_COUNT, layout.OUTPUT_COUNT))
    bound = default_kernel().bind(tables, state, np.zeros(layout.WORK_SIZE), inputs, outputs)
    found = np.zeros(layout.START_COUNT, layout.Start)
    result = layout.Outputs.at(outputs)
    for row, shift in zip(found, starts.first_shift + np.arange(layout.START_COUNT) / starts.per_metre):
        inputs[layout.IN_LATERAL_SHIFT] = shift
        if bound.step() <= layout.UNLOADED:
            row["_known"], row["roll"] = 1.0, result.roll
            row["left"], row["right"] = result.left[0].y_wheel, result.left[1].y_wheel
    # a wheelset and its mirror image start alike
    middle = layout.START_COUNT // 2
    mirror = found[:middle:-1]
    found["roll"][:middle], found["roll"][middle] = -mirror["roll"], 0.0
    found["left"][:middle], found["right"][:middle] = mirror["right"], mirror["left"]
    found["left"][middle] = found["right"][middle]
    for row, one in zip(starts.rows, found):
        row.known, row.roll, row.left, row.right = (one["_known"] == 1.0, one["roll"], one["left"],
                                                    one["right"])
