"""Witnesses for every output of an FMU: its unit, and its value from something that is not the kernel.

``WITNESSES`` has one row for each name, with ``side`` for left and right, ``k`` for the number of a patch and
``j`` for that of a station: the unit, and a function that yields (value, tolerance) pairs that the output has
to meet.  It asks :mod:`tests.helpers.wheel_witness`, or an identity between outputs.
"""

import re
from math import atan, atan2, cos, sin, tan

import numpy as np

from tests.helpers import creep_witnesses as creep
from tests.helpers import wear_witnesses as wear
from tests.helpers.wheel_witness import WheelWitness, track

#: Shares by which ANALYN may differ from the half-space.  Measured in the scenes: 0.01, 0.05, 0.13 (the
#: lighter one of three patches), 0.09 (a flange alone on its half-space), 0.15 and 0.09.
OF_PENETRATION, OF_AREA, OF_PRESSURE, OF_LENGTH, OF_WIDTH, OF_LOAD = 0.03, 0.1, 0.15, 0.12, 0.18, 0.1
#: The same for areas of patches that are solved alone, each in the plane of its deepest point, though they
#: turn; measured 0.11, where the half-space that turns is 0.005 away.
OF_AREA_ALONE = 0.16
#: The same for centres of load: a share of the wheel's patch_width, which may have several patches.
OF_PLACE = 0.03
#: Identities hold but for rounding, closed forms but for the curvatures at a place that is found to 1e-7 m
#: [relative].
EXACT, CLOSED = 1e-9, 1e-6
#: The trapezoidal rule and the largest station miss this share of a patch, over its number of stations: an
#: ellipse between them has its edges up to a station away.
ROUGH = 1.5


#: Parameters and inputs by the names of the FMU, and the status: a centred wheelset; one that is shifted,
#: yawed and unevenly loaded; flange root and flange on the left, at planes of their own; three patches on the
#: right; Hertz; a pressed wheelset that rolls with friction; one whose wheels nearly stand, so that all
#: slides; one that creeps a little; and one whose left wheel carries nothing.
SCENES = {
    "centred": ({}, {}, 0),
    "yawed": ({"wear_outputs": True}, {"lateral_shift": 3e-3, "yaw": 0.01, "load_transfer": 0.2}, 0),
    "two_planes": (
        {"wear_outputs": True, "error_outputs": True},
        {"lateral_shift": -6.15e-3, "yaw": -0.0175, "normal_force": 40e3},
        0,
    ),
    "three_patches": (
        {"rail_profile": "54E1", "rail_inclination": 0.05, "wear_outputs": True},
        {"lateral_shift": 5.5e-3, "normal_force": 100e3},
        0,
    ),
    "hertz": (
        {"normal_model": "hertz", "wear_outputs": True},
        {"lateral_shift": 3e-3, "yaw": 0.01, "load_transfer": 0.2},
        0,
    ),
    "compliant": (
        {
            "contact_mode": "compliant",
            "tangential_model": "polach",
            "contact_damping": 0.5,
            "wear_outputs": True,
            "fatigue_outputs": True,
            "yield_shear": 270e6,
        },
        {
            "lateral_shift": 4e-3,
            "yaw": 5e-3,
            "normal_force": 1.0,
            "vertical_shift_input": 0.134e-3,
            "roll_input": -0.253e-3,
            "speed": 20.0,
            "lateral_velocity": 0.05,
            "vertical_velocity": -0.01,
            "yaw_rate": 0.03,
            "roll_rate": 0.02,
            "wheel_rate": 44.0,
            "track_curvature": 2e-3,
            "left.friction": 0.25,
            "right.friction": 0.4,
        },
        0,
    ),
    "sliding": (
        {"tangential_model": "fastsim", "wear_outputs": True, "fatigue_outputs": True},
        {
            "lateral_shift": 1e-3,
            "yaw": 0.0,
            "speed": 20.0,
            "wheel_rate": 5.0,
            "lateral_velocity": 0.0,
            "vertical_velocity": 0.0,
            "yaw_rate": 0.0,
            "roll_rate": 0.0,
            "track_curvature": 0.0,
            "left.friction": 0.25,
            "right.friction": 0.4,
        },
        0,
    ),
    "mild": (
        {"tangential_model": "polach", "fatigue_outputs": True},
        {
            "lateral_shift": 1e-3,
            "yaw": 2e-3,
            "speed": 20.0,
            "wheel_rate": 43.6,
            "lateral_velocity": 0.0,
            "vertical_velocity": 0.0,
            "yaw_rate": 0.0,
            "roll_rate": 0.0,
            "track_curvature": 0.0,
            "left.friction": 0.3,
            "right.friction": 0.3,
        },
        0,
    ),
    "unloaded": ({"wear_outputs": True}, {"lateral_shift": 1e-3, "load_transfer": 1.0}, 1),
}


