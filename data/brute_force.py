"""Rigid contact of a wheelset on track by brute force: the slow, independent witness.

The question: at a given lateral shift and yaw, which roll makes the lowest point of the vertical gap equal on
both wheels, and where are the two contact points?  The recipe::

    wheel surface (phi, y_wheel)  ->  vertical gap above the rail
    dense grid over both          ->  every local minimum, refined        smallest_gap
    equal smallest gaps           ->  roll, by bracketing                 rigid_contact

Nothing here knows where on the wheel a contact can lie: both surface parameters are searched. The module
shares no code with the product that it checks; it needs numpy and scipy only.

Frames. Track: x forward, y right, z down, origin on the track centre line at top-of-rail height. Everything
is worked out for the right-hand side; the left side is the mirror image, that is the right side with shift,
yaw and roll negated. Wheel profile: y to the field side from the running circle, z down. Rail: axes parallel
to the track, origin at the highest point of the inclined head, y to the field side. Units m and rad; profile
tables in mm as printed.
"""

from dataclasses import dataclass
from math import atan, cos, hypot, sin, sqrt

import numpy as np
from scipy.optimize import brentq
from scipy.optimize.elementwise import find_root

MM = 1e-3  # [m]

# ------------------------------------------------------------------------------------------------------ wheel


def polynomial(*coefficients):
    """Height, slope and curvature of z(y) = c0 + c1 y + c2 y^2 + ... [mm]."""
    f = np.polynomial.Polynomial(coefficients)
    df, ddf = f.deriv(1), f.deriv(2)
    return lambda y: (f(y), df(y), ddf(y))


def arc(centre_y, centre_z, radius, sign):
    """The same for a circle, z = z_c + sign sqrt(R^2 - (y - y_c)^2) [mm]; sign -1 is the
    upper arc (z points down)."""

    def evaluate(y):
        u = y - centre_y
        root = np.sqrt(np.maximum(radius**2 - u**2, 1e-12))
        return centre_z + sign * root, -sign * u / root, -sign * radius**2 / root**3

    return evaluate


@dataclass(frozen=True)
class Zones:
    """A profile made of zones, each with its own printed formula, valid between its own ends (mm inside)."""

    ends: tuple  # [(y_from, y_to)] [mm], rising
    formulas: tuple

    def zone_of(self, y):
        """Index of the zone that owns y [m]; a joint belongs to the zone on its right."""
        return np.searchsorted([start for start, _ in self.ends[1:]], np.asarray(y) / MM, side="right")

    def __call__(self, y, zone=None):
        """Height [m], slope [1], curvature [1/m] at y [m], by the formula of ``zone``
        (default: the owner)."""
        y = np.asarray(y, dtype=float)
        zone = np.broadcast_to(self.zone_of(y) if zone is None else zone, y.shape)
        z, dz, ddz = np.empty(y.shape), np.empty(y.shape), np.empty(y.shape)
        for index in np.unique(zone):
            here = zone == index
            z[here], dz[here], ddz[here] = self.formulas[index](y[here] / MM)
        return z * MM, dz, ddz / MM


def s1002():
    """Wheel profile S1002 as printed in EN 13715 / UIC 510-2, zones H to A, rounding
    steps at the joints included."""
    table = [
        (-70, -62.764705882, arc(-49.5, 9.519259302, 20.5, +1)),
        (-62.764705882, -49.662510381, arc(-55, 16, 12, +1)),
        (-49.662510381, -39.764473993, arc(-58.558326413, 8.834924130, 20, +1)),
        (-39.764473993, -38.426669071, polynomial(-93.576667419, -2.747477419)),
        (-38.426669071, -35, arc(-26.210665, 16.446, 13, -1)),
        (
            -35,
            -26,
            polynomial(
                -4.320221063e3,
                -1.038384026e3,
                -1.065501873e2,
                -6.051367875,
                -2.054332446e-1,
                -4.169739389e-3,
                -4.687195829e-5,
                -2.252755540e-7,
            ),
        ),
        (
            -26,
            32.15796,
            polynomial(
                0,
                -3.358537058e-2,
                1.565681624e-3,
                -2.810427944e-5,
                5.844240864e-8,
                -1.562379023e-8,
                5.309217349e-15,
                -5.957839843e-12,
                2.646656573e-13,
            ),
        ),
        (32.15796, 60, polynomial(1.364323640, -0.066666667)),
    ]
    return Zones(ends=tuple((a, b) for a, b, _ in table), formulas=tuple(f for *_, f in table))


