"""Jumps of the contact: lateral shifts at which two places of a wheel have the same smallest gap."""

from dataclasses import dataclass

import numpy as np

from ..conventions import SIDES

FAR = 0.2e-3  # [m] a step in which the contact moves by more is examined
RESOLUTION = 1e-9  # [m] to which a jump is located
NEIGHBOURS = 0.05e-3  # [m] jumps closer to each other are reported as one
LIFTED = -20e-3  # [m] height at which a compliant wheelset touches nothing; its geometry is still computed


@dataclass(frozen=True)
class Jump:
    """A ``lateral_shift`` [m] at which the contact of one wheel jumps from one place to another.

    With rising shift, y_wheel is ``before`` and ``after`` the jump, and y_rail is ``rail_before`` and
    ``rail_after`` [m].
    """

    side: str
    lateral_shift: float
    before: float
    after: float
    rail_before: float
    rail_after: float


def find_jumps(system, lateral_shift, yaw=0.0):
    """Jumps of both contacts between neighbouring values of ``lateral_shift`` [m], rising (n,): a list, left
    ones first.

    Where a contact moves by more than FAR in one step, the step is halved until the parts move by less or the
    jump is located to RESOLUTION.
    """
    lateral_shift = np.asarray(lateral_shift, dtype=float)
    places = contact_places(system, lateral_shift, yaw)
    return [jump for side in SIDES for jump in _jumps_of(system, yaw, side, lateral_shift, places[side])]


def contact_places(system, lateral_shift, yaw=0.0):
    """y_wheel and y_rail of the contacts [m], (2, n) by side, for ``lateral_shift`` (n,); NaN without
    contact."""
    table = system.evaluate_many(lateral_shift=lateral_shift, yaw=yaw, vertical_shift_input=LIFTED,
                                 outputs="geometry")
    return {side: np.array([getattr(table, side).contact.y_wheel, getattr(table, side).contact.y_rail])
            for side in SIDES}


def _jumps_of(system, yaw, side, shift, places):
    """Jumps of one contact with known ``places`` (2, n) at ``shift`` (n,); all steps are halved together."""
    low, high, before, after = shift[:-1], shift[1:], places[:, :-1], places[:, 1:]
    while True:
        far = np.abs(after[0] - before[0]) > FAR
        low, high, before, after = low[far], high[far], before[:, far], after[:, far]
        if np.all(high - low < RESOLUTION):
            break
        middle = 0.5 * (low + high)
        between = contact_places(system, middle, yaw)[side]
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
        before, after = np.hstack([before, between]), np.hstack([between, after])
    order = np.argsort(low)
    return [Jump(side, *map(float, row)) for row in
            zip(0.5 * (low + high)[order], before[0, order], after[0, order], before[1, order],
                after[1, order])]


def merged_jumps(jumps, side):
    """The ``jumps`` of one side; jumps within NEIGHBOURS of the one before are merged, at the place of the
    largest."""
    clusters = []
    for jump in (jump for jump in jumps if jump.side == side):
        if clusters and jump.lateral_shift - clusters[-1][-1].lateral_shift < NEIGHBOURS:
            clusters[-1].append(jump)
        else:
            clusters.append([jump])
    return [Jump(side, max(cluster, key=lambda jump: abs(jump.after - jump.before)).lateral_shift,
                 cluster[0].before, cluster[-1].after, cluster[0].rail_before, cluster[-1].rail_after)
            for cluster in clusters]
