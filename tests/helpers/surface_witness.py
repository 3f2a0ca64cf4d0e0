"""Wheel and rail surfaces of many poses at once, by numpy from the printed profiles: a witness for
tests, slow in no place.

It knows nothing of where a contact can lie. A wheel is cut into circles STATION apart. On each of them the
gap to the rail is convex, since a disc and a rail's head are, so Newton's method finds its smallest value;
the least along the profile are then refined. Frames and profiles are those of data/brute_force.py,
and no code is the product's.
"""

from math import atan

import numpy as np
import pytest

from data import brute_force

STATION = 0.5e-3  # [m]
TABLE = 2e-6  # [m] of the rail's table of heights
# [m] a minimum hides less below its stations: STATION^2 / 8 times 2000 1/m, at the flange root
NEAR = 7e-5
WHOLE_START, WHOLE_STOP = -69.6e-3, 60e-3  # [m]
EDGE = 5e-3  # [m] within which circles of a wheel that is cut off can be lower than its contact
CHUNK = 64  # poses at a time
STEEPEST = np.tan(np.radians(80.0))  # the product reads profiles up to here
#: S1002's printed coefficients leave steps of 1.2e-7 m, 4e-8 m and, on the flange's tip, 6e-11 m there,
#: of which the product leads the first two over within half a millimetre.
JOINTS, JOINT_REACH, JOINT_STEP = (-35e-3, -26e-3, -49.662510381e-3), 0.501e-3, 1.3e-7


