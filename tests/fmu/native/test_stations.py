"""The native FMU of FMI 3 with other numbers of stations of the outlines."""

import re

import pytest

from tests.helpers.cases import INPUT_NAMES, poses
from tests.helpers.fmus import SAME, needs_compiler, outline_of_both
from wrcontact import ContactSystem
from wrcontact.interface import variables
from wrcontact.interface.variables import PLACE, REFERENCE, VARIABLES

pytestmark = needs_compiler

STATIONS = (3, 7, 31, 61, 201)


@pytest.mark.parametrize(
    "start", [{}, {"wear_outputs": True, "tangential_model": "strips"}], ids=["plain", "wear"]
)
def test_outlines_with_other_numbers_of_stations(run3, start):
    """Instances with different numbers in one process, in turn: each with the values of the
    package, and as by itself."""
    rows = [{**row, "speed": 20.0} for row in poses(8)] if start else poses(8)
    answer = run3("outlines", stations=STATIONS, rows=rows, start=start)
    assert answer["seen"] == answer["alone"]
    for number, seen in zip(STATIONS, answer["seen"]):
        stepper = ContactSystem(stations=number, **start).stepper()
        stepper.inputs[:] = [v.start for v in VARIABLES[: len(INPUT_NAMES)]]
        for row, found in zip(rows, seen):
            stepper.inputs[[REFERENCE[name] for name in row]] = list(row.values())
            status = stepper.step()
            wanted = {
                v.name: value
                for v, value in zip(VARIABLES[variables.FIRST_OUTPUT : variables.FIRST_WEAR], stepper.outputs)
                if not v.name.endswith("]")
            }
            for name, values in outline_of_both(stepper.outputs, stepper.layout).items():
                wanted |= {f"{name}[{k + 1}]": value for k, value in enumerate(values)}
            assert len(found) == len(wanted) + 3 and found["status"] == status
            for name, value in wanted.items():
                nominal = VARIABLES[PLACE[re.sub(r"\[\d+\]$", "[1]", name)]].nominal or 1.0
                assert found[name] == pytest.approx(value, rel=SAME, abs=SAME * nominal), (number, name)


def test_saved_states_with_other_numbers_of_stations(run3):
    """An outline is kept where a step is not possible, and goes on bit by bit from a saved
    state, elsewhere too."""
    seen = run3("stations_again", stations=201, other=7, rows=poses(30))
    assert seen["kept"] == [seen["before"], {"status": 4}] and seen["held"] == seen["before"]
    assert seen["straight"] == seen["back"] == seen["elsewhere"] and len(seen["straight"][0]) > 10 * 201
    assert seen["read"] == {"stations": 201}


def test_configuration_mode(run3):
    seen = run3("configuration")
    for name, (refused, lines) in seen["calls"].items():
        assert refused, name
        assert len(lines) == 1 and lines[0][:2] == [3, "logStatusError"], f"{name}: {lines}"
    sentences = {name: lines[0][2] for name, (_, lines) in seen["calls"].items()}
    for wrong in (0, 2, 202, 2**64 - 1):
        assert sentences[f"{wrong}"] == f"stations is {wrong}; permitted is 3 ... 201"
    assert (
        sentences["not entered"] == "stations is fixed at 31 outside configuration mode and cannot become 61"
    )
    assert sentences["31 values"] == "fmi3GetFloat64: there are 31 values; these variables have 7"
    assert "8 values; these variables have 7" in sentences["8 values"]
    assert (
        "permitted in configuration mode is stations"
        in sentences["another parameter"] + sentences["an output"]
    )
    assert seen["kept"] == {"stations": 31} and seen["after"] == seen["running"] and len(seen["after"]) == 7
    assert seen["reset"] == {"stations": 31} and seen["again"] == seen["fresh"] and len(seen["twice"]) == 31
    assert seen["log"] == []


def test_outlines_by_simulate_fmu(run3):
    row = {"lateral_shift": 2e-3, "yaw": 1e-3}
    state = ContactSystem(stations=61).evaluate(**row)
    wanted = outline_of_both(state.values, state.layout)
    assert len(wanted) == 18
    for name, values in run3("simulated_stations", stations=61, row=row).items():
        assert values == pytest.approx(wanted[name], rel=SAME, abs=1e-15), name
