"""Work of a step on the speed's trajectory, as the kernel counts it: the same on every machine.

The budgets are what was counted when they were set, and 3 % more. Work that grows past them is a change that
has to be wanted; work that falls far below them asks for lower ones.
"""

import pytest

from benchmarks import tables, times
from wrcontact.kernel.binding.library import default_kernel

STEPS, EVERY = 400, 50  # the 20 s of the trajectory, each 50th step
#: Gap evaluations, scans, roll iterations, nodes, force solves and strip systems of a step (times.COUNTS).
#:
#: A wheel that strips find more than 1.15 times as deep as estimated is sunk anew
#: (strip_contact.SUNK_DEEPER): 12 % of their gap evaluations in rigid contact, where ANALYN does not. Six
#: sweeps a wheel are 12 systems.
#:
#: A state does not depend on the states before it: a last Newton step starts from a roll that is rounded to
#: 2^-30 rad, about two iterations of the roll and two to four gap evaluations a step more than without it.
BUDGETS = {
    "Hertz, rigid": (32.10, 2.03, 6.20, 0.00, 0.00, 0.00),
    "ANALYN, rigid": (62.37, 2.03, 6.20, 45.65, 7.46, 0.00),
    "strips, rigid": (68.14, 2.03, 6.20, 71.79, 0.00, 12.00),
    "ANALYN, compliant": (60.15, 2.00, 0.00, 39.58, 2.64, 0.00),
    "ANALYN, elastic": (151.84, 4.05, 11.30, 192.14, 27.84, 0.00),
    "strips, compliant": (60.15, 2.00, 0.00, 52.40, 0.00, 12.00),
    "strips, elastic": (154.24, 4.04, 12.12, 321.70, 0.00, 61.22),
}
SLACK = 1.03


@pytest.mark.skipif(not default_kernel().compiled, reason="no compiled library here")
@pytest.mark.parametrize("name", BUDGETS)
def test_work_stays_within_its_budget(name):
    parameters, _ = times.ROWS[name]
    found = times.work(parameters, STEPS, EVERY)
    for what, value, budget in zip(times.COUNTS, found, BUDGETS[name]):
        assert value <= SLACK * budget, what
        assert value >= 0.8 * budget, f"{what}: set a lower budget"


def test_every_row_has_a_budget_and_its_line():
    assert set(BUDGETS) == set(times.ROWS)
    found = times.trajectory_times(quick=True)
    assert list(found) == list(times.ROWS) and all(row["units"] > 0.0 for row in found.values())
    lines = tables.trajectory_table({"trajectory": {"rows": found}}).splitlines()
    assert len(lines) == 2 + len(times.ROWS)
