"""Rolling radius difference, contact angles and roll over the lateral shift, each on one axis."""

import numpy as np

from ..conditioning.curves import merged_jumps
from ..conventions import SIDES
from .style import DEGREE, INK, MM, QUIET, SIDE_COLOUR, given_axis, styled
from .sweep import check_contact, draw_roll

SIZE = 5.4, 3.4  # [in] of a figure


@styled
def radius_difference(swept, axis=None):
    """Right minus left rolling radius [mm] over the lateral shift [mm], with a gap at each jump.

    Parameters
    ----------
    swept : what :func:`wrcontact.plots.sweep` returns.
    axis : axis of matplotlib; None for one in a new figure.

    Returns
    -------
    axis
    """
    axis = given_axis(axis, *SIZE)
    state = swept.state
    _draw(axis, swept, (state.right.rolling_radius - state.left.rolling_radius) / MM, SIDES, color=INK)
    _label(axis, swept, "Rolling radius difference", "right \N{MINUS SIGN} left [mm]")
    axis.axhline(0.0, color=QUIET, linewidth=0.6)
    return axis


@styled
def contact_angle(swept, axis=None):
    """Contact angles of both wheels [deg] over the lateral shift [mm], with gaps at their jumps; arguments
    and result as for :func:`radius_difference`."""
    axis = given_axis(axis, *SIZE)
    for side, stroke in zip(SIDES, ("-", (0, (5, 1.5)))):
        _draw(
            axis,
            swept,
            getattr(swept.state, side).contact_angle / DEGREE,
            (side,),
            color=SIDE_COLOUR[side],
            linestyle=stroke,
            label=f"{side} wheel",
        )
    _label(axis, swept, "Contact angle", "towards the flange + [deg]")
    axis.legend(loc="upper center", frameon=True, framealpha=1.0, edgecolor="none")
    return axis


@styled
def roll_angle(swept, axis=None):
    """Roll of the wheelset [deg] over the lateral shift [mm]; arguments and result as for
    :func:`radius_difference`."""
    check_contact(swept.state)
    axis = given_axis(axis, *SIZE)
    draw_roll(axis, swept)
    return axis


def _draw(axis, swept, values, sides, **look):
    """A curve that is interrupted at the jumps of ``sides``, with dotted lines there."""
    check_contact(swept.state)
    jumps = [jump.lateral_shift for side in sides for jump in merged_jumps(swept.jumps, side)]
    shift = np.concatenate([swept.lateral_shift, jumps])
    order = np.argsort(shift, kind="stable")
    axis.plot(shift[order] / MM, np.concatenate([values, np.full(len(jumps), np.nan)])[order], **look)
    for jump in jumps:
        axis.axvline(jump / MM, color=look["color"], linewidth=0.8, linestyle=":", gid="jump")


def _label(axis, swept, title, quantity):
    axis.set(
        xlim=(swept.lateral_shift[0] / MM, swept.lateral_shift[-1] / MM),
        ylabel=quantity,
        xlabel="lateral shift, right + [mm]",
    )
    axis.set_title(f"{title}; dotted: jumps")
