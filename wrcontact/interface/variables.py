"""Everything that crosses the border of an FMU: the variables that follow from the rows of inputs, parameters
and outputs.

Registration, units, documentation and tests read it.  Outputs lie in ``VARIABLES`` in the order of the
kernel's array, so that one copy moves them all.  A variable's place there moves when a row is added before
it; its value reference never moves (references.py).
"""

import math
import re
from dataclasses import dataclass, replace

from ..conventions import SIDES
from .inputs import ANSWERED, INPUTS
from .outputs import SIDE, STATION_COUNT, WEAR, WHEELSET
from .parameters import PARAMETERS
from .references import numbered
from .rows import AXES, Blocks, Run, Vector
from .starts import STARTS
from .units import UNITS  # noqa: F401  a part of the table

INPUT, PARAMETER, OUTPUT = "input", "parameter", "output"
REAL, INTEGER, BOOLEAN, STRING = "Real", "Integer", "Boolean", "String"


@dataclass(frozen=True)
class Variable:
    """One variable: its name, what it means in the field's terms, its unit and limits, and what it follows.

    ``index`` is the place in the kernel's inputs or outputs (None for parameters and ``status``), ``keyword``
    the argument of :class:`~wrcontact.ContactSystem` that a parameter sets, ``depends_on`` the inputs that an
    output follows.  ``place`` says whose value it is ("Right wheel, patch 1"); several variables share one
    ``meaning``.
    """

    name: str
    causality: str
    meaning: str
    type: str = REAL
    unit: str = ""
    start: object = None
    minimum: float | None = None
    maximum: float | None = None
    nominal: float | None = None
    index: int | None = None
    keyword: str = ""
    choices: tuple = ()
    depends_on: tuple = ()
    place: str = ""

    @property
    def description(self):
        """The meaning, preceded by the place where there is one."""
        return f"{self.place}: {self.meaning}" if self.place else self.meaning

    @property
    def variability(self):
        """How the value may change: parameters are fixed, Reals follow their inputs, others switch."""
        if self.causality == PARAMETER:
            return "fixed"
        return "continuous" if self.type == REAL else "discrete"


def _inputs():
    """What moves: the pose and the load of the wheelset."""
    for row in INPUTS:
        if row.switch:
            start = bool(STARTS.get(row.name, row.start))
            yield Variable(row.name, INPUT, row.meaning, BOOLEAN, start=start)
            continue
        yield Variable(
            row.name,
            INPUT,
            row.meaning,
            unit=row.unit,
            start=STARTS.get(row.name, row.start),
            minimum=row.minimum,
            maximum=row.maximum,
            nominal=row.nominal,
            place=row.place,
        )


def _parameters():
    """What stays: profiles, track, wheelset, material and methods."""
    return [_parameter(row) for row in PARAMETERS.values() if row.fmu_name]


def _parameter(row):
    """The variable of one row of :data:`~wrcontact.interface.parameters.PARAMETERS`."""
    start, known = STARTS.get(row.fmu_name, row.start), row.number
    if known is None:
        choices = row.family.names(python=False) if row.family else ()
        return Variable(
            row.fmu_name, PARAMETER, row.meaning, STRING, start=start, keyword=row.name, choices=choices
        )
    if known.switch:
        return Variable(row.fmu_name, PARAMETER, row.meaning, BOOLEAN, start=start, keyword=row.name)
    return Variable(
        row.fmu_name,
        PARAMETER,
        row.meaning,
        unit=known.unit,
        start=start,
        minimum=known.low,
        maximum=known.high,
        nominal=known.nominal or row.start,
        keyword=row.name,
    )


def _expanded(rows, prefix="", place=""):
    """The variables of ``rows`` in the kernel's order; ``place`` says whose they are ("Right wheel, patch
    1")."""
    for row in rows:
        name = prefix + row.name
        if isinstance(row, Blocks):
            for k in range(1, row.count + 1):
                yield from _expanded(row.rows, f"{name}[{k}].", f"{place}, {row.words} {k}")
        elif isinstance(row, Run):
            for j in range(1, STATION_COUNT + 1):
                yield _output(row, f"{name}[{j}]", row.meaning, f"{place}, station {j}")
        elif isinstance(row, Vector):
            for axis, way in AXES:
                yield _output(row, f"{name}.{axis}", row.meaning.format(axis=way), place)
        else:
            yield _output(row, name, row.meaning, place)


