"""From corrected strips to patches: each run is a patch.

Half-length and pressure between the strips of a run follow the cosines through them, at its fine strips; to
the pressure comes what the fine part of the gap adds, eq. (S13).
"""

from math import pi, sqrt
from typing import Final

from ..layout import (
    FINE_WAVES,
    LOAD_VERTICAL,
    RULE_STRAIGHT,
    SOLVED_PATCH_LIMIT,
    Contact,
    Equations,
    Frame,
    Region,
    Regions,
    SideSearch,
    SolvedStrips,
    Strip,
    StripProblem,
    StripRun,
    Tables,
    Waves,
)
from ..patch.filling import add_load, begin_patch, clear_patches, finish_patch, finish_patches
from ..surface.rails import upright_share
from .strip_surfaces import TOUCHING, between

#: Strips of a region that lie closer together than this have no slant [m].
CLOSE: Final[float] = 1e-6
#: So many fine strips at either end of a run are without the fine part of the gap.
SMOOTH_ENDS: Final[int] = 2
#: Largest p / sin t of the outermost strip of a run over that of the next one.
SPIKE: Final[float] = 1.5
#: Half-lengths between strips are no less than this share of the smallest axis times sin t.
NARROWED: Final[float] = 0.5


def fill_from_strips(tables: Tables, contact: Contact, side: SideSearch, count: int):
    """Fill the patches of a side from the runs of strips, which lie in ``count`` regions."""
    problem = contact.strip_problem
    for index in range(count):
        load_region(tables, contact.frame, contact.regions[index], problem, index)
    clear_patches(side)
    for k in range(problem.run_count):
        if side.patch_count < SOLVED_PATCH_LIMIT:
            fill_run(tables, contact, side, k)
    finish_patches(side)


def fill_run(tables: Tables, contact: Contact, side: SideSearch, k: int):
    """Fill the next patch from run ``k``."""
    problem = contact.strip_problem
    waves = tables.waves
    run = problem.runs[k]
    first = k * waves.count
    deepest = first
    for i in range(first, first + waves.count):
        if problem.strips[i].y > problem.strips[deepest].y:
            deepest = i
    region = contact.regions[problem.strips[deepest].region]
    fine = FINE_WAVES * waves.count
    index = side.patch_count - 1
    meets = False
    if k > 0:
        meets = run.next_start - problem.runs[k - 1].next_stop < TOUCHING * (run.next_stop - run.next_start)
    if not meets:
        index = begin_patch(side, region, run.next_start, k * fine, RULE_STRAIGHT)
    patch = side.patches[index]
    scale = 0.5 * pi * pi * tables.contact_modulus
    spread = (run.next_stop - run.next_start) * pi / float(waves.count)
    for i in range(waves.count):
        strip = problem.strips[first + i]
        load = scale * strip.half_length * strip.width * strip.y
        add_load(patch, strip.region, load, load * strip.station)
        patch.totals.area += spread * strip.next_half * waves.sin[i] * strip.stretch
    patch.totals.stop = run.next_stop
    patch.last = (k + 1) * fine - 1
    fill_fine_strips(tables, problem, contact.strips, k)
    patch.pressure_square = max(
        patch.pressure_square, largest_square(contact.strips, k * fine, patch.last, True)
    )
    patch.half_length_square = max(
        patch.half_length_square, largest_square(contact.strips, k * fine, patch.last, False)
    )
    finish_patch(side)


