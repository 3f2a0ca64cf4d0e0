"""The true gap of wheel and rail over the plane of a rigid contact.

The plane is tangent to the rail at the rigid contact point: x along the track, s to the field side, heights t
along its normal from rail to wheel. Both surfaces are met along the normals, the wheel as the rolled and
yawed surface of revolution that it is:

    h(x, s) = t_wheel(x, s) - t_rail(s) (H8)

Everything is for a right wheel; the left one comes in mirrored (:func:`contact_plane`).
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..conventions import MIRROR
from ..kernel import layout
from ..kernel.layout import Profile
from ..profiles.compiled import evaluate_table

NEWTON_LIMIT = 15
NEWTON_STEP = 1e-8       # [m]; the step after one this small is below 1e-14 m
GUESSES = 600            # points of a profile from which Newton's method starts
#: Half the extent of the domain along and across [m]: a rail head is 72 mm wide; with 4 deg of yaw a
#: flange is 80 mm ahead.
REACH_X, REACH_S = 0.15, 0.08


@dataclass(frozen=True)
class ContactPlane:
    """The plane of one wheel's rigid contact, as a right wheel, and the surfaces that face it.

    Attributes
    ----------
    wheel, rail : compiled profile tables.
    radius, arm, rail_y : nominal radius, half the distance of the running circles, track
    coordinate of the rail [m].
    centre : of the wheelset in the track frame (3,) [m].
    attitude : R = Rz(yaw) Rx(roll), wheelset to track (3, 3).
    origin : the rigid contact point in the track frame (3,) [m].
    angle : contact angle [rad], positive towards the flange.
    around : angle around the wheel of the contact point [rad].
    """

    wheel: np.ndarray
    rail: np.ndarray
    radius: float
    arm: float
    rail_y: float
    centre: np.ndarray
    attitude: np.ndarray
    origin: np.ndarray
    angle: float
    around: float

    @property
    def lateral(self):
        """Direction of s in the track frame (3,)."""
        return np.array([0.0, math.cos(self.angle), -math.sin(self.angle)])

    @property
    def normal(self):
        """Direction of t in the track frame (3,), from the rail into the wheel."""
        return np.array([0.0, -math.sin(self.angle), -math.cos(self.angle)])

    def gap(self, x, s):
        """Distance h of the surfaces at x (n,), s (m,) [m] beyond that at the origin: (n, m) [m],
        infinite without one."""
        rail = self.rail_height(s)
        there = np.isfinite(rail)
        gap = np.full((len(x), len(s)), math.inf)
        gap[:, there] = self.wheel_height(x, s[there]) - rail[there] - self._touching
        return gap

    @cached_property
    def _touching(self):
        """Distance of the surfaces at the rigid contact point [m], zero but for the kernel's tolerance."""
        start = np.zeros(1)
        return float((self.wheel_height(start, start) - self.rail_height(start))[0, 0])

    def rail_height(self, s):
        """Height t of the rail at s (m,) [m], infinite (negative) where there is none."""
        y = _table_points(self.rail)
        z = evaluate_table(self.rail, y)[0]
        t, exists = _guess(s, *self._project(np.stack([np.full(len(y), self.origin[0]), y + self.rail_y, z],
                                                      axis=-1)))
        y_0, z_0 = self.origin[1] - self.rail_y + s * self.lateral[1], self.origin[2] + s * self.lateral[2]

        def above(t):
            height, slope, _ = evaluate_table(self.rail, _within(self.rail, y_0 + t * self.normal[1]))
            return height - z_0 - t * self.normal[2], slope * self.normal[1] - self.normal[2]

        t, met = _newton(above, t)
        return np.where(exists & met & _inside(self.rail, y_0 + t * self.normal[1]), t, -math.inf)

    def wheel_height(self, x, s):
        """Height t of the wheel at x (n,), s (m,): (n, m) [m], infinite where there is none.

        A point q in the wheelset frame lies on the wheel where its distance from the axle is the wheel's
        radius, ``hypot(q_x, q_z) = R_0 + z(q_y)``; q is linear in x, s and t.
        """
        back = self.attitude.T
        start = back @ (self.origin - self.centre)
        across, up = back @ self.lateral, back @ self.normal
        qx, qy, qz = (start[k] + back[k, 0] * x[:, None] + across[k] * s[None, :] for k in range(3))
        y = _table_points(self.wheel)
        r = self.radius + evaluate_table(self.wheel, y)[0]
        ring = np.stack([r * math.sin(self.around), self.arm + y, r * math.cos(self.around)], axis=-1)
        t, exists = _guess(s, *self._project(ring @ self.attitude.T + self.centre))
        bow = 0.5 * x**2 * math.cos(self.angle) / self.radius

        def inside(t):
            x_wheel, z_wheel = qx + t * up[0], qz + t * up[2]
            distance = np.hypot(x_wheel, z_wheel)
            height, slope, _ = evaluate_table(self.wheel, _within(self.wheel, qy + t * up[1] - self.arm))
            return (self.radius + height - distance,
                    slope * up[1] - (x_wheel * up[0] + z_wheel * up[2]) / distance)

        t, met = _newton(inside, t[None, :] + bow[:, None])
        return np.where(exists & met & _inside(self.wheel, qy + t * up[1] - self.arm), t, math.inf)

    def rail_angle(self, s):
        """Contact angle of the rail at station ``s`` [m]: [rad], positive towards the flange."""
        return -math.atan(float(evaluate_table(self.rail, self.rail_abscissa(s))[1]))

    def rail_abscissa(self, s):
        """Abscissa of the rail [m] at station ``s`` [m]."""
        t = self.rail_height(np.atleast_1d(float(s)))[0]
        return self.origin[1] - self.rail_y + s * self.lateral[1] + t * self.normal[1]

    def _project(self, points):
        """Station s and height t of points (k, 3) of the track frame."""
        away = points - self.origin
        return away @ self.lateral, away @ self.normal


