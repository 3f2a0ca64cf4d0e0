"""Records of the room wheelset: how each side carries its load, and what one step leaves for the next."""

from .record import Float, record, run

#: Force x, y, z [N] and moment x, y, z [N m].
Resultant = run(6)


@record
class Support:
    first: float                    # how far below its smallest gap the wheel is estimated to sink [m]
    height: float                   # the vertical shift at which it carries its load [m]
    lever: float                    # how that follows the roll [m]
    spare_3: Float * 5
    resultant: Resultant            # force on the wheel and its moment about the track's origin
    spare_14: Float * 2


@record
class State:
    array = "state"
    roll: float                     # last valid roll [rad]
    warm: float                     # 1 when STATE_ROLL holds one
    gap_count: float                # evaluations of the vertical gap since the state was cleared
    scan_count: float               # scans of one side
    roll_count: float               # iterations of the roll search
    node_count: float               # evaluations of the normal gap
    solve_count: float              # iterations of the force solve
    y_left: float                   # wheel abscissae of the last contacts [m]
    y_right: float
    shift: float                    # and the lateral shift [m]
    strip_count: float              # systems of strips solved
