"""The figures of the degree project as pictures, each drawn only from its table, which is also written as
CSV.

Lines are exact, dots are the source's searches, broken lines are elastic contact or the complete theory.
"""

from functools import partial

import numpy as np

from ..plots.patch import finer
from ..plots.pose import HIGH
from ..plots.style import (
    CONTACT_COLOUR,
    INK,
    MM,
    QUIET,
    RAIL_COLOUR,
    RAIL_LABEL,
    WHEEL_COLOUR,
    ZONE_COLOUR,
    new_figure,
    styled,
)
from ..plots.sweep import WHEEL_ZONES

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")  # of cases side by side, after Okabe and Ito
JUMP = 3.0  # [mm] a line is interrupted where its value jumps by more between two points
THEORY = {"color": INK, "linewidth": 1.1, "linestyle": (0, (4, 2))}
UPRIGHT = 2.5  # patches longer than so many widths are not drawn to one scale


@styled
def source_figure(figure):
    """The picture of a :class:`~wrcontact.study.figure.SourceFigure`."""
    draw, size = DRAWN[figure.number]
    picture = new_figure(*size)
    picture.suptitle(f"{figure.number}  {figure.title}", x=0.01, ha="left")
    draw(picture, figure)
    return picture


# --- values over the lateral shift, chapters 4 and 5 -----------------------------------------------


def look_of(name):
    """How a curve over the lateral shift is drawn."""
    yaw = int(name.rpartition("yaw ")[2].split()[0]) if "yaw" in name else None
    colour = COLOURS[yaw] if yaw is not None else WHEEL_COLOUR
    if "search" in name:
        return {
            "linestyle": "",
            "marker": "o" if "dy 1 mm" not in name else "x",
            "markersize": 3.2,
            "zorder": 1.5,
            "color": colour if yaw is not None else QUIET,
            "alpha": 0.7,
        }
    if "elastic" in name:
        return {
            "color": colour if yaw is not None else CONTACT_COLOUR,
            "linestyle": (0, (4, 1.5)),
            "linewidth": 1.4,
        }
    return {"color": colour, "linewidth": 1.5}


def lateral_curves(panel, figure, wanted, *, span=None, legend=True):
    """The curves whose names ``wanted`` accepts over the lateral shift."""
    value = list(figure.columns)[2]
    for name in filter(wanted, figure.curves):
        shift, values = figure.curve(name, "lateral shift [mm]", value)
        jump = np.flatnonzero(np.abs(np.diff(values)) > JUMP) + 1
        panel.plot(
            np.insert(shift, jump, np.nan), np.insert(values, jump, np.nan), label=name, **look_of(name)
        )
    panel.set(xlabel="lateral shift of the wheelset, right + [mm]", ylabel=AXES[value])
    if span:
        seen = [
            line.get_ydata()[(line.get_xdata() >= span[0]) & (line.get_xdata() <= span[1])]
            for line in panel.lines
        ]
        low, high = (of(np.concatenate(seen)) for of in (np.nanmin, np.nanmax))
        panel.set(xlim=span, ylim=(low - 0.04 * (high - low), high + 0.04 * (high - low)))
    if legend:
        panel.legend()


AXES = {
    "roll [deg]": "roll, right wheel down + [deg]",
    "y_wheel [mm]": "contact on the wheel, field side + [mm]",
    "x_wheel [mm]": "contact ahead of the axle [mm]",
}


def every(name):
    return True


def exact(name):
    return "exact" in name


def draw_inset(panel, figure, bounds, span, title="", wanted=every):
    """A smaller panel inside another one, with a part of the curves over ``span`` [mm]; it is returned."""
    inset = panel.inset_axes(bounds)
    lateral_curves(inset, figure, wanted, span=span, legend=False)
    inset.set(xlabel="", ylabel="")
    inset.set_title(title, fontsize=8, fontweight="normal")
    inset.tick_params(labelsize=7)
    return inset


def draw_panel(panel, figure, title, *, wanted=every, zones=False, marked="", **look):
    """Curves over the lateral shift, with the zones of the wheel or not, and with lines at the figure's numbers
    that begin with the word ``marked``; the rest is that of :func:`lateral_curves`."""
    lateral_curves(panel, figure, wanted, **look)
    if zones:
        draw_zones(panel)
    names = (name for name in figure.numbers if name.endswith("at [mm]"))
    mark_jumps(panel, [figure.numbers[name] for name in names if marked and name.startswith(marked)])
    panel.set_title(title)


