"""Records of the room motion: how the wheelset and its rails move."""

from .record import record


@record
class RailMotion:
    """How a rail moves, and the place about which it rolls."""

    lateral: float                  # velocity to the right [m/s]
    vertical: float                 # and down
    roll: float                     # rotation, right side down [rad/s]
    y: float                        # track coordinates of its highest point [m]
    z: float


@record
class Constraint:
    """What keeps a wheel on its rail: a force on it does no work as the wheelset moves."""

    y: float                        # the force in the track frame, in any unit
    z: float
    moment_x: float                 # its moment about the wheelset's centre, in this unit times m
    moment_y: float
    moment_z: float


@record
class Motion:
    """How the wheelset and the rail of one side move in the track frame; the left side's is mirrored."""

    speed: float                    # of its centre along the track [m/s]
    lateral: float                  # to the right
    vertical: float                 # and down
    turn_x: float                   # its rotation but for that about the axle [rad/s]
    turn_y: float
    turn_z: float
    wheel_rate: float               # rotation about the axle, positive when it rolls forward [rad/s]
    track_rate: float               # rotation of the track frame in space, about z [rad/s]
    axle_x: float                   # direction of the axle, to the right
    axle_y: float
    axle_z: float
    centre_y: float                 # the wheelset's centre [m]
    centre_z: float
    rail: RailMotion
    constraint: Constraint
