"""Records of rails whose section changes along the track: the table of such a rail, and the search over it."""

from typing import Final

from .contact import Place
from .record import OPEN, Float, To, record, run

BOX_LIMIT: Final[int] = 512  # boxes that wait to be searched
#: Bounds are known over rows of 1, LEVEL_RATIO and LEVEL_RATIO^2 cells along the track.
LEVEL_COUNT: Final[int] = 3
LEVEL_RATIO: Final[int] = 4
#: The longitudinal curvature of a wheel on a changing rail: the effective one, with that of the rail (surface/curvature.py).
LONGITUDINAL_CHANGING: Final[int] = 100


@record
class SectionCubic:
    """A cubic of the distance from a break along the track."""

    c0: float
    c1: float
    c2: float
    c3: float


@record
class SectionKnot:
    """A line of equal share between two breaks: its lateral place, and there height, slope and second derivative
    across the track, towards the line before and the one behind."""

    place: SectionCubic  # [m]
    height: SectionCubic  # [m]
    slope: SectionCubic  # [-]
    before: SectionCubic  # [1/m]
    behind: SectionCubic  # [1/m]


@record
class SectionCell:
    """Bounds of the surface's derivatives in a cell, and over the next ones along the track."""

    least_along: float  # z_u [-]
    most_along: float
    least_across: float  # z_y [-]
    most_across: float
    least_bend_along: float  # z_uu [1/m]
    most_bend_along: float
    least_twist: float  # z_uy [1/m]
    most_twist: float
    least_bend_across: float  # z_yy [1/m]
    most_bend_across: float
    least_lean: float  # x component of the normal that points down [-]
    most_lean: float


#: Values at the breaks along the track.
SectionBreaks = run(OPEN)
SectionKnots = SectionKnot * OPEN
SectionCells = SectionCell * OPEN


@record
class SectionFrame:
    """A frame along the ruling direction of a changing rail at a place, in the track; its x is that direction, its y lies
    level to the field side."""

    x: float  # the place [m], ahead of the wheelset's middle,
    y: float  # as that of a right side where the rail is in its nominal place,
    z: float
    along: Float * 3  # its axes in the track
    aside: Float * 3
    down: Float * 3
    centre: Float * 3  # the wheelset's centre in it [m]
    turn: float  # of the wheel, for angles around it in the frame [rad]


@record
class ValleyNode:
    """Where a line of a changing rail crosses the places along the track at which the wheel is nearest, in the frame."""

    y: float  # place across [m]
    z: float  # height of the constant rail that has the same gap [m], its slope [-],
    slope: float
    before: float  # and second derivatives on both sides [1/m]
    behind: float
    gap: float  # of wheel and rail there [m]
    wheel: float  # wheel abscissa of the outline there [m]
    move: float  # how far the nearest place lies ahead of the outline [m]
    lift: float  # and how much lower the wheel is there [m]
    rise: float  # slope of both surfaces along the frame there [-]
    bend: float  # curvature of the rail along the frame, positive on a crest [1/m]
    rate: float  # lateral place of the line by the position along the track [-]
    skew: float  # how much the patch runs obliquely to the frame here, 0 ... 1 [-]
    bridge: bool  # whether no line was followed here: the rail is laid far below the wheel


#: One for each line.
ValleyNodes = ValleyNode * OPEN


@record
class Sections:
    """A rail whose section changes along the track (wrcontact/sections/surface.py)."""

    interval_count: int
    knot_count: int
    breaks: To(SectionBreaks)  # where the cubics begin and the last one ends [m]
    knots: To(SectionKnots)  # those of the first interval, then those of the next
    along_count: int  # of the cells of bounds
    across_count: int
    along: To(SectionBreaks)  # where the cells begin and the last one ends [m]
    across_start: float  # lateral places where they begin and end [m]
    across_stop: float
    across_per_metre: float
    cells: To(
        SectionCells
    )  # of single cells, a row across for each one along; then of LEVEL_RATIO cells, ...
    arcs: To(SectionBreaks)  # how long the section is from its first line to each at each break [m]
    top: float  # height of the highest place [m]
    least_lean: float  # over the whole surface [-]
    most_lean: float
    # what follows a pose, in the tables of one stepper
    lateral: float  # track coordinate of the origin, as that of a right side [m]
    room: int  # from the beginning of the tables to where the rail of a pose is written
    scratch: int
    first: int  # the nodes that are known
    last: int
    cut_first: bool  # whether the places beyond are not followed, though there is a rail
    cut_last: bool
    bridged: bool  # whether a node is one of a bridge
    far: float  # the gap up to which it is laid [m]
    arc_start: float  # where the section begins and ends in the frame [m],
    arc_stop: float
    arc_before: float  # how long it is before the first node, later before the first cell of its arcs [m],
    arc_total: float  # and all of it
    frame: SectionFrame
    nodes: To(ValleyNodes)


