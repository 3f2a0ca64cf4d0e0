"""Where inputs are, by the names of an FMU ("left.friction") and by Python's keywords ("left_friction"), and what a
system has profiles of."""

from .inputs import INPUTS

#: Rows of inputs by the names of an FMU.
ROWS = {row.name: row for row in INPUTS}
#: Places in the kernel's order by Python's keywords, and by these and by the names of an FMU.
KEYWORDS = {row.keyword: place for place, row in enumerate(INPUTS)}
PLACES = {name: place for place, row in enumerate(INPUTS) for name in (row.name, row.keyword)}
#: Profiles of a pair, and keywords of all profiles of a system; an FMU's parameters have "_profile" behind them.
KINDS = ("wheel", "rail")
PROFILES = ("wheel", "rail", "left_wheel", "left_rail")


def row_of(name):
    """The row of an input in the table of inputs, by either name; KeyError if there is none."""
    return INPUTS[PLACES[name]]


def keyword_of(name):
    """The keyword of an input, by either name; None if there is none."""
    return INPUTS[PLACES[name]].keyword if name in PLACES else None
