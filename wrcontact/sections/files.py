"""Files of sections: CONTACT's slice files, .slcs, and our own .toml.

A slice file of CONTACT (Vtech CMCC, User guide, "Rail profiles along the track") has lines of numbers, "%" begins a
comment:

    U_OFFSET U_SCALE      positions are U_SCALE (U_OFFSET + U) in mm
    NSLC                  number of slices
    NFEAT NKINK NACCEL    numbers of features, kinks and accelerations
    U_INTPOL              1: through the slices, 2: smooth along them
    U 'file'              NSLC lines, files beside the slice file
    U S_1 ... S_NFEAT     NSLC lines if NFEAT > 1: lengths of the features in mm, negative where a slice has none

Sections are in any format of rail profiles, in mm or m.  A slice file of a wheel, .slcw, has angles instead of positions,
TH_SCALE (TH_OFFSET + TH) in rad, and no features.
"""

import math
import os
import re

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..profiles.formats import read_points
from ..profiles.profile import Profile
from ..profiles.remarks import Refusal, remark

#: Factors to metres.
UNITS, ANGLE_UNITS = {"m": 1.0, "mm": MM}, {"rad": 1.0, "deg": math.pi / 180.0}
#: A section that is narrower than this many mm is in metres.
NARROW = 1.0
#: Most bytes of a file, and most slices.
LARGEST, MOST_SLICES = 4_000_000, 2_000
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eEdD][+-]?\d+)?$")
TABLES = {"slice": {"position", "file", "features"}, "slice of a wheel": {"angle", "file"}}
KEYS = {"kind", "name", "unit", "position_unit", "slice"}
WHEEL_KEYS = {"kind", "name", "unit", "angle_unit", "slice"}
KIND, WHEEL_KIND = "rail sections", "wheel sections"


def read_sections(path):
    """The arguments of :class:`~wrcontact.RailSections` in the file ``path``."""
    return _read(path, KIND, {".slcs": read_slices, ".toml": read_toml})


def read_wheel_sections(path):
    """The arguments of :class:`~wrcontact.WheelSections` in the file ``path``."""
    return _read(path, WHEEL_KIND, {".slcw": read_wheel_slices, ".toml": read_wheel_toml})


def _read(path, kind, readers):
    path = os.fspath(path)
    name, ending = os.path.splitext(os.path.basename(path))
    if ending.lower() not in readers:
        raise ValueError(
            f"{kind} {path} ends in {ending or 'nothing'}; permitted are {' and '.join(readers)}"
        )
    try:
        return {"name": name, **readers[ending.lower()](_text(path), os.path.dirname(path))}
    except Refusal as problem:
        raise ValueError(f"{kind} {path} {problem}") from None


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
    offset, scale, count, features = _head(lines, "U_OFFSET and U_SCALE", "rail", "along the track")
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


def read_wheel_slices(text, folder):
    """Angles and profiles in the ``text`` of a .slcw, whose files are in ``folder``."""
    lines = _Lines(text)
    offset, scale, count, features = _head(lines, "TH_OFFSET and TH_SCALE", "wheel", "around the wheel")
    if features > 1:
        raise Refusal(f"has {features} features; permitted is 0 for a wheel")
    rows = [lines.slice(k, count) for k in range(count)]
    angles = scale * (offset + np.array([row[0] for row in rows]))
    points = [section_points(folder, row[1], k + 1, "wheel") for k, row in enumerate(rows)]
    return {"angles": angles, "profiles": _wheels(points, None)}


def _wheels(points, unit):
    """Profiles through the sections of a wheel."""
    found = []
    for k, part in enumerate(in_metres(points, unit), start=1):
        try:
            found.append(Profile.from_points(*(part.T / MM), name=f"section {k}", kind="wheel"))
        except ValueError as problem:
            raise Refusal(f"has slice {k}, in which {problem}") from None
    return found


def _head(lines, scaled, kind, along):
    """Offset and scale, number of slices and of features at the beginning of a slice file."""
    offset, scale = lines.numbers(2, scaled)
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
            kind, "sections", [f"U_INTPOL 2 asks for smoothing {along}: the surface goes through the slices"]
        )
    return offset, scale, count, features


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


def section_points(folder, file, number, kind="rail"):
    """Points (k, 2) of a section in the unit of its ``file``, which belongs to slice ``number`` of a ``kind``."""
    path = os.path.join(folder, *re.split(r"[\\/]", file)) if not os.path.isabs(file) else file
    try:
        text = _text(path)
    except OSError as problem:
        raise Refusal(f"has slice {number} in {file!r}, which cannot be read ({problem.strerror})") from None
    try:
        points = read_points(text, os.path.splitext(path)[1].lower(), kind)
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
    content, units = _toml(text, KIND, KEYS, {"unit": UNITS, "position_unit": UNITS})
    return _slices_of(content["slice"], units, folder) | _named(content)


def read_wheel_toml(text, folder):
    """As :func:`read_wheel_slices`, of a .toml.

    It has ``kind`` = "wheel sections", ``unit`` of the sections' points, "m" or "mm" and "m" by default, ``angle_unit``, "rad" or
    "deg" and "rad" by default, and tables ``[[slice]]`` with ``angle`` and ``file``.
    """
    content, (unit, angle_unit) = _toml(
        text, WHEEL_KIND, WHEEL_KEYS, {"unit": UNITS, "angle_unit": ANGLE_UNITS}
    )
    angles, points = [], []
    for k, row in enumerate(content["slice"], start=1):
        angle, file = _place(row, "angle", TABLES["slice of a wheel"], k)
        angles.append(angle * ANGLE_UNITS[angle_unit])
        points.append(section_points(folder, file, k, "wheel"))
    return {"angles": angles, "profiles": _wheels(points, unit)} | _named(content)


def _toml(text, kind, keys, units):
    """The checked content of a TOML of this ``kind``, and its units."""
    try:
        import tomllib  # since Python 3.11
    except ImportError:
        raise Refusal(
            "is TOML, which Python reads from version 3.11; permitted before are slice files"
        ) from None
    try:
        content = tomllib.loads(text)
    except tomllib.TOMLDecodeError as problem:
        raise Refusal(f"is not TOML ({problem})") from None
    if content.get("kind") != kind:
        raise Refusal(f"has the kind {content.get('kind')!r}; permitted is {kind!r}")
    _known(content, keys, "")
    found = [_unit(content, key, known) for key, known in units.items()]
    slices = content.get("slice", [])
    if not isinstance(slices, list) or not all(isinstance(row, dict) for row in slices) or len(slices) < 2:
        raise Refusal("has fewer than 2 tables [[slice]]; permitted are 2 or more")
    return content, found


def _unit(content, key, units):
    found = content.get(key, next(iter(units)))
    if found not in units:
        raise Refusal(f"has {key} {found!r}; permitted are {' and '.join(map(repr, units))}")
    return found


def _named(content):
    return {"name": str(content["name"])} if "name" in content else {}


def _place(row, key, keys, number):
    """Place and file of slice ``number``."""
    _known(row, keys, f" in slice {number}")
    place, file = row.get(key), row.get("file")
    if type(place) not in (int, float) or not isinstance(file, str):
        raise Refusal(f"has no {key} or no file in slice {number}; permitted are a number and a name")
    return place, file


def _known(table, keys, where):
    for key in table.keys() - keys:
        raise Refusal(f"has {key!r}{where}; permitted are {', '.join(sorted(keys))}")


def _slices_of(slices, units, folder):
    positions, points, features = [], [], []
    for k, row in enumerate(slices, start=1):
        position, file = _place(row, "position", TABLES["slice"], k)
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
