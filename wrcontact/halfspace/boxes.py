"""Boxes (x_low, x_high, s_low, s_high) [m] in the plane of contact, and the cells that fill them."""

import numpy as np
from scipy import ndimage

#: Share of the area of one grid below which several grids for the patches are solved faster.
APART = 0.4


def centres(box, counts):
    """Centres (n,), (m,) of n x m cells that fill a box."""
    return tuple(
        low + (high - low) * (np.arange(count) + 0.5) / count
        for low, high, count in zip(box[::2], box[1::2], counts)
    )


def around(marked, x, s, dx, ds, margin):
    """Box around the marked cells' centres, ``margin`` cells larger on each side."""
    rows, columns = np.flatnonzero(marked.any(axis=1)), np.flatnonzero(marked.any(axis=0))
    return (
        x[rows[0]] - margin * dx,
        x[rows[-1]] + margin * dx,
        s[columns[0]] - margin * ds,
        s[columns[-1]] + margin * ds,
    )


def clipped(box, domain):
    return tuple((max if k % 2 == 0 else min)(side, end) for k, (side, end) in enumerate(zip(box, domain)))


def touched_sides(pressure):
    """Whether a border of the grid is loaded: x low, x high, s low, s high."""
    borders = pressure[0], pressure[-1], pressure[:, 0], pressure[:, -1]
    return tuple(bool(border.any()) for border in borders)


def enlarged(box, touched, domain, share):
    """``box`` larger by ``share`` of its size on the touched sides; ArithmeticError where the domain ends."""
    sides = list(box)
    for k, touch in enumerate(touched):
        if touch:
            if (sides[k] <= domain[k]) if k % 2 == 0 else (sides[k] >= domain[k]):
                raise ArithmeticError(
                    f"the patch reaches {'x' if k < 2 else 's'} = {domain[k]:g} m, the end "
                    "of the domain; permitted are patches inside"
                )
            size = box[k | 1] - box[k & 2]
            sides[k] += share * size * (1 if k % 2 else -1)
    return clipped(sides, domain)


def loaded_boxes(found):
    """Box around each connected run of loaded cells, and its share of the load."""
    dx, ds = found.x[1] - found.x[0], found.s[1] - found.s[0]
    labels, count = ndimage.label(found.pressure > 0.0, np.ones((3, 3)))
    loads = ndimage.sum_labels(found.pressure, labels, np.arange(1, count + 1))
    return [
        (
            (
                found.x[rows][0] - 0.5 * dx,
                found.x[rows][-1] + 0.5 * dx,
                found.s[columns][0] - 0.5 * ds,
                found.s[columns][-1] + 0.5 * ds,
            ),
            load / loads.sum(),
        )
        for (rows, columns), load in zip(ndimage.find_objects(labels), loads)
    ]


def merged(boxes):
    """Groups of boxes: those that come closer to each other than a quarter of their
    sizes are solved on one grid."""
    groups = [[box] for box in boxes]
    while True:
        pair = next(
            (
                (a, b)
                for a in range(len(groups))
                for b in range(a)
                if _close(hull(groups[a]), hull(groups[b]))
            ),
            None,
        )
        if pair is None:
            return groups
        groups[pair[1]] += groups.pop(pair[0])


def are_apart(groups):
    """Whether grids for each of the ``groups`` of boxes have much less cells than one for all."""
    areas = [
        (box[1] - box[0]) * (box[3] - box[2])
        for box in (*map(hull, groups), hull([box for group in groups for box in group]))
    ]
    return len(groups) > 1 and sum(areas[:-1]) < APART * areas[-1]


def hull(boxes):
    """The box around boxes."""
    sides = np.array(boxes)
    return sides[:, 0].min(), sides[:, 1].max(), sides[:, 2].min(), sides[:, 3].max()


def _close(one, other):
    spare = [0.25 * (one[k + 1] - one[k] + other[k + 1] - other[k]) for k in (0, 2)]
    return all(
        one[k] - spare[k // 2] < other[k + 1] and other[k] - spare[k // 2] < one[k + 1] for k in (0, 2)
    )
