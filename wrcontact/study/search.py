"""The source's searches on fixed nodes: chapter 4 without yaw, chapter 5 with it.

Both roll the wheelset until the smallest vertical distances of the two wheels are equal::

    wheel and rail as nodes  ->  smallest distance of each wheel    ProfileMatrix.lowest, (4.2), (4.3)
    equal distances  ->  roll, by steps of source eq. (4.6)         balance

All is written for a right wheel; the left one comes in mirrored (conventions.MIRROR). The profiles are the
kernel's own tables, so a search can differ from the exact one by its method only.
"""

import math
from dataclasses import dataclass, replace
from math import cos, hypot, sin, sqrt

import numpy as np

from ..conventions import MIRROR, SIDES
from ..profiles.compiled import ends, evaluate_table

#: y_wheel that parts contacts in the flange root of S1002 (to -34.4 mm) from those on its
#: flange (from -38.4 mm) [m].
FLANGE = -36.5e-3
#: A roll beyond this is no wheelset on its track any more [rad]; 12 mm of lateral shift need 0.013.
ROLL_LIMIT = 0.12
STEP_LIMIT = 400


@dataclass(frozen=True)
class Pose:
    """Pose of a wheel seen as a right one: lateral shift [m], yaw [rad], roll [rad]."""

    lateral_shift: float
    yaw: float
    roll: float = 0.0

    def of(self, side):
        """This wheelset's pose as that of the ``side`` wheel, mirrored if it is the left one."""
        return (
            self
            if side == "right"
            else Pose(
                *(sign * value for sign, value in zip(MIRROR, (self.lateral_shift, self.yaw, self.roll)))
            )
        )


class Surfaces:
    """Profiles, places and radius of ``system``.

    Attributes
    ----------
    radius, arm : nominal radius, and half the distance of the running circles [m].
    rail_y : lateral track coordinate of the right rail's highest point [m].
    wheel_ends, rail_ends : first and last abscissa of the profiles (2,) [m].
    """

    def __init__(self, system):
        chosen = system.parameters
        self.radius, self.arm = chosen["nominal_radius"], 0.5 * chosen["running_circle_distance"]
        self._wheel, self._rail, self.rail_y = system.profile_tables()
        self.wheel_ends, self.rail_ends = ends(self._wheel), ends(self._rail)

    def wheel(self, y):
        """Height [m] and slope [-] of the wheel profile at ``y`` [m], two arrays of its shape."""
        return evaluate_table(self._wheel, y)[:2]

    def rail(self, y):
        """Height [m] and slope [-] of the placed rail's profile at ``y`` [m]."""
        return evaluate_table(self._rail, y)[:2]

    def reach(self, yaw):
        """How far ahead of or behind its principal profile the wheel can touch at ``yaw``,
        whatever the contact [m]."""
        y = np.linspace(*self.wheel_ends, 2001)
        return self.radius * min(1.0, abs(math.tan(yaw)) * 1.05 * np.abs(self.wheel(y)[1][20:-20]).max())


def profile_nodes(ends, spacing):
    """Multiples of ``spacing`` [m] between ``ends`` (2,)."""
    first, last = math.ceil(ends[0] / spacing + 1e-9), math.floor(ends[1] / spacing - 1e-9)
    return spacing * np.arange(first, last + 1)


@dataclass(frozen=True)
class Lowest:
    """The smallest gap [m] of a wheel, and where it is (x_wheel, y_wheel, y_rail, y_axle) [m].

    ``y_axle`` is its distance from the wheelset's centre along the yawed, unrolled axle.
    """

    gap: float
    x_wheel: float
    y_wheel: float
    y_rail: float
    y_axle: float


