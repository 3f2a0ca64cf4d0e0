"""Figures of the degree project that show values over the lateral shift, from their tables."""

import numpy as np

from ..plots.style import CONTACT_COLOUR, MM, QUIET, WHEEL_COLOUR, ZONE_COLOUR
from ..plots.sweep import WHEEL_ZONES

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")  # of cases side by side, after Okabe and Ito
JUMP = 3.0  # [mm] a line is interrupted where its value jumps by more between two points


def look_of(name):
    """How a curve over the lateral shift is drawn."""
    yaw = int(name.rpartition("yaw ")[2].split()[0]) if "yaw" in name else None
    colour = COLOURS[yaw] if yaw is not None else WHEEL_COLOUR
    if "search" in name:
        return {"linestyle": "", "marker": "o" if "dy 1 mm" not in name else "x", "markersize": 3.2,
                "zorder": 1.5, "color": colour if yaw is not None else QUIET, "alpha": 0.7}
    if "elastic" in name:
        return {"color": colour if yaw is not None else CONTACT_COLOUR, "linestyle": (0, (4, 1.5)),
                "linewidth": 1.4}
    return {"color": colour, "linewidth": 1.5}


def over_shift(panel, figure, wanted, *, span=None, legend=True):
    """The curves whose names ``wanted`` accepts over the lateral shift."""
    value = list(figure.columns)[2]
    for name in filter(wanted, figure.curves):
        shift, values = figure.curve(name, "lateral shift [mm]", value)
        jump = np.flatnonzero(np.abs(np.diff(values)) > JUMP) + 1
        panel.plot(np.insert(shift, jump, np.nan), np.insert(values, jump, np.nan), label=name,
                   **look_of(name))
    panel.set(xlabel="lateral shift of the wheelset, right + [mm]", ylabel=AXES[value])
    if span:
        seen = [line.get_ydata()[(line.get_xdata() >= span[0]) & (line.get_xdata() <= span[1])]
                for line in panel.lines]
        low, high = (of(np.concatenate(seen)) for of in (np.nanmin, np.nanmax))
        panel.set(xlim=span, ylim=(low - 0.04 * (high - low), high + 0.04 * (high - low)))
    if legend:
        panel.legend()


AXES = {"roll [deg]": "roll, right wheel down + [deg]",
        "y_wheel [mm]": "contact on the wheel, field side + [mm]",
        "x_wheel [mm]": "contact ahead of the axle [mm]"}


def draw_inset(panel, figure, bounds, wanted, span, title=""):
    """A smaller panel inside another one, with a part of the curves over ``span`` [mm]; it is returned."""
    inset = panel.inset_axes(bounds)
    over_shift(inset, figure, wanted, span=span, legend=False)
    inset.set(xlabel="", ylabel="")
    inset.set_title(title, fontsize=8, fontweight="normal")
    inset.tick_params(labelsize=7)
    return inset


def every(name):
    return True


def mark_jumps(panel, shifts):
    """Dotted lines at lateral shifts [mm] with their numbers."""
    low, high = panel.get_xlim()
    for shift in shifts:
        if low < shift < high:
            panel.axvline(shift, color=QUIET, linewidth=0.8, linestyle=":")
            panel.annotate(f"{shift:.3f}", (shift, 0.02), (-3, 0), xycoords=("data", "axes fraction"),
                           textcoords="offset points", rotation=90, ha="right", va="bottom", fontsize=8,
                           color=QUIET)


def jumps_of(figure):
    """Lateral shifts [mm] of the jumps among the numbers."""
    return [value for name, value in figure.numbers.items() if name.startswith("jump")
            and name.endswith("at [mm]")]


# --- chapters 4 and 5 ------------------------------------------------------------------------------


def draw_roll(picture, figure):
    whole, near = picture.subplots(1, 2)
    over_shift(whole, figure, every)
    over_shift(near, figure, every, span=(4.3, 6.6), legend=False)
    mark_jumps(near, (figure.numbers["bend to the flange root at [mm]"],
                      figure.numbers["bend to the flange at [mm]"]))
    whole.set_title("Whole range")
    near.set_title("Around the two jumps of the contact: the roll bends there")


