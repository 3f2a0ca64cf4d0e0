# Written by tools/make_fields.py from wrcontact/interface; do not edit.
"""The parts of a result and the inputs by name: a property for each row of the tables of inputs and outputs."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .views import N, RunView, StripView, Vector, View


class InputFields(np.ndarray):
    """Inputs by the names of Python's keywords."""

    @property
    def lateral_shift(self) -> Any:
        """Lateral shift of the wheelset against the track centre, positive to the right [m]."""
        return self["lateral_shift"]

    @property
    def yaw(self) -> Any:
        """Yaw of the wheelset, positive clockwise seen from above [rad]."""
        return self["yaw"]

    @property
    def roll_guess(self) -> Any:
        """Where the search for the roll angle starts; changes the cost of a step, never its answer [rad]."""
        return self["roll_guess"]

    @property
    def normal_force(self) -> Any:
        """Load per wheel before load transfer, normal or vertical (parameter load); in compliant contact only for the equilibrium [N]."""
        return self["normal_force"]

    @property
    def load_transfer(self) -> Any:
        """Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 - L) left [1]."""
        return self["load_transfer"]

    @property
    def vertical_shift_input(self) -> Any:
        """Vertical shift of the wheelset with contact_mode compliant, positive down; other modes do not read it [m]."""
        return self["vertical_shift_input"]

    @property
    def roll_input(self) -> Any:
        """Roll of the wheelset with contact_mode compliant, positive with the right wheel down; other modes do not read it [rad]."""
        return self["roll_input"]

    @property
    def left_rail_lateral(self) -> Any:
        """Left rail: displacement from its nominal place, to the right [m]."""
        return self["left.rail_lateral"]

    @property
    def left_rail_vertical(self) -> Any:
        """Left rail: displacement from its nominal place, down [m]."""
        return self["left.rail_vertical"]

    @property
    def left_rail_roll(self) -> Any:
        """Left rail: rotation about its highest point in its nominal place, positive with the right side down [rad]."""
        return self["left.rail_roll"]

    @property
    def right_rail_lateral(self) -> Any:
        """Right rail: displacement from its nominal place, to the right [m]."""
        return self["right.rail_lateral"]

    @property
    def right_rail_vertical(self) -> Any:
        """Right rail: displacement from its nominal place, down [m]."""
        return self["right.rail_vertical"]

    @property
    def right_rail_roll(self) -> Any:
        """Right rail: rotation about its highest point in its nominal place, positive with the right side down [rad]."""
        return self["right.rail_roll"]

    @property
    def speed(self) -> Any:
        """Speed along the track; creepages need a velocity, such as this [m/s]."""
        return self["speed"]

    @property
    def lateral_velocity(self) -> Any:
        """How fast the lateral shift grows [m/s]."""
        return self["lateral_velocity"]

    @property
    def vertical_velocity(self) -> Any:
        """How fast the vertical shift grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [m/s]."""
        return self["vertical_velocity"]

    @property
    def yaw_rate(self) -> Any:
        """How fast the yaw grows, excluding the rotation of the track in a curve [rad/s]."""
        return self["yaw_rate"]

    @property
    def roll_rate(self) -> Any:
        """How fast the roll grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [rad/s]."""
        return self["roll_rate"]

    @property
    def wheel_rate(self) -> Any:
        """Rotation of the wheelset about its axle, positive when it rolls forward; 0 with free_rolling: the one without torque or under axle_torque, or speed / nominal_radius without a tangential_model [rad/s]."""
        return self["wheel_rate"]

    @property
    def free_rolling(self) -> Any:
        """Whether a wheel_rate of 0 means wheels that turn freely or under axle_torque; otherwise it means wheels that do not turn [1]."""
        return self["free_rolling"]

    @property
    def track_curvature(self) -> Any:
        """Curvature of the track, 1 / radius, positive in a curve to the right [1/m]."""
        return self["track_curvature"]

    @property
    def left_rail_lateral_velocity(self) -> Any:
        """Left rail: velocity to the right [m/s]."""
        return self["left.rail_lateral_velocity"]

    @property
    def left_rail_vertical_velocity(self) -> Any:
        """Left rail: velocity down [m/s]."""
        return self["left.rail_vertical_velocity"]

    @property
    def left_rail_roll_velocity(self) -> Any:
        """Left rail: rotation about its highest point, right side down [rad/s]."""
        return self["left.rail_roll_velocity"]

    @property
    def right_rail_lateral_velocity(self) -> Any:
        """Right rail: velocity to the right [m/s]."""
        return self["right.rail_lateral_velocity"]

    @property
    def right_rail_vertical_velocity(self) -> Any:
        """Right rail: velocity down [m/s]."""
        return self["right.rail_vertical_velocity"]

    @property
    def right_rail_roll_velocity(self) -> Any:
        """Right rail: rotation about its highest point, right side down [rad/s]."""
        return self["right.rail_roll_velocity"]

    @property
    def left_friction(self) -> Any:
        """Left wheel: coefficient of friction, read with a tangential_model [1]."""
        return self["left.friction"]

    @property
    def right_friction(self) -> Any:
        """Right wheel: coefficient of friction, read with a tangential_model [1]."""
        return self["right.friction"]

    @property
    def left_wheel_rate(self) -> Any:
        """Left wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]."""
        return self["left.wheel_rate"]

    @property
    def right_wheel_rate(self) -> Any:
        """Right wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]."""
        return self["right.wheel_rate"]

    @property
    def rail_time_step(self) -> Any:
        """Time in which rails on springs have come from the deflections before; 0: they are at rest, and dampers carry nothing [s]."""
        return self["rail_time_step"]

    @property
    def left_rail_deflection_lateral_before(self) -> Any:
        """Left rail: lateral deflection of its springs one rail_time_step ago [m]."""
        return self["left.rail_deflection_lateral_before"]

    @property
    def left_rail_deflection_vertical_before(self) -> Any:
        """Left rail: vertical deflection of its springs one rail_time_step ago [m]."""
        return self["left.rail_deflection_vertical_before"]

    @property
    def right_rail_deflection_lateral_before(self) -> Any:
        """Right rail: lateral deflection of its springs one rail_time_step ago [m]."""
        return self["right.rail_deflection_lateral_before"]

    @property
    def right_rail_deflection_vertical_before(self) -> Any:
        """Right rail: vertical deflection of its springs one rail_time_step ago [m]."""
        return self["right.rail_deflection_vertical_before"]

    @property
    def axle_torque(self) -> Any:
        """Torque of motor or brake on the wheelset about its axle, positive where it drives forward; read where wheel_rate is 0 with free_rolling [N.m]."""
        return self["axle_torque"]

    @property
    def left_axle_torque(self) -> Any:
        """Left wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]."""
        return self["left.axle_torque"]

    @property
    def right_axle_torque(self) -> Any:
        """Right wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]."""
        return self["right.axle_torque"]

    @property
    def track_position(self) -> Any:
        """Place of the wheelset's centre along the track; only read where a rail's section changes [m]."""
        return self["track_position"]

    @property
    def wheel_rotation(self) -> Any:
        """Turn of the wheelset about its axle, growing when it rolls forward; only read where a wheel is not round [rad]."""
        return self["wheel_rotation"]


