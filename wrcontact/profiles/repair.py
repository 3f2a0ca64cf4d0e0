"""Repair of measured points: every repair is reported, and points that cannot be repaired are refused.

The recipe is :func:`mend`. Each step takes points and returns points, and adds to ``remarks`` what it did, to
how many points, where and by how much. Outliers, gaps and kinks are found in flaws.py. The
message of a Refusal lacks the file's name, which files.py adds.
"""

import math
from dataclasses import replace

import numpy as np

from .flaws import (
    LONGEST_RUN,
    OUTLIER,
    SIDE,
    WIDEST_GAP,
    Mended,
    apart,
    check_gaps,
    rounded,
    straight_over,
    without_outliers,
)
from .orientation import faced, turned_upright
from .remarks import Refusal, counted, stretch
from .running_circle import at_running_circle, evenly
from .smoothing import LEAST_NOISE, noise_by_place, noise_of

LEAST_POINTS = 10
#: Permitted width of a profile [mm].
WIDTHS = (20.0, 200.0)
#: Largest height of a profile [mm]; whole rail sections have up to 190 mm.
HIGHEST = 300.0
#: Largest width without flange back, rail neck and foot [mm].
WIDEST = {"wheel": WIDTHS[1], "rail": 110.0}
#: Smallest width of a rail's head on either side of its highest point, and the width below which it is
#: reported [mm].
SHOULDER, USUAL_SHOULDER = 2.0, 10.0
#: A profile turns back where its y decreases by this [mm]; noise is smaller.
TURN = 0.5
#: Points that run back by LEAST_BACK [mm] or less are rounded or noisy. Those that run back by more than
#: MOST_BACK [mm], or whose branches are more than MOST_APART [mm] apart, are a fold. A curve steeper than STEEP
#: [1] over SIDE points on either side is a wall, which may wave.
LEAST_BACK, MOST_BACK, MOST_APART, STEEP = 5e-3, 2.0, 0.5, 2.0
#: A rail is needed down to this depth below its top, where the gauge is measured, also inclined by 1:20; a
#: wheel up to this y on its field side [mm].
NEEDED, FIELD = 16.0, 45.0
#: Points left out behind a fold or a wall are reported where they reach farther by this [mm].
CUT = 0.5
#: Where y varies by less [mm], the side of a rail's head is a wall, which is kept down to
#: where the gauge is measured.
UPRIGHT = 0.2
#: The gauge face is needed down to this depth below the top of an upright rail; it may recede there by at
#: most RECESS [mm].
FACE, RECESS = 20.0, 3.0
#: Factors to millimetres, and the widths in the file's unit for which that unit is assumed. Centimetres and
#: inches do not overlap for the usual widths of wheels (90 ... 160 mm) and rails (48 ... 90 mm).
UNITS = {
    "metres": (1e3, {"wheel": (0.02, 0.2), "rail": (0.02, 0.2)}),
    "inches": (25.4, {"wheel": (3.55, 6.3), "rail": (1.9, 3.5)}),
    "centimetres": (10.0, {"wheel": (9.0, 16.0), "rail": (4.8, 9.0)}),
    "micrometres": (1e-3, {"wheel": (2e4, 2e5), "rail": (2e4, 2e5)}),
}
#: A point this many widths away is not a measurement, but a code such as -9999.
FAR = 5.0
#: Points closer to each other count as one [mm].
SAME = 1e-6
#: Points at the same y are averaged where their z differ by less than this share of the median spacing.
NEAR = 0.25


