"""What the outputs of one wheel have to be: from the printed profiles by brute force, and from a half-space.

Geometry is that of data/brute_force.py and of the dense overlap search, normal contact that of
data/halfspace_reference.py or Hertz's by scipy.  No code is the product's, and no output is read
but through :attr:`WheelWitness.values`: the height and the roll of the wheelset, whose witnesses are the gaps
at them, the loads and places of patches where a question is asked about one, and the wheel's load.
"""

from dataclasses import replace
from functools import cache, cached_property
from math import atan, cos, hypot, pi, radians, sin
from types import SimpleNamespace

import numpy as np
from scipy import ndimage

from data import brute_force, halfspace_reference
from data.brute_force import Pose
from data.hertz import hertz
from tests.helpers.overlap import deepest, overlap

SIGNS = {"left": -1, "right": 1}
#: Angle between normals from which on one half-space does not hold two patches [rad].
ONE_PLANE = radians(15)
#: Cells of the half-space over a patch, along the track.
CELLS = 32
#: Cells over the narrowest patch, across the track, and in all at most.
ACROSS, MOST = 24, 240
#: A part of the half-space's patch with a smaller share of the load is none.
STRAY = 1e-4


@cache
def track(rail, inclination):
    return brute_force.track(rail, inclination)


@cache
def smallest_gap(system, pose):
    return brute_force.smallest_gap(system, pose)


class HalfspacePatch:
    """A connected patch of a half-space's solution: ``pressure`` (n, m) [Pa] of it alone on the grid, and
    ``offset`` [m] from the stations of the plane to those of the outputs."""

    def __init__(self, solution, plane, pressure, offset):
        x, s = solution.x, solution.s
        dx, ds = x[1] - x[0], s[1] - s[0]
        self.s = s + offset
        self.half_lengths = np.array([0.5 * dx * halfspace_reference.loaded_cells(row) for row in pressure.T])
        self.pressures = pressure.max(axis=0)
        self.load = pressure.sum() * solution.cell
        self.area = 2.0 * self.half_lengths.sum() * ds
        self.max_pressure = self.pressures.max()
        self.length = 2.0 * self.half_lengths.max()
        loaded = pressure.any(axis=0)
        self.start, self.stop = self.s[loaded][0] - 0.5 * ds, self.s[loaded][-1] + 0.5 * ds
        self.width = self.stop - self.start
        share = pressure.sum(axis=0) / pressure.sum()
        centroid = float(share @ s)
        self.centroid = centroid + offset
        forward = float(pressure.sum(axis=1) @ x / pressure.sum())
        self.place = plane.point(forward, centroid, plane.rail(centroid))
        across = plane.point(0.0, s[loaded], plane.rail(s[loaded]))[1]
        slope = plane.system.rail(across - plane.system.rail_origin)[1]
        # sine and cosine of the rail's angle, the means over the pressure
        self.normal = share[loaded] @ (
            np.stack([-slope, np.ones(slope.shape)], axis=1) / np.hypot(1.0, slope)[:, None]
        )

    def at(self, stations):
        """Half-lengths and pressures at ``stations`` [m], zero beside the patch."""
        return (np.interp(stations, self.s, of, 0.0, 0.0) for of in (self.half_lengths, self.pressures))


class HertzPatch:
    """The ellipse under ``load`` [N] at a contact point whose wheel has these curvatures [1/m]."""

    def __init__(self, contact, sign, curvatures, load):
        A, B = (0.5 * curvature for curvature in curvatures)
        self.penetration, a, b, self.max_pressure = hertz(A, B, load)
        self.load, self.area, self.centroid = load, pi * a * b, 0.0
        self.normal = np.array([sin(contact.contact_angle), cos(contact.contact_angle)])
        self.length, self.width, self.start, self.stop = 2.0 * a, 2.0 * b, -b, b
        self.place = np.array([contact.x_track, sign * contact.y_track, contact.z_track])

    def at(self, stations):
        """Half-lengths and pressures at ``stations`` [m], zero beside the patch."""
        height = np.sqrt(np.maximum(1.0 - (stations / self.stop) ** 2, 0.0))
        return 0.5 * self.length * height, self.max_pressure * height


