"""A profile's zones as an array of numbers for the kernel's preparation; kernel/prepare/zones.py defines the
layout."""

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..kernel.prepare import zones as layout
from .zones import Arc, Moved, Polynomial


def definition(profile):
    """The array (n,) of an upright ``profile`` of polynomials and arcs, with the exact numbers of its
    zones."""
    terms = max((len(zone.coefficients) for zone in profile.zones if not isinstance(zone, Arc)), default=0)
    rows = np.zeros((len(profile.zones), layout.ZONE_COEFFICIENTS + terms))
    for row, zone in zip(rows, profile.zones):
        row[layout.ZONE_START], row[layout.ZONE_STOP] = zone.start, zone.stop
        if isinstance(zone, Arc):
            row[layout.ZONE_FAMILY], row[layout.ZONE_SIDE] = layout.FAMILY_ARC, zone.side
            row[layout.ZONE_ORIGIN], row[layout.ZONE_Z_CENTRE] = zone.y_centre, zone.z_centre
            row[layout.ZONE_RADIUS] = zone.radius
        else:
            row[layout.ZONE_FAMILY], row[layout.ZONE_ORIGIN] = layout.FAMILY_POLYNOMIAL, zone.origin
            row[layout.ZONE_TERMS] = len(zone.coefficients)
            row[layout.ZONE_COEFFICIENTS :][: len(zone.coefficients)] = zone.coefficients
    head = np.zeros(layout.DEFINITION_ZONES)
    head[layout.DEFINITION_WORN] = profile.worn_face / MM
    head[layout.DEFINITION_COUNT], head[layout.DEFINITION_ROW] = rows.shape
    return np.concatenate([head, rows.ravel()])


def zones_of(zones, angle=0.0):
    """The zones (a tuple) in a definition, of which some may have been turned by ``angle`` [rad]."""
    count, size = int(zones[layout.DEFINITION_COUNT]), int(zones[layout.DEFINITION_ROW])
    starts = range(layout.DEFINITION_ZONES, layout.DEFINITION_ZONES + count * size, size)
    return tuple(_zone(zones[start : start + size], angle) for start in starts)


def _zone(row, angle):
    """The zone in one row of a definition."""
    start, stop = row[layout.ZONE_START], row[layout.ZONE_STOP]
    if row[layout.ZONE_FAMILY] == layout.FAMILY_ARC:
        return Arc(
            start,
            stop,
            row[layout.ZONE_RADIUS],
            row[layout.ZONE_ORIGIN],
            row[layout.ZONE_Z_CENTRE],
            int(row[layout.ZONE_SIDE]),
        )
    coefficients = tuple(row[layout.ZONE_COEFFICIENTS :][: int(row[layout.ZONE_TERMS])])
    if not row[layout.ZONE_TURNED]:
        return Polynomial(start, stop, coefficients, row[layout.ZONE_ORIGIN])
    upright = Polynomial(row[layout.ZONE_FIRST], row[layout.ZONE_LAST], coefficients, row[layout.ZONE_ORIGIN])
    return Moved(upright, angle, row[layout.ZONE_Y_SHIFT], row[layout.ZONE_Z_SHIFT])
