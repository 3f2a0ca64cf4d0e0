"""Wheel-rail contact of a wheelset on its track: contact positions, roll, patches and creep forces."""

from importlib import import_module

from .creep import CreepForces, CreepPatch, creep_forces, elliptic_patch, outlined_patch, patch_of
from .interface.friction import Friction
from .interface.parameters import Material, Track, Wheelset
from .methods import *  # noqa: F403
from .methods import __all__ as _methods
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

#: What is imported when it is first used, and where from: an FMU does not have it.
_ELSEWHERE = {
    **dict.fromkeys(
        (
            "FlangeClimb",
            "GuidingReport",
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
    "sweep": ".sweeps.run",
    **dict.fromkeys(
        ("ArchardMap", "BritishRail", "Usfd", "Wear", "WearRun", "Zobory", "fatigue", "wear_run"), ".wear"
    ),
}
__all__ = [
    "ContactSystem",
    "CreepForces",
    "CreepPatch",
    "Friction",
    "GuidingForces",
    "Material",
    "Profile",
    "ProfileFile",
    "ProfileWarning",
    "Status",
    "Stepper",
    "Track",
    "UnusualValueWarning",
    "WheelContact",
    "WheelState",
    "Wheelset",
    "WheelsetState",
    "check",
    "check_fleet",
    "creep_forces",
    "elliptic_patch",
    "explain",
    "guiding_forces",
    "low_pass",
    "motion_jacobian",
    "motion_of",
    "outlined_patch",
    "patch_of",
    "sliding_mean",
    *_methods,
    *_ELSEWHERE,
]

#: Parts of the package that are imported when they are first used: they need matplotlib or scipy.
_LATER = frozenset({"conditioning", "export", "fleet", "halfspace", "plots", "study", "track", "wear"})


def __getattr__(name):
    if name in _LATER:
        return import_module(f".{name}", __name__)
    if name in _ELSEWHERE:
        return getattr(import_module(_ELSEWHERE[name], __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*__all__, *_LATER, "__version__", "__doc__", "__file__", "__name__", "__path__"})


def check(system):
    """Check the pair of profiles of a ``system``: a :class:`~wrcontact.conditioning.Conditioning`.

    It reports jumps of the contact, sensitivities, conformal zones, quality of the profiles and equivalent
    conicity (docs/guides/check.md); see :func:`wrcontact.conditioning.check`.
    """
    from . import conditioning  # not part of an FMU

    return conditioning.check(system)


def check_fleet(wheels, rails, output=None, **options):
    """Check every wheel on every rail, in folders or lists, and write a report: a
    :class:`~wrcontact.fleet.Fleet` (docs/guides/fleets.md); see :func:`wrcontact.fleet.check_fleet`."""
    from . import fleet  # not part of an FMU

    return fleet.check_fleet(wheels, rails, output, **options)
