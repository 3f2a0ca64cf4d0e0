"""Contacts and roll against the lateral shift, with the parts of the wheel and the jumps of the contact."""

from dataclasses import dataclass

import numpy as np
from matplotlib.ticker import MultipleLocator

from ..conditioning.curves import find_jumps, merged_jumps
from ..conventions import SIDES
from ..profiles.changing import refuse_changing
from ..results.words import ShortText
from ..status import Status, explain
from .geometry import WHEEL_ZONES
from .style import DEGREE, INK, MM, QUIET, SIDE_COLOUR, ZONE_COLOUR, given_axes, new_figure, number, styled

SHOWN = (-46e-3, 24e-3)  # [m] of the wheel profile
STEP = 0.05e-3  # [m]
TICKS = 2  # [mm] between numbers on the shift axis
LARGEST = 8e-3  # [m] lateral shift of a sweep to both sides
BAND = {"boxstyle": "square,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}


@dataclass(frozen=True, repr=False)
class Sweep(ShortText):
    """Wheelset states at rising lateral shifts [m], and the jumps of their contacts."""

    lateral_shift: np.ndarray
    state: object
    jumps: list


def sweep(system, lateral_shift=None, yaw=0.0):
    """Evaluate ``system`` over rising ``lateral_shift`` [m] (n,), by default from -8 to 8 mm, at one yaw
    [rad]."""
    refuse_changing(system, "a sweep over the lateral shift")
    if lateral_shift is None:
        lateral_shift = np.linspace(-LARGEST, LARGEST, round(2 * LARGEST / STEP) + 1)
    lateral_shift = np.asarray(lateral_shift, dtype=float)
    state = system.evaluate_many(lateral_shift=lateral_shift, yaw=yaw)
    return Sweep(lateral_shift, state, find_jumps(system, lateral_shift, yaw))


def check_contact(table):
    """Refuse a table of states of which none has a contact, with the reason of the middle one."""
    if not np.any(np.asarray(table.status) <= Status.UNLOADED):
        middle = table[len(table) // 2]
        raise ValueError(
            f"none of the {len(table)} lateral shifts has a contact: {explain(middle.status, middle.inputs)}"
        )


@styled
def sweep_figure(swept, ax=None):
    """Contact position of both wheels and roll of the wheelset against the lateral shift, in the axes ``ax``
    (3,) or in a new figure; returns the figure."""
    figure, panels = given_axes(new_figure(10, 3.6).subplots(1, 3) if ax is None else ax, (3,))
    draw_sweep(panels, swept)
    return figure


def draw_sweep(panels, swept):
    """Left contact, right contact and roll into three panels."""
    for panel, side in zip(panels, SIDES):
        draw_position(panel, swept, side)
    draw_roll(panels[2], swept)


def draw_position(panel, swept, side):
    """Lateral position of one contact on its wheel [mm] over the lateral shift [mm], with the zones of the
    S1002."""
    panel.set_label(f"{side} position")
    draw_zones(panel, 0.03 if side == "right" else 0.97)
    panel.plot(*broken_curve(swept, side), color=SIDE_COLOUR[side], gid="position")
    for jump in told_jumps(swept, side):
        draw_jump(panel, jump, SIDE_COLOUR[side])
    panel.set(
        xlim=(swept.lateral_shift[0] / MM, swept.lateral_shift[-1] / MM),
        ylim=(SHOWN[0] / MM, SHOWN[1] / MM),
        xlabel="lateral shift, right + [mm]",
        ylabel="field side + [mm]",
    )
    panel.xaxis.set_major_locator(MultipleLocator(TICKS))
    panel.set_title(f"Contact on the {side} wheel's profile")


def draw_zones(panel, edge):
    """Bands of tread, flange root and flange, named at ``edge``: 0 left, 1 right in the panel, more beside
    it."""
    for name, (low, high) in WHEEL_ZONES.items():
        low, high = max(low, SHOWN[0]) / MM, min(high, SHOWN[1]) / MM
        panel.axhspan(low, high, color=ZONE_COLOUR[name], linewidth=0, zorder=0)
        panel.text(
            edge,
            low + 0.8 if name == "tread" else (low + high) / 2,
            name,
            color=QUIET,
            style="italic",
            ha="right" if 0.5 < edge < 1 else "left",
            va="bottom" if name == "tread" else "center",
            transform=panel.get_yaxis_transform(),
        )


def broken_curve(swept, side):
    """Lateral shift and contact position [mm], two arrays, interrupted at every jump."""
    jumps = [jump for jump in swept.jumps if jump.side == side]
    shift = np.concatenate([swept.lateral_shift, *([jump.lateral_shift] * 3 for jump in jumps)])
    place = np.concatenate(
        [getattr(swept.state, side).contact.y_wheel, *([jump.before, np.nan, jump.after] for jump in jumps)]
    )
    order = np.argsort(shift, kind="stable")
    return shift[order] / MM, place[order] / MM


def told_jumps(swept, side):
    """(lateral shift, before, after) [m] of the jumps of one contact; close neighbours are one, at the
    largest of them."""
    return [(jump.lateral_shift, jump.before, jump.after) for jump in merged_jumps(swept.jumps, side)]


def draw_jump(panel, jump, colour):
    """A jump as a dotted line with its lateral shift beside it."""
    shift, before, after = (length / MM for length in jump)
    panel.plot([shift, shift], [before, after], color=colour, linewidth=1, linestyle=":", gid="jump")
    inward = -1 if shift > 0 else 1
    panel.annotate(
        f"jump at {number(shift, 2)} mm",
        (shift, (before + after) / 2),
        (6 * inward, 0),
        textcoords="offset points",
        ha="right" if inward < 0 else "left",
        va="center",
        fontsize=8,
        color=INK,
        bbox=BAND,
    )


def draw_roll(panel, swept):
    """Roll of the wheelset [deg] over the lateral shift [mm]."""
    panel.set_label("roll")
    panel.axhline(0, color=QUIET, linewidth=0.6)
    panel.plot(swept.lateral_shift / MM, swept.state.roll / DEGREE, color=INK)
    panel.set(
        xlim=(swept.lateral_shift[0] / MM, swept.lateral_shift[-1] / MM),
        xlabel="lateral shift, right + [mm]",
        ylabel="right wheel down + [deg]",
    )
    panel.xaxis.set_major_locator(MultipleLocator(TICKS))
    panel.set_title("Roll of the wheelset")
