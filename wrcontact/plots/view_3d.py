"""A wheel on its rail in three dimensions, with its patches and their normals."""

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from ..conventions import SIDES
from ..methods.numbers import check_choice
from ..profiles.placement import readable_wheel
from .geometry import mirrored, rail_lengths, rail_outline
from .patch import LAYERS, fine_outline, loaded, missing, of_one_pose, patch_places, pressure_scale
from .style import (
    INK,
    KILONEWTON,
    MEGAPASCAL,
    MM,
    PRESSURE_COLOURS,
    RAIL_COLOUR,
    WHEEL_COLOUR,
    given_axis,
    number,
    styled,
)

#: [m] of the rail ahead of and behind the contact, and of the wheel's running circle; of the wheel on the track
#: and field side; and of its rim towards the axle.
AHEAD, ARC, INSIDE, OUTSIDE, RIM = 60e-3, 100e-3, 69.5e-3, 59.5e-3, 32e-3
#: [m] of the arrow of the largest normal force.
NORMAL = 45e-3
#: Points of the drawn surfaces along the track and across, and where the reader stands [deg].
ALONG, ACROSS = 33, 41
ELEVATION, AZIMUTH = 18, 42


@styled
@of_one_pose()
def wheel_on_rail(system, state, axis=None, *, side="right"):
    """The lower part of a wheel's rim on its rail in three dimensions, seen from ahead and from the track's middle,
    with the pressure of its patches on the rail and an arrow along the normal of each, as long as its normal
    force is large.

    The patches have the outline of the state, whose pressure is continued along the rolling direction as a
    half-ellipse; they lie on the rail's surface.

    Parameters
    ----------
    system, state : a :class:`~wrcontact.ContactSystem` and its state at one pose.
    axis : axis of matplotlib with ``projection="3d"``; None for one in a new figure.
    side : "right" or "left".

    Returns
    -------
    axis
        in the track frame in mm, with heights upwards.
    """
    check_choice("side", side, SIDES)
    axis = given_axis(axis, 6.4, 4.9, projection="3d")
    if axis.name != "3d":
        raise ValueError('axis is flat; permitted is one with projection="3d"')
    axis.computed_zorder = False
    wheel = getattr(state, side)
    x, y, z = wheel_surface(system, state, side)
    _draw_rail(axis, system, state, side)
    axis.plot_surface(x / MM, y / MM, -z / MM, color=WHEEL_COLOUR, alpha=0.16, linewidth=0, zorder=5)
    axis.plot_wireframe(
        x / MM, y / MM, -z / MM, color=WHEEL_COLOUR, linewidth=0.4, alpha=0.4, rcount=9, ccount=7, zorder=6
    )
    _draw_rim(axis, system, state, side)
    if not missing(wheel):
        _draw_patches(axis, system, state, side)
        for patch in wheel.patches:
            _draw_normal(axis, patch, side, max(one.normal_force for one in wheel.patches))
    axis.set(xlabel="forward [mm]", ylabel="across, right + [mm]", zlabel="up [mm]", facecolor="none")
    axis.set_title(
        f"{side.capitalize()} wheel at {number(state.inputs.lateral_shift / MM, 1)} mm: "
        + (missing(wheel) or "patches and normal forces"),
        loc="center",
        y=1.03,
    )
    axis.set_aspect("equal")
    axis.set_box_aspect(axis._box_aspect, zoom=1.0)
    for part, bins in ((axis.xaxis, 3), (axis.yaxis, 4), (axis.zaxis, 4)):
        part.set_major_locator(MaxNLocator(bins))
        part.set_pane_color((1.0, 1.0, 1.0, 0.0))
        part.labelpad = 6
    axis.grid(False)
    axis.view_init(ELEVATION, _azimuth(side))
    return axis


def _azimuth(side):
    """From ahead and from the middle of the track [deg]."""
    return -AZIMUTH if side == "right" else AZIMUTH


def wheel_surface(system, state, side):
    """Track coordinates x, y, z (down) [m] of the wheel's surface of revolution around its lowest line,
    three arrays (along, across)."""
    y, radius = wheel_section(system, side)
    return turned(system, state, side, y, radius)


def wheel_section(system, side):
    """Lateral places y and radii [m] of the drawn part of a wheel's profile, (across,) each."""
    profile = readable_wheel(system.wheel if side == "right" else system.left_wheel)
    y = np.linspace(max(profile.start, -INSIDE), min(profile.stop, OUTSIDE), ACROSS)
    return y, system.side_parameters(side)["nominal_radius"] + profile.evaluate(y)[0]


