"""Pictures of wear and of rolling contact fatigue."""

import numpy as np

from ..conventions import SIDES
from ..wear import Fatigue, fatigue, shakedown_limit
from ..wear.fatigue import YIELD_SHEAR
from .style import INK, MM, QUIET, SIDE_COLOUR, in_lines, new_figure, styled

#: Profiles over mileage: light at the beginning, dark at the end.
AGE_COLOURS = "viridis_r"
#: Curves at most in one panel, and times that the depth is enlarged over the new profile.
CURVES, LARGER = 9, 10.0
KILOMETRE, SQUARE_MM = 1e3, 1e-6
#: Mileage [m] from which axes are in thousands of kilometres.
FAR = 2e7
#: Lengths that are shown over mileage: name, words, colour, line.
SIZES = (
    ("flange_thickness", "flange thickness Sd", "#0072B2", "-"),
    ("flange_steepness", "qR", "#56B4E9", "--"),
    ("flange_height", "flange height Sh", "#D55E00", "-"),
    ("radius_loss", "radius loss", INK, ":"),
    ("hollow", "hollow", "#009E73", "-."),
)
FRICTION = np.linspace(0.0, 0.6, 121)


@styled
def wear_figure(run, side=None):
    """Figure of a :class:`~wrcontact.WearRun`: profiles and worn depth of a ``side`` over the mileage, and
    what a workshop measures; None is the right side, or the only wheel."""
    side = side or run.sides[-1]
    figure = new_figure(9.6, 8.4)
    axes = figure.subplot_mosaic([["profile", "profile"], ["depth", "sizes"], ["conicity", "area"]])
    per, unit = (KILOMETRE, "km") if run.part == "wheel" else (1.0, "passages")
    if run.distance[-1] >= FAR:
        per, unit = 1e3 * per, f"1000 {unit}"
    distance = run.distance / per
    shown = np.unique(np.linspace(0, len(run.steps) - 1, min(CURVES, len(run.steps))).round().astype(int))
    colours = dict(zip(shown.tolist(), _ages(len(shown))))
    first = run.steps[0].profiles[side]
    y = np.linspace(first.start, first.stop, 2001)[1:-1]
    depths = _depths(run, side, y)
    _draw_profiles(axes["profile"], first, y, {k: depths[k] for k in colours}, colours)
    axes["profile"].set_title(f"{side} {run.part}, depth enlarged {LARGER:g} times")
    for k, colour in colours.items():
        axes["depth"].plot(y / MM, depths[k] / MM, color=colour, linewidth=1.1, label=f"{distance[k]:.0f}")
    axes["depth"].set(title="Worn depth, along the normal", xlabel="across, field side + [mm]", ylabel="mm")
    axes["depth"].set_ylim(0, None)
    axes["depth"].legend(title=unit, title_fontsize=7.5, fontsize=7, loc="upper right", labelspacing=0.2)
    if run.part == "wheel":
        for name, words, colour, line in SIZES:
            change = run.shape(name, side) - run.shape(name, side)[0]
            axes["sizes"].plot(distance, change / MM, color=colour, linestyle=line, label=words)
        axes["sizes"].legend(fontsize=7.5)
        axes["conicity"].plot(distance, run.conicity, color=INK)
    axes["sizes"].set(title="Change of dimensions", xlabel=unit, ylabel="mm")
    axes["conicity"].set(title="Equivalent conicity at 3 mm", xlabel=unit, ylabel="tan γ", ylim=(0, None))
    for one, line in zip(run.sides, ("-", "--")):
        area = run.shape("worn_area", one) / SQUARE_MM
        axes["area"].plot(distance, area, color=SIDE_COLOUR[one], label=one, linestyle=line)
    axes["area"].set(title="Worn cross-section", xlabel=unit, ylabel="mm²", ylim=(0, None))
    axes["area"].legend()
    return figure


def _ages(count):
    import matplotlib

    return matplotlib.colormaps[AGE_COLOURS](np.linspace(0.05, 1.0, count))


def _depths(run, side, y):
    """Depth (steps, n) along the normal that was taken off before each step, over the new profile."""
    taken = [np.interp(y, *step.depth[side], left=0.0, right=0.0) for step in run.steps]
    return np.concatenate([np.zeros((1, len(y))), np.cumsum(taken, axis=0)[:-1]])


