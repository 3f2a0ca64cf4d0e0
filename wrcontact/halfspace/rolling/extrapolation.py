"""Steady rolling contact of a patch: forces extrapolated from two grids."""

from dataclasses import dataclass

import numpy as np

from .contact import RollingSolution, rolling_contact
from .pressure import Outline

#: Cells across the patch, each way, of the coarse grid; the fine one has twice as many.
COARSE_CELLS = 24


@dataclass(frozen=True)
class RollingForces:
    """Forces on the wheel, extrapolated; tractions of the fine grid.

    Attributes
    ----------
    force_x, force_y : along and across the rolling direction [N].
    moment : about the normal through the origin [N m].
    stick_share : share of the patch's area without slip, 0 ... 1.
    max_shear : largest traction of a cell of the fine grid [Pa].
    dissipation : friction power over the rolling speed, W/(m/s) = N.
    coarse, fine : :class:`RollingSolution` on either grid.
    """

    force_x: float
    force_y: float
    moment: float
    stick_share: float
    max_shear: float
    dissipation: float
    coarse: RollingSolution
    fine: RollingSolution


def extrapolated(coarse, fine):
    """:class:`RollingForces` of solutions whose cells differ by the factor 2.

    The grid's error is proportional to the cell: ``F = 2 F_fine - F_coarse``.  (R8)  The stick share is cut
    to 0 ... 1 and the dissipation to positive values.
    """
    names = ("force_x", "force_y", "moment", "stick_share", "dissipation")
    values = {name: 2.0 * getattr(fine, name) - getattr(coarse, name) for name in names}
    values["stick_share"] = float(np.clip(values["stick_share"], 0.0, 1.0))
    values["dissipation"] = max(values["dissipation"], 0.0)
    return RollingForces(**values, max_shear=fine.max_shear, coarse=coarse, fine=fine)


def roll_outline(outline, *, creepage_x, creepage_y, spin, cells=COARSE_CELLS, start=None, **material):
    """:class:`RollingForces` of a patch that is given by stations.

    Parameters
    ----------
    outline : :class:`~wrcontact.halfspace.rolling.pressure.Outline`; rolling towards +x, y = station.
    creepage_x, creepage_y : xi, eta [1]; a number, or one for each station (n,), such as
        from the rolling radius of each strip; then straight lines between the stations.
    spin : phi [1/m].
    cells : of the coarse grid, each way.
    start : :class:`RollingForces` of the same outline at other creepages, to be faster.
    material : ``friction``, ``shear_modulus`` [Pa], ``poisson_ratio``.

    Raises
    ------
    ValueError, ArithmeticError
        as :func:`~wrcontact.halfspace.rolling.contact.rolling_contact`.
    """
    solution, found = None if start is None else start.coarse, []
    for count in (cells, 2 * cells):
        field = outline.on_grid(count, count)
        creepages = [each if np.ndim(each) == 0 else np.interp(field.y, outline.station, each)
                     for each in (creepage_x, creepage_y)]
        solution = rolling_contact(field, creepage_x=creepages[0], creepage_y=creepages[1], spin=spin,
                                   start=solution, **material)
        found.append(solution)
    return extrapolated(*found)


def roll_ellipse(half_length, half_width, normal_force, **motion):
    """:class:`RollingForces` of Hertz's ellipse; keywords as in :func:`roll_outline`.

    Parameters
    ----------
    half_length, half_width : half-axes along and across the rolling direction [m].
    normal_force : [N].
    """
    return roll_outline(Outline.of_ellipse(half_length, half_width, normal_force), **motion)
