"""Records of the room patch: the solved contact patches of one wheel.

A model of normal contact fills them; totals, outline and resultant read them, and so will a model of
tangential contact.
"""

from typing import Final

from .contact import REGION_LIMIT
from .interface import RUN_COUNT, STATION_LIMIT
from .record import Float, record, size

SOLVED_PATCH_LIMIT: Final[int] = 8       # contact patches of one wheel
SOLVED_PART_LIMIT: Final[int] = SOLVED_PATCH_LIMIT + REGION_LIMIT
SOLVED_STRIP_LIMIT: Final[int] = 768     # strips of all of them: the nodes of three regions

# how half-length and pressure follow between the strips of a patch (patch/interpolation.py)
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


@record
class SolvedPart:
    """What of a patch lies in one region; it has one normal."""

    patch: int                      # indices of both
    region: int
    load: float                     # [N]
    moment: float                   # of the load about station zero [N m]


@record
class PatchForce:
    """The force of a patch on its wheel, in the track's axes; x has no part of it without friction."""

    y: float                        # [N]
    z: float
    x_track: float                  # its centre of load [m]
    y_track: float
    z_track: float
    moment_x: float                 # about the track's origin [N m]
    moment_y: float
    moment_z: float
    rolling_radius: float           # at the centre of load [m]


@record
class SolvedPatch:
    totals: PatchTotals
    force: PatchForce               # written by the wheelset's resultant, as is
    local_penetration: float        # that of the undeformed surfaces at its point, the largest [m]
    contact_angle: float            # of the rail at its point [rad]
    cos: float                      # of the angle along which its force acts
    sin: float
    rail: float                     # its point, the closest or deepest one: rail abscissa [m],
    wheel: float                    # wheel abscissa [m],
    station: float                  # station [m],
    x: float                        # track coordinate x [m]
    slant: float                    # of the line through the strips' middles, dx/ds [-]; 0 without yaw
    rule: int                       # how to interpolate between its strips, one of RULE_...
    first: int                      # the strips that it lies between: the outermost may have no width
    last: int
    rank: int                       # its place among the patches by load, from 1


SOLVED_PATCH_SIZE: Final[int] = size(SolvedPatch)
SolvedStrips = SolvedStrip * SOLVED_STRIP_LIMIT


@record
class SolvedPatches:
    count: int
    totals: PatchTotals             # of all patches
    pressure_square: float          # squares of the largest pressure [Pa^2] of the patch that is filled and
    half_length_square: float       # of its largest half-length [m^2] so far
    patches: SolvedPatch * SOLVED_PATCH_LIMIT
    part_count: int
    parts: SolvedPart * SOLVED_PART_LIMIT
    strips: SolvedStrips


@record
class Outline:
    """Stations, half-lengths and pressures of one wheel, as many of each as stations are wanted, one run
    after the other."""

    numbers: Float * (RUN_COUNT * STATION_LIMIT)