def contact_plane(tables, outputs, inputs, index):
    """The contact plane of side ``index`` (0 left, 1 right) as a right wheel; the one mirror of this file.

    ``tables``, ``outputs`` and ``inputs`` as the kernel holds them after a valid step.
    """
    shift, yaw, roll = inputs[layout.IN_LATERAL_SHIFT], inputs[layout.IN_YAW], outputs[layout.OUT_ROLL]
    side = outputs[(layout.OUT_LEFT, layout.OUT_RIGHT)[index]:]
    origin = np.array([side[layout.SIDE_X_TRACK], side[layout.SIDE_Y_TRACK], side[layout.SIDE_Z_TRACK]])
    if index == 0:
        shift, yaw, roll = (sign * value for sign, value in zip(MIRROR, (shift, yaw, roll)))
        origin[1] = -origin[1]
    radius = tables[layout.SET_RADIUS]
    return ContactPlane(
        wheel=tables[int(tables[layout.SET_WHEEL]):int(tables[layout.SET_RAIL])],
        rail=tables[int(tables[layout.SET_RAIL]):int(tables[layout.SET_SCAN])],
        radius=radius, arm=tables[layout.SET_ARM], rail_y=tables[layout.SET_RAIL_Y],
        centre=np.array([0.0, shift, outputs[layout.OUT_VERTICAL_SHIFT] - radius]),
        attitude=_attitude(yaw, roll), origin=origin, angle=side[layout.SIDE_CONTACT_ANGLE],
        around=math.atan2(side[layout.SIDE_X_WHEEL], radius + side[layout.SIDE_Z_WHEEL]))


def _attitude(yaw, roll):
    """R = Rz(yaw) Rx(roll) (3, 3); wrcontact/conventions.py."""
    about_z = np.array([[math.cos(yaw), -math.sin(yaw), 0.0], [math.sin(yaw), math.cos(yaw), 0.0],
                        [0.0, 0.0, 1.0]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, math.cos(roll), -math.sin(roll)],
                        [0.0, math.sin(roll), math.cos(roll)]])
    return about_z @ about_x


# --- heights along the normals ------------------------------------------------------------------------------


def _table_points(table):
    """Abscissae over a whole profile table [m]."""
    return np.linspace(Profile.at(table).start, Profile.at(table).stop, GUESSES)


def _within(table, y):
    return np.clip(y, Profile.at(table).start, Profile.at(table).stop)


def _inside(table, y):
    return (y >= Profile.at(table).start) & (y <= Profile.at(table).stop)


def _guess(s, stations, heights):
    """Heights (m,) at ``s`` on a curve given by points, and where it exists.

    Only the run of the curve around s = 0 counts on which the station rises: beyond a fold the
    normals meet another run.
    """
    middle = int(np.argmin(np.hypot(stations, heights)))
    falls = np.flatnonzero(np.diff(stations) <= 0.0)
    first = falls[falls < middle].max(initial=-1) + 1
    last = falls[falls >= middle].min(initial=len(stations) - 1)
    run = slice(first, last + 1)
    spare = np.diff(stations[run]).max(initial=0.0)
    exists = (s >= stations[first] - spare) & (s <= stations[last] + spare)
    return np.interp(s, stations[run], heights[run]), exists


def _newton(function, t):
    """Roots t of ``function``, which returns value and derivative, and where they are met."""
    step = np.full(t.shape, math.inf)
    for _ in range(NEWTON_LIMIT):
        value, rate = function(t)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = value / rate
        step = np.clip(np.nan_to_num(step, posinf=0.0, neginf=0.0), -1e-2, 1e-2)
        t = t - step
        if np.max(np.abs(step)) < NEWTON_STEP:
            break
    return t, np.abs(step) < NEWTON_STEP
