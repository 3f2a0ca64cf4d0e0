"""Files of sections: CONTACT's slice files, .slcs, and our own .toml.

A slice file of CONTACT (Vtech CMCC, User guide, "Rail profiles along the track") has lines of numbers, "%" begins a
comment:

    U_OFFSET U_SCALE      positions are U_SCALE (U_OFFSET + U) in mm
    NSLC                  number of slices
    NFEAT NKINK NACCEL    numbers of features, kinks and accelerations
    U_INTPOL              1: through the slices, 2: smooth along them
    U 'file'              NSLC lines, files beside the slice file
    U S_1 ... S_NFEAT     NSLC lines if NFEAT > 1: lengths of the features in mm, negative where a slice has none

Sections are in any format of rail profiles, in mm or m.
"""

import os
import re

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..profiles.formats import read_points
from ..profiles.remarks import Refusal, remark

#: Factors to metres.
UNITS = {"m": 1.0, "mm": MM}
#: A section that is narrower than this many mm is in metres.
NARROW = 1.0
#: Most bytes of a file, and most slices.
LARGEST, MOST_SLICES = 4_000_000, 2_000
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eEdD][+-]?\d+)?$")
TABLES = {"slice": {"position", "file", "features"}}
KEYS = {"kind", "name", "unit", "position_unit", "slice"}
KIND = "rail sections"


def read_sections(path):
    """The arguments of :class:`~wrcontact.RailSections` in the file ``path``."""
    path = os.fspath(path)
    name, ending = os.path.splitext(os.path.basename(path))
    readers = {".slcs": read_slices, ".toml": read_toml}
    if ending.lower() not in readers:
        raise ValueError(f"rail sections {path} ends in {ending or 'nothing'}; permitted are .slcs and .toml")
    try:
        return {"name": name, **readers[ending.lower()](_text(path), os.path.dirname(path))}
    except Refusal as problem:
        raise ValueError(f"rail sections {path} {problem}") from None


def _text(path):
    with open(path, "rb") as file:
        content = file.read(LARGEST + 1)
    if len(content) > LARGEST:
        raise Refusal(f"has more than {LARGEST / 1e6:g} MB; permitted are files of at most that")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def read_slices(text, folder):
    """Positions, profiles and features in the ``text`` of a .slcs, whose files are in ``folder``."""
    lines = _Lines(text)
    offset, scale = lines.numbers(2, "U_OFFSET and U_SCALE")
    count = lines.whole("NSLC, the number of slices", 2, MOST_SLICES)
    features, kinks, bends = (int(value) for value in lines.numbers(3, "NFEAT, NKINK and NACCEL"))
    if kinks or bends:
        raise Refusal(
            f"has {kinks} kinks and {bends} accelerations between parts; permitted are files without, whose sections "
            "are smooth between their features"
        )
    method = lines.numbers(1, "U_INTPOL", more=True)
    if method[0] not in (1.0, 2.0) or any(method[1:]):
        raise Refusal(
            f"has U_INTPOL {' '.join(f'{value:g}' for value in method)}; permitted are 1 and 2, without PERTURB"
        )
    if method[0] == 2.0:
        remark(
            "rail",
            "sections",
            ["U_INTPOL 2 asks for smoothing along the track: the surface goes through the slices"],
        )
    rows = [lines.slice(k, count) for k in range(count)]
    positions = scale * (offset + np.array([row[0] for row in rows])) * MM
    table = None
    if features > 1:
        table = np.array(
            [lines.numbers(1 + features, f"slice and {features} features", row=k + 1) for k in range(count)]
        )
        apart = np.abs(table[:, 0] - [row[0] for row in rows]) > 1e-6 * (1.0 + np.abs(table[:, 0]))
        if apart.any():
            k = int(np.argmax(apart))
            raise Refusal(
                f"has features for {table[k, 0]:g} where slice {k + 1} is at {rows[k][0]:g}; permitted are the same "
                "positions in both lists"
            )
        table = table[:, 1:] * MM
    points = [section_points(folder, row[1], k + 1) for k, row in enumerate(rows)]
    return {"positions": positions, "profiles": in_metres(points, None), "features": table}


