"""What programs need that move a wheelset themselves: its motion from that of a spinning body, names of what
they read and write, the reaction on a rail, a height to start from."""

from .body import motion_jacobian, motion_of

__all__ = ["motion_jacobian", "motion_of"]
