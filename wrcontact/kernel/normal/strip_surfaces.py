"""What wheel and rail are at each strip: overlap, inclination, ridge, and the gap beside it."""

from math import sqrt
from typing import Final

from ..contact.frame import NO_GAP, enter_plane, is_yawed, leave_plane
from ..contact.curves import open_origin
from ..contact.separation import separation
from ..contact.pressed import limited
from ..contact.traces import start_traces
from ..layout import (LOAD_VERTICAL, LONGITUDINAL_BASIC, RAIL, WHEEL, Contact, Frame, Pair, Place, Region,
                      Strip, StripProblem, Strips, Tables)
from ..surface.locus import outline_x
from ..surface.curvature import longitudinal_curvature
from ..surface.tables import height_slope, height_slope_bend
from ..surface.rails import upright_share
from .coefficients import hertz_coefficients, middle_slant, skewed_coefficients, table_value
from .strip_layout import length_before
from .strip_lengths import TESTED, gap_beside, limit_lengths

#: To what the abscissae of wheel and rail are traced [m].
STRIP_TRACE: Final[float] = 1e-9
#: Lateral curvatures of a zone over A are within these.
FLATTEST_ZONE: Final[float] = 0.02
SHARPEST_ZONE: Final[float] = 1e3
#: Before its half-length is known, the level of a strip is no less than this share of the overlap there, and
#: than this one of the depth.
INSIDE: Final[float] = 0.25
LEAST_OVERLAP: Final[float] = 0.05
#: The middle of a strip begins before its ridge by no more than this share of the half-length.
FIRST_LEAD: Final[float] = 0.5


def trace_strips(pair: Pair, contact: Contact, count: int):
    """Overlap, its rise, inclination and ridge of all strips, which lie in ``count`` regions."""
    problem = contact.strip_problem
    strips = problem.strips
    contact.frame.blur = 0.0
    for index in range(count):
        region = contact.regions[index]
        enter_plane(contact.frame, contact.frames, region, index)
        started = False
        for i in range(problem.count):
            strip = strips[i]
            if strip.region == index:
                if not started:
                    start_traces(contact.frame, region.station, region.rail, region.wheel)
                    open_origin(pair, contact.frame, contact.origin, region, 0.0)
                    started = True
                trace_strip(pair, contact, region, strip)
        leave_plane(contact.frame, contact.frames, region)


def trace_strip(pair: Pair, contact: Contact, region: Region, strip: Strip):
    """The surfaces at a strip of ``region``, whose frame is open."""
    frame = contact.frame
    gap, rate, bend, curvature = separation(pair, frame, contact.origin, strip.station - region.offset,
                                            STRIP_TRACE)
    strip.rise = 0.0
    strip.overlap = -NO_GAP
    if gap < NO_GAP:
        strip.overlap = frame.raised + frame.depth - gap
        strip.rise = -rate
    height, slope = height_slope(pair.rail, frame.traces[RAIL].abscissa)
    strip.cos = 1.0 / sqrt(1.0 + slope * slope)
    strip.sin = slope * strip.cos
    strip.x = 0.0
    strip.A = 0.5 * curvature
    strip.skew = 0.0
    strip.wheel = frame.traces[WHEEL].abscissa
    if is_yawed(frame):
        strip.x = outline_x(pair, frame.place, strip.wheel)


def place_on_middle(strips: Strips, count: int):
    """Places and breadths of the strips on the curve between wheel and rail, in the middle of the overlap.

    Where the rail bulges, that is shorter than the rail by half the overlap times its curvature; and it is
    inclined by half of what the overlap rises.
    """
    stretch = 1.0
    for i in range(count):
        strip = strips[i]
        before = i
        after = i
        if i > 0 and strips[i - 1].joined:
            before = i - 1
        if i < count - 1 and strip.joined:
            after = i + 1
        turned = (strips[after].sin * strips[before].cos - strips[after].cos * strips[before].sin)
        reach = strips[after].station - strips[before].station
        last = stretch
        stretch = 1.0
        if reach > 0.0 and strip.overlap > 0.0:
            stretch = 1.0 - 0.5 * strip.overlap * turned / reach
        strip.breadth = strip.width * stretch
        strip.place = strip.station
        if i > 0:
            way = strip.station - strips[i - 1].station
            strip.place = strips[i - 1].place + 0.5 * (last + stretch) * way


def incline_strips(tables: Tables, frame: Frame, problem: StripProblem):
    """Turn the strips to the mean of the normals of wheel and rail; what of penetration and load counts, and
    the gap where nothing penetrates, for strips laid at the problem's penetration."""
    for i in range(problem.count):
        strip = problem.strips[i]
        half = 0.5 * strip.rise
        scale = 1.0 / sqrt(1.0 + half * half)
        strip.share = strip.cos / frame.plane.cos
        cosine = (strip.cos - half * strip.sin) * scale
        strip.sin = (strip.sin + half * strip.cos) * scale
        strip.cos = cosine
        strip.counted = 1.0
        if tables.load == LOAD_VERTICAL:
            strip.counted = upright_share(frame.place, cosine, strip.sin)


