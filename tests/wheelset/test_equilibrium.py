"""Height and roll at which a compliant wheelset carries its load."""

import math
import pickle

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import system
from wrcontact.interface.variables import REFERENCE
from wrcontact.simulation.session import Session

POSES = [(0.0, 0.0, 0.0), (3e-3, 0.01, 0.2), (5.4e-3, 0.0, -0.3), (-6.8e-3, -0.02, 0.1)]
FORCE = 80e3


@pytest.mark.parametrize("load", ["normal", "vertical"])
@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
@pytest.mark.parametrize("shift, yaw, transfer", POSES)
def test_a_wheelset_that_starts_there_carries_its_load(shift, yaw, transfer, model, load):
    one = system(contact_mode="compliant", normal_model=model, load=load)
    stand = one.evaluate(shift, yaw, FORCE, transfer).equilibrium
    state = one.evaluate(shift, yaw, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    assert stand.status == 0
    for sign, wheel in ((-1, state.left), (1, state.right)):
        carried = wheel.normal_force if load == "normal" else -wheel.force.z
        assert carried == pytest.approx(FORCE * (1 + sign * transfer), rel=1e-9)


def test_of_tables_and_rows():
    one = system(contact_mode="compliant")
    table = one.evaluate_many(np.array([0.0, 2e-3]), normal_force=FORCE)
    row = one.evaluate(2e-3, normal_force=FORCE)
    assert table.equilibrium.roll[1] == table[1].equilibrium.roll == row["equilibrium.roll"]
    assert pickle.loads(pickle.dumps(row)).equilibrium == row.equilibrium
    assert isinstance(row.equilibrium.roll, float)


def test_where_there_is_none():
    off = system(contact_mode="compliant").evaluate(0.02).equilibrium
    assert off.status == 2 and math.isnan(off.roll)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_other_modes_are_there(mode):
    state = system(contact_mode=mode).evaluate(3e-3, 0.01)
    assert state.equilibrium == (state.vertical_shift, state.roll, 0)


@pytest.fixture
def session():
    """A compliant wheelset, and the lines that it tells."""
    lines = []
    made = Session(log=lines.append)
    made.set_strings([REFERENCE["contact_mode"]], ["compliant"])
    made.start()
    lines.clear()
    return made, lines


EQUILIBRIUM = [REFERENCE[name] for name in ("equilibrium.vertical_shift", "equilibrium.roll")]


def test_it_is_found_when_it_is_read(session, monkeypatch):
    made, _ = session
    found = []
    monkeypatch.setattr(
        wrcontact.simulation.session.Session,
        "_find_equilibrium",
        lambda self, find=Session._find_equilibrium: (found.append(1), find(self)),
    )
    made.set_reals([REFERENCE["lateral_shift"], REFERENCE["normal_force"]], [3e-3, FORCE])
    made.get_reals([REFERENCE["roll"], REFERENCE["right.area"]])
    assert found == []
    height, roll = made.get_reals(EQUILIBRIUM)
    wanted = system(contact_mode="elastic").evaluate(3e-3, 0.0, FORCE)
    assert (height, roll) == pytest.approx((wanted.vertical_shift, wanted.roll), rel=1e-9)
    made.get_reals(EQUILIBRIUM)
    assert found == [1]
    saved = made.snapshot()
    made.set_reals([REFERENCE["lateral_shift"]], [-3e-3])
    assert made.get_reals(EQUILIBRIUM)[1] == pytest.approx(-roll, rel=1e-6)
    made.restore(saved)
    assert made.get_reals(EQUILIBRIUM) == [height, roll] and found == [1, 1]


def test_one_sentence_where_there_is_none(session):
    """Beyond the profiles the step says so, and the last values stay."""
    made, lines = session
    before = made.get_reals(EQUILIBRIUM)
    lines.clear()
    made.set_reals([REFERENCE["lateral_shift"]], [0.02])
    assert made.get_reals(EQUILIBRIUM) == before
    assert len(lines) == 1 and "lateral_shift is 0.02 m" in lines[0]