class Creepage(View[N]):
    """Velocity of the wheel against the rail in the plane of a patch, over the rolling speed."""

    __slots__ = ()
    _members = (
        "x",
        "y",
        "spin",
    )

    @property
    def x(self) -> N:
        """Longitudinal creepage at its centre of load: velocity of the wheel against the rail, forward, over the rolling speed [1]."""
        return self._number(15)

    @property
    def y(self) -> N:
        """Lateral creepage, in the plane of the patch, positive to the left on both sides [1]."""
        return self._number(16)

    @property
    def spin(self) -> N:
        """Spin: rotation of the wheel about the normal from the rail to the wheel, over the rolling speed [1/m]."""
        return self._number(17)


class Tangential(View[N]):
    """Creep force and moment of a patch on its wheel."""

    __slots__ = ()
    _members = (
        "x",
        "y",
        "moment",
    )

    @property
    def x(self) -> N:
        """Creep force on the wheel, forward [N]."""
        return self._number(18)

    @property
    def y(self) -> N:
        """Creep force on the wheel, in the plane of the patch to the field side [N]."""
        return self._number(19)

    @property
    def moment(self) -> N:
        """Moment of the tractions on the wheel about the normal from the rail to the wheel through its centre of load [N.m]."""
        return self._number(20)


class PatchFields(View[N]):
    """One contact patch."""

    __slots__ = ()
    _members = (
        "normal_force",
        "area",
        "max_pressure",
        "length",
        "width",
        "centroid",
        "contact_angle",
        "penetration",
        "rolling_radius",
        "x_track",
        "y_track",
        "z_track",
        "force",
        "creepage",
        "tangential",
        "stick_share",
        "max_shear",
        "friction_power",
        "saturation",
        "wear_number",
        "fatigue_damage",
        "shakedown_ratio",
        "surface_fatigue_index",
        "slope",
    )

    @property
    def creepage(self) -> Creepage[N]:
        """Velocity of the wheel against the rail in the plane of a patch, over the rolling speed."""
        return Creepage(self._values, self._offset, self.layout)

    @property
    def tangential(self) -> Tangential[N]:
        """Creep force and moment of a patch on its wheel."""
        return Tangential(self._values, self._offset, self.layout)

    @property
    def normal_force(self) -> N:
        """Normal force [N]."""
        return self._number(0)

    @property
    def area(self) -> N:
        """Contact area [m2]."""
        return self._number(1)

    @property
    def max_pressure(self) -> N:
        """Highest contact pressure [Pa]."""
        return self._number(2)

    @property
    def length(self) -> N:
        """Length in rolling direction [m]."""
        return self._number(3)

    @property
    def width(self) -> N:
        """Width in the contact plane [m]."""
        return self._number(4)

    @property
    def centroid(self) -> N:
        """Centre of load in the contact plane, from the contact point to the field side [m]."""
        return self._number(5)

    @property
    def contact_angle(self) -> N:
        """Angle of its force: that of the rail's normal at its centre of load, positive towards the flange [rad]."""
        return self._number(6)

    @property
    def penetration(self) -> N:
        """Local penetration of the undeformed surfaces at its point of smallest gap or largest overlap [m]."""
        return self._number(7)

    @property
    def rolling_radius(self) -> N:
        """Rolling radius at its centre of load: nominal radius plus height of the wheel profile [m]."""
        return self._number(8)

    @property
    def x_track(self) -> N:
        """Centre of load in the track frame, forward [m]."""
        return self._number(9)

    @property
    def y_track(self) -> N:
        """Centre of load in the track frame, to the right of the track centre (not mirrored) [m]."""
        return self._number(10)

    @property
    def z_track(self) -> N:
        """Centre of load in the track frame, down from top of rail [m]."""
        return self._number(11)

    @property
    def force(self) -> Vector[N]:
        """Force of the rail on the wheel, forward, to the right, down [N]."""
        return Vector(self._values, self._offset + 12, self.layout)

    @property
    def stick_share(self) -> N:
        """Share of the area that sticks; zero where the model does not know it [1]."""
        return self._number(21)

    @property
    def max_shear(self) -> N:
        """Largest traction; zero where the model does not know it [Pa]."""
        return self._number(22)

    @property
    def friction_power(self) -> N:
        """Power that friction takes from the motion [W]."""
        return self._number(23)

    @property
    def saturation(self) -> N:
        """Creep force over friction times normal force [1]."""
        return self._number(24)

    @property
    def wear_number(self) -> N:
        """Wear number T gamma: creep forces times creepages without spin; this and what follows is zero without fatigue_outputs [N]."""
        return self._number(25)

    @property
    def fatigue_damage(self) -> N:
        """T gamma damage of a passage; a sum of 1 begins a crack [1]."""
        return self._number(26)

    @property
    def shakedown_ratio(self) -> N:
        """Peak pressure of an ellipse with its load and area, over yield_shear [1]."""
        return self._number(27)

    @property
    def surface_fatigue_index(self) -> N:
        """Creep force over normal force, minus 1 / shakedown_ratio; above zero the surface yields at every passage [1]."""
        return self._number(28)

    @property
    def slope(self) -> N:
        """Inclination of the normal of its force along the track, positive where it pushes back; zero on a rail that is the same all along the track [rad]."""
        return self._number(29)


