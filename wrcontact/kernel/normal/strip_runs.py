"""Runs of loaded strips: which strips they have, and how they part and join.

A run lies between two edges on one curve of traced stations.  Its n strips lie at

    s_i = middle - half cos t_i,    t_i = (i + 1/2) pi / n                                          (S10)

closer together towards the edges, where half-length and pressure fall to zero like sin t.
"""

from math import pi, sqrt
from typing import Final

from ..contact.penetrated import limited
from ..elementary.powers import log
from ..layout import FINE_WAVES, STRIP_RUN_LIMIT, Strip, StripProblem, StripRun, TracedStation, Waves, copy
from .strip_surfaces import between, interval, rest_gap, way_through

#: Axes of a new run are no less than this share of its largest.
FLAT_START: Final[float] = 0.25
#: Runs, and gaps between two runs, that are narrower than this share of their zone are none.
NARROW: Final[float] = 0.02
#: A strip pulls where its pressure is below this share of the largest one, with the other sign.
PULLING: Final[float] = 1e-3
#: A part of a run that is a single strip counts from this share of the largest pressure on.
SINGLE: Final[float] = 0.1


def raise_axes(problem: StripProblem, first: int, count: int):
    """Raise the axes of a run that begins with strip ``first`` to their smallest."""
    largest = 0.0
    for i in range(first, first + count):
        largest = max(largest, problem.strips[i].axis)
    for i in range(first, first + count):
        strip = problem.strips[i]
        strip.axis = max(strip.axis, FLAT_START * largest)


def add_run(problem: StripProblem, low: int, high: int, start: float, stop: float):
    """Add a run between two stations [m] of a curve to the next ones, if it is wide enough; joined to the
    last one where they meet.  Where there is no room, the narrowest one goes."""
    zone = problem.zones[problem.traced[low].region]
    least = NARROW * (zone.stop - zone.start)
    joins = False
    if problem.next_count > 0:
        before = problem.next_runs[problem.next_count - 1]
        if before.low == low and start - before.next_stop < least:
            joins = True
            before.next_start = min(before.next_start, start)
            before.next_stop = max(before.next_stop, stop)
            before.origin = -1
    room = False
    if stop - start > least and not joins:
        room = has_room(problem, stop - start)
    if room:
        run = problem.next_runs[problem.next_count]
        run.low = low
        run.high = high
        run.next_start = start
        run.next_stop = stop
        run.start_move = 0.0
        run.stop_move = 0.0
        run.origin = -1
        problem.next_count = problem.next_count + 1


def has_room(problem: StripProblem, width: float) -> bool:
    """Whether there is room for another run of this ``width`` [m], if need be in place of the narrowest."""
    if problem.next_count < STRIP_RUN_LIMIT:
        return True
    narrowest = 0
    for k in range(1, problem.next_count):
        if run_width(problem.next_runs[k]) < run_width(problem.next_runs[narrowest]):
            narrowest = k
    if not run_width(problem.next_runs[narrowest]) < width:
        return False
    for k in range(narrowest, problem.next_count - 1):
        copy(problem.next_runs[k + 1], problem.next_runs[k])
    problem.next_count = problem.next_count - 1
    return True


def run_width(run: StripRun):
    """Width of a run of the next sweep [m]."""
    return run.next_stop - run.next_start


def adopt_runs(problem: StripProblem):
    """Let the next runs be those of this sweep."""
    for k in range(problem.next_count):
        copy(problem.next_runs[k], problem.runs[k])
        run = problem.runs[k]
        run.start = run.next_start
        run.stop = run.next_stop
    problem.run_count = problem.next_count


def run_station(run: StripRun, cosine: float):
    """Station [m] of a run at the angle with this cosine, eq. (S10)."""
    return 0.5 * (run.start + run.stop) - 0.5 * (run.stop - run.start) * cosine


def gap_beside(strip: Strip, x: float):
    """Rise of the gap [m] at a distance ``x`` from the ridge.

    Its sides differ no more than where they were measured: beyond, a cubic would turn over, and each side
    keeps its own curvature.
    """
    return x * x * (strip.A + limited(strip.skew * x, strip.odd))


def lay_strips(problem: StripProblem, waves: Waves, smooth: bool):
    """Wheel and rail under all strips, their half-lengths, widths and gaps; these as the smooth part of the
    gap has them, or as they are just there."""
    count = waves.count
    for k in range(problem.run_count):
        run = problem.runs[k]
        j = run.low
        spread = 0.5 * (run.stop - run.start) * pi / float(count)
        for i in range(count):
            strip = problem.strips[k * count + i]
            strip.station = run_station(run, waves.cos[i])
            j = interval(problem, j, run.high, strip.station)
            lay_strip(strip, problem.traced[j], problem.traced[j + 1], way_through(problem, j, strip.station))
            strip.half_length = strip.axis * waves.sin[i]
            strip.square = strip.half_length * strip.half_length
            strip.middle = strip.x + strip.lead
            strip.width = spread * waves.sin[i] * strip.stretch
            strip.slender = log(strip.width / strip.half_length)
            if not smooth:
                strip.gap = rest_gap(problem, j, strip.station)
        if smooth:
            smooth_gaps(problem, waves, run, k * count)
        for i in range(k * count, (k + 1) * count):
            strip = problem.strips[i]
            strip.gap += gap_beside(strip, strip.lead)


