"""provisional"""
from math import cos, fabs, pi, sqrt

from ..layout import RollingPatch, SolvedPatches


def cut_patch(solved: SolvedPatches, index: int, rolling: RollingPatch):
    """provisional: an ellipse"""
    patch = solved.patches[index]
    totals = patch.totals
    rolling.load = totals.load
    ratio = 2.0 * totals.max_half_length / totals.width
    rolling.half_width = sqrt(totals.area / (pi * ratio))
    rolling.half_length = ratio * rolling.half_width
    rolling.count = 16
    low = totals.start
    for k in range(16):
        strip = rolling.strips[k]
        high = 0.5 * (totals.start + totals.stop) - 0.5 * totals.width * cos((k + 1) * pi / 16.0)
        strip.station = 0.5 * (low + high)
        strip.y = strip.station - totals.centroid
        strip.width = high - low
        strip.x = patch.slant * strip.y
        t = (strip.station - 0.5 * (totals.start + totals.stop)) / (0.5 * totals.width)
        strip.half_length = rolling.half_length * sqrt(fabs(1.0 - t * t))
        strip.line_load = totals.load / totals.width
        low = high
    return 0
