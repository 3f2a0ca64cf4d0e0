"""Work of a step on the speed's trajectory, as the kernel counts it: the same on every machine.

The budgets are what was counted when they were set, and 3 % more. Work that grows past them is a change that
has to be wanted; work that falls far below them asks for lower ones.
"""

import pytest

from benchmarks import counts, trajectory
from wrcontact.kernel.binding.library import default_kernel

STEPS, EVERY = 400, 50       # the 20 s of the trajectory, each 50th step
#: Gap evaluations, scans, roll iterations, nodes, force solves and strip systems of a step (counts.COUNTS).
BUDGETS = {
    "Hertz, rigid": (32.57, 2.03, 4.14, 2.00, 0.00, 0.00),
    "ANALYN, rigid": (62.40, 2.03, 4.14, 51.80, 7.45, 0.00),
    "strips, rigid": (62.40, 2.03, 4.14, 79.06, 7.00, 5.50),
    "ANALYN, compliant": (85.27, 2.00, 0.00, 43.74, 2.65, 0.00),
    "ANALYN, elastic": (325.70, 4.69, 8.65, 212.22, 26.96, 0.00),
    "strips, compliant": (85.27, 2.00, 0.00, 71.05, 2.62, 5.49),
    "strips, elastic": (307.85, 4.69, 8.34, 311.62, 28.24, 23.48),
}
SLACK = 1.03


@pytest.mark.skipif(not default_kernel().compiled, reason="no compiled library here")
@pytest.mark.parametrize("name", BUDGETS)
def test_work_stays_within_its_budget(name):
    parameters, _ = trajectory.ROWS[name]
    found = trajectory.work(parameters, STEPS, EVERY)
    for what, value, budget in zip(counts.COUNTS, found, BUDGETS[name]):
        assert value <= SLACK * budget, what
        assert value >= 0.8 * budget, f"{what}: set a lower budget"


def test_every_row_has_a_budget_and_its_line():
    assert set(BUDGETS) == set(trajectory.ROWS)
    lines = trajectory.table(count=5, rounds=1).splitlines()
    assert sum(line.startswith("|") for line in lines) == 2 + len(trajectory.ROWS)
