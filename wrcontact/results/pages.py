"""States and tables of states in HTML, as Jupyter shows them."""

import numpy as np

from ..interface.outputs import SIDE
from ..interface.rows import single_numbers
from .layout import OUTPUTS
from .words import HTML_ROWS, html_table, shown, unit_name

#: Outputs of one wheel: names and units, without patches and outlines.
SIDE_ROWS = [row for row in single_numbers(SIDE) if row[0] != "patch_count"]
#: Columns of a table of states, where it has them.
COLUMNS = (
    "roll",
    *(
        f"{side}.{name}"
        for side in ("left", "right")
        for name in ("contact.y_wheel", "contact_angle", "area", "max_pressure")
    ),
)


def page(state):
    """The HTML of one state or of a table of states."""
    return _one(state) if state.values.ndim == 1 else _many(state)


def _one(state):
    sides = ("left", "right")
    rows = [("patch_count", "", *(shown(state[f"{side}.patch_count"], "1", 0, 1) for side in sides))]
    rows += [
        (name, unit_name(unit), *(shown(state[f"{side}.{name}"], unit) for side in sides))
        for name, unit in SIDE_ROWS
    ]
    title = (
        f"status {int(state.status)}, roll {shown(state.roll, 'rad')} deg, vertical shift "
        f"{shown(state.vertical_shift, 'm')} mm"
    )
    return html_table(title, ("quantity", "unit", *sides), rows)


def _many(table):
    names = [name for name in COLUMNS if name in table.names] or list(table.names[:8])
    units = {name: OUTPUTS[name].unit or "1" for name in names if name in OUTPUTS}
    headings = [
        "",
        "lateral_shift [mm]",
        *(f"{name} {_bracket(units.get(name, '1'))}" for name in names),
        "status",
    ]
    count = min(len(table), HTML_ROWS)
    shifts, columns = table["lateral_shift"], [(table[name], units.get(name, "1")) for name in names]
    rows = [
        (
            str(k),
            shown(shifts[k], "m"),
            *(shown(values[k], unit) for values, unit in columns),
            str(int(np.asarray(table.status)[k])),
        )
        for k in range(count)
    ]
    more = f"; the first {count}" if count < len(table) else ""
    return html_table(f"{table.summary}{more}", headings, rows)


def _bracket(unit):
    return f"[{unit_name(unit)}]" if unit_name(unit) else ""
