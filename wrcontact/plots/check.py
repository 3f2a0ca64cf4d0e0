"""The picture of ``wrcontact check``: contact positions, rolling radii, contact angles, conicity, sensitivities
and conformal zones."""

from functools import partial

import numpy as np

from ..conditioning.conformal import NEAR, TURN, WIDE
from ..conditioning.conicity import AMPLITUDES, Swing, regressed_conicity
from ..conditioning.curves import merged_jumps
from ..conditioning.measures import MOVES
from ..conditioning.text import differing_left
from ..conventions import SIDES
from .lines import SHIFTS, draw_lines
from .style import (
    DEGREE,
    INK,
    MM,
    QUIET,
    RAIL_COLOUR,
    SIDE_COLOUR,
    WHEEL_COLOUR,
    given_axes,
    in_lines,
    new_figure,
    number,
    styled,
)
from .sweep import BAND

SHOWN = 8e-3  # [m] lateral shifts shown, the largest amplitude
FINE_AMPLITUDES = np.arange(5, 81) * 1e-4  # [m] of the drawn conicity
#: Curves of the conicity in the report, their colours and words.
SWINGS = ("rolled", INK, "with roll"), ("level", "#009E73", "without roll")


@styled
def check_figure(report, ax=None, side="right"):
    """Draw ``report``, a :class:`~wrcontact.conditioning.Conditioning`, in eight panels: the axes ``ax`` (8,)
    or those of a new figure, which is returned; places and rates are those of ``side``."""
    if ax is None:
        figure = new_figure(10, 12.2)
        grid = figure.add_gridspec(4, 6, height_ratios=(3.6, 2.6, 2.3, 2.3))
        figure.suptitle(in_lines(_headline(report), 10), x=0.01, ha="left")
        ax = [
            figure.add_subplot(grid[0, :]),
            *(figure.add_subplot(grid[1, column : column + 2]) for column in (0, 2, 4)),
            *(figure.add_subplot(grid[row, column : column + 3]) for row in (2, 3) for column in (0, 3)),
        ]
    figure, panels = given_axes(ax, (8,))
    draw_places(panels[0], report, side)
    for panel, draw in zip(
        panels[1:],
        (
            draw_radii,
            draw_angles,
            draw_conicity,
            partial(draw_moves, of=side),
            draw_roll_rate,
            draw_distance,
            partial(draw_near, of=side),
        ),
    ):
        draw(panel, report)
    return figure


def _headline(report):
    chosen = report.system.parameters
    lean = chosen["rail_inclination"]
    return (
        f"{report.system.title}, "
        f"{f'inclination 1:{1 / lean:.3g}' if lean else 'upright'}, gauge {chosen['gauge'] / MM:.6g} mm, "
        f"nominal radius {chosen['nominal_radius'] / MM:.6g} mm{differing_left(report.system)}"
    )


def _head(panel, label, title):
    panel.set_label(label)
    panel.set_title(title)


# --- places of contact -----------------------------------------------------------------------------


def draw_places(panel, report, of="right"):
    """Wheel above rail, contact points joined by lines coloured by the lateral shift; jumps are dotted."""
    _head(panel, "places", f"Contact points of {of} wheel and rail; dotted beside a jump")
    side = getattr(report.curves, of)
    at = np.unique([np.argmin(np.abs(report.curves.lateral_shift - shift)) for shift in SHIFTS])
    at = at[np.isfinite(side.y_wheel[at])]
    if len(at):
        draw_lines(
            panel,
            report.system,
            of,
            report.curves.lateral_shift[at],
            (side.y_wheel[at], side.y_rail[at]),
            report.jumps,
        )


def _shown_jumps(report, side):
    return [jump for jump in merged_jumps(report.jumps, side) if abs(jump.lateral_shift) <= SHOWN]


# --- rolling radii and conicity --------------------------------------------------------------------


def draw_radii(panel, report):
    """Rolling radius difference [mm] against the lateral shift, with and without roll."""
    _head(panel, "radii", "Radius difference, right minus left")
    for name, colour, words in SWINGS:
        if report.conicity_curves[name] is not None:
            shift, difference = report.conicity_curves[name]
            panel.plot(
                shift / MM,
                difference / MM,
                color=colour,
                label=words,
                zorder=2 if name == "rolled" else 3,
                linewidth=1.6 if name == "rolled" else 1.1,
            )
    panel.axhline(0, color=QUIET, linewidth=0.6)
    _shift_axis(panel, "mm")
    _legend(panel)


