"""A wheel that is not round: its sections at several angles, or a polygon, a flat, an eccentric bore."""

from __future__ import annotations

from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..profiles.placement import readable_wheel
from ..profiles.profile import Profile
from .surface import Surface
from .wheel_shapes import EDGE_RADIUS, Eccentric, Flat, Polygon, Slices

#: Slices are at least this far apart [rad], and lie within half a turn and this much more on both sides [rad].
LEAST_ANGLE, MOST_ANGLE = 1e-7, 4.0
#: What sections of a wheel may be larger or smaller than the round one [m].
LARGEST = 0.02


class WheelSections:
    """A wheel whose radius changes around it, from its sections at several angles.

    The angle theta is counted from a mark on the wheel. The mark is lowest at the ``wheel_rotation`` 0, and after a rotation chi
    the angle theta is lowest that equals chi. Between the slices a cubic spline goes through the deviations from the round
    ``profile``; beyond the first and the last one the wheel does not change (docs/guides/wheels.md).

    Parameters
    ----------
    angles : (n,), of the slices around the wheel, rising [rad].
    profiles : the n sections by their angles, each a :class:`~wrcontact.Profile` of a wheel.
    profile : the round wheel, a Profile; None is the first of ``profiles``.
    name : for messages and pictures.

    Raises
    ------
    ValueError
        in one sentence, with the number of the slice.

    Examples
    --------
    >>> import wrcontact
    >>> wheel = wrcontact.WheelSections.polygon("S1002", order=3, amplitude=1e-4)
    >>> wheel
    WheelSections('S1002, polygon of order 3')
    >>> system = wrcontact.ContactSystem(wheel=wheel)
    >>> round(system.evaluate(wheel_rotation=0.0).vertical_shift * 1e3, 2)
    -0.1
    """

    #: What messages call it.
    kind = "wheel sections"

    def __init__(
        self, angles: ArrayLike, profiles: Any, profile: Profile | None = None, name: str = "sections"
    ) -> None:
        found = _angles(angles, name)
        if len(profiles) != len(found):
            raise ValueError(
                f"wheel sections {name}: there are {len(profiles)} profiles for {len(found)} angles; permitted is one each"
            )
        for k, one in enumerate(profiles):
            if not isinstance(one, Profile) or one.kind != "wheel":
                given = f"a {one.kind} profile" if isinstance(one, Profile) else type(one).__name__
                raise ValueError(
                    f"wheel sections {name}: section {k + 1} at {found[k]:.6g} rad is {given}; permitted are Profiles of wheels"
                )
        self._shape(profile or profiles[0], Slices(tuple(found), tuple(profiles)), name)

    def _shape(self, profile, shape, name):
        self.profile, self.shape, self.name, self._surfaces = profile, shape, name, {}
        return self

    @classmethod
    def _of(cls, profile, shape, words):
        from ..profiles.catalogue import find_profile

        found = find_profile(profile, "wheel", argument="profile")
        return cls.__new__(cls)._shape(found, shape, f"{found.name}, {words}")

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> WheelSections:
        """The sections in a slice file of CONTACT, .slcw, or in a .toml (docs/guides/wheels.md); the first one is the round wheel.

        Raises
        ------
        ValueError
            in one sentence, if the file cannot be used.
        """
        from .files import read_wheel_sections

        return cls(**read_wheel_sections(path))

    @classmethod
    def polygon(cls, profile: Any, order: int, amplitude: float, phase: float = 0.0) -> WheelSections:
        """A wheel with the radius r + ``amplitude`` cos(``order`` (theta - ``phase``)).

        Parameters
        ----------
        profile : a :class:`~wrcontact.Profile` of a wheel, or what :class:`~wrcontact.ContactSystem` takes for one.
        order : waves around the wheel, 1 ... 60.
        amplitude : [m], up to 5 mm.
        phase : angle of a crest [rad].
        """
        if isinstance(order, bool) or order != int(order) or not 1 <= order <= 60:
            raise ValueError(f"order is {order!r}; permitted are whole numbers 1 ... 60")
        shape = Polygon(
            int(order),
            _number("amplitude", amplitude, -5e-3, 5e-3, " m"),
            _number("phase", phase, -7.0, 7.0, " rad"),
        )
        return cls._of(profile, shape, f"polygon of order {order}")

    @classmethod
    def eccentric(cls, profile: Any, offset: float) -> WheelSections:
        """A round wheel that turns about an axle which lies ``offset`` [m], up to 5 mm, beside its centre; it is longest at
        theta = 0."""
        return cls._of(profile, Eccentric(_number("offset", offset, 0.0, 5e-3, " m")), "eccentric")

    @classmethod
    def flat(
        cls, profile: Any, length: float, rounded: bool = True, edge_radius: float = EDGE_RADIUS
    ) -> WheelSections:
        """A wheel with a flat of this ``length`` [m], 5 ... 150 mm, about theta = 0.

        A ``rounded`` flat, as it is after some way, is a wave as deep as the chord of this length. A fresh one is the chord,
        whose edges are rounded to ``edge_radius`` [m].
        """
        shape = Flat(
            _number("length", length, 5e-3, 0.15, " m"),
            bool(rounded),
            _number("edge_radius", edge_radius, 1e-5, 1e-2, " m"),
        )
        return cls._of(profile, shape, "rounded flat" if rounded else "fresh flat")

    def surface(self, radius: float) -> Surface:
        """Its deviation from a round wheel of the nominal ``radius`` [m], as a surface over angles [rad] and abscissae [m]."""
        if radius in self._surfaces:
            return self._surfaces[radius]
        theta, y, d, slope, bend = self.shape.slices(readable_wheel(self.profile), radius)
        if not np.abs(d).max() < LARGEST:
            raise ValueError(
                f"wheel {self.name} is up to {np.abs(d).max():.3g} m out of round; permitted is up to {LARGEST:g} m"
            )
        made = Surface(theta, np.stack([np.broadcast_to(y, d.shape), d, slope, bend, bend], axis=-1))
        return self._surfaces.setdefault(radius, made)

    def __repr__(self):
        return f"WheelSections({self.name!r})"


def _number(name, value, low, high, unit):
    try:
        found = float(value)
    except (TypeError, ValueError):
        found = np.nan
    if not low <= found <= high:
        raise ValueError(f"{name} is {value!r}{unit}; permitted is {low:g} ... {high:g}{unit}")
    return found


def _angles(angles, name):
    """The angles (n,) [rad], checked."""
    try:
        found = np.array(angles, dtype=float)
    except (TypeError, ValueError):
        found = np.zeros(0)
    if found.ndim != 1 or len(found) < 2 or not np.abs(found).max() <= MOST_ANGLE:
        raise ValueError(
            f"wheel sections {name}: angles has the shape {found.shape}; permitted are 2 or more numbers within "
            f"{MOST_ANGLE:g} rad of 0"
        )
    if not (np.diff(found) >= LEAST_ANGLE).all():
        k = int(np.argmin(np.diff(found) >= LEAST_ANGLE))
        raise ValueError(
            f"wheel sections {name}: angle {k + 2} is {found[k + 1]:.9g} rad, behind {found[k]:.9g} rad of the one before; "
            "permitted are angles that rise"
        )
    return found
