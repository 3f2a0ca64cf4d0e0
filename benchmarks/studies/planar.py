"""The half-space as it is usually taken, over one plane: wheel and rail along the normals of the plane that
touches them at the rigid contact point, and pressures that act on each other without regard to their normals.

It is here for comparison alone (docs/conformal.md): where a patch turns around the rail it is not the truth.
"""

import math

import numpy as np

from wrcontact.halfspace.contact import solve_contact
from wrcontact.halfspace.wheel_on_rail import wheel_on_rail
from wrcontact.kernel import layout

REACH = 0.03             # [m] of the domain around the contact point


def planar_contact(system, state, force):
    """The right wheel's contact over the plane at its rigid contact point, under a ``force`` [N] along the
    plane's normal.

    Parameters
    ----------
    system : :class:`~wrcontact.ContactSystem` with rigid contact.
    state : of this system, at one pose.

    Returns
    -------
    HalfspaceContact
        whose stations count from the contact point.

    Raises
    ------
    ArithmeticError
        where the solution is not found.
    """
    tables = system.stepper().tables
    pair = wheel_on_rail(tables, 1, lateral_shift=state.inputs[layout.IN_LATERAL_SHIFT],
                         yaw=state.inputs[layout.IN_YAW], roll=state.roll,
                         vertical_shift=state.vertical_shift)
    wheel = state.right
    return solve_contact(plane_gap(pair, wheel.contact, wheel.contact_angle), (-REACH, REACH, -REACH, REACH),
                         contact_modulus=tables[layout.SET_CONTACT_MODULUS], force=force)


def plane_gap(pair, contact, angle):
    """The gap over the plane through a rigid contact point with this contact ``angle`` [rad], as a function
    of x (n,) from there and s (m,) [m]."""
    def gap(x, s):
        y, z = contact.y_track + s * math.cos(angle), contact.z_track - s * math.sin(angle)
        normal = np.full(len(s), angle)
        along = np.broadcast_to(x[:, None] + contact.x_track, (len(x), len(s)))
        bow = 0.5 * x[:, None] ** 2 * math.cos(angle) / pair.radius
        with np.errstate(invalid="ignore"):
            return (pair.wheel_along(along, y, z, normal, bow + 0.0 * s)
                    - pair.rail_along(y, z, normal, np.zeros(len(s))))

    return gap