def draw_angles(panel, report):
    """Contact angles of both wheels [deg] against the lateral shift."""
    _head(panel, "angles", "Contact angles, to the flange +")
    shift, angle = report.curves.lateral_shift / MM, MOVES["contact_angle"]
    for side, stroke in zip(SIDES, ("-", (0, (5, 1.5)))):
        curve = _broken(report, shift, angle.shown(report.curves, side), side)
        panel.plot(*curve, color=SIDE_COLOUR[side], linestyle=stroke, label=side)
    _shift_axis(panel, angle.shown_unit)
    panel.legend(loc="best")


def draw_conicity(panel, report):
    """Equivalent conicity against the amplitude, with and without roll; dots are the values in the report."""
    _head(panel, "conicity", "Conicity (EN 15302: no roll)")
    shown = [0.0, 0.09]
    for name, colour, words in SWINGS:
        curve, dots = report.conicity_curves[name], getattr(report.conicity, name)
        if curve is not None:
            swing = Swing(*curve)
            values = [swing.conicity(value)[0] for value in FINE_AMPLITUDES]
            shown += [*values, *dots]
            panel.plot(FINE_AMPLITUDES / MM, values, color=colour, label=words)
            panel.plot(AMPLITUDES / MM, dots, "o", color=colour, markersize=3.5)
            if name == "level":
                values = regressed_conicity(*curve, FINE_AMPLITUDES)
                panel.plot(FINE_AMPLITUDES / MM, values, ":", color=colour, label="by regression")
    limits = 1.1 * np.nanmin(shown), 1.1 * np.nanmax(shown)
    panel.set(xlim=(0, AMPLITUDES[-1] / MM + 0.2), ylim=limits, xlabel="amplitude [mm]", ylabel="tan γ")
    _legend(panel)


def _legend(panel):
    if panel.get_legend_handles_labels()[0]:
        panel.legend(loc="best")
    else:
        panel.text(0.5, 0.5, "no contact", transform=panel.transAxes, ha="center", color=QUIET)


# --- conditioning ----------------------------------------------------------------------------------


def draw_moves(panel, report, of="right"):
    """Rate of the contact position of one side on wheel and rail, per lateral shift; logarithmic, linear near
    zero."""
    _head(panel, "moves", f"Rate of the {of} contact per lateral shift")
    shift = report.curves.lateral_shift / MM
    for name, colour in (("wheel_rate", WHEEL_COLOUR), ("rail_rate", RAIL_COLOUR)):
        rate = np.abs(MOVES[name].shown(report.curves, of))
        panel.plot(*_broken(report, shift, rate, of), color=colour, label=MOVES[name].heading)
    _mark_jumps(panel, report, (of,))
    _shift_axis(panel, MOVES["wheel_rate"].shown_unit, rates=True)
    panel.legend(loc="best")


def draw_roll_rate(panel, report):
    """Rate of the roll, per lateral shift; logarithmic, linear near zero."""
    _head(panel, "roll rate", "Roll per lateral shift")
    roll = MOVES["roll_rate"]
    shift, rate = report.curves.lateral_shift / MM, np.abs(roll.shown(report.curves, None))
    for side in SIDE_COLOUR:
        shift, rate = _broken(report, shift, rate, side)
    panel.plot(shift, rate, color=INK)
    _mark_jumps(panel, report, SIDE_COLOUR)
    _shift_axis(panel, roll.shown_unit, rates=True)


