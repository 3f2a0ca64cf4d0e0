"""What the differentiation knows of the kernel by name: rules for iterations and elementary functions, arrays
that follow the inputs, rates of functions."""

#: What stands in for an iteration or a series when the kernel is differentiated: a function of RULE_MODULES.
RULES = {
    "zone_width": "width_rule",
    "solve_penetrations": "penetrations_rule",
    "move_arc": "arc_rule",
    "move_chord": "chord_rule",
    "move_across": "across_rule",
    "meet_wheel": "meet_rule",
    "find_overlaps": "overlaps_rule",
    "sine_cosine": "sine_cosine_rule",
    "atan": "atan_rule",
    "atan2": "atan2_rule",
    "exp": "exp_rule",
    "log": "log_rule",
    "cube_root": "cube_root_rule",
}
#: A part of a rule, and the function whose rule it is a part of.
PARTS = {"turning_rule": "find_overlaps", "width_jet": "zone_width"}
#: The modules of the room kernel/derivative, which are differentiated and not translated themselves.
RULE_MODULES = (
    "compliant_rules",
    "contact_rules",
    "elementary_rules",
    "intrinsics",
    "motion_rules",
    "turning_rules",
    "wheelset_rules",
)
ROOT = "differentiate"
ACTIVE_ARRAYS = {"work", "place"}
INTRINSICS = {"held", "moving", "seeded", "rate_of", "differentiated", "nonzero", "common_rate"}
#: Of these and of RATES: functions of the module derivative_rates.
RATE_FUNCTIONS = {"root_rate", "size_rate", "nonzero", "common_rate"}
#: Rates of functions of one argument, where {v} is the argument, {f} the value and {d} the argument's rate.
RATES = {"sqrt": "root_rate({f}, {d})", "fabs": "size_rate({v}, {d})"}
#: What else is asked of rates.  The compiled kernel has these functions, for rates along several directions,
#: in native/directions.h.
HELPERS = '''"""How roots and sizes change, and what else is asked of rates."""


def root_rate(root: float, rate: 'rate') -> 'rate':
    """Rate of a square root whose argument changes by ``rate``; 0 where the root is 0."""
    return 0.5 * rate / root if root != 0.0 else 0.0


def size_rate(value: float, rate: 'rate') -> 'rate':
    """Rate of abs(value)."""
    return -rate if value < 0.0 else rate


def nonzero(rate: 'rate') -> 'bool':
    """Whether anything moves at this ``rate``."""
    return rate != 0.0


def common_rate(rate: 'rate') -> 'float':
    """A ``rate`` that is the same along all directions."""
    return rate
'''
