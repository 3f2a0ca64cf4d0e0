"""How finely the kernel resolves a contact: nodes and strips, by the tolerance that is asked for.

A tolerance is the relative error of the numerics, against the same model resolved as finely as the kernel can, that 95 of
100 random poses keep in penetration, area and peak pressure alike: S1002 on UIC60, |lateral shift| <= 6.6 mm, 3 to 200 kN,
half of them with up to 2 degrees of yaw (``python -m benchmarks`` measures it anew).  It says nothing about the model's own
error, which benchmarks and README list.  Worse poses are those where a region of contact is about to appear.
"""

from numbers import Real
from typing import NamedTuple


class Resolution(NamedTuple):
    """Nodes per half-width of the interpenetration, every ``stride``-th of them traced on the profiles; strips, sweeps."""

    nodes: int
    stride: int
    strips: int
    sweeps: int


#: By falling tolerance what keeps it; the last one is as fine as it gets.
ANALYN = {
    0.02: Resolution(4, 1, 24, 2),
    0.01: Resolution(8, 2, 24, 2),
    0.004: Resolution(15, 3, 24, 2),
    0.0015: Resolution(30, 2, 24, 2),
}
ANALYN_STRIP = {
    0.025: Resolution(8, 2, 16, 1),
    0.015: Resolution(8, 1, 20, 2),
    0.01: Resolution(15, 2, 24, 2),
    0.007: Resolution(15, 1, 32, 2),
    0.004: Resolution(22, 1, 48, 3),
}
LADDERS = {"analyn": ANALYN, "analyn_strip": ANALYN_STRIP}
DEFAULT = 0.01

#: Smallest tolerance of each model; Hertz's ellipse is a formula, and the half-space refines its grid as far.
FINEST = {"analyn": min(ANALYN), "analyn_strip": min(ANALYN_STRIP), "hertz": 1e-4, "halfspace": 3e-4}

#: Permitted whole numbers, in place of what the tolerance asks for, and the models that have them.
COUNTS = {"nodes": (4, 38), "strips": (16, 64), "sweeps": (1, 4)}
USERS = {"nodes": ("analyn", "analyn_strip"), "strips": ("analyn_strip",), "sweeps": ("analyn_strip",)}


def resolve(model, tolerance=None, nodes=None, strips=None, sweeps=None):
    """The :class:`Resolution` of a normal model for a tolerance, with single numbers replaced by those given.

    Raises
    ------
    ValueError
        in a sentence with name, value and permitted range.
    """
    tolerance = DEFAULT if tolerance is None else tolerance
    ladder = LADDERS.get(model, ANALYN)
    if tolerance < FINEST[model]:
        raise ValueError(f"tolerance is {tolerance:g}; permitted with the normal_model {model!r} is "
                         f"{FINEST[model]:g} ... 0.1 1")
    keeping = [resolution for kept, resolution in ladder.items() if kept <= tolerance]
    chosen = keeping[0] if keeping else list(ladder.values())[-1]
    given = {name: value for name, value in (("nodes", nodes), ("strips", strips), ("sweeps", sweeps)) if value is not None}
    for name, value in given.items():
        check_count(model, name, value)
    if nodes is not None:
        given["stride"] = 1
    return chosen._replace(**{name: int(value) for name, value in given.items()})


def check_count(model, name, value):
    """ValueError unless ``value`` is a whole number in the range of ``name``, which ``model`` must have."""
    low, high = COUNTS[name]
    if model not in USERS[name]:
        users = " or ".join(repr(user) for user in USERS[name])
        raise ValueError(f"{name} is {value!r}; permitted with the normal_model {model!r} is None, only {users} has {name}")
    whole = isinstance(value, Real) and not isinstance(value, bool) and low <= value <= high and value == int(value)
    if not whole:
        raise ValueError(f"{name} is {value!r}; permitted are whole numbers {low} ... {high}")