class ProfileMatrix:
    """The wheel cut by planes across its axle at x (n,), each a profile at y (m,):
    source eqs. (5.10), (5.11).

    ``R_n(y) = R_0(y) cos(alpha_n)``, ``sin(alpha_n) = x_n / R_0(y)``; the 2-D search has x = 0 alone.
    """

    CHUNK = 2**17  #: gaps at a time, to stay in the cache

    def __init__(self, surfaces, rail, x, y):
        self.surfaces, self.x, self.y = surfaces, np.atleast_1d(np.asarray(x, dtype=float)), y
        self.rail = rail
        R0 = surfaces.radius + surfaces.wheel(y)[0]
        self.heights = np.sqrt(R0**2 - self.x[:, None] ** 2)  # (n, m), below the axle

    def lowest(self, pose, mapping=1.0):
        """The smallest of source eq. (5.13)'s distances at ``pose``, as (5.14) asks for; a :class:`Lowest`.

        The matrix is rolled about the axle's centre; the rail, a polyline (2, k), is read below each node.
        ``mapping`` stretches the rail's abscissa about its top, for source eq. (5.12) as printed. The gap is
        infinite beside the rail.
        """
        best = Lowest(math.inf, math.nan, math.nan, math.nan, math.nan)
        rows = max(1, self.CHUNK // len(self.y))
        for first in range(0, len(self.x), rows):
            gap, abscissa, along = self._gaps(pose, slice(first, first + rows), mapping)
            row, column = np.unravel_index(np.argmin(gap), gap.shape)
            if gap[row, column] < best.gap:
                best = Lowest(
                    *map(
                        float,
                        (
                            gap[row, column],
                            self.x[first + row],
                            self.y[column],
                            abscissa[row, column],
                            along[row, column],
                        ),
                    )
                )
        return best

    def _gaps(self, pose, rows, mapping):
        c, s = math.cos(pose.roll), math.sin(pose.roll)
        heights, arm = self.heights[rows], self.surfaces.arm + self.y
        along = c * arm - s * heights  # y_w of source fig. 5.2
        depth = s * arm + c * heights - self.surfaces.radius
        lateral = pose.lateral_shift + math.sin(pose.yaw) * self.x[rows, None] + math.cos(pose.yaw) * along
        abscissa = lateral - self.surfaces.rail_y
        heights = np.interp(mapping * abscissa, *self.rail, left=math.inf, right=math.inf)
        return heights - depth, abscissa, along


def rail_polyline(surfaces, spacing):
    """Abscissae and heights (2, n) [m] of the rail's nodes at multiples of ``spacing`` [m]."""
    y = profile_nodes(surfaces.rail_ends, spacing)
    return np.array([y, surfaces.rail(y)[0]])


# --- searches --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Contact:
    """Where a wheel touches [m]: ahead of the principal profile, on the wheel
    profile, on the rail profile."""

    x_wheel: float = math.nan
    y_wheel: float = math.nan
    y_rail: float = math.nan


@dataclass(frozen=True)
class Result:
    """What a search found.

    Attributes
    ----------
    roll, vertical_shift : [rad, m], as :class:`~wrcontact.state.WheelsetState`.
    left, right : :class:`Contact`.
    steps : how often the roll was changed or confirmed.
    gap_evaluations : points of a wheel that were held against the rail.
    converged : whether the search's own tolerance was met.
    remark : "" or, in a clause, what is known to be wrong.
    """

    roll: float
    vertical_shift: float
    left: Contact
    right: Contact
    steps: int
    gap_evaluations: int
    converged: bool
    remark: str = ""


def balance(matrices, pose, *, gain, tolerance, mapping=1.0, step_limit=STEP_LIMIT):
    """Roll at which both wheels' smallest distances differ by less than ``tolerance`` [m]; a :class:`Result`.

    ``Delta theta = K atan((mindist_L - mindist_R) / (y_minL - y_minR))``, source eqs.
    (4.5)-(4.7) and (5.15). It prints a minus in front of K; with the roll counted from y to z
    that turns the wheelset away from the answer.

    Parameters
    ----------
    matrices : by side, one or more :class:`ProfileMatrix`; the smallest distance is that of all of them.
    pose : :class:`Pose`, its roll theta_init.
    gain : K > 0; 1.2 in the source.
    mapping : of the rail's abscissa.
    """
    evaluations, roll, remark = 0, pose.roll, f"no convergence in {step_limit} steps"
    for step in range(1, step_limit + 1):
        here = Pose(pose.lateral_shift, pose.yaw, roll)
        left, right = (
            min(
                (matrix.lowest(here.of(side), mapping) for matrix in matrices[side]),
                key=lambda found: found.gap,
            )
            for side in SIDES
        )
        evaluations += sum(matrix.heights.size for side in SIDES for matrix in matrices[side])
        if not (math.isfinite(left.gap) and math.isfinite(right.gap)):
            remark = "no node of a wheel is above its rail"
            break
        difference = left.gap - right.gap
        if abs(difference) < tolerance:
            return _result(roll, left, right, step, evaluations, True, "")
        roll += gain * math.atan(difference / -(left.y_axle + right.y_axle))
        if not abs(roll) < ROLL_LIMIT:
            remark = f"the roll left +-{ROLL_LIMIT:g} rad"
            break
    return _result(roll, left, right, step, evaluations, False, remark)


def _result(roll, left, right, steps, evaluations, converged, remark):
    contacts = (Contact(found.x_wheel, found.y_wheel, found.y_rail) for found in (left, right))
    return Result(roll, min(left.gap, right.gap), *contacts, steps, evaluations, converged, remark)


class Search2D:
    """The source's search without yaw, its chapter 4: principal profiles alone.

    Parameters
    ----------
    system : :class:`~wrcontact.system.ContactSystem`.
    spacing : of the nodes on wheel and rail [m].
    gain : K of source eq. (4.6).
    tolerance : of the distances, source eq. (4.5) [m]; the source has 1e-6 ... 1e-7.
    """

    def __init__(self, system, spacing=1e-4, gain=1.2, tolerance=1e-7):
        self.surfaces = Surfaces(system)
        self.gain, self.tolerance = gain, tolerance
        rail = rail_polyline(self.surfaces, spacing)
        matrix = ProfileMatrix(self.surfaces, rail, 0.0, profile_nodes(self.surfaces.wheel_ends, spacing))
        self._matrices = {side: (matrix,) for side in SIDES}

    def solve(self, lateral_shift=0.0, yaw=0.0, roll=0.0):
        """:class:`Result` at ``lateral_shift`` [m]; ``yaw`` is not seen, ``roll`` [rad] is
        where the steps begin."""
        return balance(
            self._matrices, Pose(lateral_shift, 0.0, roll), gain=self.gain, tolerance=self.tolerance
        )


class Search3D:
    """The source's search with yaw, its chapter 5: a matrix of profiles on each side.

    The 2-D search gives the roll to begin with, and contact angle and radius for Wang's shift, which is how
    far along the wheel the profiles reach (source eqs. (5.8), (5.9)): to one side only, ahead on the right
    wheel for a positive yaw.

    Parameters
    ----------
    system : :class:`~wrcontact.system.ContactSystem`.
    dx : distance of the profiles [m]; 1e-4, 5e-5 or 1e-5 in the source.
    spacing : of the nodes on wheel and rail [m]; not stated in the source.
    gain, tolerance : as for :class:`Search2D`; source eqs. (5.15), (4.5).
    profiles : so many of them on each side (201 is the source's example), or None for Wang's limit.
    as_printed : take source eq. (5.12) as printed, Z_r(s / cos psi), for the section of a yawed plane with
        the rail; right is Z_r(s cos psi), s from the top of the rail along the section.
    """

    def __init__(
        self, system, dx=1e-4, spacing=1e-4, gain=1.2, tolerance=1e-7, profiles=None, as_printed=False
    ):
        self.surfaces = Surfaces(system)
        self.dx, self.gain, self.tolerance = dx, gain, tolerance
        self.profiles, self.as_printed = profiles, as_printed
        self._plane = Search2D(system, spacing, gain, tolerance)
        self._rail = rail_polyline(self.surfaces, spacing)
        self._nodes = profile_nodes(self.surfaces.wheel_ends, spacing)

    def solve(self, lateral_shift=0.0, yaw=0.0):
        """:class:`Result` at ``lateral_shift`` [m] and ``yaw`` [rad]; its counts include the 2-D search."""
        plane = self._plane.solve(lateral_shift)
        pose = Pose(lateral_shift, yaw, plane.roll if plane.converged else 0.0)
        rows = {side: self._rows(pose.of(side), getattr(plane, side)) for side in SIDES}
        matrices = {
            side: (ProfileMatrix(self.surfaces, self._rail, rows[side], self._nodes),) for side in SIDES
        }
        mapping = math.cos(yaw) ** -2 if self.as_printed else 1.0
        found = balance(matrices, pose, gain=self.gain, tolerance=self.tolerance, mapping=mapping)
        at_end = [
            side for side in SIDES if len(rows[side]) > 1 and getattr(found, side).x_wheel == rows[side][-1]
        ]
        remark = found.remark or (
            f"smallest gap in the last profile ({' and '.join(at_end)})" if at_end else ""
        )
        return replace(
            found,
            steps=plane.steps + found.steps,
            remark=remark,
            gap_evaluations=plane.gap_evaluations + found.gap_evaluations,
        )

    def _rows(self, pose, estimate):
        """Where the profiles of a right wheel at ``pose`` are cut [m], by the 2-D
        ``estimate`` of its contact."""
        if pose.yaw == 0.0 or not math.isfinite(estimate.y_wheel):
            return np.zeros(1)
        count = self.profiles
        if count is None:
            height, slope = self.surfaces.wheel(np.array(estimate.y_wheel))
            limit = longitudinal_limit(
                self.surfaces.radius + float(height), -float(slope), roll=pose.roll, yaw=pose.yaw
            )
            count = math.ceil(limit / self.dx) + 1
        return math.copysign(self.dx, pose.yaw) * np.arange(count)


def exact_result(system, lateral_shift=0.0, yaw=0.0):
    """The exact search of ``system`` as a :class:`Result`, to compare with."""
    state = system.evaluate(lateral_shift=lateral_shift, yaw=yaw, normal_force=0.0, outputs="geometry")
    points = (state.left.contact, state.right.contact)
    contacts = (Contact(point.x_wheel, point.y_wheel, point.y_rail) for point in points)
    return Result(state.roll, state.vertical_shift, *contacts, 0, 0, int(state.status) <= 1)


def lever_share(system, shift):
    """What the difference of the distances changes with roll, as a share of what source eq. (4.6)
    takes, y_R - y_L; no yaw.

    By the envelope theorem it is the sum of y - z tan(delta) over both wheels, the contact at (y, z)
    from the wheelset's centre (docs/theory, eq. 4.2); a step of eq. (4.6) multiplies the error
    that is left by 1 - K times the share.
    """
    state = system.evaluate(lateral_shift=shift, normal_force=0.0, outputs="geometry")
    arms = [abs(side.contact.y_track - shift) for side in (state.left, state.right)]
    centre = state.vertical_shift - system.parameters["nominal_radius"]
    lost = [
        (side.contact.z_track - centre) * math.tan(side.contact_angle) for side in (state.left, state.right)
    ]
    return 1.0 - sum(lost) / sum(arms)


def jump_to_flange(solve, low=5e-3, high=6.6e-3):
    """Smallest lateral shift [m] within 1 um at which ``solve(shift)`` has the right
    contact on the flange."""
    while high - low > 1e-6:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if solve(middle).right.y_wheel < FLANGE else (middle, high)
    return high


# ----------------------------------------------------------------------------------------------- Wang's shift


# Wang's shift of a yawed wheel's contact from its principal profile, source eqs. (5.1)-(5.7).
#
# The source's roll counts from z to y. With ours (right wheel down positive) sin(roll) changes sign, and the
# shift, which it takes from the contact to the principal profile in y and z but the other way round in x, is
# from the principal profile to the contact here. Two corrections of eq. (5.3), which the search does not use:
#
# * printed ``l_x^2 l_y tan(delta)``, right is ``l_x^2 l_z tan(delta)``;
# * the sign in front of the fraction; as printed the shift of a wheel without yaw would be 2 R.


def wang_shift(radius, tan_angle, *, roll, yaw):
    """Shift (x, y, z) [m] in the track frame from the principal profile's lowest point to the
    contact, of a right wheel.

    Parameters
    ----------
    radius : wheel radius R at the contact [m].
    tan_angle : tan(delta) of the wheel profile there, in the wheelset's frame, positive towards the flange.
    roll, yaw : theta, psi [rad].
    """
    R, t, theta, psi = radius, tan_angle, -roll, yaw
    lx, ly, lz = cos(theta) * sin(psi), cos(theta) * cos(psi), sin(theta)  # (5.5)-(5.7)
    m = sqrt(max(0.0, 1 - lx**2 * (1 + t**2)))  # (5.4)
    x = R * sin(theta) * sin(psi) + lx * R * t  # (5.1)
    y = R * sin(theta) * cos(psi) - R / (1 - lx**2) * (lx**2 * ly * t + lz * m)  # (5.2)
    z = R * cos(theta) + R / (1 - lx**2) * (lx**2 * lz * t - ly * m)  # (5.3), corrected
    return x, -y, -z


def longitudinal_limit(radius, tan_angle, *, roll, yaw):
    """How far along the wheel the source searches [m], source eqs. (5.8), (5.9): the
    shift's length in plan."""
    x, y, _ = wang_shift(radius, tan_angle, roll=roll, yaw=yaw)
    return hypot(x, y)
