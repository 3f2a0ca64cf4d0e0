# Written by tools/make_types.py; do not edit.
"""Wheel-rail contact of a wheelset on its track: contact positions, roll, patches and creep forces."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, Literal

from . import conditioning as conditioning
from . import export as export
from . import fleet as fleet
from . import halfspace as halfspace
from . import plots as plots
from . import study as study
from . import track as track
from . import wear as wear
from .conditioning import Conditioning
from .fleet import Fleet
from .system import ContactSystem as ContactSystem
from .creep.forces import CreepForces as CreepForces
from .creep.patch import CreepPatch as CreepPatch
from .interface.friction import Friction as Friction
from .results.guiding import GuidingForces as GuidingForces
from .interface.parameters import Material as Material
from .profiles.profile import Profile as Profile
from .profiles.options import ProfileFile as ProfileFile
from .profiles.remarks import ProfileWarning as ProfileWarning
from .status import Status as Status
from .stepper import Stepper as Stepper
from .interface.parameters import Track as Track
from .methods.numbers import UnusualValueWarning as UnusualValueWarning
from .wheel import WheelContact as WheelContact
from .wheel import WheelState as WheelState
from .interface.parameters import Wheelset as Wheelset
from .state import WheelsetState as WheelsetState
from .creep.forces import creep_forces as creep_forces
from .creep.patch import elliptic_patch as elliptic_patch
from .status import explain as explain
from .results.guiding import guiding_forces as guiding_forces
from .results.guiding import low_pass as low_pass
from .motion.body import motion_jacobian as motion_jacobian
from .motion.body import motion_of as motion_of
from .creep.patch import outlined_patch as outlined_patch
from .creep.results import patch_of as patch_of
from .results.guiding import sliding_mean as sliding_mean
from .methods.contact import Rigid as Rigid
from .methods.contact import Elastic as Elastic
from .methods.contact import Compliant as Compliant
from .methods.contact import NormalLoad as NormalLoad
from .methods.contact import VerticalLoad as VerticalLoad
from .methods.normal import Analyn as Analyn
from .methods.normal import Strip as Strip
from .methods.normal import Auto as Auto
from .methods.normal import Hertz as Hertz
from .methods.normal import Halfspace as Halfspace
from .methods.contact import NormalSeparation as NormalSeparation
from .methods.contact import VerticalSeparation as VerticalSeparation
from .methods.contact import Equidistant as Equidistant
from .methods.contact import EquidistantChord as EquidistantChord
from .methods.contact import EffectiveCurvature as EffectiveCurvature
from .methods.contact import BasicCurvature as BasicCurvature
from .methods.contact import Adaptive as Adaptive
from .methods.contact import Smooth as Smooth
from .methods.contact import Rough as Rough
from .methods.tangential import NoTangential as NoTangential
from .methods.tangential import CoupledStrips as CoupledStrips
from .methods.tangential import Fastsim as Fastsim
from .methods.tangential import Fastrip as Fastrip
from .methods.tangential import Polach as Polach
from .methods.tangential import HalfspaceRolling as HalfspaceRolling
from .results.climbing import FlangeClimb as FlangeClimb
from .results.climbing import GuidingReport as GuidingReport
from .results.climbing import climb_distances as climb_distances
from .results.climbing import flange_climb as flange_climb
from .results.climbing import guiding_report as guiding_report
from .results.climbing import nadal_limit as nadal_limit
from .results.climbing import steepest_angle as steepest_angle
from .results.climbing import track_shift_limit as track_shift_limit
from .results.climbing import weinstock_limit as weinstock_limit
from .results.climbing import wheel_lift as wheel_lift
from .sweeps.interpolation import interpolate as interpolate
from .creep.linear import kalker_coefficients as kalker_coefficients
from .sections.rail import RailSections as RailSections
from .sweeps.run import sweep as sweep
from .wear.laws import ArchardMap as ArchardMap
from .wear.laws import BritishRail as BritishRail
from .wear.laws import Usfd as Usfd
from .wear.accumulate import Wear as Wear
from .wear.steps import WearRun as WearRun
from .wear.laws import Zobory as Zobory
from .wear.fatigue import fatigue as fatigue
from .wear.run import wear_run as wear_run

__version__: str

def check(system: ContactSystem) -> Conditioning: ...

_Profiles = str | PathLike[str] | Profile | ProfileFile

def check_fleet(wheels: _Profiles | Sequence[_Profiles], rails: _Profiles | Sequence[_Profiles],
                output: str | PathLike[str] | None = None, *, pictures: Literal["remarks", "all", "none"] = "remarks",
                processes: int | None = None, scheduler: Any = None, smoothing: float | None = None,
                **parameters: Any) -> Fleet: ...
