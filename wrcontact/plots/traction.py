"""Tractions within a patch of a wheelset that rolls, by the complete theory."""

from dataclasses import dataclass

import numpy as np

from ..creep.results import patch_of
from ..halfspace.rolling import Outline, roll_outline
from ..profiles.placement import readable_wheel
from .geometry import POINTS
from .patch import fine_outline, of_one_pose, patch_places


@dataclass(frozen=True)
class PatchTractions:
    """Tractions on the wheel in one patch, on cells: arrays (rows, columns).

    Attributes
    ----------
    station, along : middles of the cells across, to the field side, and along the track, both from the
        contact point [m].
    pressure : mean over a cell [Pa].
    shear_x, shear_y : traction forwards and to the field side [Pa].
    slips : whether friction is used up.
    cover : share of a cell that lies in the patch.
    friction : coefficient of friction.
    cell_area : [m2].
    """

    station: np.ndarray
    along: np.ndarray
    pressure: np.ndarray
    shear_x: np.ndarray
    shear_y: np.ndarray
    slips: np.ndarray
    cover: np.ndarray
    friction: float
    cell_area: float


@of_one_pose()
def patch_tractions(system, state, side="right", number=0):
    """Tractions of one patch of a wheelset that rolls, by Kalker's complete theory.

    A state knows force, moment and stick share of a patch, and its shear stress at the stations, as a mean
    along the rolling direction.  How the tractions are distributed along it is therefore computed here:
    steady rolling on the half-space (docs/theory/rolling.md), on the outline of the state, whose pressure is
    a half-ellipse along each station, with the lateral creepage and the spin of the patch, the longitudinal
    creepage of each row's own rolling radius, and the friction that the state has used.  So the sum of the
    tractions differs from the creep force of the state as its model differs from the complete theory.

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem`.
    state : of one pose.
    side : "right" or "left".
    number : place among the patches by falling load, from 0.

    Returns
    -------
    PatchTractions

    Raises
    ------
    ValueError
        in a sentence, where the patch has no creep force or the wheelset rolls backwards.
    """
    material = {name: system.parameters[name] for name in ("youngs_modulus", "poisson_ratio")}
    rolling, creepages = patch_of(state, side, number, **material)
    patch = getattr(state, side).patches[number]
    force = np.hypot(patch.tangential.x, patch.tangential.y)
    if not (force > 0.0 and patch.saturation > 0.0):
        raise ValueError(
            f"patch {number} of the {side} wheel has no creep force; it needs a system with "
            "tangential_model, and speed or wheel_rate"
        )
    if state.inputs.speed < 0.0:
        raise ValueError(
            f"speed is {state.inputs.speed:g} m/s; tractions are drawn of a wheelset that rolls forwards"
        )
    friction = force / (patch.saturation * patch.normal_force)
    outline, middle, ahead = _around_load(rolling, patch_line(system, state, side, rolling.station))
    radius = radii_at(system, state, side, rolling.station)
    # of each row, with its own rolling radius, beside that of spin
    creepages["creepage_x"] = (
        1.0
        - (1.0 - creepages["creepage_x"]) * radius / patch.rolling_radius
        + creepages["spin"] * outline.station
    )
    found = roll_outline(
        outline,
        **creepages,
        friction=friction,
        poisson_ratio=rolling.poisson_ratio,
        shear_modulus=rolling.youngs_modulus / (2 * (1 + rolling.poisson_ratio)),
    ).fine
    field = found.field
    along, station = np.meshgrid(field.x + ahead, field.y + middle)
    return PatchTractions(
        station, along, field.pressure, *found.tractions, found.slips, field.cover, friction, field.cell_area
    )


def radii_at(system, state, side, station):
    """Rolling radii [m] of a wheel at stations of its outline (n,): they are arc lengths from the contact
    point."""
    wheel = readable_wheel(system.wheel if side == "right" else system.left_wheel)
    reach = 2.0 * np.max(np.abs(station))
    contact = getattr(state, side).contact.y_wheel
    y = np.linspace(max(contact - reach, wheel.start), min(contact + reach, wheel.stop), POINTS)
    z = wheel.height(y)
    length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    length -= np.interp(contact, y, length)
    return system.side_parameters(side)["nominal_radius"] + np.interp(station, length, z)


def patch_line(system, state, side, station):
    """Where the middles of a wheel's patches lie along the track at stations (n,), from the contact point
    [m]."""
    return np.interp(
        station, fine_outline(getattr(state, side).outline)[0], patch_places(system, state, side)
    )


def _around_load(rolling, places):
    """The outline of a :class:`~wrcontact.CreepPatch` around its centre of load, and the station of that
    and its place along the track [m]; ``places`` are those of its stations."""
    station, line, length = rolling.station, rolling.line_load, rolling.half_length
    middle, ahead = (
        np.trapezoid(line * each, station) / np.trapezoid(line, station) for each in (station, places)
    )
    pressure = np.divide(line, 0.5 * np.pi * length, out=np.zeros_like(line), where=length > 0.0)
    return Outline.of_stations(station - middle, length, pressure, places - ahead), middle, ahead
