"""Wheels over rails whose section changes along the track, by matrices of rotation and grids."""

from functools import cache

import numpy as np

from wrcontact import ContactSystem, Profile, RailSections
from wrcontact.profiles import standard_profile
from wrcontact.profiles.zones import Polynomial

RAIL, RADIUS, CROWN = standard_profile("UIC60"), 0.46, 0.75
CYLINDER = Profile("cylinder", "wheel", (Polynomial(-60.0, 60.0, (0.0,)),))
#: The wheel is compared up to this angle around it [rad], and off its ends [m].
REACH, INSIDE = 0.25, 1e-9


def moving_rail(u, across, down, name="own"):
    """UIC60 at positions ``u`` (n,), moved to the field side and down by arrays (n,) or numbers [m]."""
    places = np.column_stack(np.broadcast_arrays(across, down, u)[:2])
    return RailSections(u, [RAIL] * len(u), places=places, name=name)


@cache
def swaying(sway=5e-3, dip=5e-4):
    """A rail that moves to the field side by ``sway`` within 0.4 m, and dips by ``dip`` over 0.3 m [m]."""
    u = np.arange(-0.4, 0.7001, 0.05)
    share = np.clip(u / 0.4, 0.0, 1.0)
    low = np.where(np.abs(u - 0.1) < 0.15, 0.5 * (1.0 + np.cos(2.0 * np.pi * (u - 0.1) / 0.3)), 0.0)
    return moving_rail(u, 0.5 * sway * (1.0 - np.cos(np.pi * share)), dip * low, "swaying")


@cache
def waving(height=1e-4, length=0.2):
    """Heights of a cosine, ``height`` cos(2 pi u / length), upwards [m]."""
    u = np.arange(-0.25, 0.2501, 5e-3)
    return moving_rail(u, 0.0, -height * np.cos(2.0 * np.pi * u / length), "waving")


def on_its_own(wheel, rail, **parameters):
    """A compliant wheelset whose right rail is ``rail``, with its origin CROWN from the track's centre."""
    return ContactSystem(
        wheel=wheel,
        rail=("UIC60", rail),
        left_rail_inclination=0.0,
        contact_mode="compliant",
        **origin(parameters),
    )


def origin(parameters):
    return {"rail_origin_y": CROWN, **parameters}


def gaps(rail, wheel, pose, y, angle, deviation=None):
    """The gap [m] of a right wheel at abscissae ``y`` and angles ``angle``, arrays of one shape, over ``rail``: a function of
    track positions and track coordinates that returns heights [m].

    ``pose`` is (track position, lateral shift, yaw, roll, vertical shift); ``deviation``, a function of angles and radii [m], is
    how much larger those of a wheel are that is not round.
    """
    position, shift, yaw, roll, sunk = pose
    r = RADIUS + wheel.height(y)
    if deviation is not None:
        r = r + deviation(angle, r)
    c, s = np.cos(yaw), np.sin(yaw)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ np.array(
        [[1.0, 0.0, 0.0], [0.0, np.cos(roll), -np.sin(roll)], [0.0, np.sin(roll), np.cos(roll)]]
    )
    x, across, down = np.tensordot(turn, np.stack([r * np.sin(angle), CROWN + y, r * np.cos(angle)]), 1)
    gap = rail(position + x, across + shift) - (down - RADIUS + sunk)
    return np.where(np.isnan(gap), np.inf, gap)


def smallest_gap(rail, wheel, pose, deviation=None):
    """The smallest of them by grids of abscissa and angle, each finer than the one before: gap [m], abscissa, angle."""
    y_ends = wheel.start + INSIDE, wheel.stop - INSIDE
    (y_low, y_high), (low, high), counts = y_ends, (-REACH, REACH), (700, 201)
    for _ in range(5):
        y, angle = np.linspace(y_low, y_high, counts[0]), np.linspace(low, high, counts[1])
        gap = gaps(rail, wheel, pose, *(part.ravel() for part in np.meshgrid(y, angle)), deviation)
        k = int(np.argmin(gap))
        at_y, at_angle = y[k % len(y)], angle[k // len(y)]
        near, turn = 3.0 * (y[1] - y[0]), 3.0 * (angle[1] - angle[0])
        y_low, y_high = max(at_y - near, y_ends[0]), min(at_y + near, y_ends[1])
        low, high, counts = at_angle - turn, at_angle + turn, (61, 61)
    return gap[k], at_y, at_angle


def mirrored(pose):
    """The pose of a left wheel as that of a right one."""
    position, shift, yaw, roll, sunk = pose
    return position, -shift, -yaw, -roll, sunk


def over_plane(rail, wheel, position, sunk, place):
    """The gap [m] over the tangent plane of ``rail`` at ``place`` (x, y) [m] of a wheel without yaw and roll, a function of
    places along and across in the plane from there on, and the approach [m]."""
    x0, y0 = place
    step = 1e-6
    rises = [
        float(rail(position + x0 + step * a, y0 + step * b) - rail(position + x0 - step * a, y0 - step * b))
        / (2.0 * step)
        for a, b in ((1.0, 0.0), (0.0, 1.0))
    ]
    normal = np.array([*rises, -1.0]) / np.sqrt(1.0 + rises[0] ** 2 + rises[1] ** 2)
    forward = np.array([1.0, 0.0, 0.0]) - normal[0] * normal
    forward /= np.linalg.norm(forward)
    aside = -np.cross(normal, forward)

    def overlap(x, y):
        r = RADIUS + wheel.height(y - CROWN)
        return rail(position + x, y) - (np.sqrt(r * r - x * x) - RADIUS + sunk)

    approach = -overlap(x0, y0)

    def gap(along, across):
        along = along[:, None]
        x, y = (p + along * forward[k] + across * aside[k] for k, p in enumerate(place))
        return (overlap(x, y) + approach) * -normal[2]

    return gap, approach * -normal[2]
