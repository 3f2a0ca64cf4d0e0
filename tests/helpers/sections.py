"""Slices of rails that change along the track, for the tests."""

from functools import cache

import numpy as np

from wrcontact import RailSections
from wrcontact.profiles import standard_profile

#: The artificial crossing nose of the test bank of CONTACT (Vtech CMCC): arcs of 5 mm between a level top 10 mm wide
#: and walls at 80 degrees, all of it rising 1:10 [mm].
NOSE_RADIUS, NOSE_TOP, NOSE_WALL, NOSE_RISE = 5.0, (5.0, 15.0), np.radians(80.0), 0.1


def nose_points(depth=20.0, spacing=0.1):
    """Points (n, 2) [m] of the nose at position 0."""
    turn, R = NOSE_WALL, NOSE_RADIUS
    arc = np.linspace(turn, 0.0, int(turn * R / spacing) + 1)
    y, z = NOSE_TOP[0] - R * np.sin(arc), R * (1.0 - np.cos(arc))
    wall = np.arange(z[0] + depth, z[0], -spacing)
    left = np.column_stack([np.r_[y[0] - (wall - z[0]) / np.tan(turn), y], np.r_[wall, z]])
    top = np.arange(NOSE_TOP[0] + spacing, NOSE_TOP[1] - 0.5 * spacing, spacing)
    middle = sum(NOSE_TOP)
    right = np.column_stack([middle - left[::-1, 0], left[::-1, 1]])
    return np.concatenate([left, np.column_stack([top, 0.0 * top]), right]) * 1e-3


def nose(positions):
    """The nose with slices at these ``positions`` [m]."""
    return _nose(tuple(map(float, positions)))


@cache
def _nose(positions):
    down = -NOSE_RISE * np.array(positions)
    return RailSections(
        positions, [nose_points()] * len(down), places=np.column_stack([0.0 * down, down]), name="nose"
    )


def moved(positions, rate=0.0, rise=0.0, rail="UIC60"):
    """A standard rail that moves to the field side by ``rate`` and rises by ``rise`` per length."""
    u = np.asarray(positions, dtype=float)
    return RailSections(
        u, [standard_profile(rail)] * len(u), places=np.column_stack([rate * u, -rise * u]), name="moved"
    )