def draw_panels(picture, figure, *rows, **grid):
    """A panel for each row of arguments of :func:`draw_panel`, beside each other."""
    panels = picture.subplots(1, len(rows), **grid)
    for panel, row in zip(panels, rows):
        draw_panel(panel, figure, **row)
    return panels


def mark_jumps(panel, shifts):
    """Dotted lines at lateral shifts [mm] with their numbers."""
    low, high = panel.get_xlim()
    for shift in shifts:
        if low < shift < high:
            panel.axvline(shift, color=QUIET, linewidth=0.8, linestyle=":")
            panel.annotate(
                f"{shift:.3f}",
                (shift, 0.02),
                (-3, 0),
                xycoords=("data", "axes fraction"),
                textcoords="offset points",
                rotation=90,
                ha="right",
                va="bottom",
                fontsize=8,
                color=QUIET,
            )


def draw_zones(panel):
    """Bands of tread, flange root and flange of the S1002, within what the panel shows."""
    low, high = panel.get_ylim()
    for name, (start, stop) in WHEEL_ZONES.items():
        start, stop = max(start / MM, low), min(stop / MM, high)
        if stop > start:
            panel.axhspan(start, stop, color=ZONE_COLOUR[name], linewidth=0, zorder=0)
            panel.text(
                0.99,
                stop - 0.01 * (high - low),
                name,
                color=QUIET,
                style="italic",
                ha="right",
                va="top",
                transform=panel.get_yaxis_transform(),
            )
    panel.set_ylim(low, high)


def draw_place_and_errors(picture, figure):
    whole, errors = picture.subplots(1, 2, width_ratios=(1.3, 1))
    lateral_curves(whole, figure, lambda name: "dy 1 mm" not in name)
    draw_zones(whole)
    known = dict(zip(*figure.curve("rigid, exact", "lateral shift [mm]", "y_wheel [mm]")))
    for name in figure.curves:
        if name != "rigid, exact":
            shift, place = figure.curve(name, "lateral shift [mm]", "y_wheel [mm]")
            error = np.abs(place - [known[at] for at in shift])
            errors.plot(shift, np.maximum(error, 1e-9), label=name, **look_of(name))
    errors.axvspan(6.3, 8, color=ZONE_COLOUR["flange"], linewidth=0, zorder=0)
    errors.axvspan(-8, -6.3, color=ZONE_COLOUR["flange"], linewidth=0, zorder=0)
    errors.set(
        yscale="log",
        ylim=(1e-9, 30),
        xlabel="lateral shift of the wheelset, right + [mm]",
        ylabel="distance from the rigid contact [mm]",
    )
    errors.legend(loc="lower left", fontsize=7)
    whole.set_title("Contact on the right wheel")
    errors.set_title("Distance from it; grey: beyond 6.3 mm")


def draw_two_searches(picture, figure):
    rows = (
        {"title": "Rigid contact", "wanted": lambda name: "elastic" not in name},
        {"title": "Elastic contact at 78.5 kN", "wanted": lambda name: "elastic" in name},
    )
    panels = draw_panels(
        picture, figure, *(row | {"span": (0, 8), "legend": False} for row in rows), sharey=True
    )
    for panel, row in zip(panels, rows):
        inset = draw_inset(panel, figure, (0.14, 0.14, 0.5, 0.5), (4.4, 5.6), wanted=row["wanted"])
        panel.indicate_inset_zoom(inset, edgecolor=QUIET)
    handles = {line.get_label(): line for panel in picture.axes for line in panel.lines}
    picture.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=3)


def draw_by_yaw(picture, figure, loc, ylim=None, **inset):
    """Exact lines and the source's dots for each yaw, with an ``inset`` of :func:`draw_inset`."""
    panel = picture.subplots()
    for wanted in (exact, lambda name: "search" in name):
        lateral_curves(panel, figure, wanted, legend=False)
    lines = [line for line in panel.lines if exact(line.get_label())]
    dots = next(line for line in panel.lines if "search" in line.get_label())
    names = [*(line.get_label() for line in lines), "source's 3-D search, dx 0.1 mm"]
    panel.legend([*lines, dots], names, loc=loc)
    panel.set_xlim(0, 8)
    draw_inset(panel, figure, **inset).set_ylim(ylim)


# --- where the contact is --------------------------------------------------------------------------


def draw_picture(picture, figure):
    draw_outlines(picture.subplots(), figure)


