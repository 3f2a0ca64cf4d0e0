"""Both FMUs for model exchange in one CVode: the wheelset's equations, the same motion as by fixed steps, and
fewer calls."""

import re
from ctypes import c_double

import numpy as np
import pytest
from fmpy.validation import validate_fmu

from examples.hunting_wheelset.exchange import (
    NOMINAL,
    STATES,
    Model,
    build_exchange,
    error,
    solved,
    stepped,
)
from examples.hunting_wheelset.wheelset import FORCES, PARAMETERS, Wheelset
from tests.helpers.paths import ROOT

CURVE = {
    "curve_curvature": 1 / 300,
    "curve_start": 2.0,
    "transition_length": 5.0,
    "canted": 0.3,
    "half_wheelbase": 1.2,
    "longitudinal_stiffness": 4e5,
    "lateral_stiffness": 2e5,
    "vertical_stiffness": 1e6,
    "lateral_damping": 2e3,
    "longitudinal_damping": 1e3,
    "vertical_damping": 3e4,
    "frame_speed": 30.0,
}


@pytest.fixture(scope="module")
def exchange(archives, tmp_path_factory):
    """The wheelset for model exchange."""
    return build_exchange(tmp_path_factory.mktemp("exchange"))


def test_description(exchange):
    assert validate_fmu(str(exchange)) == []


@pytest.mark.parametrize("distance", [0.0, 4.0, 20.0], ids=["straight", "transition", "curve"])
def test_equations_are_those_of_the_example(exchange, distance):
    """The rates of random states under random forces, against the Python class's accelerations."""
    random = np.random.default_rng(7)
    unit, twin = Model(exchange, "wheelset", **CURVE), Wheelset(instance_name="twin")
    twin.parameters.update(CURVE)
    twin.prepare()
    unit.start()
    for _ in range(20):
        states = np.array([*(NOMINAL[:9] * random.normal(size=9)), distance])
        twin.forces = dict(zip(FORCES, (1e4 * random.normal(size=6)).tolist()))
        twin.place, twin.rate = states[:4].tolist(), states[4:9].tolist()
        unit.ports(FORCES).write(list(twin.forces.values()))
        unit.slave.setContinuousStates((c_double * 10)(*states), 10)
        rates = (c_double * 10)()
        unit.slave.getDerivatives(rates, 10)
        wanted = [*twin.rate[:4], *twin.accelerations(distance), CURVE["frame_speed"]]
        np.testing.assert_allclose(rates, wanted, rtol=1e-12, err_msg=f"{states}")
        seen = unit.ports([*STATES, "track_curvature"]).read()
        np.testing.assert_allclose(seen, [*states, twin.curvature(distance)[0]], rtol=1e-15)
    unit.close()
    assert set(CURVE) < set(PARAMETERS)


def test_the_motion_is_that_of_small_steps(archives, exchange):
    """Explicit steps, extrapolated to none, lead where the solver does: against the flange and back."""
    run = solved((archives[0], exchange), 1e-7, duration=0.2)
    coarse, fine = (stepped(archives, step, duration=0.2) for step in (5e-5, 2.5e-5))
    extrapolated = 2 * fine.motion - coarse.motion
    assert np.ptp(run.motion[:, 0]) > 11e-3  # to the other flange
    assert error(fine, run) > 1e-6
    assert np.abs(extrapolated[:, 0] - run.motion[:, 0]).max() < 0.1 * error(fine, run)


def test_fewer_calls_for_a_smaller_error(archives, exchange):
    """A row of the table in docs/guides/closed_loop.md again: its calls within 10 %, which rounding may
    move; about
    half as many as by explicit steps of 0.1 ms, and less than a tenth of the error.  Largest status 1, a
    wheel without load for moments."""
    pair = archives[0], exchange
    finest, run, fixed = solved(pair, 1e-7), solved(pair, 1e-4), stepped(archives, 1e-4)
    assert run.evaluations < 0.6 * fixed.evaluations
    assert error(run, finest) < 0.1 * error(fixed, finest)
    assert run.worst_status <= 1 and np.ptp(run.motion[:, 0]) > 12e-3
    page = (ROOT / "docs" / "guides" / "closed_loop.md").read_text(encoding="utf-8")
    steps, calls = map(int, re.search(r"CVode, tolerance 1e-04 \| (\d+) \| (\d+)", page).groups())
    assert run.steps == pytest.approx(steps, rel=0.1) and run.evaluations == pytest.approx(calls, rel=0.1)
