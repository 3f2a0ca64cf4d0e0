"""The reaction on a rail, about the rail's own reference point."""

import numpy as np

from ..conventions import SIDES
from ..kernel import layout
from ..methods.numbers import check_choice


def rail_reaction(tables, inputs, outputs, side):
    """Force (3,) [N] of a wheel on its rail, and its moment (3,) [N m] about the rail's reference point: the
    highest point of its head, where its displacement and its springs have taken it.

    The opposite of the wheel's own, moved from the wheelset's centre C to the point P:
    ``M_P = -(M_C + (C - P) x F)``.  All in the axes of the track.

    Parameters
    ----------
    tables : of the system, with or without what follows its settings.
    inputs, outputs : of a step, as a stepper has them.
    side : "left" or "right".
    """
    check_choice("side", side, SIDES)
    index = SIDES.index(side)
    settings, given = layout.Tables.at(tables), layout.Inputs.at(np.array(inputs))
    found = layout.Outputs.at(np.array(outputs))
    out, sign = found.left[index], 1.0 if side == "right" else -1.0
    across = getattr(given, f"{side}_rail_lateral") + out.rail_deflection_lateral
    down = getattr(given, f"{side}_rail_vertical") + out.rail_deflection_vertical
    point = np.array([0.0, sign * settings.pairs[index].rail_y + across, down])
    centre = np.array([0.0, given.lateral_shift, found.vertical_shift - settings.height])
    force = np.array(out.force[:])
    return -force, -(np.array(out.moment[:]) + np.cross(centre - point, force))
