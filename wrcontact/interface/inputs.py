"""The inputs: one row for each, in the order of the kernel's array; those of friction are in friction.py."""

from .friction import FRICTION
from .rows import Input

#: Permitted size of a rail's displacement [m] and of its roll [rad].
RAIL_LIMIT, RAIL_ROLL_LIMIT = 0.05, 0.05
#: Permitted size of the speed [m/s], other velocities [m/s], rotations [rad/s], the wheels' rotation [rad/s]
#: and the curvature of the track [1/m]; beyond them a value has lost its unit.
SPEED_LIMIT, VELOCITY_LIMIT, RATE_LIMIT, WHEEL_LIMIT, CURVATURE_LIMIT = 200.0, 20.0, 100.0, 2000.0, 0.1
#: Permitted size of the torque on an axle [N m].
TORQUE_LIMIT = 1e7
#: Declared range of places along the track [m].
POSITION_LIMIT = 1e6
#: Longest time of a step of rails on springs [s].
TIME_LIMIT = 1e6
#: Where the contact determines it, an input of this kind is not read.
DERIVED = "in other contact modes it follows from contact with both rails, and this input is not read"
#: Permitted |lateral shift| [m] and |yaw| [rad]; beyond it the contact leaves the profiles' running surfaces.
LATERAL_LIMIT, YAW_LIMIT = 0.015, 0.12
#: Permitted |roll| [rad], within which the roll is searched; 12 mm of lateral shift need 0.013.
ROLL_LIMIT = 0.12
#: Declared range of the height in compliant contact [m]: a flange on top of the rail lifts the wheelset by 28
#: mm.
HEIGHT_LIMIT = 0.05


def _rail(side, part, unit, nominal, meaning, limit, **more):
    """An input of the rail of one side."""
    return Input(
        f"{side}.rail_{part}",
        unit,
        nominal,
        meaning,
        -limit,
        limit,
        field=f"{side}_rail_{part}",
        place=f"{side.capitalize()} rail",
        **more,
    )


RAILS = tuple(
    row
    for side in ("left", "right")
    for row in (
        _rail(side, "lateral", "m", 1e-3, "displacement from its nominal place, to the right", RAIL_LIMIT),
        _rail(side, "vertical", "m", 1e-3, "displacement from its nominal place, down", RAIL_LIMIT),
        _rail(
            side,
            "roll",
            "rad",
            1e-2,
            "rotation about its highest point in its nominal place, positive with the right side down",
            RAIL_ROLL_LIMIT,
        ),
    )
)

MOTION = (
    Input(
        "speed",
        "m/s",
        10.0,
        "Speed along the track; creepages need a velocity, such as this",
        -SPEED_LIMIT,
        SPEED_LIMIT,
        limited=True,
    ),
    Input(
        "lateral_velocity",
        "m/s",
        0.01,
        "How fast the lateral shift grows",
        -VELOCITY_LIMIT,
        VELOCITY_LIMIT,
        limited=True,
    ),
    Input(
        "vertical_velocity",
        "m/s",
        0.01,
        f"How fast the vertical shift grows with contact_mode compliant; {DERIVED}",
        -VELOCITY_LIMIT,
        VELOCITY_LIMIT,
        limited=True,
    ),
    Input(
        "yaw_rate",
        "rad/s",
        0.1,
        "How fast the yaw grows, excluding the rotation of the track in a curve",
        -RATE_LIMIT,
        RATE_LIMIT,
        limited=True,
    ),
    Input(
        "roll_rate",
        "rad/s",
        0.01,
        f"How fast the roll grows with contact_mode compliant; {DERIVED}",
        -RATE_LIMIT,
        RATE_LIMIT,
        limited=True,
    ),
    Input(
        "wheel_rate",
        "rad/s",
        20.0,
        "Rotation of the wheelset about its axle, positive when it rolls "
        "forward; 0 with free_rolling: the one without torque or under axle_torque, or speed / nominal_radius "
        "without a tangential_model",
        -WHEEL_LIMIT,
        WHEEL_LIMIT,
        limited=True,
    ),
    Input(
        "free_rolling",
        "1",
        1.0,
        "Whether a wheel_rate of 0 means wheels that turn freely or under axle_torque; otherwise it means "
        "wheels that do not turn",
        0.0,
        1.0,
        start=1.0,
        switch=True,
    ),
    Input(
        "track_curvature",
        "1/m",
        1e-3,
        "Curvature of the track, 1 / radius, positive in a curve to the right",
        -CURVATURE_LIMIT,
        CURVATURE_LIMIT,
        limited=True,
    ),
    *(
        row
        for side in ("left", "right")
        for row in (
            _rail(
                side, "lateral_velocity", "m/s", 0.01, "velocity to the right", VELOCITY_LIMIT, limited=True
            ),
            _rail(side, "vertical_velocity", "m/s", 0.01, "velocity down", VELOCITY_LIMIT, limited=True),
            _rail(
                side,
                "roll_velocity",
                "rad/s",
                0.1,
                "rotation about its highest point, right side down",
                RATE_LIMIT,
                limited=True,
            ),
        )
    ),
)