def profile_within(pair: Pair, y: float):
    """Height [m] of the wheel's profile at ``y`` [m], or at the end that it lies beyond."""
    wheel = pair.wheel
    y = min(max(y, wheel.start), wheel.stop)
    z, slope = height_slope(wheel, y)
    return z


def measure_ridge(pair: Pair, place: Place, strip: Strip, away: float):
    """A and skew of the gap beside a yawed wheel's ridge, which at a distance ``away`` along x are those of
    the wheel there.

    Along x a yawed wheel shows other parts of its profile, to either side of the ridge's.
    """
    if pair.tables.longitudinal != LONGITUDINAL_BASIC:
        across = away * place.sin_yaw * place.cos_roll
        z, slope, bend = height_slope_bend(pair.wheel, strip.wheel)
        before = profile_within(pair, strip.wheel - across)
        after = profile_within(pair, strip.wheel + across)
        mean = bend
        square = across * across
        if square > 0.0:
            mean = (before + after - 2.0 * z) / square
        strip.A = 0.5 * longitudinal_curvature(pair.tables, place, z, slope, mean)
        odd = 0.5 * (after - before) - slope * across
        strip.skew = odd / (sqrt(1.0 + slope * slope) * away * away * away)


def first_lengths(pair: Pair, contact: Contact, count: int):
    """Half-lengths of the strips, which lie in ``count`` regions, from how wide their zones are:
    those of Hertz's ellipse for gap and curvature at each strip."""
    problem = contact.strip_problem
    frame = contact.frame
    for index in range(count):
        region = contact.regions[index]
        zone = problem.zones[index]
        depth = region.alignment * problem.penetration - region.gap
        middle = region.offset + region.station
        A = 0.5 * region.curvature
        low = zone_curvature(depth, middle - zone.start, A)
        high = zone_curvature(depth, zone.stop - middle, A)
        B = sqrt(low * high)
        one_alpha, one_beta, nr = hertz_coefficients(pair.tables.hertz, A, B)
        lean = 0.0
        low_beta = table_value(pair.tables.hertz, 0, A / low)
        high_beta = table_value(pair.tables.hertz, 0, A / high)
        if is_yawed(frame):
            slant = ridge_slant(problem, index)
            alpha, beta, nr = skewed_coefficients(pair.tables.hertz, A, B, slant)
            lean = middle_slant(pair.tables.hertz, A, B, slant) - slant
            low_beta *= beta / one_beta
            high_beta *= beta / one_beta
            one_alpha = alpha
        for i in range(problem.count):
            strip = problem.strips[i]
            if strip.region == index:
                if is_yawed(frame):
                    overlap = max(strip.overlap, LEAST_OVERLAP * depth)
                    measure_ridge(pair, frame.place, strip, TESTED * sqrt(overlap * pair.radius))
                beta = low_beta
                if strip.station > middle:
                    beta = high_beta
                first_length(strip, depth, one_alpha, beta)
                farthest = FIRST_LEAD * strip.half_length
                strip.lead = limited(lean * (strip.station - middle), farthest)
    limit_lengths(problem.strips, problem.count)


def ridge_slant(problem: StripProblem, index: int):
    """Mean slope dx/ds of the ridge over the strips of the region with number ``index`` [-]; 0 where it has
    fewer than two."""
    strips = problem.strips
    first = -1
    last = -1
    for i in range(problem.count):
        if strips[i].region == index:
            if first < 0:
                first = i
            last = i
    slant = 0.0
    if last > first:
        slant = (strips[last].x - strips[first].x) / (strips[last].station - strips[first].station)
    return slant


def zone_curvature(depth: float, width: float, A: float):
    """Lateral curvature [1/m] with which the gap rises by most of the ``depth`` [m] over the ``width`` of a
    zone to one side [m]; between FLATTEST_ZONE A and SHARPEST_ZONE A."""
    most = SHARPEST_ZONE * A
    B = most
    if depth < most * width * width:
        B = depth / (width * width)
    B = max(B, FLATTEST_ZONE * A)
    return B


def first_length(strip: Strip, depth: float, one_alpha: float, one_beta: float):
    """Half-length of a strip in a region of this ``depth`` [m], by ANALYN's coefficients of its zone."""
    level = depth - one_beta * (depth - strip.overlap)
    strip.loaded = level > 0.0
    least = max(INSIDE * strip.overlap, LEAST_OVERLAP * depth)
    level = max(level, least)
    strip.half_length = sqrt(level / (one_alpha * strip.A))


def lengths_before(pair: Pair, frame: Frame, problem: StripProblem):
    """Half-lengths and leads of the strips from the layout before."""
    strips = problem.strips
    length_before(problem)
    for i in range(problem.count):
        strip = strips[i]
        if is_yawed(frame):
            measure_ridge(pair, frame.place, strip, TESTED * strip.half_length)
    limit_lengths(strips, problem.count)


def set_gaps(problem: StripProblem):
    """The gap in the middle of every strip where nothing penetrates."""
    for i in range(problem.count):
        strip = problem.strips[i]
        strip.gap = strip.share * problem.penetration - strip.overlap + gap_beside(strip, strip.lead)
