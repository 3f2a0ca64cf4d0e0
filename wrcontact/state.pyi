# Written by tools/make_types.py; do not edit.
"""Results of an evaluation: names for the kernel's output array, for one pose or for a table of poses."""

from collections.abc import Iterator
from typing import Any, Generic, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray
from typing_extensions import TypeVar

from .results.inputs import Inputs
from .results.layout import Layout
from .results.outlines import Outline, Strips
from .results.views import View, _N
from .status import Status

_Array = NDArray[Any]
# Of one pose or a table: a count, and a status.
_K = TypeVar("_K", default=int)
_S = TypeVar("_S", default=Status)

class Vector(View[_N]):
    def __array__(self, dtype: Any = None, copy: bool | None = None) -> _Array: ...
    def __iter__(self) -> Iterator[_N]: ...
    @overload
    def __getitem__(self, key: int) -> _N: ...
    @overload
    def __getitem__(self, key: slice) -> tuple[_N, ...]: ...
    @property
    def x(self) -> _N:
        """Component forward."""
    @property
    def y(self) -> _N:
        """Component to the right."""
    @property
    def z(self) -> _N:
        """Component down."""

class Creepage(View[_N]):
    @property
    def spin(self) -> _N:
        """Spin: rotation of the wheel about the normal from the rail to the wheel, over the rolling speed [1/m]."""
    @property
    def x(self) -> _N:
        """Longitudinal creepage at its centre of load: velocity of the wheel against the rail, forward, over the rolling speed [1]."""
    @property
    def y(self) -> _N:
        """Lateral creepage, in the plane of the patch, positive to the left on both sides [1]."""

class Tangential(View[_N]):
    @property
    def moment(self) -> _N:
        """Moment of the tractions on the wheel about the normal from the rail to the wheel through its centre of load [N.m]."""
    @property
    def x(self) -> _N:
        """Creep force on the wheel, forward [N]."""
    @property
    def y(self) -> _N:
        """Creep force on the wheel, in the plane of the patch to the field side [N]."""

class Contact(View[_N]):
    @property
    def x_track(self) -> _N:
        """Contact point in the track frame, forward [m]."""
    @property
    def x_wheel(self) -> _N:
        """Contact point in the wheel profile frame, forward of the principal profile; the frame yaws and rolls with the wheelset but does not spin [m]."""
    @property
    def y_rail(self) -> _N:
        """Contact point in the rail profile frame, from the highest point of the inclined head to the field side [m]."""
    @property
    def y_track(self) -> _N:
        """Contact point in the track frame, to the right of the track centre (not mirrored) [m]."""
    @property
    def y_wheel(self) -> _N:
        """Contact point in the wheel profile frame, from the running circle to the field side [m]."""
    @property
    def z_rail(self) -> _N:
        """Contact point in the rail profile frame, down from the highest point of the inclined head [m]."""
    @property
    def z_track(self) -> _N:
        """Contact point in the track frame, down from top of rail [m]."""
    @property
    def z_wheel(self) -> _N:
        """Contact point in the wheel profile frame, down from the running circle [m]."""

class SideNormal(View[_N]):
    @property
    def force(self) -> Vector[_N]:
        """Part of the force that is due to the pressures alone, forward, to the right, down [N]."""
    @property
    def moment(self) -> Vector[_N]:
        """Moment of this part about the wheelset's centre, around the axis forward, to the right, down [N.m]."""

class WheelsetNormal(View[_N]):
    @property
    def force(self) -> Vector[_N]:
        """Part of the resultant that is due to the pressures alone, forward, to the right, down [N]."""
    @property
    def moment(self) -> Vector[_N]:
        """Moment of this part about the wheelset's centre, around the axis forward, to the right, down [N.m]."""

