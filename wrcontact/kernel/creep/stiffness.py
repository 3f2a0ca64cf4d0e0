"""Linear theory of strips that roll side by side on one half-space: how stiff each of them is.

A strip j carries the traction X_j sqrt((a - x)/(a + x)), zero at the leading edge a, or in spin X_j
sqrt(1 - (x/a)^2).  That its neighbours move the surface below strip i, weighted along i, gives

    (2 (1 - nu) / G) sum_j Phi_ij X_j = -w_i                                                    (K1)
    Phi_ij = S((e_{j+1} - y_i) / a_ij) - S((e_j - y_i) / a_ij),   a_ij^2 = (a_i^2 + a_j^2) / 2  (K2)

for longitudinal creepage; e_j are the strips' edges, y_i their middles.  For lateral creepage and for spin
2/G stands for 2 (1 - nu)/G, and each of the three has its own odd function S, with S(infinity) = 1/2
(tools/tables/rolling_table.py), so that one infinitely wide strip is Carter's.  With unit creepages

    K1 = f1 G / (2 (1 - nu)) Phi_x^-1 1,   K2 = f2 (G/2) Phi_y^-1 1,   K3 = f3 (G/2) (Phi_s^-1 a) / a   (K3)

in which the factors f, of the patch's length over width, make the force of an ellipse exactly Kalker's.
Creepages w_x that change across a patch without symmetry ask for more or less in sum than K1 w_x, whose
stiffnesses are those of a uniform one.  Where strips begin to slip, the uniform creepage which makes up for
that comes to w_x:

    delta = (sum(a h Phi_x^-1 w_x) - sum(a h K w_x)) / sum(a h K),   K = Phi_x^-1 1              (K6)

Long patches have the mean of K3, weighted with a^2 and width, in all strips: from a/b = 1.5 to 3 it takes
over.  The equations are solved for pairs of strips; between the middles of pairs stiffnesses follow straight
lines.  None is taken below a small share of their mean: in spin the outermost strips of patches with a/b < 3
would be dragged the other way round by their neighbours, which errs more.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.powers import log
from ..layout import (
    BLOCK_COUNT,
    REACH_CELLS,
    REACH_PER_UNIT,
    REACH_ROW,
    BlockMatrix,
    Patch,
    Rolling,
    RollingBlock,
    RollingBlocks,
    RollingTable,
    Tables,
    copy,
)
from .tractions import shape_place, shape_value

#: Pairs of strips are at least as long as this share of the ellipse.
SHORT: Final[float] = 1e-3
#: Stiffnesses are at least this share of their mean.
SOFTEST: Final[float] = 0.02
#: In place of no distance, whose roots have no slope.
NEAREST: Final[float] = 1e-12
#: ln(a/b) from where on spin's stiffness is no longer that of each strip, and where it is the mean.
OWN_UNTIL: Final[float] = 0.405465108108164381978  # ln 1.5
MEAN_FROM: Final[float] = 1.098612288668109691395  # ln 3


def find_stiffnesses(tables: Tables, rolling: Rolling, patch: Patch):
    """K1, K2, K3 of the blocks of a patch, eqs. (K1) to (K3)."""
    blocks = rolling.blocks
    join_strips(rolling, patch)
    fill_equations(tables.rolling, rolling)
    solve_blocks(rolling.equations_x, 2)
    solve_blocks(rolling.equations_y, 1)
    solve_blocks(rolling.equations_spin, 1)
    ratio = patch.half_length / patch.half_width
    place = shape_place(ratio)
    half = 0.5 * tables.shear_modulus
    along = shape_value(tables.rolling, 3, place) * half / (1.0 - tables.parameters.poisson_ratio)
    across = shape_value(tables.rolling, 4, place) * half
    turning = shape_value(tables.rolling, 5, place) * half
    for i in range(BLOCK_COUNT):
        block = blocks[i]
        block.along = along * rolling.equations_x[i][BLOCK_COUNT]
        block.across = across * rolling.equations_y[i][BLOCK_COUNT]
        block.turning = turning * rolling.equations_spin[i][BLOCK_COUNT] / block.half_length
    rolling.shift = creepage_shift(rolling)
    spread_turning(blocks, mean_share(ratio))


def patch_stiffnesses(tables: Tables, rolling: Rolling, patch: Patch):
    """The same of a patch of which only creepages may have changed, where stiffnesses are kept: with the same
    bits, as only the shift of eq. (K6) depends on creepages."""
    kept = rolling.stiffnesses[rolling.place]
    if rolling.keeping and rolling.kept:
        copy(kept.blocks, rolling.blocks)
        copy(kept.equations_x, rolling.equations_x)
        renew_shift(rolling, patch)
    else:
        find_stiffnesses(tables, rolling, patch)
        if rolling.keeping:
            copy(rolling.blocks, kept.blocks)
            copy(rolling.equations_x, kept.equations_x)


def renew_shift(rolling: Rolling, patch: Patch):
    """The shift of eq. (K6) for new creepages, with the equations that are eliminated already."""
    side = BLOCK_COUNT + 1
    for i in range(BLOCK_COUNT):
        block = rolling.blocks[i]
        row = rolling.equations_x[i]
        block.slip = 0.5 * (patch.strips[2 * i].slip + patch.strips[2 * i + 1].slip)
        row[side] = block.slip
    for k in range(BLOCK_COUNT):
        pivot = rolling.equations_x[k]
        inverse = 1.0 / pivot[k]
        for i in range(k + 1, BLOCK_COUNT):
            row = rolling.equations_x[i]
            factor = row[k] * inverse
            row[side] -= factor * pivot[side]
    substitute(rolling.equations_x, side)
    rolling.shift = creepage_shift(rolling)


def join_strips(rolling: Rolling, patch: Patch):
    """The blocks from pairs of strips: edges, and the mean of a^2."""
    for i in range(BLOCK_COUNT):
        block = rolling.blocks[i]
        low = patch.strips[2 * i]
        high = patch.strips[2 * i + 1]
        block.start = low.start
        block.stop = high.stop
        square = (
            low.half_length * low.half_length * low.width + high.half_length * high.half_length * high.width
        ) / (block.stop - block.start)
        least = SHORT * patch.half_length
        block.half_length = sqrt(square + least * least)
        block.slip = 0.5 * (low.slip + high.slip)


def fill_equations(table: RollingTable, rolling: Rolling):
    """Phi of eq. (K2), and the right-hand sides of unit creepages."""
    for i in range(BLOCK_COUNT):
        block = rolling.blocks[i]
        along = rolling.equations_x[i]
        across = rolling.equations_y[i]
        turning = rolling.equations_spin[i]
        x, y, spin = reaches(table, 0.5 * (block.stop - block.start) / block.half_length)
        along[i] = 2.0 * x
        across[i] = 2.0 * y
        turning[i] = 2.0 * spin
        along[BLOCK_COUNT] = 1.0
        across[BLOCK_COUNT] = 1.0
        turning[BLOCK_COUNT] = block.half_length
        along[BLOCK_COUNT + 1] = block.slip
        for j in range(i + 1, BLOCK_COUNT):
            other = rolling.blocks[j]
            scale = 1.0 / sqrt(
                0.5 * (block.half_length * block.half_length + other.half_length * other.half_length)
            )
            middle = 0.5 * (block.start + block.stop)
            reach_beside(table, rolling, i, j, (other.start - middle) * scale, (other.stop - middle) * scale)
            middle = 0.5 * (other.start + other.stop)
            reach_beside(table, rolling, j, i, (middle - block.stop) * scale, (middle - block.start) * scale)


def reach_beside(table: RollingTable, rolling: Rolling, i: int, j: int, near: float, far: float):
    """Phi of block ``i`` and another one ``j``, whose edges are ``near`` and ``far`` from its middle."""
    near_x, near_y, near_spin = reaches(table, near)
    far_x, far_y, far_spin = reaches(table, far)
    along = rolling.equations_x[i]
    across = rolling.equations_y[i]
    turning = rolling.equations_spin[i]
    along[j] = far_x - near_x
    across[j] = far_y - near_y
    turning[j] = far_spin - near_spin


def reaches(table: RollingTable, distance: float):
    """S of longitudinal and lateral creepage and of spin at a ``distance`` over the half-length, which is not
    negative."""
    place = min(float(REACH_CELLS), REACH_PER_UNIT * sqrt(sqrt(fabs(distance) + NEAREST)))
    cell = int(place)
    u = place - float(cell)
    at = REACH_ROW * cell
    return reach_cubic(table, at, u), reach_cubic(table, at + 4, u), reach_cubic(table, at + 8, u)


def reach_cubic(table: RollingTable, at: int, u: float):
    """The cubic of four numbers from ``at`` on, at ``u``."""
    high = table.reaches[at + 2] + u * table.reaches[at + 3]
    return table.reaches[at] + u * (table.reaches[at + 1] + u * high)


def solve_blocks(equations: BlockMatrix, sides: int):
    """Solve in place by Gauss, for so many right-hand ``sides``, without exchange of rows: the kernel is
    positive, largest on the diagonal."""
    stop = BLOCK_COUNT + sides
    for k in range(BLOCK_COUNT):
        pivot = equations[k]
        inverse = 1.0 / pivot[k]
        for i in range(k + 1, BLOCK_COUNT):
            row = equations[i]
            factor = row[k] * inverse
            for j in range(k + 1, stop):
                row[j] -= factor * pivot[j]
    for side in range(BLOCK_COUNT, stop):
        substitute(equations, side)


def substitute(equations: BlockMatrix, side: int):
    """The solution for one right-hand side of eliminated equations."""
    for back in range(BLOCK_COUNT):
        k = BLOCK_COUNT - 1 - back
        pivot = equations[k]
        value = pivot[side]
        for j in range(k + 1, BLOCK_COUNT):
            known = equations[j]
            value -= pivot[j] * known[side]
        pivot[side] = value / pivot[k]


def creepage_shift(rolling: Rolling):
    """The longitudinal creepage that strips with K1 w_x lack for the force of eq. (K1) with their own
    creepages; delta of eq. (K6)."""
    missing = 0.0
    stiff = 0.0
    for i in range(BLOCK_COUNT):
        block = rolling.blocks[i]
        row = rolling.equations_x[i]
        area = block.half_length * (block.stop - block.start)
        missing += area * (row[BLOCK_COUNT + 1] - row[BLOCK_COUNT] * block.slip)
        stiff += area * row[BLOCK_COUNT]
    return missing / stiff


def mean_share(ratio: float):
    """How much the mean counts in spin's stiffness, by a/b."""
    share = min(max((log(ratio) - OWN_UNTIL) / (MEAN_FROM - OWN_UNTIL), 0.0), 1.0)
    return share