def fill_fine_strips(tables: Tables, problem: StripProblem, solved: SolvedStrips, k: int):
    """The fine strips of run ``k``."""
    waves = tables.waves
    run = problem.runs[k]
    first = k * waves.count
    fine = FINE_WAVES * waves.count
    middle = 0.5 * (run.next_start + run.next_stop)
    half = 0.5 * (run.next_stop - run.next_start)
    least = problem.strips[first].next_axis
    stretch = 0.0
    for i in range(first, first + waves.count):
        least = min(least, problem.strips[i].next_axis)
        stretch += problem.strips[i].stretch
        problem.strips[i].smooth = max(problem.strips[i].pressure, 0.0) / waves.sin[i - first]
    limit_spike(problem.strips[first], problem.strips[first + 1])
    limit_spike(problem.strips[first + waves.count - 1], problem.strips[first + waves.count - 2])
    rigid = tables.contact_modulus * float(waves.count) / ((run.stop - run.start) * stretch)
    for g in range(fine):
        axis = 0.0
        raised = 0.0
        for i in range(waves.count):
            strip = problem.strips[first + i]
            weight = waves.refining[g][i]
            axis += weight * strip.next_axis
            raised += weight * strip.smooth
        sine = waves.fine_sin[g]
        length = max(axis, NARROWED * least) * sine
        pressure = raised * sine
        if g >= SMOOTH_ENDS and g < fine - SMOOTH_ENDS:
            pressure -= rigid * roughness(waves, run, g) / sine
        pressure = max(pressure, 0.0)
        to = solved[k * fine + g]
        to.station = middle - half * waves.fine_cos[g]
        to.width = half * sine * pi / float(fine)
        near = min(max(g - 1, 0) // FINE_WAVES, waves.count - 2)
        low = problem.strips[first + near]
        high = problem.strips[first + near + 1]
        u = (to.station - low.next_station) / (high.next_station - low.next_station)
        to.x = between(low.x + low.next_lead, high.x + high.next_lead, u)
        to.curvature = 2.0 * between(low.A, high.A, u)
        to.line_load = 0.5 * pi * length * pressure
        to.half_length_square = length * length
        to.pressure_square = pressure * pressure


def limit_spike(strip: Strip, inner: Strip):
    """No spike of the outermost strip of a run beside the next one: an edge that is still on its way leaves
    it, with little load."""
    strip.smooth = min(strip.smooth, SPIKE * inner.smooth)


def roughness(waves: Waves, run: StripRun, g: int):
    """sum of m g_m cos(m t) of the gap's cosines above those of the strips, at fine strip ``g`` [m]."""
    total = 0.0
    for m in range(FINE_WAVES * waves.count):
        total += waves.roughness[g][m] * run.gaps[m]
    return total


def largest_square(solved: SolvedStrips, first: int, last: int, pressures: bool):
    """Largest square of the pressure, or of the half-length, of a run of solved strips, on parabolas through
    three of them, half the way to either side."""
    largest = 0.0
    for i in range(first + 1, last):
        if pressures:
            low = solved[i - 1].pressure_square
            here = solved[i].pressure_square
            high = solved[i + 1].pressure_square
        else:
            low = solved[i - 1].half_length_square
            here = solved[i].half_length_square
            high = solved[i + 1].half_length_square
        bend = low - 2.0 * here + high
        value = here
        if bend < 0.0:
            at = min(max(0.5 * (low - high) / bend, -0.5), 0.5)
            value += at * (0.5 * (high - low) + 0.5 * at * bend)
        largest = max(largest, value)
    return largest


def load_region(tables: Tables, frame: Frame, region: Region, problem: StripProblem, index: int):
    """What the strips of the region with number ``index`` carry: load, moment, the mean direction of the
    force, and the slant of the line through their middles."""
    strips = problem.strips
    load = 0.0
    moment = 0.0
    cosines = 0.0
    sines = 0.0
    x = 0.0
    for i in range(problem.count):
        strip = strips[i]
        if strip.region == index:
            own = strip.half_length * strip.width * strip.y
            load += own
            moment += own * strip.station
            cosines += own * strip.cos
            sines += own * strip.sin
            x += own * (strip.x + strip.next_lead)
    scale = 0.5 * pi * pi * tables.contact_modulus
    region.carried = scale * load
    region.moment = scale * moment
    region.slant = 0.0
    if load != 0.0:
        # also of a region that pulls: load times direction is the sum over its strips
        region.cos = cosines / load
        region.sin = sines / load
        if tables.load == LOAD_VERTICAL:
            region.share = upright_share(frame.place, region.cos, region.sin)
    if load > 0.0:
        slant_region(region, problem, index, moment / load, x / load)


def slant_region(region: Region, problem: StripProblem, index: int, station: float, x: float):
    """Slant of the line through the middles of a region's strips, whose load has its centre at ``station``
    and ``x`` [m]."""
    strips = problem.strips
    along = 0.0
    spread = 0.0
    carried = 0.0
    for i in range(problem.count):
        strip = strips[i]
        if strip.region == index:
            own = strip.half_length * strip.width * strip.y
            away = strip.station - station
            carried += own
            along += own * away * (strip.x + strip.next_lead - x)
            spread += own * away * away
    if spread > CLOSE * CLOSE * carried:
        region.slant = along / spread


def add_stiffness(tables: Tables, regions: Regions, problem: StripProblem, equations: Equations, count: int):
    """How the load of each region follows the penetration [N/m], from the last equations that were
    solved."""
    for index in range(count):
        regions[index].stiffness = 0.0
    scale = 0.5 * pi * pi * tables.contact_modulus
    for i in range(problem.count):
        row = equations[i]
        strip = problem.strips[i]
        region = regions[strip.region]
        region.stiffness += scale * strip.half_length * strip.width * row[problem.count]
