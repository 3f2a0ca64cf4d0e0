"""One wheel on one rail: which inputs and parameters of a wheelset it has, and its names for them."""

from functools import cache

from ..conventions import SIDES
from ..methods.words import did_you_mean
from .inputs import INPUTS
from .parameters import LEFT, PARAMETERS

#: Inputs and parameters of a wheelset that have no meaning for one wheel, and why.
LOADED = "its load follows from its height"
WITHOUT = {
    "normal_force": LOADED,
    "load_transfer": LOADED,
    "load": LOADED,
    "roll_guess": "its roll is given",
    "independent_wheels": "it turns by its own wheel_rate",
}
#: Inputs that one wheel has under the name of a wheelset's.
SHARED = ("wheel_rate", "axle_torque")
#: The only contact mode of one wheel.
MODE = "compliant"


def own_name(name, side):
    """The name of a wheelset's input or output for the wheel of this ``side``, ``friction`` for
    ``right.friction``; "" for what it does not have."""
    owner, dot, rest = name.partition(".")
    if dot and owner in SIDES:
        return rest if owner == side and rest not in SHARED else ""
    return "" if name in WITHOUT else name


@cache
def wheel_inputs(side):
    """The rows of a wheelset's inputs that the wheel of this ``side`` has, by its own names."""
    return {own: row for row in INPUTS if (own := own_name(row.name, side))}


def unknown_wheel_input(name):
    """The TypeError on a keyword that no input of one wheel has."""
    if name in WITHOUT:
        return TypeError(f"one wheel has no input {name!r}: {WITHOUT[name]}")
    known = ", ".join(wheel_inputs("right"))
    return TypeError(f"there is no input {name!r}; inputs of one wheel are {known}")


def unknown_wheel_output(name, side, known):
    """The ValueError on a name that no output of the wheel of this ``side`` has; ``known`` are those of a
    wheelset."""
    own = [own_name(output, side) for output in known if output.startswith(f"{side}.")]
    rest = name.removeprefix(f"{side}.")
    hint = did_you_mean(rest, [rest] if rest in own else own) or "; .names of a result lists them"
    return ValueError(f"of has {name!r}; permitted are names of one wheel's outputs{hint}")


def checked_wheel(given):
    """The keyword parameters ``given`` for one wheel, with its contact mode; ValueError in a sentence where
    one has no meaning."""
    for name, value in given.items():
        if name in WITHOUT:
            raise ValueError(f"{name} cannot be given for one wheel: {WITHOUT[name]}")
        if name.startswith(LEFT) and name in PARAMETERS:
            raise ValueError(
                f"{name} cannot be given for one wheel, which has {name.removeprefix(LEFT)}, and side='left'"
            )
        if isinstance(value, (tuple, list)):
            raise ValueError(f"{name} is {value!r}; permitted with one wheel is one value")
    mode = given.get("contact_mode", MODE)
    if getattr(mode, "name", mode) != MODE:
        raise ValueError(
            f"contact_mode is {mode!r}; permitted with one wheel is {MODE!r}: in other modes a "
            "wheelset stands on both rails"
        )
    return {**given, "contact_mode": mode}
