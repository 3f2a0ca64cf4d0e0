"""The one table of everything that crosses the border: inputs, parameters and outputs.

Registration, units, documentation and tests read it; nothing here knows FMI.  A variable's place in ``VARIABLES`` is
its value reference.  Outputs lie there in the order of the kernel's array, so that one copy moves them all.
"""

import math
import re
from dataclasses import dataclass

from ..kernel import layout
from ..kernel.prepare.tables import LATERAL_LIMIT, YAW_LIMIT
from ..kernel.search.roll import ROLL_LIMIT
from ..system import CHOICES, RANGES
from .starts import STARTS

INPUT, PARAMETER, OUTPUT = "input", "parameter", "output"
#: Declared range of the height in compliant contact [m]: a flange on top of the rail lifts the wheelset by 28 mm.
HEIGHT_LIMIT = 0.05
REAL, INTEGER, STRING = "Real", "Integer", "String"


@dataclass(frozen=True)
class Unit:
    """A unit as a product of SI base units, with the unit that people want to see.

    ``base`` holds the exponents of kg, m, s, rad; a value shown in ``display`` is ``display_factor`` times the value.
    """

    name: str
    base: dict
    quantity: str = ""
    display: str = ""
    display_factor: float = 1.0


UNITS = {
    unit.name: unit
    for unit in (
        Unit("m", {"m": 1}, "Length", "mm", 1e3),
        Unit("rad", {"rad": 1}, "Angle", "deg", 180.0 / math.pi),
        Unit("N", {"kg": 1, "m": 1, "s": -2}, "Force", "kN", 1e-3),
        Unit("N.m", {"kg": 1, "m": 2, "s": -2}, "Moment", "kN.m", 1e-3),
        Unit("Pa", {"kg": 1, "m": -1, "s": -2}, "Pressure", "MPa", 1e-6),
        Unit("m2", {"m": 2}, "Area", "mm2", 1e6),
        Unit("1/m", {"m": -1}, "Curvature"),
        Unit("1", {}),
    )
}


@dataclass(frozen=True)
class Variable:
    """One variable: its name, what it means in the field's terms, its unit and limits, and where the kernel keeps it.

    ``index`` is the place in the kernel's inputs or outputs (None for parameters and ``status``), ``keyword`` the
    argument of :class:`~wrcontact.ContactSystem` that a parameter sets, ``depends_on`` the inputs that an output follows.
    ``place`` says whose value it is ("Right wheel, patch 1"); several variables share one ``meaning``.
    """

    name: str
    causality: str
    meaning: str
    type: str = REAL
    unit: str = ""
    start: object = None
    minimum: float | None = None
    maximum: float | None = None
    nominal: float | None = None
    index: int | None = None
    keyword: str = ""
    choices: tuple = ()
    depends_on: tuple = ()
    place: str = ""

    @property
    def description(self):
        """The meaning, preceded by the place where there is one."""
        return f"{self.place}: {self.meaning}" if self.place else self.meaning

    @property
    def variability(self):
        """How the value may change: parameters are fixed, Reals follow their inputs, Integers switch."""
        if self.causality == PARAMETER:
            return "fixed"
        return "continuous" if self.type == REAL else "discrete"


# What an output can follow.  roll_guess is in neither: it changes the cost of a step, never its answer.  An FMU declares its
# dependencies once for all contact modes: in elastic and compliant contact the position follows the load, or height and roll.
GEOMETRY = ("lateral_shift", "yaw", "normal_force", "load_transfer", "vertical_shift_input", "roll_input")
LOAD = GEOMETRY

# What each method decides, and what each choice means; which choices there are is said in one place, system.CHOICES.
METHODS = {
    "contact_mode": ("how wheel and rail meet", {
        "rigid": "undeformed surfaces touch, at equal gaps left and right",
        "elastic": "the wheels sink in until each carries its load, which gives height and roll",
        "compliant": "height and roll are the inputs vertical_shift_input and roll_input, and the loads follow"}),
    "load": ("what normal_force prescribes", {"normal": "the total over the patches of a wheel",
                                                  "vertical": "the vertical component of their resultant"}),
    "normal_model": (
        "normal contact",
        {"analyn": "ANALYN with interacting regions", "analyn_strip": "ANALYN followed by a strip correction",
         "hertz": "one Hertz ellipse from the curvatures at the contact point"},
    ),
    "separation": (
        "how the undeformed distance is measured",
        {"normal": "along the normal of the contact plane", "vertical": "vertically at common lateral coordinate",
         "equidistant": "between points at equal arc length from the contact",
         "equidistant_chord": "between nodes that circles step off from the contact"},
    ),
    "longitudinal_curvature": (
        "rolling curvature of the wheel",
        {"effective": "of the cut along the contact normal", "basic": "1 / rolling radius"},
    ),
    "lateral_curvature": (
        "relative lateral curvature",
        {"adaptive": "averaged over a window in proportion to the patch", "smooth": "of circles fitted to the profiles",
         "rough": "change of the profiles' angles between neighbouring nodes"},
    ),
}


