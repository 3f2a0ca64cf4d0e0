# Written by tools/make_types.py; do not edit.
"""The outline of a wheel's patches at stations, and the strips of a patch, as parts of a result."""

from typing import Any

from numpy.typing import NDArray

from .layout import Layout
from .views import View, _N

_Array = NDArray[Any]

class Outline(View[_N]):
    def __init__(self, values: Any, layout: Layout, side: str) -> None: ...
    @property
    def half_length(self) -> _Array:
        """Half the length of the patch in rolling direction at the station [m], one value per station."""
    @property
    def patch_of(self) -> _Array:
        """Number of the patch that the station lies in, between patches of the nearest one; zero without load [1], one value per station; with wear_outputs."""
    @property
    def power(self) -> _Array:
        """Friction power per width at the station; its trapezoidal sum over the stations is the friction power of the wheel [W/m], one value per station; with wear_outputs."""
    @property
    def pressure(self) -> _Array:
        """Contact pressure on the centre line of the patch at the station [Pa], one value per station."""
    @property
    def rail_place(self) -> _Array:
        """Place of the station in the rail profile frame, from the highest point of the inclined head to the field side [m], one value per station; with wear_outputs."""
    @property
    def shear(self) -> _Array:
        """Creep force per area, mean over the length of the patch at the station [Pa], one value per station."""
    @property
    def slip(self) -> _Array:
        """Sliding velocity at the station, such that shear times slip is the friction power per area [m/s], one value per station."""
    @property
    def station(self) -> _Array:
        """Lateral position of an outline station in the contact plane, from the contact point to the field side [m], one value per station."""
    @property
    def wheel_place(self) -> _Array:
        """Place of the station in the wheel profile frame, from the running circle to the field side [m], one value per station; with wear_outputs."""

class WornOutline(Outline[_N]): ...

class Strips(View[_N]):
    @property
    def half_length(self) -> _Array:
        """Half its length in rolling direction [m], one value per strip."""
    @property
    def line_load(self) -> _Array:
        """Load per width [N/m], one value per strip."""
    @property
    def power(self) -> _Array:
        """Friction power per width [W/m], one value per strip."""
    @property
    def rail_place(self) -> _Array:
        """Place of its middle in the rail profile frame, from the highest point of the inclined head to the field side [m], one value per strip."""
    @property
    def slip(self) -> _Array:
        """Sliding velocity: friction power over creep force [m/s], one value per strip."""
    @property
    def wheel_place(self) -> _Array:
        """Place of its middle in the wheel profile frame, from the running circle to the field side [m], one value per strip."""
    @property
    def width(self) -> _Array:
        """Width across the rail, as stations count it [m], one value per strip."""
