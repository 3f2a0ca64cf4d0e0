"""Checks of what the half-space functions are given."""

import math

import numpy as np


def check_number(name, value, unit, above=False):
    """ValueError unless ``value`` is a finite number >= 0, or > 0 where ``above``."""
    try:
        good = math.isfinite(value) and (value > 0.0 if above else value >= 0.0)
    except TypeError:
        good = False
    if not good:
        raise ValueError(f"{name} is {value!r} {unit}; permitted is {name} {'>' if above else '>='} 0 "
                         f"{unit}, finite")


def check_load(force, penetration):
    if (force is None) == (penetration is None):
        raise ValueError(f"force is {force!r} N and penetration is {penetration!r} m; permitted is exactly "
                         "one of them")
    if force is not None:
        check_number("force", force, "N")
    elif not (isinstance(penetration, (int, float, np.number)) and math.isfinite(penetration)):
        raise ValueError(f"penetration is {penetration!r} m; permitted are finite numbers")


def checked_domain(domain):
    try:
        x_low, x_high, s_low, s_high = (float(side) for side in domain)
        good = (x_low < x_high and s_low < s_high and math.isfinite(x_high - x_low)
                and math.isfinite(s_high - s_low))
    except (TypeError, ValueError):
        good = False
    if not good:
        raise ValueError(f"domain is {domain!r} m; permitted is (x_low, x_high, s_low, s_high), finite, low "
                         "below high")
    return x_low, x_high, s_low, s_high


def checked_grid(x, s, gap):
    x, s, gap = (np.asarray(array, dtype=float) for array in (x, s, gap))
    for name, centres in (("x", x), ("s", s)):
        steps = np.diff(centres) if centres.ndim == 1 else np.zeros(0)
        if (len(steps) == 0 or not steps[0] > 0.0
            or not np.all(np.abs(steps - steps.mean()) <= 1e-6 * steps.mean())):
            raise ValueError(f"{name} has shape {centres.shape}; permitted are two or more rising, evenly "
                             "spaced values in m")
    if gap.shape != (len(x), len(s)):
        raise ValueError(f"gap has shape {gap.shape}; permitted is {(len(x), len(s))}, one value in m per "
                         "cell")
    if np.isnan(gap).any() or not np.isfinite(gap).any() or np.any(gap == -math.inf):
        raise ValueError("gap holds nan or no finite value in m; permitted are finite values, and inf "
                         "without a surface")
    return x, s, gap
