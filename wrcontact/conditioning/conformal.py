"""Conformal contact: where wheel and rail lie close to each other over a long or a strongly bent stretch.

Of the undeformed profiles at a rigid contact, the stretch around it counts in which the wheel is nearer than NEAR to the
rail, along the contact's normal.  Where that is wide, or turns by much, three things go wrong at once: the place of the
contact hangs on micrometres of the profiles, a patch is no ellipse of the curvatures at one point, and a half-space with one
normal is no model of it.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..conventions import MIRROR, SIDES
from ..profiles.compiled import evaluate_table, places

#: [m] Wheels of 0.3 to 0.5 m approach their rails by 0.05 to 0.13 mm under 50 to 150 kN: what is nearer carries.
NEAR = 0.1e-3
#: [m] Twice what a patch is long in the rolling direction under such loads, 10 to 13 mm.
WIDE = 25e-3
#: [rad] Regions that lean apart by more have planes of their own in this package (kernel/contact/planes.py).
TURN = math.radians(15.0)
#: [m] Shifts no farther apart than this belong to one zone.
ONE = 0.21e-3
#: [m] From point to point of the outlines; between them straight lines are 0.03 um off on the sharpest flange.
STEP = 0.05e-3
#: The direction of the wheel is that of chords over so many steps, 1 mm: noise does not turn them.
CHORD = 20


@dataclass(frozen=True)
class ConformalZone:
    """Lateral shifts ``start`` to ``stop`` [m] over which one contact is conformal: its place on the wheel goes from
    ``y_low`` to ``y_high`` [m], the near stretch is up to ``width`` long [m] and turns by up to ``turn`` [rad]."""

    side: str
    start: float
    stop: float
    y_low: float
    y_high: float
    width: float
    turn: float


class Outlines:
    """Right wheel and right rail of a system, as points."""

    def __init__(self, system):
        wheel, rail, self.rail_y = system.profile_tables()
        self.radius, self.arm = system.parameters["nominal_radius"], system.parameters["running_circle_distance"] / 2
        self.y = places(wheel, STEP)
        self.z = evaluate_table(wheel, self.y)[0]
        self.angle = np.arctan2(self.z[CHORD:] - self.z[:-CHORD], self.y[CHORD:] - self.y[:-CHORD])
        self.length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(self.y), np.diff(self.z)))])
        self.y_rail = places(rail, STEP)
        self.z_rail = evaluate_table(rail, self.y_rail)[0]

    def near(self, shift, roll, contact_angle, y_wheel):
        """Length [m] and turn [rad] of the near stretch of a right wheel that touches at ``y_wheel`` [m]."""
        sine, cosine = math.sin(roll), math.cos(roll)
        across = shift + (self.arm + self.y) * cosine - (self.radius + self.z) * sine
        down = (self.arm + self.y) * sine + (self.radius + self.z) * cosine
        gap = np.interp(across - self.rail_y, self.y_rail, self.z_rail, left=np.inf, right=np.inf) - down
        contact = int(np.clip(np.searchsorted(self.y, y_wheel), 1, len(self.y) - 2))
        apart = (gap - np.min(gap[contact - 1:contact + 2])) * math.cos(contact_angle) > NEAR
        low = contact - int(np.argmax(apart[contact::-1])) if apart[:contact + 1].any() else -1
        high = contact + int(np.argmax(apart[contact:])) if apart[contact:].any() else len(self.y)
        low, high = low + 1, max(high - 1, low + 1)
        angle = self.angle[low:high - CHORD + 1]
        return self.length[high] - self.length[low], np.max(angle) - np.min(angle) if high - low >= CHORD else 0.0


def near_stretches(system, lateral_shift, table):
    """Length [m] and turn [rad] of the near stretches by side, (2, n), for the states ``table`` at these shifts (n,)."""
    outlines, found = Outlines(system), {}
    for side, sign in zip(SIDES, (MIRROR[0], 1.0)):
        wheel = getattr(table, side)
        rows = zip(sign * lateral_shift, sign * table.roll, wheel.contact_angle, wheel.contact.y_wheel)
        found[side] = np.array([outlines.near(*row) if math.isfinite(row[1]) else (math.nan, math.nan) for row in rows]).T
    return found


def conformal_zones(lateral_shift, sides):
    """The :class:`ConformalZone` of both contacts, left ones first; ``sides`` are their SideCurves by name."""
    return tuple(_zone(name, lateral_shift, side, shifts) for name, side in sides.items()
                 for shifts in _zones(lateral_shift, (side.near_width > WIDE) | (side.near_turn > TURN)))


def _zones(lateral_shift, conformal):
    """Indices of the ``conformal`` shifts (n,), zone by zone; those no farther apart than ONE are in the same."""
    found = np.flatnonzero(conformal)
    return [part for part in np.split(found, np.flatnonzero(np.diff(lateral_shift[found]) > ONE) + 1) if len(part)]


def _zone(name, lateral_shift, side, shifts):
    place = side.y_wheel[shifts]
    return ConformalZone(name, float(lateral_shift[shifts[0]]), float(lateral_shift[shifts[-1]]), float(np.min(place)),
                         float(np.max(place)), float(np.max(side.near_width[shifts])), float(np.max(side.near_turn[shifts])))