def spread_turning(blocks: RollingBlocks, share: float):
    """Let spin's stiffness be its mean to this share, and keep all stiffnesses above zero."""
    total = 0.0
    mean = 0.0
    along = 0.0
    across = 0.0
    for i in range(BLOCK_COUNT):
        block = blocks[i]
        weight = block.half_length * block.half_length * (block.stop - block.start)
        total += weight
        mean += block.turning * weight
        along += block.along * weight
        across += block.across * weight
    for i in range(BLOCK_COUNT):
        block = blocks[i]
        block.turning += share * (mean / total - block.turning)
        block.turning = not_below(block.turning, SOFTEST * mean / total)
        block.along = not_below(block.along, SOFTEST * along / total)
        block.across = not_below(block.across, SOFTEST * across / total)


def not_below(value: float, least: float):
    """The larger of both."""
    value = max(value, least)
    return value


def stiffnesses_at(blocks: RollingBlocks, index: int, station: float):
    """K1, K2, K3 of strip ``index`` with its middle at ``station`` [m], between the middles of two blocks."""
    own = blocks[index // 2]
    towards = index // 2 - 1
    if index % 2 == 1:
        towards = index // 2 + 1
    along = own.along
    across = own.across
    turning = own.turning
    if towards >= 0 and towards < BLOCK_COUNT:
        other = blocks[towards]
        middle = 0.5 * (own.start + own.stop)
        share = (station - middle) / (0.5 * (other.start + other.stop) - middle)
        along += share * (other.along - along)
        across += share * (other.across - across)
        turning += share * (other.turning - turning)
    return along, across, turning