class Patch(View[_N]):
    @property
    def area(self) -> _N:
        """Contact area [m2]."""
    @property
    def centroid(self) -> _N:
        """Centre of load in the contact plane, from the contact point to the field side [m]."""
    @property
    def contact_angle(self) -> _N:
        """Angle of its force: that of the rail's normal at its centre of load, positive towards the flange [rad]."""
    @property
    def creepage(self) -> Creepage[_N]:
        """Velocity of the wheel against the rail in the plane of a patch, over the rolling speed."""
    @property
    def fatigue_damage(self) -> _N:
        """T gamma damage of a passage; a sum of 1 begins a crack [1]."""
    @property
    def force(self) -> Vector[_N]:
        """Force of the rail on the wheel, forward, to the right, down [N]."""
    @property
    def friction_power(self) -> _N:
        """Power that friction takes from the motion [W]."""
    @property
    def length(self) -> _N:
        """Length in rolling direction [m]."""
    @property
    def max_pressure(self) -> _N:
        """Highest contact pressure [Pa]."""
    @property
    def max_shear(self) -> _N:
        """Largest traction; zero where the model does not know it [Pa]."""
    @property
    def normal_force(self) -> _N:
        """Normal force [N]."""
    @property
    def penetration(self) -> _N:
        """Local penetration of the undeformed surfaces at its point of smallest gap or largest overlap [m]."""
    @property
    def rolling_radius(self) -> _N:
        """Rolling radius at its centre of load: nominal radius plus height of the wheel profile [m]."""
    @property
    def saturation(self) -> _N:
        """Creep force over friction times normal force [1]."""
    @property
    def shakedown_ratio(self) -> _N:
        """Peak pressure of an ellipse with its load and area, over yield_shear [1]."""
    @property
    def stick_share(self) -> _N:
        """Share of the area that sticks; zero where the model does not know it [1]."""
    @property
    def surface_fatigue_index(self) -> _N:
        """Creep force over normal force, minus 1 / shakedown_ratio; above zero the surface yields at every passage [1]."""
    @property
    def tangential(self) -> Tangential[_N]:
        """Creep force and moment of a patch on its wheel."""
    @property
    def wear_number(self) -> _N:
        """Wear number T gamma: creep forces times creepages without spin; this and what follows is zero without fatigue_outputs [N]."""
    @property
    def width(self) -> _N:
        """Width in the contact plane [m]."""
    @property
    def x_track(self) -> _N:
        """Centre of load in the track frame, forward [m]."""
    @property
    def y_track(self) -> _N:
        """Centre of load in the track frame, to the right of the track centre (not mirrored) [m]."""
    @property
    def z_track(self) -> _N:
        """Centre of load in the track frame, down from top of rail [m]."""