def halfspace_patches(solution, plane, offset=0.0):
    """The patches of a solution by falling load."""
    labels, count = ndimage.label(solution.pressure > 0.0, np.ones((3, 3)))
    found = [
        HalfspacePatch(solution, plane, np.where(labels == number, solution.pressure, 0.0), offset)
        for number in range(1, count + 1)
        if solution.pressure[labels == number].sum() > STRAY * solution.pressure.sum()
    ]
    return sorted(found, key=lambda patch: -patch.load)


class WheelWitness:
    """One wheel of a scene, seen as a right wheel.

    values : outputs of the wheelset by name, as read from an FMU.
    inputs : what it was given; ``mode`` and ``model`` are its contact mode and normal model.
    """

    def __init__(self, system, side, values, inputs, mode, model):
        self.system, self.side, self.sign = system, side, SIGNS[side]
        self.values, self.inputs, self.mode, self.model = values, inputs, mode, model
        self.shift, self.yaw, self.roll = (
            self.sign * of
            for of in (inputs.get("lateral_shift", 0.0), inputs.get("yaw", 0.0), values["roll"])
        )
        transfer = inputs.get("load_transfer", 0.0)
        self.load = inputs.get("normal_force", 78.5e3) * (1.0 + self.sign * transfer)
        self.pose = Pose(self.shift, self.yaw, self.roll, values["vertical_shift"])
        #: The wheelset's centre in the track frame [m], not mirrored.
        self.centre = self.pose.centre(system) * [1.0, self.sign, 1.0]

    def __getitem__(self, name):
        """An output of this wheel."""
        return self.values[f"{self.side}.{name}"]

    @property
    def count(self):
        return int(self["patch_count"])

    @property
    def loaded(self):
        return self["normal_force"] > 0.0

    @property
    def pressed(self):
        return self.mode == "compliant"

    # --- where it touches -------------------------------------------------------------------------

    @cached_property
    def lowest(self):
        """Smallest vertical gap of the wheel at no vertical shift: gap, phi, y, zone."""
        return smallest_gap(self.system, replace(self.pose, vertical_shift=0.0))

    @cached_property
    def deepest(self):
        """Where a pressed wheel overlaps its rail most along the rail's normals: depth, x, rail abscissa."""
        wide = np.linspace(-0.06, 0.06, 61)[:, None], np.linspace(-0.034, 0.03, 641)[None, :]
        depth = overlap(self.system, self.pose, *wide, iterations=8)
        near = wide[1][0, np.unravel_index(np.argmax(depth), depth.shape)[1]]
        return deepest(self.system, self.pose, near, 2e-4, iterations=12)

    @cached_property
    def contact(self):
        """The contact point in all frames, its angle and the wheel's radius there."""
        if not self.pressed:
            touching = replace(self.pose, vertical_shift=self.lowest[0])
            return brute_force.contact(self.system, touching, *self.lowest[1:], side=self.sign)
        _, x, abscissa = self.deepest
        height, slope, _ = self.system.rail(abscissa)
        on_wheel = self.wheel_point(x, abscissa)
        radius = hypot(on_wheel[0], on_wheel[2])
        return brute_force.Contact(
            on_wheel[0],
            on_wheel[1] - self.system.half_distance,
            on_wheel[2] - self.system.nominal_radius,
            abscissa,
            float(height),
            x,
            self.sign * (self.system.rail_origin + abscissa),
            float(height),
            -atan(slope),
            radius,
        )

    def wheel_point(self, x, abscissa, pose=None):
        """The wheel's point (3,) in the axes of the wheelset on the rail's normal at ``x`` and
        ``abscissa``."""
        pose = pose or self.pose
        height, slope, _ = self.system.rail(abscissa)
        depth = overlap(self.system, pose, np.array(x), np.array(abscissa))
        normal = np.array([0.0, -slope, 1.0]) / hypot(1.0, slope)
        place = np.array([x, self.system.rail_origin + abscissa, float(height)]) + depth * normal
        return (place - pose.centre(self.system)) @ pose.rotation()

    @cached_property
    def curvatures(self):
        """1/R_x of the wheel, and second derivative along s of the smallest distance over x [1/m], at the
        contact point, from the fundamental forms of both surfaces."""
        contact = self.contact
        angle = contact.contact_angle
        lateral, normal = np.array([0.0, cos(angle), -sin(angle)]), np.array([0.0, -sin(angle), -cos(angle)])
        phi = atan(contact.x_wheel / (self.system.nominal_radius + contact.z_wheel))
        height, slope, bend = self.system.wheel(contact.y_wheel)
        r, s, c = self.system.nominal_radius + height, sin(phi), cos(phi)
        turn = self.pose.rotation()
        along, across, twice_along, twist, twice_across = (
            turn @ np.array(v)
            for v in (
                (r * c, 0, -r * s),
                (slope * s, 1, slope * c),
                (-r * s, 0, -r * c),
                (slope * c, 0, -slope * s),
                (bend * s, 0, bend * c),
            )
        )
        tangents = np.array([[along[0], across[0]], [along @ lateral, across @ lateral]])
        form = np.array([[twice_along @ normal, twist @ normal], [twist @ normal, twice_across @ normal]])
        inverse = np.linalg.inv(tangents)
        hessian = inverse.T @ form @ inverse
        _, rail_slope, rail_bend = self.system.rail(contact.y_rail)
        of_rail = rail_bend / hypot(1.0, rail_slope) ** 3
        return hessian[0, 0], hessian[1, 1] - hessian[0, 1] ** 2 / hessian[0, 0] + of_rail

    # --- how it is loaded -------------------------------------------------------------------------

    @cached_property
    def hertz(self):
        """Hertz's patch at the contact point."""
        return HertzPatch(self.contact, self.sign, self.curvatures, self["normal_force"])

    @cached_property
    def one_plane(self):
        """Whether one half-space holds all patches."""
        angles = [self[f"patch[{k}].contact_angle"] for k in range(1, self.count + 1)]
        return all(abs(angle - self.contact.contact_angle) < ONE_PLANE for angle in angles)

    def plane(self, x, abscissa):
        """The tangent plane at a point of the rail."""
        height, slope, _ = self.system.rail(abscissa)
        smooth = replace(self.system, wheel=halfspace_reference.without_steps(self.system.wheel))
        origin = np.array([x, self.system.rail_origin + abscissa, float(height)])
        return halfspace_reference.ContactPlane(smooth, self.pose, origin, -atan(slope))

    @cached_property
    def halfspace(self):
        """The half-space in the contact plane under the wheel's load: penetration [m] and patches."""
        beside = 0.2 * self["patch_width"]
        return self.pressed_on(
            self.contact.x_track,
            self.contact.y_rail,
            0.0,
            self["station[1]"] - beside,
            self["station[31]"] + beside,
            self["normal_force"],
        )

    @cached_property
    def carried(self):
        """Hertz's patch, or the patches of the half-space by falling load: in the contact plane, or each one
        alone with its load, in the plane of its deepest point, where the planes differ."""
        if self.model == "hertz":
            return [self.hertz]
        if self.one_plane:
            return self.halfspace[1]
        return [self.alone(k) for k in range(1, self.count + 1)]

    def alone(self, k):
        """Patch ``k`` alone on a half-space that ends halfway to the next patch."""
        _, x, abscissa = self.entry(k)
        mine, *others = (self.stretch(i) for i in (k, *(i for i in range(1, self.count + 1) if i != k)))
        spaces = [0.5 * max(mine.start - of.stop, of.start - mine.stop) for of in others]
        beside = min(0.35 * mine.width, *spaces)
        return self.pressed_on(
            x,
            abscissa,
            self.stations_to(abscissa),
            mine.start - beside,
            mine.stop + beside,
            self[f"patch[{k}].normal_force"],
        )[1][0]

    def pressed_on(self, x, abscissa, offset, low, high, load):
        """The half-space in the plane at this point of the rail, between the stations ``low`` and ``high`` of
        the outputs, which are ``offset`` [m] more than those of the plane."""
        plane = self.plane(x, abscissa)
        ahead = 0.7 * self["patch_length"]
        narrowest = min(self[f"patch[{k}].width"] for k in range(1, self.count + 1))
        cells = CELLS, int(np.clip(ACROSS * (high - low) / narrowest, ACROSS, MOST))
        solution = halfspace_reference.solve_within(
            plane, (-ahead, low - offset), (ahead, high - offset), cells, load
        )
        assert not solution.touches_border, f"{self.side}: the patches are larger than the outputs say"
        return solution.penetration, halfspace_patches(solution, plane, offset)

    def stations_to(self, abscissa):
        """The rail's arc length [m] from the contact point to ``abscissa``."""
        y = np.linspace(self.contact.y_rail, abscissa, 2001)
        slope = self.system.rail(y)[1]
        return float(np.trapezoid(np.hypot(1.0, slope), y))

    # --- its patches ------------------------------------------------------------------------------

    @cached_property
    def under_load(self):
        """The wheel where it overlaps the rail by its penetration: a rigid wheel sinks straight down."""
        if self.pressed:
            return self.pose
        sunk = self["penetration"] / cos(self.contact.contact_angle)
        return replace(self.pose, vertical_shift=self.pose.vertical_shift + sunk)

    def abscissa(self, k):
        """Of the rail [m] where patch ``k`` has its centre of load."""
        return self.sign * self[f"patch[{k}].y_track"] - self.system.rail_origin

    @cache
    def entry(self, k):
        """Where the wheel overlaps its rail most near patch ``k``: depth, x, rail abscissa."""
        reach = 0.5 * self[f"patch[{k}].width"]
        return deepest(self.system, self.under_load, self.abscissa(k), reach, levels=4, iterations=8)

    def ridge(self, k):
        """Track coordinate x [m] at which the overlap is largest on the rail's line through the centre of
        load of patch ``k``."""
        x = self.entry(k)[1] + np.linspace(-0.03, 0.03, 1201)
        return x[np.argmax(overlap(self.system, self.under_load, x, np.array(self.abscissa(k)), 12))]

    def stretch(self, k=None):
        """The outline over patch ``k``, or all of it: area, load and centroid by the trapezoidal rule, edges,
        largest half-length and pressure, and the number of cells of the narrowest patch in it; None where
        the stations do not tell the patches apart."""
        s, a, p = (
            np.array([self[f"{name}[{j}]"] for j in range(1, 32)])
            for name in ("station", "half_length", "pressure")
        )
        labels, count = ndimage.label(p > 0.0)
        runs = [np.flatnonzero(labels == number) for number in range(1, count + 1)]
        cells = min(len(run) + 1 for run in runs)
        if k is not None:
            places = sorted(self[f"patch[{i}].centroid"] for i in range(1, self.count + 1))
            if count != self.count:
                return None
            run = runs[places.index(self[f"patch[{k}].centroid"])]
            s, a, p = (of[run[0] - 1 : run[-1] + 2] for of in (s, a, p))
            cells = len(run) + 1
        line = 0.5 * pi * a * p
        load = np.trapezoid(line, s)
        return SimpleNamespace(
            area=np.trapezoid(2.0 * a, s),
            load=load,
            length=2.0 * a.max(),
            cells=cells,
            centroid=np.trapezoid(line * s, s) / load,
            max_pressure=p.max(),
            start=s[0],
            stop=s[-1],
            width=s[-1] - s[0],
        )
