"""Where one wheel's load jumps, on the way from one end of a bracket of the roll to the other.

The difference of heights that is bracketed (enclosing.py) does not show where in the bracket it jumps, so that
halving takes a trial of both wheels for each bit.  Here the height between both ends is interpolated, since the
other wheel is steady, and the wheel that jumps is followed by itself.  Mostly its regions change: one comes or goes,
or another one becomes the deepest.  The deepest points show that without any load: a region changes where a saddle is
as deep as penetration_maxima.MERGE permits, or where two points are equally deep.  Where regions stay, since a curvature
jumps, the wheel's load is compared.

The interpolated height is off by the square of the bracket's width, and so is the place of the jump: some trials
beside it narrow the bracket to what rounding leaves.
"""

from math import fabs
from typing import Final

from ..contact.penetration_maxima import follow_overlaps, keep_points, region_pattern
from ..contact.overlaps import list_deep_points
from ..layout import MODEL_HERTZ, REGION_LIMIT, UNLOADED, Tables, Work, seldom
from ..search.roll import follow_side, turn_both
from .residuals import balance_side

#: Steps to a jump at most.
JUMP_STEPS: Final[int] = 40
#: What a step finds.
SAME: Final[int] = 0
OTHER: Final[int] = 1
LOST: Final[int] = 2
#: The next trial is beyond the change by no less than this [m], so that it is enclosed.
LEAST_BEYOND: Final[float] = 2e-13


@seldom
def find_jump(tables: Tables, work: Work, index: int, force: float, roll: float, missed: float, steep: bool):
    """Where the next trial of a bracket is [rad], from its end at ``roll`` on, at which the sides are: beside
    the jump of side ``index`` under ``force`` [N], and beyond it from the nearer end by what a height that
    is ``missed`` by so much [m] asks for.  The end at ``roll`` itself where none is found.  Loads are compared where
    the bracket is ``steep``."""
    bracket = work.roll_bracket
    jump = work.jump
    jump.roll = roll
    jump.height = bracket.at_high
    jump.turn = bracket.low - bracket.high
    jump.climb = bracket.at_low - bracket.at_high
    jump.sign = float(1 - 2 * index)
    if roll == bracket.low:
        jump.height = bracket.at_low
        jump.turn = -jump.turn
        jump.climb = -jump.climb
        jump.sign = -jump.sign
    width = tables.arm * fabs(jump.turn)
    sharp = max(missed, LEAST_BEYOND) / width
    work.contact.filling = False
    work.contact.following = True
    jump.pattern = -1
    jump.near = 1.0
    list_deep_points(tables.pairs[index], work.contact.overlap, work.sides[index], jump.height)
    if work.contact.overlap.count <= REGION_LIMIT:
        keep_points(work.contact.overlap, work.contact.changing)
        jump.pattern = region_pattern(work.contact.overlap, tables.normal_model == MODEL_HERTZ)
        narrow_jump(tables, work, index, force, 0.25 * sharp)
    if jump.near == 1.0 and steep:
        jump.pattern = -1
        narrow_jump(tables, work, index, force, 0.25 * sharp)
    work.contact.following = False
    share = jump.near - sharp
    if jump.near < 0.5:
        share = jump.far + sharp
    if jump.near == 1.0:
        share = 0.0
    return roll + share * jump.turn


@seldom
def narrow_jump(tables: Tables, work: Work, index: int, force: float, sharp: float):
    """Narrow the part of the bracket, from ``near`` to ``far``, in which the side jumps, to ``sharp`` [-];
    ``near`` is 1 where it does not jump."""
    jump = work.jump
    near = 0.0
    far = 1.0
    lost = 1.0
    jumps = jump.pattern < 0
    step = 1.0
    if jumps:
        step = 0.5
    for i in range(JUMP_STEPS):
        share = near + step
        turn_both(work.sides, jump.roll + share * jump.turn)
        if jump.pattern >= 0:
            compared = compare_pattern(tables, work, index, jump.height + share * jump.climb)
        else:
            compared = compare_load(tables, work, index, force, jump.height + share * jump.climb)
        if compared == LOST:
            lost = share
            step *= 0.5
        elif compared == SAME:
            near = share
            step = far - near
            if jumps:
                step *= 0.5
        else:
            jumps = True
            far = share
            step = 0.5 * (far - near)
        if step < sharp:
            break
    if lost > near and lost < far:
        far = lost
    jump.near = near
    jump.far = far


@seldom
def compare_pattern(tables: Tables, work: Work, index: int, height: float) -> int:
    """Whether side ``index`` has the same regions at ``height`` [m], at the roll to which it is turned: SAME,
    and the points that are followed are those here; OTHER; or LOST, where they cannot be followed."""
    overlap = work.contact.overlap
    changing = work.contact.changing
    pair = tables.pairs[index]
    if follow_overlaps(pair, overlap, changing, work.sides[index].place, height) == 0:
        return LOST
    compared = OTHER
    if region_pattern(overlap, tables.normal_model == MODEL_HERTZ) == work.jump.pattern:
        compared = SAME
        keep_points(overlap, changing)
    return compared


@seldom
def compare_load(tables: Tables, work: Work, index: int, force: float, height: float) -> int:
    """Whether side ``index`` carries more than ``force`` [N] at ``height`` [m], or less, as at the first end
    of the bracket: SAME; OTHER; or LOST, where it is not known."""
    if not follow_side(tables.pairs[index], work.sides[index]):
        return LOST
    if balance_side(tables, work, index, force, height) > UNLOADED:
        return LOST
    compared = OTHER
    if work.jump.sign * (work.supports[index].height - height) > 0.0:
        compared = SAME
    return compared
