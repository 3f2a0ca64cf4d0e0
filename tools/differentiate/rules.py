"""What the differentiation knows of the kernel by name: rules for iterations, arrays that follow the
inputs, rates of functions."""

#: What stands in for an iteration when the kernel is differentiated: a function of RULE_MODULES.
RULES = {
    "zone_width": "width_rule", "solve_penetrations": "penetrations_rule", "move_arc": "arc_rule",
    "move_chord": "chord_rule", "move_across": "across_rule", "meet_wheel": "meet_rule",
    "find_overlaps": "overlaps_rule",
}
#: A part of a rule, and the function whose rule it is a part of.
PARTS = {"turning_rule": "find_overlaps", "width_jet": "zone_width"}
#: Called by the rules as it is: it solves for rates.
RATE_SOLVER = "eliminate"
#: The modules of the room kernel/derivative, which are differentiated and not translated themselves.
RULE_MODULES = ("contact_rules", "intrinsics", "wheelset_rules")
ROOT = "differentiate"
ACTIVE_ARRAYS = {"work", "place"}
INTRINSICS = {"held", "moving", "seeded", "rate_of", "differentiated"}
#: Rates of functions of one argument, where {v} is the argument, {f} the value and {d} the argument's rate.
RATES = {"sqrt": "root_rate({f}, {d})", "fabs": "size_rate({v}, {d})", "log": "{d} / {v}", "exp": "{f} * {d}",
         "sin": "cos({v}) * {d}", "cos": "-sin({v}) * {d}", "atan": "{d} / (1.0 + {v} * {v})"}
HELPERS = '''"""How roots and sizes change: helpers of the differentiated kernel."""


def root_rate(root: float, rate: float):
    """Rate of a square root whose argument changes by ``rate``; 0 where the root is 0."""
    result = 0.0
    if root != 0.0:
        result = 0.5 * rate / root
    return result


def size_rate(value: float, rate: float):
    """Rate of abs(value)."""
    result = rate
    if value < 0.0:
        result = -rate
    return result


def power_rate(power: float, base: float, exponent: float, rate: float):
    """Rate of base ** exponent; 0 where the base is 0."""
    result = 0.0
    if base != 0.0:
        result = exponent * power / base * rate
    return result
'''