def _inputs():
    """What moves: the pose and the load of the wheelset."""
    return [
        Variable("lateral_shift", INPUT, "Lateral shift of the wheelset against the track centre, positive to the right",
                 unit="m", start=0.0, minimum=-LATERAL_LIMIT, maximum=LATERAL_LIMIT, nominal=1e-3, index=layout.IN_LATERAL_SHIFT),
        Variable("yaw", INPUT, "Yaw of the wheelset, positive clockwise seen from above",
                 unit="rad", start=0.0, minimum=-YAW_LIMIT, maximum=YAW_LIMIT, nominal=1e-2, index=layout.IN_YAW),
        Variable("roll_guess", INPUT, "Where the search for the roll angle starts; changes the cost of a step, never its answer",
                 unit="rad", start=0.0, minimum=-0.5, maximum=0.5, nominal=1e-3, index=layout.IN_ROLL_GUESS),
        Variable("normal_force", INPUT, "Load per wheel before load transfer: normal force, total over its patches, or its vertical component (parameter load); the contact_mode compliant does not read it",
                 unit="N", start=78500.0, minimum=0.0, maximum=1e7, nominal=1e5, index=layout.IN_NORMAL_FORCE),
        Variable("load_transfer", INPUT, "Share L of the load N moved from left to right: N (1 + L) on the right wheel, N (1 - L) on the left; the contact_mode compliant does not read it",
                 unit="1", start=0.0, minimum=-1.0, maximum=1.0, nominal=0.1, index=layout.IN_LOAD_TRANSFER),
        Variable("vertical_shift_input", INPUT, "Vertical shift of the wheelset in the contact_mode compliant, positive down; other modes do not read it",
                 unit="m", start=0.0, minimum=-HEIGHT_LIMIT, maximum=HEIGHT_LIMIT, nominal=1e-3, index=layout.IN_VERTICAL_SHIFT),
        Variable("roll_input", INPUT, "Roll of the wheelset in the contact_mode compliant, positive with the right wheel down; other modes do not read it",
                 unit="rad", start=0.0, minimum=-ROLL_LIMIT, maximum=ROLL_LIMIT, nominal=1e-3, index=layout.IN_ROLL),
    ]  # fmt: skip


def _parameters():
    """What stays: profiles, track, material and methods."""
    return [
        Variable("wheel_profile", PARAMETER, "Wheel profile: a built-in name, or the name of a file that is packed in the FMU",
                 STRING, start=STARTS.get("wheel_profile", "S1002"), keyword="wheel"),
        Variable("rail_profile", PARAMETER, "Rail profile: a built-in name, or the name of a file that is packed in the FMU",
                 STRING, start=STARTS.get("rail_profile", "UIC60"), keyword="rail"),
        _number("rail_inclination", 0.025, 0.025, "Inclination of the rail to the track centre as a slope; 0.025 is 1:40"),
        _number("gauge", 1.435, 1.0, "Track gauge between the gauge faces of the rails"),
        _number("gauge_depth", 0.014, 0.01, "Depth below the highest point of the inclined rail head at which the gauge is measured"),
        _number("running_circle_distance", 1.5, 1.0, "Distance between the running circles of the two wheels"),
        _number("nominal_radius", 0.46, 0.5, "Wheel radius at the running circle"),
        _number("youngs_modulus", 210e9, 1e11, "Young's modulus of wheel and rail"),
        _number("poisson_ratio", 0.28, 0.3, "Poisson's ratio of wheel and rail"),
        _number("tolerance", 0.01, 0.01, "Relative error of the numerics in penetration, area and peak pressure; nodes and strips are as fine as it asks"),
        *(_method(name, *METHODS[name]) for name in CHOICES),
        _number("curvature_step", 0.2e-3, 1e-3, "Arc length from node to node of the rough lateral curvature"),
        _number("curvature_reach", 3e-3, 1e-3, "Half the width over which the smooth lateral curvature fits circles to the profiles"),
    ]  # fmt: skip


def _number(name, start, nominal, meaning):
    """A numeric parameter; unit and range are those of the contact system."""
    low, high, unit = RANGES[name]
    return Variable(name, PARAMETER, meaning, unit=unit, start=start, minimum=low, maximum=high, nominal=nominal, keyword=name)


