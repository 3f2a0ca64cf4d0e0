"""Which contact an FMU has: that of a wheelset, or that of one wheel on one rail.

The FMU of one wheel is that of a wheelset of which one side is computed.  Its variables are those of this
side, without ``left.`` or ``right.`` in their names, and keep the wheelset's value references.
"""

from dataclasses import dataclass, replace

from ..interface.inputs import INPUT_NAMES
from ..interface.one_wheel import MODE, WITHOUT, checked_wheel, own_name, wheel_inputs
from ..interface.variables import VARIABLES
from ..kernel import layout
from ..status import Terms
from .settings import ROWS, checked

#: Variables of every FMU; the last two of FMI 3 only.
COMMON = ("status", "time", "stations")


@dataclass(frozen=True)
class Variant:
    """One of them.

    ``model`` is its name, ``description`` says what it is, ``sides`` what the kernel computes; ``side`` is ""
    for a wheelset, else that of the wheel.
    """

    model: str
    description: str
    sides: int
    side: str = ""

    def name(self, name):
        """The name of a wheelset's variable here; "" where it is not there."""
        if not self.side or name in COMMON:
            return name
        if name in ROWS:
            row = ROWS[name]
            return "" if row.right or row.name in WITHOUT or row.name == "contact_mode" else name
        return own_name(name, self.side) if name in INPUT_NAMES or name.startswith(f"{self.side}.") else ""

    def variable(self, variable):
        """A wheelset's variable with its name and its words here."""
        if not self.side:
            return variable
        follows = tuple(own for name in variable.depends_on if (own := self.name(name)))
        return replace(
            variable,
            name=self.name(variable.name),
            depends_on=follows,
            place=variable.place.removeprefix(f"{self.side.capitalize()} ").capitalize(),
        )

    def variables(self):
        """(Place in the table, variable) of each, in the order of the table."""
        return [(place, self.variable(one)) for place, one in enumerate(VARIABLES) if self.name(one.name)]

    def terms(self):
        """How sentences name the inputs."""
        return _WheelTerms(self)

    def starts(self, settings):
        """The ``settings`` of a build with what this contact itself fixes; inputs have a wheelset's names."""
        if not self.side:
            return settings
        rows, settings = wheel_inputs(self.side), settings or {}
        self.check(settings)
        checked(settings, self.side)
        found = {rows[name].name if name in rows else name: value for name, value in settings.items()}
        return {**found, "contact_mode": MODE}

    def named(self, starts):
        """Start values with a wheelset's names by the names here."""
        return {self.name(name): value for name, value in starts.items()}

    def check(self, starts):
        """ValueError, in a sentence, where a start value has no meaning here."""
        if self.side:
            given = {ROWS[name].name if name in ROWS else name: value for name, value in starts.items()}
            own = wheel_inputs(self.side)
            checked_wheel({name: value for name, value in given.items() if name not in own})


class _WheelTerms(Terms):
    """Sentences with the names of a variant."""

    def __init__(self, variant):
        self._variant = variant

    def name(self, name):
        return self._variant.name(name) or name


#: The descriptions do not name methods, because methods are added over time.
WHEELSET = Variant(
    "WheelsetContact",
    "Wheel-rail contact of a wheelset on track: contact points and roll, contact patches with "
    "their pressures, creepages and creep forces, resultant forces and moments, friction "
    "power",
    layout.SIDES_BOTH,
)


def single_wheel(side):
    """The variant of one wheel on the rail of this ``side``, "left" or "right"."""
    return Variant(
        "WheelContact",
        f"Wheel-rail contact of one wheel on the {side} rail, with six degrees of freedom and its "
        "own rotation: contact point, contact patches with their pressures, creepages and creep "
        "forces, force and moment, friction power",
        {"left": layout.SIDES_LEFT, "right": layout.SIDES_RIGHT}[side],
        side,
    )
