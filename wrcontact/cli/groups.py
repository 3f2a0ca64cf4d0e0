"""Groups of options in help texts, which of them are usual, and words that differ from those of FMUs."""

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
MOVES = re.compile("independent|speed|velocity|_rate|curvature$|friction|slope_")
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
#: Help texts that differ from those of the FMU.
WORDS = {
    "wheel": f"Wheel profile: {', '.join(WHEELS)}, {FROM_FILE}",
    "rail": f"Rail profile: {', '.join(RAILS)}, {FROM_FILE}",
    "rail_inclination": "Inclination of the rails towards the track centre, as a ratio, 1:40, or a slope, "
    "0.025",
    "normal_force": "Load per wheel before load transfer; --load says whether it is the normal or the "
    "vertical force",
    "load_transfer": "Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 "
    "- L) left",
    "vertical_shift_input": "Height of the wheelset with --contact-mode compliant, positive down",
    "roll_input": "Roll of the wheelset with --contact-mode compliant, positive with the right wheel down",
    "speed": "Speed along the track; creepages need a velocity, such as this",
    "vertical_velocity": "How fast the vertical shift grows, read with --contact-mode compliant alone",
    "roll_rate": "How fast the roll grows, read with --contact-mode compliant alone",
    "wheel_rate": "Rotation of the wheelset about its axle, positive when it rolls forward; 0 is that of "
    "free rolling, without torque or under --axle-torque",
    **{
        f"{side}_wheel_rate": f"{side.capitalize()} wheel: rotation about the axle with --independent-wheels, "
        "positive when it rolls forward; 0 is that of free rolling"
        for side in ("left", "right")
    },
    "free_rolling": "A --wheel-rate of 0 means wheels that turn freely or under --axle-torque; otherwise it "
    "means wheels that do not turn",
    "nominal_rolling": "Free wheels turn at --speed over --nominal-radius, a rotation that brakes or drives, "
    "instead of the one without torque",
    "axle_torque": "Torque of motor or brake on the wheelset about its axle, positive where it drives forward; "
    "read where --wheel-rate is 0",
    **{
        f"{side}_axle_torque": f"{side.capitalize()} wheel: torque of motor or brake on it with "
        "--independent-wheels, positive where it drives forward"
        for side in ("left", "right")
    },
    "independent_wheels": "Each wheel turns by itself, with --left-wheel-rate and --right-wheel-rate instead "
    "of --wheel-rate",
    "wear_outputs": "Compute what models of wear read: the place on both profiles, the friction power and "
    "the patch at each station of an outline",
    "fatigue_outputs": "Compute T gamma, its damage, the shakedown ratio and the surface fatigue index of "
    "each patch",
    "error_outputs": "Let the --normal-model analyn estimate its error in the peak pressure; "
    "auto always does, others have none",
    "yield_shear": "Yield stress in cyclic shear of wheel or rail, read with --fatigue-outputs; give that of "
    "your steel",
    "left_friction": "Left wheel: coefficient of friction, read with a --tangential-model",
    "right_friction": "Right wheel: coefficient of friction, read with a --tangential-model",
    "flange_friction_angle": "Contact angle half-way between the friction of the tread and that of the "
    "flange; it changes over 11.5 deg to either side",
    "slope_reduction_floor": "Share of the slope that is left at large creepage where "
    "--slope-reduction-rate is above 0 (alpha)",
    "contact_damping": "Contact damping with --contact-mode compliant: forces are multiplied by 1 + "
    "damping times the speed of the approach, and are never below zero",
    **{
        f"{side}rail_{direction}_stiffness": f"{words}tiffness of the spring that holds each rail {adverb}, "
        "read with --contact-mode compliant; 0: " + zero
        for side, words, zero in (("", "S", "rigid"), (LEFT, "Left side: s", "as on the right"))
        for direction, adverb in (("lateral", "laterally"), ("vertical", "vertically"))
    },
    **{
        f"{side}rail_{direction}_damping": f"{words}amping beside the {direction} spring of each rail, over "
        "the --rail-time-step" + zero
        for side, words, zero in (("", "D", ""), (LEFT, "Left side: d", "; 0: as on the right"))
        for direction in ("lateral", "vertical")
    },
    **{
        f"{side}_rail_deflection_{direction}_before": f"{side.capitalize()} rail: {direction} deflection of "
        "its springs one --rail-time-step ago"
        for side in ("left", "right")
        for direction in ("lateral", "vertical")
    },
    "contact_mode": "How wheel and rail meet. rigid: the undeformed surfaces touch; elastic: the wheels "
    "approach the rails until each carries its load, which gives height and roll; "
    "compliant: --vertical-shift-mm and --roll-deg give height and roll, and the loads "
    "follow",
    "load": "What --normal-force-kn is. normal: the sum over the patches of a wheel; vertical: the "
    "vertical component of their resultant",
    "separation": "How the undeformed distance of wheel and rail is measured. normal: along the normal of "
    "the contact plane; vertical: at equal lateral coordinates; equidistant: between points "
    "at equal arc lengths from the contact; equidistant_chord: between nodes at equal chord "
    "steps from the contact",
    "lateral_curvature": "Curvature across the rail. adaptive: averaged over a window in proportion to the "
    "patch; smooth: of circles fitted to the profiles over --curvature-reach-mm on "
    "either side; rough: change of the profile angles over --curvature-step-mm",
    "curvature_step": "Arc length over which --lateral-curvature rough takes the change of the profile angle",
    "curvature_reach": "Half the width over which --lateral-curvature smooth fits circles to the profiles",
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


def words_of(name, variable, family):
    """What the help says of an option, without unit and default."""
    if name in WORDS:
        return WORDS[name]
    if family:
        return f"{family.decides[0].upper()}{family.decides[1:]}. " + "; ".join(
            f"{method.name}: {method.words}" for method in family.methods
        )
    return variable.description