@record
class SectionBounds:
    """Bounds as in a cell, over a part of the surface."""

    least_along: float
    most_along: float
    least_across: float
    most_across: float
    least_bend_along: float
    most_bend_along: float
    least_twist: float
    most_twist: float
    least_bend_across: float
    most_bend_across: float
    least_lean: float
    most_lean: float


@record
class SectionBox:
    """Places on the wheel that wait to be searched."""

    low: float  # wheel abscissae [m]
    high: float
    back: float  # angles around the wheel [rad]
    ahead: float


@record
class SectionGap:
    """The gap at a place of the wheel, and its derivatives by abscissa and angle."""

    gap: float  # [m]
    across: float  # [-]
    around: float  # [m]
    bend_across: float  # [1/m]
    twist: float  # [-]
    bend_around: float  # [m]
    x: float  # place in the track, from the middle of the wheelset [m]
    y: float
    along: float  # slopes of the rail there [-]
    slope: float


@record
class SectionSpread:
    """What is known of the wheel over a box, and of the gap's second derivatives in it."""

    least_slope: float  # of the wheel's profile [-]
    most_slope: float
    least_bend: float  # [1/m]
    most_bend: float
    least_radius: float  # [m]
    most_radius: float
    out_of_round: bool  # whether the next ones are known; they are those of the radius:
    least_rate: float  # by the angle [m],
    most_rate: float
    least_rate_bend: float  # its second derivative [m],
    most_rate_bend: float
    most_rate_twist: float  # and the largest absolute mixed one [-]
    least_lead: float  # of the normal before the radius, by these rates [rad]
    most_lead: float
    least_lead_cosine: float
    least_sine: float  # of the angles
    most_sine: float
    least_cosine: float
    most_cosine: float
    least_outward: float  # G along the direction to the place, and beside it [-]
    most_outward: float
    least_aside: float
    most_aside: float
    least_rise: float  # derivatives of the gap by the abscissa [-]
    most_rise: float
    least_turn: float  # and by the angle [m]
    most_turn: float
    bend_across: float  # smallest second derivative of the gap by the abscissa [1/m]
    twist: float  # largest absolute mixed one [-]
    bend_around: float  # smallest one by the angle [m]
    most_across: float  # largest absolute ones
    most_around: float


@record
class SectionSearch:
    """The smallest gap of one wheel over a rail whose section changes, while it is sought."""

    place: Place  # where the wheel is placed
    position: float  # of the wheelset along the track [m]
    rotation: float  # of the wheelset about its axle, without whole turns [rad]
    best: float  # smallest gap found [m]
    best_y: float  # its wheel abscissa [m]
    best_angle: float  # and angle around the wheel, forward from the lowest point [rad]
    settled_y: float  # where Newton's method has settled last
    settled_angle: float
    box_count: float  # boxes looked at
    gap_count: float  # gaps computed
    low: float  # wheel abscissae between which the wheel may overlap its rail [m] (changing/one_valley.py)
    high: float
    on_bridge: bool  # whether the wheel may overlap its rail where that is not followed
    edge: float  # what the gap may be where the straight continuation beside the section ends [m]
    u: float  # middle of the part of the rail below a box [m]
    abscissa: float
    ahead: float  # and how far it reaches at most [m]
    aside: float
    inside: bool  # whether there is a surface below all of it
    at: SectionGap  # last computed; in the end at the smallest one
    spread: SectionSpread
    bounds: SectionBounds  # of the rail
    deviation: SectionBounds  # of a wheel that is not round
    boxes: SectionBox * BOX_LIMIT


@record
class SectionTouch:
    """Where a wheel is nearest to a rail whose section changes."""

    place: Place  # of the wheel
    best: float  # smallest gap [m]
    y: float  # its wheel abscissa [m]
    angle: float  # and angle around the wheel [rad]
    rail_x: float  # place in the track, from the wheelset's middle [m]
    rail_y: float
    rail_z: float
    along: float  # slopes of the rail there [-]
    slope: float
    rate: float  # how the gap follows the roll [m]
    turn_rate: float  # and the rotation of a wheel that is not round [m]


#: Of the left and right side.
SectionTouches = SectionTouch * 2
