# Written by tools/make_fields.py from wrcontact/interface; do not edit.
"""Keywords of systems and calls, for editors and type checkers; they are read from the same tables when the package
runs."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from os import PathLike
from typing import Any, Literal, TypedDict

from numpy.typing import ArrayLike

from .interface.friction import Friction
from .interface.parameters import Material, Track, Wheelset
from .methods import (
    ContactMode,
    LateralCurvature,
    Load,
    LongitudinalCurvature,
    NormalModel,
    Separation,
    TangentialModel,
)
from .profiles import Profile, ProfileFile
from .sections import RailSections, WheelSections

OneProfile = str | PathLike[str] | ProfileFile | Profile
OneRail = OneProfile | RailSections
OneWheel = OneProfile | WheelSections
Depth = Literal["all", "patches", "geometry"]
Wanted = Depth | str | Iterable[str]
Sides = Literal["both", "left", "right"]
ContactModeName = Literal["rigid", "elastic", "compliant"]
LoadName = Literal["normal", "vertical"]
NormalModelName = Literal["analyn", "analyn_strip", "auto", "hertz", "halfspace"]
SeparationName = Literal["normal", "vertical", "equidistant", "equidistant_chord"]
LongitudinalCurvatureName = Literal["effective", "basic"]
LateralCurvatureName = Literal["adaptive", "smooth", "rough"]
TangentialModelName = Literal["none", "strips", "fastsim", "fastrip", "polach", "halfspace"]


class SystemKeywords(TypedDict, total=False):
    """Of a system."""

    rail_inclination: float | str | tuple[float | str, float | str]
    """Inclination of the rails towards the track centre as a slope; 0.025 is 1:40; 0 ... 0.1; by default 0.025."""
    gauge: float
    """Track gauge between the gauge faces of the rails; 0.5 ... 2 m; by default 1.435."""
    gauge_depth: float
    """Depth below the highest point of the inclined rail head at which the gauge is measured; 0.005 ... 0.035 m; by default 0.014."""
    running_circle_distance: float
    """Distance between the running circles of the two wheels; 0.5 ... 2.5 m; by default 1.5."""
    nominal_radius: float | tuple[float, float]
    """Wheel radius at the running circle; 0.1 ... 1 m; by default 0.46."""
    youngs_modulus: float
    """Young's modulus of wheel and rail; 1e+06 ... 1e+13 Pa; by default 2.1e+11."""
    poisson_ratio: float
    """Poisson's ratio of wheel and rail; 0 ... 0.499; by default 0.28."""
    flange_friction_ratio: float
    """Friction on a lubricated flange over that on the tread; 1: the same everywhere; 0 ... 10; by default 1."""
    flange_friction_angle: float
    """Contact angle half-way between the friction of the tread and that of the flange; it changes over 0.2 rad (11.5 deg) to either side; 0.2 ... 1.2 rad; by default 0.6."""
    friction_fall: float
    """Friction at infinite sliding velocity over that without sliding; 1: no fall (A of Polach 2005); 0 ... 1; by default 1."""
    friction_fall_rate: float
    """How fast friction falls with the sliding velocity (B of Polach 2005); 0 ... 100 s/m; by default 0."""
    slope_reduction: float
    """Initial slope of the creep force over that of clean rails; 1: clean (k0 of Spiryagin, Polach, Cole 2013); 0.01 ... 1; by default 1."""
    slope_reduction_floor: float
    """Share of the slope that is left at large creepage where slope_reduction_rate is above 0 (alpha); 0 ... 1; by default 0.02."""
    slope_reduction_rate: float
    """How fast the slope falls with creepage; 0: it does not (beta); 0 ... 10; by default 0."""
    contact_mode: ContactModeName | ContactMode
    """How wheel and rail meet; by default 'rigid'."""
    load: LoadName | Load
    """What normal_force is; by default 'normal'."""
    normal_model: NormalModelName | NormalModel | Callable[..., Any]
    """Normal contact; by default 'analyn'."""
    tolerance: float | None
    """Relative error of the numerics in penetration, area and peak pressure; nodes and strips are as fine as it needs; 0.0001 ... 0.1."""
    nodes: int | None
    """Nodes per half-width of the interpenetration, instead of those that the tolerance needs; 4 ... 38."""
    strips: int | None
    """Strips of the strip model, instead of those that the tolerance needs; 6 ... 16."""
    sweeps: int | None
    """Sweeps of the strip model, instead of those that the tolerance needs; 1 ... 20."""
    separation: SeparationName | Separation
    """How the undeformed distance of wheel and rail is measured; by default 'normal'."""
    longitudinal_curvature: LongitudinalCurvatureName | LongitudinalCurvature
    """Rolling curvature of the wheel; by default 'effective'."""
    lateral_curvature: LateralCurvatureName | LateralCurvature
    """Curvature across the rail; by default 'adaptive'."""
    curvature_reach: float
    """Half the width over which lateral_curvature smooth fits circles to the profiles; 0.0001 ... 0.01 m; by default 0.003."""
    curvature_step: float
    """Arc length over which lateral_curvature rough takes the change of the profile angle; 2e-05 ... 0.005 m; by default 0.0002."""
    tangential_model: TangentialModelName | TangentialModel | Callable[..., Any]
    """Creep forces; by default 'none'."""
    published_spin: int
    """1: the longitudinal part of spin has the flexibility of spin, as FASTSIM and FaStrip were published; 0: that of longitudinal creepage, which is closer to the complete theory; 0 ... 1; by default 0."""
    contact_damping: float
    """Contact damping with contact_mode compliant: forces are multiplied by 1 + damping times the speed of the approach, and are never below zero; 0 ... 100 s/m; by default 0."""
    rail_lateral_stiffness: float | tuple[float, float]
    """Stiffness of the spring that holds each rail laterally, read with contact_mode compliant; 0: rigid; 0 ... 1e+12 N/m; by default 0."""
    rail_vertical_stiffness: float | tuple[float, float]
    """Stiffness of the spring that holds each rail vertically, read with contact_mode compliant; 0: rigid; 0 ... 1e+12 N/m; by default 0."""
    rail_lateral_damping: float | tuple[float, float]
    """Damping beside the lateral spring of each rail, over the rail_time_step; 0 ... 1e+09 N.s/m; by default 0."""
    rail_vertical_damping: float | tuple[float, float]
    """Damping beside the vertical spring of each rail, over the rail_time_step; 0 ... 1e+09 N.s/m; by default 0."""
    independent_wheels: bool
    """Whether each wheel turns by itself, with left.wheel_rate and right.wheel_rate instead of wheel_rate; by default False."""
    nominal_rolling: bool
    """Whether a wheel_rate of 0 with free_rolling means speed / nominal_radius, a rotation that brakes or drives, instead of the one without torque; by default False."""
    wear_outputs: bool
    """Whether the outputs of wear are computed: the place on both profiles, the friction power and the patch at each station of an outline, and in Python the strips of each patch; by default False."""
    fatigue_outputs: bool
    """Whether the outputs of fatigue are computed: T gamma, its damage, the shakedown ratio and the surface fatigue index of each patch; by default False."""
    yield_shear: float
    """Yield stress in cyclic shear of wheel or rail, read with fatigue_outputs; give that of your steel; 1e+07 ... 1e+10 Pa; by default 3e+08."""
    error_outputs: bool
    """Whether the normal_model analyn estimates its error in the peak pressure; auto always does, others have no estimate; by default False."""
    stations: int
    """Stations of a patch's outline; 3 ... 201; by default 31."""
    smoothing: float | None
    """Permitted RMS distance between the curve and the points of a profile file; 0 ... 0.0005 m."""
    rail_position: float | tuple[float, float]
    """Place along the track of the position 0 of a rail whose section changes; -1e+06 ... 1e+06 m; by default 0."""
    rail_reversed: bool | tuple[bool, bool]
    """Whether the positions of a rail whose section changes count against the track; its sides stay; by default False."""
    rail_origin_y: float | tuple[float, float]
    """Lateral distance of the origin of changing sections from the track's centre, to the field side; 0: by the gauge of the section at position 0, whose highest place then has the height 0; -2 ... 2 m; by default 0."""
    rail_origin_z: float | tuple[float, float]
    """How far the origin of changing sections lies below the running surface; beside rail_origin_y only; -1 ... 1 m; by default 0."""
    roller_radius: float | tuple[float, float]
    """Radius of the roller in the place of a rail, at the highest place of its section; 0: a rail; 0 ... 1000 m; by default 0."""
    left_wheel: OneWheel | None
    """On the left side, wheel; by default that of the right."""
    left_rail: OneRail | None
    """On the left side, rail; by default that of the right."""
    left_rail_inclination: float | str | None
    """On the left side, rail_inclination; by default that of the right."""
    left_nominal_radius: float | None
    """On the left side, nominal_radius; by default that of the right."""
    left_rail_lateral_stiffness: float | None
    """On the left side, rail_lateral_stiffness; by default that of the right."""
    left_rail_vertical_stiffness: float | None
    """On the left side, rail_vertical_stiffness; by default that of the right."""
    left_rail_lateral_damping: float | None
    """On the left side, rail_lateral_damping; by default that of the right."""
    left_rail_vertical_damping: float | None
    """On the left side, rail_vertical_damping; by default that of the right."""
    left_rail_position: float | None
    """On the left side, rail_position; by default that of the right."""
    left_rail_reversed: bool | None
    """On the left side, rail_reversed; by default that of the right."""
    left_rail_origin_y: float | None
    """On the left side, rail_origin_y; by default that of the right."""
    left_rail_origin_z: float | None
    """On the left side, rail_origin_z; by default that of the right."""
    left_roller_radius: float | None
    """On the left side, roller_radius; by default that of the right."""


