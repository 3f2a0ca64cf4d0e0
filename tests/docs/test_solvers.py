"""docs/guides/solvers.md: its first example runs, and its table is what the example of solvers gives."""

import re

import numpy as np
import pytest

from examples.implicit_wheelset import SOLVERS, run
from tests.helpers.paths import ROOT
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
PAGE = (ROOT / "docs" / "guides" / "solvers.md").read_text(encoding="utf-8")


def test_the_examples_run():
    names = {}
    first, body, second, third = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    exec(first, names)
    # the wheelset stands on its load
    assert names["force"][2] == pytest.approx(-109e3, rel=0.01) and names["moment"].shape == (3,)
    assert names["slopes"].shape == (2, 3) and np.isfinite(names["slopes"]).all()
    assert names["on_rail"][2] == pytest.approx(54.5e3, rel=0.1)
    assert abs(names["about_rail"][0]) < 54.5e3 * 0.03  # half a head's width is its lever at most
    # what holds the wheelset back is stiff against a displacement
    exec(body, names)
    assert names["along_y"].shape == (2,) and np.isfinite(names["about_z"]).all()
    exec(second, names)
    assert names["state"].status == 0 and not names["table"].status.all()
    # a wheel and its rail that sink together stay as they are
    assert names["slopes"].sum() == pytest.approx(0.0, abs=1e-6 * abs(names["slopes"][0, 0]))
    exec(third, names)
    # springs still at work: the vertical one alone carries less than the wheel
    stepper, sunk = names["stepper"], names["stepper"].outputs[names["now"]][3]
    assert 0.0 < 5e7 * sunk < -stepper.outputs[stepper.place("right.force.z")]


@pytest.mark.full
@pytest.mark.machine
@pytest.mark.parametrize("name", SOLVERS)
def test_the_table(name):
    """Counts follow rounding in solvers that choose their steps."""
    (row,) = re.findall(rf"^\| {re.escape(name)} \| (.*) \|$", PAGE, re.MULTILINE)
    *counts, largest = map(float, row.split(" | "))
    found = run(name)
    # without wide vectors numpy sums in another order, and Radau takes 5 % more or fewer calls
    assert found[:3] == pytest.approx(counts, rel=0.1, abs=8)
    assert 1e3 * found[3] == pytest.approx(largest, abs=6e-4)
