"""Creep forces of a patch by the kernel's models."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import fsum, pi
from typing import Any

import numpy as np

from ..kernel import layout
from ..kernel.binding.fixed_tables import fixed_tables
from ..kernel.binding.library import default_kernel
from ..kernel.binding.own_models import OwnKernel
from ..kernel.prepare import tables as fixed
from ..methods import HalfspaceRolling, TangentialModel, family_of
from ..methods.own import STAND_INS, functions_in
from ..state import Patch
from .patch import CreepPatch, check_number
from .results import rolling_patch


@dataclass(frozen=True)
class CreepForces:
    """What friction does to the wheel in a patch."""

    x: float  #: force on the wheel forwards [N]
    y: float  #: and to the field side [N]
    moment: float  #: moment about the normal, through the centre of load [N m]
    stick_share: float  #: share of the patch's area that sticks [-]
    max_shear: float  #: largest traction [Pa]


def creep_forces(
    patch: CreepPatch | Patch[float],
    creepage_x: float = 0.0,
    creepage_y: float = 0.0,
    spin: float = 0.0,
    friction: float = 0.3,
    tangential_model: str | TangentialModel | Callable[..., Any] = "strips",
) -> CreepForces:
    """Creep force and moment of a patch in steady rolling.

    Parameters
    ----------
    patch : a :class:`CreepPatch`, or a patch of the result of one pose, ``state.right.patches[0]``.  That one
        is taken as of steel (210 GPa, 0.28) and not slanted; :func:`patch_of` takes other numbers.
    creepage_x, creepage_y : slip velocity of the wheel against the rail at the patch's centre of load over
        the rolling speed, forwards and to the field side [-].
    spin : rate of turning of the wheel against the rail about the normal, over the rolling speed [1/m];
        x forward, y to the field side and the normal are right-handed.
    friction : coefficient of friction [-].
    tangential_model : "strips" or another one of :class:`~wrcontact.ContactSystem`, or a method with its
        numbers, such as ``wrcontact.Fastsim(published_spin=1)``, or a function (docs/guides/own_model.md).

    Returns
    -------
    CreepForces
        on the wheel, opposite to its slip.

    Raises
    ------
    ValueError
        where a number is out of its range or a model is unknown, in a sentence.
    """
    if isinstance(patch, Patch):
        patch = rolling_patch(patch)
    if not isinstance(patch, CreepPatch):
        raise TypeError(
            f"patch is a {type(patch).__name__}; permitted is a patch of a result, or what "
            "elliptic_patch makes"
        )
    for name, value, unit, high in (
        ("creepage_x", creepage_x, "", 1e6),
        ("creepage_y", creepage_y, "", 1e6),
        ("spin", spin, "1/m", 1e9),
    ):
        check_number(name, value, unit, -high, high)
    check_number("friction", friction, "", 0.0, 10.0)
    model = tangential_model
    functions = functions_in({"tangential_model": model})
    if not isinstance(model, TangentialModel):
        name = STAND_INS["tangential_model"] if functions else tangential_model
        model = family_of("tangential_model").method(name)
    tables = model_tables(model.kernel_number, patch.youngs_modulus, patch.poisson_ratio)
    workspace = np.zeros(layout.WORK_SIZE)
    work = layout.Work.at(workspace)
    found = work.patch
    found.creepage_x, found.creepage_y, found.spin, found.friction = creepage_x, creepage_y, spin, friction
    work.rolling.published = getattr(model, "published_spin", 0) == 1
    roll(patch, tables, workspace, OwnKernel(functions) if functions else None)
    if model.name == HalfspaceRolling.name:
        roll_on_halfspace(patch, found)
    return CreepForces(found.creep_x, found.creep_y, found.creep_moment, found.stick_share, found.max_shear)


def roll_on_halfspace(patch, found):
    """The creep force of a patch that has been cut into strips, by the complete theory."""
    from ..halfspace.rolling_step import roll_strips  # needs scipy

    shear_modulus = patch.youngs_modulus / (2.0 * (1.0 + patch.poisson_ratio))
    roll_strips(found, shear_modulus=shear_modulus, poisson_ratio=patch.poisson_ratio)


def roll(patch, tables, workspace, kernel=None):
    """Cut a patch into the strips of the workspace (n,) and find its creep force there, with the creepages
    and the friction that stand there, by this process's ``kernel`` where None is given."""
    work = layout.Work.at(workspace)
    write_patch(patch, work.patch, work.contact.strips)
    kernel = kernel or default_kernel()
    kernel.divide_into_strips(workspace)
    kernel.solve_creep_force(tables, workspace)


def write_patch(patch, written, strips):
    """Write a patch as a record of the kernel, which lies on ``strips``."""
    written.rule = layout.RULE_ELLIPSE if patch.ellipse else layout.RULE_STRAIGHT
    written.slant = patch.slant
    totals = written.totals
    totals.start, totals.stop = patch.station[[0, -1]]
    totals.width = totals.stop - totals.start
    totals.load = patch.normal_force
    totals.max_half_length = patch.half_length.max()
    totals.centroid = 0.0
    if patch.ellipse:
        totals.area = pi * totals.max_half_length * totals.stop
        return
    low, high = patch.half_length[:-1], patch.half_length[1:]
    width, middle = np.diff(patch.station), 0.5 * (patch.station[1:] + patch.station[:-1])
    # the squares of the half-lengths follow straight lines
    both = np.maximum(low + high, 1e-300)
    totals.area = 2.0 * fsum(width * 2.0 / 3.0 * (low**2 + low * high + high**2) / both)
    before, after = patch.line_load[:-1], patch.line_load[1:]
    moment = fsum(width * (0.5 * (before + after) * middle + (after - before) * width / 12.0))
    totals.centroid = moment / fsum(width * 0.5 * (before + after))
    inner = slice(1, -1)
    written.first, written.last = 0, len(patch.station) - 3
    for strip, station, length, load in zip(
        strips,
        patch.station[inner].tolist(),
        patch.half_length[inner].tolist(),
        patch.line_load[inner].tolist(),
    ):
        strip.station, strip.width = station, 1.0
        strip.half_length_square, strip.line_load = length * length, load


@lru_cache(maxsize=32)
def model_tables(number, youngs_modulus, poisson_ratio):
    """The kernel's tables (n,) for a model of creep forces alone."""
    array = np.zeros(layout.SETTING_COUNT + layout.ROLLING_TABLE_SIZE)
    tables = layout.Tables.at(array)
    tables.tangential = number
    tables.shear_modulus = youngs_modulus / (2.0 * (1.0 + poisson_ratio))
    tables.parameters.poisson_ratio = poisson_ratio
    tables.rolling = layout.SETTING_COUNT
    fixed.append_rolling(tables, layout.SETTING_COUNT, memoryview(fixed_tables()), poisson_ratio)
    return array