def _output(row, name, meaning, place):
    """One output; angles are bounded by a right angle."""
    low, high = (-math.pi / 2, math.pi / 2) if row.unit == "rad" else (row.minimum, row.maximum)
    if row.whole:
        return Variable(
            name, OUTPUT, meaning, INTEGER, minimum=low, maximum=high, depends_on=ANSWERED, place=place
        )
    return Variable(
        name,
        OUTPUT,
        meaning,
        unit=row.unit,
        minimum=low,
        maximum=high,
        nominal=row.nominal,
        depends_on=ANSWERED,
        place=place,
    )


def _outputs():
    """What comes back: the kernel's array in its own order, and what follows it with wear_outputs."""
    yield from _expanded(WHEELSET)
    for side in SIDES:
        yield from _expanded(SIDE, f"{side}.", f"{side.capitalize()} wheel")
    for side in SIDES:
        yield from _expanded(WEAR, f"{side}.", f"{side.capitalize()} wheel")


def _indexed(variables):
    """The variables of one of the kernel's arrays, each with its place there."""
    return [replace(variable, index=index) for index, variable in enumerate(variables)]


def _equilibrium():
    """Where a compliant wheelset carries its load: computed apart from a step, and only when it is read."""
    follows = tuple(name for name in ANSWERED if name not in ("vertical_shift_input", "roll_input"))
    words = (
        "{} of the wheelset at which both wheels carry the load that the inputs give; from here a "
        "wheelset in the contact_mode compliant starts at rest (in other modes {} itself)"
    )
    for name, unit, quantity in (("vertical_shift", "m", "Vertical shift"), ("roll", "rad", "Roll")):
        low, high = (-math.pi / 2, math.pi / 2) if unit == "rad" else (None, None)
        yield Variable(
            f"equilibrium.{name}",
            OUTPUT,
            words.format(quantity, name),
            unit=unit,
            minimum=low,
            maximum=high,
            nominal=1e-3,
            depends_on=follows,
        )


#: What became of a step; it is no part of the kernel's outputs.
_STATUS = Variable(
    "status",
    OUTPUT,
    "Outcome of the step: 0 valid, 1 a wheel is unloaded, 2 off the profile, 3 not converged, 4 invalid input, "
    "5 friction does not carry the axle torque (2 to 5 keep the last valid values)",
    INTEGER,
    minimum=0,
    maximum=5,
    depends_on=ANSWERED,
)

VARIABLES = (*_indexed(_inputs()), *_parameters(), *_equilibrium(), *_indexed(_outputs()), _STATUS)
#: Place of every variable in the table, and its value reference in FMI 2.0.
PLACE = {variable.name: place for place, variable in enumerate(VARIABLES)}
REFERENCE = numbered(PLACE, 2)
INPUT_VARIABLES = {v.name: v for v in VARIABLES if v.causality == INPUT}

#: Place of the first of the equilibrium's two outputs.
EQUILIBRIUM = PLACE["equilibrium.vertical_shift"]
#: Places of the first kernel output, of the first output of wear, and of the status; between them the
#: kernel's array lies without a hole.
FIRST_OUTPUT = PLACE["roll"]
FIRST_WEAR = PLACE[f"{SIDES[0]}.{WEAR[0].name}[1]"]
STATUS = PLACE["status"]


def select(causality=None, type=None):
    """The variables of one causality and type, in table order."""
    return [
        variable
        for variable in VARIABLES
        if causality in (None, variable.causality) and type in (None, variable.type)
    ]


def documented():
    """The table for people: (name, variable) with left and right, patches and stations folded into one row
    each.

    ``right.patch[2].area`` and its like appear once, as ``side.patch[k].area``.
    """
    rows = {}
    for variable in VARIABLES:
        rows.setdefault(folded(variable.name), variable)
    return list(rows.items())


def folded(name):
    """A variable's name with its side, and its places in arrays, as letters."""
    name = re.sub(r"^(left|right)\.", "side.", name)
    name = re.sub(r"patch\[\d+\]", "patch[k]", name)
    return re.sub(r"\[\d+\]", "[j]", name)
