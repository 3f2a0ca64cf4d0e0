"""Contacts against the lateral shift: their positions, their rates, and the distance to the next jump."""

from dataclasses import dataclass

import numpy as np

from ..conventions import SIDES
from ..results.words import ShortText
from .jumps import FAR, LIFTED

#: Step of the central differences [m]: roll and positions are accurate to 1e-14, and the curvature of a
#: profile changes over 1e-4 m or more.
NUDGE = 1e-6


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
    radius [m], and ``level_radius_difference``, the same at zero roll; ``left`` and ``right``, a
    :class:`SideCurves` each.
    """

    lateral_shift: np.ndarray
    roll: np.ndarray
    roll_rate: np.ndarray
    jump_distance: np.ndarray
    radius_difference: np.ndarray
    level_radius_difference: np.ndarray
    left: SideCurves
    right: SideCurves


def geometry(system, lateral_shift):
    """States at ``lateral_shift`` (n,) [m], geometry only: of a rigid wheelset, or of a compliant one at zero
    roll."""
    return system.evaluate_many(lateral_shift=lateral_shift, vertical_shift_input=LIFTED, outputs="geometry")


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
