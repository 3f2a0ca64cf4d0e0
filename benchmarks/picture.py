"""Run time against error, one point for each row; quoted programs as bars from their shortest to their longest time."""

import numpy as np

from wrcontact.plots import style
from wrcontact.plots.style import INK, QUIET

from .machine import unit
from .peers import PEERS
from .rows import mean_error

KINDS = {  # kind of row: label, marker, colour (Okabe and Ito)
    "Hertz": ("Hertz", "s", "#E69F00"),
    "analyn": ("ANALYN, by tolerance", "o", "#0072B2"),
    "strips": ("ANALYN with strips, strips × sweeps", ".", "#56B4E9"),
    "analyn_strip": ("ANALYN with strips, by tolerance", "D", "#009E73"),
    "halfspace": ("half-space in Python, by tolerance", "^", "#CC79A7"),
}
PEER_COLOUR = "#6E6E6E"
LOWEST, HIGHEST = 0.1, 15.0  # [%] of the picture
FASTEST, SLOWEST = 3.0, 2e6  # [us]


@style.styled
def figure(rows):
    """The picture of measured rows."""
    picture = style.new_figure(8.6, 5.4)
    axes = picture.subplots()
    axes.set(xscale="log", yscale="log", xlim=(FASTEST, SLOWEST), ylim=(LOWEST, HIGHEST),
             xlabel="one wheelset, both patches [µs]",
             ylabel="error on 20 positions from tread to flange [%]\nmean of penetration, area and peak pressure")
    axes.grid(which="major", color="#E4E4E4", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    draw_units(axes)
    draw_rows(axes, rows)
    draw_peers(axes)
    axes.legend(loc="upper right", title="measured in this run", alignment="left")
    return picture


def draw_units(axes):
    """A second axis on top, in units."""
    seconds = 1e6 * unit()
    top = axes.secondary_xaxis("top", functions=(lambda us: us / seconds, lambda units: units * seconds))
    top.set_xlabel("in units: np.sqrt of 2000 doubles, same machine")
    top.spines["top"].set_visible(True)


def draw_rows(axes, rows):
    for kind, (label, marker, colour) in KINDS.items():
        chosen = [row for row in rows if row.kind == kind and (row.setting or kind == "Hertz")]
        time = np.array([row.cost.microseconds for row in chosen])
        error = np.array([100 * mean_error(row.positions) for row in chosen])
        lines = "-" if kind in ("analyn", "analyn_strip", "halfspace") else "none"
        axes.plot(time, error, marker=marker, linestyle=lines, linewidth=1, color=colour, label=label,
                  zorder=2 if kind == "strips" else 3)
        if kind in ("analyn", "analyn_strip", "halfspace"):
            ends = {0: (-4, 6, "right"), len(chosen) - 1: (6, -3, "left")}
            for place, (right, up, side) in ends.items():
                axes.annotate(chosen[place].setting, (time[place], error[place]), (right, up), textcoords="offset points",
                              fontsize=7.5, color=colour, ha=side)


def draw_peers(axes):
    """Bars; the one without error stands on the lower edge, the one without a time is a mark on its error's axis."""
    for peer in PEERS:
        error = max(100 * float(np.mean(peer.mean)), LOWEST * 1.06)
        if peer.milliseconds is None:
            axes.plot(SLOWEST, error, "<", color=PEER_COLOUR, clip_on=False)
            axes.annotate(f"{peer.name} (error only)", (SLOWEST, error), (-10, 0), textcoords="offset points", fontsize=8,
                          color=QUIET, ha="right", va="center")
            continue
        axes.plot(peer.microseconds, (error, error), color=PEER_COLOUR, linewidth=5, alpha=0.75)
        note = ", error 0 by definition" if not peer.mean.any() else ""
        axes.annotate(f"{peer.name}{note}", (peer.microseconds[0], error), (0, 6), textcoords="offset points", fontsize=8,
                      color=INK)
    axes.text(0.01, 0.015, "grey: CONTACT v25.2, quoted, another machine", transform=axes.transAxes, fontsize=8, color=QUIET)
