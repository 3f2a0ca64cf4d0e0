"""Witnesses for outputs that follow the motion of the wheelset and that friction gives: finite displacements,
Polach's formula in numpy, or friction times pressure where all slides, and vector sums; a part of
output_witnesses.py."""

import json
from math import cos, hypot, pi, sin

import numpy as np

from tests.helpers.motion import creepages, sliding
from tests.helpers.paths import DATA
from wrcontact import ContactSystem

EXACT = 1e-9
#: Between its nodes Kalker's table is a straight line here and smooth in the kernel [share of mu N].
OF_FORCE = 0.005
#: How much the slip and its direction change over a patch where all slides.
OF_SLIDING = 0.01
#: How far strips, at which tractions act, lie beside the plane through the centre of load, over the width:
#: the outputs have one place for a patch.
OF_BOW = 0.01
#: The middles of sixteen strips miss this share of the largest pressure, and the lines between them that.
OF_LARGEST, OF_STATION = 0.05, 0.1
YOUNG, POISSON = 210e9, 0.28
#: Kalker's table E3: C11, C22, C23 by (a < b or a > b, ratio 0.1 ... 1, coefficient, Poisson's ratio 0, 0.25,
#: 0.5).
KALKER = np.array(json.loads((DATA / "creep" / "kalker_cij.json").read_text())["table"])


def kalker(a, b, nu):
    """C11, C22, C23 of an ellipse a along, b across: 1/C linear in ln(a/b) and a parabola in nu."""
    nodes = np.array([0.0, 0.25, 0.5])
    weights = [np.prod([(nu - other) / (node - other) for other in nodes if other != node]) for node in nodes]
    ratios = np.arange(1, 11) / 10
    rows = 1.0 / KALKER[0 if a < b else 1] @ weights
    at = np.log(min(a / b, b / a))
    return np.array([1.0 / np.interp(at, np.log(ratios), rows[:, k]) for k in range(3)])


def polach(*, a, b, load, friction, shear_modulus, nu, x, y, spin):
    """Force (2,) on the wheel [N] of an ellipse with the creepages x, y [1] and spin [1/m]: O. Polach, A fast
    wheel-rail forces calculation computer code, Vehicle System Dynamics Supplement 33 (1999) 728-739.

    The frame is x forward, y across, spin about x times y; creepages are those of the wheel.
    """
    c11, c22, c23 = kalker(a, b, nu)
    bound = friction * load
    lateral = y + spin * a if abs(y + spin * a) > abs(y) else y
    whole = np.hypot(x, lateral)
    slope = np.hypot(c11 * x, c22 * y) / np.hypot(x, y)
    epsilon = np.pi * a * b * shear_modulus * slope * whole / (4.0 * bound)
    push = 2.0 * bound / np.pi * (epsilon / (1.0 + epsilon**2) + np.arctan(epsilon))
    wide = 1.0 + 6.3 * (1.0 - np.exp(-a / b))
    of_spin = 8.0 / 3.0 * shear_modulus * b * np.sqrt(a * b) * c23 * whole / (bound * wide)
    delta = (of_spin**2 - 1.0) / (of_spin**2 + 1.0)
    k = of_spin * (delta**3 / 3 - delta**2 / 2 + 1 / 6) - (1.0 - delta**2) ** 1.5 / 3.0
    force = -push / whole * np.array([x, y]) + [0.0, 9.0 / 16.0 * a * bound * k * wide * spin / whole]
    return force * min(1.0, bound / np.hypot(*force))


def equilibrium(name):
    """Of a wheelset that is told its height and roll: where an elastic one stands under the load; of others
    their own."""

    def witness(scene):
        value = scene.values[name]
        if scene.mode == "compliant":
            load = {key: scene.inputs[key] for key in ("lateral_shift", "yaw", "normal_force")}
            value = getattr(ContactSystem(contact_mode="elastic").evaluate(**load), name)
        yield value, 1e-12

    return witness


def motion(wheel, k):
    """What :func:`tests.helpers.motion.sliding` asks for, of patch ``k``."""
    given = wheel.inputs
    names = {
        "lateral": "lateral_velocity",
        "vertical": "vertical_velocity",
        "yaw_rate": "yaw_rate",
        "roll_rate": "roll_rate",
        "curvature": "track_curvature",
    }
    return dict(
        place=[wheel[f"patch[{k}].{axis}_track"] for axis in "xyz"],
        sign=wheel.sign,
        radius=wheel[f"patch[{k}].rolling_radius"],
        centre=wheel.centre,
        angle=wheel[f"patch[{k}].contact_angle"],
        yaw=given["yaw"],
        roll=wheel.values["roll"],
        speed=given["speed"],
        wheel_rate=given["wheel_rate"],
        **{name: given[key] for name, key in names.items()},
    )