class Surfaces:
    """The pair of one scene: arguments as of ContactSystem; the wheel and the rail between
    given ends [m], if any."""

    def __init__(
        self,
        rail="UIC60",
        rail_inclination=1 / 40,
        gauge=1.435,
        gauge_depth=0.014,
        nominal_radius=0.46,
        wheel_start=WHOLE_START,
        wheel_stop=WHOLE_STOP,
        rail_stop=np.inf,
    ):
        track = brute_force.track(rail, rail_inclination, gauge, gauge_depth)
        self.wheel, self.rail = track.wheel, track.rail
        self.origin, self.radius, self.arm = track.rail_origin, nominal_radius, 0.75
        self.y = np.append(np.arange(wheel_start, wheel_stop, STATION), wheel_stop)
        self.z, self.slope, _ = self.wheel(self.y)
        self.edges = [
            end for end, whole in ((wheel_start, WHOLE_START), (wheel_stop, WHOLE_STOP)) if end != whole
        ]
        x = np.arange(-45e-3, 45e-3, TABLE)
        height, slope, _ = self.rail(x)
        kept = (np.abs(slope) < STEEPEST) & (x <= rail_stop)
        self.x, self.height, self.rail_slope = x[kept], height[kept], slope[kept]

    def is_edge(self, y):
        """Whether places ``y`` [m] are at the edge of a wheel that is cut off, within EDGE.

        The product looks for contacts where surfaces are parallel; the edge of a
        yawed wheel can be lower elsewhere.
        """
        return (
            np.any([np.abs(y - edge) < EDGE for edge in self.edges], axis=0)
            if self.edges
            else np.zeros(y.shape, bool)
        )

    def place(self, shift, yaw, roll, phi, y, z):
        """Lateral and vertical track coordinate of wheel points, and their derivatives by phi;
        without vertical shift."""
        r = self.radius + z
        s, c = r * np.sin(phi), r * np.cos(phi)
        sin_yaw, cos_yaw, sin_roll, cos_roll = np.sin(yaw), np.cos(yaw), np.sin(roll), np.cos(roll)
        across = shift + sin_yaw * s + cos_yaw * ((self.arm + y) * cos_roll - c * sin_roll)
        down = (self.arm + y) * sin_roll + c * cos_roll - self.radius
        return across, down, sin_yaw * c + cos_yaw * s * sin_roll, -s * cos_roll, r

    def table_gap(self, shift, yaw, roll, phi, y, z):
        """Gap from the rail's table, and its first and about its second derivative by
        phi; NaN beside the rail."""
        across, down, across_rate, down_rate, r = self.place(shift, yaw, roll, phi, y, z)
        u = (across - self.origin - self.x[0]) / TABLE
        k = np.clip(u.astype(np.int64), 0, len(self.x) - 2)
        share = u - k
        height = self.height[k] + share * (self.height[k + 1] - self.height[k])
        slope = self.rail_slope[k] + share * (self.rail_slope[k + 1] - self.rail_slope[k])
        bend = (self.rail_slope[k + 1] - self.rail_slope[k]) / TABLE
        beside = (u < 0) | (u > len(self.x) - 1)
        curved = (
            bend * across_rate**2 - slope * np.sin(yaw) * r * np.sin(phi) + r * np.cos(phi) * np.cos(roll)
        )
        return np.where(beside, np.nan, height - down), slope * across_rate - down_rate, curved

    def smallest_gaps(self, shift, yaw, roll):
        """Refined local minima of the gap of right wheels within NEAR of the smallest: row of the pose, gap
        [m] and place on the wheel [m], each (m,); and the smallest gap over all stations (n,)."""
        rows, gaps, places, least = [], [], [], []
        for first in range(0, len(shift), CHUNK):
            pose = [column[first : first + CHUNK, None] for column in (shift, yaw, roll)]
            phi = -np.tan(pose[1]) * (self.slope * np.cos(pose[2]) + np.sin(pose[2]))
            _, rate, curved = self.table_gap(*pose, phi, self.y, self.z)
            phi = phi - np.clip(np.nan_to_num(rate / np.maximum(curved, 0.1)), -0.05, 0.05)
            gap = self.table_gap(*pose, phi, self.y, self.z)[0]
            gap = np.where(np.isnan(gap), np.inf, gap)
            lowest = np.where(self.is_edge(self.y), np.inf, gap).min(axis=1)
            row, k = np.nonzero(
                (gap < lowest[:, None] + NEAR)
                & (gap <= np.roll(gap, 1, axis=1))
                & (gap <= np.roll(gap, -1, axis=1))
            )
            low, high = self.y[np.maximum(k - 1, 0)], self.y[np.minimum(k + 1, len(self.y) - 1)]
            refined = self.refine(*(column[row, 0] for column in pose), low, high, phi[row, k])
            rows.append(row + first), gaps.append(np.fmin(refined[0], gap[row, k])), places.append(refined[1])
            least.append(lowest)
        return np.concatenate(rows), np.concatenate(gaps), np.concatenate(places), np.concatenate(least)

    def lowest(self, shift, yaw, roll):
        """The smallest gap [m] of each right wheel (n,)."""
        rows, gaps, _, _ = self.smallest_gaps(shift, yaw, roll)
        lowest = np.full(len(shift), np.inf)
        np.minimum.at(lowest, rows, gaps)
        return lowest

    def refine(self, shift, yaw, roll, low, high, phi):
        """Smallest gap between ``low`` and ``high`` and its place, by golden section, on each
        circle by Newton's method."""
        ratio = (np.sqrt(5) - 1) / 2
        one, other = high - ratio * (high - low), low + ratio * (high - low)
        at_one, phi = self.circle_gap(shift, yaw, roll, phi, one)
        at_other, phi = self.circle_gap(shift, yaw, roll, phi, other)
        for _ in range(22):  # down to 1e-8 m, where the gap changes by less than 1e-12 m
            left = ~(at_one > at_other)
            low, high = np.where(left, low, one), np.where(left, other, high)
            new = np.where(left, high - ratio * (high - low), low + ratio * (high - low))
            at_new, phi = self.circle_gap(shift, yaw, roll, phi, new)
            one, other = np.where(left, new, other), np.where(left, one, new)
            at_one, at_other = np.where(left, at_new, at_other), np.where(left, at_one, at_new)
        return np.fmin(at_one, at_other), 0.5 * (low + high)

    def circle_gap(self, shift, yaw, roll, phi, y):
        """Smallest gap on the circles through ``y``, near ``phi``, from the formulas; and its phi."""
        z = self.wheel(y)[0]
        for _ in range(2):
            across, down, across_rate, down_rate, r = self.place(shift, yaw, roll, phi, y, z)
            height, slope, bend = self.rail(across - self.origin)
            curved = (
                bend * across_rate**2 - slope * np.sin(yaw) * r * np.sin(phi) + r * np.cos(phi) * np.cos(roll)
            )
            phi = phi - np.clip((slope * across_rate - down_rate) / np.maximum(curved, 0.1), -0.05, 0.05)
        across, down, *_ = self.place(shift, yaw, roll, phi, y, z)
        beside = (across - self.origin < self.x[0]) | (across - self.origin > self.x[-1])
        return np.where(beside, np.nan, self.rail(across - self.origin)[0] - down), phi

    def contact(self, shift, yaw, roll, x_wheel, y_wheel):
        """At right wheels' points (x_wheel, y_wheel): gap [m], height of the wheel profile [m], and sine of
        the angle between the normals of both surfaces."""
        z, slope, _ = self.wheel(y_wheel)
        phi = np.arcsin(x_wheel / (self.radius + z))
        across, down, *_ = self.place(shift, yaw, roll, phi, y_wheel, z)
        height, rail_slope, _ = self.rail(across - self.origin)
        # normal of the wheel (sin phi, -slope, cos phi) in the wheelset's axes, rolled and yawed
        n = np.array([np.sin(phi), -slope, np.cos(phi)]) / np.hypot(1.0, slope)
        n = np.array(
            [n[0], np.cos(roll) * n[1] - np.sin(roll) * n[2], np.sin(roll) * n[1] + np.cos(roll) * n[2]]
        )
        n = np.array([np.cos(yaw) * n[0] - np.sin(yaw) * n[1], np.sin(yaw) * n[0] + np.cos(yaw) * n[1], n[2]])
        rail = np.array([0 * rail_slope, -rail_slope, 1 + 0 * rail_slope]) / np.hypot(1.0, rail_slope)
        return height - down, z, np.linalg.norm(np.cross(n, rail, axis=0), axis=0), np.arctan(-rail_slope)


