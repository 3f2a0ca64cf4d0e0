"""A profile's zones as an array of numbers for the kernel's preparation; kernel/prepare/zones.py defines the layout."""

import numpy as np

from ..kernel.prepare import zones as layout
from .zones import Arc


def definition(profile):
    """The array (n,) of an upright ``profile`` of polynomials and arcs, with the exact numbers of its zones."""
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
            row[layout.ZONE_COEFFICIENTS:][:len(zone.coefficients)] = zone.coefficients
    head = np.zeros(layout.DEFINITION_ZONES)
    head[layout.DEFINITION_COUNT], head[layout.DEFINITION_ROW] = rows.shape
    return np.concatenate([head, rows.ravel()])
