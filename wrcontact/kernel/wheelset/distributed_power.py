"""Distribution of a patch's friction power over its strips and over the stations of the outline, for models of
wear.

A strip's share is its own power (rolling_contact.py); what the models add to the sum over the strips counts in
proportion.  Polach's formula has no strips: there the share is the load of the strip, as if tractions were
spread like the pressure.  So the strips of a patch have its friction power, no more and no less.

Stations share the power between them as hat functions do, with the value 1 at a station and 0 at its
neighbours:

    power_j = int P(s) h_j(s) ds / int h_j(s) ds

so that the trapezoidal sum over the stations is the integral of P, and its mean place that of P.  Next to a
station that belongs to another patch the station of its own patch gets all.
"""

from ..layout import (
    ROLLING_STRIP_LIMIT,
    Outline,
    Patch,
    RollingStrip,
    SideSearch,
    StripOutputs,
    WearRuns,
    seldom,
)
from .rolling_contact import strip_power


@seldom
def distribute_power(side: SideSearch, stations: int):
    """Friction power per width [W/m] of all strips of a wheel, and at the ``stations`` of its outline."""
    for j in range(2 * stations, 3 * stations):
        side.wear.numbers[j] = 0.0
    for number in range(side.patch_count):
        patch = side.patches[number]
        worn = side.worn[number]
        share_among_strips(patch, worn)
        for i in range(ROLLING_STRIP_LIMIT):
            add_power(side.wear, side.outline, stations, float(patch.rank), patch.strips[i], worn.power[i])
    width = cell_width(side.outline, stations)
    for j in range(2 * stations, 3 * stations):
        own = width
        if j == 2 * stations or j == 3 * stations - 1:
            own = 0.5 * width
        if own > 0.0:
            side.wear.numbers[j] /= own


@seldom
def share_among_strips(patch: Patch, worn: StripOutputs):
    """Share the friction power of a patch among its strips."""
    power = patch.forces.friction_power
    total = 0.0
    if power != 0.0:
        for i in range(ROLLING_STRIP_LIMIT):
            worn.power[i] = strip_power(patch, patch.strips[i])
            total += worn.power[i] * patch.strips[i].width
        if not total > 0.0:
            for i in range(ROLLING_STRIP_LIMIT):
                worn.power[i] = patch.strips[i].line_load
                total += worn.power[i] * patch.strips[i].width
    scale = 0.0
    if total > 0.0:
        scale = power / total
    for i in range(ROLLING_STRIP_LIMIT):
        if scale == 0.0:
            worn.power[i] = 0.0
        else:
            worn.power[i] *= scale


@seldom
def cell_width(outline: Outline, stations: int):
    """Distance of neighbouring stations [m]."""
    return (outline.numbers[stations - 1] - outline.numbers[0]) / float(stations - 1)


@seldom
def add_power(
    wear: WearRuns, outline: Outline, stations: int, owner: float, strip: RollingStrip, power: float
):
    """Add the ``power`` per width [W/m] of a strip of the patch with the number ``owner`` to the stations
    around it."""
    width = cell_width(outline, stations)
    last = float(stations - 1)
    if width > 0.0 and strip.width > 0.0:
        # counted in stations
        start = min(max((strip.start - outline.numbers[0]) / width, 0.0), last)
        stop = min(max((strip.stop - outline.numbers[0]) / width, 0.0), last)
        if stop > start:
            density = power * strip.width / (stop - start)
            at = start
            while at < stop:
                cell = min(int(at), stations - 2)
                after = stop
                if cell < stations - 2:
                    after = min(float(cell + 1), stop)
                share = own_share(wear, stations, cell, owner, 0.5 * (at + after) - float(cell))
                part = density * (after - at)
                wear.numbers[2 * stations + cell] += (1.0 - share) * part
                wear.numbers[2 * stations + cell + 1] += share * part
                at = after
        else:
            # beside the outline but for rounding
            cell = min(int(start + 0.5), stations - 1)
            wear.numbers[2 * stations + cell] += power * strip.width


@seldom
def own_share(wear: WearRuns, stations: int, cell: int, owner: float, share: float):
    """The share of a power in a cell that goes to its second station, where ``share`` is how far it lies from
    the first one [cells]."""
    first = wear.numbers[3 * stations + cell]
    second = wear.numbers[3 * stations + cell + 1]
    found = share
    if first == owner and second != owner:
        found = 0.0
    elif second == owner and first != owner:
        found = 1.0
    return found
