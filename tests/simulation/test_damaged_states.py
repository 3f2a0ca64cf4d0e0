"""Damaged states of a session are refused, and the session goes on."""

import pytest

from tests.helpers.damages import damages
from tests.helpers.faults import needs_linux
from wrcontact.interface.variables import REFERENCE
from wrcontact.simulation.session import Refused as StateRefused
from wrcontact.simulation.session import Session

pytestmark = needs_linux


@pytest.mark.parametrize("count", [500, pytest.param(20_000, marks=pytest.mark.full)])
def test_damaged_states_of_a_session_are_refused(count):
    """Those of the FMUs are in tests/fmu."""
    one, other = (Session(tell=lambda sentence: None) for _ in range(2))
    for session in (one, other):
        session.start()
        session.set_reals([0, 1], [3e-3, 1e-3])
        session.step()
    for name, bad in damages(one.snapshot(), 3, count):
        with pytest.raises(StateRefused, match="the saved state .*; the present state is kept"):
            one.restore(bad)
            pytest.fail(name)
    for session in (one, other):
        session.set_reals([0], [6e-3])
    assert one.get_reals([REFERENCE["roll"]]) == other.get_reals([REFERENCE["roll"]]) and one.status == 0
