"""How the rail in a file stands: where its gauge side is, and whether it is already inclined.

Both are found from the head's shape. The middle between both sides is taken at several depths below the
highest point. A head that was symmetric when new, and is little worn, has all of them on one line, its axis;
the inclination of the axis is that of the rail. On a worn head only the gauge side can be found: wear and
inclination both move the highest point towards the field side, and make the gauge corner wider.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from .flaws import LONGEST_RUN
from .options import INCLINATION
from .remarks import Grave, Refusal

#: Depths below the highest point at which the middle of the head is taken [mm]; the last three quarters of
#: LEAST_DEPTH must exist.
DEPTHS = np.arange(1.0, 18.1, 0.5)
LEAST_DEPTH = 10.0
#: The points are averaged over this length before that, against noise [mm].
AVERAGED = 2.0
#: Steepest inclination that is looked for, and the steps of the search.
STEEPEST, TILTS = 0.12, 41
#: Distances from the middle over which the two halves of the crown are compared [mm].
CROWN = (1.0, 18.0)
#: A head is symmetric if the middles and the crown scatter by less about its axis [mm]; 50 um of noise gives
#: 0.1 mm, worn heads have 0.4 mm and more.
SYMMETRIC = 0.15
#: Smaller inclinations count as upright.
INCLINED = 1 / 150
#: A head leans as its track within this: 50 um of noise gives 0.002, and tracks are laid to 0.003.
LEANING = 0.003
#: The highest point shows the gauge side where it is farther from the middle [mm].
ASIDE = 2.0
#: The corners show it where their widths between the depths CORNER differ by more than ROUNDER [mm].
CORNER, ROUNDER = (5.0, 14.0), 1.0
#: The gauge side must reach as deep below the highest point [mm].
GAUGE_DEPTH = 14.0


@dataclass(frozen=True)
class Head:
    """The shape of a rail's head, y and z as in the file with z down.

    ``inclination``, the slope of its axis, positive if it leans to smaller y; NaN if a side is too short.
    ``scatter``, the deviation from symmetry about the axis [mm].  ``aside``, the highest point's distance
    from the middle of the head [mm].  ``rounder``, how much wider the corner at smaller y is than that at
    larger y [mm].  ``reach``, depths (2,) of both ends, at smaller and at larger y [mm].
    """

    inclination: float
    scatter: float
    aside: float
    rounder: float
    reach: tuple

    @property
    def symmetric(self):
        return self.scatter <= SYMMETRIC


def head_of(y, z):
    """The :class:`Head` of points ``y``, ``z`` (n,) [mm] in order along the curve, y rising and z down."""
    y, z = _calm(y, z)
    top = int(np.argmin(z))
    reach = float(z[: top + 1].max() - z[top]), float(z[top:].max() - z[top])
    sides = _sides(y, z, 0.0)
    middles = np.mean(sides, axis=0)
    deepest = middles[np.isfinite(middles)]
    aside = float(y[top] - deepest[-1]) if len(deepest) else 0.0
    high, low = (int(np.argmin(np.abs(DEPTHS - depth))) for depth in CORNER)
    corners = np.array([sides[0][high] - sides[0][low], sides[1][low] - sides[1][high]])
    rounder = float(corners[0] - corners[1]) if np.all(np.isfinite(corners)) else 0.0
    if min(reach) < LEAST_DEPTH:
        return Head(math.nan, math.inf, aside, rounder, reach)
    tilts = np.linspace(-STEEPEST, STEEPEST, TILTS)
    best = tilts[np.argmin([_scatter(y, z, tilt) for tilt in tilts])]
    step = tilts[1] - tilts[0]
    while step > 1e-6:
        best = min((best - step, best, best + step), key=lambda tilt: _scatter(y, z, tilt))
        step *= 0.5
    scatter = max(_scatter(y, z, best), _crown_scatter(y, z, best))
    return Head(math.tan(best), scatter, aside, rounder, reach)


def _calm(y, z):
    """Points (n,) without short outliers, and averaged over AVERAGED."""
    size = 2 * LONGEST_RUN + 1
    chord = np.median(np.hypot(np.diff(y), np.diff(z)))
    average = 2 * int(0.5 * AVERAGED / max(chord, 1e-6)) + 1
    for count, calm in ((size, np.median), (min(average, len(y) // 8 * 2 + 1), np.mean)):
        y, z = (
            calm(
                np.lib.stride_tricks.sliding_window_view(
                    np.pad(part, count // 2, mode="reflect", reflect_type="odd"), count
                ),
                axis=1,
            )
            for part in (y, z)
        )
    return y, z


def _sides(y, z, tilt):
    """Coordinates (2, m) [mm] of both sides at DEPTHS, of the points turned by ``tilt`` [rad]; NaN below a
    side's end."""
    c, s = math.cos(tilt), math.sin(tilt)
    y, z = c * y - s * z, s * y + c * z
    top = int(np.argmin(z))
    return [_crossings(y[top::step], z[top::step] - z[top]) for step in (-1, 1)]