class Scene:
    """A wheelset on its track: what an FMU was given, the outputs that it answered by name, and both its
    wheels."""

    def __init__(self, name, values):
        start, self.inputs, self.status = SCENES[name]
        self.values, self.mode = values, start.get("contact_mode", "rigid")
        self.known = {}  # what has been wanted, by name: witnesses are searches
        system = track(start.get("rail_profile", "UIC60"), start.get("rail_inclination", 0.025))
        self.wheels = {
            side: WheelWitness(
                system, side, values, self.inputs, self.mode, start.get("normal_model", "analyn")
            )
            for side in ("left", "right")
        }
        for wheel in self.wheels.values():
            wheel.tangential = start.get("tangential_model", "none")
            wheel.damping, wheel.worn = start.get("contact_damping", 0.0), start.get("wear_outputs", False)
            wheel.estimated = start.get("error_outputs", False)
            wheel.yield_shear = start.get("yield_shear", 300e6) if "fatigue_outputs" in start else 0.0

    def wanted(self, name):
        """(Value, tolerance) pairs of the output called ``name``."""
        if name not in self.known:
            pattern, side, place = folded(name)
            witness = WITNESSES[pattern][1]
            self.known[name] = list(witness(self.wheels[side], *place) if side else witness(self))
        return self.known[name]

    def misses(self):
        """A line for every output that is not what a witness says."""
        for name, value in self.values.items():
            for number, (wanted, tolerance) in enumerate(self.wanted(name)):
                if not abs(value - wanted) <= tolerance:
                    yield f"{name} is {value!r}, by witness {number} {float(wanted)!r} +- {tolerance:.3g}"


def folded(name):
    """The row of WITNESSES for an output, its side or None, and its number in an array, (k,) or (j,) or
    ()."""
    side, _, rest = name.partition(".")
    if side not in ("left", "right"):
        return name, None, ()
    number = re.search(r"\[(\d+)\]", rest)
    rest = re.sub(r"^patch\[\d+\]", "patch[k]", rest)
    rest = re.sub(r"\[\d+\]$", "[j]", rest)
    return f"side.{rest}", side, (int(number[1]),) if number else ()


# --- the wheelset -------------------------------------------------------------------------------------


def roll(scene):
    """Equal gaps on both wheels, or the input; the difference of the gaps falls by the distance of the wheels
    with the roll."""
    if scene.mode == "compliant":
        yield scene.inputs["roll_input"], 0.0
    else:
        left, right = (scene.wheels[side].lowest[0] for side in ("left", "right"))
        yield scene.values["roll"] + (right - left) / 1.5, 1e-9


def vertical_shift(scene):
    if scene.mode == "compliant":
        yield scene.inputs["vertical_shift_input"], 0.0
    else:
        for wheel in scene.wheels.values():
            yield wheel.lowest[0], 1e-9


def sum_of_wheels(name):
    def witness(scene):
        yield sum(wheel[name] for wheel in scene.wheels.values()), 1e-12 * total_load(scene)

    return witness


