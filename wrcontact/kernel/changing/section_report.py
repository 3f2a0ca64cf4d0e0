"""The outputs that only rails whose section changes have."""

from ..layout import PATCH_LIMIT, Work


def report_slopes(work: Work, index: int):
    """The slopes of the patches of side ``index`` that are reported."""
    side = work.sides[index]
    for number in range(side.patch_count):
        patch = side.patches[number]
        if patch.rank > 0 and patch.rank <= PATCH_LIMIT:
            work.outputs.left[index].patch[patch.rank - 1].slope = patch.slope
