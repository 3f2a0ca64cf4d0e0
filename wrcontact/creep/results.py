"""A patch of a wheelset's result, and its creepages, for :func:`creep_forces`."""

from typing import TYPE_CHECKING

import numpy as np

from ..results.layout import SIDE_STARTS
from ..state import Patch, Side
from .patch import CreepPatch, check_number, outlined_patch

if TYPE_CHECKING:
    from ..state import WheelsetState


def patch_of(
    state: "WheelsetState",
    side: str,
    number: int = 0,
    *,
    slant: float = 0.0,
    youngs_modulus: float = 210e9,
    poisson_ratio: float = 0.28,
) -> tuple[CreepPatch, dict[str, float]]:
    """Patch and creepages of a result.

    The patch has the outline's stations, its own load and its own width.  The result does not say how the
    patch of a yawed wheel is slanted, nor of which material wheel and rail are; both are given here.

    Parameters
    ----------
    state : :class:`~wrcontact.WheelsetState` of one pose.
    side : "left" or "right".
    number : place among the patches by falling load, from 0.
    slant : dx/ds of the line through the middles of the patch's strips [-].
    youngs_modulus, poisson_ratio : of wheel and rail [Pa], [-].

    Returns
    -------
    patch : :class:`CreepPatch`.
    creepages : ``creepage_x``, ``creepage_y`` and ``spin`` as keywords of :func:`creep_forces`: in results y
        is to the left and the normal upwards on both sides, here y is to the field side.

    Raises
    ------
    ValueError
        where there is no such patch, in a sentence.
    """
    if side not in ("left", "right"):
        raise ValueError(f"side is {side!r}; permitted are 'left' and 'right'")
    if state.values.ndim != 1:
        raise ValueError("state has many poses; permitted is that of one pose, such as state[0]")
    wheel = getattr(state, side)
    check_number("number", number, "", 0, 2)
    if number >= len(wheel.patches):
        raise ValueError(f"number is {number}; the {side} wheel has {len(wheel.patches)} patches")
    patch = wheel.patches[number]
    rolling = rolling_patch(patch, slant=slant, youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio)
    to_field = -1.0 if side == "right" else 1.0
    return rolling, {
        "creepage_x": patch.creepage.x,
        "creepage_y": to_field * patch.creepage.y,
        "spin": to_field * patch.creepage.spin,
    }


def rolling_patch(patch: Patch, **more) -> CreepPatch:
    """The :class:`CreepPatch` of a ``patch`` of a result, with the stations of its wheel's outline."""
    values, place = patch._values, patch._offset
    if values.ndim != 1:
        raise ValueError(
            "patch has many poses; permitted is that of one pose, such as table[0].right.patches[0]"
        )
    outline = Side(
        values, max(first for first in SIDE_STARTS.values() if first <= place), patch.layout
    ).outline
    station, half_length, pressure = own_outline(
        patch, *(np.asarray(run) for run in (outline.station, outline.half_length, outline.pressure))
    )
    return outlined_patch(station, half_length, pressure, normal_force=patch.normal_force, **more)


def own_outline(patch, station, half_length, pressure):
    """Stations, half-lengths and pressures (n,) of one patch from its wheel's outline.

    The patch is the loaded run around its centroid.  Where the run ends with the outline, that is its edge;
    the other edge follows from its width, or, between two other patches, both from its middle.
    """
    loaded = pressure > 0.0
    if not loaded.any():
        raise ValueError("the result has no outline with loaded stations")
    nearest = np.flatnonzero(loaded)[np.argmin(np.abs(station[loaded] - patch.centroid))]
    first = last = nearest
    while first > 0 and loaded[first - 1]:
        first -= 1
    while last < len(station) - 1 and loaded[last + 1]:
        last += 1
    before, after = station[max(first - 1, 0)], station[min(last + 1, len(station) - 1)]
    if first <= 1:
        start, stop = before, before + patch.width
    elif last >= len(station) - 2:
        start, stop = after - patch.width, after
    else:
        start, stop = 0.5 * (before + after) + np.array([-0.5, 0.5]) * patch.width
    run = np.arange(first, last + 1)
    run = run[(station[run] > start) & (station[run] < stop)]
    if len(run) == 0:
        raise ValueError("the outline has no station within the patch; more stations show its shape")
    ends = np.concatenate([[start], station[run], [stop]])
    return ends, np.pad(half_length[run], 1), np.pad(pressure[run], 1)
