"""Conformal contact: where wheel and rail are close to each other over a long or strongly curved stretch.

The *close stretch* is the part of the undeformed wheel around a rigid contact that is less than NEAR from the
rail, measured along the contact's normal.  If it is long or its direction changes much, three difficulties
arise: the contact position depends on micrometres of the profiles, the patch is not the ellipse of the
curvatures at one point, and a model with a single normal is not good.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..conventions import MIRROR, SIDES
from ..profiles.compiled import evaluate_table, places

#: [m] The approach of wheels of 0.3 to 0.5 m radius under 50 to 150 kN is 0.05 to 0.13 mm: closer points
#: carry load.
NEAR = 0.1e-3
#: [m] Twice the length of a patch in the rolling direction under such loads, which is 10 to 13 mm.
WIDE = 25e-3
#: [rad] Patches whose normals differ by more have planes of their own in wrcontact
#: (kernel/contact/frame.py).
TURN = math.radians(15.0)
#: [m] Conformal shifts that are no farther apart than this belong to one zone.
ONE = 0.21e-3
#: [m] Spacing of the outline's points; the error of straight lines between them is 0.03 um on the sharpest
#: flange.
STEP = 0.05e-3
#: Number of steps in a chord, 1 mm, that gives the wheel's direction; noise changes it little.
CHORD = 20
#: Points to each side of a contact, 10 mm, among which the ends of a close stretch are sought first.
REACH = 200


@dataclass(frozen=True)
class ConformalZone:
    """A range of lateral shifts, ``start`` to ``stop`` [m], over which the contact of one side is conformal.

    The contact on the wheel lies between ``y_low`` and ``y_high`` [m]; the close stretch is up to ``width``
    long [m], and its direction changes by up to ``turn`` [rad].
    """

    side: str
    start: float
    stop: float
    y_low: float
    y_high: float
    width: float
    turn: float


class Outlines:
    """Wheel and rail of one side of a system as those of a right side, as points."""

    def __init__(self, system, side="right"):
        wheel, rail, self.rail_y = system.profile_tables(side)
        chosen = system.side_parameters(side)
        self.radius, self.arm = chosen["nominal_radius"], chosen["running_circle_distance"] / 2
        self.y = places(wheel, STEP)
        self.z = evaluate_table(wheel, self.y)[0]
        self.angle = np.arctan2(self.z[CHORD:] - self.z[:-CHORD], self.y[CHORD:] - self.y[:-CHORD])
        self.length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(self.y), np.diff(self.z)))])
        self.y_rail = places(rail, STEP)
        self.z_rail = evaluate_table(rail, self.y_rail)[0]

    def near(self, shift, roll, contact_angle, y_wheel):
        """Length [m] and change of direction [rad] (2, n) of the close stretches of a right wheel in contact
        at ``y_wheel`` (n,) [m]."""
        pose = np.array(
            [
                shift,
                *(
                    list(map(function, angles))
                    for function, angles in ((math.sin, roll), (math.cos, roll), (math.cos, contact_angle))
                ),
            ]
        )
        contact = np.clip(np.searchsorted(self.y, y_wheel), 1, len(self.y) - 2)
        low, high = self._ends(contact, pose)
        turn = [
            np.ptp(self.angle[first : last - CHORD + 1]) if last - first >= CHORD else 0.0
            for first, last in zip(low, high)
        ]
        return np.array([self.length[high] - self.length[low], turn])

    def _ends(self, contact, pose):
        """First and last index (2, n) of the stretches around ``contact`` (n,), in a window that is doubled
        until it holds them."""
        ends, left, reach = np.empty((2, len(contact)), dtype=int), np.arange(len(contact)), REACH
        while len(left):
            middle = contact[left]
            apart = self._apart(middle, reach, pose[:, left])
            before, after = apart[:, reach::-1], apart[:, reach:]
            down, up = np.argmax(before, axis=1), np.argmax(after, axis=1)
            closed = before.any(axis=1), after.any(axis=1)
            low = np.where(closed[0], middle - down + 1, 0)
            ends[:, left] = low, np.maximum(np.where(closed[1], middle + up, len(self.y)) - 1, low)
            ended = middle <= reach, middle + reach >= len(self.y) - 1
            left = left[~((closed[0] | ended[0]) & (closed[1] | ended[1]))]
            reach *= 2
        return ends

    def _apart(self, contact, reach, pose):
        """Which points are no longer close to the rail (n, 2 reach + 1), around each ``contact`` (n,)."""
        at = np.clip(contact[:, None] + np.arange(-reach, reach + 1), 0, len(self.y) - 1)
        shift, sine, cosine, lean = pose[:, :, None]
        y, z = self.arm + self.y[at], self.radius + self.z[at]
        across = shift + y * cosine - z * sine
        gap = np.interp(across - self.rail_y, self.y_rail, self.z_rail, left=np.inf, right=np.inf)
        gap -= y * sine + z * cosine
        least = np.min(gap[:, reach - 1 : reach + 2], axis=1, keepdims=True)
        return (gap - least) * lean > NEAR


def near_stretches(system, lateral_shift, table):
    """Length [m] and change of direction [rad] of the close stretches (2, n) by side, for the states
    ``table`` at these shifts (n,)."""
    found = {}
    for side, sign in zip(SIDES, (MIRROR[0], 1.0)):
        outlines, wheel = Outlines(system, side), getattr(table, side)
        rows = (sign * lateral_shift, sign * table.roll, wheel.contact_angle, wheel.contact.y_wheel)
        touching = np.isfinite(table.roll)
        found[side] = np.full((2, len(lateral_shift)), math.nan)
        found[side][:, touching] = outlines.near(*(row[touching] for row in rows))
    return found


def conformal_zones(lateral_shift, sides):
    """Every :class:`ConformalZone`, left ones first; ``sides`` has the SideCurves by name."""
    return tuple(
        _zone(name, lateral_shift, side, shifts)
        for name, side in sides.items()
        for shifts in _zones(lateral_shift, (side.near_width > WIDE) | (side.near_turn > TURN))
    )


def _zones(lateral_shift, conformal):
    """Indices of the ``conformal`` shifts (n,), one array per zone; shifts no farther apart than ONE are in
    one zone."""
    found = np.flatnonzero(conformal)
    return [
        part for part in np.split(found, np.flatnonzero(np.diff(lateral_shift[found]) > ONE) + 1) if len(part)
    ]


def _zone(name, lateral_shift, side, shifts):
    place = side.y_wheel[shifts]
    return ConformalZone(
        name,
        float(lateral_shift[shifts[0]]),
        float(lateral_shift[shifts[-1]]),
        float(np.min(place)),
        float(np.max(place)),
        float(np.max(side.near_width[shifts])),
        float(np.max(side.near_turn[shifts])),
    )
