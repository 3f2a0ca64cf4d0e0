"""Rails on springs in the FMUs: outputs, the memory of a step and the equilibrium are those of the package."""

import pytest

from tests.helpers.fmus import WARM_START
from wrcontact import ContactSystem

SPRINGS = {"contact_mode": "compliant", "tangential_model": "polach", "rail_lateral_stiffness": 2e7,
           "rail_vertical_stiffness": 5e7, "left_rail_vertical_stiffness": 9e7, "rail_vertical_damping": 1e5}
ROWS = [{"lateral_shift": 1e-3 * k, "vertical_shift_input": 1.3e-3, "roll_input": -1e-4, "speed": 20.0,
         "rail_time_step": 0.01 * (k > 0), "left.rail_deflection_vertical_before": 1e-4 * k} for k in range(5)]
NAMES = ["force.y", "left.force.z", "right.force.z", "left.rail_deflection_lateral",
         "right.rail_deflection_lateral", "left.rail_deflection_vertical", "right.rail_deflection_vertical",
         "equilibrium.vertical_shift", "status"]


def test_rails_on_springs(run):
    seen = run("trajectory", rows=ROWS, names=NAMES, start=SPRINGS)["seen"]
    system = ContactSystem(**SPRINGS)
    for row, found in zip(ROWS, seen, strict=True):
        state = system.evaluate(**{name.replace(".", "_"): value for name, value in row.items()})
        assert found["status"] == state.status == 0
        assert found["left.rail_deflection_vertical"] > 1e-4
        for name in NAMES[:-1]:
            assert found[name] == pytest.approx(state[name], rel=WARM_START), (name, row)
    assert seen[1]["left.rail_deflection_vertical"] != pytest.approx(seen[0]["left.rail_deflection_vertical"],
                                                                     rel=1e-3)
