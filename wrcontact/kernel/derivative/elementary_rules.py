"""How the elementary functions follow their arguments: by the derivatives that calculus gives them, not by
those of their series.  As contact_rules.py an input of ``tools/differentiate``."""

from ..elementary.circle import atan, atan2, sine_cosine
from ..elementary.powers import cube_root, exp, log
from .intrinsics import held, rate_of, seeded


def sine_cosine_rule(x: float):
    """Sine and cosine."""
    sine, cosine = sine_cosine(held(x))
    return seeded(sine, cosine * rate_of(x)), seeded(cosine, -sine * rate_of(x))


def atan_rule(x: float):
    """Arc tangent."""
    return seeded(atan(held(x)), rate_of(x) / (1.0 + x * x))


def atan2_rule(up: float, along: float):
    """Angle of a direction."""
    return seeded(
        atan2(held(up), held(along)), (along * rate_of(up) - up * rate_of(along)) / (along * along + up * up)
    )


def exp_rule(x: float):
    """Exponential."""
    value = exp(held(x))
    return seeded(value, value * rate_of(x))


def log_rule(x: float):
    """Logarithm."""
    return seeded(log(held(x)), rate_of(x) / x)


def cube_root_rule(x: float):
    """Cube root; at 0 it has no rate, which counts as 0."""
    root = cube_root(held(x))
    rate = 0.0
    if held(x) != 0.0:
        rate = root / (3.0 * held(x)) * rate_of(x)
    return seeded(root, rate)
