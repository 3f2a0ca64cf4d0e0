"""Records of surfaces, and of the room contact: tables of a profile and of its lateral curvature, where a
wheel is placed, the plane of a contact, the regions beside it, and the overlap of a pressed wheel."""

from typing import Final

from .record import OPEN, WIDTH, Float, To, record, run, size

REGION_LIMIT: Final[int] = 4  # loaded regions of one wheel
#: The two profiles, where there is something for each of them.
RAIL: Final[int] = 0
WHEEL: Final[int] = 1


@record
class Piece:
    """One quintic of a profile: height c0 + c1 u + ... + c5 u^5 at u = y - start."""

    start: float  # where it begins [m]; not a number in the piece after the last
    c0: float
    c1: float
    c2: float
    c3: float
    c4: float
    c5: float
    stop: float  # where the next one begins; not a number in the last piece


#: Numbers of a piece: 64 bytes, as much as a line of a processor's cache.
PIECE_SIZE: Final[int] = size(Piece)


@record
class Profile:
    """A profile as the kernel reads it: quintic pieces found through uniform bins."""

    start: float  # first and last abscissa [m]
    stop: float
    bins_per_metre: float
    bin_count: float
    pieces: To(Piece)  # the first of them
    bins: Float * OPEN  # 2^52 and how far from here the first piece begins that reaches into a bin


#: Numbers of a profile's table before its bins.
PROFILE_HEAD: Final[int] = Profile.bins.offset // WIDTH


@record
class CurvatureTable:
    """Lateral curvature along a profile at even distances, positive where the profile bulges towards the
    other body."""

    count: float
    start: float  # abscissa of the first value [m]
    per_metre: float
    curvatures: Float * OPEN  # [1/m]


@record
class Cubic:
    """One cell of a table of cubics: value + u slope + u^2 bend + u^3 third at 0 <= u < 1 of the way through
    the cell."""

    value: float
    slope: float
    bend: float
    third: float


CUBIC_SIZE: Final[int] = size(Cubic)


@record
class CubicTable:
    """A function as cubics over even cells, with the function's own slope at their ends."""

    count: float  # of cells
    start: float  # of the first cell
    cells_per_unit: float
    cells: Cubic * OPEN


@record
class Meeting:
    """Where a normal of the rail meets the wheel."""

    wheel: float  # wheel abscissa [m]
    overlap: float  # there [m]; 0 where they do not meet, and the rest is of no use,
    rise: float  # and its derivatives along the rail's arc [-, 1/m]
    rate: float
    z: float  # height, slope and second derivative of the wheel's profile [m, -, 1/m]
    slope: float
    bend: float
    rail_slope: float  # of the rail where the normal begins [-]


@record
class Place:
    """Where a right wheel is placed over its rail, as :mod:`locus` reads it: in the frame that moves with the
    rail, in which the rail is in its nominal place."""

    shift: float  # lateral shift of the wheelset against the rail's nominal place [m]
    sin_yaw: float
    cos_yaw: float
    sin_roll: float
    cos_roll: float
    t: float  # tan(yaw) sin(roll) [-]
    w_per_slope: float  # w over the profile's slope [-]
    cos_t: float  # 1 / sqrt(1 + t^2)
    radius: float  # nominal radius of the wheel [m]
    height: float  # the wheelset's centre at vertical shift zero above the rail [m]
    arm: float  # half the distance of the running circles [m]
    yawed: bool
    rail_lateral: float  # displacement of its rail, to the field side [m]
    rail_vertical: float  # and down
    leaning: bool  # whether its rail has a roll; the rest counts only then, but rail_sin
    rail_roll: float  # field side down [rad]
    rail_sin: float  # and its sine, else zero
    rail_cos: float
    track_sin_yaw: float  # of the wheelset's yaw in the track
    track_cos_yaw: float
    reference: float  # the vertical shift for which the place holds [m]
    gap_count: float  # evaluations of its vertical gap since the workspace was made
    node_count: float  # and of the gap along a normal
    meeting: Meeting  # the last one


