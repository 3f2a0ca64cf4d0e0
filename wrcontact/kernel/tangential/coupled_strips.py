"""Coupled strips: creep force of any patch, strip by strip.

Each strip has its stick zone (stick_zone.py) and its slip zone (slip_march.py), with the stiffness that it
has beside the others on one half-space (stiffness.py).  What an ellipse with the patch's area and length over
width is known to differ by from the complete theory comes to the sum (correction.py).  Sums over a strip:

    int p dx = sum_q p_q a pi/(n + 1) sin t_q - c (e - (0, k)) (pi/2) m (a - d)^2,   x_q = a cos t_q   (T1)
    int x p_y dx = sum_q x_q p_q,y a pi/(n + 1) sin t_q - c (e_y - k) (pi/2) m (a - d)^2 d            (T2)

in which the second root of eq. (Z1) is integrated exactly.
"""

from math import pi, sqrt

from ..layout import ROLLING_STRIP_LIMIT, Patch, Rolling, RollingStrip, Tables
from .correction import correct_force
from .slip_march import march_strips, open_marches, set_pushes, set_stick
from .stick_zone import find_stick_zone
from .stiffness import find_stiffnesses, stiffnesses_at
from .tractions import add_strip, bound_rate, patch_area, point_weight


def solve_strips(tables: Tables, rolling: Rolling, patch: Patch):
    """Force, moment, stick share and largest traction of a patch."""
    find_stiffnesses(tables, rolling, patch)
    add_strips(tables, rolling, patch)
    if not rolling.bare:
        correct_force(tables, patch)


def add_strips(tables: Tables, rolling: Rolling, patch: Patch):
    """What the strips add up to, without correction."""
    march = rolling.march
    marches = rolling.marches
    ratio = patch.half_length / patch.half_width
    plane, spinning = flexibilities(patch)
    open_marches(marches, ratio)
    stuck = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        rate = bound_rate(patch, strip)
        if rate > 0.0:
            begin_march(rolling, patch, strip, rate, i)
            find_stick_zone(march, strip.width, ratio)
            set_pushes(march, marches, i, plane, spinning, ratio)
            set_stick(tables.rolling, march, marches, i)
            stuck += 2.0 * (march.half_length - march.depth) * march.weight * strip.width
    march_strips(tables.rolling, marches)
    finish_marches(rolling, patch)
    patch.stick_share = stuck / patch_area(patch)


def flexibilities(patch: Patch):
    """i1/K1 and i3/K3 [1/m] of eq. (M3)."""
    first = 0.0
    second = 0.0
    third = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        area = strip.half_length * strip.width
        first += area
        second += area * strip.half_length
        third += area * strip.half_length * strip.half_length
    return 0.5 * pi * first / second, 0.75 * pi * second / third


def begin_march(rolling: Rolling, patch: Patch, strip: RollingStrip, rate: float, index: int):
    """Creepages and stiffnesses of a strip."""
    march = rolling.march
    march.half_length = strip.half_length
    march.rate = rate
    march.slip = strip.slip
    march.lateral = patch.creepage_y + patch.spin * strip.x
    march.spin = patch.spin
    along, across, turning = stiffnesses_at(rolling.blocks, index, strip.station)
    march.along = along
    march.across = across
    march.turning = turning


def finish_marches(rolling: Rolling, patch: Patch):
    """Add the strips' forces, eqs. (T1), (T2), and find the largest traction."""
    marches = rolling.marches
    largest = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        unit = bound_rate(patch, strip) * strip.half_length
        square = marches.largest[i] * unit * unit
        if square > largest:
            largest = square
        if unit > 0.0:
            unit *= point_weight(strip)
            add_strip(patch, strip, unit * marches.sum_x[i], unit * marches.sum_y[i],
                      unit * strip.half_length * marches.sum_moment[i])
    patch.max_shear = sqrt(largest)
