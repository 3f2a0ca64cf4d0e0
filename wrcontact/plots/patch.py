"""Pictures of a contact patch: its outline in the contact plane, its pressure in colour, and the pressure on
its centre line."""

from functools import wraps

import numpy as np
from matplotlib.colors import Normalize
from scipy.interpolate import Akima1DInterpolator

from ..conventions import SIDES
from ..methods.numbers import check_choice
from ..state import WheelsetState
from .geometry import stations_along
from .style import (
    INK,
    KILONEWTON,
    MEGAPASCAL,
    MM,
    PRESSURE_COLOURS,
    QUIET,
    SIDE_COLOUR,
    given_axes,
    new_figure,
    styled,
)

FINER = 12  # drawn points per stored station
LAYERS = 61  # drawn points from the front edge of the patch to the rear edge
MARGIN = 1.2e-3  # [m] around a patch


def fine_outline(outline):
    """Station [m], half-length [m] and pressure [Pa] of one pose at many stations, three arrays (n,)."""
    return finer(outline.station, outline.half_length, outline.pressure)


def finer(station, *values):
    """Many stations between the stored ones, and there the ``values`` (n,) >= 0.

    Their squares are interpolated: they are linear near an edge, so an ellipse stays smooth.
    """
    stored = np.arange(len(station))
    place = np.linspace(0, stored[-1], FINER * stored[-1] + 1)
    squares = (Akima1DInterpolator(stored, each**2, method="makima")(place) for each in values)
    return np.interp(place, stored, station), *(np.sqrt(np.maximum(square, 0.0)) for square in squares)


def patch_places(system, state, side):
    """Where the patches of one wheel lie along the track, from the contact point [m]: their middles at the
    stations of :func:`fine_outline` (n,).

    Each patch lies on the line that fits the wheel's locus best over its load; without yaw that is zero.
    """
    station, half_length, pressure = fine_outline(getattr(state, side).outline)
    locus, places = stations_along(system, state, side, station), np.full(len(station), np.nan)
    for inside in loaded(half_length):
        load = np.sqrt(half_length[inside] * pressure[inside])
        if np.count_nonzero(load) > 1:
            line = np.polyfit(station[inside], locus[inside], 1, w=load)
            places[inside] = np.polyval(line, station[inside])
    known = np.flatnonzero(np.isfinite(places))
    if not len(known):
        return np.zeros(len(station))
    nearest = known[np.argmin(np.abs(np.arange(len(station))[:, None] - known), axis=1)]
    return places[nearest]