def draw_place(picture, figure):
    whole, near = picture.subplots(1, 2, width_ratios=(1.5, 1))
    for panel, span in ((whole, None), (near, (4.3, 8.0))):
        over_shift(panel, figure, every, span=span, legend=span is None)
        draw_zones(panel)
    mark_jumps(near, jumps_of(figure))
    whole.set_title("Whole range")
    near.set_title("Flange root and flange")


def draw_zones(panel):
    """Bands of tread, flange root and flange of the S1002, within what the panel shows."""
    low, high = panel.get_ylim()
    for name, (start, stop) in WHEEL_ZONES.items():
        start, stop = max(start / MM, low), min(stop / MM, high)
        if stop > start:
            panel.axhspan(start, stop, color=ZONE_COLOUR[name], linewidth=0, zorder=0)
            panel.text(0.99, stop - 0.01 * (high - low), name, color=QUIET, style="italic", ha="right",
                       va="top", transform=panel.get_yaxis_transform())
    panel.set_ylim(low, high)


def draw_place_and_errors(picture, figure):
    whole, errors = picture.subplots(1, 2, width_ratios=(1.3, 1))
    over_shift(whole, figure, lambda name: "dy 1 mm" not in name)
    draw_zones(whole)
    known = dict(zip(*figure.curve("rigid, exact", "lateral shift [mm]", "y_wheel [mm]")))
    for name in figure.curves:
        if name != "rigid, exact":
            shift, place = figure.curve(name, "lateral shift [mm]", "y_wheel [mm]")
            error = np.abs(place - [known[at] for at in shift])
            errors.plot(shift, np.maximum(error, 1e-9), label=name, **look_of(name))
    errors.axvspan(6.3, 8, color=ZONE_COLOUR["flange"], linewidth=0, zorder=0)
    errors.axvspan(-8, -6.3, color=ZONE_COLOUR["flange"], linewidth=0, zorder=0)
    errors.set(yscale="log", ylim=(1e-9, 30), xlabel="lateral shift of the wheelset, right + [mm]",
               ylabel="distance from the rigid contact [mm]")
    errors.legend(loc="lower left", fontsize=7)
    whole.set_title("Contact on the right wheel")
    errors.set_title("Distance from it; grey: beyond 6.3 mm")


def draw_two_searches(picture, figure):
    kinds = (("Rigid contact", lambda name: "elastic" not in name),
             ("Elastic contact at 78.5 kN", lambda name: "elastic" in name))
    for panel, (title, wanted) in zip(picture.subplots(1, 2, sharey=True), kinds):
        over_shift(panel, figure, wanted, span=(0, 8), legend=False)
        inset = draw_inset(panel, figure, (0.14, 0.14, 0.5, 0.5), wanted, (4.4, 5.6))
        panel.indicate_inset_zoom(inset, edgecolor=QUIET)
        panel.set_title(title)
    handles = {line.get_label(): line for panel in picture.axes for line in panel.lines}
    picture.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=3)


def draw_by_yaw(picture, figure):
    panel = picture.subplots()
    over_shift(panel, figure, lambda name: "exact" in name, legend=False)
    over_shift(panel, figure, lambda name: "search" in name, legend=False)
    lines = [line for line in panel.lines if "exact" in line.get_label()]
    dots = next(line for line in panel.lines if "search" in line.get_label())
    panel.legend([*lines, dots], [*(line.get_label() for line in lines), "source's 3-D search, dx 0.1 mm"],
                 loc="lower left" if "roll" in figure.title.lower() else "upper left")
    return panel


def draw_roll_by_yaw(picture, figure):
    panel = draw_by_yaw(picture, figure)
    draw_inset(panel, figure, (0.14, 0.32, 0.38, 0.5), lambda name: "exact" in name, (0, 5.3),
               "tread and flange root")
    panel.set_xlim(0, 8)


def draw_shift_by_yaw(picture, figure):
    panel = draw_by_yaw(picture, figure)
    panel.set_xlim(0, 8)
    inset = draw_inset(panel, figure, (0.27, 0.3, 0.36, 0.62), every, (0, 6.3), "before flange contact")
    inset.set_ylim(-0.5, 11)