def draw_distance(panel, report):
    """Distance in lateral shift to the nearest jump of either contact."""
    _head(panel, "distance", "Distance to the nearest jump of either contact")
    next_jump = MOVES["jump_distance"]
    distance = next_jump.shown(report.curves, None)
    panel.plot(report.curves.lateral_shift / MM, np.where(np.isfinite(distance), distance, np.nan), color=INK)
    _mark_jumps(panel, report, SIDE_COLOUR)
    if np.isfinite(report.nearest_jump):
        panel.plot([0], [report.nearest_jump / MM], "o", color=INK, markersize=4)
        panel.annotate(
            f"centred: {number(report.nearest_jump * next_jump.factor, next_jump.digits)} {next_jump.shown_unit}",
            (0, report.nearest_jump / MM),
            (7, 0),
            textcoords="offset points",
            ha="left",
            va="center",
            fontsize=8,
            bbox=BAND,
        )
    else:
        panel.text(0.5, 0.5, "no jumps", transform=panel.transAxes, ha="center", color=QUIET)
    _shift_axis(panel, next_jump.shown_unit)
    panel.set_ylim(0, None)


def draw_near(panel, report, of="right"):
    """Length of the close stretch on the wheel of one side; conformal shifts are shaded."""
    _head(panel, "near", f"Length of the {of} wheel within {NEAR / MM:g} mm of the rail")
    shift, close = report.curves.lateral_shift / MM, MOVES["near_width"]
    width = close.shown(report.curves, of)
    for zone in report.conformal:
        if zone.side == of:
            panel.axvspan(
                zone.start / MM, zone.stop / MM, color="#F0E442", alpha=0.45, linewidth=0, gid="conformal"
            )
    panel.plot(*_broken(report, shift, width, of), color=INK)
    panel.axhline(WIDE / MM, color=QUIET, linestyle="--", linewidth=0.8)
    panel.text(
        0.01,
        WIDE / MM,
        f"shaded: longer, or bends by\nmore than {TURN / DEGREE:.0f}° (conformal)",
        ha="left",
        va="bottom",
        fontsize=7.5,
        color=QUIET,
        transform=panel.get_yaxis_transform(),
    )
    _shift_axis(panel, close.shown_unit)
    panel.set_ylim(
        0,
        1.25
        * max(
            WIDE / MM,
            np.nanmax(np.where(np.abs(shift) <= SHOWN / MM, width, 0.0), initial=0.0),
        ),
    )


def _broken(report, shift, values, side):
    """The curve, interrupted at each jump of ``side``."""
    at = np.array([jump.lateral_shift / MM for jump in report.jumps if jump.side == side])
    order = np.argsort(np.concatenate([shift, at]), kind="stable")
    return np.concatenate([shift, at])[order], np.concatenate([values, np.full(len(at), np.nan)])[order]


def _mark_jumps(panel, report, sides):
    """Dotted lines at the jumps of ``sides``, in their colours."""
    for side in sides:
        for jump in _shown_jumps(report, side):
            panel.axvline(
                jump.lateral_shift / MM,
                color=SIDE_COLOUR[side],
                linewidth=0.8,
                linestyle=":",
                gid=f"{side} jump",
            )


def _shift_axis(panel, unit, rates=False):
    panel.set(xlim=(-SHOWN / MM, SHOWN / MM), xlabel="lateral shift, right + [mm]", ylabel=unit)
    _scale_to_shown(panel, rates)


def _scale_to_shown(panel, rates):
    """Fit the vertical range of ``panel`` to its curves within the shown shifts; ``rates`` have a logarithmic
    axis that is linear near zero, so that a curve may come to zero inside the panel."""
    shown = [
        np.asarray(line.get_ydata(), dtype=float)[
            np.abs(np.asarray(line.get_xdata(), dtype=float)) <= SHOWN / MM
        ]
        for line in panel.lines
        if len(line.get_xdata()) > 2
    ]
    values = np.concatenate([*shown, [np.nan]])
    values = values[np.isfinite(values)]
    if not len(values) or np.ptp(values) == 0.0:
        return
    low, high = np.min(values), np.max(values)
    if rates:
        usual = max(np.percentile(values[values > 0.0], 5), 1e-3 * high)
        linear, top = 10.0 ** np.floor(np.log10(usual)), 10.0 ** np.ceil(np.log10(high))
        panel.set_yscale("symlog", linthresh=linear, linscale=0.5)
        panel.set_ylim(0.0 if low < linear else linear, top if high < 10.0 * linear else 1.3 * high)
    else:
        panel.set_ylim(low - 0.05 * (high - low), high + 0.05 * (high - low))