def allowance(y):
    """How far heights of the product's S1002 are from the printed ones at ``y`` [m], at most [m]."""
    return np.where(np.any([np.abs(y - joint) < JOINT_REACH for joint in JOINTS], axis=0), JOINT_STEP, 0.0)


def inclined_stop(rail, inclination, stop):
    """Where the field side of an inclined head ends that is cut off at ``stop`` [mm] when upright: in
    its placed frame [m]."""
    pieces, half = brute_force.tangent_chain(brute_force.RAIL_HEADS[rail]), stop
    angle = atan(inclination)
    centre, radius = next((centre, radius) for centre, radius, joint in pieces if half <= joint[0])
    point = np.array([half, centre[1] - np.sqrt(radius**2 - (half - centre[0]) ** 2)])
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    # the highest point of the inclined head lies straight above the centre of the arc that holds it
    for centre, radius, joint in pieces:
        top = turn @ centre - [0, radius]
        if top[0] <= (turn @ joint)[0]:
            return (turn @ point - top)[0] * 1e-3
    raise ValueError(f"no highest point at an inclination of {inclination}")


def assert_positions(found, wanted, place=3e-7, rail=()):
    """Rigid contact is where ``brute_force.rigid_contact`` finds it, to ``place`` [m], in the coordinates
    ``rail`` too. Printed coefficients leave steps of 1 nm at the joints, which the product has closed; a gap
    that is off by this much moves the contact by sqrt(2e-9 / 5 m) / 100, 0.2 um."""
    assert found.status <= 1
    assert found.roll == pytest.approx(wanted.roll, abs=3e-9)  # [rad]
    assert found.vertical_shift == pytest.approx(wanted.vertical_shift, abs=3e-9)  # [m]
    for side in ("left", "right"):
        mine, theirs = getattr(found, side), getattr(wanted, side)
        for name in ("x_wheel", "y_wheel", "z_wheel", "x_track", "y_track", "z_track", *rail):
            one, other = getattr(mine.contact, name), getattr(theirs, name)
            assert one == pytest.approx(other, abs=place), (side, name)
        assert mine.rolling_radius == pytest.approx(theirs.rolling_radius, abs=place)
        # the angle follows the position with the wheel's curvature, 77 1/m at most
        assert mine.contact_angle == pytest.approx(theirs.contact_angle, abs=100 * place)
