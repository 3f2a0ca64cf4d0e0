"""The contact patch: its outline in the contact plane, filled by pressure, and the pressure along its middle."""

import numpy as np
from matplotlib.colors import Normalize

from .style import CONTACT_COLOUR, INK, MEGAPASCAL, MM, PRESSURE_COLOURS, QUIET, new_figure, styled

FINER = 12  # drawn points per stored station
LAYERS = 41  # drawn points from the front edge of the patch to the rear edge


def fine_outline(outline):
    """Station [m], half-length [m] and pressure [Pa] of one pose at many stations, three arrays (n,).

    Between the stored stations the squares run straight: near an edge they do so in truth, and an ellipse stays round.
    """
    count = len(outline.station)
    place = np.linspace(0, count - 1, FINER * (count - 1) + 1)
    stored = np.arange(count)
    half_length, pressure = (np.sqrt(np.interp(place, stored, values**2)) for values in (outline.half_length, outline.pressure))
    return np.interp(place, stored, outline.station), half_length, pressure


def draw_patch(panel, outline, pressures):
    """Fill the patch of one pose by pressure: lateral position to the right, rolling direction up, both in mm.

    ``pressures`` is a matplotlib norm in MPa, so that several patches share one colour scale.
    """
    station, half_length, middle = fine_outline(outline)
    across = np.linspace(-1, 1, LAYERS)
    pressure = middle * np.sqrt(1 - across[:, None] ** 2)
    y, x = np.broadcast_arrays(station / MM, across[:, None] * half_length / MM)
    mesh = panel.pcolormesh(y, x, pressure / MEGAPASCAL, shading="gouraud", cmap=PRESSURE_COLOURS, norm=pressures, rasterized=True)
    for edge in (half_length, -half_length):
        panel.plot(station / MM, edge / MM, color=INK, linewidth=0.9)
    panel.set_aspect("equal")
    return mesh


def draw_pressure(panel, outline, colour=CONTACT_COLOUR):
    """Pressure along the middle of the patch [MPa] over the lateral position [mm]."""
    station, _, pressure = fine_outline(outline)
    panel.fill_between(station / MM, pressure / MEGAPASCAL, color=colour, alpha=0.25, linewidth=0)
    return panel.plot(station / MM, pressure / MEGAPASCAL, color=colour)[0]


def pressure_scale(outlines):
    """One colour scale for several patches, from zero to the largest pressure [MPa] in round hundreds."""
    largest = max(float(np.max(outline.pressure)) for outline in outlines) / MEGAPASCAL
    return Normalize(0, 100 * np.ceil(max(largest, 1.0) / 100))


def common_limits(outlines, margin=1.5e-3):
    """Largest lateral position and half-length of several patches with a margin [mm]: low y, high y, x."""
    low, high = (pick(pick(outline.station) for outline in outlines) for pick in (min, max))
    half = max(float(np.max(outline.half_length)) for outline in outlines)
    return (low - margin) / MM, (high + margin) / MM, (half + margin) / MM


@styled
def outline_figure(state):
    """The patches of both wheels at one pose, above their pressure."""
    figure = new_figure(8, 6.4)
    panels = figure.subplots(2, 2, height_ratios=(3, 2))
    draw_outlines(figure, panels, state)
    return figure


def draw_outlines(figure, panels, state):
    """Patch and pressure of the left and the right wheel into ``panels`` (2, 2), with one scale for both."""
    sides = {"left": state.left, "right": state.right}
    loaded = [side.outline for side in sides.values() if side.patch_count]
    for (name, side), upper, lower in zip(sides.items(), *panels):
        upper.set_label(f"{name} patch")
        lower.set_label(f"{name} pressure")
        if not side.patch_count:
            _empty(upper, lower, name)
            continue
        low, high, half = common_limits(loaded)
        mesh = draw_patch(upper, side.outline, pressure_scale(loaded))
        draw_pressure(lower, side.outline)
        upper.set(xlim=(low, high), ylim=(-half, half), title=_headline(name, side), ylabel="rolling direction [mm]")
        lower.set(xlim=(low, high), ylim=(0, None), ylabel="pressure [MPa]", xlabel="lateral in the contact plane, field side + [mm]")
    if loaded:
        figure.colorbar(mesh, ax=panels[0], label="pressure [MPa]", shrink=0.9)
        lower.sharey(panels[1][0])


def _headline(name, side):
    """What one sees of one wheel's contact, in two lines."""
    regions = {1: "one patch"}.get(side.patch_count, f"{side.patch_count} patches")
    return (f"{name.capitalize()} wheel: {regions}, {side.area / MM**2:.0f} mm²,\n"
            f"up to {side.max_pressure / MEGAPASCAL:.0f} MPa, angle {np.degrees(side.contact_angle):.1f}°")


def _empty(upper, lower, name):
    """A wheel without load."""
    upper.set_title(f"{name.capitalize()} wheel: no load, no patch")
    for panel in (upper, lower):
        panel.set(xticks=[], yticks=[])
        panel.text(0.5, 0.5, "unloaded", transform=panel.transAxes, ha="center", va="center", color=QUIET)
