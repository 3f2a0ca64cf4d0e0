"""Named cases that several test files and the benchmarks share."""

import csv
import json
import math
from functools import cache

import numpy as np

import wrcontact
from data import TRAJECTORIES
from tests.helpers.paths import DATA
from wrcontact import ContactSystem
from wrcontact.interface.variables import INPUT, OUTPUT, REAL, VARIABLES
from wrcontact.methods import CHOICES, TangentialModel

INPUT_NAMES = [v.name for v in VARIABLES if v.causality == INPUT]
#: All but switches.
REAL_INPUT_NAMES = [v.name for v in VARIABLES if v.causality == INPUT and v.type == REAL]
OUTPUT_NAMES = [v.name for v in VARIABLES if v.causality == OUTPUT]
RUNS = ("hunting", "jumps", "load")


def pressed_poses(count):
    """Poses with the height and roll at which they carry their loads."""
    system = ContactSystem(contact_mode="elastic")
    states = [system.evaluate(**row) for row in poses(count)]
    return [
        {**row, "vertical_shift_input": state.vertical_shift, "roll_input": state.roll}
        for row, state in zip(poses(count), states)
    ]


def stored(name):
    """Times, inputs and expected outputs of a stored trajectory; empty cells are left out."""
    with open(TRAJECTORIES[name], newline="", encoding="utf-8") as file:
        table = [
            {key: float(cell) for key, cell in row.items() if cell.strip()} for row in csv.DictReader(file)
        ]
    times = [row["time"] for row in table]
    # others keep their start values
    rows = [{key: row[key] for key in INPUT_NAMES if key in row} for row in table]
    names = [name for name in dict.fromkeys(key for row in table for key in row) if name in OUTPUT_NAMES]
    return times, rows, [{name: row.get(name) for name in names} for row in table]


def poses(count):
    """Poses over tread, flange root and flange, with load changes."""
    k = np.arange(count)
    columns = {
        "lateral_shift": 6e-3 * np.sin(0.7 * k),
        "yaw": 5e-3 * np.sin(0.31 * k),
        "roll_guess": 0.0 * k,
        "normal_force": 78.5e3 + 40e3 * np.sin(0.5 * k),
        "load_transfer": 0.3 * np.sin(0.23 * k),
    }
    return [dict(zip(columns, row)) for row in zip(*(column.tolist() for column in columns.values()))]


INVALID_INPUTS = {
    "nan": ({"lateral_shift": math.nan}, 4, "lateral_shift", "nan"),
    "infinite": ({"yaw": math.inf}, 4, "yaw", "inf"),
    "nan_guess": ({"roll_guess": math.nan}, 4, "roll_guess", "nan"),
    "negative_force": ({"normal_force": -1.0}, 4, "normal_force", "-1"),
    "transfer": ({"load_transfer": 1.5}, 4, "load_transfer", "1.5"),
    "off_profile": ({"lateral_shift": 0.08}, 2, "lateral_shift", "0.08"),
    "all_nan": (dict.fromkeys(REAL_INPUT_NAMES, math.nan), 4, "lateral_shift", "nan"),
}


def profile_file(folder, kind):
    """A profile file of one's own: a worn-looking conical wheel or a rail crown."""
    file = folder / f"own {kind}.txt"
    y = np.arange(-60.0, 56.0, 0.5)
    z = -y / 20 + np.where(y < -30, 0.05 * (y + 30) ** 2, 0.0)
    np.savetxt(file, np.column_stack((y, z)), fmt="%.4f")
    return file


WRONG_PARAMETERS = {
    "contact_mode": (
        {"contact_mode": "elastisch"},
        ["contact_mode", "elastisch", "rigid", "elastic", "compliant"],
    ),
    "load": ({"contact_mode": "elastic", "load": "lateral"}, ["load", "lateral", "normal", "vertical"]),
    "normal_model": ({"normal_model": "kalker"}, ["normal_model", "kalker", "analyn", "hertz"]),
    "wheel": ({"wheel_profile": "S1003"}, ["wheel_profile is 'S1003'; permitted are S1002, cone20, cone40"]),
    "left rail": (
        {"left_rail_profile": "UIC61"},
        ["left_rail_profile is 'UIC61'; permitted are UIC60, 60E1, 54E1"],
    ),
    "gauge": ({"gauge": 14.35}, ["gauge", "14.35", "m"]),
    "nominal_radius": ({"nominal_radius": math.nan}, ["nominal_radius", "nan", "m"]),
    "poisson_ratio": ({"poisson_ratio": 0.7}, ["poisson_ratio", "0.7"]),
    "spring": ({"rail_lateral_stiffness": 2.5e7}, ["rail_lateral_stiffness", "N/m", "contact_mode", "rigid"]),
    "damper": (
        {"contact_mode": "compliant", "left_rail_lateral_damping": 3.5},
        ["left_rail_lateral_damping", "3.5", "without left_rail_lateral_stiffness"],
    ),
}