def patch_creepage(index):
    """Of the wheel's surface that is moved with the wheelset; none of a wheelset that stands still."""

    def witness(wheel, k):
        if not wheel.inputs.get("speed"):
            yield 0.0, 0.0
            return
        yield creepages(**motion(wheel, k))[index], 1e-6

    return witness


def patch_moves(wheel, k):
    """Velocity of the wheel's surface against the rail (3,) [m/s], and rotation about the normal [rad/s]."""
    slide, _, turning, _ = sliding(**motion(wheel, k))
    return slide, turning


def friction(wheel):
    """The coefficient of friction of a wheel that has creep forces, else None."""
    rolls = wheel.inputs.get("speed") and wheel.tangential != "none"
    return wheel.inputs[f"{wheel.side}.friction"] if rolls else None


def slides(wheel):
    """Whether the scene is one in which all slides; the others have Polach's formula."""
    return wheel.tangential == "fastsim"


def of_patch(wheel, k, *names):
    return [wheel[f"patch[{k}].{name}"] for name in names]


def axes(wheel, k):
    """Directions of tangential.x, of tangential.y and of the normal from the rail to the wheel (3, 3)."""
    angle = wheel[f"patch[{k}].contact_angle"]
    sine, cosine = sin(angle), cos(angle)
    return np.array([[1.0, 0.0, 0.0], [0.0, wheel.sign * cosine, -sine], [0.0, -wheel.sign * sine, -cosine]])


def axle(wheel):
    """Direction of the axle to the right, not mirrored (3,)."""
    yaw, roll = wheel.sign * wheel.yaw, wheel.sign * wheel.roll
    return np.array([-sin(yaw) * cos(roll), cos(yaw) * cos(roll), sin(roll)])


def creep_vectors(wheel, k):
    """Creep force of a patch, and its moment about the wheelset's centre, by its own outputs (2, 3); about
    the axle the arm of the force is the rolling radius."""
    x, y, moment = of_patch(wheel, k, "tangential.x", "tangential.y", "tangential.moment")
    along, outside, normal = axes(wheel, k)
    force = x * along + y * outside
    arm = np.array(of_patch(wheel, k, "x_track", "y_track", "z_track")) - wheel.centre
    turned, around = np.cross(arm, force), axle(wheel)
    longer = wheel[f"patch[{k}].rolling_radius"] / np.linalg.norm(np.cross(around, arm)) - 1.0
    return np.array([force, turned + longer * (turned @ around) * around + moment * normal])


def side_creep(wheel):
    """Creep force and moment of a wheel, the sum over its patches (2, 3)."""
    return sum((creep_vectors(wheel, k) for k in range(1, wheel.count + 1)), np.zeros((2, 3)))


def patch_bowed(wheel, k):
    """What the moment of a patch's creep force may miss where tractions act at strips [N m]; Polach's formula
    knows none."""
    force = np.linalg.norm(creep_vectors(wheel, k)[0])
    return OF_BOW * force * wheel[f"patch[{k}].width"] * slides(wheel)


def bowed(wheel):
    """The same of a wheel."""
    return sum(patch_bowed(wheel, k) for k in range(1, wheel.count + 1))


def expected_force(wheel, k):
    """(tangential.x, tangential.y): friction times load against the slip, or by Polach's formula."""
    if slides(wheel):
        slide, _ = patch_moves(wheel, k)
        along = np.array([slide @ axis for axis in axes(wheel, k)[:2]])
        return -friction(wheel) * wheel[f"patch[{k}].normal_force"] * along / np.hypot(*along)
    load, area, length, width = of_patch(wheel, k, "normal_force", "area", "length", "width")
    x, y, spin = of_patch(wheel, k, "creepage.x", "creepage.y", "creepage.spin")
    # the ellipse with the area of the patch, and its length over its width
    a, b = (np.sqrt(area / pi * ratio) for ratio in (length / width, width / length))
    # seen to the field side, and about the normal into the rail, on the right wheel
    return polach(
        a=a,
        b=b,
        load=load,
        friction=friction(wheel),
        shear_modulus=YOUNG / (2 * (1 + POISSON)),
        nu=POISSON,
        x=x,
        y=-wheel.sign * y,
        spin=-wheel.sign * spin,
    )


def zero_without_friction(witness):
    def zero_or(wheel, *place):
        if friction(wheel) is None:
            yield 0.0, 0.0
        else:
            yield from witness(wheel, *place)

    return zero_or


def tangential(index):
    @zero_without_friction
    def witness(wheel, k):
        yield expected_force(wheel, k)[index], OF_FORCE * friction(wheel) * wheel[f"patch[{k}].normal_force"]

    return witness


@zero_without_friction
def moment(wheel, k):
    """Polach's formula knows none; where all slides tractions are as the pressure, and the moment is about
    the centre of load."""
    if slides(wheel):
        load, area = of_patch(wheel, k, "normal_force", "area")
        yield 0.0, OF_SLIDING * friction(wheel) * load * np.sqrt(area)
    else:
        yield 0.0, 0.0


