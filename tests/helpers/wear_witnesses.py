"""Witnesses for the outputs of wear and of damping: arc lengths along the rail, points of the wheel on the
rail's normals, and power that is spread like the pressure; a part of output_witnesses.py."""

from math import pi

import numpy as np

from tests.helpers import creep_witnesses as creep
from tests.helpers.motion import velocity
from tests.helpers.overlap import overlap

EXACT = 1e-9
#: Places on a rail whose arc length is summed from 2e-6 m, and on a wheel whose ridge is sought in steps of
#: 5e-5 m along the track, 1 um across at 20 mrad of yaw; a rigid wheel sinks by an estimate [m].
OF_RAIL, OF_WHEEL = 2e-7, 1e-5
#: Shares of a patch's largest power: strips and stations are as far from each other.
OF_POWER = 0.12
#: Share of the wheel's width by which the edges of patches differ from the half-space's.
OF_EDGE = 0.18
STATIONS = 31


def damping_power(wheel):
    """What the damped forces take more than the elastic ones, N / (1 + d a), at the approach a."""
    damping = wheel.damping
    total = missed = 0.0
    for k in range(1, wheel.count + 1):
        if damping:
            given, load = creep.motion(wheel, k), wheel[f"patch[{k}].normal_force"]
            moves = {
                name: given[name]
                for name in ("centre", "yaw", "roll", "lateral", "vertical", "yaw_rate", "roll_rate")
            }
            normal = [0.0, wheel.sign * np.sin(given["angle"]), np.cos(given["angle"])]
            approach = velocity(given["place"], **moves) @ normal
            power = load * approach * (1.0 - 1.0 / (1.0 + damping * approach))
            total, missed = total + power, missed + 1e-3 * power
    yield total, missed


def derailment_quotient(wheel):
    """Of its own force, and without friction of the angles of the patches."""
    yield wheel.sign * wheel["force.y"] / wheel["force.z"], EXACT
    if creep.friction(wheel) is None:
        down, angles = (
            np.array([wheel[f"patch[{k}].{name}"] for k in range(1, wheel.count + 1)])
            for name in ("force.z", "contact_angle")
        )
        yield down @ np.tan(angles) / down.sum(), EXACT


def zero_without_wear(witness):
    def zero_or(wheel, j):
        if wheel.worn:
            yield from witness(wheel, j)
        else:
            yield 0.0, 0.0

    return zero_or


def rail_abscissa(wheel, j):
    """The rail's abscissa [m] at the arc length of a station, or of Hertz's ellipse in the contact plane."""
    station, start = wheel[f"station[{j}]"], wheel.contact.y_rail
    if wheel.model == "hertz" and not wheel.pressed:
        return start + station * np.cos(wheel.contact.contact_angle)
    y = start + np.sign(station) * np.arange(0.0, abs(station) + 4e-6, 2e-6)
    speed = np.hypot(1.0, wheel.system.rail(0.5 * (y[1:] + y[:-1]))[1])
    return np.interp(abs(station), np.concatenate([[0.0], np.cumsum(speed * 2e-6)]), y)


@zero_without_wear
def rail_place(wheel, j):
    yield rail_abscissa(wheel, j), OF_RAIL


@zero_without_wear
def wheel_place(wheel, j):
    """Where the wheel overlaps most along the track, on the rail's normal."""
    abscissa = rail_abscissa(wheel, j)
    x = wheel.contact.x_track + np.linspace(-0.03, 0.03, 1201)
    pose = wheel.pose if wheel.model == "hertz" else wheel.under_load
    depth = overlap(wheel.system, pose, x, np.array(abscissa), 12)
    place = wheel.wheel_point(x[np.argmax(depth)], abscissa, pose)[1] - wheel.system.half_distance
    yield place, OF_WHEEL


@zero_without_wear
def power(wheel, j):
    """Of its patch, as the line load is; and what the others leave of the friction power of the wheel."""
    places, powers = (
        np.array([wheel[f"{name}[{i}]"] for i in range(1, STATIONS + 1)]) for name in ("station", "power")
    )
    weights = np.gradient(places) * np.where(np.isin(np.arange(STATIONS), (0, STATIONS - 1)), 0.5, 1.0)
    others = powers @ weights - powers[j - 1] * weights[j - 1]
    allowed = 1e-12 * max(wheel["friction_power"], 1e-300) / weights.min()
    yield (wheel["friction_power"] - others) / weights[j - 1], allowed
    if creep.friction(wheel) is None:
        yield 0.0, 0.0
        return
    line = (
        0.5
        * pi
        * np.array([wheel[f"half_length[{i}]"] * wheel[f"pressure[{i}]"] for i in range(1, STATIONS + 1)])
    )
    # means under the hat functions of a broken line
    line = np.convolve(np.pad(line, 1), (1.0, 4.0, 1.0), "valid") / 6.0 * np.gradient(places) / weights
    k = int(wheel[f"patch_of[{j}]"])
    share = wheel[f"patch[{k}].friction_power"] / wheel[f"patch[{k}].normal_force"]
    yield share * line[j - 1], OF_POWER * share * line.max()


@zero_without_wear
def patch_of(wheel, j):
    """The patch of the theory that is nearest; near the middle between two it may be either."""
    station = wheel[f"station[{j}]"]
    away = np.array([max(patch.start - station, station - patch.stop, 0.0) for patch in wheel.carried])
    order = np.argsort(away, kind="stable")
    close = len(order) > 1 and away[order[1]] - away[order[0]] < OF_EDGE * wheel["patch_width"]
    yield 1 + order[0], abs(order[1] - order[0]) if close else 0
