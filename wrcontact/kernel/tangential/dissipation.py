"""Friction takes power: where a model would give some back, its moment is changed.

In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes

    P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)

with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
almost everywhere.  In one of some thousand cases, with spin on long patches, the error of the moment makes P
negative; there the moment is the one with P = 0.  Forces stay as they are, and nothing jumps.
"""

from ..layout import RollingPatch


def keep_dissipating(rolling: RollingPatch):
    """Change the moment where it would be a gain of power, eq. (W1), but to no more than friction has."""
    gain = (rolling.creepage_x * rolling.force_x + rolling.creepage_y * rolling.force_y
            + rolling.spin * rolling.moment + bent_gain(rolling))
    if gain > 0.0 and rolling.spin != 0.0:
        reach = rolling.half_length
        if reach < rolling.half_width:
            reach = rolling.half_width
        most = rolling.friction * rolling.load * reach
        moment = rolling.moment - gain / rolling.spin
        if moment > most:
            moment = most
        if moment < -most:
            moment = -most
        rolling.moment = moment
    return 0


def bent_gain(rolling: RollingPatch):
    """The sum of eq. (W1), which is zero in a plane patch."""
    gain = 0.0
    for i in range(rolling.count):
        strip = rolling.strips[i]
        plane = rolling.creepage_x - rolling.spin * strip.y
        gain += (strip.slip - plane) * strip.force_x * strip.width
    return gain
