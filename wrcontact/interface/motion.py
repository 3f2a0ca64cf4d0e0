"""The inputs that say how the wheelset moves: rows of the table in inputs.py."""

from .rows import Input

#: Permitted size of the speed [m/s], other velocities [m/s], rotations [rad/s], the wheels' rotation [rad/s]
#: and the curvature of the track [1/m]; beyond them a value has lost its unit.
SPEED_LIMIT, VELOCITY_LIMIT, RATE_LIMIT, WHEEL_LIMIT, CURVATURE_LIMIT = 200.0, 20.0, 100.0, 2000.0, 0.1

#: Where the contact determines it, an input of this kind is not read.
DERIVED = "in other contact modes it follows from contact with both rails, and this input is not read"


def _rail(side):
    """How fast a rail moves."""
    def row(part, unit, nominal, meaning, limit):
        return Input(f"{side}.rail_{part}_velocity", unit, nominal, meaning,
                     -limit, limit, limited=True, field=f"{side}_rail_{part}_velocity",
                     place=f"{side.capitalize()} rail")

    return (row("lateral", "m/s", 0.01, "velocity to the right", VELOCITY_LIMIT),
            row("vertical", "m/s", 0.01, "velocity down", VELOCITY_LIMIT),
            row("roll", "rad/s", 0.1, "rotation about its highest point, right side down", RATE_LIMIT))


MOTION = (
    Input("speed", "m/s", 10.0, "Speed along the track; creepages need speed or wheel_rate",
          -SPEED_LIMIT, SPEED_LIMIT, limited=True),
    Input("lateral_velocity", "m/s", 0.01, "How fast the lateral shift grows",
          -VELOCITY_LIMIT, VELOCITY_LIMIT, limited=True),
    Input("vertical_velocity", "m/s", 0.01, "How fast the vertical shift grows in the contact_mode "
          f"compliant; {DERIVED}", -VELOCITY_LIMIT, VELOCITY_LIMIT, limited=True),
    Input("yaw_rate", "rad/s", 0.1, "How fast the yaw grows, excluding the rotation of the track in a curve",
          -RATE_LIMIT, RATE_LIMIT, limited=True),
    Input("roll_rate", "rad/s", 0.01, f"How fast the roll grows in the contact_mode compliant; {DERIVED}",
          -RATE_LIMIT, RATE_LIMIT, limited=True),
    Input("wheel_rate", "rad/s", 20.0, "Rotation of the wheelset about its axle, positive when it rolls "
          "forward; 0 with free_rolling means speed / nominal_radius",
          -WHEEL_LIMIT, WHEEL_LIMIT, limited=True),
    Input("free_rolling", "1", 1.0, "Whether a wheel_rate of 0 means speed / nominal_radius; otherwise it "
          "means wheels that do not turn", 0.0, 1.0, start=1.0, switch=True),
    Input("track_curvature", "1/m", 1e-3, "Curvature of the track, 1 / radius, positive in a curve to the "
          "right", -CURVATURE_LIMIT, CURVATURE_LIMIT, limited=True),
    *(row for side in ("left", "right") for row in _rail(side)),
)
