"""A patch of the kernel as an outline in its station frame: x forward, y the station, to the field
side on both sides of the track; the origin is its centre of load."""

import numpy as np

from ...kernel import layout
from .extrapolation import roll_outline
from .pressure import Outline


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
    loaded = [strip for strip in strips if strip.line_load > 0.0 and strip.half_length_square > 0.0
              and totals.start < strip.station < totals.stop]
    if not loaded:
        raise ValueError(f"the patch at station {totals.centroid} m has no loaded strip")
    station, square, load, x = np.array([[strip.station, strip.half_length_square, strip.line_load, strip.x]
                                         for strip in loaded]).T
    half_length = np.sqrt(square)
    pressure = load / (0.5 * np.pi * half_length)
    middle = x - np.average(x, weights=load * [strip.width for strip in loaded])
    outline = Outline.of_stations(
        np.concatenate([[totals.start], station, [totals.stop]]) - totals.centroid,
        np.pad(half_length, 1), np.pad(pressure, 1), np.pad(middle, 1, mode="edge"))
    return outline.scaled(totals.load)


def roll_patch(strips, patch, **motion):
    """:class:`~wrcontact.halfspace.rolling.extrapolation.RollingForces` on the wheel of one patch, in
    its station frame and about its centre of load; keywords as for
    :func:`~wrcontact.halfspace.rolling.extrapolation.roll_outline`."""
    return roll_outline(outline_of_patch(strips, patch), **motion)