def turned(system, state, side, y, radius):
    """Track coordinates x, y, z (down) [m] of the surface of revolution of points with lateral places ``y``
    and radii (n,) [m], three arrays (along, n)."""
    chosen = system.side_parameters(side)
    turn = np.linspace(-ARC, ARC, ALONG)[:, None] / chosen["nominal_radius"]
    sign = mirrored(side)
    lateral = sign * (chosen["running_circle_distance"] / 2 + y) + 0.0 * turn
    forward, down = radius * np.sin(turn), radius * np.cos(turn)
    roll, yaw = state.roll, state.inputs.yaw
    lateral, down = (
        np.cos(roll) * lateral - np.sin(roll) * down,
        np.sin(roll) * lateral + np.cos(roll) * down,
    )
    return (
        np.cos(yaw) * forward - np.sin(yaw) * lateral,
        np.sin(yaw) * forward + np.cos(yaw) * lateral + state.inputs.lateral_shift,
        down - system.centre_height + state.vertical_shift,
    )


def _draw_rim(axis, system, state, side):
    """Both faces of the rim, and its sections at both ends, so that a wheel is seen."""
    y, radius = wheel_section(system, side)
    inner = system.side_parameters(side)["nominal_radius"] - RIM
    for end in (0, -1):
        x, across, z = turned(system, state, side, y[[end, end]], np.array([radius[end], inner]))
        axis.plot_surface(x / MM, across / MM, -z / MM, color=WHEEL_COLOUR, alpha=0.13, linewidth=0, zorder=4)
        for line in (0, 1):
            axis.plot(
                x[:, line] / MM,
                across[:, line] / MM,
                -z[:, line] / MM,
                color=WHEEL_COLOUR,
                linewidth=1,
                zorder=7,
            )
    closed = np.concatenate([y, y[[-1, 0, 0]]]), np.concatenate([radius, [inner, inner, radius[0]]])
    x, across, z = turned(system, state, side, *closed)
    for end in (0, -1):
        axis.plot(x[end] / MM, across[end] / MM, -z[end] / MM, color=WHEEL_COLOUR, linewidth=1.2, zorder=7)
        face = Poly3DCollection(
            [np.transpose([x[end], across[end], -z[end]]) / MM], color=WHEEL_COLOUR, alpha=0.3, linewidth=0
        )
        axis.add_collection3d(face)


def _draw_rail(axis, system, state, side):
    """The head of the rail."""
    y, z = rail_outline(system, side, state)
    pick = np.linspace(0, len(y) - 1, ACROSS).astype(int)
    x = np.linspace(-AHEAD, AHEAD, ALONG)[:, None] + getattr(state, side).contact.x_track
    x, y, z = np.broadcast_arrays(x, y[pick], z[pick])
    axis.plot_surface(x / MM, y / MM, -z / MM, color=RAIL_COLOUR, alpha=0.35, linewidth=0, zorder=1)
    axis.plot_wireframe(
        x / MM, y / MM, -z / MM, color=RAIL_COLOUR, linewidth=0.5, alpha=0.7, rcount=7, ccount=9, zorder=2
    )


def _draw_patches(axis, system, state, side):
    """The patches with their pressure on the rail."""
    outline = getattr(state, side).outline
    scale, colours = pressure_scale([outline]), colormaps[PRESSURE_COLOURS]
    station, half_length, middle = fine_outline(outline)
    across = np.sin(np.linspace(-np.pi / 2, np.pi / 2, LAYERS // 4))[:, None]
    x = across * half_length + patch_places(system, state, side) + getattr(state, side).contact.x_track
    y, z = on_rail(system, state, side, station)
    x, y, z = np.broadcast_arrays(x, y, z)
    pressure = middle * np.sqrt(np.maximum(1 - across**2, 0.0)) / MEGAPASCAL
    for part in loaded(half_length):
        axis.plot_surface(
            x[:, part] / MM,
            y[:, part] / MM,
            -z[:, part] / MM,
            rcount=LAYERS,
            ccount=LAYERS,
            facecolors=colours(scale(pressure[:, part])),
            shade=False,
            linewidth=0,
            zorder=3,
        )
    axis.get_figure().colorbar(
        ScalarMappable(scale, colours), ax=axis, label="pressure [MPa]", shrink=0.6, pad=0.13
    )


def on_rail(system, state, side, station):
    """Track coordinates y, z (down) [m] on the rail at stations of an outline (n,)."""
    y, z, length = rail_lengths(system, side, state)
    return mirrored(side) * np.interp(station, length, y), np.interp(station, length, z)


def _draw_normal(axis, patch, side, largest):
    """An arrow from the centre of load upwards along the normal, with the force."""
    sign = mirrored(side)
    start = np.array([patch.x_track, patch.y_track, -patch.z_track]) / MM
    normal = np.array([0.0, -sign * np.sin(patch.contact_angle), np.cos(patch.contact_angle)])
    stroke = NORMAL / MM * patch.normal_force / largest * normal
    axis.quiver(*start, *stroke, color=INK, linewidth=1.6, arrow_length_ratio=0.15, zorder=8)
    axis.text(
        *(start + 1.12 * stroke),
        f"{patch.normal_force / KILONEWTON:.0f} kN",
        ha="center",
        va="bottom",
        zorder=9,
        fontweight="bold",
    )
