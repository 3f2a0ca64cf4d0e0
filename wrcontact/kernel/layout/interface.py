"""What goes into a step and what comes out of it; outputs are in the order of the FMU's variables."""

from .choices import PATCH_LIMIT, STATION_COUNT
from .record import Float, record


@record
class Inputs:
    lateral_shift: float
    yaw: float
    roll_guess: float
    normal_force: float
    load_transfer: float
    vertical_shift: float           # prescribed height and roll of the compliant form
    roll: float


@record
class Patch:
    normal_force: float
    area: float
    max_pressure: float
    length: float
    width: float
    centroid: float
    contact_angle: float


@record
class SideOutputs:
    patch_count: float
    x_wheel: float
    y_wheel: float
    z_wheel: float
    y_rail: float
    z_rail: float
    x_track: float
    y_track: float
    z_track: float
    contact_angle: float
    rolling_radius: float
    curvature_x: float
    curvature_y: float
    penetration: float
    normal_force: float
    area: float
    max_pressure: float
    patch_length: float
    patch_width: float
    patch_centroid: float
    patch: Patch * PATCH_LIMIT      # PATCH_LIMIT blocks of PATCH_SIZE
    station: Float * STATION_COUNT  # STATION_COUNT values each
    half_length: Float * STATION_COUNT
    pressure: Float * STATION_COUNT


@record
class Outputs:
    roll: float
    vertical_shift: float
    force: Float * 3                # resultant of the contact forces on the wheelset, x, y, z in the track frame
    moment: Float * 3               # and their moment about the wheelset's centre
    left: SideOutputs * 2
