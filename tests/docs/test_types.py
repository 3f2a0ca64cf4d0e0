"""What editors and type checkers know of the package is what it has, and they see a user's errors."""

import ast
import os
import re
import subprocess
import sys
from importlib.util import find_spec
from inspect import signature
from pathlib import Path

import pytest

import wrcontact
from tests.helpers.paths import ROOT
from tools import make_fields
from wrcontact import ContactSystem, WheelContact, keywords
from wrcontact.interface.one_wheel import WITHOUT

#: A user's program without an error; a line with the word "wrong" has one.
PROGRAM = """
from typing import Any

import numpy as np
from numpy.typing import NDArray
from typing_extensions import assert_type

import wrcontact

system = wrcontact.ContactSystem(wheel="S1002", rail=("UIC60", "UIC60"), rail_inclination="1:40",
                                 normal_model=wrcontact.Analyn(tolerance=0.004),
                                 tangential_model="strips", material=wrcontact.Material(poisson_ratio=0.3))
state = system.evaluate(1e-3, 0.0, normal_force=78.5e3, left_friction=0.4, free_rolling=True)
assert_type(state, wrcontact.WheelsetState)
assert_type(state.status, wrcontact.Status)
assert_type(state.right.patches[0].area, float)
assert_type(state.right.patches[0].creepage.spin, float)
assert_type(state.left.contact.y_wheel, float)
assert_type(state.right.normal.force.z, float)
assert_type(state.right.patch_count, int)
assert_type(state.equilibrium.roll, float)
assert_type(state["right.area"], float)
pressure: NDArray[Any] = state.right.outline.pressure
table = system.evaluate_many(np.linspace(-1e-3, 1e-3, 5), outputs=["right.area"], threads=2)
area: NDArray[Any] = table.right.area
roll: float = table[2].roll
some: NDArray[Any] = table[1:3].roll
stepper = system.stepper(side="right")
stepper.inputs[stepper.place("speed")] = 20.0
force, moment = stepper.resultant(wrcontact.motion_of([0, 0, -0.46], np.eye(3), [20, 0, 0], [0, -43, 0]))
quotient: float = state.right.derailment_quotient
places: NDArray[Any] = state.right.strips[0].wheel_place
filtered: NDArray[Any] = wrcontact.low_pass(wrcontact.guiding_forces(table).sum_y, 1e-3)
slopes: NDArray[Any] = system.derivatives(of=["force.y"], by=["yaw"], lateral_shift=1e-3)
wheel = wrcontact.WheelContact(side="left", contact_damping=0.01).evaluate(vertical_shift_input=1e-4)
assert_type(wheel.force.x, float)
patch = wrcontact.elliptic_patch(6e-3, 4e-3, 8e4)
creep = wrcontact.creep_forces(patch, friction=0.4, tangential_model=wrcontact.Fastsim(published_spin=1))
assert_type(creep.moment, float)
assert_type(wrcontact.creep_forces(state.right.patches[0], 1e-3).x, float)
profile: wrcontact.Profile | wrcontact.WheelSections = wrcontact.check(system).system.wheel
swept = wrcontact.sweep(system, {"yaw": np.linspace(0.0, 1e-3, 3)}, ["roll"], "a.zarr", workers=2, speed=10.0)
between: NDArray[Any] = wrcontact.interpolate(swept, method="cubic")(yaw=0.5e-3)["roll"]
worst: float = wrcontact.interpolate("a.zarr").errors["roll"].worst
wears = wrcontact.Wear(wrcontact.WheelContact(), wrcontact.Usfd())
wears.add(wrcontact.WheelContact().evaluate_many(lateral_shift=[0.0]))
cracks = wrcontact.fatigue(wrcontact.WheelContact().evaluate(), yield_shear=3e8).damage
bad = wrcontact.Wear("S1002", wrcontact.Usfd())  # wrong: a system or a wheel
bad = wrcontact.sweep(system, {"yaw": [0.0]}, speed="fast")  # wrong: a number
bad = system.evaluate(lateralshift=1e-3)  # wrong: no such input
bad = wrcontact.ContactSystem(contact_mode="elastik")  # wrong: no such mode
bad = wrcontact.ContactSystem(gauge="wide")  # wrong: a number
bad = state.right.aera  # wrong: no such output
bad = state.right.patches[0].creepage.x.y  # wrong: a number
bad = wrcontact.Analyn(tolerance="fine")  # wrong: a number
bad = wrcontact.WheelContact(load="vertical")  # wrong: one wheel has none
"""
WRONG = [number for number, line in enumerate(PROGRAM.splitlines(), 1) if "# wrong" in line]


