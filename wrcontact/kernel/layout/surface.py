"""Records of surfaces: the table of a profile, the table of its lateral curvature, and where a wheel is
placed."""

from typing import Final

from .record import OPEN, WIDTH, Float, To, record, size


@record
class Piece:
    """One quintic of a profile: height c0 + c1 u + ... + c5 u^5 at u = y - start."""

    start: float                    # where it begins [m]; not a number in the piece after the last
    c0: float
    c1: float
    c2: float
    c3: float
    c4: float
    c5: float


PIECE_SIZE: Final[int] = size(Piece)


@record
class Profile:
    """A profile as the kernel reads it: quintic pieces found through uniform bins."""

    start: float                    # first and last abscissa [m]
    stop: float
    bins_per_metre: float
    bin_count: float
    pieces: To(Piece)               # the first of them
    bins: Float * OPEN              # how far from here the first piece begins that reaches into a bin


#: Numbers of a profile's table before its bins.
PROFILE_HEAD: Final[int] = Profile.bins.offset // WIDTH


@record
class CurvatureTable:
    """Lateral curvature along a profile at even distances, positive where the profile bulges towards the
    other body."""

    count: float
    start: float                    # abscissa of the first value [m]
    per_metre: float
    curvatures: Float * OPEN        # [1/m]


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

    count: float                    # of cells
    start: float                    # of the first cell
    cells_per_unit: float
    cells: Cubic * OPEN


@record
class Place:
    """Where a right wheel is placed over its rail, as :mod:`locus` reads it: in the frame that moves with the
    rail, in which the rail is in its nominal place."""

    shift: float                    # lateral shift of the wheelset against the rail's nominal place [m]
    sin_yaw: float
    cos_yaw: float
    sin_roll: float
    cos_roll: float
    t: float                        # tan(yaw) sin(roll) [-]
    w_per_slope: float              # w over the profile's slope [-]
    cos_t: float                    # 1 / sqrt(1 + t^2)
    radius: float                   # nominal radius of the wheel [m]
    height: float                   # the wheelset's centre at vertical shift zero above the rail [m]
    arm: float                      # half the distance of the running circles [m]
    yawed: bool
    rail_lateral: float             # displacement of its rail, to the field side [m]
    rail_vertical: float            # and down
    leaning: bool                   # whether its rail has a roll; the rest counts only then, but rail_sin
    rail_roll: float                # field side down [rad]
    rail_sin: float                 # and its sine, else zero
    rail_cos: float
    track_sin_yaw: float            # of the wheelset's yaw in the track
    track_cos_yaw: float
    reference: float                # the vertical shift for which the place holds [m]


PLACE_SIZE: Final[int] = size(Place)
