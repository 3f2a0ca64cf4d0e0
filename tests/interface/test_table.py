"""One table: records, variables, results and calls of evaluate follow from its rows; what
does not fit is an error."""

import inspect
import re

import numpy as np
import pytest

import wrcontact
from tests.helpers.inside import tables_of
from wrcontact import state
from wrcontact.interface import units
from wrcontact.interface.inputs import INPUTS
from wrcontact.interface.outputs import PATCH, SIDE, STRIPS, WEAR, WHEELSET
from wrcontact.interface.parameters import KERNEL_PARAMETERS, PARAMETERS
from wrcontact.interface.rows import Blocks, Input, Run, Vector
from wrcontact.interface.section_places import SECTION_PLACES
from wrcontact.interface.variables import FIRST_OUTPUT, FIRST_WEAR, STATUS, VARIABLES
from wrcontact.kernel import layout
from wrcontact.kernel.patch.outline import row_size
from wrcontact.results.layout import Layout
from wrcontact.status import Status


def names(record):
    return [name for name, _ in record._fields_]


def test_records_have_a_field_for_every_row_in_order():
    assert names(layout.Inputs) == [row.field for row in INPUTS]
    assert names(layout.PatchOutputs) == [row.field for row in PATCH]
    assert names(layout.SideOutputs) == [row.name if isinstance(row, Blocks) else row.field for row in SIDE]
    assert names(layout.Outputs)[:-1] == [row.field for row in WHEELSET]
    assert names(layout.StripOutputs) == [row.field for row in STRIPS]
    assert names(layout.Parameters) == list(KERNEL_PARAMETERS)
    assert layout.INPUT_NOMINALS == tuple(row.nominal for row in INPUTS)


def test_a_unit_that_is_declared_twice_is_refused():
    """The one before would be lost without a word."""
    with pytest.raises(ValueError, match="unit 'N/m' is declared twice"):
        units.by_name(
            units.Unit("N", {}), units.Unit("N/m", {"kg": 1, "s": -2}), units.Unit("N/m", {}, "Stiffness")
        )
    assert units.by_name(units.Unit("N", {}))["N"].quantity == ""


@pytest.mark.parametrize("wear", [False, True])
@pytest.mark.parametrize("stations", [3, 31, 201])
def test_every_output_is_a_property_of_a_result_that_reads_its_place(stations, wear):
    """All places of a row have one name, but for those of strips; those of an outline of other stations stand
    behind the others, where a row of 31 has them among those of its side."""
    rows = Layout(stations, wear)
    stepper = wrcontact.ContactSystem(stations=stations, wear_outputs=wear).stepper()
    assert stepper.layout == rows and rows.size == row_size(layout.Tables.at(stepper.tables))
    scalars = [v for v in VARIABLES[FIRST_OUTPUT:FIRST_WEAR] if not v.name.endswith("]")]
    runs = sum(isinstance(row, Run) for row in SIDE) + len(WEAR) * wear
    places = list(rows.places.values())
    assert len(set(places)) == len(places) == len(scalars) + 2 * runs * stations
    values = np.arange(float(rows.size))
    values[[layout.OUT_LEFT, layout.OUT_RIGHT]] = layout.PATCH_LIMIT
    result = wrcontact.WheelsetState(values, 0, np.zeros(layout.INPUT_COUNT), rows)
    for name, place in rows.places.items():
        if name.endswith("patch_count"):
            continue
        assert property_of(result, name) == result[name] == place, name
    if stations == 31:
        usual = VARIABLES[FIRST_OUTPUT : STATUS if wear else FIRST_WEAR]
        assert rows.places == {variable.name: variable.index for variable in usual}


def property_of(result, name):
    """The value of an output by its properties."""
    found = result
    for part in name.replace("]", "").split("."):
        name, _, number = part.partition("[")
        if name in {row.name for row in (*SIDE, *WEAR) if isinstance(row, Run)}:
            found = found.outline
        name = "patches" if name == "patch" else name
        found = getattr(found, name)[int(number) - 1] if number else getattr(found, name)
    return found


def test_a_row_of_another_layout_is_refused():
    with pytest.raises(ValueError, match=r"^values has rows of \d+ numbers, those of the layout have \d+$"):
        wrcontact.WheelsetState(np.zeros(Layout(7).size), 0, None, Layout(61))


