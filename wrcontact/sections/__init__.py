"""Rails whose section changes along the track, and wheels that are not round: slices, and the surfaces through them."""

from .rail import RailSections
from .wheel import WheelSections

__all__ = ["RailSections", "WheelSections"]