def mend(points, kind, file, track, remarks, *, keep_all=False):
    """The repaired points (:class:`Mended`) of a file's ``points``, and the inclination [1] from which a rail
    was turned upright.

    Parameters
    ----------
    points : :class:`~wrcontact.profiles.formats.base.Points`.
    kind : "wheel" or "rail".
    file : :class:`~wrcontact.profiles.options.ProfileFile`, what the file does not say itself.
    track : inclination of the rails on the track [1], None where it is not known.
    remarks : list to which every repair is added.
    keep_all : whether outliers and kinks are only reported.

    Raises
    ------
    Refusal
        if the points cannot be repaired.
    """
    found = Mended(points.y, points.z, points.weight)
    found = without_nothing(found, points.lines, remarks)
    found = in_range(in_millimetres(found, kind, file, remarks), file)
    found = moved(found, file)
    found = in_order(found, points.free, remarks)
    found = without_repetition(found, remarks)
    found = upright(found, kind, file, points, remarks)
    inclination = 0.0
    if kind == "wheel":
        found = at_running_circle(found, file, points.free, remarks)
    else:
        one_head(found)  # two rails side by side are refused before their common shape is looked at
        found = faced(found, file, points.free, remarks)
        found, inclination = turned_upright(found, file, track, remarks)
    found = found if keep_all else without_backward(found, kind, remarks)
    if kind == "wheel":
        whole, found = found, outward(found, kind)
        remarks.extend(words_on_cuts(found.y, whole.y))
    else:
        found = outward(gauge_face(found, remarks), kind)
    found = without_outliers(replace(found, noise=noise_of(found.y, found.z)[0]), remarks, keep=keep_all)
    found = outward(found, kind)
    found = without_far_parts(found, kind, remarks)
    if kind == "rail":
        remark_near_end(found, remarks)
    noise, certainty = noise_at(found, remarks)
    found = replace(found, noise=noise, weight=found.weight * (certainty if noise > LEAST_NOISE else 1.0))
    check_gaps(found, remarks)
    found = rounded(found, remarks, keep=keep_all) if found.noise <= LEAST_NOISE else found
    return found, inclination


def without_nothing(found, lines, remarks):
    """Remove points that are not finite numbers, and codes for missing values such as -9999."""
    finite = np.isfinite(found.y) & np.isfinite(found.z)
    if not finite.any():
        raise Refusal("has only points that are not finite numbers; permitted are numbers in mm")
    if not finite.all():
        where = ", ".join(map(str, lines[~finite][:3])) + (", ..." if np.sum(~finite) > 3 else "")
        remarks.append(f"{counted(np.sum(~finite), 'point')} without finite numbers left out (line {where})")
    found = found.only(finite)
    with np.errstate(over="ignore"):
        width = max(_span(part) for part in (found.y, found.z))
        far = np.max([np.abs(part - np.median(part)) for part in (found.y, found.z)], axis=0) > FAR * max(
            width, 1e-12
        )
    if far.any():
        remarks.append(
            f"{counted(far.sum(), 'point')} far from the others left out (y = "
            f"{found.y[far][0]:.4g}, z = {found.z[far][0]:.4g} first)"
        )
    return found.only(~far)


def _span(values):
    """Distance between the 5th and the 95th percentile of ``values``."""
    return np.subtract(*np.percentile(values, [95, 5]))


def in_millimetres(found, kind, file, remarks):
    """Convert to millimetres; the unit is found from the width."""
    if file.y_range is not None and np.ptp(found.y) > WIDTHS[0]:
        return found
    if len(found.y) < LEAST_POINTS:
        raise Refusal(f"has {len(found.y)} points; permitted are {LEAST_POINTS} or more")
    width, factor = found.y.max() - found.y.min(), 1.0
    if not WIDTHS[0] <= width <= WIDTHS[1]:
        unit = next(
            (unit for unit, (_, widths) in UNITS.items() if widths[kind][0] <= width <= widths[kind][1]), None
        )
        if unit is None:
            raise Refusal(f"is {width:g} mm wide; permitted are {WIDTHS[0]:g} ... {WIDTHS[1]:g} mm")
        remarks.append(f"its width of {width:.4g} means {unit}; converted to mm")
        factor = UNITS[unit][0]
    if not factor * _span(found.z) <= HIGHEST:
        raise Refusal(f"is {factor * _span(found.z):g} mm high; permitted are {HIGHEST:g} mm or less")
    return replace(found, y=factor * found.y, z=factor * found.z)


