"""Contact lines: the profiles of a wheel and its rail one above the other, and lines between the places that
touch each other while the wheelset moves across the track."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize

from ..conditioning.curves import find_jumps, merged_jumps
from ..conventions import SIDES
from ..methods.numbers import check_choice
from ..profiles.compiled import evaluate_table, places
from .style import MM, RAIL_COLOUR, RAIL_LABEL, SHIFT_COLOURS, WHEEL_COLOUR, given_axis, number, styled
from .sweep import check_contact

SHIFTS = np.arange(-32, 33) * 0.25e-3  # [m] lateral shifts of the drawn lines
APART = 14e-3  # [m] distance between the drawn wheel and rail
STEP = 0.2e-3  # [m] spacing of the points of a drawn profile
MARGIN = 8e-3  # [m] of the profiles beside the outermost contacts
FLANGE = 24e-3  # [m] of the wheel beside the outermost contact on the track side, with its flange
NAMED = 1e-3  # [m] a jump over more than this has its lateral shift written beside it
BROKEN = {"linestyle": ":", "linewidth": 1.2}


@styled
def contact_lines(system, axis=None, *, side="right", lateral_shift=SHIFTS, yaw=0.0, bar=True):
    """Lines between the places of a wheel and its rail that touch each other, coloured by the lateral shift.

    Where the contact jumps the lines leave a gap, between two dotted lines: the places just before and behind
    the jump, whose lateral shift stands above.  Both profiles lie as in the centred position, the wheel
    raised.

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem`.
    axis : axis of matplotlib; None for one in a new figure.
    side : "right" or "left"; both have the field side on the right.
    lateral_shift : rising, of the lines (n,) [m].
    yaw : [rad].
    bar : whether to draw a bar with the colours.

    Returns
    -------
    axis
        its lines are ``gid`` "line" and, beside a jump, "jump"; in mm.
    """
    check_choice("side", side, SIDES)
    shift = np.asarray(lateral_shift, dtype=float)
    table = system.evaluate_many(lateral_shift=shift, yaw=yaw, outputs="geometry")
    check_contact(table)
    contact = getattr(table, side).contact
    there = np.isfinite(contact.y_wheel)
    axis = given_axis(axis, 7.2, 3.7)
    axis.set_title(
        f"Where the {side} wheel touches its rail: {_pair(system, side)}\n"
        "Dotted: before and behind a jump, at this lateral shift in mm",
        fontsize=9,
    )
    draw_lines(
        axis,
        system,
        side,
        shift[there],
        (contact.y_wheel[there], contact.y_rail[there]),
        find_jumps(system, shift, yaw),
        bar,
    )
    return axis


def _pair(system, side):
    wheel, rail = (system.wheel, system.rail) if side == "right" else (system.left_wheel, system.left_rail)
    return f"{wheel.name} on {rail.name}"


def draw_lines(axis, system, side, shift, touching, jumps, bar=True):
    """Draw the profiles of a ``side`` and lines between ``touching``, the places on wheel and rail (n,) [m],
    at the lateral shifts ``shift`` (n,) [m]; ``jumps`` are those of both sides."""
    wheel, rail, y_top = system.profile_tables(side)
    # lateral distance of the rail's frame from the wheel's in the centred position
    aside = y_top - system.side_parameters(side)["running_circle_distance"] / 2
    jumps = [jump for jump in merged_jumps(jumps, side) if shift[0] <= jump.lateral_shift <= shift[-1]]
    colours = shift_colours(shift)
    _draw_profile(axis, wheel, touching[0], 0.0, APART / MM, WHEEL_COLOUR, up=True)
    _draw_profile(axis, rail, touching[1], aside, 0.0, RAIL_COLOUR, up=False)
    for at, *pair in zip(shift, *touching):
        _join(axis, wheel, rail, aside, pair, color=colours.to_rgba(at / MM), linewidth=0.9, gid="line")
    for jump in jumps:
        colour = colours.to_rgba(jump.lateral_shift / MM)
        for pair in ((jump.before, jump.rail_before), (jump.after, jump.rail_after)):
            top = _join(axis, wheel, rail, aside, pair, color=colour, gid="jump", **BROKEN)
        if abs(jump.after - jump.before) > NAMED:
            inwards = np.array([evaluate_table(wheel, jump.after)[1], 1.0])
            axis.annotate(
                number(jump.lateral_shift / MM, 2),
                top,
                13 * inwards / np.hypot(*inwards),
                textcoords="offset points",
                ha="center",
                va="center",
                fontsize=8,
            )
    axis.set_aspect("equal", adjustable="datalim")
    axis.set(xlabel="across the wheel from its running circle, field side + [mm]", yticks=[])
    axis.spines["left"].set_visible(False)
    if bar:
        axis.get_figure().colorbar(colours, ax=axis, label="lateral shift, right + [mm]", pad=0.01, aspect=30)


def shift_colours(shift):
    """Colours of lateral shifts between the first and last of ``shift`` (n,) [m], by mm."""
    return ScalarMappable(Normalize(shift[0] / MM, shift[-1] / MM), ListedColormap(SHIFT_COLOURS))


def _draw_profile(axis, table, touched, aside, height, colour, up):
    """A profile around the places ``touched`` [mm], filled upwards or downwards."""
    y = places(table, STEP)
    y = y[(y >= np.min(touched) - (FLANGE if up else MARGIN)) & (y <= np.max(touched) + MARGIN)]
    z = height - evaluate_table(table, y)[0] / MM
    edge = np.max(z) + 3 if up else np.min(z) - 3
    axis.fill_between((y + aside) / MM, z, edge, color=colour, alpha=0.18, linewidth=0)
    axis.plot((y + aside) / MM, z, color=colour)
    name, at = ("wheel", np.max(z) + 1) if up else ("rail", np.min(z) - 1)
    axis.text(
        (y[-1] + aside) / MM - 1, at, name, color=WHEEL_COLOUR if up else RAIL_LABEL, ha="right", va="center"
    )


def _join(axis, wheel, rail, aside, pair, **look):
    """Draw a line from a point on the wheel to one on the rail; return its upper end [mm]."""
    y_wheel, y_rail = pair
    top = y_wheel / MM, (APART - evaluate_table(wheel, y_wheel)[0]) / MM
    axis.plot([top[0], (y_rail + aside) / MM], [top[1], -evaluate_table(rail, y_rail)[0] / MM], **look)
    return top