def _crown_scatter(y, z, tilt):
    """Standard deviation [mm] of the difference in height between both halves of the crown, of the points
    turned by ``tilt`` [rad]."""
    middle = np.nanmedian(np.mean(_sides(y, z, tilt), axis=0))
    c, s = math.cos(tilt), math.sin(tilt)
    y, z = c * y - s * z, s * y + c * z
    near = (np.abs(y - middle) <= CROWN[1] + AVERAGED) & (z - z.min() <= LEAST_DEPTH)  # without web and foot
    order = np.flatnonzero(near)[np.argsort(y[near], kind="stable")]
    left, right = (np.interp(middle + side * np.linspace(*CROWN, 50), y[order], z[order]) for side in (-1, 1))
    return float(np.std(left - right))


def _crossings(y, z):
    """Coordinates (m,) [mm] where a side, from the highest point outwards, first reaches DEPTHS."""
    deep = np.maximum.accumulate(z)
    after = np.searchsorted(deep, DEPTHS)
    inside = after < len(z)
    k = np.clip(after, 1, len(z) - 1) if len(z) > 1 else np.zeros(len(DEPTHS), dtype=int)
    share = (DEPTHS - deep[k - 1]) / np.maximum(deep[k] - deep[k - 1], 1e-12)
    return np.where(inside, y[k - 1] + share * (y[k] - y[k - 1]), np.nan)


def _scatter(y, z, tilt):
    """Standard deviation [mm] of the middles about the axis with this ``tilt`` [rad]."""
    middles = np.mean(_sides(y, z, tilt), axis=0)
    found = np.isfinite(middles)
    return float(np.std(middles[found])) if found.sum() >= 3 else math.inf


# --- gauge side -----------------------------------------------------------------------------------


def faced(found, file, free, remarks):
    """The points with the gauge side at the smaller y.

    They are mirrored only if the format leaves the direction open (``free``), the gauge side is found at the
    larger y, and ``file`` (:class:`~wrcontact.profiles.options.ProfileFile`) does not say ``mirror_y``.
    Otherwise ``remarks`` says what was found.
    """
    if file.mirror_y is not None:
        return found
    head = head_of(found.y, found.z)
    side, reason = _gauge_side(head)
    if side > 0 and free:
        remarks.append(f"the gauge side was at the larger y ({reason}); mirrored")
        return replace(found, y=-found.y).only(slice(None, None, -1))
    if side > 0:
        remarks.append(
            Grave(
                f"the gauge side seems to be at the larger y ({reason}); mirror_y = True "
                "mirrors the rail, mirror_y = False confirms the smaller y"
            )
        )
    elif side == 0 and not head.symmetric:
        remarks.append(
            "the gauge side cannot be found from the shape; the smaller y is used; mirror_y = True"
            " mirrors the rail, mirror_y = False confirms it"
        )
    return found