def in_range(found, file):
    """The points whose y in the file lies within ``file.y_range``."""
    if file.y_range is None:
        return found
    low, high = file.y_range_mm
    inside = found.only((found.y >= low) & (found.y <= high))
    if len(inside.y) < LEAST_POINTS or np.ptp(inside.y) > WIDTHS[1]:
        raise Refusal(
            f"has {len(inside.y)} points between y = {low:.4g} and {high:.4g} mm; permitted are "
            f"{LEAST_POINTS} or more, within {WIDTHS[1]:g} mm; its points are at y = {found.y.min():.4g} ... "
            f"{found.y.max():.4g} mm"
        )
    return inside


def moved(found, file):
    """The points shifted, rotated and mirrored as ``file`` says."""
    y, z = (part + shift for part, shift in zip((found.y, found.z), file.shift_mm))
    c, s = math.cos(file.rotate), math.sin(file.rotate)
    y, z = (c * y - s * z, s * y + c * z) if file.rotate else (y, z)
    return replace(found, y=-y if file.mirror_y else y, z=-z if file.mirror_z else z)


def in_order(found, free, remarks):
    """Sort the points: in the file's order or in that of y, whichever path is shorter,
    starting at the smallest y."""
    backwards = found.y[0] > found.y[-1]
    if backwards:
        found = found.only(slice(None, None, -1))
    order = np.argsort(found.y, kind="stable")
    ways = [np.sum(np.hypot(np.diff(found.y[k]), np.diff(found.z[k]))) for k in (slice(None), order)]
    if ways[1] >= ways[0] * (1 - 1e-12):
        if backwards and not free:
            remarks.append("the points ran from the largest y to the smallest; reversed")
        return found
    moved = order != np.arange(len(order))
    remarks.append(f"{counted(moved.sum(), 'point')} sorted by y ({stretch(found.y[moved])})")
    return found.only(order)


def without_repetition(found, remarks):
    """Remove repeated points, and average points with the same y and nearly the same z."""
    chord = np.hypot(np.diff(found.y), np.diff(found.z))
    again = np.concatenate([[False], chord < SAME])
    if again.any():
        remarks.append(f"{counted(again.sum(), 'repeated point')} left out ({stretch(found.y[again])})")
        found, chord = found.only(~again), chord[~again[1:]]
    steps = np.abs(np.diff(found.y))
    near = NEAR * np.median(steps[steps > SAME]) if np.any(steps > SAME) else 0.0
    beside = (np.abs(np.diff(found.y)) < SAME) & (np.abs(np.diff(found.z)) < max(near, SAME))
    if beside.any():
        first = np.flatnonzero(np.concatenate([[True], ~beside]))
        count = np.diff(np.append(first, len(found.y)))
        y, z, weight = (np.add.reduceat(part, first) / count for part in (found.y, found.z, found.weight))
        spread = np.max(np.abs(np.diff(found.z))[beside])
        remarks.append(
            f"{counted(beside.sum(), 'point')} at the same y as others averaged "
            f"({stretch(found.y[1:][beside])}, z up to {1e3 * spread:.3g} um apart)"
        )
        found = Mended(y, z, weight)
    if len(found.y) < LEAST_POINTS:
        raise Refusal(f"has {len(found.y)} points; permitted are {LEAST_POINTS} or more")
    return found


def upright(found, kind, file, points, remarks):
    """Turn z down and a wheel's flange to negative y, unless ``file`` says how they are, or for a rail the
    format of its ``points``."""
    y, z = evenly(found)
    low, middle, high = np.percentile(z, [2, 50, 98])
    if kind == "wheel":
        upwards = middle - low > high - middle
    else:  # the ends of a head are its lowest points, also where a wide base has the most points
        ends = 0.5 * (np.median(found.z[:3]) + np.median(found.z[-3:]))
        upwards = ends < min(middle, 0.5 * (low + high))
    if upwards and file.mirror_z is None and kind == "rail" and points.defined:
        raise Refusal(
            "has ends that are higher than its middle, as if z were positive upwards, and its format has z down; "
            "mirror_z = True turns it over, mirror_z = False confirms it"
        )
    if upwards and file.mirror_z is None:
        found, z, middle, high = replace(found, z=-found.z), -z, -middle, -low
        if not points.free:
            remarks.append("z was positive upwards; its sign is changed")
    reversed_wheel = kind == "wheel" and np.mean(y[z >= 0.4 * middle + 0.6 * high]) > 0.5 * (y[0] + y[-1])
    if reversed_wheel and file.mirror_y is None:
        found = replace(found, y=-found.y).only(slice(None, None, -1))
        if not points.free:
            remarks.append("the flange was at the larger y; mirrored")
    return found


