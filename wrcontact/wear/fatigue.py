"""Rolling contact fatigue of each patch: T gamma damage, surface fatigue index, shakedown map.

Each patch of each row is one passage.  The functions take a state or a table of them; an FMU has some of
these numbers too, with the parameter fatigue_outputs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..conventions import SIDES
from ..interface.parameters import PARAMETERS
from ..kernel.layout import PATCH_LIMIT
from ..kernel.wheelset import fatigue as kernel
from ..methods.numbers import check_choice
from ..results.words import ShortText
from ..state import WheelsetState
from ..wheel import WheelState
from .rows import prefixes_of

#: Breakpoints of the T gamma damage [N], and lines between them: (slope [1/N], constant).
BREAKS = (kernel.FIRST_BREAK, kernel.LARGEST, 175.0)
RISE, FALL = (kernel.RISE, kernel.RISE_CONSTANT), (kernel.FALL, kernel.FALL_CONSTANT)
DIRECTIONS = ("both", "driven", "braked")
#: That of the parameter of FMUs [Pa].
YIELD_SHEAR = PARAMETERS["yield_shear"].default
#: Outputs of a patch that are read.
READ = (
    "normal_force",
    "area",
    "length",
    "width",
    "max_pressure",
    "creepage.x",
    "creepage.y",
    "tangential.x",
    "tangential.y",
)
#: Points along and below a line contact, in half its length, for the shakedown limit.
ALONG, BELOW = np.linspace(-3.0, 3.0, 601), np.linspace(0.005, 1.5, 300)


@dataclass(frozen=True, repr=False)
class Fatigue(ShortText):
    """Fatigue of the patches of a table; arrays (n, 2, 3): row, side (left, right), patch; of one wheel
    (n, 3): row, patch.  NaN where there is no patch.

    Attributes
    ----------
    wear_number : T gamma = abs(F_x xi) + abs(F_y eta), without spin [N].
    damage : T gamma damage of a passage [1]; 1 begins a crack.
    utilised_friction : creep force over normal force [1].
    mean_peak : 3 N / (2 A) [Pa], p0 of an ellipse with this area.
    shakedown_ratio : that over the yield stress in shear [1].
    surface_fatigue_index : utilised friction minus 1 / shakedown_ratio [1]; above 0 the surface yields.
    peak_index : the same with the largest pressure of the patch instead.
    surface_damage : of a passage [1]; NaN without ``surface_life``.
    subsurface_stress : N / (4 pi a b) (1 + friction^2) [Pa], first term of the subsurface index.
    wheel_place, rail_place : centre of friction on the profiles [m]; NaN without outputs of wear.
    """

    wear_number: np.ndarray
    damage: np.ndarray
    utilised_friction: np.ndarray
    mean_peak: np.ndarray
    shakedown_ratio: np.ndarray
    surface_fatigue_index: np.ndarray
    peak_index: np.ndarray
    surface_damage: np.ndarray
    subsurface_stress: np.ndarray
    wheel_place: np.ndarray
    rail_place: np.ndarray

    @property
    def sides(self):
        """The sides that the arrays have, ("left", "right"); (None,) of one wheel."""
        return SIDES if self.damage.ndim == 3 else (None,)

    def of_side(self, name, side=None):
        """An array (n, 3) of one side; None is the right one, or the only wheel."""
        values = getattr(self, name)
        if values.ndim == 3:
            side = "right" if side is None else side
            check_choice("side", side, SIDES)
            return values[:, SIDES.index(side)]
        if side is not None:
            raise ValueError(f"side is {side!r}; it cannot be given for one wheel")
        return values

    def histogram(self, name, part="rail", side=None, width=1e-3, weights=None):
        """Places [m] of bins, and the sums over rows of ``name``, such as "damage", in each.

        Parameters
        ----------
        part, side : "wheel" or "rail", "left" or "right"; None is "right", or the only wheel.
        width : of a bin [m].
        weights : (n,) passages of each row; None is one each.
        """
        check_choice("part", part, ("wheel", "rail"))
        check_choice("name", name, tuple(vars(self)))
        place, value = self.of_side(f"{part}_place", side), self.of_side(name, side)
        if weights is not None:
            weights = np.asarray(weights, dtype=float)
            if weights.shape != value.shape[:1]:
                raise ValueError(
                    f"weights has the shape {weights.shape}; permitted is one for each of the {len(value)} "
                    "rows"
                )
            value = value * weights[:, None]
        there = np.isfinite(place) & np.isfinite(value)
        if not np.any(there):
            raise ValueError("there are no places of patches; permitted are tables with wear_outputs=True")
        first, last = np.floor(np.min(place[there]) / width), np.ceil(np.max(place[there]) / width)
        edges = width * np.arange(first, max(last, first + 1) + 1)
        sums, _ = np.histogram(place[there], edges, weights=value[there])
        return 0.5 * (edges[1:] + edges[:-1]), sums


def fatigue(
    table: WheelsetState[Any, Any, Any] | WheelState[Any, Any, Any],
    *,
    yield_shear: float = YIELD_SHEAR,
    direction: str = "both",
    damage: Callable[[NDArray[Any]], NDArray[Any]] | None = None,
    surface_life: tuple[float, float] | None = None,
) -> Fatigue:
    """The :class:`Fatigue` of each patch of a state or a table with creep forces, of a wheelset or of one
    wheel.

    Parameters
    ----------
    yield_shear : yield stress in cyclic shear k [Pa].  The default is often used for rails, but no source of
        it was read: give that of your steel.
    direction : which traction damages the rail: "both", or that of "driven" or of "braked" wheels alone.
    damage : function of T gamma [N] that returns the damage; None is :func:`wear_number_damage`.
    surface_life : None, or (cycles, exponent) of N_f = cycles FI^-exponent, for ``surface_damage``.

    Raises
    ------
    ValueError
        without creep forces, or if an argument is not permitted.

    >>> import wrcontact
    >>> system = wrcontact.ContactSystem(tangential_model="strips")
    >>> found = wrcontact.fatigue(system.evaluate(6e-3, yaw=5e-3, speed=20.0), yield_shear=300e6)
    >>> found.damage.shape, bool(found.wear_number[0, 1, 0] > 100.0)
    ((1, 2, 3), True)
    """
    if not isinstance(table, (WheelsetState, WheelState)):
        raise ValueError(
            f"table is {type(table).__name__}; permitted is what evaluate or evaluate_many returns"
        )
    if not (isinstance(yield_shear, Real) and yield_shear > 0.0):
        raise ValueError(f"yield_shear is {yield_shear!r}; permitted is yield_shear > 0 Pa")
    check_choice("direction", direction, DIRECTIONS)
    table, one = table._as_table(), isinstance(table, WheelState)
    prefixes = prefixes_of(table.side if one else None)
    read = {name: _patches(table, prefixes, name) for name in READ}
    if not np.nansum(np.abs(read["tangential.x"]) + np.abs(read["tangential.y"])) > 0.0:
        raise ValueError('the table has no creep forces; fatigue needs tangential_model="strips" and a speed')
    there = (read["area"] > 0.0) & (read["max_pressure"] > 0.0) & (read["width"] > 0.0)
    read = {name: np.where(there, values, np.nan) for name, values in read.items()}
    found = indices(read, yield_shear, damage or wear_number_damage, surface_life)
    # a wheel that is driven is pushed forward by the rail
    counts = {
        "both": np.isfinite(found.damage),
        "driven": read["tangential.x"] > 0.0,
        "braked": read["tangential.x"] < 0.0,
    }[direction]
    found = replace(found, damage=np.where(there, np.where(counts, found.damage, 0.0), np.nan))
    places = _places([table] if one else [table.left, table.right])
    found = replace(found, **{name: np.where(there, values, np.nan) for name, values in places.items()})
    return replace(found, **{name: values[:, 0] for name, values in vars(found).items()}) if one else found


def indices(read, yield_shear, damage, surface_life):
    """The :class:`Fatigue` of patches of which these outputs are given by name, arrays of one shape."""
    load, area, peak = read["normal_force"], read["area"], read["max_pressure"]
    along, across = read["tangential.x"], read["tangential.y"]
    number = np.abs(along * read["creepage.x"]) + np.abs(across * read["creepage.y"])
    used, mean_peak = np.hypot(along, across) / load, 1.5 * load / area
    index = used - yield_shear / mean_peak
    life = np.full(index.shape, np.nan)
    if surface_life is not None:
        cycles, exponent = surface_life
        life = np.where(np.isnan(index), np.nan, np.maximum(index, 0.0) ** exponent / cycles)
    below = load / (np.pi * read["length"] * read["width"]) * (1.0 + used**2)  # a b = length width / 4
    nowhere = np.full(index.shape, np.nan)
    return Fatigue(
        number,
        damage(number),
        used,
        mean_peak,
        mean_peak / yield_shear,
        index,
        used - yield_shear / peak,
        life,
        below,
        nowhere,
        nowhere,
    )


def wear_number_damage(wear_number, breaks=BREAKS):
    """T gamma damage of a rail for a passage [1], 1 begins a crack.

    Zero up to 20 N, 2.22e-7 T gamma - 4.44e-6 up to 65 N, 1.59e-5 - 9.09e-8 T gamma up to 175 N, and zero
    beyond, where wear removes cracks.  Read in a public implementation of a model of head checks.  Burstow's
    form begins at 15 N; that source was not read.  Other ``breaks`` [N] keep the largest damage, at the
    second.

    >>> float(wear_number_damage(40.0)), float(wear_number_damage(300.0))
    (4.44e-06, 0.0)
    """
    number = np.asarray(wear_number, dtype=float)
    low, middle, high = breaks
    if not 0.0 <= low < middle < high:
        raise ValueError(f"breaks are {breaks!r}; permitted are three rising numbers [N]")
    if tuple(breaks) == BREAKS:
        rise, fall = RISE[0] * number + RISE[1], FALL[0] * number + FALL[1]
    else:
        top = RISE[0] * BREAKS[1] + RISE[1]
        rise, fall = top * (number - low) / (middle - low), top * (high - number) / (high - middle)
    found = np.where(number < low, 0.0, np.where(number < middle, rise, np.where(number < high, fall, 0.0)))
    return np.where(np.isnan(number), np.nan, np.maximum(found, 0.0))[()]


def shakedown_limit(friction):
    """p0 / k up to which a line contact shakes down, for each utilised ``friction`` [1].

    By Melan's theorem residual stresses can take everything but the shear stress along the surface, so that
    p0 / k is 1 over its largest value, for p0 = 1, under p = sqrt(1 - x^2) with the traction friction p
    (Johnson, Contact Mechanics, 1985, section 9.2).  It is 4 without friction, and 1 / friction where the
    surface yields, beyond about 0.37.

    >>> import numpy as np
    >>> np.round(shakedown_limit([0.0, 0.5]), 3).tolist()
    [4.0, 2.0]
    """
    friction = np.asarray(friction, dtype=float)
    normal, tangential = line_shear(*np.meshgrid(ALONG, BELOW))
    flat = np.abs(friction).reshape(-1)
    largest = [max(mu, float(np.max(np.abs(normal + mu * tangential)))) for mu in flat]
    return (1.0 / np.array(largest)).reshape(friction.shape)[()]


def line_shear(x, z):
    """Shear stress tau_xz over p0 at ``x``, ``z`` [half-lengths] below a line contact: of the pressure
    sqrt(1 - x^2), and of a traction of the same form.

    With w = x + iz, the integral of the pressure over w - s is pi (w - sqrt(w^2 - 1)), and Johnson's (2.23)
    are its imaginary part and derivative.
    """
    w = x + 1j * z
    root = np.sqrt(w - 1.0) * np.sqrt(w + 1.0)  # tends to w far away
    slope = 1.0 - w / root
    return -z * slope.imag, (w - root).imag + z * slope.real


def _patches(table, prefixes, name):
    """An output of every patch, (n, sides, 3)."""
    return np.stack(
        [[table[f"{prefix}patch[{k + 1}].{name}"] for k in range(PATCH_LIMIT)] for prefix in prefixes]
    ).transpose(2, 0, 1)


def _places(sides):
    """Centres of friction (n, sides, 3) on both profiles; empty without outputs of wear."""
    found = {"wheel_place": [], "rail_place": []}
    try:
        sides = [side.strips for side in sides]
    except AttributeError:
        return {}
    for name, values in found.items():
        for strips in sides:
            weights = [strip.power * strip.width + 1e-300 * strip.width for strip in strips]
            values.append(
                [
                    np.sum(getattr(strip, name) * weight, axis=1) / np.maximum(np.sum(weight, axis=1), 1e-320)
                    for strip, weight in zip(strips, weights)
                ]
            )
    return {name: np.array(values).transpose(2, 0, 1) for name, values in found.items()}