PLACE_SIZE: Final[int] = size(Place)


@record
class Point:
    y: float  # lateral and vertical coordinate [m]
    z: float


@record
class Direction:
    cos: float
    sin: float


@record
class Trace:
    """Where a profile is at one station; Newton's method for the next station starts from it."""

    abscissa: float  # [m]
    rate: float  # its first and second derivative over the stations [-, 1/m]
    bend: float


@record
class Frame:
    """The contact plane of the side at work, and where wheel and rail are traced along it."""

    rail: Point  # the contact point on the rail's profile
    wheel: Point  # and on the wheel's
    plane: Direction  # the plane's inclination on the track
    wheel_plane: Direction  # and in the wheelset's frame
    place: To(Place)  # of the wheel
    aside: float  # lateral shift that lets the wheel just touch [m]; 0 if rigid
    shift: float  # and the vertical shift [m]
    lift: float  # of the wheel's point below the rail's [m]; zero but for rounding
    raised: float  # what is added to the gap of a region with a plane of its own [m]
    station: float  # to which the traces belong [m]
    traces: Trace * 2  # of RAIL and WHEEL
    pressed: bool  # whether the wheel is pressed into the rail, rather than just touching it
    sunk: bool  # whether it is pressed straight down from where it just touched
    way: float  # along the rail, of a pressed wheel's deepest point, where stations are zero [m]
    height: float  # vertical shift at which a pressed wheelset stands [m]
    depth: float  # how deep a pressed wheel is, along the normal [m]
    bend: float  # second derivative of the gap at the contact point [1/m]
    curvature: float  # and the wheel's 1/R_x there [1/m]
    blur: float  # half the length over which r'' of a pressed wheel is averaged [m]


#: The numbers of a frame that is set aside while another one is open: one for each region, and the contact
#: point's.
KeptFrame = run(size(Frame))
KeptFrames = KeptFrame * (REGION_LIMIT + 1)


@record
class Origin:
    """The pair of points from which the separation of a region is measured."""

    station: float  # [m]
    gap: float  # the normal gap there [m]
    points: Point * 2  # of RAIL: abscissa and height; of WHEEL: its outline's coordinates
    spacing: float  # length of a chord [m]; 0: true arc length


@record
class Region:
    station: float  # of the minimum [m]
    gap: float  # there [m]
    rail: float  # rail and wheel abscissa there [m]
    wheel: float
    low: float  # stations that bound it [m]
    high: float
    width_low: float  # half-widths of the interpenetration [m]
    width_high: float
    spacing: float  # of its nodes [m]
    first: int  # first and last node
    last: int
    local_penetration: float  # its share, less its gap and what other regions displace [m]
    load: float  # [N]
    stiffness: float  # rate of the load over it [N/m]
    bend: float  # second derivative of the gap at the minimum [1/m]
    curvature: float  # the wheel's 1/R_x at the minimum [1/m]
    middle: float  # station that stands for its load in the interaction [m]
    residual: float  # of the local penetration during the force solve [m]
    slope: float  # its change per change of the total penetration [-]
    move: float  # its change that closes the residual [m]
    width_penetration: float  # local penetration that the half-widths were measured at [m]
    square: float  # square of its half-length as estimated [m^2]
    reached: float  # rise of the gap where the last half-width ends [m]
    side_low: float  # lateral curvature on either side, rise / half-width^2 [1/m]
    side_high: float
    slant: float  # dx/ds of the line of smallest gap [-]; of a yawed wheel only
    own: bool  # Whether it has a plane of its own
    alignment: float  # cosine between its normal and the contact point's [-]
    offset: float  # from its own stations to those of the outputs [m]
    cos: float  # of the angle of its force: the rail's at its minimum, or a mean
    sin: float
    share: float  # of its load that counts for the prescribed force
    moment: float  # of the load that it carries, over the stations of the outputs [N m]
    carried: float  # that load [N]
    inclination: float  # slope of the rail at its minimum [-]
    x_track: float  # track coordinate x of the minimum [m]
    strip: int  # the strip of the solved patches at its minimum
    solve_count: float  # of the first region: iterations of the force solve


