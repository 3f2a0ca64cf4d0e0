"""Friction takes power: where a model would give some back, its moment is changed.

In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes

    P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)

with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
almost everywhere.  In one of some thousand cases, with spin on long patches, the error of the moment makes P
negative; there the moment is the one with P = 0.  Forces stay as they are, and nothing jumps.
"""

from ..layout import ROLLING_STRIP_LIMIT, Patch


def keep_dissipating(patch: Patch):
    """Change the moment where it would be a gain of power, eq. (W1), but to no more than friction has."""
    gain = creep_gain(patch)
    if gain > 0.0 and patch.spin != 0.0:
        reach = patch.half_length
        if reach < patch.half_width:
            reach = patch.half_width
        most = patch.friction * patch.totals.load * reach
        moment = patch.creep_moment - gain / patch.spin
        if moment > most:
            moment = most
        if moment < -most:
            moment = -most
        patch.creep_moment = moment


def creep_gain(patch: Patch):
    """-P of eq. (W1) [N].  The sum over the strips is zero in a plane patch."""
    gain = (patch.creepage_x * patch.creep_x + patch.creepage_y * patch.creep_y
            + patch.spin * patch.creep_moment)
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        plane = patch.creepage_x - patch.spin * strip.y
        gain += (strip.slip - plane) * strip.force_x * strip.width
    return gain
