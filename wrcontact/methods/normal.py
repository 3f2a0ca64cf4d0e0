"""What the normal models share: a tolerance, and the nodes and strips that keep it.

A tolerance is the relative error of the numerics, against the same model resolved as finely as the kernel
can, that 95 of 100 random poses keep in penetration, area and peak pressure alike: S1002 on UIC60, |lateral
shift| <= 6.6 mm, 3 to 200 kN, half of them with up to 2 degrees of yaw (``python -m benchmarks`` measures it
anew).  It says nothing about the error of the model itself, which the benchmarks list.  Errors are larger at
poses where a region of contact is about to appear.
"""

from typing import ClassVar, NamedTuple

from .method import Method
from .numbers import frozen, number, whole

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
    0.02: Resolution(4, 1, 10, 6),
    0.01: Resolution(8, 2, 10, 6),
    0.004: Resolution(15, 3, 10, 6),
    0.0015: Resolution(30, 2, 10, 6),
}


def tolerance_from(finest):
    """The field ``tolerance`` of a model that keeps tolerances down to ``finest`` [1]."""
    return number(
        None,
        finest,
        COARSEST,
        "1",
        "Relative error of the numerics in penetration, area and peak "
        "pressure; nodes and strips are as fine as it needs",
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
    """How patches, their pressures and the penetration follow from load and geometry.

    The kernel has a function for each model, called from wrcontact/kernel/normal/normal_contact.py for one
    wheel whose contact plane is open.  It returns

    * the penetration [m] along the normal of the contact point: that under the given force [N], or the
      prescribed one where that is a number;
    * the number of regions, 0 where the wheel overlaps its rail most at the end of a profile;
    * whether the force is satisfied; the step has the status "not converged" where it is not.

    For each region it leaves what the equilibrium of an elastic wheelset needs: ``stiffness`` [N/m] and
    ``carried`` [N].  Where patches are wanted it fills them with wrcontact/kernel/patch/filling.py, from one
    edge to the other: load and its moment by region, area, edges, largest half-length and pressure, and the
    strips between which outline and creep forces interpolate.

    A subclass has ``tolerance``, as tolerances are stated at the head of this module, and ``ladder``: a
    :class:`Resolution` by falling tolerance, of which the last one is as fine as the model gets.
    """

    parameter = "normal_model"
    constant = "MODEL"
    decides = "normal contact"
    ladder: ClassVar[dict] = ANALYN_LADDER

    @property
    def resolution(self):
        """The coarsest :class:`Resolution` that keeps the tolerance, with single numbers replaced by those
        given."""
        tolerance = DEFAULT if self.tolerance is None else self.tolerance
        finest = list(self.ladder.values())[-1]
        found = next((rung for kept, rung in self.ladder.items() if kept <= tolerance), finest)
        counts = {name: getattr(self, name, None) for name in ("nodes", "strips", "sweeps")}
        given = {name: value for name, value in counts.items() if value is not None}
        if "nodes" in given:
            given["stride"] = 1  # each of them is traced
        return found._replace(**given)


@frozen
class Analyn(NormalModel):
    """ANALYN (Sichani, Enblom, Berg 2014), with regions that interact.

    ``tolerance`` [1] is the relative error of the numerics, ``nodes`` per half-width replaces what it needs.
    """

    name = "analyn"
    kernel_number = 1
    words = "ANALYN with interacting regions"
    ladder = ANALYN_LADDER

    tolerance: float | None = tolerance_from(min(ANALYN_LADDER))
    nodes: int | None = node_count()


#: Resolution by falling tolerance.
STRIP_LADDER = {
    0.025: Resolution(8, 2, 8, 4),
    0.015: Resolution(8, 2, 8, 5),
    0.01: Resolution(8, 2, 10, 6),
    0.007: Resolution(8, 2, 10, 7),
    0.004: Resolution(8, 2, 14, 9),
}


@frozen
class Strip(NormalModel):
    """Strips of a patch that press on each other.

    ``tolerance`` [1] is the relative error of the numerics; ``strips``, ``sweeps`` (how often they are
    corrected) and ``nodes`` per half-width replace what it needs.
    """

    name = "analyn_strip"
    kernel_number = 2
    words = "strips that press on each other"
    ladder = STRIP_LADDER

    tolerance: float | None = tolerance_from(min(STRIP_LADDER))
    nodes: int | None = node_count()
    strips: int | None = whole(
        None, 6, 16, "Strips of the strip model, instead of those that the tolerance needs", python_only=True
    )
    sweeps: int | None = whole(
        None, 1, 20, "Sweeps of the strip model, instead of those that the tolerance needs", python_only=True
    )


@frozen
class Auto(Strip):
    """ANALYN where the estimate of its error is below 4 %, :class:`Strip` where it is above 5 %, and a mean
    of both between (docs/theory/analyn.md).

    Its numbers are those of :class:`Strip`; ``nodes`` count for both.
    """

    name = "auto"
    kernel_number = 3
    words = "ANALYN, or strips where it errs by 4 %"


@frozen
class Hertz(NormalModel):
    """One Hertz ellipse from the curvatures at the contact point.

    ``tolerance`` only sets the nodes over which an adaptive lateral curvature is averaged; the ellipse is a
    formula.
    """

    name = "hertz"
    kernel_number = 0
    words = "one Hertz ellipse from the curvatures at the contact point"

    tolerance: float | None = tolerance_from(1e-4)


@frozen
class Halfspace(NormalModel):
    """Complete elastic half-space on the true three-dimensional gap, whose normals turn with the surfaces
    (wrcontact/halfspace/contact.py).

    It needs scipy, so an FMU does not have it.  A wheel takes some tenths of a second, seconds where narrow
    patches lie far apart.  ``tolerance`` [1] is the relative error of its grid, 0.005 where None.
    """

    name = "halfspace"
    kernel_number = Hertz.kernel_number  # the cheapest; of the kernel it needs the rigid geometry alone
    words = "complete half-space theory on the true gap"
    python_only = True
    needs = {
        "knows the whole surface": {
            "longitudinal_curvature": "effective",
            "separation": "normal",
            "lateral_curvature": "adaptive",
        },
        "has no damping": {"contact_damping": 0.0},
    }

    tolerance: float | None = tolerance_from(3e-4)

    def check_beside(self, chosen):
        """As for every method; with creep forces, which would carry a part of a vertical load, the load is
        the normal one."""
        super().check_beside(chosen)
        if chosen["tangential_model"] != "none" and chosen["load"] != "normal":
            raise ValueError(
                f"load is {chosen['load']!r}; permitted with the normal_model 'halfspace' and "
                f"the tangential_model {chosen['tangential_model']!r} is 'normal'"
            )
