"""The search over a rail whose section changes, for one wheel at one pose by itself."""

from ..layout import SectionSearch, Tables
from ..surface.locus import place_wheelset
from .section_search import search_sections


def search_at(tables: Tables, search: SectionSearch, index: int, pose: "float[:]") -> bool:
    """Search the smallest gap of the wheel of side ``index`` at a pose: position along the track, lateral shift [m], yaw
    and roll [rad], as those of a right side; whether it is certain."""
    pair = tables.pairs[index]
    place_wheelset(search.place, pose[1], pose[2], pose[3], pair.radius, tables.height, tables.arm)
    search.position = pose[0]
    search.rotation = 0.0
    return search_sections(pair, search.place, search)