class _Lines:
    """The lines of a slice file that have something but comments."""

    def __init__(self, text):
        stripped = ((k, line.split("%")[0].strip()) for k, line in enumerate(text.splitlines(), start=1))
        self._lines = [(k, line) for k, line in stripped if line]
        self._next = 0

    def _line(self, what):
        if self._next == len(self._lines):
            raise Refusal(f"ends where a line should have {what}")
        self._next += 1
        return self._lines[self._next - 1]

    def numbers(self, count, what, more=False, row=None):
        """``count`` numbers at the beginning of the next line; with ``more`` all there are."""
        where = what if row is None else f"{what} of row {row}"
        number, line = self._line(where)
        found = []
        for word in line.replace(",", " ").split():
            if not NUMBER.match(word):
                break
            found.append(float(word.lower().replace("d", "e")))
        if len(found) < count or not np.isfinite(found).all():
            raise Refusal(f"has {line!r} in line {number}; permitted is {where}: {count} numbers")
        return found if more else found[:count]

    def whole(self, what, least, most):
        value = self.numbers(1, what)[0]
        if value != int(value) or not least <= value <= most:
            raise Refusal(f"has {value:g} as {what}; permitted are {least} ... {most}")
        return int(value)

    def slice(self, k, count):
        """Position and file of a slice."""
        number, line = self._line(f"position and file of slice {k + 1} of {count}")
        found = re.match(r"(\S+)\s+(?:'([^']+)'|\"([^\"]+)\")", line)
        if not found or not NUMBER.match(found[1]):
            raise Refusal(
                f"has {line!r} in line {number}; permitted is slice {k + 1} of {count}: a position and 'file'"
            )
        return float(found[1].lower().replace("d", "e")), found[2] or found[3]


def section_points(folder, file, number):
    """Points (k, 2) of a section in the unit of its ``file``, which belongs to slice ``number``."""
    path = os.path.join(folder, *re.split(r"[\\/]", file)) if not os.path.isabs(file) else file
    try:
        text = _text(path)
    except OSError as problem:
        raise Refusal(f"has slice {number} in {file!r}, which cannot be read ({problem.strerror})") from None
    try:
        points = read_points(text, os.path.splitext(path)[1].lower(), "rail")
    except Refusal as problem:
        raise Refusal(f"has slice {number} in {file!r}, which {problem}") from None
    return np.column_stack([points.y, points.z])


def in_metres(points, unit):
    """Sections in metres; without a ``unit`` narrow ones are in metres and wide ones in millimetres."""
    if unit is None:
        widest = max(np.ptp(part[:, 0]) for part in points)
        unit = "m" if widest < NARROW else "mm"
    return [part * UNITS[unit] for part in points]


def read_toml(text, folder):
    """As :func:`read_slices`, of a .toml.

    It has ``kind`` = "rail sections", ``unit`` of the sections' points and of features, and ``position_unit``, each "m"
    or "mm" and "m" by default, and tables ``[[slice]]`` with ``position``, ``file`` and maybe ``features``.
    """
    try:
        import tomllib  # since Python 3.11
    except ImportError:
        raise Refusal("is TOML, which Python reads from version 3.11; permitted before is .slcs") from None
    try:
        content = tomllib.loads(text)
    except tomllib.TOMLDecodeError as problem:
        raise Refusal(f"is not TOML ({problem})") from None
    if content.get("kind") != KIND:
        raise Refusal(f"has the kind {content.get('kind')!r}; permitted is {KIND!r}")
    _known(content, KEYS, "")
    units = [content.get(key, "m") for key in ("unit", "position_unit")]
    for key, unit in zip(("unit", "position_unit"), units):
        if unit not in UNITS:
            raise Refusal(f"has {key} {unit!r}; permitted are 'm' and 'mm'")
    slices = content.get("slice", [])
    if not isinstance(slices, list) or not all(isinstance(row, dict) for row in slices) or len(slices) < 2:
        raise Refusal("has fewer than 2 tables [[slice]]; permitted are 2 or more")
    return _slices_of(slices, units, folder) | ({"name": str(content["name"])} if "name" in content else {})


def _known(table, keys, where):
    for key in table.keys() - keys:
        raise Refusal(f"has {key!r}{where}; permitted are {', '.join(sorted(keys))}")


def _slices_of(slices, units, folder):
    positions, points, features = [], [], []
    for k, row in enumerate(slices, start=1):
        _known(row, TABLES["slice"], f" in slice {k}")
        position, file = row.get("position"), row.get("file")
        if type(position) not in (int, float) or not isinstance(file, str):
            raise Refusal(f"has no position or no file in slice {k}; permitted are a number and a name")
        positions.append(position * UNITS[units[1]])
        points.append(section_points(folder, file, k))
        features.append(row.get("features"))
    if all(row is None for row in features):
        return {"positions": positions, "profiles": in_metres(points, units[0]), "features": None}
    for k, row in enumerate(features, start=1):
        numbers = isinstance(row, list) and all(type(value) in (int, float) for value in row)
        if not numbers or len(row) != len(features[0] or []):
            raise Refusal(
                f"has other features in slice {k} than in slice 1; permitted are as many numbers in each slice"
            )
    return {
        "positions": positions,
        "profiles": in_metres(points, units[0]),
        "features": np.array(features, dtype=float) * UNITS[units[0]],
    }
