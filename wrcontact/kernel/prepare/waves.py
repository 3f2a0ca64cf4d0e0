"""What the strips of a run have from their number n alone; eqs. (S10) ... (S13) of docs/theory.

Strip i lies at the angle t_i = (i + 1/2) pi / n along the run, s = middle - half cos t.  A smooth function of
the run is a sum of the cosines cos(m t), m < n, through its values at the strips.
"""

from math import fabs, pi

from ..elementary.circle import sine_cosine
from ..elementary.powers import log
from ..layout import FINE_WAVES, Waves


def wave(m: int, i: int, count: int):
    """cos(m t) at the angle t = (i + 1/2) pi / ``count``."""
    sine, cosine = sine_cosine(float(m * (2 * i + 1) % (4 * count)) * 0.5 * pi / float(count))
    return cosine


def write_waves(waves: Waves, count: int):
    """All of the table for runs of ``count`` strips."""
    waves.count = count
    fine = FINE_WAVES * count
    for i in range(count):
        write_strip(waves, i, count)
    for k in range(fine):
        sine, cosine = sine_cosine((float(k) + 0.5) * pi / float(fine))
        waves.fine_sin[k] = sine
        waves.fine_cos[k] = cosine
        for i in range(count):
            smooth = 0.5
            for m in range(1, count):
                smooth += wave(m, i, count) * wave(m, k, fine)
            waves.smoothing[i][k] = 2.0 * smooth / float(fine)
            waves.refining[k][i] = 2.0 * smooth / float(count)
        for j in range(fine):
            rough = 0.0
            for m in range(count, fine):
                rough += float(m) * wave(m, k, fine) * wave(m, j, fine)
            waves.roughness[k][j] = 2.0 * rough / float(fine)


def write_strip(waves: Waves, i: int, count: int):
    """Angle, weights and the row of eq. (S11) of strip ``i``."""
    sine, cosine = sine_cosine((float(i) + 0.5) * pi / float(count))
    waves.sin[i] = sine
    waves.cos[i] = cosine
    waves.spread[i] = log(float(count) / (pi * sine))
    start = 0.5
    stop = 0.5
    sign = 1.0
    for m in range(1, count):
        sign = -sign
        start += wave(m, i, count)
        stop += sign * wave(m, i, count)
    waves.start[i] = 2.0 * start / float(count)
    waves.stop[i] = 2.0 * stop / float(count)
    for j in range(count):
        left = -log(2.0)
        for m in range(1, count):
            left -= 2.0 * wave(m, i, count) * wave(m, j, count) / float(m)
        if j != i:
            left -= log(fabs(wave(1, i, count) - wave(1, j, count)))
        waves.singular[i][j] = 2.0 * left