def draw_outlines(panel, figure):
    """Wheel, rail and contact point on the track, to one scale."""
    ends = {"wheel": HIGH / MM, "rail": -60.0}
    for name, colour in (("wheel", WHEEL_COLOUR), ("rail", RAIL_COLOUR)):
        y, height = figure.curve(name, "y_track [mm]", "height [mm]")
        panel.fill_between(y, height, ends[name], color=colour, alpha=0.18, linewidth=0)
        panel.plot(y, height, color=colour)
    (y,), (height,) = figure.curve("contact point", "y_track [mm]", "height [mm]")
    panel.plot(
        [y], [height], "*", color=CONTACT_COLOUR, markersize=12, markeredgecolor="white", markeredgewidth=0.6
    )
    panel.annotate(
        "contact point",
        (y, height),
        (30, -34),
        textcoords="offset points",
        ha="left",
        color=CONTACT_COLOUR,
        arrowprops={"arrowstyle": "-", "color": CONTACT_COLOUR, "linewidth": 0.8},
    )
    panel.text(768, -12, "rail", color=RAIL_LABEL, ha="center")
    panel.text(768, 11, "wheel", color=WHEEL_COLOUR, ha="center")
    panel.set(
        xlim=(685, 805),
        ylim=(-32, 16),
        aspect="equal",
        xlabel="across the track, right + [mm]",
        ylabel="above top of rail [mm]",
    )


# --- separations -----------------------------------------------------------------------------------


def draw_separation(picture, figure):
    whole, near, patch = picture.subplots(1, 3, width_ratios=(1.2, 1, 1.1))
    for name, colour, look in (("equidistant", COLOURS[0], "-"), ("vertical", COLOURS[1], (0, (3, 1.5)))):
        y, apart, half = figure.curve(name, "y [mm]", "separation [mm]", "half length [mm]")
        whole.plot(y, apart, color=colour, linestyle=look, label=name)
        closed_outline(patch, y, half, color=colour, linestyle=look, label=name)
    cosine = np.cos(np.radians(figure.numbers.get("contact angle [deg]", 0.0)))
    station, half = figure.curve("complete theory", "station [mm]", "half length [mm]")
    closed_outline(patch, station * cosine, half, fine=True, label="complete theory", **THEORY)
    y, apart = figure.curve("vertical less equidistant", "y [mm]", "separation [mm]")
    near.plot(y, np.abs(apart), color=INK)
    near.axhspan(1e-4, 1e-3, color=ZONE_COLOUR["flange root"], linewidth=0, zorder=0)
    near.text(
        0.5,
        1.2e-3,
        "source: 1e-4 ... 1e-3",
        transform=near.get_yaxis_transform(),
        color=QUIET,
        fontsize=7.5,
        ha="center",
        va="bottom",
    )
    near.set(
        yscale="log",
        ylim=(1e-7, 1e-1),
        xlabel="y from the contact, field side + [mm]",
        ylabel="vertical less equidistant [mm]",
    )
    whole.set(ylim=(-0.3, 8), xlabel="y from the contact, field side + [mm]", ylabel="separation [mm]")
    patch.set(xlabel="y from the contact, field side + [mm]", ylabel="rolling direction [mm]")
    to_scale(patch)
    patch.plot([0], [0], "*", color=CONTACT_COLOUR, markersize=7)
    for panel, title in (
        (whole, "Separation"),
        (near, "Their difference inside the patch"),
        (patch, "Patch"),
    ):
        panel.set_title(title)
    whole.legend(loc="upper center")
    patch.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=3, handlelength=1.6, columnspacing=1)


def closed_outline(panel, station, half_length, *, fine=False, label=None, **look):
    """The edge of a patch over its stations [mm]; ``fine`` draws stored stations as the round curve they
    stand for."""
    if fine:
        station, half_length = finer(station, half_length)
    loaded = half_length > 0
    beside = loaded | np.roll(loaded, 1) | np.roll(loaded, -1)
    edge = np.where(beside, half_length, np.nan)
    panel.plot(
        np.concatenate([station, [np.nan], station]),
        np.concatenate([edge, [np.nan], -edge]),
        label=label,
        **look,
    )


def to_scale(panel):
    """One scale for both directions unless the patch is long and thin; then the label says so."""
    low, high = panel.get_xlim()
    bottom, top = panel.get_ylim()
    if top - bottom < UPRIGHT * (high - low):
        panel.set_aspect("equal", adjustable="datalim")
    else:
        panel.set_xlabel(panel.get_xlabel() + ", stretched")