def stick_share(wheel, k):
    """Nothing sticks, or Polach's formula does not know it."""
    yield 0.0, 0.0


@zero_without_friction
def max_shear(wheel, k):
    """Of tractions that are spread as the pressure of the ellipse, or friction times the largest pressure."""
    load, area = of_patch(wheel, k, "normal_force", "area")
    if slides(wheel):
        largest = friction(wheel) * wheel[f"patch[{k}].max_pressure"]
        yield largest, OF_LARGEST * largest
    else:
        yield 1.5 * hypot(*expected_force(wheel, k)) / area, 1.5 * OF_FORCE * friction(wheel) * load / area


@zero_without_friction
def shear(wheel, j):
    """Friction times the mean of the pressure along the patch, which is an ellipse's; Polach's formula does
    not know it.  At the edges it follows straight lines."""
    pressures = [wheel[f"pressure[{i}]"] for i in range(1, 32)]
    mean = friction(wheel) * pi / 4.0 * wheel[f"pressure[{j}]"] * slides(wheel)
    yield mean, slides(wheel) * friction(wheel) * OF_STATION * max(pressures)


@zero_without_friction
def slip(wheel, j):
    """The velocity of the wheel's surface where all slides; spin and the wheel's profile change it little."""
    if slides(wheel) and wheel[f"pressure[{j}]"] > 0.0:
        value = np.linalg.norm(patch_moves(wheel, 1)[0])
        yield value, OF_SLIDING * value
    else:
        yield 0.0, 0.0


@zero_without_friction
def saturation(wheel, k):
    yield hypot(*expected_force(wheel, k)) / (friction(wheel) * wheel[f"patch[{k}].normal_force"]), OF_FORCE
    yield (
        hypot(*of_patch(wheel, k, "tangential.x", "tangential.y"))
        / (friction(wheel) * wheel[f"patch[{k}].normal_force"]),
        EXACT,
    )


def of_fatigue(value, margin):
    """A witness of an output of fatigue, zero where a scene does not ask for it: ``value`` of T gamma [N],
    utilised friction [1] and the peak of an ellipse [Pa], over the yield stress in shear [Pa]."""

    def witness(wheel, k):
        yielding = wheel.yield_shear
        if not yielding or k > wheel.count:
            yield 0.0, 0.0
            return
        x, y, slip_x, slip_y, load, area = of_patch(
            wheel, k, "tangential.x", "tangential.y", "creepage.x", "creepage.y", "normal_force", "area"
        )
        number = abs(x * slip_x) + abs(y * slip_y)
        yield value(number, hypot(x, y) / load, 1.5 * load / area, yielding), margin

    return witness


def damage(number, *_):
    """Lines through the corners of the figure, at 20, 65 and 175 N; its formulas miss them by 1e-8."""
    return np.interp(number, [20.0, 65.0, 175.0], [0.0, 9.99e-6, 0.0])


def power(wheel, k):
    """Of the creep force and its moment on the wheel's surface, which is moved with the wheelset."""
    slide, turning = patch_moves(wheel, k)
    force = creep_vectors(wheel, k)[0]
    return -(force @ slide + wheel[f"patch[{k}].tangential.moment"] * turning)


def power_missed(wheel, k):
    """Velocities by differences [W], and strips that slide otherwise than the patch's plane as it turns."""
    return 1e-5 * abs(power(wheel, k)) + 1e-3 + patch_bowed(wheel, k) * abs(patch_moves(wheel, k)[1])


@zero_without_friction
def patch_power(wheel, k):
    yield power(wheel, k), power_missed(wheel, k)


@zero_without_friction
def side_power(wheel):
    patches = range(1, wheel.count + 1)
    yield sum(power(wheel, k) for k in patches), sum(power_missed(wheel, k) for k in patches)


@zero_without_friction
def wear_number(wheel):
    value = sum(
        abs(
            np.multiply(
                of_patch(wheel, k, "tangential.x", "tangential.y"),
                of_patch(wheel, k, "creepage.x", "creepage.y"),
            )
        ).sum()
        for k in range(1, wheel.count + 1)
    )
    yield value, EXACT * value


def side_torque(wheel):
    """About the axle, which is yawed and rolled; a wheel turns forward against the axle's direction to the
    right."""
    moment = side_creep(wheel)[1]
    yield -moment @ axle(wheel), EXACT * 1e3 + EXACT * np.abs(moment).max() + bowed(wheel)


def wheel_rate(wheel):
    """That of the inputs; nothing turns without one in these scenes."""
    yield wheel.inputs.get("wheel_rate", 0.0), 0.0


def driving_torque(scene):
    """That of both wheels."""
    parts = [next(side_torque(wheel)) for wheel in scene.wheels.values()]
    yield sum(torque for torque, _ in parts), sum(tolerance for _, tolerance in parts)
