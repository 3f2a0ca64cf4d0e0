"""The example with solvers: they agree, and what each asks of the contact is bounded."""

import numpy as np
import pytest

from examples.implicit_wheelset import SOLVERS, Nearby, Wheelset, run
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
#: Steps and derivatives of the contact that a step of the solver takes at most; a vehicle with four
#: wheelsets and an implicit solver has to do with 30.
CALLS = {"Euler, semi-implicit, 0.25 ms": 1, "trapezoidal, linearised, 1 ms": 3}


@pytest.mark.parametrize(
    "name", [name if name in CALLS else pytest.param(name, marks=pytest.mark.full) for name in SOLVERS]
)
def test_solvers_agree(name):
    steps, evaluated, derived, largest, _ = run(name)
    assert largest == pytest.approx(0.9757e-3, rel=2e-3)  # mm; RK45 at a hundredth of the tolerance
    if name in CALLS:
        assert evaluated + derived <= CALLS[name] * steps and 4 * CALLS[name] <= 30


def test_the_jacobian_is_that_of_the_rates():
    wheelset = Wheelset()
    motion = wheelset.start + np.array([3e-4, 1e-6, 1e-5, 1e-3, 0.01, 1e-3, 1e-3, 0.01, 0.05])
    found = wheelset.jacobian(0.2, motion)
    for column, step in enumerate((1e-8, 1e-9, 1e-9, 1e-7, 1e-6, 1e-6, 1e-6, 1e-6, 1e-4)):
        way = step * np.eye(9)[column]
        wanted = (wheelset.rates(0.2, motion + way) - wheelset.rates(0.2, motion - way)) / (2.0 * step)
        np.testing.assert_allclose(found[:, column], wanted, rtol=1e-5, atol=1e-6 * np.abs(wanted).max())


def test_near_places_are_answered_by_derivatives():
    """Differences for a Jacobian take one derivative and no step; a place further away takes a step."""
    wheelset, exact = Nearby(), Wheelset()
    wheelset.rates(0.2, wheelset.start)
    for row in np.eye(9):
        near = wheelset.start + 1e-8 * row
        np.testing.assert_allclose(wheelset.rates(0.2, near), exact.rates(0.2, near), rtol=1e-6, atol=1e-6)
    assert (wheelset.steps, wheelset.derivatives) == (1, 1)
    far = wheelset.start + 1e-6 * np.eye(9)[0]
    assert np.array_equal(wheelset.rates(0.2, far), exact.rates(0.2, far)) and wheelset.steps == 2
