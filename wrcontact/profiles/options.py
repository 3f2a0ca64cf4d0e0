"""How a file of points is to be read: what the file does not say itself."""

import math
import os
from dataclasses import dataclass, fields
from numbers import Integral

from ..conventions import MILLIMETRE as MM
from ..methods.numbers import Number, ratio_of
from .remarks import Refusal

#: Help text of each option; the names on the command line begin with --wheel- or --rail-.
WORDS = {
    "mirror_y": "Change the sign of y in the file (default: found from the shape where that is possible)",
    "mirror_z": "Change the sign of z in the file (default: found from the shape)",
    "rotate": "Rotate the points in the file about x, from y to z, in deg",
    "shift": "Shift the points in the file by y and z, such as 1.5,-0.2, in mm",
    "file_inclination": "Inclination that the rail in the file already has, as a ratio, 1:40, or a slope, "
    "0.025; it is turned upright before --rail-inclination applies; 0 is upright",
    "select": "Which profile of a file with several: its number, from 1, or its name",
    "y_range": "Use only the points between two values of y in the file, such as -70,5, in mm",
    "corner_radius": "Round the corners of the profile by arcs of this radius, in mm; also of a named profile",
}
#: Options on the command line: the end of each name.
ENDINGS = {
    "mirror_y": "mirror-y",
    "mirror_z": "mirror-z",
    "rotate": "rotate-deg",
    "shift": "shift-mm",
    "file_inclination": "file-inclination",
    "select": "select",
    "y_range": "y-range-mm",
    "corner_radius": "corner-radius-mm",
}
ROTATE = Number(0.0, -math.pi, math.pi, "rad", "Rotation of the points about x, from y to z")
SHIFT = Number(0.0, -1.0, 1.0, "m", "Shift of the points")
CORNER = Number(None, 1e-6, 0.1, "m", "Radius of the arcs that round the corners of a profile")
FORMS = {
    "corner_radius": "a number",
    "rotate": "a number",
    "shift": "two numbers Y,Z",
    "y_range": "two rising numbers FROM,TO",
    "file_inclination": "a ratio 1:40 or a slope 0.025",
}
INCLINATION = Number(
    None, 0.0, 0.1, "1", "Inclination that the rail in a file already has, as a slope", ratio=True
)


@dataclass(frozen=True)
class ProfileFile:
    """A file of points together with what it does not say itself; permitted wherever a path is.

    The operations are those of Simpack's processing data, in its order: bound, shift, rotate, mirror.  They
    follow those that a Simpack file itself asks for.

    Parameters
    ----------
    path : path of the file.
    mirror_y, mirror_z : whether the sign of y, of z is changed.  None finds the direction from the shape, as
        far as that is possible.
    rotate : rotation about x, from y to z [rad].
    shift : (y, z), added to the points [m].  A part that is not 0 replaces the shift of a wheel to its
        running circle that is found from its shape.
    file_inclination : slope by which the rail in the file is already inclined towards the track centre, such
        as 1/40; it is turned upright, since ``rail_inclination`` inclines it on the track.  0 says that it is
        upright.  None is unknown: it is read as upright, with a remark if its head does not look upright.
    select : which profile of a file with several: its number, from 1, or its name.
    y_range : (from, to), the y of the points in the file that are used, before all else [m]: one profile out
        of two that a file has side by side.  None uses all.
    corner_radius : radius of the arcs that round the corners of the profile at last [m], as
        :meth:`Profile.rounded`; with it alone ``path`` may also be the name of a standard profile, or a prepared file.
        None leaves them.

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and permitted range.
    """

    path: str | os.PathLike[str]
    mirror_y: bool | None = None
    mirror_z: bool | None = None
    rotate: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)
    file_inclination: float | None = None
    select: int | str | None = None
    y_range: tuple[float, float] | None = None
    corner_radius: float | None = None

    def __post_init__(self):
        for name in ("mirror_y", "mirror_z"):
            if getattr(self, name) not in (None, False, True):
                raise ValueError(f"{name} is {getattr(self, name)!r}; permitted are True, False and None")
        keep = object.__setattr__
        keep(self, "rotate", ROTATE.checked("rotate", self.rotate))
        keep(self, "file_inclination", INCLINATION.checked("file_inclination", self.file_inclination))
        if not isinstance(self.shift, (tuple, list)) or len(self.shift) != 2:
            raise ValueError(f"shift is {self.shift!r}; permitted are two numbers (y, z) in m")
        keep(
            self,
            "shift",
            tuple(SHIFT.checked(f"shift in {axis}", part) for axis, part in zip("yz", self.shift)),
        )
        keep(self, "corner_radius", CORNER.checked("corner_radius", self.corner_radius))
        if self.y_range is not None:
            keep(self, "y_range", _checked_range(self.y_range))
        number = isinstance(self.select, Integral) and not isinstance(self.select, bool)
        if not (
            self.select is None
            or (number and self.select >= 1)
            or (isinstance(self.select, str) and self.select)
        ):
            raise ValueError(
                f"select is {self.select!r}; permitted are the number of a profile in the file, "
                "from 1, and its name"
            )

    def __str__(self):
        return os.fspath(self.path)

    @property
    def reading(self):
        """The options as keywords of :meth:`wrcontact.Profile.from_file`."""
        return {field.name: getattr(self, field.name) for field in fields(self)[1:]}

    @property
    def shift_mm(self):
        """The shift (y, z) [mm]."""
        return tuple(part / MM for part in self.shift)

    @property
    def y_range_mm(self):
        """The range of y (2,) [mm]."""
        return tuple(part / MM for part in self.y_range)

    @property
    def given(self):
        """Names of the options that differ from their defaults."""
        return [field.name for field in fields(self)[1:] if getattr(self, field.name) != field.default]


