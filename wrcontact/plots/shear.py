"""The map of a wheel's patches: pressure, shear stress, and where they stick and slip."""

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import Normalize
from matplotlib.patches import Patch as Swatch
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from scipy.ndimage import distance_transform_edt

from ..methods.numbers import check_choice
from .patch import (
    draw_patch,
    fine_outline,
    frame_patch,
    headline,
    leave_empty,
    missing,
    of_one_pose,
    patch_ends,
    patch_places,
    pressure_scale,
    window_size,
)
from .style import INK, MEGAPASCAL, MM, given_axis, styled
from .traction import patch_tractions

#: What the colours of a map show, and the words beside their bar.
SHOWN = {"pressure": "pressure [MPa]", "shear": "shear stress [MPa]", "slip": ""}
STICK_COLOUR, SLIP_COLOUR = "#56B4E9", "#E69F00"
SHEAR_COLOURS = "cividis_r"
#: Arrows beside each other in a picture, and the length of the longest one, in distances between them.
ARROWS, LONGEST = 15, 1.4
#: Below this share of the largest shear stress there is no arrow.
SMALLEST = 0.04
#: Share of the bound of friction that a cell that slips has, but for rounding.
USED = 0.999
#: Least width and height of a picture in shares of the larger one of a wheel's patches.
LEAST_ACROSS, LEAST_ALONG = 1.0, 0.6
#: Share of the height that is added below for the key of the arrows.
KEY = 0.12
#: [in] of a figure with a square picture, and what titles and labels need of its height.
SIZE, AROUND = (5.6, 4.0), 0.7


@styled
@of_one_pose()
def patch_map(system, state, axis=None, *, side="right", colour="pressure", bar=True):
    """The patches of one wheel in the contact plane, the rolling direction up, with arrows of the shear
    stress on the wheel and the border between stick and slip.

    The pressure is that of the state's outline, continued along the rolling direction as a half-ellipse.
    Shear stress, stick and slip are reconstructed by :func:`patch_tractions`, and left out where the state
    has no creep force.

    Parameters
    ----------
    system, state : a :class:`~wrcontact.ContactSystem` and its state at one pose.
    axis : axis of matplotlib; None for one in a new figure.
    side : "right" or "left".
    colour : what the colours show: "pressure", "shear", or "slip", the areas that stick and slip.
    bar : whether to draw a bar with the colours; areas that stick and slip have a legend instead.

    Returns
    -------
    axis
    """
    check_choice("side", side, ("left", "right"))
    check_choice("colour", colour, SHOWN)
    wheel = getattr(state, side)
    if missing(wheel):
        axis = given_axis(axis, *SIZE)
        axis.set_title(headline(side, wheel))
        leave_empty(missing(wheel), axis)
        return axis
    outline, places = wheel.outline, patch_places(system, state, side)
    fields = _fields(system, state, side)
    if colour != "pressure" and not fields:
        raise ValueError(
            f"colour is {colour!r}; permitted is 'pressure' where there are no creep forces or the "
            "wheelset rolls backwards"
        )
    half = _window(outline, places)
    axis = given_axis(axis, SIZE[0], SIZE[1] * half[1] / half[0] + AROUND)
    axis.set_title(headline(side, wheel))
    if colour == "pressure":
        mesh = draw_patch(axis, outline, pressure_scale([outline]), places)
    else:
        mesh = _draw_cells(axis, outline, places, fields, colour)
    _draw_edges(axis, fields, _edge(outline, places), colour)
    _draw_arrows(axis, fields, 2 * max(half) / ARROWS)
    frame_patch(axis, outline, *half, np.mean(patch_ends(outline, places)) - KEY / (1 + KEY) * half[1])
    axis.set(xlabel="lateral in the contact plane, field side + [mm]", ylabel="rolling direction [mm]")
    if bar and colour != "slip":
        axis.get_figure().colorbar(mesh, ax=axis, label=SHOWN[colour], pad=0.02)
    return axis


def _fields(system, state, side):
    """Tractions of the patches with creep forces."""
    rolls = state.inputs.speed >= 0.0
    return [
        patch_tractions(system, state, side, number)
        for number, patch in enumerate(getattr(state, side).patches)
        if rolls and patch.saturation > 0.0
    ]


def _draw_edges(axis, fields, edge, colour):
    """The edge of the patches, and where they stick, if not the ``colour`` shows it."""
    axis.add_patch(PathPatch(edge, facecolor="none", edgecolor=INK, linewidth=0.9))
    if colour != "slip" and any([_draw_border(axis, field, edge) for field in fields]):
        axis.text(
            0.99,
            0.045,
            "dashed: border of sticking",
            transform=axis.transAxes,
            ha="right",
            va="center",
            fontsize=8,
        )


def _window(outline, places):
    """Half width and half length of a picture [m], not too narrow, with room for the key of the arrows."""
    half = window_size([outline], [places])
    across, along = (max(one, least * max(half)) for one, least in zip(half, (LEAST_ACROSS, LEAST_ALONG)))
    return across, (1.0 + KEY) * along


