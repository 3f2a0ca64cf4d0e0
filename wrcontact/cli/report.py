"""Output of the command line: one state, and a sweep."""

import json
import math
from operator import attrgetter

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

from ..conventions import SIDES
from ..interface.outputs import PATCH, SIDE
from ..interface.rows import single_numbers
from ..kernel import layout
from ..results.words import shown, unit_name
from ..status import Status, explain
from .terms import SWEEP, Typed

VECTOR_AXES = ("x", "y", "z")
SIDE_ROWS = [row for row in single_numbers(SIDE) if row[0] != "patch_count"]
PATCH_ROWS = [row for row in single_numbers(PATCH) if not row[0].startswith("creepage.")]
CREEPAGE_ROWS = [row for row in single_numbers(PATCH) if row[0].startswith("creepage.")]
#: Columns for each wheel in a printed sweep: heading, name, digits after the point.
SWEEP_COLUMNS = (("y_wheel", "contact.y_wheel", 3), ("area", "area", 1), ("pressure", "max_pressure", 0))


def sentence(status, inputs, compliant=False, terms=None):
    """One sentence on a status at these seven inputs, in :class:`~wrcontact.status.Terms`; "" for status
    0."""
    return explain(status, inputs, compliant, terms)


def is_compliant(system):
    """Whether the contact mode is compliant: height and roll are inputs, and the loads follow."""
    return system.parameters["contact_mode"] == "compliant"


def console():
    """The rich console for tables, without markup."""
    return Console(markup=False, highlight=False)


# --- one state -----------------------------------------------------------------------------------


def print_state(system, state):
    """One state in display units, left and right side by side."""
    shift, yaw = state.inputs[:2]
    out = console()
    out.print(f"{system.title}: lateral shift {shown(shift, 'm')} mm, yaw "
              f"{shown(yaw, 'rad')} deg, {load_words(system, state)}", soft_wrap=True)
    out.print(f"roll {shown(state.roll, 'rad')} deg, vertical shift {shown(state.vertical_shift, 'm')} mm, "
              f"status {int(state.status)} ({state.status.name.lower().replace('_', ' ')})", soft_wrap=True)
    out.print(f"contact forces on the wheelset {vector_words(state.force, 'N')}, moment about its centre "
              f"{vector_words(state.moment, 'N.m')}", soft_wrap=True)
    out.print(state_table(state))
    if state.status:
        out.print(sentence(state.status, state.inputs, is_compliant(system), Typed()), soft_wrap=True)


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
    rows = PATCH_ROWS * (most > 1) + CREEPAGE_ROWS * is_rolling(state)
    for k in range(most if rows else 0):
        table.add_section()
        for name, unit in rows:
            table.add_row(f"patch[{k + 1}].{name}", unit_name(unit),
                          *(_of_patch(side, k, name, unit) for side in sides))
    return table


def is_rolling(state):
    """Whether a pose has creepages."""
    return bool(state.inputs[[layout.IN_SPEED, layout.IN_WHEEL_RATE]].any())


def _of_patch(side, k, name, unit):
    return shown(attrgetter(name)(side.patches[k]), unit) if k < len(side.patches) else ""


def state_text(system, state):
    """One state as JSON in SI, with the Python names; null where there is no value."""
    content = state.to_dict()
    words = sentence(state.status, state.inputs, is_compliant(system))
    return json.dumps(_plain({"status": content.pop("status"), "explanation": words, **content}), indent=2)


def _plain(value):
    """``value`` for JSON; None for NaN and infinity."""
    if isinstance(value, dict):
        return {name: _plain(entry) for name, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


# --- sweeps --------------------------------------------------------------------------------------

#: Outputs that a printed sweep shows.
SWEEP_OUTPUTS = ["roll", *(f"{side}.{name}" for side in SIDES for _, name, _ in SWEEP_COLUMNS)]


def print_sweep(table, step):
    """Print contact position, area and largest pressure of both wheels against the lateral shift, whose steps
    are ``step`` [mm], in display units."""
    units = dict(SIDE_ROWS)
    digits_of_shift = max(3, min(9, 1 - math.floor(math.log10(step))))
    quantities = [("shift", table["lateral_shift"], "m", digits_of_shift), ("roll", table["roll"], "rad", 4)]
    quantities += [(f"{side}\n{heading}", table[f"{side}.{name}"], units[name], digits)
                   for side in SIDES for heading, name, digits in SWEEP_COLUMNS]
    printed = Table(box=box.SIMPLE_HEAD)
    for heading, _, unit, _ in quantities:
        printed.add_column(f"{heading}\n{unit_name(unit)}", justify="right", vertical="bottom", no_wrap=True)
    for row in range(len(table)):
        printed.add_row(*(shown(values[row], unit, digits) for _, values, unit, digits in quantities))
    console().print(printed)


class Remark:
    """What is to be said on the rows of a sweep that are not valid, part after part."""

    def __init__(self, system):
        self.compliant, self.rows, self.wrong, self.useless, self.first = is_compliant(system), 0, 0, True, ""

    def add(self, table):
        """Take the next part of the table into account."""
        wrong = np.flatnonzero(table.status != Status.VALID)
        if len(wrong) and not self.first:
            self.first = sentence(table.status[wrong[0]], table.inputs[wrong[0]], self.compliant, SWEEP)
        self.rows += len(table)
        self.wrong += len(wrong)
        self.useless &= bool(np.all(table.status > Status.UNLOADED))

    def words(self):
        """One sentence; "" if all rows are valid."""
        if not self.wrong:
            return ""
        have = "rows have" if self.wrong > 1 else "row has" if self.rows == 1 else "rows has"
        return f"{self.wrong} of {self.rows} {have} a status other than 0; the first: {self.first}"