class Contact(View[N]):
    """The contact point in the frames of the wheel, the rail and the track."""

    __slots__ = ()
    _members = (
        "x_wheel",
        "y_wheel",
        "z_wheel",
        "y_rail",
        "z_rail",
        "x_track",
        "y_track",
        "z_track",
    )

    @property
    def x_wheel(self) -> N:
        """Contact point in the wheel profile frame, forward of the principal profile; the frame yaws and rolls with the wheelset but does not spin [m]."""
        return self._number(1)

    @property
    def y_wheel(self) -> N:
        """Contact point in the wheel profile frame, from the running circle to the field side [m]."""
        return self._number(2)

    @property
    def z_wheel(self) -> N:
        """Contact point in the wheel profile frame, down from the running circle [m]."""
        return self._number(3)

    @property
    def y_rail(self) -> N:
        """Contact point in the rail profile frame, from the highest point of the inclined head to the field side [m]."""
        return self._number(4)

    @property
    def z_rail(self) -> N:
        """Contact point in the rail profile frame, down from the highest point of the inclined head [m]."""
        return self._number(5)

    @property
    def x_track(self) -> N:
        """Contact point in the track frame, forward [m]."""
        return self._number(6)

    @property
    def y_track(self) -> N:
        """Contact point in the track frame, to the right of the track centre (not mirrored) [m]."""
        return self._number(7)

    @property
    def z_track(self) -> N:
        """Contact point in the track frame, down from top of rail [m]."""
        return self._number(8)


