"""A wheel or rail profile: height, slope and curvature as functions of the lateral coordinate."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..conventions import MILLIMETRE as MM
from ..methods.numbers import is_plain
from ..storage.atomic import write_atomically
from .definition import definition
from .files import read_profile, zones_through
from .options import ProfileFile
from .remarks import Reading, counted, remark, stretch
from .source import Source
from .zones import Chain, joined

#: Largest height step that a published profile may have at a joint [mm].  EN 13715's S1002 has 1.2e-4 by
#: rounding.
JOINT_HEIGHT = 2e-4
#: Largest height step that is joined by moving the outer zones [mm]: numbers of standards are printed to 0.01 mm
#: or finer.
PRINTED_STEP = 0.01
#: Largest slope step at a joint of a tangent chain [-]; S1002 as printed has 1.1e-5.
JOINT_SLOPE = 3e-5


@dataclass(frozen=True)
class Joint:
    """Where two zones meet: position [m] and the steps in height [m], slope [-] and second derivative
    [1/m]."""

    y: float
    height_step: float
    slope_step: float
    bend_step: float


@dataclass(frozen=True)
class Profile:
    """A profile made of ``zones`` (in mm, by rising y), read in metres.

    ``kind`` is "wheel" (y to the field side from the running circle, radius = nominal radius + height) or
    "rail" (origin at the highest point of the head).  Height is positive down for both.  The constructor
    checks that consecutive zones have no hole between them and agree in height and slope.  Steps in height of up
    to PRINTED_STEP between printed zones are joined: the outer zones are moved to the inner ones, with a
    :class:`~wrcontact.ProfileWarning`.  ``smooth=False``
    permits corners, which stay.  ``source`` says where the numbers of a standard profile come from, None of
    any other; it has no effect.  ``reading`` describes the file of points that the profile comes
    from, if any; it has no effect.  ``worn_face`` is how far the inner face of a rail has worn at the depth of
    the gauge since it was laid [m]: a worn rail keeps its place on the track, and the gauge is wider.

    Raises
    ------
    ValueError
        if a zone does not meet its neighbour.
    """

    name: str
    kind: str
    zones: tuple
    smooth: bool = True
    joints: tuple = field(init=False, compare=False)
    reading: Reading | None = field(default=None, compare=False, repr=False)
    worn_face: float = 0.0
    source: Source | None = field(default=None, compare=False, repr=False)

    def __post_init__(self):
        if self.kind not in ("wheel", "rail"):
            raise ValueError(f"profile {self.name}: kind is {self.kind!r}, permitted are 'wheel' and 'rail'")
        if not self.zones:
            raise ValueError(f"profile {self.name}: it has no zones")
        meeting = [self._meeting(*pair) for pair in zip(self.zones[:-1], self.zones[1:])]
        steps = [abs(float(right[0] - left[0])) for left, right in meeting]
        if any(JOINT_HEIGHT < step <= PRINTED_STEP for step in steps):
            object.__setattr__(self, "zones", joined(self.zones, JOINT_HEIGHT, PRINTED_STEP)[0])
            printed = [
                (zone.start, step)
                for zone, step in zip(self.zones[1:], steps)
                if JOINT_HEIGHT < step <= PRINTED_STEP
            ]
            remark(
                self.kind,
                self.name,
                [
                    f"{counted(len(printed), 'step')} of up to {max(step for _, step in printed):.2g} mm between its zones "
                    f"({stretch([y for y, _ in printed])}) joined by moving the zones that lie farther from y = 0"
                ],
            )
            meeting = [self._meeting(*pair) for pair in zip(self.zones[:-1], self.zones[1:])]
        object.__setattr__(self, "joints", tuple(map(self._joint, self.zones[1:], meeting)))

    def _meeting(self, before, after):
        """Height, slope and second derivative of two neighbours where they meet."""
        if abs(after.start - before.stop) > 1e-9:
            raise ValueError(f"profile {self.name}: hole between y = {before.stop} mm and {after.start} mm")
        return before(after.start), after(after.start)

    def _joint(self, after, meeting):
        left, right = meeting
        step, slope, bend = (float(b - a) for a, b in zip(left, right))
        if not abs(step) <= JOINT_HEIGHT:
            raise ValueError(
                f"profile {self.name}: height step of {step:.3g} mm at y = {after.start} mm, "
                f"permitted is {PRINTED_STEP} mm"
            )
        if self.smooth and not abs(np.arctan(right[1]) - np.arctan(left[1])) <= JOINT_SLOPE:
            raise ValueError(
                f"profile {self.name}: slope step of {slope:.3g} at y = {after.start} mm, "
                f"permitted is {JOINT_SLOPE}, or any with smooth=False"
            )
        return Joint(after.start * MM, step * MM, slope, bend / MM)

    def __repr__(self):
        zones = f"{len(self.zones)} zone{'s' if len(self.zones) > 1 else ''}"
        return (
            f"Profile({self.name!r}, {self.kind}, y = {self.zones[0].start:.5g} ... "
            f"{self.zones[-1].stop:.5g} mm, {zones})"
        )

    @classmethod
    def from_file(
        cls, path: str | PathLike[str], kind: str, smoothing: float | None = None, **options: Any
    ) -> Profile:
        """The profile in a file of points or a prepared file (docs/guides/profiles.md).

        Parameters
        ----------
        path : text columns in mm, a file of Simpack (.prw, .prr), MiniProf (.whl, .ban, .mpt), Vampire (.whe,
            .rai) or GENSYS (.wheel, .rail), or a prepared .json.
        kind : "wheel" or "rail".
        smoothing : root mean square distance [m] between the smoothing spline and the points, 0 ... 0.5e-3; 0
            goes through every point; None is the estimated noise of the points.
        options : mirror_y, mirror_z, rotate [rad], shift (y, z) [m], file_inclination, select, y_range [m],
            corner_radius [m]: what the file does not say itself, as in :class:`~wrcontact.ProfileFile`.

        Raises
        ------
        ValueError
            if an option is not permitted or the file cannot be used, or if it has a symmetric rail that is
            inclined and neither ``file_inclination`` nor a track says what is meant.  Repairs are reported by a
            :class:`~wrcontact.ProfileWarning`.
        """
        if kind not in ("wheel", "rail"):
            raise ValueError(f"kind is {kind!r}, permitted are 'wheel' and 'rail'")
        return read_profile(ProfileFile(path, **options), kind, smoothing, cls)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the profile to a file; ``wheel`` and ``rail``, their options of the command line and
        :meth:`from_file` read it.

        A prepared file, such as worn.json, has all digits. Other endings are those of points, at most 0.1 mm apart,
        with nine digits behind the point of a millimetre: .csv, .txt, Simpack's .prw and .prr, MiniProf's .whl and .ban,
        GENSYS's .wheel and .rail.

        Raises
        ------
        ValueError
            if the path has another ending, one of the other kind of profile, or if the format cannot hold it.
        """
        from .writers import saved_text  # not needed before something is saved

        write_atomically(path, saved_text(self, path).encode())

    @classmethod
    def from_points(cls, y: ArrayLike, z: ArrayLike, *, name: str, kind: str) -> Profile:
        """A profile through points ``y`` (n,), ``z`` (n,) in millimetres by a cubic spline.

        A rail is shifted so that its highest point is the origin.

        Raises
        ------
        ValueError
            if the points are too few, not finite, not rising in y, or do not have the size of a profile.
        """
        return cls(name, kind, zones_through(y, z, name, kind))

    def rounded(self, radius: float) -> Profile:
        """The profile with each of its corners rounded by an arc of a ``radius`` [m] that is tangential to both
        sides.

        How far the profile moves at most is reported by a :class:`~wrcontact.ProfileWarning`: about
        radius (1 / cos(turn / 2) - 1).  A corner that is left is rounded when a system is made of the profile,
        to about 1 mm or over 0.1 mm.

        Raises
        ------
        ValueError
            if the radius is not above 0, or an arc does not fit between the neighbours of its corner.
        """
        from .fillets import fillet_remarks, rounded_zones  # not needed before a corner is rounded

        if not is_plain(radius) or not 0.0 < radius <= 1.0:
            raise ValueError(f"radius is {radius!r}; permitted are numbers above 0 and up to 1, in m")
        zones, moved = rounded_zones(self, radius / MM)
        remark(self.kind, self.name, fillet_remarks(moved, radius / MM))
        return replace(self, zones=zones)

    def definition(self):
        """The zones as one array (n,), which the kernel's preparation reads."""
        return definition(self)

    @property
    def start(self) -> float:
        """Smallest y of the profile [m]."""
        return self.zones[0].start * MM

    @property
    def stop(self) -> float:
        """Largest y of the profile [m]."""
        return self.zones[-1].stop * MM

    def evaluate(self, y: ArrayLike) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Height [m], slope [-] and second derivative [1/m] at ``y`` [m], three arrays of y's shape; NaN
        outside."""
        y = np.asarray(y, dtype=float)
        # ``start`` and ``stop`` in metres need not come back to the same millimetres
        y_mm = np.where(
            (y >= self.start) & (y <= self.stop),
            np.clip(y / MM, self.zones[0].start, self.zones[-1].stop),
            np.nan,
        )
        if self._chain:
            z, slope, bend = self._chain(y_mm)
            return z * MM, slope, bend / MM
        result = np.full((3,) + y_mm.shape, np.nan)
        for zone in self.zones:
            inside = (y_mm >= zone.start) & (y_mm <= zone.stop)
            if np.any(inside):
                result[:, inside] = zone(y_mm[inside])
        return result[0] * MM, result[1], result[2] / MM

    @cached_property
    def _chain(self):
        """The zones of a file of points at once; None where one is an arc."""
        return Chain.of(self.zones)

    def height(self, y: ArrayLike) -> NDArray[Any]:
        """Height z(y) [m], positive down, at ``y`` [m]; array in, array out, NaN outside the profile."""
        return self.evaluate(y)[0]

    def slope(self, y: ArrayLike) -> NDArray[Any]:
        """Slope dz/dy [-] at ``y`` [m]."""
        return self.evaluate(y)[1]

    def curvature(self, y: ArrayLike) -> NDArray[Any]:
        """Curvature z'' / (1 + z'^2)^(3/2) [1/m] at ``y`` [m]; positive where z'' > 0."""
        _, slope, bend = self.evaluate(y)
        return bend / (1 + slope**2) ** 1.5
