"""Contacts against the lateral shift: their positions, their rates, and their jumps: lateral shifts at which
two places of a wheel have the same smallest gap."""

from dataclasses import dataclass

import numpy as np

from ..conventions import SIDES
from ..results.words import ShortText

FAR = 0.2e-3  # [m] a step in which the contact moves by more is examined
RESOLUTION = 1e-9  # [m] to which a jump is located
NEIGHBOURS = 0.05e-3  # [m] jumps closer to each other are reported as one
LIFTED = -20e-3  # [m] height at which a compliant wheelset touches nothing; its geometry is still computed
#: Step of the central differences [m]: roll and positions are accurate to 1e-14, and the curvature of a
#: profile changes over 1e-4 m or more.
NUDGE = 1e-6


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


@dataclass(frozen=True, repr=False)
class SideCurves(ShortText):
    """One contact over the lateral shift, arrays (n,), NaN where there is none.

    ``y_wheel``, ``y_rail`` [m]; ``wheel_rate``, ``rail_rate``, their derivatives with respect to the lateral
    shift [1]; ``contact_angle`` [rad]; ``curvature``, relative, across the track [1/m]; ``rolling_radius``
    [m]; ``near_width`` [m] and ``near_turn`` [rad], length and change of direction of the close stretch
    (conformal.py).
    """

    y_wheel: np.ndarray
    y_rail: np.ndarray
    wheel_rate: np.ndarray
    rail_rate: np.ndarray
    contact_angle: np.ndarray
    curvature: np.ndarray
    rolling_radius: np.ndarray
    near_width: np.ndarray
    near_turn: np.ndarray


@dataclass(frozen=True, repr=False)
class Curves(ShortText):
    """Contact of a pair of profiles against the lateral shift; arrays (n,), NaN where there is no contact.

    ``lateral_shift`` [m]; ``roll`` [rad] and its derivative ``roll_rate`` [rad/m]; ``jump_distance`` to the
    nearest jump of either contact [m], infinite without one; ``radius_difference``, right minus left rolling
    radius [m], and ``level_radius_difference``, the same at zero roll; ``delta_tan_gamma``, tan of the right minus tan
    of the left contact angle [1]; ``free_curvature`` of the curve in which a free wheelset rolls without longitudinal
    creepage [1/m], positive to the right as ``track_curvature``; ``left`` and ``right``, a :class:`SideCurves` each.
    """

    lateral_shift: np.ndarray
    roll: np.ndarray
    roll_rate: np.ndarray
    jump_distance: np.ndarray
    radius_difference: np.ndarray
    level_radius_difference: np.ndarray
    delta_tan_gamma: np.ndarray
    free_curvature: np.ndarray
    left: SideCurves
    right: SideCurves


def geometry(system, lateral_shift, yaw=0.0):
    """States at ``lateral_shift`` (n,) [m] and ``yaw`` [rad], geometry only: of a rigid wheelset, or of a
    compliant one at zero roll."""
    return system.evaluate_many(
        lateral_shift=lateral_shift, yaw=yaw, vertical_shift_input=LIFTED, outputs="geometry", threads=1
    )


def free_curvature(table):
    """Curvature (n,) [1/m] of the track on which the wheels of a free wheelset in the states ``table`` both roll without
    longitudinal creepage: the ratio of their rolling radii is that of the lengths of both rails, Redtenbacher (1855), at
    the contacts' own distance from the middle of the track."""
    (left, y_left), (right, y_right) = (
        (side.rolling_radius, side.contact.y_track) for side in (table.left, table.right)
    )
    return (left - right) / (y_right * left - y_left * right)


def radius_difference(system, lateral_shift):
    """Right minus left rolling radius (n,) [m] at ``lateral_shift`` (n,) [m]."""
    table = geometry(system, lateral_shift)
    return table.right.rolling_radius - table.left.rolling_radius


def rates(system, lateral_shift):
    """Derivatives of roll (n,) [rad/m] and of (y_wheel, y_rail) by side (2, n) [1] with respect to the
    lateral shift (n,).

    Central differences over 2 NUDGE; NaN where a jump or the end of a profile lies in between.
    """
    ahead, behind = (geometry(system, lateral_shift + nudge) for nudge in (NUDGE, -NUDGE))
    roll = (ahead.roll - behind.roll) / (2 * NUDGE)
    moves = {}
    for side in SIDES:
        contacts = [getattr(table, side).contact for table in (ahead, behind)]
        move = np.array([contacts[0].y_wheel - contacts[1].y_wheel, contacts[0].y_rail - contacts[1].y_rail])
        moves[side] = np.where(np.abs(move[0]) > FAR, np.nan, move) / (2 * NUDGE)
        roll = np.where(np.isnan(moves[side][0]), np.nan, roll)
    return roll, moves


def jump_distance(jumps, lateral_shift):
    """Distance [m] of each of ``lateral_shift`` (n,) to the nearest of ``jumps``; infinite without one."""
    at = np.array([jump.lateral_shift for jump in jumps])
    return np.min(np.abs(lateral_shift[:, None] - at), axis=1, initial=np.inf)


# --- jumps -----------------------------------------------------------------------------------------


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
    table = geometry(system, lateral_shift, yaw)
    return {
        side: np.array([getattr(table, side).contact.y_wheel, getattr(table, side).contact.y_rail])
        for side in SIDES
    }


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
    return [
        Jump(side, *map(float, row))
        for row in zip(
            0.5 * (low + high)[order], before[0, order], after[0, order], before[1, order], after[1, order]
        )
    ]


def merged_jumps(jumps, side):
    """The ``jumps`` of one side; jumps within NEIGHBOURS of the one before are merged, at the place of the
    largest."""
    clusters = []
    for jump in (jump for jump in jumps if jump.side == side):
        if clusters and jump.lateral_shift - clusters[-1][-1].lateral_shift < NEIGHBOURS:
            clusters[-1].append(jump)
        else:
            clusters.append([jump])
    return [
        Jump(
            side,
            max(cluster, key=lambda jump: abs(jump.after - jump.before)).lateral_shift,
            cluster[0].before,
            cluster[-1].after,
            cluster[0].rail_before,
            cluster[-1].rail_after,
        )
        for cluster in clusters
    ]
