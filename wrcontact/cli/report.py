"""Output of the command line: one state, and a sweep."""

import json
import math
from operator import attrgetter

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

from ..conventions import SIDES
from ..interface.inputs import INPUTS
from ..interface.outputs import PATCH, SIDE
from ..interface.rows import single_numbers
from ..kernel import layout
from ..results.words import plain, shown, unit_name
from ..status import Status, explain
from .typed import SWEEP, Typed

VECTOR_AXES = ("x", "y", "z")
#: What only creep forces give, and the parts of a force without them.
OF_CREEP = (
    "tangential.",
    "stick_share",
    "max_shear",
    "friction_power",
    "saturation",
    "wear_number",
    "driving_torque",
    "normal.",
)
SIDE_NUMBERS = [row for row in single_numbers(SIDE) if row[0] != "patch_count"]
SIDE_ROWS = [row for row in SIDE_NUMBERS if not row[0].startswith(OF_CREEP)]
SIDE_CREEP_ROWS = [row for row in SIDE_NUMBERS if row[0].startswith(OF_CREEP)]
PATCH_ROWS = [row for row in single_numbers(PATCH) if not row[0].startswith(("creepage.", *OF_CREEP))]
CREEPAGE_ROWS = [row for row in single_numbers(PATCH) if row[0].startswith("creepage.")]
CREEP_ROWS = [row for row in single_numbers(PATCH) if row[0].startswith(OF_CREEP)]
#: Places of the inputs without all of which nothing rolls.
RATES = [place for place, row in enumerate(INPUTS) if row.unit in ("m/s", "rad/s")]
#: Columns for each wheel in a printed sweep: heading, name, unit, digits after the point; the others with
#: creep forces: which share of the friction is used, and its power.
SWEEP_COLUMNS = (
    ("y_wheel", "contact.y_wheel", "m", 3),
    ("area", "area", "m2", 1),
    ("pressure", "max_pressure", "Pa", 0),
)
CREEP_COLUMNS = (
    ("y_wheel", "contact.y_wheel", "m", 3),
    ("used", "patch[1].saturation", "1", 3),
    ("power", "friction_power", "W", 3),
)


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
    out.print(
        f"{system.title}: lateral shift {shown(shift, 'm')} mm, yaw "
        f"{shown(yaw, 'rad')} deg, {load_words(system, state)}",
        soft_wrap=True,
    )
    out.print(
        f"roll {shown(state.roll, 'rad')} deg, vertical shift {shown(state.vertical_shift, 'm')} mm, "
        f"status {int(state.status)} ({state.status.name.lower().replace('_', ' ')})",
        soft_wrap=True,
    )
    out.print(
        f"contact forces on the wheelset {vector_words(state.force, 'N')}, moment about its centre "
        f"{vector_words(state.moment, 'N.m')}",
        soft_wrap=True,
    )
    with_creep = has_creep_forces(system, state.inputs)
    if with_creep:
        out.print(
            f"of these without creep forces {vector_words(state.normal.force, 'N')}, "
            f"{vector_words(state.normal.moment, 'N.m')}; driving torque "
            f"{shown(state.driving_torque, 'N.m')} {unit_name('N.m')}",
            soft_wrap=True,
        )
    elif has_model(system):
        out.print("no creep forces: neither --speed nor --wheel-rate is given", soft_wrap=True)
    out.print(state_table(state, with_creep))
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


def has_model(system):
    """Whether creep forces are computed for a wheelset that rolls."""
    return system.parameters["tangential_model"] != "none"


def has_creep_forces(system, inputs):
    """Whether there are creep forces at these inputs, of one pose or of all in a sweep."""
    return has_model(system) and is_rolling(inputs)


def state_table(state, with_creep=False):
    """A table with the columns quantity, unit, left, right; ``with_creep`` tells whether there are creep
    forces."""
    table = Table("quantity", "unit", box=box.SIMPLE_HEAD)
    for side in SIDES:
        table.add_column(side, justify="right")
    sides = [getattr(state, side) for side in SIDES]
    table.add_row("patch_count", "", *(str(side.patch_count) for side in sides))
    for name, unit in SIDE_ROWS + SIDE_CREEP_ROWS * with_creep:
        table.add_row(name, unit_name(unit), *(shown(attrgetter(name)(side), unit) for side in sides))
    most = max(side.patch_count for side in sides)
    rows = PATCH_ROWS * (most > 1) + CREEPAGE_ROWS * is_rolling(state.inputs) + CREEP_ROWS * with_creep
    for k in range(most if rows else 0):
        table.add_section()
        for name, unit in rows:
            table.add_row(
                f"patch[{k + 1}].{name}", unit_name(unit), *(_of_patch(side, k, name, unit) for side in sides)
            )
    return table


def is_rolling(inputs):
    """Whether there are creepages at these inputs."""
    return bool(inputs[..., RATES].any())


def _of_patch(side, k, name, unit):
    if k >= len(side.patches):
        return ""
    return shown(attrgetter(name)(side.patches[k]), unit)


def state_text(system, state):
    """One state as JSON in SI, with the Python names; null where there is no value."""
    content = state.to_dict()
    words = sentence(state.status, state.inputs, is_compliant(system))
    return json.dumps(plain({"status": content.pop("status"), "explanation": words, **content}), indent=2)


# --- sweeps --------------------------------------------------------------------------------------


def sweep_outputs(columns):
    """Outputs that a printed sweep shows with these columns for each wheel."""
    return ["roll", *(f"{side}.{name}" for side in SIDES for _, name, _, _ in columns)]


def sweep_columns(system, given):
    """Columns for each wheel in a sweep whose inputs are ``given`` by name."""
    rolling = any(given.get(name) for name in ("speed", "wheel_rate", "left_wheel_rate", "right_wheel_rate"))
    return CREEP_COLUMNS if has_model(system) and rolling else SWEEP_COLUMNS


def print_sweep(table, step, columns=SWEEP_COLUMNS):
    """Print the ``columns`` of both wheels against the lateral shift, whose steps are ``step`` [mm], in
    display units."""
    digits_of_shift = max(3, min(9, 1 - math.floor(math.log10(step))))
    quantities = [("shift", table["lateral_shift"], "m", digits_of_shift), ("roll", table["roll"], "rad", 4)]
    quantities += [
        (f"{side}\n{heading}", table[f"{side}.{name}"], unit, digits)
        for side in SIDES
        for heading, name, unit, digits in columns
    ]
    printed = Table(box=box.SIMPLE_HEAD)
    for heading, _, unit, _ in quantities:
        printed.add_column(f"{heading}\n{unit_name(unit)}", justify="right", vertical="bottom", no_wrap=True)
    for row in range(len(table)):
        printed.add_row(*(shown(values[row], unit, digits, 3) for _, values, unit, digits in quantities))
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
