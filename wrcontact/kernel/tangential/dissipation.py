"""Friction takes power: what a model would give back is taken out of its result.

In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes

    P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)

with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
almost everywhere: in one of some thousand cases, with spin and long patches, P is a little below zero.  There
the moment is reduced, as far as it drives, and then the force along the slip.  Neither becomes larger, and
both stay continuous.
"""

from ..layout import RollingPatch


def keep_dissipating(rolling: RollingPatch):
    """Take what would be a gain of power, eq. (W1), out of moment and force."""
    x = rolling.creepage_x
    y = rolling.creepage_y
    sliding = x * rolling.force_x + y * rolling.force_y
    turning = rolling.spin * rolling.moment
    gain = sliding + turning + bent_gain(rolling)
    if gain > 0.0 and turning > 0.0:
        less = smaller(turning, gain)
        rolling.moment *= (turning - less) / turning
        gain -= less
    if gain > 0.0 and sliding > 0.0:
        share = smaller(sliding, gain) / (x * x + y * y)
        rolling.force_x -= share * x
        rolling.force_y -= share * y
    return 0


def bent_gain(rolling: RollingPatch):
    """The sum of eq. (W1), which is zero in a plane patch."""
    gain = 0.0
    for i in range(rolling.count):
        strip = rolling.strips[i]
        plane = rolling.creepage_x - rolling.spin * strip.y
        gain += (strip.slip - plane) * strip.force_x * strip.width
    return gain


def smaller(one: float, other: float):
    """The smaller of both."""
    if other < one:
        one = other
    return one
