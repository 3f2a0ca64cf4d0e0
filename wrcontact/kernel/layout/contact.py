"""Records of the room contact: the plane of a contact and the regions beside it."""

from typing import Final

from .record import Float, record

REGION_LIMIT: Final[int] = 3         # loaded regions of one wheel
REGION_BLOCK: Final[int] = 48        # numbers kept of each
CONTACT_BLOCK: Final[int] = 40       # contact frame and tracer
OVERLAP_LIMIT: Final[int] = 200      # samples of the overlap of a pressed wheel to either side
OVERLAP_BLOCK: Final[int] = 64 + 4 * 2 * OVERLAP_LIMIT


@record
class Frame:
    abscissa: float                 # rail abscissa of the contact point [m]
    height: float                   # rail height there [m]
    y: float                        # wheel abscissa [m]
    cos: float                      # of the plane's angle
    sin: float
    shift: float                    # vertical shift of the wheelset [m]
    place: float                    # offset of the placed wheel in the workspace
    z: float                        # wheel height [m]
    wheel_cos: float                # of the plane's angle in the wheelset's frame
    wheel_sin: float
    tracer_station: float
    tracer_rail: float
    tracer_rail_rate: float
    tracer_rail_bend: float
    tracer_wheel: float
    tracer_wheel_rate: float
    tracer_wheel_bend: float
    lift: float                     # of the wheel's point below the rail's [m]; zero but for rounding
    aside: float                    # lateral shift that lets the wheel just touch [m]; zero for a rigid contact
    raised: float                   # what is added to the gap of a region with a plane of its own [m]
    pose: float                     # vertical shift of the wheelset where it stands [m]
    depth: float                    # how deep wheel and rail overlap there, along the normal [m]
    pressed: bool                  # 1 if the wheel comes down, 0 if it comes along the normal
    blur: float                     # half the stretch of a pressed wheel that its bend is averaged over [m]
    spare_24: Float * 16


@record
class Origin:
    station: float                  # [m]
    gap: float                      # the normal gap there [m]
    rail: Float * 2                 # rail abscissa and height there [m]
    wheel: Float * 2                # the outline's lateral and vertical coordinate there [m]
    spacing: float                  # length of a chord [m]; 0: true arc length
    spare_7: Float * 1


@record
class Region:
    station: float                  # of the minimum [m]
    gap: float                      # there [m]
    rail: float                     # rail and wheel abscissa there [m]
    wheel: float
    low: float                      # stations that bound it [m]
    high: float
    width_low: float                # half-widths of the interpenetration [m]
    width_high: float
    spacing: float                  # of its nodes [m]
    first: int                    # first and last node
    last: int
    local_penetration: float        # share of the total, less own gap and the displacement by other regions [m]
    load: float                     # [N]
    stiffness: float                # rate of the load over it [N/m]
    bend: float                     # second derivative of the gap at the minimum [1/m]
    curvature: float                # the wheel's 1/R_x at the minimum [1/m]
    middle: float                   # station that stands for its load in the interaction [m]
    residual: float                 # of the local penetration during the force solve [m]
    slope: float                    # its change per change of the total penetration [-]
    move: float                     # its change that closes the residual [m]
    width_penetration: float        # local penetration that the half-widths were measured at [m]
    square: float                   # square of its half-length as estimated [m^2]
    reached: float                  # rise of the gap where the last half-width ends [m]
    side_low: float                 # lateral curvature on either side, rise over square of the half-width [1/m]
    side_high: float
    upright_a: float                # upright ellipse with the strips of a yawed wheel's tilted one: its A and B over the
    upright_b: float                # real ones, and its penetration over the real one [-]
    upright_share: float
    slant: float                    # of the line along which the gap is smallest, dx/ds [-]; of a yawed wheel only
    own: bool                      # 1 if it has a plane of its own, else 0
    turn: float                     # how much of the penetration comes along its normal [-]
    offset: float                   # from its own stations to those of the outputs [m]
    cos: float                      # of the angle along which its force acts: the rail's at its minimum, or the mean over it
    sin: float
    share: float                    # of its load that counts for the prescribed force
    moment: float                   # of the load that it carries, over the stations of the outputs [N m]
    carried: float                  # that load [N]
    lean: float                     # slope of the rail at its minimum
    along: float                    # track coordinate x of the minimum [m], where regions lean apart
    strip: int                      # the strip of the solved patches at its minimum
    spare_43: Float * 8


#: The loaded regions of one wheel.
Regions = Region * REGION_LIMIT
