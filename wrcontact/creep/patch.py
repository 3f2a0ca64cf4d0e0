"""Patches whose creep forces can be asked for, and checks of what a user gives for them."""

from __future__ import annotations

from dataclasses import dataclass
from math import fsum, isfinite, pi
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike

from ..kernel.layout import SOLVED_STRIP_LIMIT


def check_number(name, value, unit, low, high):
    """Refuse what is not a number from ``low`` to ``high``."""
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    if not (isfinite(value) and low <= value <= high):
        behind = f" {unit}" if unit else ""
        raise ValueError(f"{name} is {value:.6g}{behind}; permitted are {low:g} to {high:g}{behind}")


def check_run(name, values, unit, count):
    """``values`` as a new array of finite numbers (n,), ``count`` of them if that is given."""
    try:
        array = np.array(values)
        if array.dtype.kind in "Ub":  # numpy takes texts and truth values for numbers
            raise TypeError
        array = array.astype(float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be numbers [{unit}], not {type(values).__name__}") from None
    if array.ndim != 1:
        raise ValueError(f"{name} has {array.ndim} dimensions; permitted is one")
    if count is not None and len(array) != count:
        raise ValueError(f"{name} has {len(array)} values, station has {count}; they must be as many")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} has a value that is not a finite number [{unit}]")
    return array


@dataclass(frozen=True, eq=False)
class CreepPatch:
    """A contact patch with its load, whose creep forces can be asked for; made by
    :func:`elliptic_patch`, :func:`outlined_patch` or :func:`patch_of`.

    Stations run to the field side; creepages hold for the centre of load.
    """

    ellipse: bool  #: whether it is Hertz's ellipse; else it has stations
    station: np.ndarray  #: from edge to edge (n,) [m]
    half_length: np.ndarray  #: of the patch at the stations (n,) [m]
    line_load: np.ndarray  #: load per width at the stations (n,) [N/m]
    normal_force: float  #: [N]
    slant: float  #: of the line through the strips' middles, dx/ds [-]
    youngs_modulus: float  #: of wheel and rail [Pa]
    poisson_ratio: float  #: [-]


def elliptic_patch(
    half_length: float,
    half_width: float,
    normal_force: float,
    youngs_modulus: float = 210e9,
    poisson_ratio: float = 0.28,
) -> CreepPatch:
    """Hertz's elliptic patch.

    Parameters
    ----------
    half_length, half_width : semi-axes along and across the rolling direction [m].
    normal_force : [N].
    youngs_modulus, poisson_ratio : of wheel and rail [Pa], [-].

    Raises
    ------
    ValueError
        where a number is out of its range, in a sentence.
    """
    check_number("half_length", half_length, "m", 1e-9, 1.0)
    check_number("half_width", half_width, "m", 1e-9, 1.0)
    check_number("normal_force", normal_force, "N", 0.0, 1e9)
    check_elasticity(youngs_modulus, poisson_ratio)
    edges = np.array([-half_width, 0.0, half_width])
    return CreepPatch(
        True,
        edges,
        np.array([0.0, half_length, 0.0]),
        np.array([0.0, 0.75 * normal_force / half_width, 0.0]),
        float(normal_force),
        0.0,
        float(youngs_modulus),
        float(poisson_ratio),
    )


def outlined_patch(
    station: ArrayLike,
    half_length: ArrayLike,
    pressure: ArrayLike,
    *,
    slant: float = 0.0,
    normal_force: float | None = None,
    youngs_modulus: float = 210e9,
    poisson_ratio: float = 0.28,
) -> CreepPatch:
    """A patch that is given by its outline.

    Parameters
    ----------
    station : rising stations from one edge of the patch to the other (n,), n >= 3 [m].
    half_length, pressure : half-length along the rolling direction [m] and pressure on the middle line [Pa]
        at the stations (n,); along the rolling direction the pressure falls like an ellipse.  Both are taken
        as zero at the first and the last station.
    slant : dx/ds of the line through the middles, of a yawed wheel [-].
    normal_force : [N]; the pressures are scaled so that they carry it.  None: as they are.
    youngs_modulus, poisson_ratio : of wheel and rail [Pa], [-].

    Raises
    ------
    ValueError
        where numbers do not fit each other or are out of their range, in a sentence.
    """
    station = check_run("station", station, "m", None)
    half_length = check_run("half_length", half_length, "m", len(station))
    pressure = check_run("pressure", pressure, "Pa", len(station))
    if not 3 <= len(station) <= SOLVED_STRIP_LIMIT:
        raise ValueError(f"station has {len(station)} values; permitted are 3 to {SOLVED_STRIP_LIMIT}")
    if (np.diff(station) <= 0.0).any():
        raise ValueError("station must rise from one value to the next")
    for name, values in (("half_length", half_length), ("pressure", pressure)):
        if (values < 0.0).any():
            raise ValueError(f"{name} has the value {values.min():.6g}; permitted are values from 0 on")
    check_number("slant", slant, "", -10.0, 10.0)
    check_elasticity(youngs_modulus, poisson_ratio)
    line_load = 0.5 * pi * half_length * pressure
    line_load[[0, -1]] = 0.0
    load = fsum(0.5 * (line_load[1:] + line_load[:-1]) * np.diff(station))
    if not load > 0.0:
        raise ValueError(
            "the outline carries no load; half_length and pressure must be above 0 at a station "
            "between the first and the last"
        )
    if normal_force is not None:
        check_number("normal_force", normal_force, "N", 0.0, 1e9)
        line_load, load = line_load * (normal_force / load), float(normal_force)
    return CreepPatch(
        False,
        station,
        half_length,
        line_load,
        float(load),
        float(slant),
        float(youngs_modulus),
        float(poisson_ratio),
    )


def check_elasticity(youngs_modulus, poisson_ratio):
    check_number("youngs_modulus", youngs_modulus, "Pa", 1e3, 1e15)
    check_number("poisson_ratio", poisson_ratio, "", 0.0, 0.5)
