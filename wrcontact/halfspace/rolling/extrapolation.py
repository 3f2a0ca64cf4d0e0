"""Steady rolling contact of a patch: forces extrapolated from two grids.

A patch of the kernel is an outline in its station frame: x forward, y the station, to the field side on both
sides of the track; the origin is its centre of load.
"""

from dataclasses import dataclass

import numpy as np

from ...kernel import layout
from .contact import RollingSolution, rolling_contact
from .pressure import Outline

#: Cells across the patch, each way, of the coarse grid; the fine one has twice as many.
COARSE_CELLS = 24


def outline_of_patch(strips, patch):
    """The :class:`~wrcontact.halfspace.rolling.pressure.Outline` of one patch, with the patch's load.

    Parameters
    ----------
    strips : :class:`~wrcontact.kernel.layout.SolvedStrips` on which it lies.
    patch : :class:`~wrcontact.kernel.layout.Patch`.

    Raises
    ------
    ValueError
        if no strip of the patch is loaded.
    """
    totals = patch.totals
    if patch.rule == layout.RULE_ELLIPSE:
        return Outline.of_ellipse(totals.max_half_length, 0.5 * totals.width, totals.load)
    strips = [strips[k] for k in range(patch.first, patch.last + 1)]
    loaded = [
        strip
        for strip in strips
        if strip.line_load > 0.0
        and strip.half_length_square > 0.0
        and totals.start < strip.station < totals.stop
    ]
    if not loaded:
        raise ValueError(f"the patch at station {totals.centroid} m has no loaded strip")
    station, square, load, x = np.array(
        [[strip.station, strip.half_length_square, strip.line_load, strip.x] for strip in loaded]
    ).T
    half_length = np.sqrt(square)
    pressure = load / (0.5 * np.pi * half_length)
    middle = x - np.average(x, weights=load * [strip.width for strip in loaded])
    outline = Outline.of_stations(
        np.concatenate([[totals.start], station, [totals.stop]]) - totals.centroid,
        np.pad(half_length, 1),
        np.pad(pressure, 1),
        np.pad(middle, 1, mode="edge"),
    )
    return outline.scaled(totals.load)


def roll_patch(strips, patch, **motion):
    """:class:`~wrcontact.halfspace.rolling.extrapolation.RollingForces` on the wheel of one patch, in
    its station frame and about its centre of load; keywords as for
    :func:`~wrcontact.halfspace.rolling.extrapolation.roll_outline`."""
    return roll_outline(outline_of_patch(strips, patch), **motion)


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
    mean_friction : mean coefficient of friction, weighted with the pressure [-].
    coarse, fine : :class:`RollingSolution` on either grid.
    """

    force_x: float
    force_y: float
    moment: float
    stick_share: float
    max_shear: float
    dissipation: float
    mean_friction: float
    coarse: RollingSolution
    fine: RollingSolution


def extrapolated(coarse, fine):
    """:class:`RollingForces` of solutions whose cells differ by the factor 2.

    The grid's error is proportional to the cell: ``F = 2 F_fine - F_coarse``.  (R8)  The stick share is cut
    to 0 ... 1 and the dissipation to positive values.
    """
    names = ("force_x", "force_y", "moment", "stick_share", "dissipation", "mean_friction")
    values = {name: 2.0 * getattr(fine, name) - getattr(coarse, name) for name in names}
    values["stick_share"] = float(np.clip(values["stick_share"], 0.0, 1.0))
    values["dissipation"] = max(values["dissipation"], 0.0)
    return RollingForces(**values, max_shear=fine.max_shear, coarse=coarse, fine=fine)


def roll_outline(outline, *, creepage_x, creepage_y, spin, cells=COARSE_CELLS, start=None, **material):
    """:class:`RollingForces` of a patch that is given by stations.

    Parameters
    ----------
    outline : :class:`~wrcontact.halfspace.rolling.pressure.Outline`; rolling towards +x, y = station.
    creepage_x, creepage_y, spin : xi, eta [1], phi [1/m]; a number, or one for each station (n,), such as
        from the rolling radius of each strip; then straight lines between the stations.
    cells : of the coarse grid, each way.
    start : :class:`RollingForces` of the same outline at other creepages, to be faster.
    material : ``friction``, ``fall``, ``shear_modulus`` [Pa], ``poisson_ratio``.

    Raises
    ------
    ValueError, ArithmeticError
        as :func:`~wrcontact.halfspace.rolling.contact.rolling_contact`.
    """
    solution, found = None if start is None else start.coarse, []
    for count in (cells, 2 * cells):
        field = outline.on_grid(count, count)
        creepages = [
            each if np.ndim(each) == 0 else np.interp(field.y, outline.station, each)
            for each in (creepage_x, creepage_y, spin)
        ]
        solution = rolling_contact(
            field,
            creepage_x=creepages[0],
            creepage_y=creepages[1],
            spin=creepages[2],
            start=solution,
            **material,
        )
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