def test_the_package_says_that_it_has_types():
    """In its modules: there are no stubs, and what follows from the tables is as they are."""
    assert (ROOT / "wrcontact" / "py.typed").exists() and not list((ROOT / "wrcontact").rglob("*.pyi"))
    for path, text in make_fields.files().items():
        assert path.read_text(encoding="utf-8") == text, f"python tools/make_fields.py writes {path.name}"


def test_the_keywords_are_those_of_the_calls():
    """Names and order of what the package takes when it runs."""
    for function, typed in (
        (ContactSystem.__init__, "SystemKeywords"),
        (ContactSystem.evaluate, "PoseInputs"),
        (ContactSystem.evaluate_many, "TableInputs"),
        (WheelContact.__init__, "WheelKeywords"),
        (WheelContact.evaluate, "WheelInputs"),
    ):
        assert f"Unpack[{typed}]" in str(function.__annotations__), typed
    taken = {
        "SystemKeywords": set(signature(ContactSystem).parameters)
        - {"wheel", "rail", "track", "wheelset", "material", "friction"},
        "PoseInputs": set(signature(ContactSystem.evaluate).parameters)
        - {"self", "penetration", "side", "outputs"},
        "TableInputs": set(signature(ContactSystem.evaluate_many).parameters)
        - {"self", "penetration", "side", "outputs", "processes", "threads"},
        "WheelInputs": set(signature(WheelContact.evaluate).parameters) - {"self", "outputs"},
    }
    for typed, names in taken.items():
        assert set(getattr(keywords, typed).__annotations__) == names, typed
    own = {name for name in taken["SystemKeywords"] if not name.startswith("left_")} - set(WITHOUT)
    assert set(keywords.WheelKeywords.__annotations__) == own | {"track", "wheelset", "material", "friction"}


def test_what_is_imported_later_is_known_to_type_checkers():
    """The names that the face imports when they are first used stand in it for type checkers, too."""
    face = ast.parse((ROOT / "wrcontact" / "__init__.py").read_text(encoding="utf-8"))
    (block,) = (node for node in face.body if isinstance(node, ast.If))
    named = {alias.name for node in block.body for alias in node.names if isinstance(node, ast.ImportFrom)}
    assert named - {"*", "OneProfile"} == {*wrcontact._ELSEWHERE, *wrcontact._LATER}
    assert all(hasattr(wrcontact, name) for name in wrcontact.__all__)


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    """A folder with the user's program, and how mypy and pyright find the package."""
    folder = tmp_path_factory.mktemp("types")
    (folder / "program.py").write_text(PROGRAM, encoding="utf-8")
    (folder / "mypy.ini").write_text(
        "[mypy]\nstrict = true\nfollow_imports = silent\nignore_missing_imports = true\n", encoding="utf-8"
    )
    (folder / "pyrightconfig.json").write_text(
        f'{{"extraPaths": [{str(ROOT)!r}], "typeCheckingMode": "standard"}}'.replace("'", '"'),
        encoding="utf-8",
    )
    return folder


def run(folder, package, *command):
    """The lines that a type checker prints."""
    if not find_spec(package):
        pytest.skip(f"{package} is not installed")
    programs = Path(sys.executable).parent
    found = subprocess.run(
        [programs / command[0], *command[1:]],
        cwd=folder,
        capture_output=True,
        text=True,
        env=os.environ | {"MYPYPATH": str(ROOT), "PYTHONPATH": str(ROOT)},
        check=False,
    )
    return (found.stdout + found.stderr).splitlines()


def wrong_lines(lines):
    """Numbers of the program's lines that have an error."""
    found = (re.search(r"program\.py:(\d+):.*?error", line) for line in lines)
    return sorted({int(one[1]) for one in found if one})


@pytest.mark.full
def test_mypy_sees_a_user_s_errors_and_no_others(program):
    lines = run(program, "mypy", "mypy", "program.py")
    assert wrong_lines(lines) == WRONG, "\n".join(lines)


@pytest.mark.full
def test_pyright_sees_a_user_s_errors_and_no_others(program):
    lines = run(program, "basedpyright", "basedpyright", "--pythonpath", sys.executable, "program.py")
    assert wrong_lines(lines) == WRONG, "\n".join(lines)
