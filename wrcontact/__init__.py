"""Wheel-rail contact of a wheelset on its track: contact positions, roll, patches and creep forces."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal

from . import methods
from .creep import CreepForces, CreepPatch, creep_forces, elliptic_patch, outlined_patch, patch_of
from .interface.friction import Friction
from .interface.parameters import Material, Track, Wheelset
from .methods import *  # noqa: F403
from .methods.numbers import UnusualValueWarning
from .motion import motion_jacobian, motion_of
from .profiles import Profile, ProfileFile, ProfileWarning
from .results.guiding import GuidingForces, guiding_forces, low_pass, sliding_mean
from .state import WheelsetState
from .status import Status, explain
from .stepper import Stepper
from .system import ContactSystem
from .version import __version__ as __version__
from .wheel import WheelContact, WheelState

if TYPE_CHECKING:  # what is imported when it is first used
    from . import conditioning as conditioning
    from . import export as export
    from . import fleet as fleet
    from . import halfspace as halfspace
    from . import plots as plots
    from . import study as study
    from . import track as track
    from . import wear as wear
    from .creep.linear import kalker_coefficients
    from .keywords import OneProfile
    from .methods.contact import *  # noqa: F403
    from .methods.normal import *  # noqa: F403
    from .methods.tangential import *  # noqa: F403
    from .results.climbing import (
        FlangeClimb,
        GuidingReport,
        climb_distance_limit,
        climb_distances,
        flange_climb,
        guiding_report,
        nadal_limit,
        steepest_angle,
        track_shift_limit,
        weinstock_limit,
        wheel_lift,
    )
    from .sections import RailSections, WheelSections
    from .sweeps.interpolation import interpolate
    from .sweeps.run import sweep
    from .wear import ArchardMap, BritishRail, Usfd, Wear, WearRun, Zobory, fatigue, wear_run

#: What is imported when it is first used, and where from: an FMU does not have it.
_ELSEWHERE = {
    **dict.fromkeys(
        (
            "FlangeClimb",
            "GuidingReport",
            "climb_distance_limit",
            "climb_distances",
            "flange_climb",
            "guiding_report",
            "nadal_limit",
            "steepest_angle",
            "track_shift_limit",
            "weinstock_limit",
            "wheel_lift",
        ),
        ".results.climbing",
    ),
    "interpolate": ".sweeps.interpolation",
    "kalker_coefficients": ".creep.linear",
    "RailSections": ".sections",
    "WheelSections": ".sections",
    "sweep": ".sweeps.run",
    **dict.fromkeys(
        ("ArchardMap", "BritishRail", "Usfd", "Wear", "WearRun", "Zobory", "fatigue", "wear_run"), ".wear"
    ),
}
__all__ = [
    "ArchardMap",
    "BritishRail",
    "ContactSystem",
    "CreepForces",
    "CreepPatch",
    "FlangeClimb",
    "Friction",
    "GuidingForces",
    "GuidingReport",
    "Material",
    "Profile",
    "ProfileFile",
    "ProfileWarning",
    "RailSections",
    "WheelSections",
    "Status",
    "Stepper",
    "Track",
    "UnusualValueWarning",
    "Usfd",
    "Wear",
    "WearRun",
    "WheelContact",
    "WheelState",
    "Wheelset",
    "WheelsetState",
    "Zobory",
    "check",
    "check_fleet",
    "climb_distance_limit",
    "climb_distances",
    "creep_forces",
    "elliptic_patch",
    "explain",
    "fatigue",
    "flange_climb",
    "guiding_forces",
    "guiding_report",
    "interpolate",
    "kalker_coefficients",
    "low_pass",
    "motion_jacobian",
    "motion_of",
    "nadal_limit",
    "outlined_patch",
    "patch_of",
    "sliding_mean",
    "steepest_angle",
    "sweep",
    "track_shift_limit",
    "wear_run",
    "weinstock_limit",
    "wheel_lift",
]
__all__ += methods.__all__

#: Parts of the package that are imported when they are first used: they need matplotlib or scipy.
_LATER = frozenset({"conditioning", "export", "fleet", "halfspace", "plots", "study", "track", "wear"})


def __getattr__(name: str) -> Any:
    if name in _LATER:
        return import_module(f".{name}", __name__)
    if name in _ELSEWHERE:
        return getattr(import_module(_ELSEWHERE[name], __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, *_LATER, "__version__", "__doc__", "__file__", "__name__", "__path__"})


def check(system: ContactSystem) -> conditioning.Conditioning:
    """Check the pair of profiles of a ``system``: a :class:`~wrcontact.conditioning.Conditioning`.

    It reports jumps of the contact, sensitivities, conformal zones, quality of the profiles and equivalent
    conicity (docs/guides/check.md); see :func:`wrcontact.conditioning.check`.
    """
    from . import conditioning  # not part of an FMU

    return conditioning.check(system)


def check_fleet(
    wheels: OneProfile | Sequence[OneProfile],
    rails: OneProfile | Sequence[OneProfile],
    output: str | PathLike[str] | None = None,
    *,
    pictures: Literal["remarks", "all", "none"] = "remarks",
    processes: int | None = None,
    scheduler: Any = None,
    smoothing: float | None = None,
    **parameters: Any,
) -> fleet.Fleet:
    """Check every wheel on every rail, in folders or lists, and write a report: a
    :class:`~wrcontact.fleet.Fleet` (docs/guides/fleets.md); see :func:`wrcontact.fleet.check_fleet`."""
    from . import fleet  # not part of an FMU

    return fleet.check_fleet(
        wheels,
        rails,
        output,
        pictures=pictures,
        processes=processes,
        scheduler=scheduler,
        smoothing=smoothing,
        **parameters,
    )