# ------------------------------------------------------------------------------------------------------- rail

RAIL_HEADS = {  # half-widths [mm] at the joints R300|R80, R80|R13, R13|side
    "UIC60": (10.5, 25.988023, 36.0),
    "60E1": (10.228, 26.0265, 36.0),
    "54E1": (10.012, 24.864, 35.0),
}
RAIL_RADII = (300.0, 80.0, 13.0)  # [mm]
SIDE_SLOPE = 20.0  # the head sides drop 20 for 1 sideways
SIDE_DEPTH = 30.0  # [mm] how far down the sides are modelled
FAR = 100.0  # [mm] how far the profile is prolonged beyond its ends
STEEPEST = 115.0  # steepest slope kept after inclining (89.5 deg): z must stay a function of y


def tangent_chain(half_widths, radii=RAIL_RADII):
    """Centre, radius and far joint of each arc of the field-side half, head upright, crown at
    the origin, z down [mm].

    At each joint two arcs share the tangent, so the next centre lies on the radius through the joint::

        joint_k = centre_k + R_k n_k, n_k = (sin a_k, -cos a_k), sin a_k = (half-width - y_centre_k) / R_k
        centre_k+1 = joint_k - R_k+1 n_k

    The last arc ends where it is as steep as the side; the printed width is then met to 5e-4 mm.
    """
    sides = SIDE_SLOPE / hypot(1, SIDE_SLOPE)
    centre, arcs = np.array([0.0, radii[0]]), []
    for radius, half_width, following in zip(radii, half_widths, (*radii[1:], 0.0)):
        sine = (half_width - centre[0]) / radius if following else sides
        normal = np.array([sine, -sqrt(1 - sine**2)])
        joint = centre + radius * normal
        arcs.append((centre, radius, joint))
        centre = joint - following * normal
    if abs(joint[0] - half_widths[-1]) > 5e-4:
        raise ValueError(f"the arcs end at a half-width of {joint[0]} mm, printed is {half_widths[-1]} mm")
    return arcs


def inclined_head(half_widths, inclination):
    """Zones of the inclined right-hand head, origin at its highest point [mm in the table].

    Inclining turns every point by atan(inclination) so that the crown leans to the track centre, here to -y;
    an arc stays an arc about its turned centre.
    """
    angle = atan(inclination)
    # (y, z): an upright axis leans to -y
    turn = np.array([[cos(angle), sin(angle)], [-sin(angle), cos(angle)]])
    chain = tangent_chain(half_widths)
    foot = chain[-1][2] + (SIDE_DEPTH - chain[-1][2][1]) * np.array([1 / SIDE_SLOPE, 1])
    field = [(turn @ c, r, turn @ joint) for c, r, joint in chain]
    mirror = np.diag([-1, 1])
    gauge = [(turn @ mirror @ c, r, turn @ mirror @ joint) for c, r, joint in chain]
    pieces = [("line", turn @ mirror @ foot, gauge[2][2])]
    pieces += [("arc", gauge[k][2], gauge[k - 1][2], *gauge[k][:2]) for k in (2, 1)]
    pieces += [("arc", gauge[0][2], field[0][2], *field[0][:2])]
    pieces += [("arc", field[k - 1][2], field[k][2], *field[k][:2]) for k in (1, 2)]
    pieces += [("line", field[2][2], turn @ foot)]
    return single_valued(pieces)