def test_properties_have_the_words_and_units_of_their_rows():
    for rows, kind in ((SIDE, state.Side), (PATCH, state.Patch), (WHEELSET, wrcontact.WheelsetState)):
        for row in rows:
            if (
                not isinstance(row, (Blocks, Run, Vector))
                and "." not in row.name
                and row.name != "patch_count"
            ):
                words = inspect.getdoc(getattr(kind, row.name))
                assert words.lower().startswith(row.meaning.lower()) and f"[{row.unit}]" in words


def test_evaluate_takes_every_input_by_name_and_the_main_ones_by_place():
    shown = inspect.signature(wrcontact.ContactSystem.evaluate).parameters
    assert {row.keyword: row.start for row in INPUTS}.items() <= {
        name: one.default for name, one in shown.items()
    }.items()
    assert list(shown)[1:5] == ["lateral_shift", "yaw", "normal_force", "load_transfer"]
    system = wrcontact.ContactSystem(normal_model="hertz")
    given = system.evaluate(1e-3, 2e-3, 3e4, 0.1, roll_guess=1e-5).inputs
    assert given[:5].tolist() == [1e-3, 2e-3, 1e-5, 3e4, 0.1]
    assert given[5:].tolist() == [row.start for row in INPUTS[5:]]
    moved = {row.keyword: 1e-4 * (1 + k) for k, row in enumerate(INPUTS) if "." in row.name}
    moved_inputs = system.evaluate(1e-3, **moved)
    assert {row.keyword: moved_inputs[row.name] for row in INPUTS if "." in row.name} == moved
    for arguments, keywords, words in (
        ((1, 2, 3, 4, 5), {}, "input"),
        ((), {"shift": 0.0}, "input"),
        ((1e-3,), {"lateral_shift": 2e-3}, "lateral_shift is given twice"),
    ):
        with pytest.raises(TypeError, match=words):
            system.evaluate(*arguments, **keywords)


def test_every_parameter_reaches_the_kernel():
    system = wrcontact.ContactSystem(gauge=1.437, poisson_ratio=0.3, stations=7, load="vertical")
    found = layout.Tables.at(tables_of(system)).parameters
    expected = {
        "gauge": 1.437,
        "poisson_ratio": 0.3,
        "stations": 7,
        "load": layout.LOAD_VERTICAL,
        "tolerance": 0.01,
    }
    assert {name: getattr(found, name) for name in expected} == expected
    assert set(PARAMETERS) - set(KERNEL_PARAMETERS) == {
        "wheel",
        "rail",
        "nodes",
        "strips",
        "sweeps",
        "smoothing",
        "left_wheel",
        "left_rail",
        "left_nominal_radius",
        "left_rail_inclination",
        "left_rail_lateral_stiffness",
        "left_rail_vertical_stiffness",
        "left_rail_lateral_damping",
        "left_rail_vertical_damping",
        *(side + name for side in ("", "left_") for name in SECTION_PLACES),
    }


def test_a_row_without_a_known_unit_is_an_error():
    with pytest.raises(TypeError, match="the unit of speed is 'km/h'; there are m, "):
        Input("speed", "km/h", 1.0, "Speed")


def test_left_settings_of_zero_are_as_on_the_right():
    """Of an FMU: 0 of a parameter of the left side is no value, and other values are its own."""
    from wrcontact.fmu.settings import ROWS, keywords_of

    left = [name for name, row in ROWS.items() if row.right]
    assert left
    for name in left:
        assert keywords_of({name: 0}) == keywords_of({name: 0.0}) == {}
    radius = next(name for name in left if ROWS[name].name == "left_nominal_radius")
    assert keywords_of({radius: 0.4}) == {"left_nominal_radius": 0.4}


def test_units_for_display_are_multiples_by_their_prefix():
    """mm2 has the prefix of mm twice."""
    prefixes = {"m": 1e3, "k": 1e-3, "M": 1e-6}
    shown = [unit for unit in units.UNITS.values() if unit.display and unit.name != "rad"]
    assert len(shown) >= 6
    for unit in shown:
        assert unit.display[1:] == unit.name
        power = 2 if unit.name == "m2" else 1
        assert unit.display_factor == pytest.approx(prefixes[unit.display[0]] ** power, rel=1e-15)
    assert units.UNITS["rad"].display == "deg" and units.UNITS["rad"].display_factor * np.pi == 180.0


def test_the_declared_range_of_the_status_has_every_status():
    """... and its description names each number once."""
    status = VARIABLES[STATUS]
    assert (status.minimum, status.maximum) == (min(Status), max(Status))
    words = status.description.partition("(")[0]
    assert [int(number) for number in re.findall(r"\d", words)] == list(Status)
