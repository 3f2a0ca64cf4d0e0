"""Random wheelsets with two different sides over rails that are displaced and roll, while all moves, and
their mirror images."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import CREEP_MODELS, MODELS
from tests.helpers.fuzzing import INCLINATIONS, log_uniform
from tests.helpers.fuzzing import RAILS as RAIL_PROFILES
from wrcontact.interface.inputs import MOTION, RAILS

SIDES = ("left", "right")
MODES = ("rigid", "elastic", "compliant")
#: Inputs of the pose that change their sign in the mirror.
TURNED = ("lateral_shift", "yaw", "load_transfer", "roll_input")
#: [N] lighter wheels sink in by less than a contact's place, known to 1e-12 m, tells of their patches
LOADS = (1e3, 2e5)
SIGNS = {"lateral_velocity": -1, "yaw_rate": -1, "roll_rate": -1, "track_curvature": -1}


def motions(count, rng):
    """Velocities of all sizes up to the limits, of either sign, a third of them zero."""
    given = {}
    for row in MOTION:
        sizes = row.maximum * 10.0 ** rng.uniform(-12, 0, count) * rng.choice([-1.0, 0.0, 1.0], count)
        given[row.keyword] = (sizes != 0.0).astype(float) if row.switch else sizes
    return given


def mirrored_motion(motion):
    """The motion in the mirror along the track; rails change places."""
    found = {}
    for name, values in motion.items():
        other = name.replace("left", "?").replace("right", "left").replace("?", "right")
        sign = SIGNS.get(name, -1 if name.endswith(("lateral_velocity", "roll_velocity")) else 1)
        found[other] = sign * values
    return found


def creepages(side):
    return np.array([[patch.creepage.x, patch.creepage.y, patch.creepage.spin] for patch in side.patches])


def draw_wheelset(rng, mode):
    """Arguments of ContactSystem; pairs are (left, right)."""
    radius = rng.uniform(0.4, 0.52)
    pairs = dict(
        wheel=rng.choice(("S1002", "S1002", "S1002", "cone20", "cone40"), 2),
        rail=rng.choice(RAIL_PROFILES, 2),
        nominal_radius=radius + rng.uniform(-1e-3, 1e-3, 2),
        rail_inclination=rng.choice(INCLINATIONS, 2),
    )
    found = {name: tuple(values.tolist()) for name, values in pairs.items()}
    found |= dict(
        contact_mode=mode, normal_model=str(rng.choice(MODELS)), gauge=float(rng.uniform(1.43, 1.44))
    )
    if mode == "compliant":
        found["contact_damping"] = float(rng.choice((0.0, 0.3)))
    return found


def draw_poses(rng, wheelset, count):
    """Inputs (count,) by name: poses and loads, a third of the rails in their nominal place; motions."""
    yaw = rng.uniform(-0.03, 0.03, count) * (rng.random(count) < 0.7)
    transfer = rng.uniform(-0.9, 0.9, count) * (rng.random(count) < 0.5)
    given = dict(
        lateral_shift=rng.uniform(-7e-3, 7e-3, count),
        yaw=yaw,
        normal_force=log_uniform(rng, *LOADS, count),
        load_transfer=transfer,
    )
    far = np.where(rng.random(count) < 0.02, 10.0, 1.0)  # now and then beyond all that is permitted
    moved = {
        row.keyword: rng.uniform(-1, 1, count)
        * (0.03 if row.unit == "rad" else 3e-3)
        * (rng.random(count) < 0.67)
        * far
        for row in RAILS
    }
    if wheelset["contact_mode"] == "compliant":
        stand = wrcontact.ContactSystem(
            **{**wheelset, "contact_mode": "rigid", "normal_model": "hertz", "contact_damping": 0.0}
        )
        table = stand.evaluate_many(given["lateral_shift"], given["yaw"], outputs="geometry", **moved)
        sink = rng.choice((-1, 1, 1, 1), count) * log_uniform(rng, 1e-7, 3e-4, count)
        tilt = rng.choice((-1, 0, 1), count) * log_uniform(rng, 1e-7, 3e-4, count)
        given["vertical_shift_input"] = np.nan_to_num(table.vertical_shift) + sink
        given["roll_input"] = np.nan_to_num(table.roll) + tilt
    return {**given, **moved, **motions(count, rng)}


def mirrored(wheelset, given):
    """The same in the mirror along the track: sides are exchanged, and what is across the track turns."""
    motion = mirrored_motion({name: given[name] for name in motions(1, np.random.default_rng(0))})
    found = {
        name: (-1 if name in TURNED else 1) * values for name, values in given.items() if name not in motion
    }
    for row in RAILS:
        side, part = row.keyword.split("_", 1)
        found[row.keyword] = (1 if part == "rail_vertical" else -1) * given[
            f"{SIDES[1 - SIDES.index(side)]}_{part}"
        ]
    other = {name: values[::-1] if isinstance(values, tuple) else values for name, values in wheelset.items()}
    return other, {**found, **motion}


def line(wheelset, given, row):
    """A line of Python that evaluates this pose."""
    wheels = ", ".join(f"{name}={value!r}" for name, value in wheelset.items())
    pose = ", ".join(f"{name}={float(values[row])!r}" for name, values in given.items() if values[row] != 0.0)
    return f"ContactSystem({wheels}).evaluate({pose})"


def assert_none(bad, wheelset, given, what, measure=None):
    if np.any(bad):
        row = int(np.flatnonzero(bad)[0])
        found = "" if measure is None else f" {measure[row]:.3g}"
        pytest.fail(f"{what}{found}, {np.count_nonzero(bad)} of {len(bad)}: {line(wheelset, given, row)}")


def draw_friction(rng, wheelset, count):
    """A wheelset with a tangential model, whose friction falls and whose slope is reduced now and then; and
    the friction (count,) of both sides, of all sizes."""
    found = dict(
        wheelset,
        tangential_model=str(rng.choice(CREEP_MODELS)),
        load=str(rng.choice(("normal", "vertical"))),
        friction_fall=float(rng.choice((1.0, 0.4))),
        friction_fall_rate=float(rng.choice((0.0, 0.6))),
        flange_friction_ratio=float(rng.choice((1.0, 0.2))),
        slope_reduction=float(rng.choice((1.0, 0.5))),
        slope_reduction_rate=float(rng.choice((0.0, 0.64))),
        poisson_ratio=float(rng.choice((0.25, 0.27, 0.28, 0.3, 0.4))),
    )
    return found, {
        f"{side}_friction": np.where(rng.random(count) < 0.05, 0.0, log_uniform(rng, 1e-3, 1.0, count))
        for side in SIDES
    }