def highest_point(pieces):
    """The point of the head with a horizontal tangent: straight above the centre of
    the arc that has one [mm]."""
    for kind, start, end, *circle in pieces:
        if kind == "arc" and start[0] <= circle[0][0] <= end[0]:
            (y, z), radius = circle
            return np.array([y, z - radius])
    raise ValueError("no highest point on the arcs of this head")


def single_valued(pieces):
    """Pieces -> Zones about the highest point, cut where steeper than 89.5 deg and prolonged
    straight at both ends."""
    origin = highest_point(pieces)
    zones = []
    for kind, start, end, *circle in pieces:
        start, end = start - origin, end - origin
        if kind == "arc":
            (y, z), radius = circle[0] - origin, circle[1]
            reach = radius * STEEPEST / hypot(1, STEEPEST)
            zones.append((max(start[0], y - reach), min(end[0], y + reach), arc(y, z, radius, -1)))
        elif end[0] > start[0] and abs(end[1] - start[1]) < STEEPEST * (end[0] - start[0]):
            slope = (end[1] - start[1]) / (end[0] - start[0])
            zones.append((start[0], end[0], polynomial(start[1] - slope * start[0], slope)))
    first, last = zones[0], zones[-1]
    zones = [
        (first[0] - FAR, first[0], tangent(first[2], first[0])),
        *zones,
        (last[1], last[1] + FAR, tangent(last[2], last[1])),
    ]
    return Zones(ends=tuple((a, b) for a, b, _ in zones), formulas=tuple(f for *_, f in zones))


def tangent(formula, y):
    """The straight line that continues ``formula`` beyond y [mm]."""
    z, slope, _ = formula(np.float64(y))
    return polynomial(z - slope * y, slope)


# ---------------------------------------------------------------------------------------------- wheel on rail


@dataclass(frozen=True)
class Track:
    """What stays fixed: profiles and track dimensions [m]."""

    wheel: Zones
    rail: Zones
    rail_origin: float  # track y of the highest point of the right head [m]
    nominal_radius: float = 0.46
    half_distance: float = 0.75  # running circle to track centre [m]
    rail_depth: float = 0.0  # of the rail's origin below top of rail [m]
    height: float | None = None  # of the wheelset's centre over the running circles [m]; None: the radius


def track(rail="UIC60", inclination=1 / 40, gauge=1.435, gauge_depth=0.014):
    """S1002 wheels on a track laid to ``gauge``, measured ``gauge_depth`` below the
    highest point of the head."""
    head = inclined_head(RAIL_HEADS[rail], inclination)
    side, top = -0.060, -0.020  # [m] bracket of the gauge point
    gauge_point = brentq(lambda y: head(y)[0] - gauge_depth, side, top, xtol=1e-16, rtol=1e-15)
    return Track(wheel=s1002(), rail=head, rail_origin=gauge / 2 - gauge_point)


@dataclass(frozen=True)
class Pose:
    """Pose of the right wheel, wheelset at nominal height unless ``vertical_shift`` is given [m, rad]."""

    lateral_shift: float
    yaw: float
    roll: float
    vertical_shift: float = 0.0

    def mirrored(self):
        """The left wheel's pose, seen in the mirror."""
        return Pose(-self.lateral_shift, -self.yaw, -self.roll, self.vertical_shift)

    def rotation(self):
        """R = Rz(yaw) Rx(roll): wheelset axes -> track axes."""
        c, s, ct, st = cos(self.yaw), sin(self.yaw), cos(self.roll), sin(self.roll)
        return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, ct, -st], [0, st, ct]])

    def centre(self, system):
        height = system.height or system.nominal_radius
        return np.array([0.0, self.lateral_shift, self.vertical_shift - height])


