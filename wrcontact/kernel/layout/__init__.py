"""Records of the kernel: what stands where in its arrays."""

from .records import *  # noqa: F403
