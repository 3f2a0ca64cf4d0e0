"""The status of a step, and the sentence that explains it; native FMUs get the table of sentences as C."""

import math
import re
from collections.abc import Iterable, Mapping
from enum import IntEnum
from typing import NamedTuple

from .interface.friction import FRICTION, FRICTION_LIMIT
from .interface.inputs import (
    DEFLECTIONS,
    INPUT_NAMES,
    INPUT_UNITS,
    INPUTS,
    LATERAL_LIMIT,
    RAIL_LIMIT,
    RAIL_ROLL_LIMIT,
    RAILS,
    ROLL_LIMIT,
    TIME_LIMIT,
    USUAL_LOAD,
    YAW_LIMIT,
)
from .kernel import layout
from .kernel.wheelset.input_checks import NO_FORCE
from .kernel.wheelset.residuals import DEEPEST
from .methods.numbers import unit_behind


class Status(IntEnum):
    """Outcome of a step; the FMU's ``status``."""

    VALID = layout.VALID
    UNLOADED = layout.UNLOADED  #: a wheel carries no load; geometry valid, its patch empty
    OFF_PROFILE = layout.OFF_PROFILE  #: contact beyond the profiles; no results
    NOT_CONVERGED = layout.NOT_CONVERGED  #: likewise
    INVALID_INPUT = layout.INVALID_INPUT  #: likewise
    BEYOND_ADHESION = layout.BEYOND_ADHESION  #: friction does not carry the axle torque; likewise

    def __str__(self):
        return str(int(self))  # as from Python 3.11 on


class Terms:
    """How a sentence names inputs and shows their values: names of Python and the FMUs, SI units."""

    def name(self, name):
        """The name of an input."""
        return name

    def value(self, name, value, limit=math.nan):
        """A value of an input with its unit, with as many digits as tell it from ``limit``."""
        return f"{distinct(value, limit)}{unit_behind(UNITS_BY_NAME[name])}"

    def length(self, value):
        """A length [m] with its unit."""
        return f"{value:g} m"


class _OneWheel(Terms):
    """The terms of one wheel, whose inputs belong to no side."""

    def name(self, name):
        return name.rpartition(".")[2]


#: The end of sentences on steps that leave the outputs as they are.
KEPT = "; the outputs keep their last valid values"
UNITS_BY_NAME = dict(zip(INPUT_NAMES, INPUT_UNITS))


def distinct(value, limit):
    """``value`` as text with six digits, or with as many as it needs to differ from ``limit``."""
    texts = (f"{value:.{digits}g}" for digits in range(6, 18))
    return next(
        (text for text in texts if abs(float(text)) != abs(limit) or abs(value) == abs(limit)), repr(value)
    )


class Sentence(NamedTuple):
    """The message on a status if a test of one input holds, in one contact mode or in all."""

    status: Status
    test: str  #: one of TESTS
    name: str  #: the input that is tested
    limit: float  #: of the test, and what the shown value has to differ from
    text: str  #: <name of an input>, [value with its unit], [input:value], {length in m}
    compliant: bool | None = None  #: None is every contact mode


#: Tests of an input against a limit.
TESTS = {
    "always": lambda value, limit: True,
    "infinite": lambda value, limit: not math.isfinite(value),
    "beyond": lambda value, limit: abs(value) > limit,
    "outside": lambda value, limit: not 0.0 <= value <= limit,
    "below": lambda value, limit: value < limit,
    "nonzero": lambda value, limit: value != 0.0,
}


def _beyond(status, name, limit, why="", compliant=None):
    """That an input exceeds the limit of its size."""
    text = f"<{name}> is [{name}]{why}; permitted is |<{name}>| <= [{name}:{limit!r}]"
    return Sentence(status, "beyond", name, limit, text, compliant)