def wheel_surface(system, pose, phi, y, zone=None):
    """Point of the right wheel in the track frame and its partial derivatives.

    ``p = R (r sin phi, b + y, r cos phi) + centre``, r = R0 + z_wheel(y). Returns p, p_phi, p_y,
    p_phiphi, each (3, ...).
    """
    z, dz, _ = system.wheel(y, zone)
    r, s, c = system.nominal_radius + z, np.sin(phi), np.cos(phi)
    nil = 0 * r * s

    def turn(*vector):
        return np.tensordot(pose.rotation(), np.array([v + nil for v in vector]), axes=1)

    centre = pose.centre(system).reshape(3, *(1,) * nil.ndim)
    return (
        turn(r * s, system.half_distance + y, r * c) + centre,
        turn(r * c, 0, -r * s),
        turn(dz * s, 1, dz * c),
        turn(-r * s, 0, -r * c),
    )


def vertical_gap(system, pose, phi, y, zone=None):
    """Vertical gap z_rail - z_wheel [m] over a wheel point, and its derivatives by
    phi, by y and twice by phi."""
    p, p_phi, p_y, p_phiphi = wheel_surface(system, pose, phi, y, zone)
    z, dz, ddz = system.rail(p[1] - system.rail_origin)
    return (
        z + system.rail_depth - p[2],
        dz * p_phi[1] - p_phi[2],
        dz * p_y[1] - p_y[2],
        ddz * p_phi[1] ** 2 + dz * p_phiphi[1] - p_phiphi[2],
    )


# ----------------------------------------------------------------------------------------------------- search

# [rad] +-110 mm around the wheel, far more than yaw can move a contact
PHI_GRID = np.linspace(-0.24, 0.24, 25)
STEP = 0.05 * MM  # [m] grid over the profile
REACH = 0.5 * MM  # [m] a minimum hides at most 3 STEP = 0.15 mm below its grid points on a 70 deg flank
ROUNDING = 4e-16  # relative precision at which root searches stop


def profile_grid(wheel, step=STEP):
    """Dense grid over the profile, every zone with both its ends: y (n,) [m] and the
    zone of each point (n,)."""
    grids = [np.linspace(a, b, int((b - a) * MM / step) + 2) * MM for a, b in wheel.ends]
    return np.concatenate(grids), np.repeat(np.arange(len(grids)), [len(g) for g in grids])


def lowest_around(system, pose, y, zone, precision=1e-17):
    """phi (n,) at which the gap over the circle at each y is smallest: grid, then the
    root of d gap / d phi."""
    grid = vertical_gap(system, pose, PHI_GRID[:, None], y, zone)[0]
    k = np.clip(np.argmin(grid, axis=0), 1, len(PHI_GRID) - 2)

    def slope(phi, y, zone):
        return vertical_gap(system, pose, phi, y, zone.astype(int))[1]

    found = find_root(
        slope,
        (PHI_GRID[k - 1], PHI_GRID[k + 1]),
        args=(y, zone),
        tolerances=dict(xatol=precision, xrtol=ROUNDING),
    )
    return np.where(found.success, found.x, PHI_GRID[k])


def local_minima(system, pose):
    """Local minima of the vertical gap of the right wheel, within REACH of the
    lowest: gap, phi, y_wheel, zone.

    Along the profile the gap is taken at its smallest around each circle. A minimum is a place where its
    derivative turns from falling to rising inside a zone, or an end of a zone that the gap falls towards.
    """
    y, zone = profile_grid(system.wheel)
    phi = lowest_around(system, pose, y, zone, precision=1e-9)
    gap, _, slope, _ = vertical_gap(system, pose, phi, y, zone)
    near = gap < gap.min() + REACH
    start = np.r_[True, zone[1:] != zone[:-1]]
    end = np.r_[start[1:], True]
    turn = np.flatnonzero(near[:-1] & (slope[:-1] < 0) & (slope[1:] >= 0) & ~end[:-1])
    edge = np.flatnonzero(near & ((start & (slope >= 0)) | (end & (slope <= 0))))
    y, zone = (
        np.r_[refine(system, pose, y[turn], y[turn + 1], zone[turn]), y[edge]],
        np.r_[zone[turn], zone[edge]],
    )
    phi = lowest_around(system, pose, y, zone)
    return vertical_gap(system, pose, phi, y, zone)[0], phi, y, zone


