"""Vertical loads of which friction carries a part.

With ``load="vertical"`` a wheel's whole force, creep forces included, has the vertical component Q that is
prescribed.  The first solution leaves creep forces out; it has the component s Q.  Were all forces
proportional to the load, normal forces for the load Q / s would give Q: this is the second solution.  From
there on a secant through the last two finds the load of each wheel, with two or three more solutions.

A steep flange on which friction acts downwards jams: the more it is loaded, the less it carries, until the
patch reaches the flange root.  There the load is met with a multiple of it as normal force.  A wheel without
load carries none, so that the loads tried enclose the one that is sought as soon as one of them carries too
much: until then they are doubled, and what secants do not find, halving does.  An end that stays is tried
again now and then, since the other wheel may have moved the load past it.  Where the vertical force jumps past
Q, the loads end at the jump, and there is no answer; nor is there one where the wheel would be deeper in its
rail than DEEPEST, or after so many passes or trials.
"""

from math import fabs
from typing import Final

from ..layout import LOAD_VERTICAL, MODE_COMPLIANT, Support, Tables, Work
from .input_checks import has_creep_forces, wanted_force
from .residuals import DEEPEST

#: The load is met when no wheel misses it by more than this share [-].
LOAD_MET: Final[float] = 1e-9
#: The wheelset is solved again so often at most, and an elastic one in so many trials of both wheels: the
#: first pass takes about ten, and some hundreds where its equilibrium has to be bracketed.
LOAD_PASSES: Final[int] = 60
LOAD_TRIALS: Final[float] = 800.0
#: Secants alone find the loads in the first of these turns.
LOAD_SECANTS: Final[float] = 8.0
#: After so many turns each time, an end that has not moved is tried again.
DOUBTED: Final[float] = 4.0
#: In one turn the load changes by a factor between this and its inverse.
LARGEST_CHANGE: Final[float] = 2.0
#: A secant through two loads that differ by less than this share is not tried [-].
LEAST_CHANGE: Final[float] = 1e-12
#: Two loads that enclose the one that is sought enclose a jump when they differ by less than this share [-].
AT_JUMP: Final[float] = 1e-12


def release_friction(work: Work):
    """Friction carries nothing yet."""
    for index in range(2):
        support = work.supports[index]
        support.friction_load = 1.0
        support.load_before = 0.0
        support.share_before = 0.0
        support.low_load = 0.0
        support.high_load = 0.0
        support.turns = 0.0
        support.trials = 0.0


def carries_friction(tables: Tables, work: Work) -> bool:
    """Whether a part of the prescribed load is carried by friction."""
    carried = False
    if tables.load == LOAD_VERTICAL and tables.mode != MODE_COMPLIANT:
        carried = has_creep_forces(tables, work)
    return carried


def carried_share(work: Work, index: int):
    """The vertical force of a wheel over the load that is wanted of it; 1 for a wheel without load."""
    share = 1.0
    wanted = wanted_force(work.inputs, index)
    forces = work.sides[index].forces
    if wanted > 0.0 and forces.normal_force[2] < 0.0:
        share = -forces.force[2] / wanted
    return share


def is_load_met(work: Work) -> bool:
    """Whether neither wheel misses the vertical force that is wanted, or is deeper in its rail than
    DEEPEST."""
    met = True
    for index in range(2):
        if not fabs(carried_share(work, index) - 1.0) <= LOAD_MET:
            met = False
        if not work.sides[index].penetration <= DEEPEST:
            met = False
    return met


def is_load_lost(work: Work) -> bool:
    """Whether there is no load to be tried any more: a wheel gives too little where it is deeper in its rail
    than DEEPEST; or one jumps past its load, and the other one does so too or is at its own; or the trials
    are used up."""
    lost = work.supports[0].trials > LOAD_TRIALS
    jumping = True
    for index in range(2):
        share = carried_share(work, index)
        if fabs(share - 1.0) > LOAD_MET and not is_jump(work.supports[index], share):
            jumping = False
        if share < 1.0 and not work.sides[index].penetration <= DEEPEST:
            lost = True
    return lost or jumping


def is_jump(support: Support, share: float) -> bool:
    """Whether the load of a side has just gone from one end of those that enclose the one that is sought to
    the other, and its ``share`` of what is wanted from too little to too much."""
    return (
        is_enclosed(support)
        and share > 1.0
        and support.share_before < 1.0
        and support.friction_load == support.high_load
        and support.load_before == support.low_load
    )


def is_enclosed(support: Support) -> bool:
    """Whether the loads that enclose the one that is sought have become one."""
    return support.high_load - support.low_load < AT_JUMP * support.high_load


def is_doubtful(support: Support, share: float) -> bool:
    """Whether to try the far one of the loads that enclose the one that is sought again: the last two have given
    both too little or both too much, the last one ``share`` of what is wanted."""
    return (
        support.low_load > 0.0
        and support.turns > LOAD_SECANTS - 0.5
        and support.turns - DOUBTED * int(support.turns / DOUBTED) < 0.5
        and (share - 1.0) * (support.share_before - 1.0) > 0.0
    )


def share_load(work: Work):
    """Let the normal forces of both sides carry what friction leaves of the load, or adds to it."""
    for index in range(2):
        share = carried_share(work, index)
        support = work.supports[index]
        if fabs(share - 1.0) > LOAD_MET:
            enclose_load(support, share)
            load = next_load(support, share)
            support.load_before = support.friction_load
            support.share_before = share
            support.friction_load = load


def enclose_load(support: Support, share: float):
    """Let the load of a side, which has given ``share`` of what is wanted, be an end of those that enclose
    the one that is sought.  The other end goes where the other wheel has moved this one past it."""
    load = support.friction_load
    support.turns += 1.0
    if share < 1.0:
        support.low_load = load
        if not support.high_load > load:
            support.high_load = 0.0
            support.turns = 0.0
    else:
        support.high_load = load
        if not support.low_load < load:
            support.low_load = 0.0
            support.turns = 0.0


def next_load(support: Support, share: float):
    """The next load of a side over that of the inputs, where the last one has given ``share`` of what is
    wanted: from a secant, or in proportion, or between those that enclose the one that is sought."""
    load = support.friction_load
    change = load - support.load_before
    slope = share / load
    if support.load_before > 0.0 and fabs(change) > LEAST_CHANGE * load:
        secant = (share - support.share_before) / change
        if secant > slope / LARGEST_CHANGE and (
            secant < slope * LARGEST_CHANGE or support.turns > LOAD_SECANTS
        ):
            slope = secant
    following = load * LARGEST_CHANGE
    if slope > 0.0:
        following = max(min(load - (share - 1.0) / slope, load * LARGEST_CHANGE), load / LARGEST_CHANGE)
    if support.high_load > 0.0:
        if is_enclosed(support):
            following = support.low_load
            if load == following:
                following = support.high_load
        elif is_doubtful(support, share):
            following = support.low_load
            if share < 1.0:
                following = support.high_load
        elif (
            not (following > support.low_load and following < support.high_load)
            or support.turns > LOAD_SECANTS
            and (support.turns - 2.0 * int(0.5 * support.turns)) < 0.5
        ):
            following = 0.5 * (support.low_load + support.high_load)
    return following
