"""Records of the room patch: the contact patches of a wheel, from the model of normal contact to the report.

Everything stands in the frame of a right wheel: y to the field side, z down.  A left wheel is mirrored where
its forces are added to those of the right one, and in the report.
"""

from typing import Final

from .contact import REGION_LIMIT
from .interface import RUN_COUNT, STATION_LIMIT, Vector
from .record import Float, record, run, size

SOLVED_PATCH_LIMIT: Final[int] = 8       # contact patches of one wheel
SOLVED_STRIP_LIMIT: Final[int] = 768     # strips of all of them: the nodes of three regions
ROLLING_STRIP_LIMIT: Final[int] = 16     # strips that a patch is cut into along the rolling direction

#: A number for each region.
RegionRun = run(REGION_LIMIT)

# how half-length and pressure follow between the strips of a patch (patch/outline.py)
RULE_ELLIPSE: Final[int] = 0         # the patch is an ellipse and has no strips: in closed form
RULE_QUADRATIC: Final[int] = 1       # quadratics through the squares at evenly spaced strips
RULE_STRAIGHT: Final[int] = 2        # straight lines through the squares, to zero at the patch's edges


@record
class SolvedStrip:
    station: float                  # of its middle, along the rail's profile, from the contact point [m]
    width: float                    # along the profile [m]; 0: outside the patches, for the interpolation
    x: float                        # track coordinate x of its middle [m]
    curvature: float                # relative longitudinal curvature 1/R_x [1/m]
    line_load: float                # load per width [N/m]; not above zero where there is no load, like
    half_length_square: float       # the square of its half-length [m^2] and
    pressure_square: float          # the square of the pressure on its middle [Pa^2]


@record
class PatchTotals:
    """Of one patch, or of all patches of a wheel together."""

    load: float                     # [N]
    area: float                     # [m^2]
    moment: float                   # of the load about station zero [N m]
    centroid: float                 # station of the load's centre [m]
    max_pressure: float             # [Pa]
    max_half_length: float          # [m]
    start: float                    # stations of the edges [m]
    stop: float
    width: float                    # from edge to edge [m]


SolvedStrips = SolvedStrip * SOLVED_STRIP_LIMIT


@record
class RollingStrip:
    """A strip of a patch along the rolling direction, with the creep force on it."""

    start: float                    # stations of its edges [m]
    stop: float
    station: float                  # and of its middle
    y: float                        # its middle, from the patch's centre of load [m]
    width: float                    # [m]
    x: float                        # how far its middle is ahead of the centre of load [m]
    half_length: float              # [m]
    line_load: float                # load per width [N/m]
    slip: float                     # its longitudinal creepage [-]
    y_track: float                  # track coordinates of its middle [m]
    z_track: float
    rolling_radius: float           # there [m],
    radius_share: float             # and over its distance from the axle [-]
    force_x: float                  # creep force on the wheel per width [N/m],
    force_y: float
    moment: float                   # and moment of the lateral one about the centre of load, per width [N]


@record
class Forces:
    """Forces on a patch, a wheel or the wheelset, and their moments about the wheelset's centre."""

    force: Vector                   # [N]
    moment: Vector                  # [N m]
    normal_force: Vector            # of the pressures alone
    normal_moment: Vector
    driving_torque: float           # of the creep forces about the axle [N m], positive where it drives
    friction_power: float           # that friction takes [W]
    wear_number: float              # creep forces times creepages [N]


@record
class Patch:
    """One contact patch of a wheel, from its normal model to the report."""

    totals: PatchTotals
    pressure_square: float          # squares of the largest pressure [Pa^2] and of the largest half-length
    half_length_square: float       # [m^2], while it is filled
    loads: RegionRun                # what of its load lies in each region [N],
    moments: RegionRun              # and the moment of that about station zero [N m]
    rank: int                       # its place among the patches of the wheel by load, from 1; 0: no load
    rule: int                       # how to interpolate between its solved strips, one of RULE_...
    first: int                      # the solved strips that it lies between: the outermost may have no width
    last: int
    slant: float                    # of the line through the strips' middles, dx/ds [-]; 0 without yaw
    rail: float                     # its point, the closest or deepest one: rail abscissa [m],
    wheel: float                    # wheel abscissa [m],
    station: float                  # station [m],
    x: float                        # track coordinate x [m]
    penetration: float              # of the undeformed surfaces at its point [m]
    contact_angle: float            # of its force [rad]
    x_track: float                  # its centre of load [m]
    y_track: float
    z_track: float
    rolling_radius: float           # there [m]
    normal_y: float                 # force of its pressures [N]; x has no part of it
    normal_z: float
    normal_moment: Vector           # and its moment about the track's origin [N m]
    half_length: float              # semi-axes of the ellipse with its area, length over width [m]
    half_width: float
    friction: float                 # coefficient of friction [-]
    speed: float                    # the rolling speed [m/s]
    creepage_x: float               # velocity of the wheel on the rail over the rolling speed: x forward,
    creepage_y: float               # y to the field side [-],
    spin: float                     # and its turning about x times y [1/m]
    radius_share: float             # rolling radius over the distance from the axle [-]
    backwards: bool                 # whether it rolls towards -x
    strips: RollingStrip * ROLLING_STRIP_LIMIT
    creep_x: float                  # creep force on the wheel [N], in the frame of the creepages
    creep_y: float
    creep_moment: float             # and its moment about the normal through the centre of load [N m]
    stick_share: float              # share of the area that sticks [-]
    max_shear: float                # largest traction [Pa]
    saturation: float               # creep force over friction times load [-]
    forces: Forces


PATCH_SIZE: Final[int] = size(Patch)
Patches = Patch * SOLVED_PATCH_LIMIT


@record
class Outline:
    """Stations, half-lengths and pressures of one wheel, as many of each as stations are wanted, one run
    after the other."""

    numbers: Float * (RUN_COUNT * STATION_LIMIT)
