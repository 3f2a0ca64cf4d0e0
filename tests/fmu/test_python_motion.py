"""The Python FMU: velocities in, a switch, creepages and the equilibrium out."""

from tests.helpers.cases import poses
from tests.helpers.fmus import assert_same, session, stepped
from wrcontact.interface.variables import REFERENCE, VARIABLES

NAMES = [v.name for v in VARIABLES if ".creepage." in v.name]
EQUILIBRIUM = ["equilibrium.vertical_shift", "equilibrium.roll"]


def test_creepages_and_equilibrium(run):
    rows = [{**pose, "speed": 25.0, "lateral_velocity": 0.04, "yaw_rate": 0.05, "free_rolling": bool(k % 2),
             "right.rail_lateral_velocity": 0.02, "vertical_shift_input": 3e-4}
            for k, pose in enumerate(poses(4))]
    for start in ({}, {"contact_mode": "compliant"}):
        seen = run("trajectory", rows=rows, names=NAMES + EQUILIBRIUM, start=start)["seen"]
        made = session(**start)
        for row, found in zip(rows, seen):
            wanted = stepped(made, row)
            wanted |= dict(zip(EQUILIBRIUM, made.get_reals([REFERENCE[name] for name in EQUILIBRIUM])))
            assert_same(found, {name: wanted[name] for name in NAMES + EQUILIBRIUM}, 1e-7)
        assert seen[0]["left.patch[1].creepage.x"] > 1.9        # wheels that do not turn