def _draw_profiles(panel, new, y, depths, colours):
    """The new profile, and points of it moved along its normal by the enlarged ``depths``."""
    z, slope, _ = new.evaluate(y)
    into = (LARGER if new.kind == "wheel" else -LARGER) / np.hypot(1.0, slope)
    for k, depth in depths.items():
        worn = depth > 0.0
        if k == 0:
            panel.plot(y / MM, -z / MM, color=QUIET, linewidth=1.1)
        elif np.any(worn):
            some = slice(max(int(np.argmax(worn)) - 1, 0), len(y) - int(np.argmax(worn[::-1])) + 1)
            across, down = y + depth * into * slope, z - depth * into
            panel.plot(across[some] / MM, -down[some] / MM, color=colours[k], linewidth=0.9)
    panel.set(xlabel="across, field side + [mm]", ylabel="height [mm]")
    panel.set_aspect("equal", adjustable="datalim")


@styled
def wear_depth_figure(wear, distance, smoothing=1e-3, per=KILOMETRE):
    """Figure of a :class:`~wrcontact.Wear`: depth over both profiles after a ``distance`` [m] and as many
    passages, with the standard error of the bootstrap over poses."""
    figure = new_figure(9.6, 5.6)
    axes = figure.subplots(2, sharex=False)
    for panel, part in zip(axes, ("wheel", "rail")):
        for side in (wear.side,) if wear.side else SIDES[1:] if wear.mirrored else SIDES:
            name = part if wear.side else f"{side}.{part}"
            count = distance if part == "wheel" else 1.0
            factor = count / MM if part == "wheel" else 1e9  # nm per passage
            places, _ = wear.depth(name)
            depth = wear.smooth_depth(name, smoothing) * factor
            error = wear.error(name, smoothing=smoothing) * factor
            panel.fill_between(
                places / MM,
                np.maximum(depth - error, 0.0),
                depth + error,
                alpha=0.2,
                color=SIDE_COLOUR[side],
                linewidth=0,
            )
            panel.plot(
                places / MM, depth, color=SIDE_COLOUR[side], label="both sides" if wear.mirrored else side
            )
        said = f"mm in {distance / per:g} km" if part == "wheel" else "nm in a passage"
        panel.set(ylabel=said, ylim=(0, None), title=f"Worn depth of the {part}s, along the normal")
        panel.legend()
    axes[1].set_xlabel("across, field side + [mm]")
    return figure


@styled
def shakedown_figure(table, yield_shear=YIELD_SHEAR, ax=None):
    """The shakedown map of a table of states or a :class:`~wrcontact.wear.Fatigue`: each patch by its
    utilised friction and its peak pressure over the yield stress in shear [Pa].

    The limit is that of a line contact; on its branch 1 / friction the surface fatigue index is zero.
    """
    found = table if isinstance(table, Fatigue) else fatigue(table, yield_shear=yield_shear)
    figure = new_figure(7.0, 5.0) if ax is None else ax.get_figure()
    panel = figure.subplots() if ax is None else ax
    for side in found.sides:
        friction, ratio = (found.of_side(name, side) for name in ("utilised_friction", "shakedown_ratio"))
        there = np.isfinite(ratio)
        panel.scatter(
            friction[there],
            ratio[there],
            s=14,
            color=SIDE_COLOUR[side or "right"],
            alpha=0.6,
            linewidths=0,
            label=f"{side} patches" if side else "patches",
        )
    panel.plot(FRICTION, shakedown_limit(FRICTION), color=INK, label="shakedown of a line contact")
    beyond = FRICTION > 0.15
    panel.plot(
        FRICTION[beyond], 1.0 / FRICTION[beyond], color=QUIET, linestyle="--", label="surface yields, index 0"
    )
    panel.set(
        xlabel="utilised friction",
        ylabel="p₀ / k",
        xlim=(0, FRICTION[-1]),
        ylim=(0, max(5.0, 1.05 * np.nanmax(found.shakedown_ratio))),
        title="Shakedown map",
    )
    panel.legend(loc="upper right")
    return figure


@styled
def fatigue_figure(found, name="damage", part="rail", weights=None, width=1e-3):
    """Histogram of a number of a :class:`~wrcontact.wear.Fatigue` over the profiles of both sides, or of one
    wheel."""
    figure = new_figure(8.4, 3.6)
    panel = figure.subplots()
    for shift, side in zip((-0.2, 0.2), found.sides):
        places, sums = found.histogram(name, part, side, width, weights)
        colour, label = SIDE_COLOUR[side or "right"], side or "one wheel"
        panel.bar((places + shift * width) / MM, sums, 0.4 * width / MM, color=colour, label=label)
    title = f"{name.replace('_', ' ').capitalize()} over the {part}, sum of all passages"
    panel.set(xlabel="across, field side + [mm]", title=in_lines(title, 8.4), ylabel=name.replace("_", " "))
    panel.legend()
    return figure