class SideNormal(View[N]):
    """Forces and moments of the pressures alone, without creep forces."""

    __slots__ = ()
    _members = (
        "force",
        "moment",
    )

    @property
    def force(self) -> Vector[N]:
        """Part of the force that is due to the pressures alone, forward, to the right, down [N]."""
        return Vector(self._values, self._offset + 26, self.layout)

    @property
    def moment(self) -> Vector[N]:
        """Moment of this part about the wheelset's centre, around the axis forward, to the right, down [N.m]."""
        return Vector(self._values, self._offset + 29, self.layout)


class SideFields(View[N]):
    """One wheel on its rail."""

    __slots__ = ()
    _members = (
        "patch_count",
        "contact",
        "contact_angle",
        "rolling_radius",
        "curvature_x",
        "curvature_y",
        "penetration",
        "normal_force",
        "area",
        "max_pressure",
        "patch_length",
        "patch_width",
        "patch_centroid",
        "force",
        "moment",
        "normal",
        "friction_power",
        "wear_number",
        "driving_torque",
        "damping_power",
        "derailment_quotient",
        "rail_deflection_lateral",
        "rail_deflection_vertical",
        "wheel_rate_found",
        "model_error",
    )

    @property
    def contact(self) -> Contact[N]:
        """The contact point in the frames of the wheel, the rail and the track."""
        return Contact(self._values, self._offset, self.layout)

    @property
    def normal(self) -> SideNormal[N]:
        """Forces and moments of the pressures alone, without creep forces."""
        return SideNormal(self._values, self._offset, self.layout)

    @property
    def contact_angle(self) -> N:
        """Contact angle, positive towards the flange [rad]."""
        return self._number(9)

    @property
    def rolling_radius(self) -> N:
        """Rolling radius at the contact point: nominal radius plus height of the wheel profile [m]."""
        return self._number(10)

    @property
    def curvature_x(self) -> N:
        """Relative (combined) principal curvature of wheel and rail at the contact point, in rolling direction [1/m]."""
        return self._number(11)

    @property
    def curvature_y(self) -> N:
        """Relative (combined) principal curvature of wheel and rail at the contact point, across the rail [1/m]."""
        return self._number(12)

    @property
    def penetration(self) -> N:
        """Penetration: approach of the two bodies [m]."""
        return self._number(13)

    @property
    def normal_force(self) -> N:
        """Normal force, total over the patches [N]."""
        return self._number(14)

    @property
    def area(self) -> N:
        """Contact area, total over the patches [m2]."""
        return self._number(15)

    @property
    def max_pressure(self) -> N:
        """Highest contact pressure [Pa]."""
        return self._number(16)

    @property
    def patch_length(self) -> N:
        """Length of the contact in rolling direction [m]."""
        return self._number(17)

    @property
    def patch_width(self) -> N:
        """Width of the contact in the contact plane, from first to last loaded point [m]."""
        return self._number(18)

    @property
    def patch_centroid(self) -> N:
        """Centre of load in the contact plane, from the contact point to the field side [m]."""
        return self._number(19)

    @property
    def force(self) -> Vector[N]:
        """Force of the rail on the wheel, forward, to the right, down [N]."""
        return Vector(self._values, self._offset + 20, self.layout)

    @property
    def moment(self) -> Vector[N]:
        """Moment of this force about the wheelset's centre, around the axis forward, to the right, down [N.m]."""
        return Vector(self._values, self._offset + 23, self.layout)

    @property
    def friction_power(self) -> N:
        """Power that friction takes from the motion, sum over the patches [W]."""
        return self._number(32)

    @property
    def wear_number(self) -> N:
        """Wear number T gamma: creep forces times creepages without spin, sum over the patches [N]."""
        return self._number(33)

    @property
    def driving_torque(self) -> N:
        """Torque of the creep forces about the axle, positive where they turn the wheel forward [N.m]."""
        return self._number(34)

    @property
    def damping_power(self) -> N:
        """Power that contact damping takes from the motion, sum over the patches [W]."""
        return self._number(35)

    @property
    def derailment_quotient(self) -> N:
        """Y/Q of EN 14363: force of the wheel on its rail, outwards over downwards; zero where it does not press its rail down [1]."""
        return self._number(36)

    @property
    def rail_deflection_lateral(self) -> N:
        """Displacement of the rail from the foot of its springs, to the right; zero where it is rigid [m]."""
        return self._number(37)

    @property
    def rail_deflection_vertical(self) -> N:
        """Displacement of the rail from the foot of its springs, down; zero where it is rigid [m]."""
        return self._number(38)

    @property
    def wheel_rate_found(self) -> N:
        """Rotation about the axle that creepages hold for: the one that is given, or that follows [rad/s]."""
        return self._number(39)

    @property
    def model_error(self) -> N:
        """Estimate of the relative error of max_pressure, of the normal_model auto, and of analyn with error_outputs; else zero [1]."""
        return self._number(40)


