"""Wheel-rail contact of a wheelset on its track: contact positions, roll, and contact patches."""

from .profiles import Profile, ProfileWarning
from .state import WheelsetState
from .status import Status, explain
from .stepper import Stepper
from .system import ContactSystem

__version__ = "0.1.0"
__all__ = ["ContactSystem", "Profile", "ProfileWarning", "Status", "Stepper", "WheelsetState", "check", "explain"]


def check(system):
    """Check the pair of profiles of a ``system``: a :class:`~wrcontact.conditioning.Conditioning`.

    It reports jumps of the contact, sensitivities, conformal zones, quality of the profiles and equivalent conicity
    (docs/check.md); see :func:`wrcontact.conditioning.check`.
    """
    from . import conditioning  # not part of an FMU

    return conditioning.check(system)
