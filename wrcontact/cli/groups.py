"""Groups of options in help texts, and which of them are usual."""

import re

from ..interface.parameters import LEFT
from ..profiles import RAILS, WHEELS

POSE, PROFILES, METHODS, MOTION = (
    "Pose and load",
    "Profiles, wheelset, track and material",
    "Methods",
    "Motion and friction",
)
MOVING, OTHER_SIDE, FILES = "Rails that move", "Left side, where it differs", "Files of profiles"
GRID = "Table over several inputs"
#: In the order in which a help text shows them, after a command's own options.
ORDER = (GRID, POSE, PROFILES, METHODS, MOTION, MOVING, OTHER_SIDE, FILES)
OF_POSE = {
    "lateral_shift",
    "yaw",
    "normal_force",
    "load_transfer",
    "vertical_shift_input",
    "roll_input",
    "load",
}
OF_PROFILES = {
    "wheel",
    "rail",
    "rail_inclination",
    "gauge",
    "gauge_depth",
    "running_circle_distance",
    "nominal_radius",
    "youngs_modulus",
    "poisson_ratio",
}
#: What belongs to motion and friction has one of these in its name.
MOVES = re.compile("independent|torque|speed|velocity|_rate|curvature$|friction|slope_")
METHODS_OF_CURVATURE = {"longitudinal_curvature", "lateral_curvature"}
#: Options that --help shows; --help-all shows the others too.
USUAL = {
    "lateral_shift",
    "yaw",
    "normal_force",
    "load_transfer",
    "wheel",
    "rail",
    "rail_inclination",
    "gauge",
    "nominal_radius",
    "contact_mode",
    "normal_model",
    "tangential_model",
    "speed",
    "left_friction",
    "right_friction",
}
FROM_FILE = "others of `wrcontact profiles`, or a file of points (docs/guides/profiles.md)"
#: Help texts of profiles, of which an FMU has those that were packed.
OF_KINDS = {
    "wheel": f"Wheel profile: {', '.join(WHEELS)}, {FROM_FILE}",
    "rail": f"Rail profile: {', '.join(RAILS)}, {FROM_FILE}",
}


def group_of(name):
    """The group of the option for an input or parameter, by its Python name."""
    if name in OF_POSE:
        return POSE
    if name.removeprefix(LEFT) in OF_PROFILES:
        return PROFILES if name in OF_PROFILES else OTHER_SIDE
    if "_rail_" in name or name.startswith("rail_"):
        return MOVING
    return MOTION if MOVES.search(name) and name not in METHODS_OF_CURVATURE else METHODS
