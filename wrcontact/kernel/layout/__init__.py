"""Records of the kernel: what stands where in its arrays."""

from .offsets import *  # noqa: F403
from .record import offset
from .records import *  # noqa: F403
