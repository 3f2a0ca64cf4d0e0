"""Records of the room surface: where a wheelset is placed."""

from .record import Float, record


@record
class Place:
    shift: float
    sin_yaw: float
    cos_yaw: float
    sin_roll: float
    cos_roll: float
    t: float
    w_per_slope: float
    cos_t: float
    radius: float
    arm: float
    yawed: bool
    spare_11: Float * 5
