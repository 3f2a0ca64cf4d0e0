"""Creep forces of the patches of a wheelset whose creepages are known: for each patch its friction, then the
tangential model."""

from math import sqrt

from ..layout import DEPTH_ALL, Patch, Rolling, Tables, Work
from ..motion.creepage import STANDSTILL
from ..tangential.tangential_contact import solve_tangential
from .friction import multiply_creepages, patch_friction, slope_factor
from .requested import has_creep_forces
from .wear import write_wear


def rub_patches(left_tables: Tables, right_tables: Tables, work: Work):
    """Creep forces of all patches, if there are any."""
    if has_creep_forces(right_tables, work):
        rub_side(left_tables, work, 0, work.inputs.left_friction)
        rub_side(right_tables, work, 1, work.inputs.right_friction)


def rub_side(tables: Tables, work: Work, index: int, friction: float):
    """Creep forces of the patches of side ``index``, whose coefficient of friction is ``friction``, and shear
    and slip over its outline."""
    side = work.sides[index]
    for number in range(side.patch_count):
        patch = side.patches[number]
        if patch.speed > STANDSTILL:
            factor = open_rolling(tables, work.rolling, patch, friction)
            solve_tangential(tables, work.rolling, patch)
            close_rolling(patch, factor)
    if tables.depth == DEPTH_ALL:
        write_wear(side, tables.stations)


def open_rolling(tables: Tables, rolling: Rolling, patch: Patch, friction: float):
    """Friction of a patch, and the factor of its creepages that stands for a reduced slope."""
    rolling.published = tables.parameters.published_spin == 1.0
    sliding = patch.speed * sqrt(patch.creepage_x * patch.creepage_x + patch.creepage_y * patch.creepage_y)
    patch.friction = patch_friction(tables, friction, patch.contact_angle, sliding)
    factor = slope_factor(tables, patch)
    if factor != 1.0:
        multiply_creepages(patch, factor)
    return factor


def close_rolling(patch: Patch, factor: float):
    """The saturation of a patch whose creep force is known, and its own creepages again."""
    if factor != 1.0:
        multiply_creepages(patch, 1.0 / factor)
    limit = patch.friction * patch.totals.load
    if limit > 0.0:
        patch.saturation = sqrt(patch.creep_x * patch.creep_x + patch.creep_y * patch.creep_y) / limit
