"""Patches that carry nothing in sum are taken away: by hand, and what all carry together stays."""

import numpy as np
import pytest

from wrcontact.kernel.layout import SideSearch, size
from wrcontact.kernel.patch.filling import add_load, complete_totals, finish_patches


def filled(loads, parts=None):
    """A side with patches 2 mm wide, every 4 mm, with these ``loads`` [N] at their middles, and their
    ``parts``: patch, region, load; one in region 0 each unless given."""
    side = SideSearch.at(np.zeros(size(SideSearch)))
    side.patch_count = len(loads)
    for index in range(len(loads)):
        patch = side.patches[index]
        patch.rail, patch.totals.area = 4e-3 * index, 1e-6
        patch.totals.start, patch.totals.stop = patch.rail - 1e-3, patch.rail + 1e-3
    for index, region, load in parts or [(index, 0, load) for index, load in enumerate(loads)]:
        add_load(side.patches[index], region, load, load * 4e-3 * index)
    return side


def carried(side):
    """Loads of the patches, the sums over their regions, and where the patches are."""
    patches = side.patches[: side.patch_count]
    return (
        [patch.totals.load for patch in patches],
        [sum(patch.loads) for patch in patches],
        [patch.rail for patch in patches],
    )


@pytest.mark.parametrize(
    "loads, wanted, places",
    [
        ((5.0, 3.0), [5.0, 3.0], [0, 1]),
        ((5.0, -3.0), [2.0], [0]),
        ((-3.0, 5.0), [2.0], [1]),
        ((5.0, -3.0, 4.0), [2.0, 4.0], [0, 2]),
        ((5.0, -7.0, 4.0), [2.0], [2]),
        ((-1.0, -1.0, 5.0), [3.0], [2]),
        ((0.0, 5.0), [5.0], [1]),
        ((-1.0,), [-1.0], [0]),
    ],
    ids=str,
)
def test_a_patch_without_load_counts_for_the_one_before_or_behind(loads, wanted, places):
    side = filled(loads)
    finish_patches(side)
    found, parts, where = carried(side)
    assert found == parts == wanted and where == [4e-3 * place for place in places]
    assert side.totals.load == sum(loads) and side.totals.area == pytest.approx(1e-6 * len(loads))
    assert side.totals.moment == pytest.approx(sum(4e-3 * index * load for index, load in enumerate(loads)))
    ranks = sorted(patch.rank for patch in side.patches[: side.patch_count])
    assert ranks == ([0] if sum(loads) < 0 else list(range(1, side.patch_count + 1)))


def test_what_a_region_carries_stays_in_it():
    """Its normal is its own."""
    side = filled((5.0, -1.0, 4.0), [(0, 0, 5.0), (1, 0, -2.0), (1, 1, 1.0), (2, 1, 4.0)])
    finish_patches(side)
    assert carried(side)[0] == [4.0, 4.0]
    assert [list(patch.loads) for patch in side.patches[:2]] == [[3.0, 1.0, 0.0, 0.0], [0.0, 4.0, 0.0, 0.0]]


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e6])
def test_centroids_and_widths_hang_on_no_size_of_the_load(scale):
    side = filled((5.0 * scale, 3.0 * scale, 4.0 * scale))
    for index, patch in enumerate(side.patches[:3]):
        complete_totals(patch.totals)
        assert patch.totals.centroid == pytest.approx(4e-3 * index, rel=1e-14)
        assert patch.totals.width == pytest.approx(2e-3, rel=1e-12)