class WheelsetNormal(View[N]):
    """Forces and moments of the pressures alone, without creep forces."""

    __slots__ = ()
    _members = (
        "force",
        "moment",
    )

    @property
    def force(self) -> Vector[N]:
        """Part of the resultant that is due to the pressures alone, forward, to the right, down [N]."""
        return Vector(self._values, self._offset + 8, self.layout)

    @property
    def moment(self) -> Vector[N]:
        """Moment of this part about the wheelset's centre, around the axis forward, to the right, down [N.m]."""
        return Vector(self._values, self._offset + 11, self.layout)


class WheelsetFields(View[N]):
    """A wheelset on its track."""

    __slots__ = ()
    _members = (
        "roll",
        "vertical_shift",
        "force",
        "moment",
        "normal",
        "driving_torque",
    )

    @property
    def normal(self) -> WheelsetNormal[N]:
        """Forces and moments of the pressures alone, without creep forces."""
        return WheelsetNormal(self._values, self._offset, self.layout)

    @property
    def roll(self) -> N:
        """Roll of the wheelset, positive with the right wheel down [rad]."""
        return self._number(0)

    @property
    def vertical_shift(self) -> N:
        """Vertical shift of the wheelset, positive down [m]."""
        return self._number(1)

    @property
    def force(self) -> Vector[N]:
        """Resultant of the contact forces on the wheelset, forward, to the right, down [N]."""
        return Vector(self._values, self._offset + 2, self.layout)

    @property
    def moment(self) -> Vector[N]:
        """Moment of the contact forces about the wheelset's centre, around the axis forward, to the right, down [N.m]."""
        return Vector(self._values, self._offset + 5, self.layout)

    @property
    def driving_torque(self) -> N:
        """Torque of the creep forces about the axle, positive where they turn the wheels forward [N.m]."""
        return self._number(14)


