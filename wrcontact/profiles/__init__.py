"""Wheel and rail profiles: exact definitions, placement on the track, and the kernel's tables."""

from .catalogue import RAILS, WHEELS, standard_profile
from .options import ProfileFile
from .profile import Profile
from .remarks import ProfileWarning

__all__ = ["Profile", "ProfileFile", "ProfileWarning", "RAILS", "WHEELS", "standard_profile"]