class WheelKeywords(TypedDict, total=False):
    """Of a system of one wheel."""

    track: Track | None
    """Track in one record."""
    wheelset: Wheelset | None
    """Wheelset in one record."""
    material: Material | None
    """Material in one record."""
    friction: Friction | None
    """Friction in one record."""
    rail_inclination: float | str
    """Inclination of the rails towards the track centre as a slope; 0.025 is 1:40; 0 ... 0.1; by default 0.025."""
    gauge: float
    """Track gauge between the gauge faces of the rails; 0.5 ... 2 m; by default 1.435."""
    gauge_depth: float
    """Depth below the highest point of the inclined rail head at which the gauge is measured; 0.005 ... 0.035 m; by default 0.014."""
    running_circle_distance: float
    """Distance between the running circles of the two wheels; 0.5 ... 2.5 m; by default 1.5."""
    nominal_radius: float
    """Wheel radius at the running circle; 0.1 ... 1 m; by default 0.46."""
    youngs_modulus: float
    """Young's modulus of wheel and rail; 1e+06 ... 1e+13 Pa; by default 2.1e+11."""
    poisson_ratio: float
    """Poisson's ratio of wheel and rail; 0 ... 0.499; by default 0.28."""
    flange_friction_ratio: float
    """Friction on a lubricated flange over that on the tread; 1: the same everywhere; 0 ... 10; by default 1."""
    flange_friction_angle: float
    """Contact angle half-way between the friction of the tread and that of the flange; it changes over 0.2 rad (11.5 deg) to either side; 0.2 ... 1.2 rad; by default 0.6."""
    friction_fall: float
    """Friction at infinite sliding velocity over that without sliding; 1: no fall (A of Polach 2005); 0 ... 1; by default 1."""
    friction_fall_rate: float
    """How fast friction falls with the sliding velocity (B of Polach 2005); 0 ... 100 s/m; by default 0."""
    slope_reduction: float
    """Initial slope of the creep force over that of clean rails; 1: clean (k0 of Spiryagin, Polach, Cole 2013); 0.01 ... 1; by default 1."""
    slope_reduction_floor: float
    """Share of the slope that is left at large creepage where slope_reduction_rate is above 0 (alpha); 0 ... 1; by default 0.02."""
    slope_reduction_rate: float
    """How fast the slope falls with creepage; 0: it does not (beta); 0 ... 10; by default 0."""
    contact_mode: ContactModeName | ContactMode
    """How wheel and rail meet; by default 'rigid'."""
    normal_model: NormalModelName | NormalModel | Callable[..., Any]
    """Normal contact; by default 'analyn'."""
    tolerance: float | None
    """Relative error of the numerics in penetration, area and peak pressure; nodes and strips are as fine as it needs; 0.0001 ... 0.1."""
    nodes: int | None
    """Nodes per half-width of the interpenetration, instead of those that the tolerance needs; 4 ... 38."""
    strips: int | None
    """Strips of the strip model, instead of those that the tolerance needs; 6 ... 16."""
    sweeps: int | None
    """Sweeps of the strip model, instead of those that the tolerance needs; 1 ... 20."""
    separation: SeparationName | Separation
    """How the undeformed distance of wheel and rail is measured; by default 'normal'."""
    longitudinal_curvature: LongitudinalCurvatureName | LongitudinalCurvature
    """Rolling curvature of the wheel; by default 'effective'."""
    lateral_curvature: LateralCurvatureName | LateralCurvature
    """Curvature across the rail; by default 'adaptive'."""
    curvature_reach: float
    """Half the width over which lateral_curvature smooth fits circles to the profiles; 0.0001 ... 0.01 m; by default 0.003."""
    curvature_step: float
    """Arc length over which lateral_curvature rough takes the change of the profile angle; 2e-05 ... 0.005 m; by default 0.0002."""
    tangential_model: TangentialModelName | TangentialModel | Callable[..., Any]
    """Creep forces; by default 'none'."""
    published_spin: int
    """1: the longitudinal part of spin has the flexibility of spin, as FASTSIM and FaStrip were published; 0: that of longitudinal creepage, which is closer to the complete theory; 0 ... 1; by default 0."""
    contact_damping: float
    """Contact damping with contact_mode compliant: forces are multiplied by 1 + damping times the speed of the approach, and are never below zero; 0 ... 100 s/m; by default 0."""
    rail_lateral_stiffness: float
    """Stiffness of the spring that holds each rail laterally, read with contact_mode compliant; 0: rigid; 0 ... 1e+12 N/m; by default 0."""
    rail_vertical_stiffness: float
    """Stiffness of the spring that holds each rail vertically, read with contact_mode compliant; 0: rigid; 0 ... 1e+12 N/m; by default 0."""
    rail_lateral_damping: float
    """Damping beside the lateral spring of each rail, over the rail_time_step; 0 ... 1e+09 N.s/m; by default 0."""
    rail_vertical_damping: float
    """Damping beside the vertical spring of each rail, over the rail_time_step; 0 ... 1e+09 N.s/m; by default 0."""
    nominal_rolling: bool
    """Whether a wheel_rate of 0 with free_rolling means speed / nominal_radius, a rotation that brakes or drives, instead of the one without torque; by default False."""
    wear_outputs: bool
    """Whether the outputs of wear are computed: the place on both profiles, the friction power and the patch at each station of an outline, and in Python the strips of each patch; by default False."""
    fatigue_outputs: bool
    """Whether the outputs of fatigue are computed: T gamma, its damage, the shakedown ratio and the surface fatigue index of each patch; by default False."""
    yield_shear: float
    """Yield stress in cyclic shear of wheel or rail, read with fatigue_outputs; give that of your steel; 1e+07 ... 1e+10 Pa; by default 3e+08."""
    error_outputs: bool
    """Whether the normal_model analyn estimates its error in the peak pressure; auto always does, others have no estimate; by default False."""
    stations: int
    """Stations of a patch's outline; 3 ... 201; by default 31."""
    smoothing: float | None
    """Permitted RMS distance between the curve and the points of a profile file; 0 ... 0.0005 m."""