class Outline(RunView[N]):
    """Outline and pressure at evenly spaced stations across, from the first loaded place to the last."""

    __slots__ = ()
    _members = (
        "station",
        "half_length",
        "pressure",
        "shear",
        "slip",
    )

    @property
    def station(self) -> NDArray[Any]:
        """Lateral position of an outline station in the contact plane, from the contact point to the field side [m], one value per station."""
        return self._run("station")

    @property
    def half_length(self) -> NDArray[Any]:
        """Half the length of the patch in rolling direction at the station [m], one value per station."""
        return self._run("half_length")

    @property
    def pressure(self) -> NDArray[Any]:
        """Contact pressure on the centre line of the patch at the station [Pa], one value per station."""
        return self._run("pressure")

    @property
    def shear(self) -> NDArray[Any]:
        """Creep force per area, mean over the length of the patch at the station [Pa], one value per station."""
        return self._run("shear")

    @property
    def slip(self) -> NDArray[Any]:
        """Sliding velocity at the station, such that shear times slip is the friction power per area [m/s], one value per station."""
        return self._run("slip")

    @property
    def wheel_place(self) -> NDArray[Any]:
        """Place of the station in the wheel profile frame, from the running circle to the field side [m], one value per station; with wear_outputs."""
        return self._run("wheel_place")

    @property
    def rail_place(self) -> NDArray[Any]:
        """Place of the station in the rail profile frame, from the highest point of the inclined head to the field side [m], one value per station; with wear_outputs."""
        return self._run("rail_place")

    @property
    def power(self) -> NDArray[Any]:
        """Friction power per width at the station; its trapezoidal sum over the stations is the friction power of the wheel [W/m], one value per station; with wear_outputs."""
        return self._run("power")

    @property
    def patch_of(self) -> NDArray[Any]:
        """Number of the patch that the station lies in, between patches of the nearest one; zero without load [1], one value per station; with wear_outputs."""
        return self._run("patch_of")


class WornOutline(Outline[N]):
    """An outline with the outputs of wear."""

    __slots__ = ()
    _members = (
        "station",
        "half_length",
        "pressure",
        "shear",
        "slip",
        "wheel_place",
        "rail_place",
        "power",
        "patch_of",
    )


class Strips(StripView[N]):
    """The strips of a patch along the rolling direction, across the rail: arrays (16,), or (n, 16) of a
    table, zero where the patch is not there."""

    __slots__ = ()
    _members = (
        "wheel_place",
        "rail_place",
        "width",
        "line_load",
        "half_length",
        "power",
        "slip",
    )

    @property
    def wheel_place(self) -> NDArray[Any]:
        """Place of its middle in the wheel profile frame, from the running circle to the field side [m], one value per strip."""
        return self._strips(0)

    @property
    def rail_place(self) -> NDArray[Any]:
        """Place of its middle in the rail profile frame, from the highest point of the inclined head to the field side [m], one value per strip."""
        return self._strips(16)

    @property
    def width(self) -> NDArray[Any]:
        """Width across the rail, as stations count it [m], one value per strip."""
        return self._strips(32)

    @property
    def line_load(self) -> NDArray[Any]:
        """Load per width [N/m], one value per strip."""
        return self._strips(48)

    @property
    def half_length(self) -> NDArray[Any]:
        """Half its length in rolling direction [m], one value per strip."""
        return self._strips(64)

    @property
    def power(self) -> NDArray[Any]:
        """Friction power per width [W/m], one value per strip."""
        return self._strips(80)

    @property
    def slip(self) -> NDArray[Any]:
        """Sliding velocity: friction power over creep force [m/s], one value per strip."""
        return self._strips(96)
