"""Pictures of a contact patch: its outline in the contact plane, its pressure in colour, and the pressure on
its centre line."""

import numpy as np
from matplotlib.colors import Normalize
from scipy.interpolate import Akima1DInterpolator

from .style import INK, MEGAPASCAL, MM, PRESSURE_COLOURS, QUIET, SIDE_COLOUR, new_figure, styled

FINER = 12  # drawn points per stored station
LAYERS = 61  # drawn points from the front edge of the patch to the rear edge
MARGIN = 1.2e-3  # [m] around a patch


def fine_outline(outline):
    """Station [m], half-length [m] and pressure [Pa] of one pose at many stations, three arrays (n,).

    Between the stored stations the squares are interpolated: they are linear near an edge, so an ellipse
    stays smooth.
    """
    stored = np.arange(len(outline.station))
    place = np.linspace(0, stored[-1], FINER * stored[-1] + 1)
    half_length, pressure = (np.sqrt(np.maximum(Akima1DInterpolator(stored, values**2,
                                                                    method="makima")(place), 0.0))
                             for values in (outline.half_length, outline.pressure))
    return np.interp(place, stored, outline.station), half_length, pressure


def draw_patch(panel, outline, scale):
    """Fill the patch of one pose by pressure: lateral position to the right, rolling direction up, both in
    mm.

    ``scale`` is a matplotlib norm in MPa, so that several patches share one colour scale.
    """
    station, half_length, middle = fine_outline(outline)
    across = np.sin(np.linspace(-np.pi / 2, np.pi / 2, LAYERS))[:, None]
    y, x = np.broadcast_arrays(station / MM, across * half_length / MM)
    pressure = middle * np.sqrt(np.maximum(1 - across**2, 0.0)) / MEGAPASCAL
    mesh = panel.pcolormesh(y, x, pressure, shading="gouraud", cmap=PRESSURE_COLOURS, norm=scale,
                            rasterized=True)
    edge = np.where(_between_patches(half_length), np.nan, half_length)
    for side in (edge, -edge):
        panel.plot(station / MM, side / MM, color=INK, linewidth=0.9)
    return mesh


def _between_patches(half_length):
    """Mask of the points that are not loaded and have no loaded neighbour."""
    bare = np.concatenate([[False], half_length <= 0, [False]])
    return bare[1:-1] & bare[:-2] & bare[2:]


def draw_pressure(panel, outline, colour):
    """Pressure on the centre line of the patch [MPa] against the lateral position [mm]."""
    station, _, pressure = fine_outline(outline)
    panel.fill_between(station / MM, pressure / MEGAPASCAL, color=colour, alpha=0.25, linewidth=0)
    return panel.plot(station / MM, pressure / MEGAPASCAL, color=colour)[0]


def pressure_scale(outlines):
    """One colour scale for several patches, from zero to the largest pressure, rounded up [MPa]."""
    largest = max(float(np.max(fine_outline(outline)[2])) for outline in outlines) / MEGAPASCAL
    return Normalize(0, 100 * np.ceil(max(largest, 1.0) / 100))


def window_size(outlines):
    """Half width and half length [m] of a window that fits each of several patches, so that they share one
    scale."""
    across = max(float(np.ptp(outline.station)) for outline in outlines) / 2
    along = max(float(np.max(outline.half_length)) for outline in outlines)
    return across + MARGIN, along + MARGIN


def frame_patch(panel, outline, across, along):
    """Set the limits of ``panel`` to ``across`` [m] on both sides of the patch's middle and ``along`` [m]
    ahead and behind."""
    middle = 0.5 * (outline.station[0] + outline.station[-1])
    panel.set_xlim((middle - across) / MM, (middle + across) / MM)
    panel.set_ylim(-along / MM, along / MM)
    panel.set_aspect("equal")


@styled
def outline_figure(state):
    """The patches of both wheels at one pose, above their pressure."""
    figure = new_figure(8.5, 6.6)
    draw_outlines(figure, figure.subplots(2, 2, height_ratios=(2.3, 1)), state)
    return figure


def draw_outlines(figure, panels, state):
    """Draw patch and pressure of the left and right wheel into ``panels`` (2, 2), with a common scale."""
    sides = {"left": state.left, "right": state.right}
    loaded = [side.outline for side in sides.values() if side.patch_count]
    for (name, side), upper, lower in zip(sides.items(), *panels):
        upper.set_label(f"{name} patch")
        lower.set_label(f"{name} pressure")
        upper.set_title(_headline(name, side))
        if side.patch_count:
            mesh = _draw_side(upper, lower, name, side.outline, loaded)
        else:
            _leave_empty(upper, lower)
    if loaded:
        figure.colorbar(mesh, ax=panels[0], label="pressure [MPa]", shrink=0.9)


def _draw_side(upper, lower, name, outline, loaded):
    """Patch and pressure of one wheel, with the common scale."""
    scale = pressure_scale(loaded)
    mesh = draw_patch(upper, outline, scale)
    half = max(window_size(loaded))
    frame_patch(upper, outline, half, half)
    upper.set(ylabel="rolling direction [mm]")
    draw_pressure(lower, outline, SIDE_COLOUR[name])
    lower.set(xlim=upper.get_xlim(), ylim=(0, 1.05 * scale.vmax), ylabel="pressure [MPa]",
              xlabel="lateral in the contact plane, field side + [mm]")
    return mesh


def _headline(name, side):
    """Title of one wheel's contact, in two lines."""
    if not side.patch_count:
        return f"{name.capitalize()} wheel: no load,\nno patch"
    regions = {1: "one patch"}.get(side.patch_count, f"{side.patch_count} patches")
    return (f"{name.capitalize()} wheel: {regions}, {side.area / MM**2:.0f} mm²,\n"
            f"pressure up to {side.max_pressure / MEGAPASCAL:.0f} MPa")


def _leave_empty(*panels):
    """Panels of a wheel without load."""
    for panel in panels:
        panel.set(xticks=[], yticks=[])
        panel.text(0.5, 0.5, "unloaded", transform=panel.transAxes, ha="center", va="center", color=QUIET)