def total_load(scene):
    return sum(wheel["normal_force"] for wheel in scene.wheels.values())


def status(scene):
    yield scene.status, 0


# --- where a wheel touches ----------------------------------------------------------------------------


def patch_count(wheel):
    if not wheel.loaded:
        yield 0, 0
    else:
        yield 1 if wheel.model == "hertz" else len(wheel.carried), 0
        yield sum(wheel[f"patch[{k}].normal_force"] > 0.0 for k in (1, 2, 3)), 0


def contact(name, tolerance):
    """A coordinate of the contact point, or its angle; a minimum's place is found less well than its gap."""

    def witness(wheel):
        yield getattr(wheel.contact, name), tolerance

    return witness


def contact_radius(wheel):
    yield 0.46 + float(wheel.system.wheel(wheel["contact.y_wheel"])[0]), 1e-9
    yield wheel.contact.rolling_radius, 3e-8


def curvature(index):
    """Along x, and across: there the pieces that stand for a profile miss its curvature by up to 5e-6 1/m."""

    def witness(wheel):
        yield wheel.curvatures[index], (1e-6, 2e-5)[index]

    return witness


# --- what a wheel carries -----------------------------------------------------------------------------


def zero_without_load(witness):
    def zero_or(wheel, *place):
        if wheel.loaded:
            yield from witness(wheel, *place)
        else:
            yield 0.0, 0.0

    return zero_or


def penetration(wheel):
    if wheel.pressed:
        yield wheel.deepest[0], 1e-9
    if wheel.model == "hertz":
        yield wheel.hertz.penetration, 1e-6 * wheel.hertz.penetration
    elif wheel.one_plane:
        yield wheel.halfspace[0], OF_PENETRATION * wheel.halfspace[0]


def normal_force(wheel):
    yield sum(wheel[f"patch[{k}].normal_force"] for k in (1, 2, 3)), EXACT * wheel["normal_force"]
    if not wheel.pressed:
        yield wheel.load, EXACT * wheel.load
    else:
        # the half-space's load grows with the power 3/2 of its penetration
        load = wheel["normal_force"] * (wheel.deepest[0] / wheel.halfspace[0]) ** 1.5
        yield load, 1.5 * OF_PENETRATION * load


def share_of(wheel, share, alone=None):
    """What may be missed: ``share``, or ``alone`` where patches are solved one by one."""
    if wheel.model == "hertz":
        return CLOSED
    return share if alone is None or wheel.one_plane else alone


def total(name, of, share, alone=None):
    """A total over the patches: ``of`` puts those of the theory together."""

    def witness(wheel):
        value = of(getattr(patch, name) for patch in wheel.carried)
        yield value, share_of(wheel, share, alone) * value
        outline = wheel.stretch()
        yield getattr(outline, name), ROUGH / outline.cells * value

    return witness


def patch_width(wheel):
    value = max(patch.stop for patch in wheel.carried) - min(patch.start for patch in wheel.carried)
    yield value, (CLOSED if wheel.model == "hertz" else OF_WIDTH) * value
    yield wheel["station[31]"] - wheel["station[1]"], 1e-12


def patch_centroid(wheel):
    loads = np.array([patch.load for patch in wheel.carried])
    yield loads @ [patch.centroid for patch in wheel.carried] / loads.sum(), OF_PLACE * wheel["patch_width"]
    yield wheel.stretch().centroid, OF_PLACE * wheel["patch_width"]
    yield (
        sum(wheel[f"patch[{k}].normal_force"] * wheel[f"patch[{k}].centroid"] for k in (1, 2, 3))
        / wheel["normal_force"],
        EXACT,
    )


def side_force(axis):
    def witness(wheel):
        yield sum(wheel[f"patch[{k}].force.{axis}"] for k in (1, 2, 3)), 1e-12 * wheel["normal_force"]

    return witness