def _draw_cells(axis, outline, places, fields, colour):
    """The patches in colours of their shear stress, or whether they slip."""
    edge = _edge(outline, places)
    largest = max(float(np.max(_shear(field))) for field in fields) / MEGAPASCAL
    rest = SLIP_COLOUR if colour == "slip" else colormaps[SHEAR_COLOURS](0.0)
    axis.add_patch(PathPatch(edge, facecolor=rest, linewidth=0))
    for field in fields:
        y, x = field.station / MM, field.along / MM
        if colour == "shear":
            mesh = axis.pcolormesh(
                y,
                x,
                _shear(field) / MEGAPASCAL,
                shading="gouraud",
                cmap=SHEAR_COLOURS,
                norm=Normalize(0, largest),
                rasterized=True,
            )
        else:
            mesh = axis.contourf(y, x, _used(field), levels=[-1.0, USED], colors=[STICK_COLOUR])
        mesh.set_clip_path(PathPatch(edge, transform=axis.transData))
    if colour == "slip":
        axis.legend(
            handles=[Swatch(color=STICK_COLOUR, label="sticks"), Swatch(color=SLIP_COLOUR, label="slips")],
            loc="lower right",
            ncols=2,
        )
    return mesh


def _edge(outline, places):
    """The edge of all patches of a wheel as a path [mm]."""
    station, half_length, _ = fine_outline(outline)
    rings = []
    bounds = np.flatnonzero(np.diff(np.concatenate([[0], half_length > 0.0, [0]]).astype(int)))
    for start, stop in bounds.reshape(-1, 2):
        part = slice(max(start - 1, 0), stop + 1)
        y, x, half = station[part] / MM, places[part] / MM, half_length[part] / MM
        rings.append(
            Path(
                np.column_stack([np.concatenate([y, y[::-1]]), np.concatenate([x + half, (x - half)[::-1]])]),
                closed=False,
            )
        )
    return Path.make_compound_path(*rings)


def _shear(field):
    return np.hypot(field.shear_x, field.shear_y)


def _used(field):
    """Share of friction that a cell uses, 1 where it slips; outside of the patch that of the nearest cell."""
    bound = field.friction * field.pressure
    inside = field.cover > 0.5
    share = np.divide(_shear(field), bound, out=np.ones_like(bound), where=inside)
    return share[tuple(distance_transform_edt(~inside, return_distances=False, return_indices=True))]


def _draw_border(axis, field, edge):
    """The line between stick and slip, dark on white; whether there is one."""
    used = _used(field)
    if not np.any(used < USED):
        return False
    for colour, stroke in (("white", "solid"), (INK, (0, (3, 2)))):
        line = axis.contour(
            field.station / MM,
            field.along / MM,
            used,
            levels=[USED],
            colors=[colour],
            linewidths=1.4,
            linestyles=[stroke],
        )
        line.set_clip_path(PathPatch(edge, transform=axis.transData))
    return True


def _draw_arrows(axis, fields, pitch):
    """Arrows of the shear stress on the wheel about every ``pitch`` [m], with one scale, and its key."""
    if not fields:
        return
    station, along, across, ahead = np.concatenate([_picked(field, pitch) for field in fields], axis=1)
    largest = max(float(np.max(_shear(field))) for field in fields)
    seen = np.hypot(across, ahead) > SMALLEST * largest
    arrows = axis.quiver(
        *(
            values[seen] / unit
            for values, unit in ((station, MM), (along, MM), (across, MEGAPASCAL), (ahead, MEGAPASCAL))
        ),
        angles="xy",
        scale_units="xy",
        scale=largest / MEGAPASCAL / (LONGEST * pitch / MM),
        color=INK,
        edgecolor="white",
        linewidth=0.5,
        units="inches",
        width=0.02,
        pivot="mid",
        headwidth=3.8,
        headlength=4.4,
        headaxislength=4.0,
        minlength=0.3,
        zorder=5,
    )
    shown = float(f"{largest / MEGAPASCAL:.1g}")
    axis.quiverkey(
        arrows,
        0.13,
        0.045,
        shown,
        f"shear stress {shown:g} MPa",
        labelpos="E",
        coordinates="axes",
        fontproperties={"size": 8},
    )


def _picked(field, pitch):
    """Station, place along the track, and traction across and along, of cells that lie wholly in the patch
    and about a ``pitch`` [m] from each other, (4, n)."""
    rows, columns = (_evenly(middles, pitch) for middles in (field.station[:, 0], field.along[0]))
    at = np.ix_(rows, columns)
    found = np.array([array[at] for array in (field.station, field.along, field.shear_y, field.shear_x)])
    return found[:, field.cover[at] > USED]


def _evenly(middles, pitch):
    """Indices of cells about a ``pitch`` apart, the outer ones half as far from the edge."""
    count = max(2, round(float(np.ptp(middles)) / pitch))
    return ((np.arange(count) + 0.5) * len(middles) / count).astype(int)