# --- longitudinal curvature ------------------------------------------------------------------------


def draw_longitudinal(picture, figure):
    _curvature_panels(*picture.subplots(1, 2), figure)


def draw_longitudinal_with_picture(picture, figure):
    upper, lower = picture.subfigures(2, 1, height_ratios=(1, 1))
    draw_outlines(upper.subplots(), figure)
    _curvature_panels(*lower.subplots(1, 2), figure)


def _curvature_panels(whole, near, figure):
    y, effective, basic = (
        np.array(figure.columns[name], dtype=float)
        for name in ("y_wheel [mm]", "effective 2A [1/m]", "basic 2A [1/m]")
    )
    patch = [figure.numbers[f"patch {end} y_wheel [mm]"] for end in ("from", "to")]
    at, margin = figure.numbers["y_wheel [mm]"], max(0.5, 0.25 * (patch[1] - patch[0]))
    for panel in (whole, near):
        panel.axvspan(*patch, color=ZONE_COLOUR["flange root"], linewidth=0, zorder=0)
        panel.plot(y, effective, color=COLOURS[0], label="effective, cos(contact angle) / R")
        panel.plot(y, basic, color=COLOURS[1], linestyle=(0, (4, 1.5)), label="basic, 1 / R")
        panel.axvline(at, color=QUIET, linewidth=0.8, linestyle=":")
        panel.set(xlabel="on the wheel's profile, field side + [mm]", ylabel="longitudinal curvature [1/m]")
    near.set_xlim(patch[0] - margin, patch[1] + margin)
    inside = (y > patch[0] - margin) & (y < patch[1] + margin)
    values = np.concatenate([effective[inside], basic[inside]])
    room = 0.15 * np.ptp(values) + 0.002
    near.set_ylim(values.min() - room, values.max() + room)
    whole.legend(loc="lower right")
    whole.set_title("Along the wheel; grey: the patch, dotted: the contact point")
    near.set_title("Across the patch")


# --- patches ---------------------------------------------------------------------------------------


def draw_patches(picture, figure):
    """Edges of several patches over each other, and their pressures."""
    edges, pressures = picture.subplots(1, 2)
    own = [name for name in figure.curves if "complete theory" not in name]
    for name in figure.curves:
        station, half, pressure = figure.curve(name, "station [mm]", "half length [mm]", "pressure [MPa]")
        theory = "complete theory" in name
        case = next((k for k, other in enumerate(own) if name.startswith(other)), None)
        look = {**(THEORY if theory else {}), "color": INK if case is None else COLOURS[case]}
        if name == "basic":
            look["linestyle"] = (0, (3, 1.5))
        closed_outline(edges, station, half, fine=True, label=name, **look)
        pressures.plot(*finer(station, pressure), **look)
    for panel in (edges, pressures):
        panel.set_xlabel("s in the contact plane, field side + [mm]")
    edges.set_ylabel("rolling direction [mm]")
    pressures.set_ylabel("pressure on x = 0 [MPa]")
    pressures.set_ylim(bottom=0)
    edges.plot([0], [0], "*", color=CONTACT_COLOUR, markersize=7)
    to_scale(edges)
    edges.set_title("Edges of the patches, from the rigid contact point")
    pressures.set_title("Pressure across")
    picture.legend(*edges.get_legend_handles_labels(), loc="outside lower center", ncols=3)


def draw_torn(picture, figure):
    """Loaded nodes as strips, one panel for each way to take the lateral curvature, before the complete
    theory's patch."""
    names = [name for name in figure.curves if name != "complete theory"]
    true = figure.curve("complete theory", "station [mm]", "half length [mm]")
    panels = picture.subplots(1, 3, sharex=True, sharey=True)
    for panel, name, colour in zip(panels, names, COLOURS):
        station, half = figure.curve(name, "station [mm]", "half length [mm]")
        loaded = half > 0
        panel.bar(
            station[loaded],
            2 * half[loaded],
            bottom=-half[loaded],
            width=0.2,
            color=colour,
            alpha=0.55,
            linewidth=0,
            label=f"{int(loaded.sum())} loaded nodes",
        )
        closed_outline(panel, *true, fine=True, label="complete theory", **THEORY)
        inside = loaded[np.argmin(np.abs(station))]
        panel.plot(
            [0],
            [0],
            "*",
            color=INK if inside else CONTACT_COLOUR,
            markersize=9,
            markeredgecolor="white",
            markeredgewidth=0.5,
            label=f"first contact point, {'in' if inside else 'not in'} the patch",
            linestyle="",
        )
        panel.set(xlabel="s from the contact, field side + [mm]", ylim=(-10.5, 10.5))
        panel.set_title(name[0].upper() + name[1:])
        panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=1)
    panels[0].set_ylabel("rolling direction [mm]")