def without_backward(found, kind, remarks):
    """Remove the points of a stretch that was measured twice: seen from the middle, y runs back there and on
    again, where the curve is not steep. Both branches are removed, since neither is known to be the better.

    Small steps back are noise, and a long way back is a fold.
    """
    noise = noise_of(found.y, found.z)[0]
    middle, gone, most = _middle(found, kind), np.zeros(len(found.y), dtype=bool), 0.0
    for side, part in ((1, slice(middle, None)), (-1, slice(middle, None, -1))):
        u, z, index = side * found.y[part], found.z[part], np.arange(len(found.y))[part]
        farthest = np.maximum.accumulate(u)
        behind = np.flatnonzero(u < farthest)
        for run in np.split(behind, np.flatnonzero(np.diff(behind) > 1) + 1):
            if not len(run) or run[-1] + 1 == len(u):
                continue
            low, high = float(u[run].min()), float(farthest[run[0]])
            before, after = max(run[0] - SIDE, 0), min(run[-1] + SIDE, len(u) - 1)
            steep = abs(z[after] - z[before]) > STEEP * (u[after] - u[before])
            if steep or not max(OUTLIER * noise, LEAST_BACK) < high - low <= MOST_BACK:
                continue
            first = np.arange(np.searchsorted(farthest, low), run[0])
            if abs(z[first].mean() - z[run].mean()) <= MOST_APART:
                gone[index[first]] = gone[index[run]] = True
                most = max(most, high - low)
    if gone.any():
        remarks.append(
            f"{counted(gone.sum(), 'point')} left out where the points run back by up to {most:.3g} mm "
            f"({stretch(found.y[gone])})"
        )
    return found.only(~gone)


def _middle(found, kind):
    """Index of a wheel's point at the running circle, or of a rail's highest point."""
    return int(np.argmin(np.abs(found.y) if kind == "wheel" else found.z))


def gauge_face(found, remarks):
    """Replace a gauge face that recedes below its innermost point by a vertical one, as deep as the gauge is
    measured: the gauge is the distance of the innermost points."""
    top = int(np.argmin(found.z))
    y, depth = found.y[top::-1], found.z[top::-1] - found.z[top]
    deep = np.flatnonzero(depth > FACE)
    stop = deep[0] if len(deep) else len(y)
    innermost = int(np.argmin(y[:stop]))
    recess = y[innermost:stop] - y[innermost]
    if depth[innermost] > FACE - 1.0 or not len(recess) or not UPRIGHT < recess.max() <= RECESS:
        return found
    remarks.append(
        f"the gauge face recedes by {recess.max():.3g} mm from {depth[innermost]:.3g} mm below "
        "the top on; it is taken as vertical there"
    )
    changed = found.y.copy()
    changed[top - stop + 1 : top - innermost + 1] = y[innermost]
    return replace(found, y=changed)


def one_head(found):
    """A Refusal if the points of a rail are too wide for one."""
    width = float(np.ptp(found.y[_extent(found, "rail")]))
    if width > WIDEST["rail"]:
        raise Refusal(_wrong_width(width, "rail"))


def _wrong_width(width, kind):
    several = "; y_range = FROM,TO uses one of several profiles in a file" if width > WIDTHS[0] else ""
    return (
        f"is {width:.4g} mm wide before it turns back; permitted are {WIDTHS[0]:g} ... "
        f"{WIDEST[kind]:g} mm for a {kind}{several}"
    )


def _extent(found, kind):
    """Slice of the points from the middle outwards until y turns back."""
    middle = _middle(found, kind)
    stop = middle + _farthest(found.y[middle:], kind)
    return slice(middle - _farthest(-found.y[middle::-1], kind), stop + 1)