class PoseInputs(TypedDict, total=False):
    """Of one pose."""

    lateral_shift: float
    """Lateral shift of the wheelset against the track centre, positive to the right [m]; by default 0."""
    yaw: float
    """Yaw of the wheelset, positive clockwise seen from above [rad]; by default 0."""
    roll_guess: float
    """Where the search for the roll angle starts; changes the cost of a step, never its answer [rad]; by default 0."""
    normal_force: float
    """Load per wheel before load transfer, normal or vertical (parameter load); in compliant contact only for the equilibrium [N]; by default 78500."""
    load_transfer: float
    """Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 - L) left [1]; by default 0."""
    vertical_shift_input: float
    """Vertical shift of the wheelset with contact_mode compliant, positive down; other modes do not read it [m]; by default 0."""
    roll_input: float
    """Roll of the wheelset with contact_mode compliant, positive with the right wheel down; other modes do not read it [rad]; by default 0."""
    left_rail_lateral: float
    """Left rail: displacement from its nominal place, to the right [m]; by default 0."""
    left_rail_vertical: float
    """Left rail: displacement from its nominal place, down [m]; by default 0."""
    left_rail_roll: float
    """Left rail: rotation about its highest point in its nominal place, positive with the right side down [rad]; by default 0."""
    right_rail_lateral: float
    """Right rail: displacement from its nominal place, to the right [m]; by default 0."""
    right_rail_vertical: float
    """Right rail: displacement from its nominal place, down [m]; by default 0."""
    right_rail_roll: float
    """Right rail: rotation about its highest point in its nominal place, positive with the right side down [rad]; by default 0."""
    speed: float
    """Speed along the track; creepages need a velocity, such as this [m/s]; by default 0."""
    lateral_velocity: float
    """How fast the lateral shift grows [m/s]; by default 0."""
    vertical_velocity: float
    """How fast the vertical shift grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [m/s]; by default 0."""
    yaw_rate: float
    """How fast the yaw grows, excluding the rotation of the track in a curve [rad/s]; by default 0."""
    roll_rate: float
    """How fast the roll grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [rad/s]; by default 0."""
    wheel_rate: float
    """Rotation of the wheelset about its axle, positive when it rolls forward; 0 with free_rolling: the one without torque or under axle_torque, or speed / nominal_radius without a tangential_model [rad/s]; by default 0."""
    free_rolling: float
    """Whether a wheel_rate of 0 means wheels that turn freely or under axle_torque; otherwise it means wheels that do not turn [1]; by default 1."""
    track_curvature: float
    """Curvature of the track, 1 / radius, positive in a curve to the right [1/m]; by default 0."""
    left_rail_lateral_velocity: float
    """Left rail: velocity to the right [m/s]; by default 0."""
    left_rail_vertical_velocity: float
    """Left rail: velocity down [m/s]; by default 0."""
    left_rail_roll_velocity: float
    """Left rail: rotation about its highest point, right side down [rad/s]; by default 0."""
    right_rail_lateral_velocity: float
    """Right rail: velocity to the right [m/s]; by default 0."""
    right_rail_vertical_velocity: float
    """Right rail: velocity down [m/s]; by default 0."""
    right_rail_roll_velocity: float
    """Right rail: rotation about its highest point, right side down [rad/s]; by default 0."""
    left_friction: float
    """Left wheel: coefficient of friction, read with a tangential_model [1]; by default 0.3."""
    right_friction: float
    """Right wheel: coefficient of friction, read with a tangential_model [1]; by default 0.3."""
    left_wheel_rate: float
    """Left wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]; by default 0."""
    right_wheel_rate: float
    """Right wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]; by default 0."""
    rail_time_step: float
    """Time in which rails on springs have come from the deflections before; 0: they are at rest, and dampers carry nothing [s]; by default 0."""
    left_rail_deflection_lateral_before: float
    """Left rail: lateral deflection of its springs one rail_time_step ago [m]; by default 0."""
    left_rail_deflection_vertical_before: float
    """Left rail: vertical deflection of its springs one rail_time_step ago [m]; by default 0."""
    right_rail_deflection_lateral_before: float
    """Right rail: lateral deflection of its springs one rail_time_step ago [m]; by default 0."""
    right_rail_deflection_vertical_before: float
    """Right rail: vertical deflection of its springs one rail_time_step ago [m]; by default 0."""
    axle_torque: float
    """Torque of motor or brake on the wheelset about its axle, positive where it drives forward; read where wheel_rate is 0 with free_rolling [N.m]; by default 0."""
    left_axle_torque: float
    """Left wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]; by default 0."""
    right_axle_torque: float
    """Right wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]; by default 0."""
    track_position: float
    """Place of the wheelset's centre along the track; only read where a rail's section changes [m]; by default 0."""
    wheel_rotation: float
    """Turn of the wheelset about its axle, growing when it rolls forward; only read where a wheel is not round [rad]; by default 0."""


