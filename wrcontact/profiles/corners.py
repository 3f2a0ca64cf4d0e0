"""Remarks on the corners of a profile that is given by zones. The preparation rounds them
(kernel/prepare/pieces.py)."""

import math

from ..conventions import MILLIMETRE as MM
from ..kernel.prepare.pieces import CORNER_RADIUS, CORNER_WIDTH
from .changing import is_sections
from .files import STEEPEST
from .remarks import counted, remark, stretch

#: Corners whose rounding moves the profile by less than this are not reported [mm]; it is small against the
#: penetration of a loaded wheel.
NOTABLE = 1e-4


def remark_corners(system):
    """Give a :class:`~wrcontact.ProfileWarning` on each profile of a :class:`~wrcontact.ContactSystem` with
    corners that are rounded."""
    given = (system.wheel, system.rail, system.left_wheel, system.left_rail)
    for profile in dict.fromkeys(one for one in given if not is_sections(one)):
        remark(profile.kind, profile.name, corner_remarks(profile))


def corner_remarks(profile):
    """The remarks (a tuple) on the corners of a Profile. Those of a file of points are the walls of a rail's
    head, or have been reported when it was read; those of a standard profile belong to it."""
    found = [] if profile.reading or profile.source else list(notable_corners(profile))
    if not found:
        return ()
    where, turns, lifts = zip(*found)
    return (
        f"{counted(len(found), 'corner')} of up to {math.degrees(max(turns)):.3g} deg rounded to a radius of "
        f"about {CORNER_RADIUS:g} mm, or over {2.0 * CORNER_WIDTH:g} mm ({stretch(where)}), which moves the "
        f"profile by up to {1e3 * max(lifts):.2g} um",
    )


def notable_corners(profile):
    """Abscissa [mm], change of angle [rad] and by how much the rounding moves the profile there [mm], of each
    corner that is reported."""
    for joint, before in zip(profile.joints, profile.zones):
        slope = float(before(joint.y / MM)[1])
        turn = abs(math.atan(slope + joint.slope_step) - math.atan(slope))
        steep = min(abs(slope), abs(slope + joint.slope_step))
        width = max(0.5 * CORNER_RADIUS * turn / math.hypot(1.0, steep), CORNER_WIDTH)
        # of two straight arms, in the middle of the quintic between them
        lift = 3.0 / 16.0 * abs(joint.slope_step) * width
        if lift > NOTABLE and steep < STEEPEST:
            yield joint.y / MM, turn, lift