def _checked_range(given):
    """``given`` as two rising numbers [m]."""
    if isinstance(given, (tuple, list)) and len(given) == 2:
        low, high = (SHIFT.checked("y_range", part) for part in given)
        if low < high:
            return low, high
    raise ValueError(f"y_range is {given!r}; permitted are two rising numbers (from, to) in m")


def parsed(name, text):
    """The value in SI of the option ``name`` from a ``text`` in the units of the command line.

    Raises
    ------
    ValueError
        if the text is not of the option's form or out of its range, in those units.
    """
    try:
        if name == "rotate":
            value, limit, unit = float(text), math.degrees(ROTATE.high), "deg"
            if abs(value) <= limit:
                return math.radians(value)
        elif name == "corner_radius":
            value = float(text)
            if CORNER.low <= value * MM <= CORNER.high:
                return value * MM
            raise ValueError(
                f"{text!r} is out of range; permitted is {CORNER.low / MM:g} ... {CORNER.high / MM:g} mm"
            )
        elif name in ("shift", "y_range"):
            values, limit, unit = [float(part) for part in text.split(",")], SHIFT.high / MM, "mm"
            if len(values) != 2 or name == "y_range" and not values[0] < values[1]:
                raise ValueError
            if all(abs(value) <= limit for value in values):
                return tuple(value * MM for value in values)
        else:
            value = ratio_of(text)
            if INCLINATION.low <= value <= INCLINATION.high:
                return value
            if math.isnan(value):
                raise ValueError
            raise ValueError(f"{text!r} is out of range; permitted is {INCLINATION.low:g} ... 1:10")
    except ValueError as wrong:
        if "permitted" in str(wrong):
            raise
        raise ValueError(f"{text!r} is not of the permitted form, {FORMS[name]}") from None
    raise ValueError(f"{text!r} is out of range; permitted is {-limit:g} ... {limit:g} {unit}")


def choose(names, select):
    """Index of the selected one of several profiles with these ``names``; a Refusal unless it is exactly
    one.

    ``select`` is a number from 1, as an int or in digits, a name, or None.
    """
    listed = ", ".join(f"{number}: {name}" for number, name in enumerate(names, start=1))
    if select is None:
        if len(names) == 1:
            return 0
        raise Refusal(
            f"contains {len(names)} profiles ({listed}); select is None; permitted are a number or "
            "a name of them"
        )
    same = [index for index, name in enumerate(names) if name == select]
    if len(same) == 1:
        return same[0]
    if str(select).isdecimal() and 1 <= int(select) <= len(names):
        return int(select) - 1
    several = "has that name more than once" if same else f"contains {listed}"
    raise Refusal(
        f"{several}; select is {select!r}; permitted are the numbers 1 ... {len(names)} and names "
        "that occur once"
    )
