# Written by tools/make_types.py; do not edit.
"""One wheel on one rail: an independently rotating wheel, one of a tram, a flexible axle or a roller rig."""

from collections.abc import Callable, Iterable
from typing import Any, Generic, Literal, overload

from numpy.typing import ArrayLike, NDArray
from typing_extensions import TypeVar

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
from .results.views import _N
from .state import _Array, Side, WheelsetState
from .status import Status
from .stepper import Stepper
from .system import ContactSystem, _OneProfile, _Wanted

_K = TypeVar("_K", default=int)
_S = TypeVar("_S", default=Status)

class WheelState(Side[_N, _K], Generic[_N, _K, _S]):
    side: Literal["left", "right"]
    def __init__(self, state: WheelsetState[_N, _K, _S], side: str) -> None: ...
    @property
    def status(self) -> _S: ...
    @property
    def inputs(self) -> dict[str, _N]: ...
    @property
    def names(self) -> tuple[str, ...]: ...
    @overload
    def __getitem__(self, key: str) -> _N: ...
    @overload
    def __getitem__(self, key: int) -> WheelState: ...
    @overload
    def __getitem__(self, key: slice | _Array) -> WheelState[_Array, _Array, _Array]: ...

class WheelContact:
    side: Literal["left", "right"]
    system: ContactSystem
    def __init__(
        self,
        wheel: _OneProfile = "S1002",
        rail: _OneProfile = "UIC60",
        *,
        side: Literal["left", "right"] = "right",
        track: Track | None = None,
        wheelset: Wheelset | None = None,
        material: Material | None = None,
        friction: Friction | None = None,
        rail_inclination: float | str = 0.025,
        gauge: float = 1.435,
        gauge_depth: float = 0.014,
        running_circle_distance: float = 1.5,
        nominal_radius: float = 0.46,
        youngs_modulus: float = 210000000000.0,
        poisson_ratio: float = 0.28,
        flange_friction_ratio: float = 1.0,
        flange_friction_angle: float = 0.6,
        friction_fall: float = 1.0,
        friction_fall_rate: float = 0.0,
        slope_reduction: float = 1.0,
        slope_reduction_floor: float = 0.02,
        slope_reduction_rate: float = 0.0,
        contact_mode: Literal["rigid", "elastic", "compliant"] | ContactMode = "compliant",
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
        rail_lateral_stiffness: float = 0.0,
        rail_vertical_stiffness: float = 0.0,
        rail_lateral_damping: float = 0.0,
        rail_vertical_damping: float = 0.0,
        nominal_rolling: bool = False,
        wear_outputs: bool = False,
        fatigue_outputs: bool = False,
        yield_shear: float = 300000000.0,
        error_outputs: bool = False,
        stations: int = 31,
        smoothing: float | None = None,
    ) -> None: ...
    def evaluate(
        self,
        *,
        lateral_shift: float = 0.0,
        yaw: float = 0.0,
        vertical_shift_input: float = 0.0,
        roll_input: float = 0.0,
        rail_lateral: float = 0.0,
        rail_vertical: float = 0.0,
        rail_roll: float = 0.0,
        speed: float = 0.0,
        lateral_velocity: float = 0.0,
        vertical_velocity: float = 0.0,
        yaw_rate: float = 0.0,
        roll_rate: float = 0.0,
        wheel_rate: float = 0.0,
        free_rolling: float = 1.0,
        track_curvature: float = 0.0,
        rail_lateral_velocity: float = 0.0,
        rail_vertical_velocity: float = 0.0,
        rail_roll_velocity: float = 0.0,
        friction: float = 0.3,
        rail_time_step: float = 0.0,
        rail_deflection_lateral_before: float = 0.0,
        rail_deflection_vertical_before: float = 0.0,
        axle_torque: float = 0.0,
        outputs: _Wanted = "all",
    ) -> WheelState: ...
    def evaluate_many(
        self,
        *,
        outputs: _Wanted = "all",
        processes: int = 1,
        threads: int | None = None,
        **inputs: ArrayLike,
    ) -> WheelState[_Array, _Array, _Array]: ...
    def stepper(self, outputs: Literal["all", "patches", "geometry"] = "all") -> Stepper: ...
    def derivatives(self, of: Iterable[str], by: Iterable[str], **inputs: float) -> NDArray[Any]: ...