def side_moment(index):
    """Of the patches' forces at their points, about the wheelset's centre, and of their moments of spin."""

    def witness(wheel):
        yield (
            (pressure_moment(wheel) + creep.side_creep(wheel)[1])[index],
            EXACT * wheel["normal_force"] + creep.bowed(wheel),
        )

    return witness


def pressure_moment(wheel):
    """Of the patches' forces without their creep forces at their points (3,)."""
    moment = np.zeros(3)
    for k in range(1, wheel.count + 1):
        place = np.array([wheel[f"patch[{k}].{axis}_track"] for axis in "xyz"])
        moment += np.cross(place - wheel.centre, pressure_force(wheel, k))
    return moment


def pressure_force(wheel, k):
    """The force of a patch without its creep force (3,)."""
    return np.array([wheel[f"patch[{k}].force.{axis}"] for axis in "xyz"]) - creep.creep_vectors(wheel, k)[0]


def leaning(wheel):
    """What the planes of the strips, in which creep forces act, lean against the one of their patch [N]:
    1e-7 of the creep force on a tread, which has a radius of 300 mm."""
    return 1e-7 * np.linalg.norm(creep.side_creep(wheel)[0])


def normal_part(index):
    def witness(wheel):
        yield (
            sum(pressure_force(wheel, k)[index] for k in range(1, wheel.count + 1)),
            1e-12 * wheel["normal_force"] + leaning(wheel),
        )

    return witness


def normal_moment(index):
    def witness(wheel):
        yield pressure_moment(wheel)[index], EXACT * wheel["normal_force"] + leaning(wheel)

    return witness


def model_error(wheel):
    """Zero where it is not asked for; else within eq. (7.7) for changes of 0 ... 1, of a wheel that carries
    something.  tests/normal/test_auto.py has closed forms."""
    if wheel.estimated:
        yield 0.0025 + 0.115, 0.115 * (1.0 + EXACT)
    else:
        yield 0.0, 0.0


def rigid_rail(wheel):
    """No scene has springs below its rails."""
    yield 0.0, 0.0


def level(wheel, k):
    """Every scene has rails that are the same all along the track."""
    yield 0.0, 0.0


# --- one patch ----------------------------------------------------------------------------------------


def zero_if_absent(witness):
    def zero_or(wheel, k):
        if k <= wheel.count:
            yield from witness(wheel, k)
        else:
            yield 0.0, 0.0

    return zero_or


def of_patch(name, share, alone=None):
    def witness(wheel, k):
        size = getattr(wheel.carried[k - 1], name)
        if name != "load" or wheel.one_plane:
            yield size, share_of(wheel, share, alone) * size
        outline = wheel.stretch(k)
        if outline:
            yield getattr(outline, name), ROUGH / outline.cells * size

    return witness


def patch_centre(wheel, k):
    yield wheel.carried[k - 1].centroid, OF_PLACE * wheel["patch_width"]
    if wheel.stretch(k):
        yield wheel.stretch(k).centroid, OF_PLACE * wheel["patch_width"]


def patch_angle(wheel, k):
    """The mean over the patch, by its load; with Hertz the rail's normal at the contact point."""
    if wheel.model == "hertz":
        yield -atan(wheel.system.rail(wheel.abscissa(k))[1]), 1e-7
    yield atan2(*wheel.carried[k - 1].normal), 0.02


def patch_penetration(wheel, k):
    yield wheel.entry(k)[0], 0.02 * wheel["penetration"]


def patch_radius(wheel, k):
    """Of the wheel's point on the rail's normal at the centre of load."""
    y = wheel.wheel_point(wheel[f"patch[{k}].x_track"], wheel.abscissa(k), wheel.under_load)[1] - 0.75
    yield 0.46 + float(wheel.system.wheel(y)[0]), 3e-5 if wheel.one_plane else 1e-4


