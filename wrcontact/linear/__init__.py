"""The linear wheelset on its track: matrices of stiffness, creep and rotation, for stability and control.

>>> import wrcontact
>>> system = wrcontact.ContactSystem(tangential_model="strips")
>>> linear = system.linearize(speed=30.0)
>>> pair = linear.condensed()
>>> pair.coordinates
('lateral_shift', 'yaw')
>>> bool(pair.damping[0, 0] > 0.0)
True
"""

from .point import linearize
from .record import Linearization, PatchCoefficients

__all__ = ["Linearization", "PatchCoefficients", "linearize"]