def loaded(half_length):
    """Slices of the points of each patch, with the bare points beside it."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], half_length > 0.0, [0]]).astype(int)))
    return [slice(max(start - 1, 0), stop + 1) for start, stop in edges.reshape(-1, 2)]


def draw_patch(panel, outline, scale, along=0.0):
    """Fill the patch of one pose by pressure: lateral position to the right, rolling direction up, both in
    mm.

    ``scale`` is a matplotlib norm in MPa, so that several patches share one colour scale; ``along`` [m] is
    what :func:`patch_places` gives.
    """
    station, half_length, middle = fine_outline(outline)
    across = np.sin(np.linspace(-np.pi / 2, np.pi / 2, LAYERS))[:, None]
    y, x = np.broadcast_arrays(station / MM, (across * half_length + along) / MM)
    pressure = middle * np.sqrt(np.maximum(1 - across**2, 0.0)) / MEGAPASCAL
    parts = sorted(loaded(half_length), key=lambda part: -np.max(middle[part]))
    mesh = [
        panel.pcolormesh(
            y[:, part],
            x[:, part],
            pressure[:, part],
            shading="gouraud",
            cmap=PRESSURE_COLOURS,
            norm=scale,
            rasterized=True,
        )
        for part in parts
    ][0]
    edge = np.where(_between_patches(half_length), np.nan, half_length)
    for side in (edge, -edge):
        panel.plot(station / MM, (side + along) / MM, color=INK, linewidth=0.9)
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


def window_size(outlines, places=()):
    """Half width and half length [m] of a window that fits each of several patches, so that they share one
    scale; ``places`` are what :func:`patch_places` gives."""
    across = max(float(np.ptp(outline.station)) for outline in outlines) / 2
    along = max(
        (np.ptp(patch_ends(*one)) / 2 for one in zip(outlines, places)),
        default=max(float(np.max(outline.half_length)) for outline in outlines),
    )
    return across + MARGIN, float(along) + MARGIN


def patch_ends(outline, along):
    """The rear and front end of the patches of one wheel [m]."""
    _, half_length, _ = fine_outline(outline)
    return np.min((along - half_length)[half_length > 0.0]), np.max((along + half_length)[half_length > 0.0])


def frame_patch(panel, outline, across, along, middle=0.0):
    """Set the limits of ``panel`` to ``across`` [m] on both sides of the patch's middle and ``along`` [m]
    ahead and behind of ``middle`` [m]."""
    centre = 0.5 * (outline.station[0] + outline.station[-1])
    panel.set_xlim((centre - across) / MM, (centre + across) / MM)
    panel.set_ylim((middle - along) / MM, (middle + along) / MM)
    panel.set_aspect("equal")


def chosen_sides(side):
    """The sides to draw: both for None.

    Raises
    ------
    ValueError
        if there is no such ``side``.
    """
    if side is None:
        return SIDES
    check_choice("side", side, SIDES)
    return (side,)


def of_one_pose(alone=False):
    """Decorator for pictures of one pose: they get ``system`` and ``state`` in this order, whichever comes
    first in the call; with ``alone`` they may get the state without its system, which is then None.

    They raise a TypeError, in a sentence, where there is no state, or where it is that of many poses.
    """

    def decorate(draw):
        @wraps(draw)
        def drawing(*given, **options):
            named = [options.pop(name) for name in ("system", "state") if name in options]
            first, more = [*named, *given[: 2 - len(named)]], given[2 - len(named) :]
            state = next((one for one in first if isinstance(one, WheelsetState)), None)
            system = next((one for one in first if not isinstance(one, WheelsetState)), None)
            if state is None:
                raise TypeError("state is None; permitted is what system.evaluate returns")
            if state.values.ndim > 1:
                raise TypeError(
                    f"state is a table of {len(state)} poses; permitted is one of them, such as table[0]"
                )
            if system is None and not alone:
                raise TypeError(f"system is None; permitted is {draw.__name__}(system, state)")
            return draw(system, state, *more, **options)

        return drawing

    return decorate


@styled
@of_one_pose(alone=True)
def outline_figure(system, state, ax=None, side=None):
    """The patches of both wheels at one pose, or of one ``side``, above their pressure; in the axes ``ax``
    (2, 2) or (2, 1), or in a new figure; returns the figure.

    With its ``system`` the patches of a yawed wheelset lie where they are along the track; without, in
    ``outline_figure(state)``, all lie beside the contact point.
    """
    sides = chosen_sides(side)
    if ax is None:
        ax = new_figure(4.25 * len(sides), 6.6).subplots(2, len(sides), height_ratios=(2.3, 1))
    figure, panels = given_axes(ax, (2, len(sides)))
    draw_outlines(figure, panels, system, state, sides)
    return figure


def draw_outlines(figure, panels, system, state, sides=SIDES):
    """Draw patch and pressure of the ``sides`` into ``panels`` (2, number of sides), with a common scale."""
    reasons = {name: missing(getattr(state, name)) for name in sides}
    drawn = [name for name in sides if not reasons[name]]
    places = {name: patch_places(system, state, name) if system is not None else 0.0 for name in drawn}
    outlines = [getattr(state, name).outline for name in drawn]
    for name, upper, lower in zip(sides, *panels):
        side = getattr(state, name)
        upper.set_label(f"{name} patch")
        lower.set_label(f"{name} pressure")
        upper.set_title(headline(name, side))
        if reasons[name]:
            leave_empty(reasons[name], upper, lower)
        else:
            half = max(window_size(outlines, places.values()))
            mesh = draw_patch(upper, side.outline, pressure_scale(outlines), places[name])
            frame_patch(upper, side.outline, half, half, np.mean(patch_ends(side.outline, places[name])))
            upper.set(ylabel="rolling direction [mm]")
            _draw_below(upper, lower, side.outline, SIDE_COLOUR[name], pressure_scale(outlines))
    if drawn:
        figure.colorbar(mesh, ax=list(panels[0]), label="pressure [MPa]", shrink=0.9)


def missing(side):
    """Why a wheel has no outline, in words; "" where it has one."""
    if side.patch_count == 0:
        return "unloaded"
    return "" if np.all(np.isfinite(side.outline.station)) else "not computed"


def _draw_below(upper, lower, outline, colour, scale):
    """The pressure of one wheel below its patch, with the shear stress of creep forces."""
    line = draw_pressure(lower, outline, colour)
    if np.nanmax(outline.shear) > 0.0:
        (shear,) = lower.plot(
            outline.station / MM, outline.shear / MEGAPASCAL, color=INK, linewidth=1.2, linestyle=(0, (4, 2))
        )
        lower.legend([line, shear], ["pressure", "mean shear stress"], loc="upper right")
    lower.set(
        xlim=upper.get_xlim(),
        ylim=(0, 1.05 * scale.vmax),
        ylabel="pressure [MPa]",
        xlabel="lateral in the contact plane, field side + [mm]",
    )


def headline(name, side):
    """Title of one wheel's contact, in two lines."""
    if not side.patches:
        reason = "no load" if side.patch_count == 0 else "not computed"
        return f"{name.capitalize()} wheel: {reason},\nno patch"
    regions = {1: "one patch"}.get(side.patch_count, f"{side.patch_count} patches")
    return (
        f"{name.capitalize()} wheel: {regions}, {side.area / MM**2:.0f} mm²,\n"
        f"up to {side.max_pressure / MEGAPASCAL:.0f} MPa{_creep(side)}"
    )


def _creep(side):
    """What the title says of creep forces; "" without them."""
    x, y = (sum(getattr(patch.tangential, axis) for patch in side.patches) for axis in "xy")
    size = np.hypot(x, y)
    return f", creep force {size / KILONEWTON:.1f} kN" if size > 0.0 else ""


def leave_empty(reason, *panels):
    """Panels of a wheel without outline."""
    for panel in panels:
        panel.set(xticks=[], yticks=[])
        panel.text(0.5, 0.5, reason, transform=panel.transAxes, ha="center", va="center", color=QUIET)
