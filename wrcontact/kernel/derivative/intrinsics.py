"""What the rules say about rates.

The differentiation (tools/differentiate) knows these functions by name and replaces their calls; the bodies
say what is left where no rates are carried.
"""


def held(x: float):
    """``x`` as a constant."""
    return x


def moving(x: float, other: float):
    """``x``, which moves as ``other`` does."""
    return x


def seeded(x: float, rate: float):
    """``x``, which moves at ``rate``."""
    return x


def rate_of(x: float):
    """How ``x`` moves; nothing does where no rates are carried."""
    return 0.0


def nonzero(rate: float) -> bool:
    """Whether anything moves at this ``rate``."""
    return rate != 0.0


def common_rate(rate: float):
    """A ``rate`` that is the same along every direction, as a value."""
    return rate


def differentiated(x: float):
    """``x``, a call of a function that has a rule, differentiated as it is written."""
    return x
