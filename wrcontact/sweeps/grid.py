"""The grid of a sweep: its axes, the inputs that are fixed, and its blocks.

Axes and fixed inputs have the names of Python's keywords, ``left_friction``; those of an FMU,
``left.friction``, mean the same.
"""

import math

import numpy as np

from ..interface.calls import checked_input, unknown_input
from ..interface.index import PLACES, keyword_of, row_of
from ..methods.numbers import unit_behind
from ..methods.words import did_you_mean
from ..results.words import short


def checked_axes(axes):
    """The ``axes`` {name: numbers} as {keyword: array (n,)}, in their order.

    Raises
    ------
    ValueError
        if one is no input, or its values are no numbers that rise or fall from one to the next.
    """
    if not isinstance(axes, dict) or not axes:
        raise ValueError(
            f"axes is {axes!r}; permitted is a dict of inputs, {{'lateral_shift': array, 'yaw': array}}"
        )
    found = {}
    for name, values in axes.items():
        keyword = keyword_of(name)
        if keyword is None:
            raise ValueError(
                f"axes has {name!r}; permitted are names of inputs, such as 'lateral_shift', "
                f"'yaw' and 'left_friction'{did_you_mean(name, PLACES)}"
            )
        if keyword in found:
            raise ValueError(f"axes has {keyword!r} twice; permitted is each input once")
        found[keyword] = _axis(keyword, values)
    return found


def _axis(keyword, values):
    """The values (n,) of one axis."""
    checked_input(PLACES[keyword], values)
    values, unit = np.array(values, dtype=float), unit_behind(row_of(keyword).unit)
    if values.ndim != 1 or not values.size:
        raise ValueError(
            f"the axis {keyword} has the shape {values.shape}; permitted is an array (n,), n > 0"
        )
    if not np.all(np.isfinite(values)):
        raise ValueError(
            f"the axis {keyword} has {values[~np.isfinite(values)][0]}; permitted are finite numbers"
        )
    steps = np.diff(values)
    if not (np.all(steps > 0.0) or np.all(steps < 0.0)):
        wrong = int(np.argmax(steps * (values[-1] - values[0]) <= 0.0))
        raise ValueError(
            f"the axis {keyword} has {values[wrong]:g}{unit} before {values[wrong + 1]:g}{unit}"
            "; permitted are values that all rise, or all fall"
        )
    return values


def checked_inputs(fixed, axes):
    """The ``fixed`` inputs {name: number} beside ``axes`` as {keyword: float}; those at their defaults, which
    change nothing, are left out.

    Raises
    ------
    TypeError
        if there is no such input.
    ValueError
        if it is an axis, too, or not one finite number.
    """
    found = {}
    for name, value in fixed.items():
        keyword = keyword_of(name)
        if keyword is None:
            raise unknown_input(name)
        if keyword in axes or keyword in found:
            raise ValueError(
                f"{keyword} is given twice{', as an axis and as a number' * (keyword in axes)}; "
                "permitted is one of the two"
            )
        checked_input(PLACES[keyword], value)
        if np.ndim(value):
            raise ValueError(
                f"{keyword} has the shape {np.shape(value)}; permitted is one number; arrays are axes"
            )
        if not math.isfinite(value):
            raise ValueError(f"{keyword} is {value!r}; permitted is a finite number")
        found[keyword] = float(value)
    return {keyword: value for keyword, value in sorted(found.items()) if value != row_of(keyword).start}


def words_of(keyword, values):
    """An axis in words: "161 values -0.008 ... 0.008 m"."""
    count = f"{len(values)} value{'s' if len(values) > 1 else ''}"
    return f"{count} {short(values)}{unit_behind(row_of(keyword).unit)}"


def block_shape(sizes, block):
    """The shape of a block of at most ``block`` states of a grid of these ``sizes``: whole trailing axes, as
    far as there is room.

    >>> block_shape((200, 100, 50), 20_000), block_shape((7, 30), 20)
    ((4, 100, 50), (1, 20))
    """
    shape, room = [], block
    for size in reversed(sizes):
        shape.append(max(1, min(size, room)))
        room //= shape[-1]
    return tuple(reversed(shape))


def block_at(corner, shape, sizes):
    """The slices of the block whose first state is at ``corner``."""
    return tuple(
        slice(int(first), int(min(first + width, size))) for first, width, size in zip(corner, shape, sizes)
    )
