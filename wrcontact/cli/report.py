"""Output of the command line: one state, a sweep, and CSV tables with the names of the FMU."""

import csv
import json
import math
from operator import attrgetter

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

from ..conventions import SIDES
from ..interface.inputs import INPUT_NAMES
from ..interface.outputs import PATCH, SIDE
from ..interface.rows import Blocks, Run
from ..interface.units import UNITS
from ..interface.variables import INPUT, INTEGER, OUTPUT, VARIABLES
from ..kernel import layout
from ..status import Status, explain
from ..storage.atomic import open_atomically

#: Digits after the point by display unit.
DIGITS = {"mm": 4, "deg": 4, "kN": 3, "kN.m": 3, "MPa": 1, "mm2": 2}
#: The end of some sentences of :func:`~wrcontact.status.explain`; it does not apply to a single evaluation.
KEPT = "; the outputs keep their last valid values"

VECTOR_AXES = ("x", "y", "z")
SIDE_ROWS = [(row.name, row.unit) for row in SIDE if not isinstance(row, (Blocks, Run)) and not row.whole]
PATCH_ROWS = [(row.name, row.unit) for row in PATCH]
OUTLINE_NAMES = [row.name for row in SIDE if isinstance(row, Run)]
#: Columns for each wheel in a printed sweep: heading, name, digits after the point.
SWEEP_COLUMNS = (("y_wheel", "contact.y_wheel", 3), ("area", "area", 1), ("pressure", "max_pressure", 0))


def sentence(status, inputs, compliant=False):
    """One sentence on a status at these seven inputs; "" for status 0."""
    return explain(status, inputs, compliant).removesuffix(KEPT)


def is_compliant(system):
    """Whether the contact mode is compliant: height and roll are inputs, and the loads follow."""
    return system.parameters["contact_mode"] == "compliant"


def shown(value, unit, digits=None):
    """A value in SI as text in the display unit; "-" for NaN."""
    value = float(value) * UNITS[unit].display_factor
    digits = DIGITS.get(UNITS[unit].display, 4) if digits is None else digits
    return "-" if math.isnan(value) else f"{round(value, digits) + 0.0:.{digits}f}"


def unit_name(unit):
    """The display unit's name; "" for plain numbers."""
    return UNITS[unit].display or ("" if unit == "1" else unit)


def console():
    """The rich console for tables, without markup."""
    return Console(markup=False, highlight=False)


# --- one state -----------------------------------------------------------------------------------


def print_state(system, state):
    """One state in display units, left and right side by side."""
    shift, yaw = state.inputs[:2]
    out = console()
    out.print(f"{system.wheel.name} on {system.rail.name}: lateral shift {shown(shift, 'm')} mm, yaw "
              f"{shown(yaw, 'rad')} deg, {load_words(system, state)}", soft_wrap=True)
    out.print(f"roll {shown(state.roll, 'rad')} deg, vertical shift {shown(state.vertical_shift, 'm')} mm, "
              f"status {int(state.status)} ({state.status.name.lower().replace('_', ' ')})", soft_wrap=True)
    out.print(f"contact forces on the wheelset {vector_words(state.force, 'N')}, moment about its centre "
              f"{vector_words(state.moment, 'N.m')}", soft_wrap=True)
    out.print(state_table(state))
    if state.status:
        out.print(sentence(state.status, state.inputs, is_compliant(system)), soft_wrap=True)


def load_words(system, state):
    """The load as text, or that height and roll are given."""
    if is_compliant(system):
        return "height and roll prescribed"
    force, transfer = state.inputs[[layout.IN_NORMAL_FORCE, layout.IN_LOAD_TRANSFER]]
    kind = "normal force" if system.parameters["load"] == "normal" else "vertical force"
    return f"{kind} {shown(force, 'N')} kN per wheel, load transfer {transfer:g}"


def vector_words(vector, unit):
    """Three components along the track's axes (forward, right, down) as text in display units."""
    return f"({', '.join(shown(getattr(vector, axis), unit) for axis in VECTOR_AXES)}) {unit_name(unit)}"


