"""Which call a session permits when, its times, and that a saved state holds them."""

import math

import pytest

from tests.helpers.fake_system import FakeSystem
from wrcontact.interface.variables import REFERENCE
from wrcontact.simulation import session as module
from wrcontact.simulation.fmi_state_machine import INITIALISING, INSTANTIATED, RUNNING, TERMINATED
from wrcontact.simulation.session import Refused, Session

PHASES = (INSTANTIATED, INITIALISING, RUNNING, TERMINATED)
CALLS = {
    "set_up": {INSTANTIATED},
    "enter": {INSTANTIATED},
    "leave": {INITIALISING},
    "terminate": {RUNNING},
    "step": {RUNNING},
}
ARGUMENTS = {"set_up": (0.0, 1.0), "step": (0.0, 1e-3)}


def brought_to(phase, start=0.0, stop=1.0):
    """A session in a phase of its life."""
    session = Session(log=None)
    session.set_up(start, stop)
    for call in ("enter", "leave", "terminate")[: PHASES.index(phase)]:
        getattr(session, call)()
    assert session.machine.phase == phase
    return session


@pytest.fixture(autouse=True)
def fake(monkeypatch):
    monkeypatch.setattr(module, "ContactSystem", FakeSystem)


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize("call", CALLS)
def test_each_call_has_its_phases(phase, call):
    session = brought_to(phase)
    if phase in CALLS[call]:
        getattr(session, call)(*ARGUMENTS.get(call, ()))
    else:
        before = session.snapshot()
        with pytest.raises(Refused):
            getattr(session, call)(*ARGUMENTS.get(call, ()))
        assert session.snapshot() == before


@pytest.mark.parametrize("start, stop", [(math.nan, None), (math.inf, None), (1.0, 0.5), (0.0, math.nan)])
def test_times_that_are_none_are_refused(start, stop):
    with pytest.raises(Refused, match="permitted are a finite startTime"):
        Session().set_up(start, stop)


@pytest.mark.parametrize(
    "time, size, words",
    [
        (0.0, -1.0, "-1.0 s at 0.0 s is not possible"),
        (0.0, math.nan, "nan s"),
        (0.0, math.inf, "inf s"),
        (math.nan, 0.0, "at nan s"),
        (-math.inf, 0.0, "-inf s"),
        (1e308, 1e308, "is not possible"),
        (0.5, 0.6, "after the stopTime 1.0 s"),
        (1.0, 1e-3, "after the stopTime"),
    ],
)
def test_steps_that_are_none_are_refused(time, size, words):
    session = brought_to(RUNNING)
    with pytest.raises(Refused, match=words):
        session.step(time, size)
    assert session.machine.time == 0.0


def test_steps_up_to_the_stop_with_the_rounding_of_a_sum():
    session = brought_to(RUNNING)
    for time, size in (
        (0.0, 0.0),
        (0.0, 5e-324),
        (0.0, 1.0),
        (0.0, 1.0 + 1e-12),
        (0.9, 0.1 + 1e-8),
        (-3.0, 1.0),
    ):
        session.step(time, size)
    unlimited = Session(log=None)
    unlimited.start()
    unlimited.step(0.0, 1e6)
    unlimited.step()
    assert unlimited.machine.time == 1e6


@pytest.mark.parametrize("present", PHASES)
@pytest.mark.parametrize("saved", PHASES)
def test_a_saved_state_holds_mode_time_and_stop_time(saved, present):
    one, other = brought_to(saved), brought_to(present, 5.0, 10.0)
    one.machine.time = 0.25
    other.restore(one.snapshot())
    assert (other.machine.phase, other.machine.time, other.machine.stop) == (saved, 0.25, 1.0)
    if saved == RUNNING:
        with pytest.raises(Refused, match="stopTime 1.0 s"):
            other.step(0.9, 0.2)


def test_values_of_a_terminated_session_can_be_read_only():
    session = brought_to(TERMINATED)
    session.get_reals([REFERENCE["roll"]])
    with pytest.raises(Refused, match="yaw cannot be set: the simulation has been terminated"):
        session.set_reals([REFERENCE["yaw"]], [0.0])


def test_outputs_are_read_from_the_initialisation_on():
    session = brought_to(INSTANTIATED)
    assert session.get_reals([REFERENCE["yaw"], REFERENCE["gauge"]]) == [0.0, 1.435]
    for read, name in ((session.get_reals, "roll"), (session.get_integers, "status")):
        with pytest.raises(Refused, match=f"{name} is an output and cannot be read before"):
            read([REFERENCE[name]])
    session.enter()
    session.get_reals([REFERENCE["roll"]])