def _gauge_side(head):
    """-1 or +1 for a gauge side at smaller or larger y, 0 if the shape does not show it; and the reason."""
    if head.symmetric:
        if abs(head.inclination) < INCLINED:
            return 0, ""
        side = -1 if head.inclination > 0.0 else 1
        return side, f"the head is inclined to it by {_ratio(head.inclination)}"
    deep = [depth >= GAUGE_DEPTH for depth in head.reach]
    if deep[0] != deep[1]:
        return (-1 if deep[0] else 1), f"only this side reaches {GAUGE_DEPTH:g} mm below the top"
    signs, reasons = [], []
    if abs(head.rounder) > ROUNDER:
        signs.append(-1 if head.rounder > 0.0 else 1)
        reasons.append(f"the corner there is wider by {abs(head.rounder):.3g} mm")
    if abs(head.aside) > ASIDE:
        signs.append(-1 if head.aside > 0.0 else 1)
        reasons.append(f"the highest point is {abs(head.aside):.3g} mm from the middle on the other side")
    agreed = len(set(signs)) == 1
    return (signs[0], ", ".join(reasons)) if agreed else (0, "")


# --- inclination ----------------------------------------------------------------------------------


def turned_upright(found, file, track, remarks):
    """The points without the inclination that they have, and this inclination as a slope.

    It is what ``file`` (:class:`~wrcontact.profiles.options.ProfileFile`) states; if it states none, that of
    the ``track`` [1], if the head is symmetric and leans by this within LEANING. ``track`` is None where it is
    not known.

    Raises
    ------
    Refusal
        if a symmetric head leans otherwise, and a track inclines it again or is not known.
    """
    given = file.file_inclination
    if given == 0.0:
        return found, 0.0
    head = head_of(found.y, found.z)
    leans = head.symmetric and abs(head.inclination) >= INCLINED
    if given is None and not leans:
        if not head.symmetric:
            remarks.append(
                "its head is not symmetric, so its shape does not show whether it is already "
                "inclined; read as upright; file_inclination = 0 confirms that, file_inclination = "
                "0.025 turns it upright from 1:40"
            )
        return found, 0.0
    if given is None and track == 0.0:
        remarks.append(f"its head is {_stands(head.inclination)} in the file, and used so on this track")
        return found, 0.0
    if given is None:
        if track is None or abs(head.inclination - track) > LEANING:
            raise Refusal(_undecided(head.inclination, track, file))
        given = track
        remarks.append(
            f"its head is {_stands(head.inclination)} in the file, as this track inclines it; turned upright "
            f"from {_ratio(track)}; file_inclination = 0 inclines it again"
        )
    elif head.symmetric and abs(head.inclination - given) >= INCLINED:
        remarks.append(
            Grave(f"its head is {_stands(head.inclination)}, although file_inclination is {given:.4g}")
        )
    angle = math.atan(given)
    c, s = math.cos(angle), math.sin(angle)
    return replace(found, y=c * found.y - s * found.z, z=s * found.y + c * found.z), given


def _undecided(inclination, track, file):
    """Why a symmetric head with this ``inclination`` is not used on a ``track``, and what settles it."""
    asked = "without its track" if track is None else f"and its track inclines it by {_ratio(track)}"
    turns = f"mirror_y = {not file.mirror_y} mirrors it, " if inclination < 0.0 else ""
    if 0.0 < inclination <= INCLINATION.high:
        turns = f"file_inclination = {inclination:.4g} turns it upright, "
    return (
        f"has a symmetric head that is {_stands(inclination)} in the file, {asked}; "
        f"{turns}file_inclination = 0 confirms that it is upright"
    )


def _stands(inclination):
    """An inclination in words."""
    if abs(inclination) < INCLINED:
        return "upright"
    direction = "towards the track centre" if inclination > 0.0 else "away from the track centre"
    return f"inclined by {_ratio(inclination)} {direction}"


def _ratio(inclination):
    return f"1:{1.0 / abs(inclination):.3g}"
