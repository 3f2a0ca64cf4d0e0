"""How the regions of one side press on each other: one half-space, planes of their own (docs/method.md,
(8.4))."""

from math import pi, sqrt
from typing import Final

from ..layout import Region, Tables

#: Share of the squares of two regions' half-lengths that counts as distance between them.
ELONGATED: Final[float] = 0.3
#: Cosine of the angle between two planes, 15 degrees.  Below it the lead of one region over the other counts
#: as distance.
INCLINED: Final[float] = 0.9659258262890683


def region_influence(tables: Tables, one: Region, other: Region):
    """Displacement of region ``one`` under one newton on region ``other`` [m/N].

    Boussinesq's 1 / (pi E* distance).  The distance includes the lengths of the patches along the track and
    the lead of one region over the other.  The displacement counts by the cosine of the angle between the
    planes.
    """
    distance = one.offset + one.middle - other.offset - other.middle
    lead = region_lead(one, other)
    squares = one.square + other.square
    apart = sqrt(distance * distance + lead * lead + ELONGATED * squares)
    result = 1.0 / (pi * tables.contact_modulus * apart)
    result *= planes_cosine(one, other)
    return result


def region_lead(one: Region, other: Region):
    """How far region ``one`` of a yawed wheel lies ahead of region ``other`` along the track [m]; 0 if their
    planes form an angle of less than 15 degrees.

    A flange is 17 ... 31 mm ahead of the flange root and 7 mm beside it.  Between tread and flange root, 1
    ... 3 mm in 10, the lead is left out: the upright patches (docs/method.md, section 9) do without it, and
    the half-space agrees better.
    """
    lead = 0.0
    if planes_cosine(one, other) < INCLINED:
        lead = one.x_track - other.x_track
    return lead


def planes_cosine(one: Region, other: Region):
    """Cosine of the angle between the planes of two regions [-]; 1 in one plane, not below 0."""
    cosine = 1.0
    if one.own or other.own:
        cosine = one.cos * other.cos + one.sin * other.sin
        if cosine < 0.0:
            cosine = 0.0
    return cosine
