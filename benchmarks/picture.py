"""Picture of run time against error: one point per row; quoted programs as bars from shortest to longest
time."""

from typing import NamedTuple

import numpy as np

from wrcontact.plots import style
from wrcontact.plots.style import INK, QUIET

from . import rows as all_of
from . import store
from .peers import PEERS
from .rows import SWEEPS

PATH = "docs/img/benchmark.png"

LADDERS = {  # kind of row: label, marker, colour (Okabe and Ito)
    "Hertz": ("Hertz", "s", "#E69F00"),
    "analyn": ("ANALYN, by tolerance", "o", "#0072B2"),
    "FMU": ("FMU step with ANALYN", "p", "#D55E00"),
    "analyn_strip": ("ANALYN with strips, by tolerance", "D", "#009E73"),
    "halfspace": ("half-space in Python, by tolerance", "^", "#CC79A7"),
}
STRIP_COLOUR, PEER_COLOUR = "#56B4E9", "#6E6E6E"
LOWEST, HIGHEST = 0.05, 30.0  # [%] of the picture
FASTEST, SLOWEST = 1.0, 3e6  # [us]


class Point(NamedTuple):
    """A row of the table of models: its kind and label, time [us] and in units, and error [%], the mean of
    penetration, area and peak pressure."""

    kind: str
    setting: str
    microseconds: float
    units: float
    error: float


def stored_points():
    """The points of what is kept in benchmarks/measured."""
    times, errors, halfspace = (store.load(part)["rows"] for part in ("model_times", "model_errors",
                                                                      "halfspace"))
    known = {**errors, **halfspace}
    labels = {row.name: (row.kind, row.setting) for row in all_of.all_rows(all_of.FULL)}
    labels[all_of.FMU_ROW] = "FMU", ""
    return [point(*label, times[name], known.get(name) or known[all_of.DEFAULT_ROW])
            for name, label in labels.items() if label[0] != "geometry"]


def point(kind, setting, time, errors):
    """The :class:`Point` of a row's kept time and errors."""
    return Point(kind, setting, time["µs"], time["units"], float(np.mean(errors["positions mean"])))


@style.styled
def figure(rows):
    """The picture (a matplotlib Figure) of ``rows``, each a :class:`Point`."""
    picture = style.new_figure(8.6, 5.4)
    axes = picture.subplots()
    axes.set(xscale="log", yscale="log", xlim=(FASTEST, SLOWEST), ylim=(LOWEST, HIGHEST),
             xlabel="one wheelset, both patches [µs]",
             ylabel="error on 20 positions from tread to flange [%]\nmean of penetration, area and peak "
             "pressure")
    axes.grid(which="major", color="#E4E4E4", linewidth=0.7)
    axes.set_axisbelow(True)
    for axis, form in ((axes.xaxis, ",.0f"), (axes.yaxis, "g")):
        axis.set_major_formatter(lambda value, _, form=form: format(value, form))
    draw_units(axes, rows[0].microseconds / rows[0].units)
    draw_strips(axes, [row for row in rows if row.kind == "strips"])
    for kind in LADDERS:
        draw_ladder(axes, kind,
                    [row for row in rows if row.kind == kind and (row.setting or kind in ("Hertz", "FMU"))])
    draw_peers(axes)
    axes.legend(loc="center", bbox_to_anchor=(0.52, 0.6), title="measured in this run", alignment="left")
    return picture


def draw_units(axes, one):
    """A second axis on top, in units of ``one`` [us]."""
    top = axes.secondary_xaxis("top", functions=(lambda us: us / one, lambda units: units * one))
    top.set_xlabel("in units: np.sqrt of 2000 doubles, same machine")
    top.xaxis.set_major_formatter(lambda value, _: f"{value:,g}" if value < 1 else f"{value:,.0f}")
    top.spines["top"].set_visible(True)


def draw_strips(axes, rows):
    """A line for each number of sweeps, with one point per number of strips."""
    for sweeps in SWEEPS:
        chosen = [row for row in rows if row.setting == f"× {sweeps}"]
        axes.plot(*places(chosen), ".-", color=STRIP_COLOUR, linewidth=0.8,
                  label="ANALYN with 16 … 64 strips × sweeps" if sweeps == SWEEPS[0] else None)
        annotate(axes, chosen[-1], STRIP_COLOUR, (6, -3), "left")


def draw_ladder(axes, kind, rows):
    """The rows of one kind as a line; the first and the last tolerance are printed beside it."""
    label, marker, colour = LADDERS[kind]
    axes.plot(*places(rows), marker=marker, linewidth=1, color=colour, label=label, linestyle="-"
              if len(rows) > 1 else "none")
    if len(rows) > 1:
        annotate(axes, rows[0], colour, (-6, -9) if kind == "analyn_strip" else (-5, 5), "right")
        annotate(axes, rows[-1], colour, (6, -9), "left")


def places(rows):
    """Time [us] and error [%] of rows."""
    return np.array([(row.microseconds, row.error) for row in rows]).T


def annotate(axes, row, colour, offset, side):
    axes.annotate(row.setting, places([row]).ravel(), offset, textcoords="offset points", fontsize=7.5,
                  color=colour, ha=side)


def draw_peers(axes):
    """Quoted programs as bars; one without error lies on the lower edge, one without time is a mark at the
    right edge."""
    for peer in PEERS:
        error = max(100 * float(np.mean(peer.mean)), LOWEST * 1.07)
        if peer.milliseconds is None:
            axes.plot(SLOWEST, error, "<", color=PEER_COLOUR, clip_on=False)
            axes.annotate(f"{peer.name}\n(time not reported)", (SLOWEST, error), (-10, 0),
                          textcoords="offset points", fontsize=8, color=INK, ha="right", va="center")
            continue
        axes.plot(peer.microseconds, (error, error), color=PEER_COLOUR, linewidth=5, solid_capstyle="butt")
        note = ", error 0 by definition" if not peer.mean.any() else ""
        axes.annotate(f"{peer.name}{note}", (peer.microseconds[0], error), (0, 6), textcoords="offset points",
                      fontsize=8, color=INK)
    axes.text(0.01, 0.02, "grey: CONTACT v25.2, quoted, on another machine", transform=axes.transAxes,
              fontsize=8, color=QUIET)
