"""Rules of the FMI standards for modelDescription.xml that schemas cannot say, of FMI 2.0 and 3.0."""

import re
from xml.etree import ElementTree

import pytest

from wrcontact.fmu import description, description3

pytestmark = pytest.mark.check

NAME = r"[A-Za-z_]\w*(\[\d+\])?"
#: Where unknowns are, and what they are found by.
UNKNOWNS = {
    2: (("Outputs/Unknown", "InitialUnknowns/Unknown"), "index"),
    3: (("Output", "InitialUnknown"), "valueReference"),
}


@pytest.fixture(params=(2, 3))
def described(request):
    """Version, root, and each variable's (element, attributes of it and its type, number in dependencies)."""
    make = {2: description, 3: description3}[request.param].model_description
    root = ElementTree.fromstring(make("{0}", "tool", "1", {}, ["unit.c"]))
    found = []
    for place, element in enumerate(root.find("ModelVariables"), 1):
        kind = element[0] if request.param == 2 else element
        number = place if request.param == 2 else int(element.get("valueReference"))
        found.append((kind.tag, {**kind.attrib, **element.attrib}, number))
    return request.param, root, found


def test_names_are_structured_and_every_variable_is_described(described):
    _, _, found = described
    for key in ("name", "valueReference"):
        assert len({one[key] for _, one, _ in found}) == len(found)
    for _, one, _ in found:
        assert re.fullmatch(rf"{NAME}(\.{NAME})*", one["name"], re.ASCII), one["name"]
        assert one["description"] and not one["description"].endswith("."), one["name"]


def test_units_starts_and_variabilities(described):
    """A display unit belongs to its unit; a start is within its limits, and no output that is computed has
    one; what is not Real or Float64 is discrete or fixed."""
    _, root, found = described
    units = {
        unit.get("name"): {one.get("name") for one in unit.iter("DisplayUnit")}
        for unit in root.find("UnitDefinitions")
    }
    for kind, one, _ in found:
        name = one["name"]
        assert one.get("displayUnit") in {None, *units.get(one.get("unit"), ())}, name
        assert one.get("unit") in {None, *units} and float(one.get("nominal", 1)) > 0, name
        low, high = float(one.get("min", "-inf")), float(one.get("max", "inf"))
        number = kind not in ("String", "Boolean") and one.get("start")
        assert low < high and (not number or low <= float(number) <= high), name
        assert (one["causality"] == "output") == (one.get("initial") == "calculated"), name
        assert "start" not in one or one["causality"] != "output", name
        assert kind in ("Real", "Float64") or one["variability"] in ("discrete", "fixed"), name


def test_unknowns_are_all_outputs_in_order_and_depend_on_what_is_known(described):
    version, root, found = described
    causality = {number: one["causality"] for _, one, number in found}
    outputs = [number for number, kind in causality.items() if kind == "output"]
    sections, key = UNKNOWNS[version]
    for section, known in zip(sections, ({"input"}, {"input", "parameter", "structuralParameter"})):
        unknowns = root.findall(f"ModelStructure/{section}")
        assert [int(one.get(key)) for one in unknowns] == outputs
        for one in unknowns:
            follows = [int(word) for word in one.get("dependencies").split()]
            assert follows == sorted(set(follows)) and {causality[number] for number in follows} <= known
            assert one.get("dependenciesKind").split() == ["dependent"] * len(follows)
