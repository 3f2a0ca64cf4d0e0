"""Value references never move: the list is only appended to, and has every variable."""

import csv
import hashlib

from wrcontact.fmu.description3 import variable_blocks
from wrcontact.fmu.native import blocks_of
from wrcontact.interface.references import FIRST, LIST, STORED, numbered
from wrcontact.interface.variables import PLACE, REFERENCE, VARIABLES

#: Lines of the list, without its heading, that are in users' hands, and their hash.  A release adds a pair.
RELEASED = {619: "58cd412252bc37a27bbb00fe19ef6b07f8a13841ce78c214954a062d3d54da29"}


def lines():
    return LIST.read_text(encoding="utf-8").splitlines()[1:]


def test_released_numbers_stay():
    found = lines()
    for count, known in RELEASED.items():
        text = "\n".join(found[:count])
        assert hashlib.sha256(text.encode()).hexdigest() == known, (
            f"one of the first {count} lines of {LIST.name} has changed; it is only appended to"
        )


def test_the_list_has_every_variable():
    """``make pages`` appends those that are new."""
    assert set(REFERENCE) <= set(STORED[2]) and {b.name for b in variable_blocks()} <= set(STORED[3])


def test_a_number_belongs_to_one_name_and_numbers_rise():
    """So a number that is free is the next one, and none is used twice."""
    rows = list(csv.DictReader(LIST.read_text(encoding="utf-8").splitlines()))
    assert len({row["name"] for row in rows}) == len(rows)
    for version, first in FIRST.items():
        numbers = [int(row[f"fmi{version}"]) for row in rows if row[f"fmi{version}"]]
        assert numbers == list(range(first, first + len(numbers)))


def test_a_new_variable_gets_the_next_number_wherever_it_stands():
    names = [*PLACE]
    found = numbered([*names[:40], "new", *names[40:], "newer"], 2)
    assert {name: found[name] for name in names} == REFERENCE
    assert (found["new"], found["newer"]) == (len(STORED[2]), len(STORED[2]) + 1)


def test_a_number_that_is_free_again_is_not_used_again():
    last = max(STORED[2], key=STORED[2].get)
    found = numbered([name for name in PLACE if name not in ("yaw", last)] + ["new"], 2)
    assert found["new"] == STORED[2][last] + 1 and STORED[2]["yaw"] not in found.values()


def test_c_finds_every_variable_by_its_number(monkeypatch):
    """Also where places and numbers differ; numbers without a variable lie at no place."""
    for name, number in REFERENCE.items():
        assert VARIABLES[blocks_of(2)[number][0]].name == name
    for block in variable_blocks():
        assert blocks_of(3)[block.reference] == (block.first, block.run)
    assert blocks_of(3)[0] == (-3, -1)
    monkeypatch.setattr("wrcontact.fmu.native.REFERENCE", {"yaw": 4, "roll": 2})
    monkeypatch.setattr("wrcontact.fmu.native.PLACE", {"roll": 0, "yaw": 1})
    assert blocks_of(2) == [(-3, -1), (-3, -1), (0, -1), (-3, -1), (1, -1)]