def outward(found, kind):
    """Keep the points from the middle outwards until y turns back: without flange
    back, rail neck and foot."""
    found = found.only(_extent(found, kind))
    width = found.y[-1] - found.y[0]
    if not WIDTHS[0] <= width <= WIDEST[kind]:
        raise Refusal(_wrong_width(width, kind))
    top = found.y[np.argmin(found.z)]
    if kind == "rail" and min(top - found.y[0], found.y[-1] - top) < SHOULDER:
        raise Refusal(
            f"is highest at y = {top:.4g} mm, between its ends at {found.y[0]:.4g} and "
            f"{found.y[-1]:.4g} mm; permitted are heads with {SHOULDER:g} mm or more on either "
            "side"
        )
    if len(found.y) < LEAST_POINTS:
        raise Refusal(f"has {len(found.y)} points before it turns back; permitted are {LEAST_POINTS} or more")
    return found


def without_far_parts(found, kind, remarks):
    """The points without those behind a wide gap, where wheel and rail do not touch and no gauge is measured:
    deeper than NEEDED on a rail, behind the tip of a wheel's flange, or beyond FIELD on its field side."""
    y, z = found.y, found.z
    start, stop = 0, len(y)
    middle, tip = _middle(found, kind), int(np.argmax(np.where(y < 0.0, z, -np.inf)))
    chord, wide = apart(y, z)
    for i in np.flatnonzero((chord > WIDEST_GAP) & wide):
        near = i + 1 if i < middle else i  # the end of the gap that is nearer to the middle
        far = z[near] - z.min() > NEEDED if kind == "rail" else near <= tip or y[near] > FIELD
        if not far or straight_over(y, z, i):
            continue
        where = f"{z[near] - z.min():.3g} mm below the top" if kind == "rail" else f"y = {y[near]:.4g} mm"
        remarks.append(f"gap of {chord[i]:.3g} mm from {where} on; the points behind it are left out")
        start, stop = (max(start, i + 1), stop) if i < middle else (start, min(stop, i + 1))
    return found.only(slice(start, stop))


def words_on_cuts(kept, whole):
    """Sentences on the ends of the coordinates ``kept`` (n,) [mm], where the ``whole`` (m,) points go on."""
    ends = (("smaller", kept.min(), whole.min(), -1.0), ("larger", kept.max(), whole.max(), 1.0))
    for side, end, last, outwards in ends:
        if outwards * (last - end) > CUT:
            yield (
                f"it folds back or is vertical at y = {end:.4g} mm; its points at {side} y, to {last:.4g} mm, "
                "are left out"
            )


def remark_near_end(found, remarks):
    """Report a highest point of a rail that is close to an end of the points."""
    top = found.y[np.argmin(found.z)]
    width = min(top - found.y[0], found.y[-1] - top)
    if width < USUAL_SHOULDER:
        remarks.append(
            f"its highest point is {width:.3g} mm from the end of the points; there is no contact beyond it"
        )


def noise_at(found, remarks):
    """The largest noise [mm] and the factor (n,) by which it is smaller at each point; ``remarks`` says where it
    differs much from place to place."""
    noise = noise_by_place(found.y, found.z)
    if noise is None:
        return noise_of(found.y, found.z)
    most, least = noise.max(), noise.min()
    remarks.append(
        f"its noise differs from place to place, {1e3 * least:.2g} ... {1e3 * most:.3g} um; it is largest at "
        f"{stretch(found.y[noise > 0.5 * most])}; each place is smoothed by its own"
    )
    return float(most), most / noise


def _farthest(y, kind):
    """Index of the largest ``y`` before it decreases by TURN for longer than a run of outliers; of a
    rail, the wall's foot."""
    padded = np.pad(y, LONGEST_RUN, mode="edge")
    calm = np.median(np.lib.stride_tricks.sliding_window_view(padded, 2 * LONGEST_RUN + 1), axis=1)
    turned = np.flatnonzero(calm < np.maximum.accumulate(calm) - TURN)
    ahead = y[: turned[0]] if len(turned) else y
    if kind == "rail":
        return int(np.flatnonzero(ahead >= ahead.max() - UPRIGHT)[-1])
    return int(np.flatnonzero(ahead >= ahead.max() - SAME)[0])
