"""Gaps and kinks of measured points: which gaps are bridged, and arcs in place of kinks."""

import math

import numpy as np

from .mended import SIDE, Mended
from .remarks import Refusal, counted, stretch

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


def check_gaps(found, remarks):
    """Report the gaps that are bridged; a Refusal if one is too wide and not a straight stretch."""
    y, z = found.y, found.z
    chord, step = np.hypot(np.diff(y), np.diff(z)), np.diff(y)
    usual = np.abs(step - np.median(step)) <= EVEN * np.median(step)
    # points at even steps of y are far apart where the curve is steep
    wide = step if np.mean(usual) >= MOST_EVEN else chord
    for i in np.flatnonzero((chord > GAP) & (wide > SPACINGS * np.median(wide))):
        if chord[i] > WIDEST_GAP and not straight_over(y, z, i):
            raise Refusal(f"has no points between y = {y[i]:.4g} and {y[i + 1]:.4g} mm, a gap of "
                          f"{chord[i]:.3g} mm; permitted are {WIDEST_GAP:g} mm or a straight stretch")
        remarks.append(f"gap of {chord[i]:.3g} mm bridged ({stretch(y[i:i + 2])})")


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
        raise Refusal(f"turns by {math.degrees(turned[worst]):.3g} deg at y = {y[worst + 1]:.4g} mm, a spike "
                      f"or a fold; permitted are at most {math.degrees(SPIKE):.3g} deg")
    places = _kinks(y, z)
    if not places:
        return found
    sharpest = math.degrees(max(abs(turn) for *_, turn in places))
    kinks = f"{counted(len(places), 'kink')} of up to {sharpest:.3g} deg"
    if keep:
        remarks.append(f"{kinks} kept, since smoothing is 0 ({stretch([y[index] for index, *_ in places])})")
        return found
    if len(places) > MOST_KINKS:
        raise Refusal(f"has {len(places)} kinks of {math.degrees(KINK):.3g} deg or more; permitted are at "
                      f"most {MOST_KINKS}")
    spots = np.array([_corner(y, z, index, width) for index, width, _ in places])
    points, deepest = list(zip(y, z)), 0.0
    for (index, width, _), spot in zip(places, spots):
        others = np.hypot(*(spots - spot).T)
        reach = min(ROUNDED, 0.45 * min(others[others > 0.0], default=math.inf),
                    0.9 * math.dist(spot, (y[0], z[0])), 0.9 * math.dist(spot, (y[-1], z[-1])))
        beyond = max(index - 2, 0), min(index + width + 1, len(y) - 1)
        arms = [_towards(spot, np.array([y[k], z[k]]), reach) for k in beyond]
        share = np.linspace(0.0, 1.0, 9)[:, None]
        bow = (1 - share) ** 2 * arms[0] + 2 * share * (1 - share) * spot + share**2 * arms[1]
        deepest = max(deepest, float(np.hypot(*(bow[4] - spot))))
        near = [k for k, point in enumerate(points) if math.dist(point, spot) <= 1.05 * reach]
        first = near[0] if near else points.index((y[index], z[index])) + 1
        points[first:near[-1] + 1 if near else first] = map(tuple, bow)
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
        total, reach = (np.convolve(part, np.ones(width))[width - 1:count] for part in (turn, length))
        beside = [np.max([size[k:k + len(total)] for k in (1, 2, 3 + width, 4 + width)], axis=0)
                  for size in sizes]
        sudden = np.flatnonzero((np.abs(total) > KINK) & (np.abs(total) > TIMES * width * beside[0])
                                & (np.abs(total) > TIMES * reach * beside[1]))
        found += [(int(i) + 1, width, float(total[i])) for i in sudden
                  if not any(i < k + more and k < i + 1 + width for k, more, _ in found)]
    return sorted(found)


def _corner(y, z, index, width):
    """Position (y, z) [mm] of the kink: the point itself, or the intersection of the chords before
    and after two points."""
    if width == 1:
        return np.array([y[index], z[index]])
    ahead, back = (np.array([y[b] - y[a], z[b] - z[a]])
                   for a, b in ((index - 1, index), (index + 2, index + 1)))
    start, stop = np.array([y[index], z[index]]), np.array([y[index + 1], z[index + 1]])
    cross = ahead[0] * back[1] - ahead[1] * back[0]
    return start + ahead * (((stop - start)[0] * back[1] - (stop - start)[1] * back[0]) / cross)


def _towards(start, end, length):
    """The point at the distance ``length`` from ``start`` in the direction of ``end``."""
    return start + (end - start) * (length / np.hypot(*(end - start)))
