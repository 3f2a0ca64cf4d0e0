"""Half-lengths, middles and edges of the strips: from what they displace near their ends, eqs. (S6)-(S8), and
from where their pressures end, eq. (S14)."""

from math import fabs, pi, sqrt
from typing import Final

from ..contact.penetrated import limited
from ..layout import Strip, StripProblem, StripRun, Tables, Waves
from .strip_pressures import TESTED, local_displacement, tested_displacements
from .strip_runs import gap_beside

#: Power of the ratio of displacement and gap by which a half-length is corrected.
POWER: Final[float] = 0.45
#: Share of the move of the middle that is taken, and the longest one, as a share of the half-length.
MOVED: Final[float] = 0.6
FARTHEST_MOVE: Final[float] = 0.3
#: Smallest rise of the gap towards the ends, as a share of that of a parabola.
FLATTEST: Final[float] = 0.1
#: The outermost axes of a run, which follow from the next two, over the next one.
LEAST_END: Final[float] = 0.6
MOST_END: Final[float] = 1.6
#: Largest axis over the longer one beside it.
STEEP: Final[float] = 1.5
#: Smallest axis over the largest one of its run.
FLAT: Final[float] = 0.05
#: A pressure is raised no more than so many times by a shorter half-length.
MOST_RAISED: Final[float] = 1.25
#: Share of the move of an edge that is taken, and the farthest one, of half the run.
RELAXED: Final[float] = 0.5
FARTHEST_EDGE: Final[float] = 0.25
#: Moves to and fro that are shorter than this, of half the run, are no swing.
SWING: Final[float] = 0.05
#: The regular part of a pressure beside an edge is no less than this share of its largest value.
LEAST_ROOT: Final[float] = 0.05


def corrected(ratio: float, power: float):
    """``ratio`` to a ``power`` near it, without ends: Pade's quotient, (1 + power) / (1 - power) at most."""
    more = 1.0 + power
    less = 1.0 - power
    return (less + more * ratio) / (more + less * ratio)


def correct_strip(tables: Tables, problem: StripProblem, first: int, i: int, penetration: float, yawed: bool):
    """Axis of strip ``i`` of the run that begins with strip ``first``, by how much less the surfaces are
    displaced towards its ends than the gap rises; its middle moves to where both ends are alike."""
    strip = problem.strips[first + i]
    half = strip.half_length
    away = TESTED * half
    own = gap_beside(strip, strip.lead)
    front, back = tested_displacements(tables, problem, first + i, away, yawed)
    front_gap = gap_beside(strip, strip.lead + away) - own
    back_gap = front_gap
    strip.next_lead = strip.lead
    if yawed:
        back_gap = gap_beside(strip, strip.lead - away) - own
        move = -MOVED * (front + front_gap - back - back_gap) / (4.0 * strip.A * away)
        strip.next_lead += limited(move, FARTHEST_MOVE * half)
    local = local_displacement(tables, problem, first, i)
    rise = max(0.5 * (front_gap + back_gap), FLATTEST * strip.A * away * away)
    ratio = max(0.0, (strip.share * penetration - strip.gap - local - 0.5 * (front + back)) / rise)
    strip.next_axis = strip.axis * corrected(ratio, POWER)


def correct_lengths(tables: Tables, problem: StripProblem, penetration: float, yawed: bool, share: float):
    """Axes, leads and edges after this sweep, and the pressures that keep the loads."""
    waves = tables.waves
    for k in range(problem.run_count):
        first = k * waves.count
        last = first + waves.count - 1
        for i in range(1, waves.count - 1):
            correct_strip(tables, problem, first, i, penetration, yawed)
        for i in range(first + 1, last):
            limit_axis(problem.strips[i - 1], problem.strips[i], problem.strips[i + 1])
        end_axis(problem.strips[first], problem.strips[first + 1], problem.strips[first + 2])
        end_axis(problem.strips[last], problem.strips[last - 1], problem.strips[last - 2])
        move_edges(problem, waves, problem.runs[k], first, share)
        finish_strips(tables, problem, k)


def limit_axis(before: Strip, strip: Strip, after: Strip):
    """No longer an axis than those beside it let expect, as they were in this sweep."""
    strip.next_axis = min(strip.next_axis, STEEP * max(before.axis, after.axis))


def end_axis(strip: Strip, inner: Strip, second: Strip):
    """Axis and lead of the outermost strip of a run from the next two."""
    axis = 1.5 * inner.next_axis - 0.5 * second.next_axis
    strip.next_axis = min(max(axis, LEAST_END * inner.next_axis), MOST_END * inner.next_axis)
    strip.next_lead = strip.lead + inner.next_lead - inner.lead


def move_edges(problem: StripProblem, waves: Waves, run: StripRun, first: int, share: float):
    """Move both edges of a run towards where its pressure ends like a square root, eq. (S14); ``first`` is
    its first strip.

    p sin t is the part that an edge at a wrong place leaves, with the values at both edges, and a rest.
    """
    count = waves.count
    start = 0.0
    stop = 0.0
    for i in range(count):
        product = problem.strips[first + i].y * waves.sin[i]
        start += waves.start[i] * product
        stop += waves.stop[i] * product
    largest = 0.0
    low = 0.0
    high = 0.0
    for i in range(count):
        sine = waves.sin[i]
        wrong = 0.5 * (start + stop + (start - stop) * waves.cos[i])
        root = (problem.strips[first + i].y * sine - wrong) / (sine * sine)
        largest = max(largest, max(root, -root))
        if i == 1:
            low = root
        if i == count - 2:
            high = root
    least = LEAST_ROOT * largest
    half = 0.5 * (run.stop - run.start)
    run.start_move = edge_move(half, share * start / max(low, least), run.start_move)
    run.stop_move = edge_move(half, share * stop / max(high, least), run.stop_move)
    # no farther than wheel and rail are known
    run.next_start = max(run.start - run.start_move, problem.zones[problem.traced[run.low].region].start)
    run.next_stop = min(run.stop + run.stop_move, problem.zones[problem.traced[run.high].region].stop)


def edge_move(half: float, away: float, before: float):
    """How far outwards [m] an edge of a run ``half`` as wide moves, no more than FARTHEST_EDGE of that; less
    where it moved to the other side ``before``, since beside a kink of the gap it would swing."""
    far = away / FARTHEST_EDGE
    move = FARTHEST_EDGE * half * far / sqrt(1.0 + far * far)
    if move * before < 0.0:
        known = fabs(before) + SWING * half
        move *= known / (known + fabs(move))
    return move


def finish_strips(tables: Tables, problem: StripProblem, k: int):
    """Half-lengths, stations and pressures after this sweep of the strips of run ``k``."""
    waves = tables.waves
    run = problem.runs[k]
    first = k * waves.count
    largest = 0.0
    for i in range(first, first + waves.count):
        largest = max(largest, problem.strips[i].next_axis)
    grown = (run.stop - run.start) / (run.next_stop - run.next_start)
    middle = 0.5 * (run.next_start + run.next_stop)
    half = 0.5 * (run.next_stop - run.next_start)
    for i in range(waves.count):
        strip = problem.strips[first + i]
        strip.next_axis = max(strip.next_axis, FLAT * largest)
        strip.next_half = strip.next_axis * waves.sin[i]
        strip.next_station = middle - half * waves.cos[i]
        raised = min(strip.axis / strip.next_axis, MOST_RAISED)
        strip.pressure = pi * tables.contact_modulus * strip.y * raised * grown
