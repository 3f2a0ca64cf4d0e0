"""Wang's shift of a yawed wheel's contact from its principal profile, source eqs. (5.1)-(5.7).

The source's roll counts from z to y. With ours (right wheel down positive) sin(roll) changes sign, and the
shift, which it takes from the contact to the principal profile in y and z but the other way round in x, is
from the principal profile to the contact here. Two corrections of eq. (5.3), which the search does not use:

* printed ``l_x^2 l_y tan(delta)``, right is ``l_x^2 l_z tan(delta)``;
* the sign in front of the fraction; as printed the shift of a wheel without yaw would be 2 R.
"""

from math import cos, hypot, sin, sqrt


def wang_shift(radius, tan_angle, *, roll, yaw):
    """Shift (x, y, z) [m] in the track frame from the principal profile's lowest point to the
    contact, of a right wheel.

    Parameters
    ----------
    radius : wheel radius R at the contact [m].
    tan_angle : tan(delta) of the wheel profile there, in the wheelset's frame, positive towards the flange.
    roll, yaw : theta, psi [rad].
    """
    R, t, theta, psi = radius, tan_angle, -roll, yaw
    lx, ly, lz = cos(theta) * sin(psi), cos(theta) * cos(psi), sin(theta)              # (5.5)-(5.7)
    m = sqrt(max(0.0, 1 - lx**2 * (1 + t**2)))                                         # (5.4)
    x = R * sin(theta) * sin(psi) + lx * R * t                                         # (5.1)
    y = R * sin(theta) * cos(psi) - R / (1 - lx**2) * (lx**2 * ly * t + lz * m)        # (5.2)
    z = R * cos(theta) + R / (1 - lx**2) * (lx**2 * lz * t - ly * m)                   # (5.3), corrected
    return x, -y, -z


def longitudinal_limit(radius, tan_angle, *, roll, yaw):
    """How far along the wheel the source searches [m], source eqs. (5.8), (5.9): the
    shift's length in plan."""
    x, y, _ = wang_shift(radius, tan_angle, roll=roll, yaw=yaw)
    return hypot(x, y)
