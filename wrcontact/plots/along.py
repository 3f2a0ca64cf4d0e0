"""A wheelset on rails whose section changes, along the track, or on wheels that are not round, over their rotation: height,
places of contact, loads and pressures."""

import numpy as np

from ..profiles.changing import is_sections
from .style import KILONEWTON, MEGAPASCAL, MM, QUIET, SIDE_COLOUR, new_figure, styled

SIZE = 7.2, 8.2  # [in]
#: Positions of the wheelset by default.
POSITIONS = 241
#: And its rotations.
TURNS = 721


@styled
def along_track_figure(system, track_position=None, **inputs):
    """How a wheelset stands and is loaded at positions along the track, one pose after the other.

    Five panels share the position: height of the wheelset's centre, lateral places of contact on both rails, normal force of
    every patch, force of each rail along the track, and largest pressure. Where a wheelset has no result the lines have a gap; in
    a panel without a line nothing is loaded.

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem` of which a rail changes along the track.
    track_position : rising (n,) [m]; None is from the first slice to the last one of both rails.
    inputs : others of ``evaluate``, numbers or arrays (n,).

    Returns
    -------
    figure
    """
    if not (is_sections(system.rail) or is_sections(system.left_rail)):
        raise ValueError(
            f"system has the rails {system.left_rail.name!r} and {system.rail.name!r}, which are the same all along the track; "
            "permitted is one with RailSections"
        )
    u = slices_of(system) if track_position is None else np.asarray(track_position, dtype=float)
    table = system.evaluate_many(track_position=u, **inputs)
    return _drawn(system, table, u, "position of the wheelset along the track [m]")


@styled
def around_wheel_figure(system, wheel_rotation=None, **inputs):
    """How a wheelset whose wheels are not round stands and is loaded as it turns, one pose after the other: the panels of
    :func:`along_track_figure` over the rotation in degrees.

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem` of which a wheel is :class:`~wrcontact.WheelSections`.
    wheel_rotation : rising (n,) [rad]; None is one turn.
    inputs : others of ``evaluate``, numbers or arrays (n,).

    Returns
    -------
    figure
    """
    if not (is_sections(system.wheel) or is_sections(system.left_wheel)):
        raise ValueError(
            f"system has the wheels {system.left_wheel.name!r} and {system.wheel.name!r}, which are round; permitted is one with "
            "WheelSections"
        )
    turn = (
        np.linspace(-np.pi, np.pi, TURNS)
        if wheel_rotation is None
        else np.asarray(wheel_rotation, dtype=float)
    )
    table = system.evaluate_many(wheel_rotation=turn, **inputs)
    return _drawn(system, table, np.degrees(turn), "rotation of the wheelset about its axle [deg]")


def _drawn(system, table, u, words_below):
    """The figure of a ``table`` of poses over ``u`` (n,)."""
    figure = new_figure(*SIZE)
    panels = figure.subplots(5, 1, sharex=True)
    for axis, name in zip(panels, ("height", "contacts", "loads", "forces", "pressures")):
        axis.set_label(name)
    panels[0].plot(u, -table.vertical_shift / MM, color="black", linewidth=1.2)
    for side, colour in SIDE_COLOUR.items():
        wheel = getattr(table, side)
        panels[1].plot(u, wheel.contact.y_rail / MM, ".", markersize=2.5, color=colour, label=f"{side} wheel")
        for k, patch in enumerate(wheel.patches):
            loaded = np.where(patch.normal_force > 0.0, patch.normal_force, np.nan)
            words = f"{side} wheel, patch by patch" if k == 0 else None
            panels[2].plot(u, loaded / KILONEWTON, color=colour, linewidth=1.2, label=words)
        panels[3].plot(u, wheel.force.x / KILONEWTON, color=colour, linewidth=1.2)
        panels[4].plot(u, wheel.max_pressure / MEGAPASCAL, color=colour, linewidth=1.2, label=f"{side} wheel")
    for axis, words in zip(
        panels,
        (
            "height, up +\n[mm]",
            "place on the rail,\nfield side + [mm]",
            "normal force\n[kN]",
            "force along\nthe track [kN]",
            "largest pressure\n[MPa]",
        ),
    ):
        axis.set_ylabel(words)
    panels[2].set_ylim(bottom=0.0)
    panels[3].axhline(0.0, color=QUIET, linewidth=0.6)
    panels[1].legend(loc="best", fontsize=7)
    panels[2].legend(loc="best", fontsize=7)
    panels[4].set_xlabel(words_below)
    figure.suptitle(system.title, fontsize=10)
    return figure


def slices_of(system):
    """Positions along the track from the first slice to the last one of the rails that change (POSITIONS,) [m]."""
    ends = [
        placed.surface.positions[[0, -1]]
        for placed, rail in zip(system.placed_rails, (system.left_rail, system.rail))
        if is_sections(rail)
    ]
    return np.linspace(np.min(ends), np.max(ends), POSITIONS)
