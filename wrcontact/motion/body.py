"""Pose and rates of a wheelset from those of a body that spins, and how they follow it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..interface.parameters import PARAMETERS

#: How far the length of the axle's direction may be from 1.
UNIT = 1e-6


def motion_of(
    position: ArrayLike,
    rotation: ArrayLike,
    velocity: ArrayLike,
    angular_velocity: ArrayLike,
    lateral: float = 0.0,
    *,
    nominal_radius: float | None = None,
) -> dict[str, float]:
    """The inputs of a wheelset that is a spinning body: yaw, roll, their rates, the rotation of its wheels.

    The axle has the direction ``e = R e_2``, the second column of the rotation matrix, and moves as
    ``de/dt = w x e`` with the angular velocity w.  With R = Rz(yaw) Rx(roll) Ry(spin) it is
    ``(-sin yaw cos roll, cos yaw cos roll, sin roll)``, and ``w = yaw_rate e_z + roll_rate e_ahead -
    wheel_rate e``, so that

        yaw = atan2(-e_x, e_y),                     roll = asin e_z
        yaw_rate = (e_x de_y - e_y de_x) / (e_x^2 + e_y^2),   roll_rate = de_z / cos roll
        wheel_rate = yaw_rate e_z - w . e

    All is in the axes of the track frame, x forward, y to the right, z down (docs/reference/conventions.md).

    Parameters
    ----------
    position : (3,) of the wheelset's centre [m] from the track's centre at the running surface: a wheelset
        that stands has z near minus its nominal radius.  x is not read.
    rotation : (3, 3), whose columns are the body's axes; the second is the axle, to the right.
    velocity : (3,) of the centre against the ground [m/s], with the speed along the track.
    angular_velocity : (3,) of the body [rad/s]; in a curve without the rotation of the track.
    lateral : displacement of both rails to the right [m], such as an irregularity of the track.
    nominal_radius : of the wheels [m]; None is the default of :class:`~wrcontact.ContactSystem`, and
        ``system.centre_height`` that of a system.

    Returns
    -------
    dict
        keyword inputs of :meth:`~wrcontact.ContactSystem.evaluate`, for contact_mode "compliant";
        ``wheel_rate`` holds as it is, also where it is 0.

    Raises
    ------
    ValueError
        if an array has another shape, or the axle's direction is no unit vector.

    Examples
    --------
    >>> import numpy as np
    >>> motion = motion_of([0, 1e-3, -0.46], np.eye(3), [20, 0, 0], [0, -20 / 0.46, 0])
    >>> motion["lateral_shift"], motion["yaw"], round(motion["wheel_rate"], 3)
    (0.001, 0.0, 43.478)
    """
    radius = PARAMETERS["nominal_radius"].default if nominal_radius is None else nominal_radius
    _, y, z = _three("position", position)
    speed, lateral_velocity, vertical_velocity = _three("velocity", velocity)
    turn_x, turn_y, turn_z = _three("angular_velocity", angular_velocity)
    e_x, e_y, e_z = _axle(rotation)
    d_x, d_y, d_z = turn_y * e_z - turn_z * e_y, turn_z * e_x - turn_x * e_z, turn_x * e_y - turn_y * e_x
    flat = e_x * e_x + e_y * e_y
    yaw_rate = (e_x * d_y - e_y * d_x) / flat
    return {
        "lateral_shift": y,
        "yaw": math.atan2(-e_x, e_y) + 0.0,
        "vertical_shift_input": z + radius,
        "roll_input": math.atan2(e_z, math.sqrt(flat)),
        "speed": speed,
        "lateral_velocity": lateral_velocity,
        "vertical_velocity": vertical_velocity,
        "yaw_rate": yaw_rate,
        "roll_rate": d_z / math.sqrt(flat),
        "wheel_rate": yaw_rate * e_z - (turn_x * e_x + turn_y * e_y + turn_z * e_z),
        "free_rolling": False,
        "left_rail_lateral": lateral,
        "right_rail_lateral": lateral,
    }


def motion_jacobian(rotation: ArrayLike, angular_velocity: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """How the inputs of :func:`motion_of` follow the body: the derivatives that an implicit solver needs.

    With the derivatives of a force by these inputs, those by the body are their product::

        by = motion_jacobian(rotation, angular_velocity)
        slopes = stepper.derivatives(of=["force.y"], by=list(by)) @ np.array(list(by.values()))  # (1, 12)

    A small rotation phi turns the axle by ``phi x e``, an angular velocity moves it by ``w x e``; the rest is
    the chain rule on the formulas of :func:`motion_of`.

    Parameters
    ----------
    rotation : (3, 3) as for :func:`motion_of`.
    angular_velocity : (3,) [rad/s] likewise; position and velocity do not enter.

    Returns
    -------
    dict
        by the name of an input, an array (12,) of its derivatives by small changes of the body, all in the
        axes of the track: displacement (3) [m], rotation (3) [rad], velocity (3) [m/s] and angular velocity
        (3) [rad/s].  For rotations about the body's own axes multiply columns 3 to 5 by ``rotation`` from
        the right.

    Raises
    ------
    ValueError
        as :func:`motion_of`.

    Examples
    --------
    >>> rows = motion_jacobian(np.eye(3), [0, -43.5, 0])
    >>> rows["yaw"].round(3).tolist()[3:6], rows["wheel_rate"].round(3).tolist()[9:]
    ([0.0, 0.0, 1.0], [0.0, -1.0, 0.0])
    """
    e, w = np.array(_axle(rotation)), np.array(_three("angular_velocity", angular_velocity))
    unit = np.eye(12)
    moved, turned, sped, spun = unit[0:3], unit[3:6], unit[6:9], unit[9:12]
    # of the axle (3, 12), and of its velocity d
    axle = np.cross(turned, e, axis=0)
    d = np.cross(w, e)
    rate = np.cross(w[:, None], axle, axis=0) + np.cross(spun, e, axis=0)
    flat = e[0] ** 2 + e[1] ** 2
    flatter = 2.0 * (e[0] * axle[0] + e[1] * axle[1])
    yaw_rate = (e[0] * d[1] - e[1] * d[0]) / flat
    yaw_rates = (
        d[1] * axle[0] - d[0] * axle[1] + e[0] * rate[1] - e[1] * rate[0] - yaw_rate * flatter
    ) / flat
    return {
        "lateral_shift": moved[1],
        "yaw": (e[0] * axle[1] - e[1] * axle[0]) / flat,
        "vertical_shift_input": moved[2],
        "roll_input": axle[2] / math.sqrt(flat),
        "speed": sped[0],
        "lateral_velocity": sped[1],
        "vertical_velocity": sped[2],
        "yaw_rate": yaw_rates,
        "roll_rate": rate[2] / math.sqrt(flat) - 0.5 * d[2] * flatter / flat**1.5,
        "wheel_rate": yaw_rates * e[2] + yaw_rate * axle[2] - e @ spun - w @ axle,
    }


def _three(name, values):
    """Three floats."""
    try:
        x, y, z = values
        return float(x), float(y), float(z)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {values!r}; permitted are three numbers") from None


def _axle(rotation):
    """Direction of the axle, the second column of a rotation matrix."""
    try:
        (_, x, _), (_, y, _), (_, z, _) = rotation
        x, y, z = float(x), float(y), float(z)
    except (TypeError, ValueError):
        raise ValueError(
            f"rotation is {rotation!r}; permitted is a matrix of 3 x 3 numbers, whose columns "
            "are the body's axes"
        ) from None
    if not abs(x * x + y * y + z * z - 1.0) < UNIT:
        raise ValueError(
            f"the second column of rotation, the axle, has the length "
            f"{math.sqrt(x * x + y * y + z * z):g}; permitted is a rotation matrix, whose "
            "columns have the length 1"
        )
    if x * x + y * y < UNIT:
        raise ValueError("the second column of rotation, the axle, is vertical; it points to the right")
    return x, y, z