#: The first one that holds is the message.
SENTENCES = (
    *(
        Sentence(
            Status.INVALID_INPUT,
            "infinite",
            name,
            math.nan,
            f"<{name}> is [{name}]; permitted are finite numbers",
        )
        for name in INPUT_NAMES
    ),
    *(_beyond(Status.INVALID_INPUT, row.name, row.maximum) for row in INPUTS if row.limited),
    *(
        Sentence(
            Status.INVALID_INPUT,
            "outside",
            row.name,
            FRICTION_LIMIT,
            f"<{row.name}> is [{row.name}]; permitted is 0 <= <{row.name}> <= "
            f"[{row.name}:{FRICTION_LIMIT!r}]",
        )
        for row in FRICTION
    ),
    Sentence(
        Status.INVALID_INPUT,
        "outside",
        "rail_time_step",
        TIME_LIMIT,
        "<rail_time_step> is [rail_time_step]; permitted is 0 <= <rail_time_step> <= "
        f"[rail_time_step:{TIME_LIMIT!r}]",
    ),
    Sentence(
        Status.INVALID_INPUT,
        "below",
        "normal_force",
        0.0,
        "<normal_force> is [normal_force]; permitted is <normal_force> >= [normal_force:0.0]",
    ),
    Sentence(
        Status.INVALID_INPUT,
        "always",
        "load_transfer",
        1.0,
        "<load_transfer> is [load_transfer]; permitted is -1 <= <load_transfer> <= 1",
    ),
    Sentence(
        Status.UNLOADED,
        "always",
        "vertical_shift_input",
        math.nan,
        "<vertical_shift_input> is [vertical_shift_input] at <roll_input> [roll_input], so a wheel is "
        "lifted and carries no load; its patch is empty (a larger <vertical_shift_input> lowers the "
        "wheelset)",
        True,
    ),
    *(
        Sentence(
            Status.UNLOADED,
            test,
            name,
            limit,
            f"<{name}> is [{name}], so a wheel carries no load; its patch is empty (a load needs "
            f"(1 - |<load_transfer>|) <normal_force> >= [normal_force:{NO_FORCE!r}])",
            False,
        )
        for test, name, limit in (("below", "normal_force", NO_FORCE), ("always", "load_transfer", 1.0))
    ),
    _beyond(Status.OFF_PROFILE, "lateral_shift", LATERAL_LIMIT, ", beyond the profiles"),
    _beyond(Status.OFF_PROFILE, "yaw", YAW_LIMIT, ", beyond the profiles"),
    *(
        _beyond(
            Status.OFF_PROFILE, row.name, RAIL_ROLL_LIMIT if row.name.endswith("rail_roll") else RAIL_LIMIT
        )
        for row in (*RAILS, *DEFLECTIONS)
    ),
    _beyond(Status.OFF_PROFILE, "roll_input", ROLL_LIMIT, compliant=True),
    Sentence(
        Status.OFF_PROFILE,
        "always",
        "vertical_shift_input",
        math.nan,
        "<vertical_shift_input> is [vertical_shift_input] and <roll_input> [roll_input] at "
        "<lateral_shift> [lateral_shift]: the contact leaves a profile, or a wheel is deeper in its "
        f"rail than {{{DEEPEST!r}}}",
        True,
    ),
    Sentence(
        Status.OFF_PROFILE,
        "outside",
        "normal_force",
        USUAL_LOAD[1],
        f"<normal_force> is [normal_force]; usual is at most [normal_force:{USUAL_LOAD[1]!r}]: it "
        "presses a wheel beyond the end of a profile, or deeper into its rail than "
        f"{{{DEEPEST!r}}}, at <lateral_shift> [lateral_shift] and <yaw> [yaw]",
        False,
    ),
    Sentence(
        Status.OFF_PROFILE,
        "always",
        "lateral_shift",
        math.nan,
        "<lateral_shift> is [lateral_shift] at <yaw> [yaw]: the smallest gap lies at the end of a "
        "profile, so there is no contact; or, in elastic contact, <normal_force> [normal_force] with "
        "<load_transfer> [load_transfer] presses a wheel deeper into its rail than "
        f"{{{DEEPEST!r}}}; permitted are poses with the contact inside both profiles",
        False,
    ),
    Sentence(
        Status.NOT_CONVERGED,
        "always",
        "lateral_shift",
        math.nan,
        "no solution at <lateral_shift> [lateral_shift], <yaw> [yaw], <normal_force> [normal_force], "
        "<load_transfer> [load_transfer] within the iteration limit; friction may jam a wheel "
        "that has a vertical load",
    ),
    *(
        Sentence(
            Status.BEYOND_ADHESION,
            test,
            name,
            math.nan,
            f"<{name}> is [{name}]: with their friction and their loads the wheels do not carry it, so they spin "
            "or slide",
        )
        for test, name in (
            ("nonzero", "axle_torque"),
            ("nonzero", "left.axle_torque"),
            ("always", "right.axle_torque"),
        )
    ),
)


