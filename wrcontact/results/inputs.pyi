# Written by tools/make_types.py; do not edit.
"""The inputs that a state belongs to: an array whose columns have names."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

PLACES: dict[str, int]

def number(value: NDArray[Any]) -> Any: ...

class Inputs(np.ndarray[Any, np.dtype[np.float64]]):
    def __getitem__(self, key: Any) -> Any: ...
    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any: ...
    def to_dict(self) -> dict[str, Any]: ...
    @property
    def axle_torque(self) -> Any:
        """Torque of motor or brake on the wheelset about its axle, positive where it drives forward; read where wheel_rate is 0 with free_rolling [N.m]."""
    @property
    def free_rolling(self) -> Any:
        """Whether a wheel_rate of 0 means wheels that turn freely or under axle_torque; otherwise it means wheels that do not turn [1]."""
    @property
    def lateral_shift(self) -> Any:
        """Lateral shift of the wheelset against the track centre, positive to the right [m]."""
    @property
    def lateral_velocity(self) -> Any:
        """How fast the lateral shift grows [m/s]."""
    @property
    def left_axle_torque(self) -> Any:
        """Left wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]."""
    @property
    def left_friction(self) -> Any:
        """Left wheel: coefficient of friction, read with a tangential_model [1]."""
    @property
    def left_rail_deflection_lateral_before(self) -> Any:
        """Left rail: lateral deflection of its springs one rail_time_step ago [m]."""
    @property
    def left_rail_deflection_vertical_before(self) -> Any:
        """Left rail: vertical deflection of its springs one rail_time_step ago [m]."""
    @property
    def left_rail_lateral(self) -> Any:
        """Left rail: displacement from its nominal place, to the right [m]."""
    @property
    def left_rail_lateral_velocity(self) -> Any:
        """Left rail: velocity to the right [m/s]."""
    @property
    def left_rail_roll(self) -> Any:
        """Left rail: rotation about its highest point in its nominal place, positive with the right side down [rad]."""
    @property
    def left_rail_roll_velocity(self) -> Any:
        """Left rail: rotation about its highest point, right side down [rad/s]."""
    @property
    def left_rail_vertical(self) -> Any:
        """Left rail: displacement from its nominal place, down [m]."""
    @property
    def left_rail_vertical_velocity(self) -> Any:
        """Left rail: velocity down [m/s]."""
    @property
    def left_wheel_rate(self) -> Any:
        """Left wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]."""
    @property
    def load_transfer(self) -> Any:
        """Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 - L) left [1]."""
    @property
    def normal_force(self) -> Any:
        """Load per wheel before load transfer, normal or vertical (parameter load); in compliant contact only for the equilibrium [N]."""
    @property
    def rail_time_step(self) -> Any:
        """Time in which rails on springs have come from the deflections before; 0: they are at rest, and dampers carry nothing [s]."""
    @property
    def right_axle_torque(self) -> Any:
        """Right wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]."""
    @property
    def right_friction(self) -> Any:
        """Right wheel: coefficient of friction, read with a tangential_model [1]."""
    @property
    def right_rail_deflection_lateral_before(self) -> Any:
        """Right rail: lateral deflection of its springs one rail_time_step ago [m]."""
    @property
    def right_rail_deflection_vertical_before(self) -> Any:
        """Right rail: vertical deflection of its springs one rail_time_step ago [m]."""
    @property
    def right_rail_lateral(self) -> Any:
        """Right rail: displacement from its nominal place, to the right [m]."""
    @property
    def right_rail_lateral_velocity(self) -> Any:
        """Right rail: velocity to the right [m/s]."""
    @property
    def right_rail_roll(self) -> Any:
        """Right rail: rotation about its highest point in its nominal place, positive with the right side down [rad]."""
    @property
    def right_rail_roll_velocity(self) -> Any:
        """Right rail: rotation about its highest point, right side down [rad/s]."""
    @property
    def right_rail_vertical(self) -> Any:
        """Right rail: displacement from its nominal place, down [m]."""
    @property
    def right_rail_vertical_velocity(self) -> Any:
        """Right rail: velocity down [m/s]."""
    @property
    def right_wheel_rate(self) -> Any:
        """Right wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]."""
    @property
    def roll_guess(self) -> Any:
        """Where the search for the roll angle starts; changes the cost of a step, never its answer [rad]."""
    @property
    def roll_input(self) -> Any:
        """Roll of the wheelset with contact_mode compliant, positive with the right wheel down; other modes do not read it [rad]."""
    @property
    def roll_rate(self) -> Any:
        """How fast the roll grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [rad/s]."""
    @property
    def speed(self) -> Any:
        """Speed along the track; creepages need a velocity, such as this [m/s]."""
    @property
    def track_curvature(self) -> Any:
        """Curvature of the track, 1 / radius, positive in a curve to the right [1/m]."""
    @property
    def vertical_shift_input(self) -> Any:
        """Vertical shift of the wheelset with contact_mode compliant, positive down; other modes do not read it [m]."""
    @property
    def vertical_velocity(self) -> Any:
        """How fast the vertical shift grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [m/s]."""
    @property
    def wheel_rate(self) -> Any:
        """Rotation of the wheelset about its axle, positive when it rolls forward; 0 with free_rolling: the one without torque or under axle_torque, or speed / nominal_radius without a tangential_model [rad/s]."""
    @property
    def yaw(self) -> Any:
        """Yaw of the wheelset, positive clockwise seen from above [rad]."""
    @property
    def yaw_rate(self) -> Any:
        """How fast the yaw grows, excluding the rotation of the track in a curve [rad/s]."""