def planar_cases():
    return json.loads((DATA / "contact_planar.json").read_text())["cases"]


FORCE = 78.5e3  # per wheel [N]
MODELS = CHOICES["normal_model"]
#: Models of creep forces, and those of them that follow tractions strip by strip.
CREEP_MODELS = CHOICES["tangential_model"][1:]
STRIP_MODELS = tuple(name for name in CREEP_MODELS if not TangentialModel.family.method(name).one_ellipse)
LOADS = ("normal", "vertical")
PAIRS = [(rail, inclination) for rail in ("UIC60", "60E1", "54E1") for inclination in (1 / 40, 1 / 20)]

#: lateral shift [m], yaw [rad], load transfer
POSES = {
    "tread": (1e-3, 0.0, 0.0),
    "two_region": (4.95e-3, 0.0, 0.0),
    "root": (6e-3, 0.0, 0.0),
    "conformal": (6.29e-3, 0.0, 0.0),
    "flange": (7.5e-3, 0.0, 0.0),
    "yawed": (5.2e-3, 0.0175, 0.0),
    "yawed_flange": (-6.6e-3, -0.035, 0.3),
    "root_and_flange": (6.15e-3, 0.0175, 0.0),
    "transfer": (3e-3, 0.0, 0.8),
}


@cache
def system(**parameters):
    return wrcontact.ContactSystem(**parameters)


def input_row(*first):
    """Inputs in the kernel's order: the first ones as given, all others at their starts."""
    return np.array([*first, *(float(v.start) for v in VARIABLES[len(first) : len(INPUT_NAMES)])])


MM = 1e-3

#: A left side of its own, as FMUs' parameters.
LEFT_SIDE = {
    "left_wheel_profile": "cone40",
    "left_rail_profile": "54E1",
    "left_nominal_radius": 0.4595,
    "left_rail_inclination": 0.05,
}


def moving_track(count, compliant=False):
    """Poses of :func:`poses` over rails that are displaced, lean and move, with all velocities; with
    ``compliant`` also the height and roll at which a wheelset with LEFT_SIDE carries their loads."""
    sides = {
        name: (LEFT_SIDE[f"left_{name}{'_profile' * (name in ('wheel', 'rail'))}"], right)
        for name, right in (
            ("wheel", "S1002"),
            ("rail", "UIC60"),
            ("nominal_radius", 0.46),
            ("rail_inclination", 1 / 40),
        )
    }
    made, rows = system(contact_mode="elastic", **sides), []
    for k, pose in enumerate(poses(count)):
        turn = 0.4 * k + np.arange(20)
        pose |= {
            f"{side}.rail_{part}{kind}": size * float(np.sin(turn[3 * i + j + 6 * m] + 0.1))
            for i, side in enumerate(("left", "right"))
            for j, (part, size) in enumerate((("lateral", 1e-3), ("vertical", 1.2e-3), ("roll", 0.01)))
            for m, kind in enumerate(("", "_velocity"))
        }
        state = made.evaluate(**{name.replace(".", "_"): value for name, value in pose.items()})
        moving = {
            "speed": 25.0,
            "lateral_velocity": 0.04,
            "vertical_velocity": -0.02,
            "yaw_rate": 0.05,
            "roll_rate": 0.03,
            "wheel_rate": 54.0,
            "track_curvature": 2e-3,
        }
        rows.append(
            {
                **pose,
                **moving,
                **(
                    {"vertical_shift_input": state.vertical_shift, "roll_input": state.roll}
                    if compliant
                    else {}
                ),
            }
        )
    return rows