def smooth_gaps(problem: StripProblem, waves: Waves, run: StripRun, first: int):
    """The gap at the fine strips of a run that begins with strip ``first``, and under its strips what the
    first cosines are of it."""
    fine = FINE_WAVES * waves.count
    j = run.low
    for i in range(fine):
        station = run_station(run, waves.fine_cos[i])
        j = interval(problem, j, run.high, station)
        run.gaps[i] = rest_gap(problem, j, station)
    for pair in range((waves.count + 1) // 2):
        # two sums at a time, as neither waits for the other; the last strip may be in two pairs
        i = 2 * pair
        j = min(i + 1, waves.count - 1)
        weights = waves.smoothing[i]
        next_weights = waves.smoothing[j]
        gap = 0.0
        next_gap = 0.0
        for m in range(fine):
            gap += weights[m] * run.gaps[m]
            next_gap += next_weights[m] * run.gaps[m]
        problem.strips[first + i].gap = gap
        problem.strips[first + j].gap = next_gap


def lay_strip(strip: Strip, low: TracedStation, high: TracedStation, u: float):
    """Wheel and rail under a strip that lies ``u`` of the way between two traced stations."""
    strip.region = low.region
    if u > 0.5:
        strip.region = high.region
    strip.place = between(low.place, high.place, u)
    strip.stretch = between(low.stretch, high.stretch, u)
    strip.cos = between(low.cos, high.cos, u)
    strip.sin = between(low.sin, high.sin, u)
    strip.x = between(low.x, high.x, u)
    strip.A = between(low.A, high.A, u)
    strip.skew = between(low.skew, high.skew, u)
    strip.odd = between(low.odd, high.odd, u)
    strip.share = between(low.share, high.share, u)
    strip.counted = between(low.counted, high.counted, u)


def renew_runs(problem: StripProblem, waves: Waves):
    """The runs of the next sweep: those that pull are cut or dropped, and those that have met are joined."""
    count = waves.count
    largest = 0.0
    for i in range(problem.count):
        largest = max(largest, problem.strips[i].y)
    problem.next_count = 0
    for k in range(problem.run_count):
        part_run(problem, waves, k, largest)
    if problem.next_count == 0:
        # nothing presses any more: the strips stay, and the force will press them
        for k in range(problem.run_count):
            keep_run(problem, k)
    for k in range(problem.next_count):
        after = problem.next_runs[k]
        for i in range(count):
            strip = problem.strips[k * count + i]
            if after.origin >= 0:
                strip.axis = problem.strips[after.origin * count + i].next_axis
                strip.lead = problem.strips[after.origin * count + i].next_lead
            else:
                middle = 0.5 * (after.next_start + after.next_stop)
                station = middle - 0.5 * (after.next_stop - after.next_start) * waves.cos[i]
                half, lead = sample_strips(problem, waves, after.low, station)
                strip.axis = half / waves.sin[i]
                strip.lead = lead
        if after.origin < 0:
            raise_axes(problem, k * count, count)
    adopt_runs(problem)
    problem.count = problem.run_count * count


def keep_run(problem: StripProblem, k: int):
    """Add run ``k`` to the next runs, with its strips."""
    run = problem.runs[k]
    add_run(problem, run.low, run.high, run.next_start, run.next_stop)
    last = problem.next_count - 1
    if last >= 0 and problem.next_runs[last].next_start == run.next_start:
        # neither joined nor left out
        kept = problem.next_runs[last]
        kept.origin = k
        kept.start_move = run.start_move
        kept.stop_move = run.stop_move


def part_run(problem: StripProblem, waves: Waves, k: int, largest: float):
    """Add what is pressed of run ``k`` to the next runs; the largest y of all strips is given."""
    run = problem.runs[k]
    count = waves.count
    first = k * count
    limit = -PULLING * largest
    pulling = 0
    for i in range(1, count - 1):
        if problem.strips[first + i].y < limit:
            pulling += 1
    if pulling == 0:
        keep_run(problem, k)
    else:
        i = 0
        while i < count:
            last = i
            if problem.strips[first + i].y >= limit:
                while last < count - 1 and problem.strips[first + last + 1].y >= limit:
                    last += 1
                if last > i or problem.strips[first + i].y > SINGLE * largest:
                    add_run(
                        problem,
                        run.low,
                        run.high,
                        pressed_end(problem, waves, k, i, -1),
                        pressed_end(problem, waves, k, last, 1),
                    )
            i = last + 1


def pressed_end(problem: StripProblem, waves: Waves, k: int, i: int, outward: int):
    """Station [m] where the pressure of run ``k`` falls to zero beyond its strip ``i``, or its edge."""
    run = problem.runs[k]
    beyond = i + outward
    station = run.next_start
    if beyond >= waves.count:
        station = run.next_stop
    elif beyond >= 0:
        inner = problem.strips[k * waves.count + i].y
        outer = problem.strips[k * waves.count + beyond].y
        station = problem.strips[k * waves.count + i].next_station
        way = problem.strips[k * waves.count + beyond].next_station - station
        station += way * max(inner, 0.0) / (max(inner, 0.0) - outer)
    return station


def sample_strips(problem: StripProblem, waves: Waves, low: int, station: float):
    """Half-length and lead [m] at ``station`` [m] on the straight line between the strips to either side on
    the curve that begins with traced station ``low``."""
    before = -1
    after = -1
    for k in range(problem.run_count):
        if problem.runs[k].low == low:
            for i in range(k * waves.count, (k + 1) * waves.count):
                strip = problem.strips[i]
                if strip.next_station <= station:
                    if before < 0 or strip.next_station > problem.strips[before].next_station:
                        before = i
                elif after < 0 or strip.next_station < problem.strips[after].next_station:
                    after = i
    if before < 0:
        before = after
    if after < 0:
        after = before
    lower = problem.strips[before]
    upper = problem.strips[after]
    u = 0.0
    if upper.next_station > lower.next_station:
        u = (station - lower.next_station) / (upper.next_station - lower.next_station)
    return between(lower.next_half, upper.next_half, u), between(lower.next_lead, upper.next_lead, u)