def patch_place(axis):
    def witness(wheel, k):
        value = wheel.carried[k - 1].place[axis]
        yield wheel.sign * value if axis == 1 else value, OF_PLACE * wheel["patch_width"]
        if axis == 0:
            yield wheel.ridge(k), OF_PLACE * wheel["patch_width"]
        if axis == 2:
            yield float(wheel.system.rail(wheel.abscissa(k))[0]), 1e-9

    return witness


def patch_force(axis):
    """The load along the mean normal, which is shorter than 1 where a patch turns, and the creep force."""

    def witness(wheel, k):
        load, angle = (wheel[f"patch[{k}].{name}"] for name in ("normal_force", "contact_angle"))
        turned, share = (sin(angle), cos(angle)), EXACT
        if wheel.model != "hertz":
            turned, share = wheel.carried[k - 1].normal, 0.02
        rubbed = creep.creep_vectors(wheel, k)[0]
        yield load * (0.0, -wheel.sign * turned[0], -turned[1])[axis] + rubbed[axis], share * load
        if axis == 1:
            pressed = wheel[f"patch[{k}].force.z"] - rubbed[2]
            yield wheel.sign * tan(angle) * pressed + rubbed[1], EXACT * load

    return witness


# --- the outline --------------------------------------------------------------------------------------


def station(wheel, j):
    low, high = wheel["station[1]"], wheel["station[31]"]
    yield low + (j - 1) / 30 * (high - low), 1e-12
    low, high = min(patch.start for patch in wheel.carried), max(patch.stop for patch in wheel.carried)
    share = CLOSED if wheel.model == "hertz" else 0.5 * OF_WIDTH
    yield low + (j - 1) / 30 * (high - low), share * (high - low)


def outline(index, share):
    """Within what a small move of the station changes, too: at an edge it is a root."""

    def witness(wheel, j):
        s = wheel[f"station[{j}]"]
        move = (CLOSED if wheel.model == "hertz" else 0.5 * OF_WIDTH) * wheel["patch_width"]
        near = s + np.linspace(-move, move, 41)
        values = sum(list(patch.at(near))[index] for patch in wheel.carried)
        largest = max(
            wheel.carried[0].length / 2 if index == 0 else patch.max_pressure for patch in wheel.carried
        )
        allowed = (CLOSED if wheel.model == "hertz" else share) * largest
        middle = 0.5 * (values.min() + values.max())
        yield middle, values.max() - middle + allowed

    return witness


