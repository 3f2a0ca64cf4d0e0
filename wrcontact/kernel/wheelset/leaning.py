"""Rails that are rolled: the place of a wheelset over them holds for one vertical shift (surface/rails.py),
which is found together with the contact.

The residual, how much lower the contact is found than the reference, falls at a rate of nearly one as the
reference rises. So the secant finds its root in three or four contacts.
"""

from math import fabs
from typing import Final

from ..layout import Reference, Sides

#: Contacts until the reference has to be met.
MEETINGS: Final[int] = 20
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
    return 0


def is_leaning(sides: Sides):
    """1 if a rail below the placed wheelset is rolled, else 0."""
    leaning = 0
    if sides[1].place.leaning:
        leaning = 1
    return leaning


def open_reference(reference: Reference, height: float, found: float):
    """Begin with the reference ``height`` [m], for which the contact was ``found``."""
    reference.height = height
    reference.residual = found - height
    reference.slope = -1.0
    return 0


def next_reference(reference: Reference):
    """Where the residual vanishes by its last value and slope [m]."""
    return reference.height - reference.residual / reference.slope


def note_reference(reference: Reference, height: float, found: float, met: float):
    """Note that for the reference ``height`` the contact was ``found`` [m]; 1 if that is the same to ``met``,
    else 0."""
    residual = found - height
    near = 0
    if fabs(residual) < met:
        near = 1
    elif height != reference.height:
        slope = (residual - reference.residual) / (height - reference.height)
        reference.slope = -1.0
        if slope > STEEPEST_FALL and slope < FLATTEST_FALL:
            reference.slope = slope
    reference.height = height
    reference.residual = residual
    return near
