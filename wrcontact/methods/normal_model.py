"""What the normal models share: a tolerance, and the nodes and strips that keep it.

A tolerance is the relative error of the numerics, against the same model resolved as finely as the kernel
can, that 95 of 100 random poses keep in penetration, area and peak pressure alike: S1002 on UIC60, |lateral
shift| <= 6.6 mm, 3 to 200 kN, half of them with up to 2 degrees of yaw (``python -m benchmarks`` measures it
anew).  It says nothing about the error of the model itself, which the benchmarks list.  Errors are larger at
poses where a region of contact is about to appear.
"""

from typing import ClassVar, NamedTuple

from .method import Method
from .numbers import number, whole

#: The tolerance where none is given, and the largest [1].
DEFAULT, COARSEST = 0.01, 0.1


class Resolution(NamedTuple):
    """Nodes per half-width of the interpenetration, every ``stride``-th of them traced on the profiles;
    strips, sweeps."""

    nodes: int
    stride: int
    strips: int
    sweeps: int


#: Resolution of ANALYN by falling tolerance.  Hertz's model and the half-space also look for their regions
#: with these nodes.
ANALYN_LADDER = {
    0.02: Resolution(4, 1, 24, 2),
    0.01: Resolution(8, 2, 24, 2),
    0.004: Resolution(15, 3, 24, 2),
    0.0015: Resolution(30, 2, 24, 2),
}


def tolerance_from(finest):
    """The field ``tolerance`` of a model that keeps tolerances down to ``finest`` [1]."""
    return number(
        None,
        finest,
        COARSEST,
        "1",
        "Relative error of the numerics in penetration, area and peak pressure; nodes and "
        "strips are as fine as it needs",
        nominal=0.01,
        start=DEFAULT,
    )


def node_count():
    """The field ``nodes``."""
    return whole(
        None,
        4,
        38,
        "Nodes per half-width of the interpenetration, instead of those that the tolerance needs",
        python_only=True,
    )


class NormalModel(Method):
    """How a patch, its pressure and its penetration follow from load and geometry.

    ``ladder`` holds a :class:`Resolution` by falling tolerance; the last one is as fine as the model gets.
    """

    parameter = "normal_model"
    ladder: ClassVar[dict] = ANALYN_LADDER

    @property
    def resolution(self):
        """The coarsest :class:`Resolution` that keeps the tolerance, with single numbers replaced by those
        given."""
        tolerance = DEFAULT if self.tolerance is None else self.tolerance
        found = next(
            (rung for kept, rung in self.ladder.items() if kept <= tolerance), [*self.ladder.values()][-1]
        )
        counts = {name: getattr(self, name, None) for name in ("nodes", "strips", "sweeps")}
        given = {name: value for name, value in counts.items() if value is not None}
        if "nodes" in given:
            given["stride"] = 1  # each of them is traced
        return found._replace(**given)