def state_table(state):
    """A table with the columns quantity, unit, left, right."""
    table = Table("quantity", "unit", box=box.SIMPLE_HEAD)
    for side in SIDES:
        table.add_column(side, justify="right")
    sides = [getattr(state, side) for side in SIDES]
    table.add_row("patch_count", "", *(str(side.patch_count) for side in sides))
    for name, unit in SIDE_ROWS:
        table.add_row(name, unit_name(unit), *(shown(attrgetter(name)(side), unit) for side in sides))
    most = max(side.patch_count for side in sides)
    for k in range(most if most > 1 else 0):
        table.add_section()
        for name, unit in PATCH_ROWS:
            table.add_row(f"patch[{k + 1}].{name}", unit_name(unit),
                          *(_of_patch(side, k, name, unit) for side in sides))
    return table


def _of_patch(side, k, name, unit):
    return shown(getattr(side.patches[k], name), unit) if k < len(side.patches) else ""


def state_text(system, state):
    """One state as JSON in SI, with the Python names; null where there is no value."""
    words = sentence(state.status, state.inputs, is_compliant(system))
    content = {"status": int(state.status), "explanation": words,
               "inputs": dict(zip(INPUT_NAMES, map(_plain, state.inputs))), "roll": _plain(state.roll),
               "vertical_shift": _plain(state.vertical_shift)}
    for name in ("force", "moment"):
        content[name] = {axis: _plain(getattr(getattr(state, name), axis)) for axis in VECTOR_AXES}
    return json.dumps({**content, **{side: _side_content(getattr(state, side)) for side in SIDES}}, indent=2)


def _side_content(side):
    content = {"patch_count": side.patch_count, "contact": {}}
    for name, _ in SIDE_ROWS:
        part = content["contact"] if name.startswith("contact.") else content
        part[name.removeprefix("contact.")] = _plain(attrgetter(name)(side))
    content["patches"] = [{name: _plain(getattr(patch, name)) for name, _ in PATCH_ROWS}
                          for patch in side.patches]
    content["outline"] = {name: [_plain(value) for value in getattr(side.outline, name)]
                          for name in OUTLINE_NAMES}
    return content


def _plain(value):
    """``value`` as a float for JSON; None for NaN and infinity."""
    return float(value) if math.isfinite(value) else None


# --- tables --------------------------------------------------------------------------------------


def columns_of(table):
    """Columns (n,) of a table of states in SI by FMU name: inputs, outputs, status."""
    columns = {v.name: table.inputs[:, v.index] for v in VARIABLES if v.causality == INPUT}
    columns |= {v.name: table.values[:, v.index] for v in VARIABLES if v.causality == OUTPUT
                and v.index is not None}
    return {**columns, "status": np.asarray(table.status)}


INTEGERS = {v.name for v in VARIABLES if v.type == INTEGER}


def write_table(path, columns):
    """Write ``columns`` (n,) by name to a CSV file with all digits; a cell without a value is empty."""
    with open_atomically(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(zip(*([_cell(name, value) for value in column] for name, column in columns.items())))


def _cell(name, value):
    if not math.isfinite(value):
        return ""
    return int(value) if name in INTEGERS else repr(float(value))


def print_sweep(table):
    """Print contact position, area and largest pressure of both wheels against the lateral shift, in display
    units."""
    units = dict(SIDE_ROWS)
    quantities = [("shift", table.inputs[:, 0], "m", 3), ("roll", table.roll, "rad", 4)]
    quantities += [(f"{side}\n{heading}", attrgetter(f"{side}.{name}")(table), units[name], digits)
                   for side in SIDES for heading, name, digits in SWEEP_COLUMNS]
    printed = Table(box=box.SIMPLE_HEAD)
    for heading, _, unit, _ in quantities:
        printed.add_column(f"{heading}\n{unit_name(unit)}", justify="right", vertical="bottom", no_wrap=True)
    for row in range(len(table)):
        printed.add_row(*(shown(values[row], unit, digits) for _, values, unit, digits in quantities))
    console().print(printed)


def sweep_remark(system, table):
    """One sentence on the rows that are not valid; "" if all are valid."""
    wrong = np.flatnonzero(np.asarray(table.status) != Status.VALID)
    if not len(wrong):
        return ""
    rows = f"{len(wrong)} of {len(table)} rows have" if len(wrong) > 1 else f"1 of {len(table)} rows has"
    first = sentence(table.status[wrong[0]], table.inputs[wrong[0]], is_compliant(system))
    return f"{rows} a status other than 0; the first: {first}"
