"""The Python FMU's description: variables, units, dependencies."""

import math
import re

import pytest

from tests.helpers.cases import INPUT_NAMES, OUTPUT_NAMES
from tests.helpers.fmus import WARM_START, assert_same, evaluated
from wrcontact import ContactSystem
from wrcontact.interface import variables
from wrcontact.interface.friction import FRICTION
from wrcontact.interface.inputs import DEFLECTIONS, MOTION, RAILS, RATES, TIME_STEP, TORQUES
from wrcontact.interface.variables import INPUT, OUTPUT, PARAMETER, REFERENCE, VARIABLES
from wrcontact.methods import CHOICES

pytestmark = pytest.mark.check


def test_description_has_every_variable_of_the_table(description):
    described = {v.name: v for v in description.modelVariables}
    assert list(described) == [v.name for v in VARIABLES]
    for variable in VARIABLES:
        found = described[variable.name]
        assert (found.valueReference, found.type, found.causality, found.variability) == (
            REFERENCE[variable.name],
            variable.type,
            variable.causality,
            variable.variability,
        )
        assert found.description == variable.description
        assert found.initial == {INPUT: "exact", PARAMETER: "exact", OUTPUT: "calculated"}[variable.causality]


def test_every_real_has_a_unit_and_a_nominal_value(description):
    for v in description.modelVariables:
        if v.type == "Real":
            assert v.unit in variables.UNITS, v.name
            assert float(v.nominal) > 0, v.name
            assert v.displayUnit == (variables.UNITS[v.unit].display or None), v.name


def test_units_are_si_and_shown_as_engineers_read_them(description):
    units = description.unitDefinitions
    bases = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")
    exponents = {u.name: {b: getattr(u.baseUnit, b) for b in bases if getattr(u.baseUnit, b)} for u in units}
    assert exponents == {
        "m": {"m": 1},
        "rad": {"rad": 1},
        "N": {"kg": 1, "m": 1, "s": -2},
        "N.m": {"kg": 1, "m": 2, "s": -2},
        "W": {"kg": 1, "m": 2, "s": -3},
        "Pa": {"kg": 1, "m": -1, "s": -2},
        "m2": {"m": 2},
        "1/m": {"m": -1},
        "1": {},
        "m/s": {"m": 1, "s": -1},
        "rad/s": {"rad": 1, "s": -1},
        "s/m": {"m": -1, "s": 1},
        "s": {"s": 1},
        "N/m": {"kg": 1, "s": -2},
        "N.s/m": {"kg": 1, "s": -1},
        "W/m": {"kg": 1, "m": 1, "s": -3},
    }
    shown = {d.name: float(d.factor) for u in units for d in u.displayUnits}
    assert shown == {
        "mm": 1e3,
        "deg": 180 / math.pi,
        "kN": 1e-3,
        "kN.m": 1e-3,
        "kW": 1e-3,
        "MPa": 1e-6,
        "mm2": 1e6,
    }


def test_start_values_lie_within_their_limits(description):
    for v in description.modelVariables:
        if v.type == "Real" and v.start is not None:
            assert float(v.min) <= float(v.start) <= float(v.max), v.name


def test_dependencies(description):
    follows = {u.variable.name: {d.name for d in u.dependencies} for u in description.outputs}
    assert set(follows) == set(OUTPUT_NAMES)
    # declared once for all methods: in elastic contact all that is read moves everything, velocities and
    # friction too, where friction carries a part of a vertical load
    read = {
        "lateral_shift",
        "yaw",
        "normal_force",
        "load_transfer",
        "vertical_shift_input",
        "roll_input",
        *(row.name for row in (*RAILS, *MOTION, *FRICTION, *RATES, *TORQUES, TIME_STEP, *DEFLECTIONS)),
    }
    for name, inputs in follows.items():
        given = {"vertical_shift_input", "roll_input"} if name.startswith("equilibrium.") else set()
        assert inputs == read - given, name
    initial = {u.variable.name: {d.name for d in u.dependencies} for u in description.initialUnknowns}
    assert set(initial) == set(OUTPUT_NAMES)
    parameters = {v.name for v in VARIABLES if v.causality == PARAMETER}
    assert {"gauge", "wheel_profile", "normal_model"} <= parameters
    for name, known in initial.items():
        assert known == follows[name] | parameters, name


def test_the_model_s_description_names_no_method(description):
    """It would be incomplete with the next one; and says what there is since there are creep forces."""
    names = {name.lower() for choices in CHOICES.values() for name in choices} - {"normal", "none"}
    assert not names & set(re.findall(r"\w+", description.description.lower()))
    assert "creep forces" in description.description


GEOMETRY = ("contact.", "contact_angle", "rolling_radius", "curvature_")


def is_geometry(name):
    """Whether the output is one of rigid contact's geometry."""
    return (
        name in ("roll", "vertical_shift")
        or "patch[" not in name
        and name.partition(".")[2].startswith(GEOMETRY)
    )


#: What an output of each contact mode does not follow: inputs, and the outputs that this is said of.
FREE = {
    "rigid": {
        "roll_guess": lambda name: True,
        "normal_force": is_geometry,
        "load_transfer": is_geometry,
        "vertical_shift_input": lambda name: True,
        "roll_input": lambda name: True,
    },
    "elastic": {name: lambda name: True for name in ("roll_guess", "vertical_shift_input", "roll_input")},
    "compliant": {name: lambda name: True for name in ("roll_guess", "normal_force", "load_transfer")},
}

