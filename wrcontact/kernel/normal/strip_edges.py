"""Edges of the patches that loaded strips form.

Near the edge of a patch the line load falls to zero in proportion to the distance, so the edge is where the
straight line through the line loads of the last two strips ends.
"""

from ..layout import Strips


def run_end(strips: Strips, count: int, first: int):
    """Last strip of the run of loaded strips that begins with strip ``first``."""
    last = first
    while last < count - 1 and strips[last + 1].line_load > 0.0 and strips[last].joined:
        last += 1
    return last


def run_edge(strips: Strips, count: int, last: int, first: int, outward: int):
    """Station [m] of the edge beyond strip ``last`` of a run that reaches to ``first`` on the other side."""
    station = strips[last].station
    edge = station + 0.5 * float(outward) * strips[last].width
    if last != first:
        # no farther than the middle of the next strip, which is not loaded
        limit = edge
        after = last + outward
        pair = last
        if outward < 0:
            pair = last - 1
        if after >= 0 and after < count:
            if strips[pair].joined:
                limit = strips[after].station
        inner = last - outward
        fall = strips[inner].line_load - strips[last].line_load
        edge = limit
        if fall > 0.0:
            reach = strips[last].line_load / fall * (station - strips[inner].station)
            if reach * float(outward) < (limit - station) * float(outward):
                edge = station + reach
    return edge