def _method(name, decides, words):
    """A method parameter with its choices explained; the first choice is the default."""
    choices = CHOICES[name]
    meaning = f"Method, {decides}: " + ", ".join(f"{choice} = {words[choice]}" for choice in choices)
    return Variable(name, PARAMETER, meaning, STRING, start=choices[0], keyword=name, choices=choices)


SIDE_TABLE = (
    # name, kernel slot, unit, nominal, smallest, what it follows, meaning
    ("contact.x_wheel", layout.SIDE_X_WHEEL, "m", 1e-3, None, GEOMETRY, "contact point in the wheel profile frame, forward of the principal profile; the frame yaws and rolls with the wheelset but does not spin"),
    ("contact.y_wheel", layout.SIDE_Y_WHEEL, "m", 1e-2, None, GEOMETRY, "contact point in the wheel profile frame, from the running circle to the field side"),
    ("contact.z_wheel", layout.SIDE_Z_WHEEL, "m", 1e-3, None, GEOMETRY, "contact point in the wheel profile frame, down from the running circle"),
    ("contact.y_rail", layout.SIDE_Y_RAIL, "m", 1e-2, None, GEOMETRY, "contact point in the rail profile frame, from the highest point of the inclined head to the field side"),
    ("contact.z_rail", layout.SIDE_Z_RAIL, "m", 1e-3, None, GEOMETRY, "contact point in the rail profile frame, down from the highest point of the inclined head"),
    ("contact.x_track", layout.SIDE_X_TRACK, "m", 1e-3, None, GEOMETRY, "contact point in the track frame, forward"),
    ("contact.y_track", layout.SIDE_Y_TRACK, "m", 1.0, None, GEOMETRY, "contact point in the track frame, to the right of the track centre (not mirrored)"),
    ("contact.z_track", layout.SIDE_Z_TRACK, "m", 1e-3, None, GEOMETRY, "contact point in the track frame, down from top of rail"),
    ("contact_angle", layout.SIDE_CONTACT_ANGLE, "rad", 0.1, None, GEOMETRY, "contact angle, positive towards the flange"),
    ("rolling_radius", layout.SIDE_ROLLING_RADIUS, "m", 0.5, 0.0, GEOMETRY, "rolling radius at the contact point: nominal radius plus height of the wheel profile"),
    ("curvature_x", layout.SIDE_CURVATURE_X, "1/m", 1.0, None, GEOMETRY, "relative (combined) principal curvature of wheel and rail at the contact point, in rolling direction"),
    ("curvature_y", layout.SIDE_CURVATURE_Y, "1/m", 10.0, None, GEOMETRY, "relative (combined) principal curvature of wheel and rail at the contact point, across the rail"),
    ("penetration", layout.SIDE_PENETRATION, "m", 1e-4, 0.0, LOAD, "penetration: approach of the two bodies"),
    ("normal_force", layout.SIDE_NORMAL_FORCE, "N", 1e5, 0.0, LOAD, "normal force, total over the patches"),
    ("area", layout.SIDE_AREA, "m2", 1e-4, 0.0, LOAD, "contact area, total over the patches"),
    ("max_pressure", layout.SIDE_MAX_PRESSURE, "Pa", 1e9, 0.0, LOAD, "highest contact pressure"),
    ("patch_length", layout.SIDE_PATCH_LENGTH, "m", 1e-2, 0.0, LOAD, "length of the contact in rolling direction"),
    ("patch_width", layout.SIDE_PATCH_WIDTH, "m", 1e-2, 0.0, LOAD, "width of the contact in the contact plane, from first to last loaded point"),
    ("patch_centroid", layout.SIDE_PATCH_CENTROID, "m", 1e-3, None, LOAD, "centre of load in the contact plane, from the contact point to the field side"),
)  # fmt: skip

PATCH_TABLE = (
    ("normal_force", layout.PATCH_NORMAL_FORCE, "N", 1e5, 0.0, "normal force"),
    ("area", layout.PATCH_AREA, "m2", 1e-4, 0.0, "contact area"),
    ("max_pressure", layout.PATCH_MAX_PRESSURE, "Pa", 1e9, 0.0, "highest contact pressure"),
    ("length", layout.PATCH_LENGTH, "m", 1e-2, 0.0, "length in rolling direction"),
    ("width", layout.PATCH_WIDTH, "m", 1e-2, 0.0, "width in the contact plane"),
    ("centroid", layout.PATCH_CENTROID, "m", 1e-3, None, "centre of load in the contact plane, from the contact point to the field side"),
    ("contact_angle", layout.PATCH_CONTACT_ANGLE, "rad", 0.1, None, "contact angle where its gap is smallest, along whose normal it is loaded, positive towards the flange"),
)  # fmt: skip

