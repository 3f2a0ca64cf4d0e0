"""Outliers among measured points: single points and short runs that deviate from the
curve of their neighbours."""

import numpy as np

from .mended import SIDE
from .remarks import Refusal, counted, stretch
from .smoothing import in_chords, pseudo_inverse

#: An outlier deviates from the curve of its neighbours by more than OUTLIER times the noise and by more than
#: LEAST_OUTLIER [mm]. If points are farther apart than CLOSE [mm], that limit grows with the square of the
#: spacing, since joints of exact profiles deviate by as much.
OUTLIER, LEAST_OUTLIER, CLOSE = 7.0, 5e-3, 0.3
#: It also deviates AGREED times more than the neighbours themselves do from their common
#: curve; at a kink it is 7 times.
AGREED = 8.0
#: A point is predicted by its neighbours, and thus no outlier, if the curvatures through it exceed the range
#: of the curvatures beside it by at most this share of that range, on SEEN points on either side.  Between
#: zones of different curvature they lie within the range; an outlier's curvatures alternate beyond it.
OVERSHOOT, SEEN = 0.25, 3
#: Larger curvatures beside a point are those of other outliers [1/mm]; profiles have radii of 5 mm or more.
SHARPEST = 0.2
#: Outliers are removed in passes, one from each neighbourhood per pass.
MOST_PASSES = 50
#: Longest run of outliers.
LONGEST_RUN = 3
#: Points at either end that are not judged, for lack of neighbours.
ENDS = 2
#: Neighbours that are ignored because they may be outliers themselves.
TRIMMED = 2
#: Largest share of outliers.
MOST_OUTLIERS = 0.1


def without_outliers(found, remarks, *, keep=False):
    """Remove outliers: single points and runs of up to three that deviate from the curve of their neighbours.

    With ``keep`` they are only reported.
    """
    given = found
    count, most, taken = len(found.y), 0.0, []
    for _ in range(MOST_PASSES):
        index, length, height = _runs_off(found)
        if not len(index):
            break
        most = max(most, height.max())
        gone = np.unique(np.concatenate([np.arange(i, i + n) for i, n in zip(index, length)]))
        taken += found.y[gone].tolist()
        if len(taken) > MOST_OUTLIERS * count and not keep:
            raise Refusal(f"has {len(taken)} outliers or more among its {count} points; permitted are at "
                          f"most {MOST_OUTLIERS:.0%}")
        found = found.only(np.delete(np.arange(len(found.y)), gone))
    if taken:
        done = "kept, since smoothing is 0" if keep else "left out"
        remarks.append(f"{counted(len(taken), 'outlier')} of up to {most:.3g} mm {done} ({stretch(taken)})")
    return given if keep else found


def _runs_off(found):
    """Runs of outliers whose neighbourhoods do not overlap: first indices, lengths and deviations [mm]."""
    runs = [_run_errors(found.y, found.z, length) for length in range(1, LONGEST_RUN + 1)]
    index = np.concatenate([np.arange(len(error)) for error, _ in runs])
    length = np.repeat(np.arange(1, LONGEST_RUN + 1), [len(error) for error, _ in runs])
    error, quarrel = (np.concatenate(part) for part in zip(*runs))
    spacing = np.median(np.hypot(np.diff(found.y), np.diff(found.z)))
    least = LEAST_OUTLIER * max(1.0, spacing / CLOSE) ** 2
    between = (index >= ENDS) & (index + length <= len(found.y) - ENDS)
    off = between & (error > max(OUTLIER * found.noise, least)) & (error > AGREED * quarrel)
    off[off] = [not predicted(found.y, found.z, *run) for run in zip(index[off], length[off])]
    order = np.flatnonzero(off)[np.argsort(-(error / length)[off], kind="stable")]
    free, picked = np.ones(len(found.y), dtype=bool), []
    for k in order:
        around = slice(max(index[k] - SIDE, 0), index[k] + length[k] + SIDE)
        if free[around].all():
            free[around] = False
            picked.append(k)
    return index[picked], length[picked], error[picked]


def predicted(y, z, index, length):
    """Whether the curve of points ``y``, ``z`` (n,) predicts the run of ``length`` points from ``index``.

    The curvatures of circles through three successive points, two of which may be in the run, are compared
    with those of SEEN circles on either side, which the run does not affect.  Without such a circle on one
    side, at an end of the profile, the curve may be straight there.
    """
    start, stop = max(index - SEEN - 2, 0), min(index + length + SEEN + 2, len(y))
    curvature = _curvatures(y[start:stop], z[start:stop])
    own = slice(max(index - start - 2, 0), index - start + length)      # circle k: points k ... k + 2
    straight = [0.0] if own.start < 1 or own.stop >= len(curvature) else []
    beside = np.append(np.delete(curvature, own), straight)
    low, high = np.clip([beside.min(), beside.max()], -SHARPEST, SHARPEST)
    slack = OVERSHOOT * (high - low)
    return bool(np.all((curvature[own] >= low - slack) & (curvature[own] <= high + slack)))


def _curvatures(y, z):
    """Curvatures (n - 2,) of the circles through each three successive points ``y``, ``z`` (n,)."""
    dy, dz = np.diff(y), np.diff(z)
    chord = np.hypot(dy, dz)
    across = np.hypot(y[2:] - y[:-2], z[2:] - z[:-2])
    return 2.0 * (dy[:-1] * dz[1:] - dz[:-1] * dy[1:]) / (chord[:-1] * chord[1:] * np.maximum(across, 1e-12))


def _run_errors(y, z, length):
    """For every run of ``length`` points: the deviation of its closest point from the cubic through
    its neighbours, and the deviation of the neighbours themselves, both [mm], divided by their
    expected value for noise of 1."""
    near = 2 * SIDE
    if len(y) < near + length:
        return np.zeros(0), np.zeros(0)
    start = np.arange(len(y) - length + 1)
    left = np.clip(start - SIDE, 0, len(y) - near - length)
    others = left[:, None] + np.arange(near)
    others += length * (others >= start[:, None])
    run = start[:, None] + np.arange(length)
    along, across = in_chords(y[others], z[others], y[run], z[run])
    powers = (along / np.abs(along).max(axis=1, keepdims=True))[:, :, None] ** np.arange(4)
    heard = np.ones((len(start), near, 1))
    for _ in range(TRIMMED + 1):
        solved = pseudo_inverse(powers[:, :near] * heard)
        misses = across - np.einsum("ijk,ikl,il->ij", powers, solved, across[:, :near] * heard[:, :, 0])
        quarrel = np.sqrt(np.sum((misses[:, :near] * heard[:, :, 0]) ** 2, axis=1)
                          / (heard.sum(axis=(1, 2)) - 4))
        heard[np.arange(len(start)), np.argmax(np.abs(misses[:, :near]) * heard[:, :, 0], axis=1)] = 0.0
    lever = np.sum(np.einsum("ijk,ikl->ijl", powers[:, near:], solved) ** 2, axis=2)
    return np.min(np.abs(misses[:, near:]) / np.sqrt(1.0 + lever), axis=1), quarrel
