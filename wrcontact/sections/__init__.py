"""Rails whose section changes along the track: slices, and the surface through them."""

from .rail import RailSections

__all__ = ["RailSections"]
