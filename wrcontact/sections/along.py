"""Cubic splines along the track, through the values of slices.

Beyond the first and the last slice a value runs out: its slope goes to zero within a short way, in two cubics
with continuous second derivative. Farther out it is constant.
"""

import numpy as np

#: Longest way in which values run out beyond the ends of the slices [m].
LONGEST_RUN_OUT = 0.05


def splines(u, values, run_out=LONGEST_RUN_OUT):
    """Breaks (m + 1,) [m] and coefficients (m, 4, ...) of rising powers of the distance from the break before, through
    ``values`` (n, ...) at rising ``u`` (n,) [m]: not-a-knot, a parabola through three slices, a line through two.

    m is n + 3: there are two pieces of run-out at either end, together ``run_out`` long [m] or as long as the distance
    of the last two slices.
    """
    from scipy.interpolate import CubicSpline  # not needed before there are sections

    pieces = CubicSpline(u, values, axis=0)
    inside = np.moveaxis(pieces.c[::-1], 0, 1)
    ends = []
    for at, length, direction in ((u[0], u[1] - u[0], -1.0), (u[-1], u[-1] - u[-2], 1.0)):
        half = 0.5 * min(length, run_out)
        value, slope, bend = pieces(at), pieces(at, 1) * direction, pieces(at, 2)
        ends.append((half, _run_out(value, slope, bend, half)))
    (first, before), (last, behind) = ends
    # those before the first slice were written backwards
    before = [_backwards(piece, first) for piece in before[::-1]]
    breaks = np.concatenate([[u[0] - 2.0 * first, u[0] - first], u, [u[-1] + last, u[-1] + 2.0 * last]])
    return breaks, np.concatenate([np.stack(before), inside, np.stack(behind)])


def _run_out(value, slope, bend, half):
    """Two cubics, each ``half`` long, from this ``value``, ``slope`` and second derivative to a level end."""
    middle = -slope / half - 0.5 * bend
    first = np.stack([value, slope, 0.5 * bend, (middle - bend) / (6.0 * half)])
    at = value + half * (slope + half * (first[2] + half * first[3]))
    second = np.stack([at, slope + 0.5 * half * (bend + middle), 0.5 * middle, -middle / (6.0 * half)])
    return [first, second]


def backwards(cubics, lengths):
    """The ``cubics`` (m, 4, ...) as those of the distance from the break behind, with the ``lengths`` (m,) [m] of their
    intervals."""
    lengths = lengths.reshape(-1, *[1] * (cubics.ndim - 2))
    return np.moveaxis(_backwards(np.moveaxis(cubics, 1, 0), lengths), 0, 1)


def _backwards(cubic, length):
    """The ``cubic`` of t as one of length - t."""
    c0, c1, c2, c3 = cubic
    return np.stack(
        [
            c0 + length * (c1 + length * (c2 + length * c3)),
            -(c1 + length * (2.0 * c2 + 3.0 * length * c3)),
            c2 + 3.0 * length * c3,
            -c3,
        ]
    )


def least_of(cubics, lengths):
    """The smallest value (m, ...) of each cubic, ``cubics`` (m, 4, ...), over its length (m,)."""
    length = lengths.reshape(-1, *[1] * (cubics.ndim - 2))
    c0, c1, c2, c3 = np.moveaxis(cubics, 1, 0)
    value = lambda t: c0 + t * (c1 + t * (c2 + t * c3))  # noqa: E731
    least = np.minimum(c0, value(length))
    root = np.sqrt(np.maximum(c2 * c2 - 3.0 * c1 * c3, 0.0))
    for turn in (-c2 - root, -c2 + root):
        # the roots of c1 + 2 c2 t + 3 c3 t^2, without division by a small c3
        with np.errstate(divide="ignore", invalid="ignore"):
            for t in (turn / (3.0 * c3), c1 / turn):
                inside = np.isfinite(t) & (t > 0.0) & (t < length)
                least = np.where(inside, np.minimum(least, value(np.where(inside, t, 0.0))), least)
    return least
