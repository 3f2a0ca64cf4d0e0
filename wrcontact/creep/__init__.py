"""Creep forces of a single contact patch, without a wheelset.

patch = wrcontact.elliptic_patch(half_length=6e-3, half_width=4e-3, normal_force=80e3)
found = wrcontact.creep_forces(patch, creepage_x=-1e-3, friction=0.3)
"""

from .forces import CreepForces, creep_forces
from .patch import CreepPatch, elliptic_patch, outlined_patch
from .results import patch_of

__all__ = ["CreepForces", "CreepPatch", "creep_forces", "elliptic_patch", "outlined_patch", "patch_of"]
