"""A rail whose section changes along the track."""

from __future__ import annotations

from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..conventions import MILLIMETRE as MM
from ..profiles.profile import Profile
from ..profiles.remarks import remark
from .along import least_of
from .curves import PointCurve, ProfileCurve
from .knots import knot_lengths
from .surface import HEIGHT, PLACE, Surface

#: Slices are at least this far apart [m].
LEAST_STEP = 1e-6
#: Shortest part of a section between two features [m].
LEAST_PIECE = 1e-4
#: Heights that change by more than this [m] and this share of the slices' distance are remarked.
JUMP, JUMP_SHARE = 2e-3, 0.2
#: What a spline may stand above or below both slices beside without a remark [m].
OVERSHOOT = 20e-6


class RailSections:
    """The running surface of a rail from its sections at several positions along the track.

    Sections lie where their coordinates say: lateral place y to the field side and height z downwards, from an origin
    that is the same for all. A smooth surface goes through them (docs/guides/sections.md): points with the same share
    of the length between the same two features belong together, and along the track a cubic spline goes through those
    of all slices. Beyond the first and the last slice the surface runs out level within 50 mm, or within the distance
    of the last two slices where that is shorter; farther out it does not change.

    Parameters
    ----------
    positions : (n,), of the slices along the track, rising [m].
    profiles : the n sections by their positions: each a :class:`~wrcontact.Profile` of a rail, or points (k, 2), y and
        z in one row [m], by rising y. A cubic spline over the chord length goes through points.
    features : (n, f), rising lengths along each section from its gauge-side end [m] that belong together, such as
        corners; the surface lies between the first and the last of them. None are both ends. A length behind the end
        of a section is its end.
    places : (n, 2), y and z [m] by which each section is moved; None is nowhere.
    name : for messages and pictures.

    Raises
    ------
    ValueError
        in one sentence, with the number and position of the slice.

    Warns
    -----
    ProfileWarning
        if heights jump from slice to slice, or the spline through the slices stands out beyond both slices beside.

    Examples
    --------
    A rail that falls by 2 mm over 0.2 m:

    >>> import numpy as np, wrcontact
    >>> rail = wrcontact.profiles.standard_profile("UIC60")
    >>> u = np.linspace(0.0, 0.6, 13)
    >>> down = 1e-3 * (1.0 - np.cos(np.pi * np.clip((u - 0.2) / 0.2, 0.0, 1.0)))
    >>> dip = wrcontact.RailSections(u, [rail] * 13, places=np.column_stack([0.0 * u, down]), name="dip")
    >>> dip
    RailSections('dip', 13 slices at 0 ... 0.6 m, y = -37.29 ... 37.29 mm)
    >>> round(float(dip.height(0.3, 0.0)), 6)
    0.001
    """

    #: What messages call it.
    kind = "rail sections"

    def __init__(
        self,
        positions: ArrayLike,
        profiles: Any,
        features: ArrayLike | None = None,
        places: ArrayLike | None = None,
        name: str = "sections",
    ) -> None:
        self.name = name
        self.positions = _positions(positions, name)
        count = len(self.positions)
        if len(profiles) != count:
            raise ValueError(
                f"rail sections {name}: there are {len(profiles)} profiles for {count} positions; permitted is one each"
            )
        moved = np.zeros((count, 2)) if places is None else np.array(places, dtype=float)
        if moved.shape != (count, 2) or not np.isfinite(moved).all():
            raise ValueError(
                f"rail sections {name}: places has the shape {moved.shape}"
                f"{'' if np.isfinite(moved).all() else ' and values that are not finite'}; permitted are finite "
                f"numbers ({count}, 2) in m"
            )
        self._curves = [self._curve(k, one, place) for k, (one, place) in enumerate(zip(profiles, moved))]
        self.features = self._features(features)
        lengths = knot_lengths(self._curves, self.features)
        values = np.stack([curve.at(row) for curve, row in zip(self._curves, lengths)])
        self._check_rising(values)
        try:
            self.surface = Surface(self.positions, values)
        except ValueError as problem:
            raise ValueError(f"rail sections {name}: {problem}") from None
        remark("rail", name, self._jumps(values) + self._overshoot())

    def _slice(self, k):
        """How messages call a slice."""
        return f"rail sections {self.name}: slice {k + 1} at {self.positions[k]:.6g} m"

    def _curve(self, k, section, place):
        try:
            if isinstance(section, Profile):
                if section.kind != "rail":
                    raise ValueError(
                        f"is a {section.kind} profile ({section.name}); permitted are rail profiles"
                    )
                return ProfileCurve(section, place)
            return PointCurve(np.array(section, dtype=float) + place)
        except (TypeError, ValueError) as problem:
            if isinstance(problem, TypeError) or str(problem).startswith(
                ("could not", "setting", "operands")
            ):
                problem = f"is {type(section).__name__}; permitted are a Profile or points (k, 2) in m"
            raise ValueError(f"{self._slice(k)} {problem}") from None

    def _features(self, features):
        """The features (n, f) [m], checked; those behind the end of a section at it."""
        ends = np.array([curve.length for curve in self._curves])
        if features is None:
            return np.column_stack([0.0 * ends, ends])
        try:
            given = np.array(features, dtype=float)
        except (TypeError, ValueError):
            given = np.zeros(0)
        if given.ndim != 2 or len(given) != len(ends) or given.shape[1] < 2:
            raise ValueError(
                f"rail sections {self.name}: features has the shape {given.shape}; permitted are lengths in m, "
                f"({len(ends)}, 2 or more), as many for each slice"
            )
        for k, row in enumerate(given):
            if not np.isfinite(row).all():
                raise ValueError(
                    f"{self._slice(k)} has a feature that is not a finite number; permitted are lengths in m"
                )
            if (row < 0.0).any():
                raise ValueError(
                    f"{self._slice(k)} does not have feature {int(np.argmax(row < 0.0)) + 1}; permitted are features that "
                    "all slices have, so parts that begin or end between the slices are not read"
                )
        given = np.minimum(given, ends[:, None])
        short = np.diff(given, axis=1) < LEAST_PIECE
        if short.any():
            k, f = np.argwhere(short)[0]
            raise ValueError(
                f"{self._slice(k)}: feature {f + 2} at {given[k, f + 1] / MM:.6g} mm does not lie behind feature {f + 1} at "
                f"{given[k, f] / MM:.6g} mm, where the section is {ends[k] / MM:.6g} mm long; permitted are lengths that "
                f"rise by {LEAST_PIECE / MM:g} mm or more"
            )
        return given

    def _check_rising(self, values):
        """Refuse sections whose knots do not have rising y."""
        falling = np.diff(values[..., PLACE], axis=1) <= 0.0
        if falling.any():
            k, where = np.argwhere(falling)[0]
            raise ValueError(
                f"{self._slice(k)} folds back at y = {values[k, where, PLACE] / MM:.4g} mm; permitted are sections "
                "whose y rises"
            )

    def _jumps(self, values):
        """A remark where heights jump from slice to slice."""
        step, distance = np.abs(np.diff(values[..., HEIGHT], axis=0)).max(axis=1), np.diff(self.positions)
        jump = np.flatnonzero((step > JUMP) & (step > JUMP_SHARE * distance))
        if not len(jump):
            return []
        k = jump[np.argmax(step[jump])]
        return [
            f"heights change by {step[k] / MM:.3g} mm between the slices at {self.positions[k]:.6g} and "
            f"{self.positions[k + 1]:.6g} m, as with mixed units or features that do not belong together"
        ]

    def _overshoot(self):
        """A remark where the spline along the track leaves the values of both slices beside it."""
        inside = slice(2, len(self.surface.breaks) - 3)
        cubics, steps = self.surface.cubics[inside][..., HEIGHT], np.diff(self.surface.breaks)[inside]
        if len(steps) < 2:
            return []
        end = cubics[:, 0] + steps[:, None] * (
            cubics[:, 1] + steps[:, None] * (cubics[:, 2] + steps[:, None] * cubics[:, 3])
        )
        low, high = np.minimum(cubics[:, 0], end), np.maximum(cubics[:, 0], end)
        beyond = np.maximum(low - least_of(cubics, steps), -least_of(-cubics, steps) - high).max(axis=1)
        k = int(np.argmax(beyond))
        if beyond[k] <= OVERSHOOT:
            return []
        return [
            f"between the slices at {self.positions[k]:.6g} and {self.positions[k + 1]:.6g} m the surface stands up to "
            f"{1e6 * beyond[k]:.3g} um above or below both; more slices there say what is meant"
        ]

    def __repr__(self):
        y = self.surface.cubics[2:-2, 0, :, PLACE] / MM
        return (
            f"RailSections({self.name!r}, {len(self.positions)} slices at {self.positions[0]:.6g} ... "
            f"{self.positions[-1]:.6g} m, y = {y.min():.4g} ... {y.max():.4g} mm)"
        )

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> RailSections:
        """The sections in a slice file of CONTACT, .slcs, or in a .toml (docs/guides/sections.md).

        Files of sections are read in every format of rail profiles. Their points stay where they are: they are not
        repaired, not smoothed, and not moved to the highest point.

        Raises
        ------
        ValueError
            in one sentence, if the file cannot be used.
        """
        from .files import read_sections

        return cls(**read_sections(path))

    def evaluate(self, u: ArrayLike, y: ArrayLike) -> dict[str, NDArray[Any]]:
        """Height of the surface and its derivatives at positions ``u`` and lateral places ``y`` [m], arrays of one shape.

        Returns
        -------
        dict
            ``z`` [m], ``z_u``, ``z_y`` [-], ``z_uu``, ``z_uy``, ``z_yy`` [1/m], and of the lateral place Y along a line
            of equal share ``Y_u`` [-], ``Y_uu`` [1/m]; NaN beside the section.
        """
        names = ("z", "z_u", "z_y", "z_uu", "z_uy", "z_yy", "Y_u", "Y_uu")
        u, y = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(y, dtype=float))
        first, last = self.edges(u)
        found = np.where((y >= first) & (y <= last), self.surface.jet(u, y), np.nan)
        return dict(zip(names, found))

    def height(self, u: ArrayLike, y: ArrayLike) -> NDArray[Any]:
        """Height z [m], positive down, at positions ``u`` and lateral places ``y`` [m]; NaN beside the section."""
        return self.evaluate(u, y)["z"]

    def edges(self, u: ArrayLike) -> tuple[NDArray[Any], NDArray[Any]]:
        """Lateral places [m] of the gauge-side and of the field-side end of the section at ``u`` [m]."""
        return self.surface.edges(np.asarray(u, dtype=float))

    def section(self, u: float) -> NDArray[Any]:
        """Points (k, 2), y and z [m], of the section at one position ``u`` [m], at its knots."""
        return self.surface.lines(u)[0][:, [PLACE, HEIGHT]]


def _positions(positions, name):
    """The positions (n,) [m], checked."""
    try:
        found = np.array(positions, dtype=float)
    except (TypeError, ValueError):
        found = np.zeros(0)
    if found.ndim != 1 or len(found) < 2:
        raise ValueError(
            f"rail sections {name}: positions has the shape {found.shape}; permitted are 2 or more numbers in m"
        )
    if not np.isfinite(found).all():
        k = int(np.argmin(np.isfinite(found)))
        raise ValueError(
            f"rail sections {name}: position {k + 1} is {found[k]}; permitted are finite numbers in m"
        )
    steps = np.diff(found)
    if not (steps >= LEAST_STEP).all():
        k = int(np.argmin(steps >= LEAST_STEP))
        raise ValueError(
            f"rail sections {name}: position {k + 2} is {found[k + 1]:.9g} m, behind {found[k]:.9g} m of the one before; "
            f"permitted are positions that rise by {LEAST_STEP:g} m or more"
        )
    return found