class TableInputs(TypedDict, total=False):
    """Of a table of poses."""

    lateral_shift: ArrayLike
    """Lateral shift of the wheelset against the track centre, positive to the right [m]; by default 0."""
    yaw: ArrayLike
    """Yaw of the wheelset, positive clockwise seen from above [rad]; by default 0."""
    roll_guess: ArrayLike
    """Where the search for the roll angle starts; changes the cost of a step, never its answer [rad]; by default 0."""
    normal_force: ArrayLike
    """Load per wheel before load transfer, normal or vertical (parameter load); in compliant contact only for the equilibrium [N]; by default 78500."""
    load_transfer: ArrayLike
    """Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 - L) left [1]; by default 0."""
    vertical_shift_input: ArrayLike
    """Vertical shift of the wheelset with contact_mode compliant, positive down; other modes do not read it [m]; by default 0."""
    roll_input: ArrayLike
    """Roll of the wheelset with contact_mode compliant, positive with the right wheel down; other modes do not read it [rad]; by default 0."""
    left_rail_lateral: ArrayLike
    """Left rail: displacement from its nominal place, to the right [m]; by default 0."""
    left_rail_vertical: ArrayLike
    """Left rail: displacement from its nominal place, down [m]; by default 0."""
    left_rail_roll: ArrayLike
    """Left rail: rotation about its highest point in its nominal place, positive with the right side down [rad]; by default 0."""
    right_rail_lateral: ArrayLike
    """Right rail: displacement from its nominal place, to the right [m]; by default 0."""
    right_rail_vertical: ArrayLike
    """Right rail: displacement from its nominal place, down [m]; by default 0."""
    right_rail_roll: ArrayLike
    """Right rail: rotation about its highest point in its nominal place, positive with the right side down [rad]; by default 0."""
    speed: ArrayLike
    """Speed along the track; creepages need a velocity, such as this [m/s]; by default 0."""
    lateral_velocity: ArrayLike
    """How fast the lateral shift grows [m/s]; by default 0."""
    vertical_velocity: ArrayLike
    """How fast the vertical shift grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [m/s]; by default 0."""
    yaw_rate: ArrayLike
    """How fast the yaw grows, excluding the rotation of the track in a curve [rad/s]; by default 0."""
    roll_rate: ArrayLike
    """How fast the roll grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [rad/s]; by default 0."""
    wheel_rate: ArrayLike
    """Rotation of the wheelset about its axle, positive when it rolls forward; 0 with free_rolling: the one without torque or under axle_torque, or speed / nominal_radius without a tangential_model [rad/s]; by default 0."""
    free_rolling: ArrayLike
    """Whether a wheel_rate of 0 means wheels that turn freely or under axle_torque; otherwise it means wheels that do not turn [1]; by default 1."""
    track_curvature: ArrayLike
    """Curvature of the track, 1 / radius, positive in a curve to the right [1/m]; by default 0."""
    left_rail_lateral_velocity: ArrayLike
    """Left rail: velocity to the right [m/s]; by default 0."""
    left_rail_vertical_velocity: ArrayLike
    """Left rail: velocity down [m/s]; by default 0."""
    left_rail_roll_velocity: ArrayLike
    """Left rail: rotation about its highest point, right side down [rad/s]; by default 0."""
    right_rail_lateral_velocity: ArrayLike
    """Right rail: velocity to the right [m/s]; by default 0."""
    right_rail_vertical_velocity: ArrayLike
    """Right rail: velocity down [m/s]; by default 0."""
    right_rail_roll_velocity: ArrayLike
    """Right rail: rotation about its highest point, right side down [rad/s]; by default 0."""
    left_friction: ArrayLike
    """Left wheel: coefficient of friction, read with a tangential_model [1]; by default 0.3."""
    right_friction: ArrayLike
    """Right wheel: coefficient of friction, read with a tangential_model [1]; by default 0.3."""
    left_wheel_rate: ArrayLike
    """Left wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]; by default 0."""
    right_wheel_rate: ArrayLike
    """Right wheel: rotation about the axle, positive when it rolls forward, read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or under its axle_torque [rad/s]; by default 0."""
    rail_time_step: ArrayLike
    """Time in which rails on springs have come from the deflections before; 0: they are at rest, and dampers carry nothing [s]; by default 0."""
    left_rail_deflection_lateral_before: ArrayLike
    """Left rail: lateral deflection of its springs one rail_time_step ago [m]; by default 0."""
    left_rail_deflection_vertical_before: ArrayLike
    """Left rail: vertical deflection of its springs one rail_time_step ago [m]; by default 0."""
    right_rail_deflection_lateral_before: ArrayLike
    """Right rail: lateral deflection of its springs one rail_time_step ago [m]; by default 0."""
    right_rail_deflection_vertical_before: ArrayLike
    """Right rail: vertical deflection of its springs one rail_time_step ago [m]; by default 0."""
    axle_torque: ArrayLike
    """Torque of motor or brake on the wheelset about its axle, positive where it drives forward; read where wheel_rate is 0 with free_rolling [N.m]; by default 0."""
    left_axle_torque: ArrayLike
    """Left wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]; by default 0."""
    right_axle_torque: ArrayLike
    """Right wheel: torque of motor or brake on it, positive where it drives forward; read instead of axle_torque with independent_wheels [N.m]; by default 0."""
    track_position: ArrayLike
    """Place of the wheelset's centre along the track; only read where a rail's section changes [m]; by default 0."""
    wheel_rotation: ArrayLike
    """Turn of the wheelset about its axle, growing when it rolls forward; only read where a wheel is not round [rad]; by default 0."""


