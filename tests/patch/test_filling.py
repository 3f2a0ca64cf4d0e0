"""Patches that carry nothing in sum are taken away: by hand, and what all carry together stays."""

import numpy as np
import pytest

from wrcontact.kernel.layout import SolvedPatches, size
from wrcontact.kernel.patch.filling import add_part, finish_patches


def filled(loads, parts=None):
    """Solved patches 2 mm wide, every 4 mm, with these ``loads`` [N] at their middles, and their ``parts``:
    patch, region, load; one in region 0 each unless given."""
    solved = SolvedPatches.at(np.zeros(size(SolvedPatches)))
    solved.count = len(loads)
    for index, load in enumerate(loads):
        patch = solved.patches[index]
        patch.rail = 4e-3 * index
        patch.totals.load, patch.totals.moment, patch.totals.area = load, load * patch.rail, 1e-6
        patch.totals.start, patch.totals.stop = patch.rail - 1e-3, patch.rail + 1e-3
    for index, region, load in parts or [(index, 0, load) for index, load in enumerate(loads)]:
        add_part(solved, index, region, load, load * 4e-3 * index)
    return solved


def carried(solved):
    """Loads of the patches, of their parts, and where the patches are."""
    count = solved.count
    parts = [sum(solved.parts[k].load for k in range(solved.part_count) if solved.parts[k].patch == index)
             for index in range(count)]
    patches = [solved.patches[index] for index in range(count)]
    return [patch.totals.load for patch in patches], parts, [patch.rail for patch in patches]


@pytest.mark.parametrize("loads, wanted, places",
                         [((5.0, 3.0), [5.0, 3.0], [0, 1]),
                          ((5.0, -3.0), [2.0], [0]),
                          ((-3.0, 5.0), [2.0], [1]),
                          ((5.0, -3.0, 4.0), [2.0, 4.0], [0, 2]),
                          ((5.0, -7.0, 4.0), [2.0], [2]),
                          ((-1.0, -1.0, 5.0), [3.0], [2]),
                          ((0.0, 5.0), [5.0], [1]),
                          ((-1.0,), [-1.0], [0])], ids=str)
def test_a_patch_without_load_counts_for_the_one_before_or_behind(loads, wanted, places):
    solved = filled(loads)
    finish_patches(solved)
    found, parts, where = carried(solved)
    assert found == parts == wanted and where == [4e-3 * place for place in places]
    assert solved.totals.load == sum(loads) and solved.totals.area == pytest.approx(1e-6 * len(loads))
    assert solved.totals.moment == pytest.approx(sum(4e-3 * index * load for index, load in enumerate(loads)))
    ranks = sorted(solved.patches[index].rank for index in range(solved.count))
    assert ranks == ([0] if sum(loads) < 0 else list(range(1, solved.count + 1)))


def test_what_a_region_carries_stays_in_it():
    """Its normal is its own."""
    solved = filled((5.0, -1.0, 4.0), [(0, 0, 5.0), (1, 0, -2.0), (1, 1, 1.0), (2, 1, 4.0)])
    finish_patches(solved)
    found = [(part.patch, part.region, part.load)
             for part in (solved.parts[k] for k in range(solved.part_count)) if part.load]
    assert carried(solved)[0] == [4.0, 4.0] and found == [(0, 0, 3.0), (0, 1, 1.0), (1, 1, 4.0)]
