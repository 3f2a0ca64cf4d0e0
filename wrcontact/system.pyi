# Written by tools/make_types.py; do not edit.
"""A wheelset on its track: what is fixed, prepared once; poses are evaluated against it."""

from collections.abc import Callable, Iterable, Iterator
from os import PathLike
from typing import Any, Literal

from numpy.typing import ArrayLike, NDArray

from .interface.friction import Friction
from .interface.parameters import Material, Track, Wheelset
from .methods import (
    ContactMode,
    Load,
    NormalModel,
    Separation,
    LongitudinalCurvature,
    LateralCurvature,
    TangentialModel,
)
from .linear.record import Linearization
from .profiles import Profile, ProfileFile
from .state import _Array, Equilibrium, WheelsetState
from .stepper import Stepper

_OneProfile = str | PathLike[str] | ProfileFile | Profile
_Wanted = Literal["all", "patches", "geometry"] | str | Iterable[str]
_Sides = Literal["both", "left", "right"]

class ContactSystem:
    parameters: dict[str, Any]
    methods: dict[str, Any]
    resolution: Any
    wheel: Profile
    rail: Profile
    left_wheel: Profile
    left_rail: Profile
    def __init__(
        self,
        wheel: _OneProfile | tuple[_OneProfile, _OneProfile] = "S1002",
        rail: _OneProfile | tuple[_OneProfile, _OneProfile] = "UIC60",
        *,
        track: Track | None = None,
        wheelset: Wheelset | None = None,
        material: Material | None = None,
        friction: Friction | None = None,
        rail_inclination: float | str | tuple[float | str, float | str] = 0.025,
        gauge: float = 1.435,
        gauge_depth: float = 0.014,
        running_circle_distance: float = 1.5,
        nominal_radius: float | tuple[float, float] = 0.46,
        youngs_modulus: float = 210000000000.0,
        poisson_ratio: float = 0.28,
        flange_friction_ratio: float = 1.0,
        flange_friction_angle: float = 0.6,
        friction_fall: float = 1.0,
        friction_fall_rate: float = 0.0,
        slope_reduction: float = 1.0,
        slope_reduction_floor: float = 0.02,
        slope_reduction_rate: float = 0.0,
        contact_mode: Literal["rigid", "elastic", "compliant"] | ContactMode = "rigid",
        load: Literal["normal", "vertical"] | Load = "normal",
        normal_model: Literal["analyn", "analyn_strip", "auto", "hertz", "halfspace"] | NormalModel | Callable[..., Any] = "analyn",
        tolerance: float | None = None,
        nodes: int | None = None,
        strips: int | None = None,
        sweeps: int | None = None,
        separation: Literal["normal", "vertical", "equidistant", "equidistant_chord"] | Separation = "normal",
        longitudinal_curvature: Literal["effective", "basic"] | LongitudinalCurvature = "effective",
        lateral_curvature: Literal["adaptive", "smooth", "rough"] | LateralCurvature = "adaptive",
        curvature_reach: float = 0.003,
        curvature_step: float = 0.0002,
        tangential_model: Literal["none", "strips", "fastsim", "fastrip", "polach", "halfspace"] | TangentialModel | Callable[..., Any] = "none",
        published_spin: int = 0,
        contact_damping: float = 0.0,
        rail_lateral_stiffness: float | tuple[float, float] = 0.0,
        rail_vertical_stiffness: float | tuple[float, float] = 0.0,
        rail_lateral_damping: float | tuple[float, float] = 0.0,
        rail_vertical_damping: float | tuple[float, float] = 0.0,
        independent_wheels: bool = False,
        nominal_rolling: bool = False,
        wear_outputs: bool = False,
        fatigue_outputs: bool = False,
        yield_shear: float = 300000000.0,
        error_outputs: bool = False,
        stations: int = 31,
        smoothing: float | None = None,
        left_wheel: _OneProfile | None = None,
        left_rail: _OneProfile | None = None,
        left_rail_inclination: float | str | None = None,
        left_nominal_radius: float | None = None,
        left_rail_lateral_stiffness: float | None = None,
        left_rail_vertical_stiffness: float | None = None,
        left_rail_lateral_damping: float | None = None,
        left_rail_vertical_damping: float | None = None,
    ) -> None: ...
    @property
    def equal_sides(self) -> bool: ...
    @property
    def centre_height(self) -> float: ...
    @property
    def title(self) -> str: ...
    def side_parameters(self, side: Literal["left", "right"]) -> dict[str, Any]: ...
    def profile_tables(self, side: Literal["left", "right"] = "right") -> tuple[_Array, _Array, float]: ...
    def stepper(self, side: _Sides = "both", outputs: Literal["all", "patches", "geometry"] = "all") -> Stepper: ...
    def evaluate(
        self,
        lateral_shift: float = 0.0,
        yaw: float = 0.0,
        normal_force: float = 78500.0,
        load_transfer: float = 0.0,
        *,
        roll_guess: float = 0.0,
        vertical_shift_input: float = 0.0,
        roll_input: float = 0.0,
        left_rail_lateral: float = 0.0,
        left_rail_vertical: float = 0.0,
        left_rail_roll: float = 0.0,
        right_rail_lateral: float = 0.0,
        right_rail_vertical: float = 0.0,
        right_rail_roll: float = 0.0,
        speed: float = 0.0,
        lateral_velocity: float = 0.0,
        vertical_velocity: float = 0.0,
        yaw_rate: float = 0.0,
        roll_rate: float = 0.0,
        wheel_rate: float = 0.0,
        free_rolling: float = 1.0,
        track_curvature: float = 0.0,
        left_rail_lateral_velocity: float = 0.0,
        left_rail_vertical_velocity: float = 0.0,
        left_rail_roll_velocity: float = 0.0,
        right_rail_lateral_velocity: float = 0.0,
        right_rail_vertical_velocity: float = 0.0,
        right_rail_roll_velocity: float = 0.0,
        left_friction: float = 0.3,
        right_friction: float = 0.3,
        left_wheel_rate: float = 0.0,
        right_wheel_rate: float = 0.0,
        rail_time_step: float = 0.0,
        left_rail_deflection_lateral_before: float = 0.0,
        left_rail_deflection_vertical_before: float = 0.0,
        right_rail_deflection_lateral_before: float = 0.0,
        right_rail_deflection_vertical_before: float = 0.0,
        axle_torque: float = 0.0,
        left_axle_torque: float = 0.0,
        right_axle_torque: float = 0.0,
        penetration: float | tuple[float, float] | None = None,
        side: _Sides = "both",
        outputs: _Wanted = "all",
    ) -> WheelsetState: ...
    def derivatives(
        self,
        of: Iterable[str],
        by: Iterable[str],
        *,
        penetration: float | tuple[float, float] | None = None,
        **inputs: float,
    ) -> NDArray[Any]: ...
    def stand_at(self, roll: float, **inputs: float) -> Equilibrium: ...
    def linearize(
        self,
        *,
        amplitude: float = 0.0,
        yaw_amplitude: float = 0.0,
        frequency: float = 0.0,
        phases: int = 64,
        **inputs: float,
    ) -> Linearization: ...
    def rail_reaction(self, state: WheelsetState, side: Literal["left", "right"]) -> tuple[_Array, _Array]: ...
    def evaluate_many(
        self,
        lateral_shift: ArrayLike = 0.0,
        yaw: ArrayLike = 0.0,
        normal_force: ArrayLike = 78500.0,
        load_transfer: ArrayLike = 0.0,
        *,
        roll_guess: ArrayLike = 0.0,
        vertical_shift_input: ArrayLike = 0.0,
        roll_input: ArrayLike = 0.0,
        left_rail_lateral: ArrayLike = 0.0,
        left_rail_vertical: ArrayLike = 0.0,
        left_rail_roll: ArrayLike = 0.0,
        right_rail_lateral: ArrayLike = 0.0,
        right_rail_vertical: ArrayLike = 0.0,
        right_rail_roll: ArrayLike = 0.0,
        speed: ArrayLike = 0.0,
        lateral_velocity: ArrayLike = 0.0,
        vertical_velocity: ArrayLike = 0.0,
        yaw_rate: ArrayLike = 0.0,
        roll_rate: ArrayLike = 0.0,
        wheel_rate: ArrayLike = 0.0,
        free_rolling: ArrayLike = 1.0,
        track_curvature: ArrayLike = 0.0,
        left_rail_lateral_velocity: ArrayLike = 0.0,
        left_rail_vertical_velocity: ArrayLike = 0.0,
        left_rail_roll_velocity: ArrayLike = 0.0,
        right_rail_lateral_velocity: ArrayLike = 0.0,
        right_rail_vertical_velocity: ArrayLike = 0.0,
        right_rail_roll_velocity: ArrayLike = 0.0,
        left_friction: ArrayLike = 0.3,
        right_friction: ArrayLike = 0.3,
        left_wheel_rate: ArrayLike = 0.0,
        right_wheel_rate: ArrayLike = 0.0,
        rail_time_step: ArrayLike = 0.0,
        left_rail_deflection_lateral_before: ArrayLike = 0.0,
        left_rail_deflection_vertical_before: ArrayLike = 0.0,
        right_rail_deflection_lateral_before: ArrayLike = 0.0,
        right_rail_deflection_vertical_before: ArrayLike = 0.0,
        axle_torque: ArrayLike = 0.0,
        left_axle_torque: ArrayLike = 0.0,
        right_axle_torque: ArrayLike = 0.0,
        penetration: float | tuple[float, float] | None = None,
        side: _Sides = "both",
        outputs: _Wanted = "all",
        processes: int = 1,
        threads: int | None = None,
    ) -> WheelsetState[_Array, _Array, _Array]: ...
    def evaluate_parts(
        self,
        lateral_shift: ArrayLike = 0.0,
        yaw: ArrayLike = 0.0,
        normal_force: ArrayLike = 78500.0,
        load_transfer: ArrayLike = 0.0,
        *,
        roll_guess: ArrayLike = 0.0,
        vertical_shift_input: ArrayLike = 0.0,
        roll_input: ArrayLike = 0.0,
        left_rail_lateral: ArrayLike = 0.0,
        left_rail_vertical: ArrayLike = 0.0,
        left_rail_roll: ArrayLike = 0.0,
        right_rail_lateral: ArrayLike = 0.0,
        right_rail_vertical: ArrayLike = 0.0,
        right_rail_roll: ArrayLike = 0.0,
        speed: ArrayLike = 0.0,
        lateral_velocity: ArrayLike = 0.0,
        vertical_velocity: ArrayLike = 0.0,
        yaw_rate: ArrayLike = 0.0,
        roll_rate: ArrayLike = 0.0,
        wheel_rate: ArrayLike = 0.0,
        free_rolling: ArrayLike = 1.0,
        track_curvature: ArrayLike = 0.0,
        left_rail_lateral_velocity: ArrayLike = 0.0,
        left_rail_vertical_velocity: ArrayLike = 0.0,
        left_rail_roll_velocity: ArrayLike = 0.0,
        right_rail_lateral_velocity: ArrayLike = 0.0,
        right_rail_vertical_velocity: ArrayLike = 0.0,
        right_rail_roll_velocity: ArrayLike = 0.0,
        left_friction: ArrayLike = 0.3,
        right_friction: ArrayLike = 0.3,
        left_wheel_rate: ArrayLike = 0.0,
        right_wheel_rate: ArrayLike = 0.0,
        rail_time_step: ArrayLike = 0.0,
        left_rail_deflection_lateral_before: ArrayLike = 0.0,
        left_rail_deflection_vertical_before: ArrayLike = 0.0,
        right_rail_deflection_lateral_before: ArrayLike = 0.0,
        right_rail_deflection_vertical_before: ArrayLike = 0.0,
        axle_torque: ArrayLike = 0.0,
        left_axle_torque: ArrayLike = 0.0,
        right_axle_torque: ArrayLike = 0.0,
        penetration: float | tuple[float, float] | None = None,
        side: _Sides = "both",
        outputs: _Wanted = "all",
        processes: int = 1,
    ) -> Iterator[WheelsetState[_Array, _Array, _Array]]: ...
    def find_equilibrium(self, inputs: _Array) -> Equilibrium: ...