def refine(system, pose, left, right, zone):
    """Minimum in each bracket [left, right] of the profile: root of d gap / d y with
    phi kept at its own minimum."""

    def slope(y, zone):
        zone = zone.astype(int)
        return vertical_gap(system, pose, lowest_around(system, pose, y, zone), y, zone)[2]

    tolerances = dict(xatol=1e-17, xrtol=ROUNDING)
    return find_root(slope, (left, right), args=(zone,), tolerances=tolerances).x if len(left) else left


def smallest_gap(system, pose):
    """The global minimum: gap, phi, y_wheel, zone."""
    minima = local_minima(system, pose)
    k = np.argmin(minima[0])
    return tuple(value[k] for value in minima)


# --------------------------------------------------------------------------------------------------- wheelset


@dataclass(frozen=True)
class Contact:
    """Rigid contact point of one wheel. y_wheel, y_rail to the field side on both sides;
    y_track to the right."""

    x_wheel: float
    y_wheel: float
    z_wheel: float
    y_rail: float
    z_rail: float
    x_track: float
    y_track: float
    z_track: float
    contact_angle: float  # positive towards the flange
    rolling_radius: float


@dataclass(frozen=True)
class Wheelset:
    """Rigid equilibrium of the wheelset."""

    lateral_shift: float
    yaw: float
    roll: float
    vertical_shift: float
    left: Contact
    right: Contact


ROLL_RANGE = 0.03  # [rad]


def equilibrium_roll(system, lateral_shift, yaw, left=None):
    """Roll at which the smallest gaps of both wheels agree [rad]; their difference
    falls steadily with roll."""
    left = left or system

    def difference(roll):
        pose = Pose(lateral_shift, yaw, roll)
        return smallest_gap(system, pose)[0] - smallest_gap(left, pose.mirrored())[0]

    return brentq(difference, -ROLL_RANGE, ROLL_RANGE, xtol=1e-16, rtol=1e-15)


def rigid_contact(system, lateral_shift, yaw=0.0, left=None):
    """Rigid equilibrium of the wheelset at a lateral shift [m] and yaw [rad]; ``left`` is the
    left side as a right one, where it differs."""
    left = left or system
    roll = equilibrium_roll(system, lateral_shift, yaw, left)
    pose = Pose(lateral_shift, yaw, roll)
    on_right, on_left = smallest_gap(system, pose), smallest_gap(left, pose.mirrored())
    shift = float(min(on_right[0], on_left[0]))
    return Wheelset(
        lateral_shift,
        yaw,
        roll,
        shift,
        left=contact(left, Pose(lateral_shift, yaw, roll, shift).mirrored(), *on_left[1:], side=-1),
        right=contact(system, Pose(lateral_shift, yaw, roll, shift), *on_right[1:], side=+1),
    )


def contact(system, pose, phi, y, zone, side):
    """The contact at (phi, y) of a wheel posed as a right wheel, in every frame; side +1 right, -1 left."""
    z = system.wheel(y, zone)[0]
    radius = system.nominal_radius + z
    x_track, y_track, z_track = wheel_surface(system, pose, phi, y, zone)[0]
    y_rail = y_track - system.rail_origin
    z_rail, slope, _ = system.rail(y_rail)
    # z_track is the wheel's point: on the rail, rail_depth below z_rail
    values = (
        radius * sin(phi),
        y,
        radius * cos(phi) - system.nominal_radius,
        y_rail,
        z_rail,
        x_track,
        side * y_track,
        z_track,
        -atan(slope),
        radius,
    )
    return Contact(*map(float, values))
