"""Wheel and rail profiles: exact definitions, placement on the track, and the kernel's tables."""

from .catalogue import RAILS, WHEELS, standard_profile
from .profile import Profile
from .remarks import ProfileWarning

__all__ = ["Profile", "ProfileWarning", "RAILS", "WHEELS", "standard_profile"]
