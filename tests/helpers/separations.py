"""Separations of wheel and rail near a contact, computed apart from the kernel."""

import numpy as np
import pytest
from scipy.optimize import brentq

import wrcontact
from tests.helpers.inside import workspace_of
from wrcontact.kernel import layout
from wrcontact.kernel.binding.setup import profile_tables
from wrcontact.kernel.contact import curves, separation, traces
from wrcontact.methods import NUMBERS
from wrcontact.profiles.compiled import evaluate_table, table_pieces

PLACES = {"tread": 1e-3, "root": 6e-3, "flange": 6.5e-3}
YAWS = {"no_yaw": 0.0, "yaw": 0.03, "yaw_back": -0.02}
#: One yaw at each place; the full tests have all.
SHARE_OF_PLACES = pytest.mark.parametrize(
    "shift, yaw",
    [
        pytest.param(shift, yaw, id=f"{place}-{turned}", marks=[pytest.mark.full] * (k != m))
        for k, (place, shift) in enumerate(PLACES.items())
        for m, (turned, yaw) in enumerate(YAWS.items())
    ],
)
EVERY_PLACE = pytest.mark.parametrize(
    "shift, yaw",
    [
        pytest.param(shift, yaw, id=f"{place}-{turned}")
        for place, shift in PLACES.items()
        for turned, yaw in YAWS.items()
    ],
)

#: Gauss's rule of twelve nodes from -1 to 1.  Pieces are at most 1 mm long: six nodes give the same lengths
#: to 1e-18 m, and so does scipy's adaptive quadrature.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


class Curve:
    """A curve across the track: ``point(u)`` and ``angle(u)`` of its tangent over a profile's
    abscissa u, its pieces' ends."""

    def __init__(self, table):
        self.table = table
        self.ends = table_pieces(table)[1:-1, 0]

    def point(self, u):
        return np.array([u, evaluate_table(self.table, u)[0]])

    def angle(self, u):
        return np.arctan(evaluate_table(self.table, u)[1])

    def speed(self, u):
        return 1 / np.cos(self.angle(u))

    def arc(self, start, stop):
        """Arc length by Gauss's rule, broken where the curvature may jump."""
        low, high = min(start, stop), max(start, stop)
        edges = np.concatenate([[low], self.ends[(self.ends > low) & (self.ends < high)], [high]])
        half = 0.5 * np.diff(edges)
        length = half @ self.speed((edges[:-1] + half)[:, None] + half[:, None] * NODES) @ WEIGHTS
        return length if stop > start else -length

    def at_arc(self, start, length):
        return self._root(lambda u: self.arc(start, u) - length, start, length)

    def at_chord(self, start, chord):
        """Abscissa where a circle of radius abs(chord) around the point at ``start`` cuts the curve."""
        middle = self.point(start)
        return self._root(lambda u: np.hypot(*(self.point(u) - middle)) - abs(chord), start, chord)

    def _root(self, function, start, length):
        return brentq(function, start, start + 1.2 * length, xtol=1e-16, rtol=8.9e-16)


class Outline(Curve):
    """The wheel's outline, seen along the track: of each circle around the axle the point
    whose normal has no x part.

    That point is found numerically, with the wheelset's attitude as a product of two rotation matrices.
    """

    def __init__(self, table, system, state):
        super().__init__(table)
        c, s = np.cos(float(state.inputs[1])), np.sin(float(state.inputs[1]))
        cr, sr = np.cos(float(state.roll)), np.sin(float(state.roll))
        self.turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array(
            [[1, 0, 0], [0, cr, -sr], [0, sr, cr]]
        )
        self.radius = system.parameters["nominal_radius"]
        self.arm = system.parameters["running_circle_distance"] / 2

    def around(self, u):
        """Position and normal in the track's axes at profile abscissa ``u``, from the wheelset's centre."""
        z, slope, _ = evaluate_table(self.table, u)
        r = self.radius + z

        def along(phi):
            return self.turn[0] @ [np.sin(phi), -slope, np.cos(phi)]

        phi = brentq(along, -0.7, 0.7, xtol=1e-16, rtol=8.9e-16) if self.turn[0, 1] != 0.0 else 0.0
        return (
            self.turn @ [r * np.sin(phi), self.arm + u, r * np.cos(phi)],
            self.turn @ np.array([np.sin(phi), -slope, np.cos(phi)]),
        )

    def point(self, u):
        return self.around(u)[0][1:]

    def angle(self, u):
        normal = self.around(u)[1]
        return np.arctan2(-normal[1], normal[2])

    def speed(self, u):
        """Without yaw the profile's, whose roll does not count."""
        if self.turn[0, 1] == 0.0:
            return np.hypot(1.0, evaluate_table(self.table, u)[1])
        return np.vectorize(self.yawed_speed)(u)

    def yawed_speed(self, u, step=2e-5):
        """By differences of sixth order on one side of a piece's end."""
        low, high = self.piece(u)
        step = min(step, 0.99 * (high - u) / 3, 0.99 * (u - low) / 3)
        one, two, three = (
            (self.point(u + k * step) - self.point(u - k * step)) / (2 * k * step) for k in (1, 2, 3)
        )
        return np.hypot(*(1.5 * one - 0.6 * two + 0.1 * three))

    def piece(self, u):
        profile = layout.Profile.at(self.table)
        edges = np.concatenate([[profile.start], self.ends, [profile.stop]])
        at = np.searchsorted(edges, u)
        return edges[at - 1], edges[at]


