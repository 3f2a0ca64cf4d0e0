"""Slices of rails that change along the track, for the tests."""

from functools import cache

import numpy as np

from wrcontact import RailSections
from wrcontact.interface.calls import START_ROW
from wrcontact.interface.index import PLACES
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import changing_kernel, default_kernel
from wrcontact.profiles import standard_profile
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.sections.kernel_table import with_changing_rails, with_sections
from wrcontact.stepper import Stepper

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


#: How much lower than the level wing the nose is [mm]: S1002 then touches both.
NOSE_LOW = 1.965


def _head(middle, top, radius, walls):
    """Points (n, 2) [mm] of an arc of this ``radius`` with its highest place at ``middle``, ``top``, between two slopes."""
    angle = np.linspace(*np.arctan(walls), int(radius * np.ptp(np.arctan(walls)) / 0.25))
    return np.column_stack([middle + radius * np.sin(angle), top + radius * (1.0 - np.cos(angle))])


def _line(start, stop):
    """Points [mm] on the way between two that are known."""
    count = int(np.hypot(*np.subtract(stop, start)) / 0.5) + 2
    return np.linspace(start, stop, count)[1:-1]


def crossing_points(nose_y, wing_y, nose_z=NOSE_LOW, wing_z=-1.4, floor=20.0):
    """Points [m] of a nose and a wing with a groove between: arcs of 7 mm, with walls of slope 3 and 4, and the wing level."""
    nose, wing = _head(nose_y, nose_z, 7.0, (-3.0, 3.0)), _head(wing_y, wing_z, 7.0, (-4.0, -0.02))
    foot = [
        (end[0] + way * (floor - end[1]) / slope, floor)
        for end, way, slope in ((nose[0], -1.0, 3.0), (nose[-1], 1.0, 3.0), (wing[0], -1.0, 4.0))
    ]
    end = wing[-1] + [40.0, -0.8]
    parts = (
        [foot[0]],
        _line(foot[0], nose[0]),
        nose,
        _line(nose[-1], foot[1]),
        [foot[1]],
        _line(*foot[1:]),
        [foot[2]],
        _line(foot[2], wing[0]),
        wing,
        _line(wing[-1], end),
        [end],
    )
    return np.concatenate(parts) * 1e-3, np.cumsum([len(part) for part in parts])


@cache
def crossing(nose_rate=0.04, wing_rate=0.09):
    """A crossing whose nose and wing move to the field side, each by its rate, in slices 20 mm apart."""
    u = np.arange(-0.16, 0.1601, 0.02)
    sections = [crossing_points(-24.0 + 1e3 * nose_rate * at, 34.0 + 1e3 * wing_rate * at) for at in u]
    ways = [np.r_[0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T))] for points, ends in sections]
    features = [way[[0, *(ends[[1, 2, 4, 6, 7, 8]] - 1), -1]] for way, (points, ends) in zip(ways, sections)]
    return RailSections(u, [points for points, ends in sections], features=features, name="crossing")


def moved(positions, rate=0.0, rise=0.0, rail="UIC60"):
    """A standard rail that moves to the field side by ``rate`` and rises by ``rise`` per length."""
    u = np.asarray(positions, dtype=float)
    return RailSections(
        u, [standard_profile(rail)] * len(u), places=np.column_stack([rate * u, -rise * u]), name="moved"
    )


def waves(count=13, amplitude=1e-3):
    """Sections that wave along the track, more so on the field side."""
    u = np.linspace(0.0, 0.6, count)
    wave = amplitude * np.sin(2.0 * np.pi * u / 0.3)
    points = np.column_stack([across := np.linspace(-0.03, 0.03, 121), 20.0 * across**2])
    tilt = np.column_stack([0.0 * across, across / 0.03])
    return RailSections(
        u, [points + part * tilt for part in wave], places=np.column_stack([0.5 * wave, wave])
    )