#: Read where the parameter independent_wheels is true.
RATES = tuple(
    Input(
        f"{side}.wheel_rate",
        "rad/s",
        20.0,
        "rotation about the axle, positive when it rolls forward, "
        "read instead of wheel_rate with independent_wheels; 0 with free_rolling: the one without torque or "
        "under its axle_torque",
        -WHEEL_LIMIT,
        WHEEL_LIMIT,
        field=f"{side}_wheel_rate",
        place=f"{side.capitalize()} wheel",
        limited=True,
    )
    for side in ("left", "right")
)

#: Read where the rotation of the wheels follows from it.
TORQUES = (
    Input(
        "axle_torque",
        "N.m",
        1e3,
        "Torque of motor or brake on the wheelset about its axle, positive where it drives forward; read "
        "where wheel_rate is 0 with free_rolling",
        -TORQUE_LIMIT,
        TORQUE_LIMIT,
        limited=True,
    ),
    *(
        Input(
            f"{side}.axle_torque",
            "N.m",
            1e3,
            "torque of motor or brake on it, positive where it drives forward; read instead of axle_torque "
            "with independent_wheels",
            -TORQUE_LIMIT,
            TORQUE_LIMIT,
            field=f"{side}_axle_torque",
            place=f"{side.capitalize()} wheel",
            limited=True,
        )
        for side in ("left", "right")
    ),
)

#: Read where rails stand on springs.
TIME_STEP = Input(
    "rail_time_step",
    "s",
    1e-3,
    "Time in which rails on springs have come from the "
    "deflections before; 0: they are at rest, and dampers carry nothing",
    0.0,
    TIME_LIMIT,
)
DEFLECTIONS = tuple(
    _rail(
        side,
        f"deflection_{part}_before",
        "m",
        1e-3,
        f"{part} deflection of its springs one rail_time_step ago",
        RAIL_LIMIT,
    )
    for side in ("left", "right")
    for part in ("lateral", "vertical")
)

#: Read where a rail's section changes along the track.
TRACK_POSITION = Input(
    "track_position",
    "m",
    1.0,
    "Place of the wheelset's centre along the track; only read where a rail's section changes",
    -POSITION_LIMIT,
    POSITION_LIMIT,
)

#: Read where a wheel is not round.
WHEEL_ROTATION = Input(
    "wheel_rotation",
    "rad",
    1.0,
    "Turn of the wheelset about its axle, growing when it rolls forward; only read where a wheel is not round",
    -POSITION_LIMIT,
    POSITION_LIMIT,
)

#: Usual loads of a wheel that is not lifted [N]: those of a hand trolley, and of an axle of 200 t. One in kN
#: that is taken for N lies below, and one in N that is taken for kN above.
USUAL_LOAD = (500.0, 1e6)

INPUTS = (
    Input(
        "lateral_shift",
        "m",
        1e-3,
        "Lateral shift of the wheelset against the track centre, positive to the right",
        -LATERAL_LIMIT,
        LATERAL_LIMIT,
        positional=True,
    ),
    Input(
        "yaw",
        "rad",
        1e-2,
        "Yaw of the wheelset, positive clockwise seen from above",
        -YAW_LIMIT,
        YAW_LIMIT,
        positional=True,
    ),
    Input(
        "roll_guess",
        "rad",
        1e-3,
        "Where the search for the roll angle starts; changes the cost of a step, never its answer",
        -0.5,
        0.5,
        hint=True,
    ),
    Input(
        "normal_force",
        "N",
        1e5,
        "Load per wheel before load transfer, normal or vertical (parameter load); in compliant contact only for "
        "the equilibrium",
        0.0,
        1e7,
        start=78500.0,
        positional=True,
        usual=USUAL_LOAD,
    ),
    Input(
        "load_transfer",
        "1",
        0.1,
        "Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 - L) left",
        -1.0,
        1.0,
        positional=True,
    ),
    Input(
        "vertical_shift_input",
        "m",
        1e-3,
        "Vertical shift of the wheelset with contact_mode compliant, positive down; other modes do not read it",
        -HEIGHT_LIMIT,
        HEIGHT_LIMIT,
        field="vertical_shift",
    ),
    Input(
        "roll_input",
        "rad",
        1e-3,
        "Roll of the wheelset with contact_mode compliant, positive with the right wheel down; other modes do "
        "not read it",
        -ROLL_LIMIT,
        ROLL_LIMIT,
        field="roll",
    ),
    *RAILS,
    *MOTION,
    *FRICTION,
    *RATES,
    TIME_STEP,
    *DEFLECTIONS,
    *TORQUES,
    TRACK_POSITION,
    WHEEL_ROTATION,
)

INPUT_NAMES = tuple(row.name for row in INPUTS)
INPUT_UNITS = tuple(row.unit for row in INPUTS)
INPUT_NOMINALS = tuple(row.nominal for row in INPUTS)
#: What an output may depend on.  An FMU declares its dependencies once for all methods: in elastic contact
#: all of these move everything, velocities and friction too where friction carries a part of a vertical load.
#: Rails of FMUs do not change along the track.
ANSWERED = tuple(row.name for row in INPUTS if not row.hint and row is not TRACK_POSITION)
