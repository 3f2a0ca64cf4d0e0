"""The wheelset of examples/engines in Drake and MuJoCo: hunting and Klingel's wave against theory."""

import re
from importlib import import_module
from importlib.util import find_spec

import numpy as np
import pytest

from examples.engines import case
from tests.helpers.paths import ROOT
from wrcontact.kernel.binding.library import default_kernel

compiled = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
ENGINES = [
    pytest.param(
        name,
        marks=[
            pytest.mark.full,
            pytest.mark.skipif(not find_spec(package), reason=f"{name} is not installed"),
        ],
    )
    for name, package in (("drake", "pydrake"), ("mujoco", "mujoco"))
]
SPEED = 20.0  # [m/s]


@compiled
def test_closed_form_and_derivatives_agree():
    """Linear theory knows no saturation, of which the spin of cones makes 2 % of growth at a friction of 2."""
    near, wanted = case.linear_motion(SPEED), case.theory(SPEED)
    assert near.imag == pytest.approx(wanted.imag, rel=3e-4)
    assert near.real == pytest.approx(wanted.real, rel=0.03)
    free = case.linear_motion(5.0, case.Springs())
    assert 2 * np.pi * 5.0 / free.imag == pytest.approx(case.klingel(), rel=2e-4)


def test_a_wheelset_that_stands_is_at_rest():
    """In the middle weight, frame and rails balance; aside the springs push it back."""
    for shift in (0.0, 1e-3):
        made = case.Wheelset(SPEED, shift=shift)
        roll = np.array(
            [
                [1.0, 0, 0],
                [0, np.cos(made.roll), -np.sin(made.roll)],
                [0, np.sin(made.roll), np.cos(made.roll)],
            ]
        )
        force, moment = made.pushes(made.position, roll, np.zeros(3), np.zeros(3))
        assert force[2] == pytest.approx(-case.MASS * case.GRAVITY, rel=0.02)  # normals lean by 0.05 rad
        rigid = case.Wheelset(SPEED, case.Springs(), shift=shift).pushes(
            made.position, roll, np.zeros(3), np.zeros(3)
        )
        assert force[1] - rigid[0][1] == pytest.approx(-case.SOFT.across * shift, abs=1e-6)
        assert np.array_equal(moment, rigid[1])


@compiled
@pytest.mark.parametrize("engine", ENGINES)
def test_an_engine_agrees_with_theory(engine):
    run = import_module(f"examples.engines.in_{engine}").run
    near = case.linear_motion(SPEED)
    found = run(case.Wheelset(SPEED), 2.0).hunting(near)
    assert found.real == pytest.approx(near.real, rel=1e-3)
    assert found.imag == pytest.approx(near.imag, rel=2e-4)
    wave = run(case.Wheelset(5.0, case.Springs()), 4.0).wave(case.klingel())
    assert wave == pytest.approx(case.klingel(), rel=2e-4)


@compiled
def test_the_page_has_the_numbers():
    page = (ROOT / "docs" / "guides" / "solvers.md").read_text(encoding="utf-8")
    (row,) = re.findall(r"^\| growth \[1/s\] \| (.*) \|$", page, re.MULTILINE)
    *engines, near, wanted = map(float, row.split(" | "))
    assert near == pytest.approx(case.linear_motion(SPEED).real, abs=6e-5)
    assert wanted == pytest.approx(case.theory(SPEED).real, abs=6e-5)
    assert engines == pytest.approx([near, near], abs=2e-4)
    (row,) = re.findall(r"^\| Klingel's wave \[m\] \| (.*) \|$", page, re.MULTILINE)
    *engines, _, wanted = row.split(" | ")
    assert float(wanted) == pytest.approx(case.klingel(), abs=6e-5)
    assert [float(engine) for engine in engines] == pytest.approx([float(wanted)] * 2, rel=1e-4)
