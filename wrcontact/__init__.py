"""Wheel-rail contact of a wheelset on its track: positions, roll, and contact patches after ANALYN."""

from .profiles import Profile, ProfileWarning
from .state import WheelsetState
from .status import Status, explain
from .system import ContactSystem, Stepper

__version__ = "0.1.0"
__all__ = ["ContactSystem", "Profile", "ProfileWarning", "Status", "Stepper", "WheelsetState", "explain"]
