"""Wheel-rail contact of a wheelset on its track: positions, roll, and contact patches after ANALYN."""

from .profiles import Profile, ProfileWarning
from .state import WheelsetState
from .status import Status, explain
from .stepper import Stepper
from .system import ContactSystem

__version__ = "0.1.0"
__all__ = ["ContactSystem", "Profile", "ProfileWarning", "Status", "Stepper", "WheelsetState", "check", "explain"]


def check(system):
    """What one ought to know of the pair of profiles of a ``system``: a :class:`~wrcontact.conditioning.Conditioning`.

    Where its contacts jump, how fast they move, conformal zones, quality of the profiles, equivalent conicity
    (docs/check.md); the arguments and results are those of :func:`wrcontact.conditioning.check`.
    """
    from . import conditioning  # an FMU does not carry it

    return conditioning.check(system)