class WheelInputs(TypedDict, total=False):
    """Of one pose of a wheel."""

    lateral_shift: float
    """Lateral shift of the wheelset against the track centre, positive to the right [m]; by default 0."""
    yaw: float
    """Yaw of the wheelset, positive clockwise seen from above [rad]; by default 0."""
    vertical_shift_input: float
    """Vertical shift of the wheelset with contact_mode compliant, positive down; other modes do not read it [m]; by default 0."""
    roll_input: float
    """Roll of the wheelset with contact_mode compliant, positive with the right wheel down; other modes do not read it [rad]; by default 0."""
    rail_lateral: float
    """Displacement from its nominal place, to the right [m]; by default 0."""
    rail_vertical: float
    """Displacement from its nominal place, down [m]; by default 0."""
    rail_roll: float
    """Rotation about its highest point in its nominal place, positive with the right side down [rad]; by default 0."""
    speed: float
    """Speed along the track; creepages need a velocity, such as this [m/s]; by default 0."""
    lateral_velocity: float
    """How fast the lateral shift grows [m/s]; by default 0."""
    vertical_velocity: float
    """How fast the vertical shift grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [m/s]; by default 0."""
    yaw_rate: float
    """How fast the yaw grows, excluding the rotation of the track in a curve [rad/s]; by default 0."""
    roll_rate: float
    """How fast the roll grows with contact_mode compliant; in other contact modes it follows from contact with both rails, and this input is not read [rad/s]; by default 0."""
    wheel_rate: float
    """Rotation of the wheelset about its axle, positive when it rolls forward; 0 with free_rolling: the one without torque or under axle_torque, or speed / nominal_radius without a tangential_model [rad/s]; by default 0."""
    free_rolling: float
    """Whether a wheel_rate of 0 means wheels that turn freely or under axle_torque; otherwise it means wheels that do not turn [1]; by default 1."""
    track_curvature: float
    """Curvature of the track, 1 / radius, positive in a curve to the right [1/m]; by default 0."""
    rail_lateral_velocity: float
    """Velocity to the right [m/s]; by default 0."""
    rail_vertical_velocity: float
    """Velocity down [m/s]; by default 0."""
    rail_roll_velocity: float
    """Rotation about its highest point, right side down [rad/s]; by default 0."""
    friction: float
    """Coefficient of friction, read with a tangential_model [1]; by default 0.3."""
    rail_time_step: float
    """Time in which rails on springs have come from the deflections before; 0: they are at rest, and dampers carry nothing [s]; by default 0."""
    rail_deflection_lateral_before: float
    """Lateral deflection of its springs one rail_time_step ago [m]; by default 0."""
    rail_deflection_vertical_before: float
    """Vertical deflection of its springs one rail_time_step ago [m]; by default 0."""
    axle_torque: float
    """Torque of motor or brake on the wheelset about its axle, positive where it drives forward; read where wheel_rate is 0 with free_rolling [N.m]; by default 0."""
    track_position: float
    """Place of the wheelset's centre along the track; only read where a rail's section changes [m]; by default 0."""
    wheel_rotation: float
    """Turn of the wheelset about its axle, growing when it rolls forward; only read where a wheel is not round [rad]; by default 0."""
