"""The rail on the track: inclination about the head, and the gauge.

The rail is inclined towards the track centre, so its field side rises and its highest point moves to the
field side. The inclined profile is expressed in axes parallel to the track's, with the origin at its highest
point. The kernel's own preparation does this on the profile's definition.
"""

import math
from dataclasses import dataclass

from ..conventions import MILLIMETRE as MM
from ..kernel.prepare import zones as placement
from .definition import zones_of
from .profile import Profile


@dataclass(frozen=True)
class PlacedRail:
    """The right rail on the track: its inclined profile and the track coordinate of its highest point [m]."""

    profile: Profile
    y_track: float


def place_rail(rail, *, inclination, gauge, gauge_depth):
    """The right rail on the track.

    Parameters
    ----------
    rail : Profile of an upright rail.
    inclination : tangent of its inclination towards the track centre (1/40 = 0.025).
    gauge : distance of the two inner faces as laid [m], measured ``gauge_depth`` [m] below the highest point.

    Raises
    ------
    ValueError
        if the profile does not reach down to ``gauge_depth`` on its inner side.
    """
    angle = -math.atan(inclination)
    zones = rail.definition().tolist()
    y_top, z_top = placement.highest_point(zones, 0, angle)
    depth = z_top + gauge_depth / MM
    y_gauge, reached = placement.inner_face(zones, 0, angle, depth)
    if reached < depth:
        raise ValueError(
            f"gauge_depth reaches {depth * MM:.6g} m, but the inner side of the rail profile "
            f"{rail.name} ends at {reached * MM:.6g} m; permitted are smaller depths"
        )
    return PlacedRail(
        _turned(rail, zones, angle, -y_top, -z_top), gauge / 2 + rail.worn_face + (y_top - y_gauge) * MM
    )


def readable_wheel(wheel):
    """``wheel`` without the parts at its ends that are too steep to be read, such as the vertical start of
    the flange back (STEEPEST in kernel/prepare/zones.py)."""
    return _turned(wheel, wheel.definition().tolist(), 0.0, 0.0, 0.0)


def _turned(profile, zones, angle, y_shift, z_shift):
    """``profile`` turned by ``angle`` [rad] and shifted [mm], where it can be read; ``zones`` are its
    definition, which is changed."""
    placement.turn_zones(zones, 0, angle, y_shift, z_shift)
    placement.keep_around_top(zones, 0)
    return Profile(profile.name, profile.kind, zones_of(zones, angle), profile.smooth)