OUTLINE_TABLE = (
    ("station", layout.SIDE_STATION, "m", 1e-3, None, "lateral position of an outline station in the contact plane, from the contact point to the field side"),
    ("half_length", layout.SIDE_HALF_LENGTH, "m", 1e-2, 0.0, "half the length of the patch in rolling direction at the station"),
    ("pressure", layout.SIDE_PRESSURE, "Pa", 1e9, 0.0, "contact pressure on the centre line of the patch at the station"),
)  # fmt: skip


def _side(side, first):
    """Outputs of one wheel whose block starts at ``first``, in the kernel's order."""
    wheel = f"{side.capitalize()} wheel"
    yield Variable(f"{side}.patch_count", OUTPUT, "number of loaded regions", INTEGER, minimum=0, maximum=layout.PATCH_LIMIT,
                   index=first + layout.SIDE_PATCH_COUNT, depends_on=LOAD, place=wheel)  # fmt: skip
    for name, slot, unit, nominal, minimum, depends_on, meaning in SIDE_TABLE:
        yield _output(f"{side}.{name}", meaning, unit, nominal, first + slot, depends_on, minimum, wheel)
    for k in range(layout.PATCH_LIMIT):
        patch = first + layout.SIDE_PATCH + k * layout.PATCH_SIZE
        for name, slot, unit, nominal, minimum, meaning in PATCH_TABLE:
            yield _output(f"{side}.patch[{k + 1}].{name}", meaning, unit, nominal, patch + slot, LOAD, minimum, f"{wheel}, patch {k + 1}")
    for name, slot, unit, nominal, minimum, meaning in OUTLINE_TABLE:
        for j in range(layout.STATION_COUNT):
            yield _output(f"{side}.{name}[{j + 1}]", meaning, unit, nominal, first + slot + j, LOAD, minimum, f"{wheel}, station {j + 1}")


#: Axes of the track frame.
AXES = (("x", "forward"), ("y", "to the right"), ("z", "down"))


def _output(name, meaning, unit, nominal, index, depends_on=GEOMETRY, minimum=None, place=""):
    """A Real output; angles are bounded by a right angle."""
    right_angle = math.pi / 2 if unit == "rad" else None
    lowest = -right_angle if right_angle else minimum
    return Variable(name, OUTPUT, meaning, unit=unit, minimum=lowest, maximum=right_angle, nominal=nominal, index=index,
                    depends_on=depends_on, place=place)  # fmt: skip


def _outputs():
    """What comes back: the kernel's array in its own order, then the status of the step."""
    return [
        _output("roll", "Roll of the wheelset, positive with the right wheel down", "rad", 1e-3, layout.OUT_ROLL),
        _output("vertical_shift", "Vertical shift of the wheelset, positive down", "m", 1e-3, layout.OUT_VERTICAL_SHIFT),
        *(_output(f"force.{axis}", f"Resultant of the contact forces on the wheelset, {way}", "N", 1e5, layout.OUT_FORCE + i, LOAD)
          for i, (axis, way) in enumerate(AXES)),
        *(_output(f"moment.{axis}", f"Moment of the contact forces about the wheelset's centre, around the axis {way}", "N.m", 1e4,
                  layout.OUT_MOMENT + i, LOAD) for i, (axis, way) in enumerate(AXES)),
        *_side("left", layout.OUT_LEFT),
        *_side("right", layout.OUT_RIGHT),
        Variable(
            "status", OUTPUT,
            "Outcome of the step: 0 valid, 1 a wheel is unloaded, 2 off the profile, 3 not converged, 4 invalid input (2 to 4 keep the last valid values)",
            INTEGER, minimum=0, maximum=4, depends_on=LOAD,
        ),
    ]  # fmt: skip


VARIABLES = (*_inputs(), *_parameters(), *_outputs())
REFERENCE = {variable.name: reference for reference, variable in enumerate(VARIABLES)}

#: Value references of the first kernel output and of the status; between them the kernel's array lies without a hole.
FIRST_OUTPUT = REFERENCE["roll"]
STATUS = REFERENCE["status"]


def select(causality=None, type=None):
    """Value references of the variables of one causality and type, in table order."""
    return [
        reference
        for reference, variable in enumerate(VARIABLES)
        if causality in (None, variable.causality) and type in (None, variable.type)
    ]


def documented():
    """The table for people: (name, variable) with left and right, patches and stations folded into one row each.

    ``right.patch[2].area`` and its like appear once, as ``side.patch[k].area``.
    """
    rows = {}
    for variable in VARIABLES:
        rows.setdefault(folded(variable.name), variable)
    return list(rows.items())


def folded(name):
    """A variable's name with its side, and its places in arrays, as letters."""
    name = re.sub(r"^(left|right)\.", "side.", name)
    name = re.sub(r"patch\[\d+\]", "patch[k]", name)
    return re.sub(r"\[\d+\]", "[j]", name)
