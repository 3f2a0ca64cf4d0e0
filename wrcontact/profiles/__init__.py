"""Wheel and rail profiles: exact definitions, placement on the track, and the kernel's tables."""

from .catalogue import RAILS, WHEELS, standard_profile
from .profile import Profile

__all__ = ["Profile", "RAILS", "WHEELS", "standard_profile"]
