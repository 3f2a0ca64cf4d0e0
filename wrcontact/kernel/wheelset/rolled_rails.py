"""With rolled rails the placement of the wheelset depends on its vertical shift (surface/rails.py), so both are
solved together.

The residual, how much lower the contact is found than the reference, falls at a rate of nearly one as the
reference rises. So the secant finds its root in three or four contacts.

Where a wheel is about to pass from one place to another, as from the flange root to the flange, the contact
falls faster than the reference rises, or jumps, and the secant wanders. Then the root is enclosed about the
first contact and halved, so that rounding does not decide which of several is found. If it is a jump, no
height is its own reference, and the end with the smaller residual is the answer: its wheels touch as if the
wheelset were shifted by the residual times the sine of the rail's roll.
"""

from math import fabs
from typing import Final

from ..layout import Reference, Sides
from .brackets import narrow_bracket

#: Contacts until the reference has to be met.
MEETINGS: Final[int] = 80
#: Contacts after which the root is enclosed and halved, or after one that is not nearer by this factor.
SECANTS: Final[float] = 10.0
NEARER: Final[float] = 0.5
#: The root is taken to lie within this distance of the first contact [m].
ROOT_WITHIN: Final[float] = 4e-3
#: So far beside a jump rounding does not decide on which of its sides the contact is found [m].
BESIDE: Final[float] = 1e-9
#: Over so narrow a bracket a residual that falls by more than this jumps [m]; one that falls some ten times as
#: fast as the reference rises does not, where a step BESIDE would leave it 1e-8 m off.
JUMP: Final[float] = 1e-9
#: A residual that was not computed [m].
UNKNOWN: Final[float] = 1.0
#: Rigid and elastic contact have met their reference when they differ by less [m]; sideways it is a twentieth
#: of that at most.
RIGID_MET: Final[float] = 1e-14
ELASTIC_MET: Final[float] = 2e-13
#: The residual's slope between two references [-]; elsewhere it is taken as -1.
STEEPEST_FALL: Final[float] = -2.0
FLATTEST_FALL: Final[float] = -0.5


def set_reference(sides: Sides, height: float):
    """Let ``height`` [m] be the reference of both sides when they are next placed."""
    sides[0].place.reference = height
    sides[1].place.reference = height


def has_rolled_rail(sides: Sides) -> bool:
    """Whether a rail below the placed wheelset is rolled."""
    return sides[1].place.leaning


def open_reference(reference: Reference, height: float, found: float):
    """Begin with the reference ``height`` [m], for which the contact was ``found``."""
    reference.height = height
    reference.residual = found - height
    reference.slope = -1.0
    reference.contacts = 1.0
    reference.within.low = found - ROOT_WITHIN
    reference.within.at_low = UNKNOWN
    reference.within.high = found + ROOT_WITHIN
    reference.within.at_high = -UNKNOWN


def next_reference(reference: Reference, met: float):
    """Where the residual vanishes by its last value and slope [m]; after many contacts the middle of what
    encloses it, and at last the better end."""
    height = reference.height - reference.residual / reference.slope
    if reference.contacts > SECANTS:
        height = 0.5 * (reference.within.low + reference.within.high)
        if reference.within.high - reference.within.low < met:
            beside = 0.0
            if reference.within.at_low - reference.within.at_high > JUMP:
                beside = BESIDE
            height = reference.within.low - beside
            if fabs(reference.within.at_high) < fabs(reference.within.at_low):
                height = reference.within.high + beside
    return height


def note_reference(reference: Reference, height: float, found: float, met: float) -> bool:
    """Note that for the reference ``height`` the contact was ``found`` [m]; whether that is the same to
    ``met``, or the better end of a jump."""
    residual = found - height
    near = False
    if fabs(residual) < met:
        near = True
    elif reference.contacts > SECANTS and reference.within.high - reference.within.low < met:
        if reference.within.at_low < UNKNOWN and reference.within.at_high > -UNKNOWN:
            near = True
    elif height != reference.height:
        slope = (residual - reference.residual) / (height - reference.height)
        reference.slope = -1.0
        if slope > STEEPEST_FALL and slope < FLATTEST_FALL:
            reference.slope = slope
    if reference.contacts > SECANTS:
        narrow_bracket(reference.within, height, residual)
    elif fabs(residual) > NEARER * fabs(reference.residual):
        reference.contacts = SECANTS
    reference.height = height
    reference.residual = residual
    reference.contacts += 1.0
    return near
