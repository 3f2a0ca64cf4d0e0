"""What a run of wear has found: its steps, and what a data set of them has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..methods.numbers import check_choice
from ..profiles.profile import Profile
from ..results.convert import needed
from ..results.words import ShortText
from .shape import WheelShape

#: Spacing of the places of a data set [m].
RASTER = 0.2e-3
UNITS = {"curvature": "1/m", "worn_area": "m2"}


class WearStep(NamedTuple):
    """One step of a run; ``{side: ...}`` stands for left and right, of one wheel for its own side.

    Attributes
    ----------
    distance : run before this step [m]; length : of the step [m], 0 in the last, which only reports.  Of
        rails both are numbers of passages.
    profiles : {side: Profile} before the step.
    depth : {side: (places (m,), depth that the step takes (m,))} [m].
    taken : {side: cross-section that the step takes} [m2].
    shapes : {side: WheelShape} before the step; of rails only the worn area.
    conicity : equivalent conicity at 3 mm before the step [1]; NaN of rails and of one wheel.
    shares : {side: {regime: share}}; left_out : rows that were left out.
    """

    distance: float
    length: float
    profiles: dict
    depth: dict
    taken: dict
    shapes: dict
    conicity: float
    shares: dict
    left_out: int


@dataclass(frozen=True, repr=False)
class WearRun(ShortText):
    """A run to a mileage; ``for step in run`` goes over its steps.

    Attributes
    ----------
    steps : tuple of :class:`WearStep`; the last one has the profiles at the end, and no wear of its own.
    part : "wheel" or "rail".
    sides : ("left", "right"), or the side of the only wheel.  Methods take one of them; None is the last.
    """

    steps: tuple[WearStep, ...]
    part: str

    def __iter__(self) -> Iterator[WearStep]:
        return iter(self.steps)

    @property
    def sides(self) -> tuple[str, ...]:
        """The sides that there are."""
        return tuple(self.steps[0].profiles)

    @property
    def distance(self) -> NDArray[Any]:
        """Distances (n,) [m] of the steps; of rails numbers of passages."""
        return np.array([step.distance for step in self.steps])

    @property
    def conicity(self) -> NDArray[Any]:
        """Equivalent conicity (n,) at 3 mm [1]."""
        return np.array([step.conicity for step in self.steps])

    def profiles(self, side: str | None = None) -> tuple[Profile, ...]:
        """The profile of one side at each step, the last one worn to the mileage."""
        side = self._side(side)
        return tuple(step.profiles[side] for step in self.steps)

    def shape(self, name: str, side: str | None = None) -> NDArray[Any]:
        """A dimension (n,) of :class:`~wrcontact.wear.WheelShape` over the steps."""
        check_choice("name", name, tuple(WheelShape.__dataclass_fields__))
        side = self._side(side)
        return np.array([getattr(step.shapes[side], name) for step in self.steps])

    def _side(self, side):
        """A ``side`` that there is; None is the last."""
        if side is not None:
            check_choice("side", side, self.sides)
        return side or self.sides[-1]

    def to_xarray(self) -> Any:
        """A xarray.Dataset over step and side; heights and depths over ``place`` [m] too."""
        xarray, sides = needed("xarray", "to_xarray"), self.sides
        first = [self.steps[0].profiles[side] for side in sides]
        place = RASTER * np.arange(
            np.ceil(min(one.start for one in first) / RASTER),
            np.floor(max(one.stop for one in first) / RASTER) + 1,
        )
        over = ("step", "side")
        height = [[step.profiles[side].height(place) for side in sides] for step in self.steps]
        depth = [
            [np.interp(place, *step.depth[side], left=0.0, right=0.0) for side in sides]
            for step in self.steps
        ]
        found = {
            "height": ((*over, "place"), height, {"units": "m", "long_name": "height of the profile, down"}),
            "depth": ((*over, "place"), depth, {"units": "m", "long_name": "taken off along the normal"}),
            "equivalent_conicity": ("step", self.conicity, {"units": "1", "long_name": "at 3 mm, with roll"}),
            "left_out": ("step", [step.left_out for step in self.steps], {"long_name": "rows left out"}),
        }
        for name in WheelShape.__dataclass_fields__ if self.part == "wheel" else ("worn_area",):
            found[name] = (
                over,
                np.transpose([self.shape(name, side) for side in sides]),
                {"units": UNITS.get(name, "m")},
            )
        labels = {
            "step": np.arange(len(self.steps)),
            "side": list(sides),
            "place": ("place", place, {"units": "m"}),
            "distance": ("step", self.distance, {"units": "m" if self.part == "wheel" else "1"}),
        }
        return xarray.Dataset(found, labels)
