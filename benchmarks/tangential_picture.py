"""Picture of time against error of the models of creep forces, on the cases that are held out: ellipses and
patches of a wheelset.  Quoted methods, whose times are not known, are marks at the right edge."""

import numpy as np

from wrcontact.plots import style
from wrcontact.plots.style import INK, QUIET

from . import store
from .picture import PEER_COLOUR, draw_units
from .tangential import EQUIVALENT, GRIDS, HERTZ, MODELS, NEW_ELLIPSES, NEW_PATCHES, QUOTED

PATH = "docs/img/creep_forces.png"
LOOKS = {  # label, marker, colour (Okabe and Ito)
    "polach": ("Polach's formula", "s", "#E69F00"),
    "fastsim": ("FASTSIM", "o", "#0072B2"),
    "fastrip": ("FaStrip", "^", "#CC79A7"),
    "strips": ("strips", "D", "#009E73"),
}
#: Each panel: the set of ours, that of the quoted methods, and its title.
PANELS = ((NEW_ELLIPSES, HERTZ, "Ellipses"), (NEW_PATCHES, GRIDS, "Patches of a wheelset"))
LOWEST, HIGHEST = 0.1, 100.0    # [%] of the picture
FASTEST, SLOWEST = 1.0, 200.0   # [us]


def stored():
    """Errors and times that are kept in benchmarks/measured."""
    return tuple(store.load(part)["rows"] for part in ("tangential_errors", "tangential_times"))


@style.styled
def figure(errors, times):
    """The picture (a matplotlib Figure) of both parts' rows."""
    picture = style.new_figure(9.4, 4.6)
    panels = picture.subplots(1, 2, sharey=True)
    one = times["strips"]["µs"] / times["strips"]["units"]
    for axes, (ours, theirs, title) in zip(panels, PANELS):
        axes.set(xscale="log", yscale="log", xlim=(FASTEST, SLOWEST), ylim=(LOWEST, HIGHEST),
                 xlabel="creep forces of one patch [µs]")
        axes.set_title(title, pad=8)
        axes.grid(which="major", color="#E4E4E4", linewidth=0.7)
        axes.set_axisbelow(True)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(lambda value, _: f"{value:g}")
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
        axes.plot(SLOWEST, error, "<", color=PEER_COLOUR, clip_on=False)
        lowest = max(1.19 * lowest, error)
        axes.annotate(name, (SLOWEST, lowest), (-8, 0), textcoords="offset points", fontsize=7.5, color=INK,
                      ha="right", va="center")


def draw_limit(axes, errors):
    """What no model that knows an ellipse only can do better."""
    error = errors[EQUIVALENT][NEW_PATCHES]["force"][0]
    axes.axhline(error, color=QUIET, linewidth=0.9, linestyle="--")
    axes.annotate(EQUIVALENT, (FASTEST, error), (4, 3), textcoords="offset points", fontsize=7.5,
                  color=QUIET)


def points(axes):
    """Places (n, 2) of the models' and the quoted methods' marks, for tests."""
    return np.concatenate([line.get_xydata() for line in axes.lines if line.get_marker() != "None"])
