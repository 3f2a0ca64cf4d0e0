"""Where inputs are: by either name, as the kernel's record has them; and each list of them once."""

import ast

import pytest

from tests.helpers.paths import ROOT
from tests.helpers.sources import parsed
from wrcontact.interface.index import KEYWORDS, PLACES, ROWS, keyword_of, row_of
from wrcontact.kernel import layout

NAMED = ("lateral_shift", "yaw", "normal_force", "left_rail_lateral", "right_rail_roll", "speed")


@pytest.mark.parametrize("field", NAMED)
def test_an_input_is_where_the_kernel_reads_it(field):
    """By Python's keyword, and by the name of an FMU."""
    place = getattr(layout, f"IN_{field.upper()}")
    name = row_of(field).name
    assert KEYWORDS[field] == PLACES[field] == PLACES[name] == place
    assert ROWS[name] is row_of(name) is row_of(field) and keyword_of(name) == field


def test_what_is_no_input_has_no_place():
    assert keyword_of("left.area") is None and "left.area" not in PLACES
    with pytest.raises(KeyError):
        row_of("left.area")


@pytest.mark.parametrize("name", ["SIDES", "KEYWORDS", "INPUT_VARIABLES"])
def test_a_list_stands_once(name):
    """In one module of the package."""
    found = [
        path.relative_to(ROOT).as_posix()
        for path in sorted((ROOT / "wrcontact").rglob("*.py"))
        for node in parsed(path).body
        if isinstance(node, ast.Assign) and name in {getattr(one, "id", None) for one in node.targets}
    ]
    assert len(found) == 1, found
