"""Every output of the FMUs has its name, its unit and its value from a table that is not the one that made
it.

The table is WITNESSES in tests/helpers/output_witnesses.py: brute force, a half-space, Hertz and identities.
"""

from xml.etree import ElementTree

import pytest

from tests.helpers.output_witnesses import SCENES, WITNESSES, Scene, folded
from wrcontact.fmu import description, description3
from wrcontact.simulation.session import Session

PAGES = {
    "python": description.model_description("", "", "", {}),
    "native_fmi2": description.model_description("", "", "", {}, ["model.c"]),
    "native_fmi3": description3.model_description("", "", "", {}, ["model.c"]),
}
#: Pressures act across the track; neither Polach's formula nor what slides has a moment or a stick zone;
#: rails are rigid in all scenes (tests/wheelset/test_springs.py has those on springs); the estimate of the model's
#: error has bounds here and closed forms in tests/normal/test_auto.py.
ZERO = {
    "normal.force.x",
    "side.normal.force.x",
    "side.patch[k].tangential.moment",
    "side.patch[k].stick_share",
    "side.patch[k].slope",
    "side.rail_deflection_lateral",
    "side.rail_deflection_vertical",
    "side.model_error",
}
STATIONS, PATCHES = 31, 3


def outputs(page):
    """{name: (unit, value reference, type)} of a model description's outputs; the elements of arrays one by
    one."""
    found = {}
    for variable in ElementTree.fromstring(page).find("ModelVariables"):
        if variable.get("causality") == "output":
            kind = variable if variable.tag != "ScalarVariable" else variable[0]
            row = kind.get("unit"), int(variable.get("valueReference")), kind.tag
            name = variable.get("name")
            numbers = range(1, STATIONS + 1) if variable.findall("Dimension") else ()
            found |= {f"{name}[{j}]": row for j in numbers} or {name: row}
    return found


def answered(name):
    """The outputs in a scene: set and read as an importer does, by the references of the model
    description."""
    page = ElementTree.fromstring(PAGES["python"])
    known = {v.get("name"): (int(v.get("valueReference")), v[0].tag) for v in page.find("ModelVariables")}
    start, inputs, _ = SCENES[name]
    session = Session(log=lambda sentence: None)
    for key, value in {**start, **inputs}.items():
        reference, kind = known[key]
        {"String": session.set_strings, "Boolean": session.set_booleans}.get(kind, session.set_reals)(
            [reference], [value]
        )
    session.start()
    session.step()
    values = {}
    for key, (_, reference, kind) in outputs(PAGES["python"]).items():
        (values[key],) = (session.get_integers if kind == "Integer" else session.get_reals)([reference])
    return values


@pytest.fixture(scope="module")
def scenes():
    return {name: Scene(name, answered(name)) for name in SCENES}


@pytest.mark.parametrize("kind", PAGES)
def test_every_output_has_a_witness_of_its_name_and_unit(kind):
    found = outputs(PAGES[kind])
    assert {folded(name)[0] for name in found} == set(WITNESSES)
    numbers = {}  # on both sides, of every patch and every station
    for name in found:
        pattern, *number = folded(name)
        numbers.setdefault(pattern, []).append(tuple(number))
    for pattern, there in numbers.items():
        sides = ("left", "right") if pattern.startswith("side.") else (None,)
        most = PATCHES if "[k]" in pattern else STATIONS if "[j]" in pattern else 0
        places = [(k,) for k in range(1, most + 1)] or [()]
        assert sorted(there) == [(side, place) for side in sides for place in places], pattern
    for name, (unit, _, _) in found.items():
        assert unit == WITNESSES[folded(name)[0]][0], name
    assert list(found) == list(outputs(PAGES["python"]))


@pytest.mark.parametrize("name", SCENES)
def test_every_output_is_what_its_witnesses_say(scenes, name):
    assert list(scenes[name].misses()) == []


def test_every_output_is_asked_on_both_sides_for_a_number_that_is_not_zero(scenes):
    patterns = {folded(name)[:2] for name in scenes["centred"].values}
    asked = {
        folded(name)[:2]
        for scene in scenes.values()
        for name in scene.values
        if any(abs(wanted) > 2 * tolerance for wanted, tolerance in scene.wanted(name))
    }
    assert {pattern for pattern, _ in patterns - asked} == ZERO
    assert scenes["three_patches"].values["right.patch_count"] == 3