@record
class FirstWidths:
    """Half-widths of the interpenetration about the contact point, from which those of a region beside it are
    sought."""

    penetration: float  # at which they were measured [m]; 0 if they were not
    low: float  # [m]
    high: float


#: The loaded regions of a wheel.
Regions = Region * REGION_LIMIT

OVERLAP_LIMIT: Final[int] = 200  # samples of the overlap of a pressed wheel to either side
DEEP_LIMIT: Final[int] = 9  # deepest points that are listed
SampleRun = run(2 * OVERLAP_LIMIT)


@record
class DeepPoint:
    """A local maximum of the overlap."""

    rail: float  # rail and wheel abscissa [m]
    wheel: float
    depth: float  # the overlap there [m]
    saddle: float  # rail abscissa of the smallest overlap between it and the next one [m]
    between: float  # the overlap there [m]; negative where wheel and rail are apart


@record
class DeepPoints:
    """Deepest points of one wheel that the next trial may follow, in the order of the rail, and half-widths
    that it may begin with."""

    count: int  # 0 if none are known
    points: DeepPoint * REGION_LIMIT
    width_count: int  # regions whose half-widths are known
    widths: FirstWidths * REGION_LIMIT


@record
class Samples:
    """The overlap at scan nodes, in the order of the wheel's abscissae."""

    rail: SampleRun  # rail and wheel abscissa [m]
    wheel: SampleRun
    rise: SampleRun  # slope of the overlap [-]
    turn: SampleRun  # what the rail's turning normal has taken from it [-]
    node: SampleRun  # its scan node
    gap: SampleRun  # vertical gap before the wheel has come down [m]
    aside: SampleRun  # how far the normal through the wheel's point begins beside it [m]
    rail_slope: SampleRun  # of the rail [-]
    rail_bend: SampleRun  # and its second derivative [1/m]
    adjacent: SampleRun  # Whether no scan node lies between it and the sample before it


@record
class RisePoint:
    """The rise of the overlap at a place of the rail."""

    x: float  # rail abscissa [m]
    rise: float  # derivative of the overlap along the rail [-]
    rate: float  # its own derivative by x [1/m]; 0 where it was not measured


@record
class Stretch:
    """A stretch of the rail on which deepest points are sought."""

    first: RisePoint
    last: RisePoint
    before: RisePoint  # ends of the part that is open
    after: RisePoint
    low: RisePoint  # of the part of it where a hump is sought
    high: RisePoint
    middle: RisePoint
    end: RisePoint  # of the last stretch that was measured
    known: int  # sample that it belongs to
    wheel: float  # a wheel abscissa that belongs to it [m]
    width: float  # how far the wheel's reach [m]
    least: float  # bounds of the bend of the gap [1/m]
    most: float


@record
class TurnCell:
    """How the slope of the gap along the rail's normals runs from one sample to the next one."""

    width: float  # on the wheel [m]
    first: float  # the slope at both ends [-]
    last: float
    error: float  # by which either may be wrong [-]
    first_bend: float  # and its derivatives [1/m]
    last_bend: float
    departure: float  # how far that may depart from a straight line between, but for a joint
    joint: float  # where a joint of the rail is, as a share of the width; 1 without one
    share: float  # x' at the first end [-]
    rail_jump: float  # by how much the rail's second derivative jumps there [1/m]
    jump: float  # and the bend


@record
class Overlap:
    """Where a pressed wheel overlaps its rail."""

    count: int  # of the deepest points, in the order of the rail
    height: float  # vertical shift of the wheel [m]
    points: DeepPoint * DEEP_LIMIT
    samples: Samples
    cell: TurnCell
    stretch: Stretch
