"""Wheel-rail contact of a wheelset on its track: contact positions, roll, patches and creep forces."""

from importlib import import_module

from .creep import CreepForces, CreepPatch, creep_forces, elliptic_patch, outlined_patch, patch_of
from .interface.friction import Friction
from .interface.parameters import Material, Track, Wheelset
from .methods import (
    Adaptive,
    Analyn,
    BasicCurvature,
    Compliant,
    CoupledStrips,
    EffectiveCurvature,
    Elastic,
    Equidistant,
    EquidistantChord,
    Fastrip,
    Fastsim,
    Halfspace,
    HalfspaceRolling,
    Hertz,
    NormalLoad,
    NormalSeparation,
    NoTangential,
    Polach,
    Rigid,
    Rough,
    Smooth,
    Strip,
    VerticalLoad,
    VerticalSeparation,
)
from .methods.numbers import UnusualValueWarning
from .profiles import Profile, ProfileFile, ProfileWarning
from .state import WheelsetState
from .status import Status, explain
from .stepper import Stepper
from .system import ContactSystem

__version__ = "0.1.0"
__all__ = ["ContactSystem", "Profile", "ProfileFile", "ProfileWarning", "Status", "Stepper",
           "UnusualValueWarning", "WheelsetState", "check", "explain", "Friction", "Material", "Track",
           "Wheelset", "Compliant", "Elastic", "Rigid", "NormalLoad", "VerticalLoad", "Analyn", "Halfspace",
           "Hertz", "Strip", "Equidistant", "EquidistantChord", "NormalSeparation", "VerticalSeparation",
           "BasicCurvature", "EffectiveCurvature", "Adaptive", "Rough", "Smooth", "CoupledStrips",
           "Fastrip", "Fastsim", "HalfspaceRolling", "NoTangential", "Polach", "CreepForces", "CreepPatch",
           "creep_forces", "elliptic_patch", "outlined_patch", "patch_of"]

#: Parts of the package that are imported when they are first used: they need matplotlib or scipy.
_LATER = frozenset({"conditioning", "plots", "reference", "study"})


def __getattr__(name):
    if name in _LATER:
        return import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *_LATER})


def check(system):
    """Check the pair of profiles of a ``system``: a :class:`~wrcontact.conditioning.Conditioning`.

    It reports jumps of the contact, sensitivities, conformal zones, quality of the profiles and equivalent
    conicity (docs/check.md); see :func:`wrcontact.conditioning.check`.
    """
    from . import conditioning  # not part of an FMU

    return conditioning.check(system)