def draw_lateral(picture, figure):
    """Lateral curvature of wheel and rail; rounding noise would fill the picture, so its points are small."""
    titles = {
        "wheel": "Wheel, + where it is hollow as in the flange root",
        "rail": "Rail, + where it bulges as its head does; B is half of rail less wheel",
    }
    for panel, name in zip(picture.subplots(2, 1), titles):
        at = np.array(figure.columns[f"y_{name} [mm]"])
        for kind, look in LATERAL.items():
            panel.plot(at, figure.columns[f"{name}, {kind} [1/m]"], **look)
        panel.set(
            ylim=(-45, 110),
            xlim=(at.min(), at.max()),
            ylabel="curvature [1/m]",
            xlabel=f"on the {name}'s profile, field side + [mm]",
        )
        panel.set_title(titles[name])
    picture.legend(*panel.get_legend_handles_labels(), loc="outside lower center", ncols=3)


#: How each lateral curvature is drawn; later ones lie over earlier ones.
LATERAL = {
    "rough, coordinates to 1 um": {
        "linestyle": "",
        "marker": ".",
        "markersize": 2.5,
        "color": COLOURS[1],
        "alpha": 0.8,
        "label": "three nodes, coordinates to 1 um",
    },
    "rough": {"color": COLOURS[0], "label": "three nodes 0.2 mm apart, exact profile"},
    "smooth": {"color": INK, "linestyle": (0, (4, 1.5)), "linewidth": 1.2, "label": "circle through 6 mm"},
}

ROLL = (
    {"title": "Whole range"},
    {
        "title": "Around the two jumps of the contact: the roll bends there",
        "span": (4.3, 6.6),
        "legend": False,
        "marked": "bend",
    },
)
PLACE = (
    {"title": "Whole range", "zones": True},
    {
        "title": "Flange root and flange",
        "span": (4.3, 8.0),
        "legend": False,
        "zones": True,
        "marked": "jump",
    },
)
ROLL_INSET = {"bounds": (0.14, 0.32, 0.38, 0.5), "span": (0, 5.3), "title": "tread and flange root"}
SHIFT_INSET = {"bounds": (0.27, 0.3, 0.36, 0.62), "span": (0, 6.3), "title": "before flange contact"}
WIDE, HIGHER, OUTLINES = (10.5, 4.2), (10.5, 4.8), (7.5, 3.9)  # [in]
#: What draws each figure, and the size of its picture [in].
DRAWN = {
    "4.4": (lambda *on: draw_panels(*on, *ROLL), WIDE),
    "4.5": (lambda *on: draw_panels(*on, *PLACE, width_ratios=(1.5, 1)), WIDE),
    "4.6": (draw_place_and_errors, WIDE),
    "5.6": (draw_two_searches, (10.5, 5.2)),
    "5.7": (draw_picture, OUTLINES),
    "5.8": (partial(draw_by_yaw, loc="lower left", wanted=exact, **ROLL_INSET), (10.5, 5.4)),
    "5.9": (partial(draw_by_yaw, loc="upper left", ylim=(-0.5, 11), **SHIFT_INSET), WIDE),
    "7.1": (draw_picture, OUTLINES),
    "7.2": (draw_separation, HIGHER),
    "7.3": (draw_picture, OUTLINES),
    "7.4": (draw_separation, HIGHER),
    "7.5": (draw_longitudinal, WIDE),
    "7.6": (draw_patches, HIGHER),
    "7.7": (draw_longitudinal, WIDE),
    "7.8": (draw_patches, HIGHER),
    "7.9": (draw_longitudinal_with_picture, (10.5, 7.4)),
    "7.10": (draw_patches, HIGHER),
    "7.11": (draw_lateral, (10.5, 6.6)),
    **dict.fromkeys(("7.12", "7.13", "7.14"), (draw_torn, HIGHER)),
    **dict.fromkeys(("7.15", "7.16", "7.17"), (draw_patches, HIGHER)),
}