class OnSections:
    """The search for the smallest gap of the right wheel of a ``system`` over ``rail``, whose origin lies at ``lateral``
    [m] from the track's centre; ``kernel`` is that of the process by default."""

    def __init__(self, system, rail, lateral, kernel=None, index=1):
        self.system, self.rail, self.lateral, self.index = system, rail, lateral, index
        self.kernel = kernel or default_kernel()
        self.tables = with_sections(system._tables, index, rail.surface, lateral)
        self.work = np.zeros(layout.WORK_SIZE)

    def at(self, position=0.0, shift=0.0, yaw=0.0, roll=0.0):
        """The record of the search, of which it is checked that it is certain."""
        pose = np.array([position, shift, yaw, roll], dtype=float)
        assert self.kernel.search_sections(self.tables, self.work, self.index, pose), pose
        return layout.Work.at(self.work).section_search

    def gaps(self, pose, y, angle):
        """The gap [m] at wheel abscissae ``y`` [m] and angles ``angle`` [rad], arrays of one shape, by the matrices of
        rotation; infinite farther than 5 mm beside the section."""
        position, shift, yaw, roll = pose
        tables = layout.Tables.at(self.tables)
        radius = self.system.side_parameters("right")["nominal_radius"]
        r = radius + evaluate_table(self.system.profile_tables()[0], y)[0]
        c, s = np.cos(yaw), np.sin(yaw)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ np.array(
            [[1.0, 0.0, 0.0], [0.0, np.cos(roll), -np.sin(roll)], [0.0, np.sin(roll), np.cos(roll)]]
        )
        wheel = np.stack([r * np.sin(angle), tables.arm + y, r * np.cos(angle)])
        x, across, down = np.tensordot(turn, wheel, 1)
        u, abscissa = position + x, across + shift - self.lateral
        first, last = self.rail.edges(u)
        gap = self.rail.surface.jet(u, abscissa)[0] - (down - tables.height)
        return np.where((abscissa >= first - 5e-3) & (abscissa <= last + 5e-3), gap, np.inf)

    def brute(self, pose, reach=0.25):
        """The smallest gap [m] by grids of abscissa and angle, each finer than the one before."""
        table = self.system.profile_tables()[0]
        ends = y_low, y_high = table[0] + 1e-9, table[1] - 1e-9
        low, high, counts = -reach, reach, (700, 201)
        for _ in range(5):
            y = np.linspace(y_low, y_high, counts[0])
            angle = np.linspace(low, high, counts[1])
            gap = self.gaps(pose, *(part.ravel() for part in np.meshgrid(y, angle)))
            k = int(np.argmin(gap))
            at_y, at_angle = y[k % len(y)], angle[k // len(y)]
            y_low, y_high = (at_y + side * 3.0 * (y[1] - y[0]) for side in (-1.0, 1.0))
            y_low, y_high = max(y_low, ends[0]), min(y_high, ends[1])
            low, high = (at_angle + side * 3.0 * (angle[1] - angle[0]) for side in (-1.0, 1.0))
            counts = (61, 61)
        return gap[k]


def stepper_on(system, right, left=None, lateral=None, kernel=None):
    """A stepper of the ``system`` on rails that change: sections of the ``right`` side, and of the ``left`` one or the same
    ones mirrored; their origins lie at ``lateral`` [m] from the track's centre, by default where the system's rail is."""
    lateral = system.profile_tables()[2] if lateral is None else lateral
    rails = [((left or right).surface, lateral), (right.surface, lateral)]
    return Stepper(with_changing_rails(system._tables, rails), (kernel or changing_kernel()).bind)


def stepped(stepper, **inputs):
    """The status of a step at ``inputs`` by keyword, and its outputs by name."""
    stepper.inputs[:] = START_ROW
    for name, value in inputs.items():
        stepper.inputs[PLACES[name]] = value
    status = stepper.step()
    return status, dict(zip(stepper.output_names, stepper.outputs.tolist()))
