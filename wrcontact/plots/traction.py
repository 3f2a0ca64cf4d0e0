"""Tractions within a patch of a wheelset that rolls, by the complete theory."""

from dataclasses import dataclass

import numpy as np

from ..creep.results import patch_of
from ..halfspace.rolling import Outline, roll_outline
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
    steady rolling on the half-space (docs/rolling.md), on the outline of the state, whose pressure is a
    half-ellipse along each station, with the creepages and the spin of the patch as those of one plane, and
    the friction that the state has used.  So the sum of the tractions differs from the creep force of the
    state as its model differs from the complete theory.

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
    load = np.trapezoid(rolling.line_load, rolling.station)
    middle = np.trapezoid(rolling.line_load * rolling.station, rolling.station) / load
    places = np.interp(
        rolling.station, fine_outline(getattr(state, side).outline)[0], patch_places(system, state, side)
    )
    ahead = np.trapezoid(rolling.line_load * places, rolling.station) / load
    largest = np.divide(
        rolling.line_load,
        0.5 * np.pi * rolling.half_length,
        out=np.zeros_like(places),
        where=rolling.half_length > 0.0,
    )
    outline = Outline.of_stations(rolling.station - middle, rolling.half_length, largest, places - ahead)
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


