"""What a user gives, checked: one sentence with name, value, unit and range where it cannot be used."""

from math import isfinite
from numbers import Real

import numpy as np


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
        array = np.array(values, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be numbers [{unit}], not {type(values).__name__}") from None
    if array.ndim != 1:
        raise ValueError(f"{name} has {array.ndim} dimensions; permitted is one")
    if count is not None and len(array) != count:
        raise ValueError(f"{name} has {len(array)} values, station has {count}; they must be as many")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} has a value that is not a finite number [{unit}]")
    return array