#: By name: unit, and what yields (value, tolerance).
WHEELSET = {
    "roll": ("rad", roll),
    "vertical_shift": ("m", vertical_shift),
    **{
        f"{name}.{axis}": (unit, sum_of_wheels(f"{name}.{axis}"))
        for name, unit in (("force", "N"), ("moment", "N.m"), ("normal.force", "N"), ("normal.moment", "N.m"))
        for axis in "xyz"
    },
    "driving_torque": ("N.m", creep.driving_torque),
    "equilibrium.vertical_shift": ("m", creep.equilibrium("vertical_shift")),
    "equilibrium.roll": ("rad", creep.equilibrium("roll")),
    "status": (None, status),
}
GEOMETRY = {
    **{
        f"contact.{name}": ("m", contact(name, 3e-8))
        for name in ("x_wheel", "y_wheel", "z_wheel", "y_rail", "z_rail", "x_track", "y_track", "z_track")
    },
    "contact_angle": ("rad", contact("contact_angle", 2e-7)),
    "rolling_radius": ("m", contact_radius),
    "curvature_x": ("1/m", curvature(0)),
    "curvature_y": ("1/m", curvature(1)),
}
LOAD = {
    "penetration": ("m", penetration),
    "normal_force": ("N", normal_force),
    "area": ("m2", total("area", sum, OF_AREA, OF_AREA_ALONE)),
    "max_pressure": ("Pa", total("max_pressure", max, OF_PRESSURE)),
    "patch_length": ("m", total("length", max, OF_LENGTH)),
    "patch_width": ("m", patch_width),
    "patch_centroid": ("m", patch_centroid),
    **{f"force.{axis}": ("N", side_force(axis)) for axis in "xyz"},
    **{f"moment.{axis}": ("N.m", side_moment(index)) for index, axis in enumerate("xyz")},
    **{f"normal.force.{axis}": ("N", normal_part(index)) for index, axis in enumerate("xyz")},
    **{f"normal.moment.{axis}": ("N.m", normal_moment(index)) for index, axis in enumerate("xyz")},
    "friction_power": ("W", creep.side_power),
    "wear_number": ("N", creep.wear_number),
    "driving_torque": ("N.m", creep.side_torque),
    "wheel_rate_found": ("rad/s", creep.wheel_rate),
    "damping_power": ("W", wear.damping_power),
    "derailment_quotient": ("1", wear.derailment_quotient),
    "rail_deflection_lateral": ("m", rigid_rail),
    "rail_deflection_vertical": ("m", rigid_rail),
    "model_error": ("1", model_error),
}
PATCH = {
    "normal_force": ("N", of_patch("load", OF_LOAD)),
    "area": ("m2", of_patch("area", OF_AREA, OF_AREA_ALONE)),
    "max_pressure": ("Pa", of_patch("max_pressure", OF_PRESSURE)),
    "length": ("m", of_patch("length", OF_LENGTH)),
    "width": ("m", of_patch("width", OF_WIDTH)),
    "centroid": ("m", patch_centre),
    "contact_angle": ("rad", patch_angle),
    "penetration": ("m", patch_penetration),
    "rolling_radius": ("m", patch_radius),
    **{f"{axis}_track": ("m", patch_place(index)) for index, axis in enumerate("xyz")},
    **{f"force.{axis}": ("N", patch_force(index)) for index, axis in enumerate("xyz")},
    **{
        f"creepage.{name}": (unit, creep.patch_creepage(index))
        for index, (name, unit) in enumerate((("x", "1"), ("y", "1"), ("spin", "1/m")))
    },
    "tangential.x": ("N", creep.tangential(0)),
    "tangential.y": ("N", creep.tangential(1)),
    "tangential.moment": ("N.m", creep.moment),
    "stick_share": ("1", creep.stick_share),
    "max_shear": ("Pa", creep.max_shear),
    "friction_power": ("W", creep.patch_power),
    "saturation": ("1", creep.saturation),
    "wear_number": ("N", creep.of_fatigue(lambda number, *_: number, EXACT)),
    "fatigue_damage": ("1", creep.of_fatigue(creep.damage, 1e-8)),
    "shakedown_ratio": ("1", creep.of_fatigue(lambda _, used, peak, limit: peak / limit, EXACT)),
    "surface_fatigue_index": ("1", creep.of_fatigue(lambda _, used, peak, limit: used - limit / peak, EXACT)),
    "slope": ("rad", level),
}
OUTLINE = {
    "station": ("m", station),
    "half_length": ("m", outline(0, OF_LENGTH)),
    "pressure": ("Pa", outline(1, OF_PRESSURE)),
    "shear": ("Pa", creep.shear),
    "slip": ("m/s", creep.slip),
    "wheel_place": ("m", wear.wheel_place),
    "rail_place": ("m", wear.rail_place),
    "power": ("W/m", wear.power),
    "patch_of": ("1", wear.patch_of),
}
WITNESSES = {
    **WHEELSET,
    "side.patch_count": (None, patch_count),
    **{f"side.{name}": row for name, row in GEOMETRY.items()},
    **{f"side.{name}": (unit, zero_without_load(witness)) for name, (unit, witness) in LOAD.items()},
    **{f"side.patch[k].{name}": (unit, zero_if_absent(witness)) for name, (unit, witness) in PATCH.items()},
    **{f"side.{name}[j]": (unit, zero_without_load(witness)) for name, (unit, witness) in OUTLINE.items()},
}
