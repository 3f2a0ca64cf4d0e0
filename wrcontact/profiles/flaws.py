"""Flaws of measured points: outliers, which gaps are bridged, and arcs in place of kinks."""

import math
from dataclasses import dataclass, replace

import numpy as np

from .remarks import Refusal, counted, stretch
from .smoothing import in_chords, pseudo_inverse

#: Neighbours on either side by which a point or a gap is judged.
SIDE = 5
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
#: A gap is longer than GAP [mm] and SPACINGS times the spacing; one longer than WIDEST_GAP
#: [mm] cannot be bridged.
GAP, SPACINGS, WIDEST_GAP = 3.0, 5.0, 10.0
#: Points are at even steps of y if this share of the steps differs from their median by at most EVEN of it.
MOST_EVEN, EVEN = 0.8, 0.01
#: A gap whose ends point along it within this angle [rad] is a straight stretch and may have any length.
STRAIGHT = 0.02
#: At a kink the angle changes by more than KINK [rad] and TIMES more than on both sides; it is
#: rounded over ROUNDED [mm].
KINK, TIMES, ROUNDED, MOST_KINKS = math.radians(2.0), 4.0, 1.0, 20
#: Largest permitted change of angle at a point [rad].
SPIKE = math.radians(90.0)


@dataclass(frozen=True)
class Mended:
    """Points ``y``, ``z`` (n,) [mm] in order along the curve, y rising and z down, with their
    ``weight`` and ``noise`` [mm]."""

    y: np.ndarray
    z: np.ndarray
    weight: np.ndarray
    noise: float = 0.0

    def only(self, which):
        """The points selected by ``which``, a mask or indices."""
        return replace(self, y=self.y[which], z=self.z[which], weight=self.weight[which])


# --- outliers -----------------------------------------------------------------------------------------------


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
            raise Refusal(
                f"has {len(taken)} outliers or more among its {count} points; permitted are at "
                f"most {MOST_OUTLIERS:.0%}"
            )
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
    own = slice(max(index - start - 2, 0), index - start + length)  # circle k: points k ... k + 2
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
        quarrel = np.sqrt(
            np.sum((misses[:, :near] * heard[:, :, 0]) ** 2, axis=1) / (heard.sum(axis=(1, 2)) - 4)
        )
        heard[np.arange(len(start)), np.argmax(np.abs(misses[:, :near]) * heard[:, :, 0], axis=1)] = 0.0
    lever = np.sum(np.einsum("ijk,ikl->ijl", powers[:, near:], solved) ** 2, axis=2)
    return np.min(np.abs(misses[:, near:]) / np.sqrt(1.0 + lever), axis=1), quarrel


# --- gaps and kinks -----------------------------------------------------------------------------------------


def check_gaps(found, remarks):
    """Report the gaps that are bridged; a Refusal if one is too wide and not a straight stretch."""
    y, z = found.y, found.z
    chord, far = apart(y, z)
    for i in np.flatnonzero((chord > GAP) & far):
        if chord[i] > WIDEST_GAP and not straight_over(y, z, i):
            raise Refusal(
                f"has no points between y = {y[i]:.4g} and {y[i + 1]:.4g} mm, a gap of "
                f"{chord[i]:.3g} mm; permitted are {WIDEST_GAP:g} mm or a straight stretch"
            )
        remarks.append(f"gap of {chord[i]:.3g} mm bridged ({stretch(y[i : i + 2])})")


def apart(y, z):
    """Lengths of the chords [mm], and whether each is far longer than the usual one."""
    chord, step = np.hypot(np.diff(y), np.diff(z)), np.diff(y)
    usual = np.abs(step - np.median(step)) <= EVEN * np.median(step)
    # points at even steps of y are far apart where the curve is steep
    wide = step if np.mean(usual) >= MOST_EVEN else chord
    return chord, wide > SPACINGS * np.median(wide)


def straight_over(y, z, i):
    """Whether the points before ``i`` and after ``i + 1`` have the direction of the chord
    between these two points."""
    low, high = max(i - SIDE, 0), min(i + 1 + SIDE, len(y) - 1)
    here = math.atan2(z[i + 1] - z[i], y[i + 1] - y[i])
    turns = [math.atan2(z[b] - z[a], y[b] - y[a]) - here for a, b in ((low, i), (i + 1, high)) if b > a]
    return all(abs(turn) <= STRAIGHT for turn in turns)


