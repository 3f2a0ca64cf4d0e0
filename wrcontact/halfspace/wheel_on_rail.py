"""One wheel above its rail: both surfaces, and where lines along a normal meet them.

Everything is for a right wheel in the track frame; the left one comes in mirrored
(:func:`wheels_on_rails`).  A normal with the angle a is (0, -sin a, -cos a): it points from the rail
into the wheel, and a is positive towards the flange, like a contact angle.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..conventions import MIRROR
from ..kernel import layout
from ..kernel.binding.setup import profile_tables
from ..profiles.compiled import ends, evaluate_table, places

NEWTON_LIMIT = 15
NEWTON_STEP = 1e-8  # [m]; the step after one this small is below 1e-14 m
OUTLINE_STEP = 4e-5  # [m] of the wheel's abscissa between two points of its outline


@dataclass(frozen=True)
class Outline:
    """The wheel seen along the track, as points (k,): where its normals have no component along the track.

    Attributes
    ----------
    x, y, z : in the track frame [m].
    angle : of the normals [rad].
    """

    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    angle: np.ndarray


@dataclass(frozen=True)
class WheelOnRail:
    """A placed wheel and its rail.

    Attributes
    ----------
    wheel, rail : compiled profile tables.
    radius, height, arm, rail_y : nominal radius, height of the wheelset's centre above the running circles,
        half the distance of the running circles, track coordinate of the rail [m].
    centre : of the wheelset in the track frame (3,) [m].
    attitude : R = Rz(yaw) Rx(roll), wheelset to track (3, 3).
    """

    wheel: np.ndarray
    rail: np.ndarray
    radius: float
    height: float
    arm: float
    rail_y: float
    centre: np.ndarray
    attitude: np.ndarray

    def lowered(self, approach):
        """The same with the wheel moved down by ``approach`` [m]."""
        return replace(self, centre=self.centre + [0.0, 0.0, approach])

    @cached_property
    def outline(self):
        """The :class:`Outline` over the whole wheel profile.

        A point with the angle phi around the wheel has the outward normal (sin phi, -r', cos phi) in the
        wheelset frame; with R_00 sin phi + R_02 cos phi = R_01 r' it has no component along the track.
        (2.1)
        """
        y = places(self.wheel, OUTLINE_STEP)
        z, slope, _ = evaluate_table(self.wheel, y)
        along = self.attitude[0]
        size = math.hypot(along[0], along[2])
        phi = np.arcsin(np.clip(along[1] * slope / size, -1.0, 1.0)) - math.atan2(along[2], along[0])
        r = self.radius + z
        points = np.stack([r * np.sin(phi), self.arm + y, r * np.cos(phi)], axis=-1) @ self.attitude.T
        normals = np.stack([np.sin(phi), -slope, np.cos(phi)], axis=-1) @ self.attitude.T
        x, y, z = (points + self.centre).T
        return Outline(x, y, z, np.arctan2(normals[:, 1], normals[:, 2]))

    def rail_points(self, step):
        """Points of the rail's profile, ``step`` [m] of its length apart: y, z (k,) in the track frame and
        the angles of the normals."""
        y = places(self.rail, step)
        z = evaluate_table(self.rail, y)[0]
        length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
        y = np.interp(np.linspace(0.0, length[-1], int(length[-1] / step) + 2), length, y)
        z, slope, _ = evaluate_table(self.rail, y)
        return y + self.rail_y, z, -np.arctan(slope)

    def rail_along(self, y, z, angle, guess):
        """Distance t (m,) [m] from the points (y, z) (m,) to the rail along normals; -inf without one."""
        across, up = -np.sin(angle), -np.cos(angle)

        def above(t):
            height, slope, _ = evaluate_table(self.rail, _within(self.rail, y + t * across - self.rail_y))
            return height - z - t * up, slope * across - up

        t, met = _newton(above, np.array(guess))
        return np.where(met & _inside(self.rail, y + t * across - self.rail_y), t, -math.inf)

    def wheel_along(self, x, y, z, angle, guess):
        """Distance t (n, m) [m] from the points (x, y, z), x (n, m), y and z (m,), to the wheel along
        normals; inf without one.

        A point q in the wheelset frame lies on the wheel where its distance from the axle is the wheel's
        radius, ``hypot(q_x, q_z) = R_0 + z(q_y)``; q is linear in t.
        """
        back = self.attitude.T
        qx, qy, qz = (
            back[k, 0] * (x - self.centre[0])
            + (back[k, 1] * (y - self.centre[1]) + back[k, 2] * (z - self.centre[2]))
            for k in range(3)
        )
        up = [-back[k, 1] * np.sin(angle) - back[k, 2] * np.cos(angle) for k in range(3)]

        def inside(t):
            x_wheel, z_wheel = qx + t * up[0], qz + t * up[2]
            distance = np.hypot(x_wheel, z_wheel)
            height, slope, _ = evaluate_table(self.wheel, _within(self.wheel, qy + t * up[1] - self.arm))
            return (
                self.radius + height - distance,
                slope * up[1] - (x_wheel * up[0] + z_wheel * up[2]) / distance,
            )

        t, met = _newton(inside, np.array(guess))
        return np.where(met & _inside(self.wheel, qy + t * up[1] - self.arm), t, math.inf)

    def distance(self, x, y, z, angle):
        """How far the surfaces are apart along the normal through a point near both [m]."""
        y, z, angle, start = (np.array([value]) for value in (y, z, angle, 0.0))
        wheel = self.wheel_along(np.array([[x]]), y, z, angle, start[None])
        return float(wheel[0, 0] - self.rail_along(y, z, angle, start)[0])

    def abscissa(self, place):
        """Abscissa of the wheel's profile [m] beside a place (3,) of the track frame."""
        return float(self.attitude[:, 1] @ (place - self.centre) - self.arm)

    def rolling_radius(self, place):
        """Radius of the wheel [m] beside a place (3,) of the track frame."""
        y = self.abscissa(place)
        return self.radius + float(evaluate_table(self.wheel, _within(self.wheel, y))[0])


def wheel_on_rail(tables, index, *, lateral_shift, yaw, roll, vertical_shift, rail=(0.0, 0.0)):
    """The wheel of side ``index`` (0 left, 1 right) as a right wheel; the one mirror of the half-space.

    ``tables`` are those of the kernel; lengths in m, angles in rad.  A ``rail`` that is
    displaced (to the right, down) counts as a wheelset that is displaced the other way.
    """
    lateral_shift -= rail[0]
    if index == 0:
        lateral_shift, yaw, roll = (sign * value for sign, value in zip(MIRROR, (lateral_shift, yaw, roll)))
    head = layout.Tables.at(tables)
    height = head.height + rail[1]
    wheel, table, rail_y = profile_tables(tables, index)
    return WheelOnRail(
        wheel=wheel,
        rail=table,
        radius=head.pairs[index].radius,
        height=height,
        arm=head.arm,
        rail_y=rail_y,
        centre=np.array([0.0, lateral_shift, vertical_shift - height]),
        attitude=_attitude(yaw, roll),
    )


def _attitude(yaw, roll):
    """R = Rz(yaw) Rx(roll) (3, 3); wrcontact/conventions.py."""
    about_z = np.array(
        [[math.cos(yaw), -math.sin(yaw), 0.0], [math.sin(yaw), math.cos(yaw), 0.0], [0.0, 0.0, 1.0]]
    )
    about_x = np.array(
        [[1.0, 0.0, 0.0], [0.0, math.cos(roll), -math.sin(roll)], [0.0, math.sin(roll), math.cos(roll)]]
    )
    return about_z @ about_x


def _within(table, y):
    return np.clip(y, *ends(table))


def _inside(table, y):
    start, stop = ends(table)
    return (y >= start) & (y <= stop)


def _newton(function, t):
    """Roots t of ``function``, which returns value and derivative, and where they are met."""
    step = np.full(t.shape, math.inf)
    for _ in range(NEWTON_LIMIT):
        value, rate = function(t)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = value / rate
        step = np.clip(np.nan_to_num(step, posinf=0.0, neginf=0.0), -1e-2, 1e-2)
        t = t - step
        if np.max(np.abs(step), initial=0.0) < NEWTON_STEP:
            break
    return t, np.abs(step) < NEWTON_STEP
