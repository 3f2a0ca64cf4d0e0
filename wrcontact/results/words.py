"""Values as text in display units, short texts of results, and tables in HTML."""

import math
from dataclasses import fields, is_dataclass
from html import escape

import numpy as np

from ..interface.units import UNITS

#: Digits after the point by display unit.
DIGITS = {"mm": 4, "deg": 4, "kN": 3, "kN.m": 3, "MPa": 1, "mm2": 2}
#: Rows of a table that its HTML shows.
HTML_ROWS = 10


#: Significant digits of small values, and the size below which they are rounding, in display units.
SIGNIFICANT, NOTHING = 4, 1e-9


def shown(value, unit, digits=None, significant=SIGNIFICANT):
    """A value in SI as text in the display unit; "-" for NaN.

    It has ``digits`` after the point, or as many as the unit has in DIGITS, and where these are fewer than
    ``significant`` digits, so many.

    >>> shown(-9.3567e-3, "m"), shown(1.6e-5, "1"), shown(0.0162, "N"), shown(1e-18, "m")
    ('-9.3567', '1.600e-05', '1.620e-05', '0.0000')
    """
    digits = DIGITS.get(UNITS[unit].display, 4) if digits is None else digits
    return fixed(float(value) * UNITS[unit].display_factor, digits, significant)


def fixed(value, digits, significant=1):
    """A number with ``digits`` after the point, or ``significant`` digits where it is smaller; "-" for NaN
    and infinity."""
    if not math.isfinite(value):
        return "-"
    if NOTHING < abs(value) < 10.0 ** (significant - 1 - digits):
        return f"{value:#.{significant}g}"
    return f"{round(value, digits) + 0.0:.{digits}f}"


def unit_name(unit):
    """The display unit's name; "" for plain numbers."""
    return UNITS[unit].display or ("" if unit == "1" else unit)


def short(value):
    """A number, or the range of an array, as text in SI with five digits."""
    if np.ndim(value) == 0:
        return f"{value:.5g}"
    finite = np.asarray(value)[np.isfinite(value)]
    if not finite.size:
        return "nan"
    low, high = f"{finite.min():.5g}", f"{finite.max():.5g}"
    return low if low == high else f"{low} ... {high}"


def plain(value):
    """``value`` for JSON, in terms of dicts, lists and plain numbers; None for NaN and infinity."""
    if is_dataclass(value):
        return {field.name: plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, dict):
        return {name: plain(entry) for name, entry in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(entry) for entry in value]
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    return value


class ShortText:
    """Base of dataclasses with arrays: their text has numbers in five digits, and of arrays and long tuples
    only the size."""

    def __repr__(self):
        shown = [f"{one.name}={_brief(getattr(self, one.name))}" for one in fields(self) if one.repr]
        return f"{type(self).__name__}({', '.join(shown)})"


def _brief(value):
    if isinstance(value, np.ndarray):
        return f"array {value.shape}"
    if isinstance(value, float):
        return short(value)
    text = repr(value) if not isinstance(value, (dict, list, tuple)) or len(value) < 4 else ""
    if 0 < len(text) < 60:
        return text
    return f"{type(value).__name__} of {len(value)}" if hasattr(value, "__len__") else type(value).__name__


def html_table(title, headings, rows):
    """A table in HTML: its ``title``, the ``headings`` of its columns and its ``rows`` of texts."""
    head = "".join(f"<th>{escape(heading)}</th>" for heading in headings)
    body = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return (
        f"<table><caption>{escape(title)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody>"
        "</table>"
    )
