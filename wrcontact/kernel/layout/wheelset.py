"""Records of the room wheelset: how each side carries its load, and what one step leaves for the next."""

from .patch import Forces
from .record import record


@record
class Wheelset:
    """Where the wheelset stands, and the forces on it."""

    roll: float                     # [rad]
    vertical_shift: float           # [m]
    forces: Forces


@record
class Support:
    """How a side carries its load."""

    approach: float                 # how far the wheel is estimated to come down below its smallest gap [m]
    height: float                   # the vertical shift at which it carries its load [m]
    lever: float                    # how that follows the roll [m]
    friction_load: float            # what its normal forces are to carry, over the load of the inputs [-]
    load_before: float              # the one before [-],
    share_before: float             # and what share of the wanted force it has given [-]


#: Of the left and right side.
Supports = Support * 2


@record
class Broyden:
    """Broyden's method for the height and roll of an elastic wheelset; rolls count in
    metres at the wheels."""

    left: float                     # residuals: how much lower each side carries its load [m]
    right: float
    left_height: float              # their derivatives with respect to height and roll [-]
    left_roll: float
    right_height: float
    right_roll: float
    move_height: float              # the last move [m]
    move_roll: float


@record
class Bracket:
    """Two places between which a value changes its sign."""

    low: float                      # height [m] or roll [rad]
    high: float
    at_low: float                   # the value there [m]
    at_high: float


@record
class Reference:
    """The vertical shift for which wheels are placed over rolled rails, while it is sought."""

    height: float                   # the last one [m]
    residual: float                 # how much lower the contact was found [m]
    slope: float                    # how that follows the height [-]
    contacts: float                 # how many were found
    within: Bracket                 # heights below and above the one that is sought, and their residuals


@record
class State:
    """What one step leaves for the next, and counters; the head of its array."""

    array = "state"
    roll: float                     # last valid roll [rad]
    warm: bool                      # whether there is one
    gap_count: float                # evaluations of the vertical gap since the state was cleared
    scan_count: float               # searches of one side
    roll_count: float               # iterations of the search for roll or equilibrium
    node_count: float               # evaluations of the normal gap
    solve_count: float              # iterations of the force solve
    y_left: float                   # wheel abscissae of the last contacts [m]
    y_right: float
    shift: float                    # and the lateral shift [m]
    strip_count: float              # systems of strips solved
