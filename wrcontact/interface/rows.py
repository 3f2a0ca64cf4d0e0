"""Kinds of rows of the table of inputs and outputs; each row is declared once, in inputs.py or outputs.py.

From a row follow a field of the kernel's record (wrcontact/kernel/layout/interface.py), a property of the
results (wrcontact/results/fields.py), variables of an FMU (variables.py) and their documentation.  Nothing here
imports the kernel.
"""

from dataclasses import dataclass

from .units import UNITS

#: Axes of the track frame.
AXES = (("x", "forward"), ("y", "to the right"), ("z", "down"))


@dataclass(frozen=True)
class Row:
    """What all rows have.

    Attributes
    ----------
    name : in the FMU, and in Python; a dot leads into a part of the results, as in ``contact.y_wheel``.
    unit : one of :data:`~wrcontact.interface.units.UNITS`.
    nominal : usual magnitude.
    meaning : words for the user, without the place that they hold for and without a full stop.
    minimum, maximum : limits; an angle without any is bounded by a right angle.
    field : name of the field in the kernel's record, by default the part of the name behind the dot.
    """

    name: str
    unit: str
    nominal: float
    meaning: str
    minimum: float | None = None
    maximum: float | None = None
    field: str = ""

    def __post_init__(self):
        if self.unit not in UNITS:
            raise TypeError(f"the unit of {self.name} is {self.unit!r}; there are {', '.join(UNITS)}")
        object.__setattr__(self, "field", self.field or self.name.rpartition(".")[2])


@dataclass(frozen=True)
class Input(Row):
    """What moves.

    ``start`` is its default, ``hint`` whether it changes the cost of a step only, ``positional`` whether
    :meth:`~wrcontact.ContactSystem.evaluate` takes it without its name too.  Outside ``usual`` =
    (low, high) a value other than 0 is rather a typing error.  Beyond the ``maximum`` of a ``limited`` one,
    to either side, a step is refused.  A ``switch`` is a Boolean in an FMU; the kernel reads it as 1 or 0.
    ``place`` says whose value it is ("Left rail").
    """

    start: float = 0.0
    hint: bool = False
    positional: bool = False
    usual: tuple | None = None
    place: str = ""
    limited: bool = False
    switch: bool = False

    @property
    def words(self):
        """The meaning, preceded by the place where there is one."""
        return f"{self.place}: {self.meaning}" if self.place else self.meaning

    @property
    def keyword(self):
        """Its name as an argument in Python, where a dot is an underscore."""
        return self.name.replace(".", "_")


@dataclass(frozen=True)
class Output(Row):
    """A number; ``whole`` numbers are integers."""

    whole: bool = False


@dataclass(frozen=True)
class Vector(Output):
    """Three numbers along :data:`AXES`; ``meaning`` is followed by the direction."""


@dataclass(frozen=True)
class Run(Output):
    """One number for each station of an outline."""


@dataclass(frozen=True)
class Blocks:
    """``count`` times the same ``rows``, as in ``patch[2].area``; ``words`` name one of them."""

    name: str
    count: int
    rows: tuple
    words: str


def single_numbers(rows):
    """(Name, unit) of each number of ``rows`` but for runs and blocks; vectors as ``force.x``, ``force.y``,
    ``force.z``."""
    for row in rows:
        if isinstance(row, Vector):
            yield from ((f"{row.name}.{axis}", row.unit) for axis, _ in AXES)
        elif not isinstance(row, (Blocks, Run)):
            yield row.name, row.unit
