"""A cubic through four evenly spaced values."""


def cubic_through(before: float, low: float, high: float, after: float, x: float):
    """The cubic through values at -1, 0, 1, 2, at x."""
    bend = 0.5 * (before - 2.0 * low + high)
    third = (after - 3.0 * high + 3.0 * low - before) / 6.0
    return low + x * (high - low + (x - 1.0) * (bend + (x + 1.0) * third))