def rounded(found, remarks, *, keep=False):
    """Replace kinks by arcs, since a kink has no curvature to compute a contact with.

    With ``keep`` they are only reported.
    """
    y, z = found.y, found.z
    heading = np.diff(np.arctan2(np.diff(z), np.diff(y)))
    turned = np.abs((heading + np.pi) % (2 * np.pi) - np.pi)
    if turned.max() > SPIKE and not keep:
        worst = int(np.argmax(turned))
        raise Refusal(
            f"turns by {math.degrees(turned[worst]):.3g} deg at y = {y[worst + 1]:.4g} mm, a spike "
            f"or a fold; permitted are at most {math.degrees(SPIKE):.3g} deg"
        )
    places = _kinks(y, z)
    if not places:
        return found
    sharpest = math.degrees(max(abs(turn) for *_, turn in places))
    kinks = f"{counted(len(places), 'kink')} of up to {sharpest:.3g} deg"
    if keep:
        remarks.append(f"{kinks} kept, since smoothing is 0 ({stretch([y[index] for index, *_ in places])})")
        return found
    if len(places) > MOST_KINKS:
        raise Refusal(
            f"has {len(places)} kinks of {math.degrees(KINK):.3g} deg or more; permitted are at "
            f"most {MOST_KINKS}"
        )
    spots = np.array([_corner(y, z, index, width) for index, width, _ in places])
    points, deepest = list(zip(y, z)), 0.0
    for (index, width, _), spot in zip(places, spots):
        others = np.hypot(*(spots - spot).T)
        reach = min(
            ROUNDED,
            0.45 * min(others[others > 0.0], default=math.inf),
            0.9 * math.dist(spot, (y[0], z[0])),
            0.9 * math.dist(spot, (y[-1], z[-1])),
        )
        beyond = max(index - 2, 0), min(index + width + 1, len(y) - 1)
        arms = [_towards(spot, np.array([y[k], z[k]]), reach) for k in beyond]
        share = np.linspace(0.0, 1.0, 9)[:, None]
        bow = (1 - share) ** 2 * arms[0] + 2 * share * (1 - share) * spot + share**2 * arms[1]
        deepest = max(deepest, float(np.hypot(*(bow[4] - spot))))
        near = [k for k, point in enumerate(points) if math.dist(point, spot) <= 1.05 * reach]
        first = near[0] if near else points.index((y[index], z[index])) + 1
        points[first : near[-1] + 1 if near else first] = map(tuple, bow)
    remarks.append(f"{kinks} rounded over {ROUNDED:g} mm ({stretch(spots[:, 0])}), by up to {deepest:.2g} mm")
    table = np.array(points)
    return Mended(table[:, 0], table[:, 1], np.ones(len(table)), found.noise)


def _kinks(y, z):
    """Kinks: index of a point, 1 for a kink at the point or 2 for one before the next point,
    change of angle [rad]."""
    chord = np.hypot(np.diff(y), np.diff(z))
    turn = np.diff(np.unwrap(np.arctan2(np.diff(z), np.diff(y))))
    length = 0.5 * (chord[1:] + chord[:-1])
    sizes = [np.pad(size, 3) for size in (np.abs(turn), np.abs(turn) / length)]
    count, found = len(turn), []
    for width in (1, 2):
        total, reach = (np.convolve(part, np.ones(width))[width - 1 : count] for part in (turn, length))
        beside = [
            np.max([size[k : k + len(total)] for k in (1, 2, 3 + width, 4 + width)], axis=0) for size in sizes
        ]
        sudden = np.flatnonzero(
            (np.abs(total) > KINK)
            & (np.abs(total) > TIMES * width * beside[0])
            & (np.abs(total) > TIMES * reach * beside[1])
        )
        found += [
            (int(i) + 1, width, float(total[i]))
            for i in sudden
            if not any(i < k + more and k < i + 1 + width for k, more, _ in found)
        ]
    return sorted(found)


def _corner(y, z, index, width):
    """Position (y, z) [mm] of the kink: the point itself, or the intersection of the chords before
    and after two points."""
    if width == 1:
        return np.array([y[index], z[index]])
    ahead, back = (
        np.array([y[b] - y[a], z[b] - z[a]]) for a, b in ((index - 1, index), (index + 2, index + 1))
    )
    start, stop = np.array([y[index], z[index]]), np.array([y[index + 1], z[index + 1]])
    cross = ahead[0] * back[1] - ahead[1] * back[0]
    return start + ahead * (((stop - start)[0] * back[1] - (stop - start)[1] * back[0]) / cross)


def _towards(start, end, length):
    """The point at the distance ``length`` from ``start`` in the direction of ``end``."""
    return start + (end - start) * (length / np.hypot(*(end - start)))
