"""Vertical loads of which friction carries a part.

With ``load="vertical"`` a wheel's whole force, creep forces included, has the vertical component Q that is
prescribed.  The first solution leaves creep forces out; it has the component Q (1 - c).  Were all forces
proportional to the load, normal forces for the load Q / (1 - c) would give Q.  So the load is divided by what came
out over what is wanted, and the wheelset is solved again: once on the tread, where c is small, and a few times on
the flange.
"""

from math import fabs
from typing import Final

from ..layout import LOAD_VERTICAL, MODE_COMPLIANT, Tables, Work
from .creep_forces import has_creep_forces

#: The load is met when no wheel misses it by more than this share [-].
LOAD_MET: Final[float] = 1e-4
#: The wheelset is solved again so often at most; only flanges under large friction need more than three.
LOAD_PASSES: Final[int] = 6
#: Turns in which the rate of the load is found; each leaves a tenth of the one before at most.
LOAD_RATES: Final[int] = 4
#: In one turn the load changes by a factor between this and its inverse; friction that carries more than half of
#: it would jam the wheel.
LARGEST_CHANGE: Final[float] = 2.0


def release_friction(work: Work):
    """Friction carries nothing yet."""
    for index in range(2):
        work.supports[index].friction_load = 1.0
    return 0


def carries_friction(tables: Tables, work: Work):
    """1 if a part of the prescribed load is carried by friction, else 0."""
    carried = 0
    if tables.load == LOAD_VERTICAL and tables.mode != MODE_COMPLIANT:
        carried = has_creep_forces(tables, work)
    return carried


def carried_share(work: Work, index: int):
    """The vertical force of a wheel over the load that is wanted of it; 1 for a wheel without load."""
    share = 1.0
    wanted = work.inputs.normal_force * (1.0 + float(2 * index - 1) * work.inputs.load_transfer)
    if wanted > 0.0 and work.outputs.left[index].normal_part[2] < 0.0:
        share = -work.outputs.left[index].force[2] / wanted
    return share


def is_load_met(work: Work):
    """1 if both wheels have the vertical force that is wanted, else 0."""
    met = 1
    for index in range(2):
        if fabs(carried_share(work, index) - 1.0) > LOAD_MET:
            met = 0
    return met


def share_load(work: Work):
    """Let the normal forces of both sides carry what friction leaves of the load, or adds to it."""
    for index in range(2):
        share = carried_share(work, index)
        if share > LARGEST_CHANGE:
            share = LARGEST_CHANGE
        if share < 1.0 / LARGEST_CHANGE:
            share = 1.0 / LARGEST_CHANGE
        support = work.supports[index]
        support.friction_load /= share
    return 0
