"""The first runs of strips: where ANALYN's levels, eq. (S9), are above zero; and what these levels carry."""

from math import pi, sqrt
from typing import Final

from ..contact.penetrated import limited
from ..layout import StripProblem, Waves
from .strip_runs import add_run, adopt_runs, raise_axes, run_station
from .strip_surfaces import between, interval, way_through

#: A first run is where ANALYN's level is above zero, and reaches this share of its zone's depth.
RAISED: Final[float] = 0.02
#: A zone is a shoulder of the one that it touches where the overlap falls no lower between them than to this
#: share of its depth.
SHOULDER: Final[float] = 0.99
#: Steps of Newton's method to the levels that carry the force.
LEVEL_ITERATIONS: Final[int] = 6
#: The middle of a strip begins before its ridge by no more than this share of its axis.
FIRST_LEAD: Final[float] = 0.5


def begin_runs(problem: StripProblem, waves: Waves):
    """The first runs, where ANALYN's level is above zero."""
    problem.next_count = 0
    low = 0
    while low < problem.traced_count:
        high = low
        while high < problem.traced_count - 1 and is_one_curve(problem, high):
            high += 1
        begin_curve(problem, low, high)
        low = high + 1
    adopt_runs(problem)
    problem.count = problem.run_count * waves.count
    for k in range(problem.run_count):
        run = problem.runs[k]
        first = k * waves.count
        j = interval(problem, run.low, run.high, run_station(run, 0.0))
        zone = problem.zones[problem.traced[j].region]
        j = run.low
        for i in range(waves.count):
            strip = problem.strips[first + i]
            station = run_station(run, waves.cos[i])
            j = interval(problem, j, run.high, station)
            strip.axis = level_length(problem, j, station) / waves.sin[i]
            strip.lead = limited(zone.lean * (station - zone.middle), FIRST_LEAD * strip.axis)
        raise_axes(problem, first, waves.count)


def is_one_curve(problem: StripProblem, i: int) -> bool:
    """Whether a run may go on from traced station ``i`` to the next one: within a zone, and where two zones
    meet of which one is a shoulder of the other."""
    at = problem.traced[i]
    following = problem.traced[i + 1]
    one = at.joined
    if one and at.region != following.region:
        shallower = min(problem.zones[at.region].depth, problem.zones[following.region].depth)
        one = min(at.overlap, following.overlap) > SHOULDER * shallower
    return one


def deepen_levels(problem: StripProblem, force: float):
    """Raise the levels until they carry ``force`` [N] as ANALYN has it, and how far [m].

    The load is convex over the rise, so that Newton's method comes from one side.
    """
    rise = 0.0
    for repeat in range(LEVEL_ITERATIONS):
        load = 0.0
        stiffness = 0.0
        for i in range(problem.traced_count):
            at = problem.traced[i]
            zone = problem.zones[at.region]
            line = zone.line * at.counted * zone.spacing
            level = at.level + rise * at.share
            if level > 0.0:
                load += line * level
                stiffness += line * at.share
        if stiffness > 0.0:
            rise += (force - load) / stiffness
    for i in range(problem.traced_count):
        at = problem.traced[i]
        at.level += rise * at.share
    return rise


def level_contact(problem: StripProblem):
    """Load [N], as far as it counts, and largest pressure [Pa] that the levels have."""
    load = 0.0
    square = 0.0
    for i in range(problem.traced_count):
        at = problem.traced[i]
        zone = problem.zones[at.region]
        if at.level > 0.0:
            load += zone.line * at.level * at.counted * zone.spacing
            square = max(square, zone.line * zone.line * at.level * zone.one_alpha * at.A)
    return load, 2.0 / pi * sqrt(square)


def begin_curve(problem: StripProblem, low: int, high: int):
    """The first runs of the curve of stations ``low`` ... ``high``."""
    i = low
    while i <= high:
        last = i
        if problem.traced[i].level > 0.0:
            highest = 0.0
            while last <= high and problem.traced[last].level > 0.0:
                highest = max(highest, problem.traced[last].level)
                last += 1
            last -= 1
            start = level_end(problem, i, i - 1, low, high)
            stop = level_end(problem, last, last + 1, low, high)
            zone = problem.zones[problem.traced[i].region]
            if highest > RAISED * zone.depth:
                add_run(problem, low, high, start, stop)
        i = last + 1


def level_end(problem: StripProblem, inside: int, outside: int, low: int, high: int):
    """Station [m] where the level falls to zero from a station to one beside it, or where the curve ends."""
    at = problem.traced[inside]
    station = at.station
    if outside >= low and outside <= high:
        beyond = problem.traced[outside]
        station += (beyond.station - at.station) * at.level / (at.level - beyond.level)
    elif outside < low:
        station = problem.zones[at.region].start
    else:
        station = problem.zones[at.region].stop
    return station


def level_length(problem: StripProblem, j: int, station: float):
    """Half-length [m] of a strip at ``station`` [m] behind station ``j``, as ANALYN has it."""
    low = problem.traced[j]
    high = problem.traced[j + 1]
    u = way_through(problem, j, station)
    level = max(between(low.level, high.level, u), 0.0)
    return sqrt(level / (problem.zones[low.region].one_alpha * between(low.A, high.A, u)))
