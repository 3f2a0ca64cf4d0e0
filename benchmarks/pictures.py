"""Pictures of time against error.

One is of the models, with quoted programs as bars from shortest to longest time; one is of the models of
creep forces, on the cases that are held out, with quoted methods, whose times are not known, as marks at the
right edge.
"""

from typing import NamedTuple

import numpy as np

from wrcontact.plots import style
from wrcontact.plots.style import INK, QUIET

from . import rows as all_of
from . import store
from .creep import EQUIVALENT, GRIDS, HERTZ, MODELS, NEW_ELLIPSES, NEW_PATCHES, QUOTED
from .rows import SWEEPS
from .tables import PEERS

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
    open_axes(axes, (FASTEST, SLOWEST), (LOWEST, HIGHEST), "one wheelset, both patches [µs]", ",.0f")
    axes.set_ylabel("error on 20 positions from tread to flange [%]\nmean of penetration, area and peak "
                    "pressure")
    draw_units(axes, rows[0].microseconds / rows[0].units)
    draw_strips(axes, [row for row in rows if row.kind == "strips"])
    for kind in LADDERS:
        draw_ladder(axes, kind,
                    [row for row in rows if row.kind == kind and (row.setting or kind in ("Hertz", "FMU"))])
    draw_peers(axes)
    axes.legend(loc="center", bbox_to_anchor=(0.52, 0.6), title="measured in this run", alignment="left")
    return picture


def open_axes(axes, times, errors, words, form="g"):
    """Logarithmic axes over these ranges of times [us], whose numbers have this ``form``, and errors [%]."""
    axes.set(xscale="log", yscale="log", xlim=times, ylim=errors, xlabel=words)
    axes.grid(which="major", color="#E4E4E4", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_formatter(lambda value, _: format(value, form))
    axes.yaxis.set_major_formatter(lambda value, _: format(value, "g"))


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


# ----------------------------------------------------------------------------------------------- creep forces


CREEP_PATH = "docs/img/creep_forces.png"
LOOKS = {  # label, marker, colour (Okabe and Ito)
    "polach": ("Polach's formula", "s", "#E69F00"),
    "fastsim": ("FASTSIM", "o", "#0072B2"),
    "fastrip": ("FaStrip", "^", "#CC79A7"),
    "strips": ("strips", "D", "#009E73"),
}
#: Each panel: the set of ours, that of the quoted methods, and its title.
PANELS = ((NEW_ELLIPSES, HERTZ, "Ellipses"), (NEW_PATCHES, GRIDS, "Patches of a wheelset"))
CREEP_LOWEST, CREEP_HIGHEST = 0.1, 100.0    # [%] of the picture
CREEP_FASTEST, CREEP_SLOWEST = 1.0, 200.0   # [us]


def stored_creep():
    """Errors and times that are kept in benchmarks/measured."""
    return tuple(store.load(part)["rows"] for part in ("tangential_errors", "tangential_times"))


@style.styled
def creep_figure(errors, times):
    """The picture (a matplotlib Figure) of both parts' rows."""
    picture = style.new_figure(9.4, 4.6)
    panels = picture.subplots(1, 2, sharey=True)
    one = times["strips"]["µs"] / times["strips"]["units"]
    for axes, (ours, theirs, title) in zip(panels, PANELS):
        open_axes(axes, (CREEP_FASTEST, CREEP_SLOWEST), (CREEP_LOWEST, CREEP_HIGHEST),
                  "creep forces of one patch [µs]")
        axes.set_title(title, pad=8)
        draw_units(axes, one)
        draw_models(axes, errors, times, ours)
        draw_quoted(axes, errors, theirs)
    panels[0].set_ylabel("error of the force on new cases [% of μN]\nmean, and bar to 95 of 100 cases")
    draw_limit(panels[1], errors)
    panels[0].legend(loc="lower left", title="measured in this run", alignment="left")
    picture.supxlabel("hollow: spin as published; grey: CONTACT v25.2, quoted, on its own cases, time not "
                      "reported", fontsize=8, color=QUIET)
    return picture


def draw_models(axes, errors, times, chosen):
    """A point for each model, hollow where spin is as published, with a bar up to 95 of 100 cases."""
    for name, (model, published) in MODELS.items():
        label, marker, colour = LOOKS[model]
        mean, most, _ = errors[name][chosen]["force"]
        time = times[model]["µs"] * (1.06 if published else 1.0)       # beside each other
        axes.plot([time, time], [mean, most], color=colour, linewidth=0.8)
        axes.plot(time, mean, marker, color=colour, linestyle="none", label=None if published else label,
                  markerfacecolor="white" if published else colour, zorder=3)


def draw_quoted(axes, errors, chosen):
    """Marks at the right edge; labels keep apart from each other."""
    found = sorted((errors[name][chosen]["force"][0], name) for name in QUOTED if chosen in errors[name])
    lowest = 0.0
    for error, name in found:
        axes.plot(CREEP_SLOWEST, error, "<", color=PEER_COLOUR, clip_on=False)
        lowest = max(1.19 * lowest, error)
        axes.annotate(name, (CREEP_SLOWEST, lowest), (-8, 0), textcoords="offset points", fontsize=7.5,
                      color=INK, ha="right", va="center")


def draw_limit(axes, errors):
    """What no model that knows an ellipse only can do better."""
    error = errors[EQUIVALENT][NEW_PATCHES]["force"][0]
    axes.axhline(error, color=QUIET, linewidth=0.9, linestyle="--")
    axes.annotate(EQUIVALENT, (CREEP_FASTEST, error), (4, 3), textcoords="offset points", fontsize=7.5,
                  color=QUIET)


def marks(axes):
    """Places (n, 2) of the models' and the quoted methods' marks, for tests."""
    return np.concatenate([line.get_xydata() for line in axes.lines if line.get_marker() != "None"])