class Contact:
    """The right wheel at a pose, sunk under ``force``: the region that carries most of it, both curves
    through its deepest point, their abscissae there, and the kernel's own frame of the region."""

    def __init__(self, shift, yaw=0.0, kind="normal", force=78.5e3, **parameters):
        self.system = wrcontact.ContactSystem(separation=kind, **parameters)
        stepper = self.system.stepper()
        stepper.inputs[:4] = shift, yaw, 0.0, force
        assert stepper.step() == 0
        self.state = self.system.evaluate(shift, yaw, force)
        self.tables, self.work = stepper.tables, workspace_of(stepper)
        wheel, rail, _ = profile_tables(self.tables, 1)
        self.rail = Curve(rail)
        self.wheel = Outline(wheel, self.system, self.state)
        contact = layout.Work.at(self.work).contact
        index = max(range(contact.overlap.count), key=lambda k: contact.regions[k].load)
        region, frame = contact.regions[index], contact.frame
        layout.copy(contact.frames[index], frame)
        frame.raised = 0.0  # separations begin at zero
        self.u_rail, self.u_wheel = region.rail, region.wheel
        self.depth = frame.depth
        self.angle = np.arctan2(frame.plane.sin, frame.plane.cos)

    def kernel(self, kind, stations, spacing=0.0):
        """Gap [m], rate [-], bend [1/m] and 1/R_x [1/m] from the kernel's Python, (4, n), at
        ``stations`` from the deepest point."""
        tables, work = layout.Tables.at(self.tables.copy()), layout.Work.at(self.work.copy())
        tables.separation = NUMBERS["separation"][kind]
        region = layout.Region(rail=self.u_rail, wheel=self.u_wheel)
        traces.start_traces(work.contact.frame, 0.0, self.u_rail, self.u_wheel)
        curves.open_origin(tables.pairs[1], work.contact.frame, work.contact.origin, region, spacing)
        return np.array(
            [
                separation.separation(
                    tables.pairs[1], work.contact.frame, work.contact.origin, float(s), 1e-13
                )
                for s in stations
            ]
        ).T

    def depth_lost(self, u_rail):
        """How much less deep the wheel is at the rail's point, as it was pressed in along the deepest point's
        normal [m]."""
        return self.depth * (1 - np.cos(self.rail.angle(u_rail) - self.rail.angle(self.u_rail)))

    def normal(self, station):
        """Depth of the deepest point less the overlap along the rail's normal at arc length ``station``, of
        the outline where it stands."""
        u_rail = self.rail.at_arc(self.u_rail, station) if station else self.u_rail
        first, angle = self.rail.angle(self.u_rail), self.rail.angle(u_rail)
        pressed = self.depth * np.array([-np.sin(first), np.cos(first)])

        def apart(u_wheel):
            return self.between(u_rail, u_wheel) + pressed

        along = np.array([np.cos(angle), np.sin(angle)])
        u_wheel = self.wheel._root(lambda u: apart(u) @ along, self.u_wheel - station, 3 * station)
        return self.depth - apart(u_wheel) @ [-np.sin(angle), np.cos(angle)]

    def between(self, u_rail, u_wheel):
        """Wheel's point less the rail's, both from the deepest point [m]."""
        return (self.wheel.point(u_wheel) - self.wheel.point(self.u_wheel)) - (
            self.rail.point(u_rail) - self.rail.point(self.u_rail)
        )

    def along_mean_normal(self, u_rail, u_wheel):
        normals = [
            np.array([np.sin(curve.angle(u)), -np.cos(curve.angle(u))])
            for curve, u in ((self.rail, u_rail), (self.wheel, u_wheel))
        ]
        return self.between(u_rail, u_wheel) @ sum(normals) / np.hypot(*sum(normals))

    def vertical(self, station):
        lateral = station * np.cos(self.angle)
        start = self.wheel.point(self.u_wheel)[0]
        u = brentq(
            lambda u: self.wheel.point(u)[0] - start - lateral,
            self.u_wheel - 5e-3,
            self.u_wheel + 5e-3,
            xtol=1e-16,
            rtol=8.9e-16,
        )
        return -self.between(self.u_rail + lateral, u)[1]

    def equidistant(self, station):
        u_rail = self.rail.at_arc(self.u_rail, station)
        u_wheel = self.wheel.at_arc(self.u_wheel, station)
        return self.along_mean_normal(u_rail, u_wheel) + self.depth_lost(u_rail)

    def chords(self, count, spacing):
        u_rail, u_wheel = self.u_rail, self.u_wheel
        for _ in range(count):
            u_rail, u_wheel = self.rail.at_chord(u_rail, spacing), self.wheel.at_chord(u_wheel, spacing)
        return self.along_mean_normal(u_rail, u_wheel) + self.depth_lost(u_rail)


STATIONS = np.array([0.2e-3, 0.6e-3, 1.1e-3])  # on a flange the rail's side begins soon
