"""Rails on springs in the FMUs: outputs, dampers and the equilibrium are those of the package."""

import pytest

from tests.helpers.fmus import WARM_START, needs_compiler
from wrcontact import ContactSystem

SPRINGS = {
    "contact_mode": "compliant",
    "tangential_model": "polach",
    "rail_lateral_stiffness": 2e7,
    "rail_vertical_stiffness": 5e7,
    "left_rail_vertical_stiffness": 9e7,
    "rail_vertical_damping": 1e5,
}
ROWS = [
    {
        "lateral_shift": 1e-3 * k,
        "vertical_shift_input": 1.3e-3,
        "roll_input": -1e-4,
        "speed": 20.0,
        "rail_time_step": 0.01 * (k > 0),
        "left.rail_deflection_vertical_before": 1e-4 * k,
    }
    for k in range(5)
]
NAMES = [
    "force.y",
    "left.force.z",
    "right.force.z",
    "left.rail_deflection_lateral",
    "right.rail_deflection_lateral",
    "left.rail_deflection_vertical",
    "right.rail_deflection_vertical",
    "equilibrium.vertical_shift",
    "status",
]


def test_rails_on_springs(run):
    seen = run("trajectory", rows=ROWS, names=NAMES, start=SPRINGS)["seen"]
    system = ContactSystem(**SPRINGS)
    for row, found in zip(ROWS, seen, strict=True):
        state = system.evaluate(**{name.replace(".", "_"): value for name, value in row.items()})
        assert found["status"] == state.status == 0
        assert found["left.rail_deflection_vertical"] > 1e-4
        for name in NAMES[:-1]:
            assert found[name] == pytest.approx(state[name], rel=WARM_START), (name, row)
    assert seen[1]["left.rail_deflection_vertical"] != pytest.approx(
        seen[0]["left.rail_deflection_vertical"], rel=1e-3
    )


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_dampers_are_refused_in_model_exchange(hosts, version):
    """A damper needs a step in time; springs are there."""
    still = {name: value for name, value in SPRINGS.items() if "damping" not in name}
    rows = [
        {name: value for name, value in row.items() if "before" not in name and "time" not in name}
        for row in ROWS
    ]
    wanted = hosts(version).ask("trajectory", rows=rows, names=NAMES, start=still)["seen"]
    seen = hosts(version).ask("points", rows=rows, names=NAMES, start=still, exchange=True)
    assert seen["continuous"] == wanted
    answer = hosts(version).ask("refusals", cases={"damper": SPRINGS}, exchange=True)["damper"]
    assert answer["refused"] and answer["log"][0][-1] == (
        "rail_vertical_damping is 100000.0 N.s/m; permitted in model exchange is 0: a damper needs the steps "
        "of co-simulation"
    )