#: Inputs that have to be zero on rails that change along the track, or on rollers, neither of which FMUs have: with the status 4,
#: if none of the sentences above but the last of that status holds.
CHANGING = tuple(
    Sentence(Status.INVALID_INPUT, "nonzero", name, math.nan, f"<{name}> is [{name}]; permitted {where} is 0")
    for endings, where in (
        (("rail_roll", "rail_roll_velocity"), "with a rail that changes along the track"),
        (("track_curvature",), "on a roller"),
    )
    for name in INPUT_NAMES
    if name.endswith(endings)
)

#: Sentences on calls that are refused, of the FMU that runs in Python and of native ones; ``%s`` is a name or a value.
REFUSALS = {
    "started": "initialisation is permitted once, with startTime and stopTime, after instantiation or a reset",
    "times": "startTime is %s s and stopTime %s s; permitted are a finite startTime and a stopTime not before it",
    "entered": "initialisation mode can be entered once, after instantiation or a reset",
    "not_entered": "initialisation mode can be left only after it was entered",
    "not_running": "only a running simulation can be terminated",
    "no_step_before": "the wheelset cannot step: it has not been initialised",
    "no_step_after": "the wheelset cannot step: it has been terminated",
    "step": "a step of %s s at %s s is not possible; permitted are finite times and sizes of 0 s or more",
    "past_stop": "a step of %s s at %s s ends after the stopTime %s s; permitted are steps up to it",
    "unknown": "value reference %lu does not exist; they run from %d to %d",
    "type": "%s is of type %s, not %s",
    "unread": "%s is an output and cannot be read before the initialisation",
    "terminated": "%s cannot be set: the simulation has been terminated",
    "output": "%s is an output and cannot be set",
    "null": "%s is a NULL pointer; permitted are texts",
    "fixed": "%s is fixed at %s after initialisation and cannot become %s",
    "other_state": "the saved state is not one of this version; the present state is kept",
    "damaged_state": "the saved state is damaged (its checksum differs); the present state is kept",
}


def explain(
    status: int,
    inputs: Iterable[float] | Mapping[str, float],
    compliant: bool | None = None,
    terms: Terms | None = None,
    held: bool = False,
) -> str:
    """One sentence on a non-zero ``status`` that names the variable, its value and the limit; "" for VALID.

    ``inputs`` are those of the step: ``state.inputs``, also of one wheel, or numbers in the order of
    wrcontact/interface/inputs.py.  ``compliant`` says whether the contact mode is compliant; None is what
    ``state.inputs`` know of it, and False for numbers.  ``terms`` say how names and values are written,
    ``held`` whether to add that outputs of a failed step keep their values, as those of a stepper and an FMU
    do.
    """
    if Status(status) == Status.VALID:
        return ""
    if compliant is None:
        compliant = getattr(inputs, "compliant", False)
    if isinstance(inputs, Mapping):
        if "normal_force" not in inputs:  # of one wheel, by its own names
            compliant, terms = True, terms or _OneWheel()
        inputs = [inputs.get(row.name, inputs.get(row.name.rpartition(".")[2], row.start)) for row in INPUTS]
    terms, given = terms or Terms(), dict(zip(INPUT_NAMES, map(float, inputs)))
    said = next(
        row
        for row in SENTENCES
        if row.status == status
        and row.compliant in (None, bool(compliant))
        and TESTS[row.test](given[row.name], row.limit)
    )
    if said.test == "always" and status == Status.INVALID_INPUT and abs(given["load_transfer"]) <= 1.0:
        said = next((row for row in CHANGING if TESTS[row.test](given[row.name], row.limit)), said)
    text = written(
        said.text,
        terms,
        lambda name: terms.value(name, given[name], said.limit if name == said.name else math.nan),
    )
    return text + (KEPT if held and status >= Status.OFF_PROFILE else "")


def written(text, terms, value):
    """The text of a :class:`Sentence` with names and lengths as ``terms`` has them, and with each
    ``value(name)``."""

    def put(found):
        name, shown, given, length = found.groups()
        if name:
            return terms.name(name)
        if length:
            return terms.length(float(length))
        return terms.value(shown, float(given)) if given else value(shown)

    return re.sub(r"<([a-z][\w.]*)>|\[([\w.]+)(?::([^]]+))?\]|{(.+?)}", put, text)
