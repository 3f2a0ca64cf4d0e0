"""One wheel pressed into its rail, straight down: until it carries a force, or by a given penetration."""

from dataclasses import dataclass, replace

from .contact import RESIDUAL_SHARE, solve_problem
from .problem import Problem
from .solution import HalfspaceContact
from .turning_gap import TurningGap, turning_gap

#: A first answer on coarse grids tells how deep the wheel comes; its error.
FIRST_TOLERANCE = 0.1
#: The curve between the bodies is made anew where the penetration differs from the one that it is made for by
#: more than this share of it: 20 % change the load by 0.02 % and the peak by 0.1 %.
LAID_SHARE = 0.03
LAYINGS = 8


@dataclass(frozen=True)
class Settings:
    """What is the same for all wheels: E* [Pa], the coupling of the materials
    (:func:`~wrcontact.halfspace.deflection.coupling_of`), whether forces are vertical ones, and the permitted
    relative error."""

    contact_modulus: float
    coupling: float
    vertical: bool
    tolerance: float

    def at(self, tolerance):
        """The same with another tolerance."""
        return replace(self, tolerance=tolerance)


@dataclass(frozen=True)
class PressedWheel:
    """A wheel in its rail: ``surfaces``, with gaps that are exact for the ``contact``, which lies on them."""

    surfaces: TurningGap
    contact: HalfspaceContact

    def counted_from(self, rail_y):
        """The same with stations counted from the rail's abscissa ``rail_y`` [m] of the track frame."""
        start = self.surfaces.curve.station_of(rail_y)
        return PressedWheel(replace(self.surfaces, curve=self.surfaces.curve.shifted(start)),
                            replace(self.contact, s=self.contact.s - start))


def press(pair, settings, *, force=None, penetration=None, estimate=None, sure=False):
    """The :class:`PressedWheel` of a ``pair`` that just touches.

    Parameters
    ----------
    pair : the wheel above its rail, :class:`~wrcontact.halfspace.wheel_on_rail.WheelOnRail`.
    settings : :class:`Settings`.
    force : of the contact [N], with an ``estimate`` of the penetration [m], which may be ``sure``; or
    penetration : how far the wheel moves down [m].

    Raises
    ------
    ArithmeticError
        where the solution or the curve below it is not found.
    """
    laid = estimate if penetration is None else penetration
    known = force is None or sure
    tolerance = settings.tolerance if known else max(settings.tolerance, FIRST_TOLERANCE)
    for _ in range(LAYINGS):
        surfaces = turning_gap(pair, laid)
        found = solve_problem(Problem(surfaces, surfaces.domain, settings.contact_modulus, force, penetration,
                                      RESIDUAL_SHARE * tolerance, settings.coupling, settings.vertical),
                              tolerance)
        final, tolerance = tolerance == settings.tolerance, settings.tolerance
        if final and abs(found.penetration - laid) <= LAID_SHARE * abs(laid):
            return PressedWheel(surfaces.near(found.penetration), found)
        laid = found.penetration
    raise ArithmeticError(f"the penetration still changes from {laid:g} m after {LAYINGS} curves between "
                          "wheel and rail")