OF_WHEELS = {row.name for row in RATES}
MOVING = {row.name for row in MOTION} | OF_WHEELS
ROLLING_CONTACT = {row.name for row in FRICTION}
#: Torques on the axle, which change the rotation of wheels that roll freely; those of single wheels.
DRIVING = {row.name for row in TORQUES}
OF_SINGLE = DRIVING - {"axle_torque"}
#: Read where rails stand on springs (tests/fmu/test_springs.py).
SPRUNG = {row.name for row in (TIME_STEP, *DEFLECTIONS)}
#: Words in the names of what creep forces change, while friction carries no part of the load.
OF_CREEP = (
    "tangential.",
    "stick_share",
    "max_shear",
    "friction_power",
    "saturation",
    "wear_number",
    "shear[",
    "slip[",
    "driving_torque",
    "derailment_quotient",
    "force.x",
    "force.y",
    "force.z",
    "moment.x",
    "moment.y",
    "moment.z",
)
#: Methods under which dependencies are tried: contact mode, and others.
METHODS = {
    "rigid": {},
    "elastic": {},
    "compliant": {},
    "rigid, creep forces": {"tangential_model": "polach"},
    "elastic, creep forces": {"tangential_model": "polach"},
    "compliant, creep forces": {"tangential_model": "polach"},
    "rigid, vertical load": {"tangential_model": "polach", "load": "vertical"},
    "rigid, independent wheels": {"tangential_model": "polach", "independent_wheels": True},
    "elastic, vertical load": {"tangential_model": "polach", "load": "vertical"},
}


def does_not_follow(mode, methods, moved, name):
    """Whether the output ``name`` has nothing of the input ``moved``."""
    creep = "tangential_model" in methods
    if moved in SPRUNG:
        return True  # the rails are rigid
    if moved in ("vertical_velocity", "roll_rate") and mode != "compliant":
        return True  # they follow from contact
    if moved in ({"wheel_rate", "axle_torque"} if "independent_wheels" in methods else OF_WHEELS | OF_SINGLE):
        return True  # it is not read
    if name.endswith("wheel_rate_found") and moved not in MOVING and not creep:
        return True  # no torque tells of a rotation
    if moved in MOVING | ROLLING_CONTACT | DRIVING:
        creepage = (".creepage." in name or "wheel_rate_found" in name) and (creep or moved in MOVING)
        rubbed = creep and any(word in name for word in OF_CREEP) and "normal." not in name
        carried = "load" in methods and not (mode == "rigid" and is_geometry(name))
        return not (creepage or rubbed or carried)
    return FREE[mode].get(moved, lambda output: False)(name)


@pytest.mark.full
@pytest.mark.parametrize("case", METHODS)
def test_declared_dependencies_hold(case):
    """At a pose with nothing special: no output changes with an input that it is not declared to
    follow, nor with one that the methods do not read for it; and every input that they read
    does change something."""
    mode, methods = case.partition(",")[0], METHODS[case]
    system = ContactSystem(contact_mode=mode, **methods)
    pose = {
        "lateral_shift": 1.3e-3,
        "yaw": 2e-3,
        "roll_guess": 0.0,
        "normal_force": 78.5e3,
        "load_transfer": 0.05,
        "vertical_shift_input": 0.2e-3,
        "roll_input": -7e-5,
        "speed": 20.0,
        **dict.fromkeys((row.name for row in (*MOTION[1:], *RAILS, *RATES, *TORQUES)), 0.0),
        **dict.fromkeys(SPRUNG, 0.0),
        "free_rolling": 1.0,
        "track_position": 0.0,
        "wheel_rotation": 0.0,
        **dict.fromkeys(ROLLING_CONTACT, 0.3),
    }
    changes = {
        "lateral_shift": 1e-4,
        "yaw": 1e-3,
        "roll_guess": 1e-3,
        "normal_force": 1e3,
        "load_transfer": 0.01,
        "vertical_shift_input": 1e-6,
        "roll_input": 1e-6,
        **{
            row.name: 0.1 * row.nominal
            for row in (*MOTION, *RAILS, *FRICTION, *RATES, *TORQUES, TIME_STEP, *DEFLECTIONS)
        },
        "free_rolling": -1.0,
        "track_position": 0.1,  # these rails do not change
        "wheel_rotation": 0.1,  # and these wheels are round
    }
    assert set(changes) == set(INPUT_NAMES)
    present = evaluated(pose, system.stepper())
    assert present["status"] == 0
    for name, change in changes.items():
        changed = evaluated({**pose, name: pose[name] + change}, system.stepper())
        outputs = VARIABLES[variables.FIRST_OUTPUT : variables.FIRST_WEAR]
        free = [
            v.name
            for v in outputs
            if name not in v.depends_on or does_not_follow(mode, methods, name, v.name)
        ]
        assert_same({v: changed[v] for v in free}, {v: present[v] for v in free}, WARM_START)
        seen = (
            ".creepage."
            if name in MOVING
            else ".tangential."
            if name in ROLLING_CONTACT | DRIVING
            else ".area"
        )
        moved = [v for v in present if seen in v]
        assert len(free) == len(outputs) or any(changed[v] != present[v] for v in moved), name
    if "load" in methods:
        harder = evaluated({**pose, "left.friction": 0.4}, system.stepper())
        assert harder["left.area"] != present["left.area"], "friction carries none of the load"


def test_capabilities(description):
    ability = description.coSimulation
    assert not ability.needsExecutionTool
    assert ability.canHandleVariableCommunicationStepSize
    assert ability.canGetAndSetFMUstate and ability.canSerializeFMUstate
    assert not ability.canBeInstantiatedOnlyOncePerProcess
    assert {c.name for c in description.logCategories} == {"logStatusWarning", "logStatusError"}
    assert "PythonFMU" in description.generationTool
