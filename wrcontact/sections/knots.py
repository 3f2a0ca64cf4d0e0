"""Where the knots of a surface lie on each slice: the same shares of the length between the same features."""

import numpy as np

#: Largest distance of knots [m]; where the surface would leave a section by more than the error of its curve, it is
#: halved, at most so often.
SPACING, HALVINGS = 4e-4, 5
#: A joint of the first slice's profile is a knot where every slice has one at the same share, but for this length [m].
SAME = 1e-9


def knot_lengths(curves, features):
    """Lengths (n, k) [m] of the knots on each of the n ``curves``, between the first and the last of their ``features``
    (n, f) [m]."""
    spans = np.diff(features, axis=1)
    lengths = [features[:, :1]]
    for piece, span in enumerate(spans.T):
        start = features[:, piece]
        exact = _common_joints(curves, start, span)
        ends = np.column_stack([start, exact, start + span])
        ends[:, -1] = features[:, piece + 1]
        for low, high in zip(ends.T[:-1], ends.T[1:]):
            count = max(1, int(np.ceil((high - low).max() / SPACING - 1e-9)))
            lengths += [
                low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, count + 1)[1:-1],
                high[:, None],
            ]
    found = np.concatenate(lengths, axis=1)
    for _ in range(HALVINGS):
        wanted = _too_wide(curves, found)
        if not wanted.any():
            break
        middles = 0.5 * (found[:, :-1] + found[:, 1:])[:, wanted]
        found = np.insert(found, np.flatnonzero(wanted) + 1, middles, axis=1)
    return found


def _too_wide(curves, lengths):
    """Whether between two knots (k - 1,) the surface leaves a section by more than its error at a third or half of the
    way."""
    wide = np.zeros(lengths.shape[1] - 1, dtype=bool)
    for curve, row in zip(curves, lengths):
        y, z, slope, before, behind = curve.at(row).T
        for share in (0.33, 0.5):
            place, height = curve.at(row[:-1] + share * np.diff(row)).T[:2]
            h, w = np.diff(y), place - y[:-1]
            v = w / h
            rest = np.diff(z) - h * (slope[:-1] + 0.5 * h * behind[:-1])
            turn, bend = h * (np.diff(slope) - h * behind[:-1]), h * h * (before[1:] - behind[:-1])
            drawn = z[:-1] + w * (slope[:-1] + 0.5 * w * behind[:-1]) + v**3 * (
                10.0 * rest - 4.0 * turn + 0.5 * bend
                + v * (-15.0 * rest + 7.0 * turn - bend + v * (6.0 * rest - 3.0 * turn + 0.5 * bend))
            )  # fmt: skip
            # across the surface: height over what is steep counts less
            wide |= np.abs(drawn - height) > curve.error * np.hypot(1.0, slope[:-1])
    return wide


def _common_joints(curves, start, span):
    """Lengths (n, j) [m] of the joints that all ``curves`` have at the same share of a piece that begins at ``start``
    (n,) and is ``span`` (n,) long [m]."""
    found = []
    for length in curves[0].joints:
        share = (length - start[0]) / span[0]
        if not SAME < share * span[0] < span[0] - SAME:
            continue
        row = []
        for curve, first, long in zip(curves, start, span):
            if len(curve.joints):
                nearest = curve.joints[np.argmin(np.abs(curve.joints - first - share * long))]
                if abs(nearest - first - share * long) <= SAME:
                    row.append(nearest)
        if len(row) == len(curves):
            found.append(row)
    return np.array(found).T if found else np.zeros((len(curves), 0))