class Side(View[_N], Generic[_N, _K]):
    @property
    def patch_count(self) -> _K: ...
    @property
    def patches(self) -> tuple[Patch[_N], ...]: ...
    @property
    def outline(self) -> Outline[_N]: ...
    @property
    def strips(self) -> tuple[Strips[_N], ...]: ...
    @property
    def area(self) -> _N:
        """Contact area, total over the patches [m2]."""
    @property
    def contact(self) -> Contact[_N]:
        """The contact point in the frames of the wheel, the rail and the track."""
    @property
    def contact_angle(self) -> _N:
        """Contact angle, positive towards the flange [rad]."""
    @property
    def curvature_x(self) -> _N:
        """Relative (combined) principal curvature of wheel and rail at the contact point, in rolling direction [1/m]."""
    @property
    def curvature_y(self) -> _N:
        """Relative (combined) principal curvature of wheel and rail at the contact point, across the rail [1/m]."""
    @property
    def damping_power(self) -> _N:
        """Power that contact damping takes from the motion, sum over the patches [W]."""
    @property
    def derailment_quotient(self) -> _N:
        """Y/Q of EN 14363: force of the wheel on its rail, outwards over downwards; zero where it does not press its rail down [1]."""
    @property
    def driving_torque(self) -> _N:
        """Torque of the creep forces about the axle, positive where they turn the wheel forward [N.m]."""
    @property
    def force(self) -> Vector[_N]:
        """Force of the rail on the wheel, forward, to the right, down [N]."""
    @property
    def friction_power(self) -> _N:
        """Power that friction takes from the motion, sum over the patches [W]."""
    @property
    def max_pressure(self) -> _N:
        """Highest contact pressure [Pa]."""
    @property
    def model_error(self) -> _N:
        """Estimate of the relative error of max_pressure, of the normal_model auto, and of analyn with error_outputs; else zero [1]."""
    @property
    def moment(self) -> Vector[_N]:
        """Moment of this force about the wheelset's centre, around the axis forward, to the right, down [N.m]."""
    @property
    def normal(self) -> SideNormal[_N]:
        """Forces and moments of the pressures alone, without creep forces."""
    @property
    def normal_force(self) -> _N:
        """Normal force, total over the patches [N]."""
    @property
    def patch_centroid(self) -> _N:
        """Centre of load in the contact plane, from the contact point to the field side [m]."""
    @property
    def patch_length(self) -> _N:
        """Length of the contact in rolling direction [m]."""
    @property
    def patch_width(self) -> _N:
        """Width of the contact in the contact plane, from first to last loaded point [m]."""
    @property
    def penetration(self) -> _N:
        """Penetration: approach of the two bodies [m]."""
    @property
    def rail_deflection_lateral(self) -> _N:
        """Displacement of the rail from the foot of its springs, to the right; zero where it is rigid [m]."""
    @property
    def rail_deflection_vertical(self) -> _N:
        """Displacement of the rail from the foot of its springs, down; zero where it is rigid [m]."""
    @property
    def rolling_radius(self) -> _N:
        """Rolling radius at the contact point: nominal radius plus height of the wheel profile [m]."""
    @property
    def wear_number(self) -> _N:
        """Wear number T gamma: creep forces times creepages without spin, sum over the patches [N]."""
    @property
    def wheel_rate_found(self) -> _N:
        """Rotation about the axle that creepages hold for: the one that is given, or that follows [rad/s]."""

class Equilibrium(NamedTuple):
    vertical_shift: float
    roll: float
    status: int

class WheelsetState(View[_N], Generic[_N, _K, _S]):
    values: _Array
    status: _S
    def __init__(self, values: _Array, status: _S, inputs: _Array | None, layout: Layout = ...,
                 kept: _Array | None = None, system: Any = None) -> None: ...
    @property
    def inputs(self) -> Inputs: ...
    @property
    def left(self) -> Side[_N, _K]: ...
    @property
    def right(self) -> Side[_N, _K]: ...
    @property
    def equilibrium(self) -> Equilibrium: ...
    @property
    def names(self) -> tuple[str, ...]: ...
    @overload
    def __getitem__(self, key: str) -> _N: ...
    @overload
    def __getitem__(self, key: int) -> WheelsetState: ...
    @overload
    def __getitem__(self, key: slice | _Array) -> WheelsetState[_Array, _Array, _Array]: ...
    def to_pandas(self) -> Any: ...
    def to_xarray(self) -> Any: ...
    @property
    def summary(self) -> str: ...
    @property
    def driving_torque(self) -> _N:
        """Torque of the creep forces about the axle, positive where they turn the wheels forward [N.m]."""
    @property
    def force(self) -> Vector[_N]:
        """Resultant of the contact forces on the wheelset, forward, to the right, down [N]."""
    @property
    def moment(self) -> Vector[_N]:
        """Moment of the contact forces about the wheelset's centre, around the axis forward, to the right, down [N.m]."""
    @property
    def normal(self) -> WheelsetNormal[_N]:
        """Forces and moments of the pressures alone, without creep forces."""
    @property
    def roll(self) -> _N:
        """Roll of the wheelset, positive with the right wheel down [rad]."""
    @property
    def rows_of_inputs(self) -> _Array:
        """The :class:`~wrcontact.results.inputs.Rows` of a table."""
    @property
    def vertical_shift(self) -> _N:
        """Vertical shift of the wheelset, positive down [m]."""
