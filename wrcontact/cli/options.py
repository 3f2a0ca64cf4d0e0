"""Command line options, and sentences in their names and units.

They are made from the table of variables, in display units: ``lateral_shift`` [m] becomes
``--lateral-shift-mm``, and the command receives the value in SI.  An option that is not given leaves the
package's default.  Others, such as ``--rail-mirror-y``, tell how a file of points is read.
"""

import re
from functools import wraps
from inspect import Parameter, Signature, signature
from math import radians
from typing import Annotated

import typer

from ..interface.parameters import GEOMETRY as GEOMETRY_NAMES
from ..interface.parameters import LEFT, PARAMETERS
from ..interface.variables import INPUT, PARAMETER, REAL, UNITS, VARIABLES
from ..methods.numbers import UnusualValueWarning
from ..profiles import RAILS, WHEELS
from ..profiles.options import ENDINGS, ProfileFile, parsed
from ..profiles.options import WORDS as FILE_WORDS
from ..status import Terms, distinct
from .door import Refused, sentences

#: From display units to SI.  Division by a power of ten is correctly rounded; multiplication by 0.001 is not.
TO_SI = {"mm": lambda value: value / 1e3, "deg": radians, "kN": lambda value: value * 1e3,
         "MPa": lambda value: value * 1e6}
#: Help texts that differ from those of the FMU.
WORDS = {
    "wheel": f"Wheel profile: {', '.join(WHEELS)}, or the path of a file of points (docs/profiles.md)",
    "rail": f"Rail profile: {', '.join(RAILS)}, or the path of a file of points (docs/profiles.md)",
    "rail_inclination": "Inclination of the rails towards the track centre, as a ratio, 1:40, or a slope, "
                        "0.025",
    "normal_force": "Load per wheel before load transfer; --load says whether it is the normal or the "
                    "vertical force",
    "load_transfer": "Share L of the load N moved from the left to the right wheel: N (1 + L) right, N (1 - "
                     "L) left",
    "vertical_shift_input": "Height of the wheelset with --contact-mode compliant, positive down",
    "roll_input": "Roll of the wheelset with --contact-mode compliant, positive with the right wheel down",
    "contact_mode": "How wheel and rail meet. rigid: the undeformed surfaces touch; elastic: the wheels "
                    "approach the rails until each carries its load, which gives height and roll; compliant: "
                    "--vertical-shift-mm and --roll-deg give height and roll, and the loads follow",
    "load": "What --normal-force-kn is. normal: the sum over the patches of a wheel; vertical: the vertical "
            "component of their resultant",
    "separation": "How the undeformed distance of wheel and rail is measured. normal: along the normal of "
                  "the contact plane; vertical: at equal lateral coordinates; equidistant: between points at "
                  "equal arc lengths from the contact; equidistant_chord: between nodes at equal chord steps "
                  "from the contact",
    "lateral_curvature": "Curvature across the rail. adaptive: averaged over a window in proportion to the "
                         "patch; smooth: of circles fitted to the profiles over --curvature-reach-mm on "
                         "either side; rough: change of the profile angles over --curvature-step-mm",
    "curvature_step": "Arc length over which --lateral-curvature rough takes the change of the profile angle",
    "curvature_reach": "Half the width over which --lateral-curvature smooth fits circles to the profiles",
}
RATIO = "rail_inclination"


def number(text):
    """``text`` as a float; typer's BadParameter if it is not a number."""
    try:
        return float(text)
    except ValueError:
        comma = ", permitted is a point before the decimals" if re.fullmatch(r"\s*-?\d+,\d*\s*", text) else ""
        raise typer.BadParameter(f"{text!r} is not a number{comma}") from None


def ratio(text):
    """The slope of ``1:40``, ``1/40`` or ``0.025``."""
    try:
        rise, _, run = str(text).replace("/", ":").partition(":")
        return float(rise) / float(run or 1)
    except (ValueError, ZeroDivisionError):
        raise typer.BadParameter(f"{text!r} is neither a ratio such as 1:40 nor a slope such as "
                                 "0.025") from None


#: Without roll_guess, which changes the cost of a result but never the result, and without switches.
POSE = [v for v in VARIABLES if v.causality == INPUT and v.type == REAL and v.name != "roll_guess"]
LOAD = [v for v in POSE if v.name != "lateral_shift"]
SYSTEM = [v for v in VARIABLES if v.causality == PARAMETER]
#: Profiles, track and wheelset, without materials and methods.
GEOMETRY = [v for v in SYSTEM
            if (v.keyword or v.name).removeprefix(LEFT) in ("wheel", "rail", *GEOMETRY_NAMES)]
PANELS = {INPUT: "Pose and load", PARAMETER: "Wheelset, track, material and methods"}


def takes(**groups):
    """Decorator that adds options for groups of variables to a command.

    ``@takes(pose=POSE, system=SYSTEM)`` calls the command with ``pose`` and ``system``, dicts of the SI
    values given, with the names of the arguments of :class:`~wrcontact.ContactSystem` and its ``evaluate``.
    """

    def decorate(command):
        @wraps(command)
        def with_options(**given):
            taken = {group: _values(variables, given) for group, variables in groups.items()}
            return command(**taken, **given)

        options = [_option(variable) for variables in groups.values() for variable in variables]
        own = [p.replace(kind=Parameter.KEYWORD_ONLY) for p in signature(command).parameters.values()
               if p.name not in groups]
        with_options.__signature__ = Signature(options + own)
        with_options.__annotations__ = {p.name: p.annotation for p in options + own}
        return with_options

    return decorate


def name_of(variable):
    """The Python name of a variable: ``wheel`` for the FMU's ``wheel_profile``."""
    return variable.keyword or variable.name.replace(".", "_")


def option_of(variable):
    """The option of a variable, such as ``--nominal-radius-mm``; ``--roll-deg`` for ``roll_input``."""
    words = [name_of(variable).removesuffix("_input").replace("_", "-"), _display(variable).lower()]
    return "--" + "-".join(word for word in words if word)


def _display(variable):
    """The display unit of a variable; "" for names and numbers without a unit."""
    return UNITS[variable.unit].display if variable.type == REAL else ""


def _option(variable):
    """The command's parameter for a variable; its default None means the package's default."""
    unit = _display(variable)
    start = (f"{variable.start * UNITS[variable.unit].display_factor:g}" if variable.type == REAL
             else variable.start)
    right = PARAMETERS[name_of(variable)].right if variable.causality == PARAMETER else ""
    if right:
        words, start = (f"{WORDS.get(right, right.replace('_', ' ').capitalize())}, on the left side",
                        "as right")
    else:
        words = WORDS.get(name_of(variable), variable.description)
    words += (f", in {unit}" if unit else "") + f" (default: {start})"
    kind, reading = str, {"metavar": "NAME"}
    if variable.type == REAL:
        kind, reading = float, {"metavar": "NUMBER", "parser": ratio if name_of(variable).endswith(RATIO)
                                else number}
    option = typer.Option(option_of(variable), help=words, show_default=False,
                          rich_help_panel=PANELS[variable.causality], **reading)
    return Parameter(name_of(variable), Parameter.KEYWORD_ONLY, default=None,
                     annotation=Annotated[kind | None, option])


def _values(variables, given):
    """Remove the options of ``variables`` from ``given``; return those that were given, by Python name, in
    SI."""
    typed = {variable: given.pop(name_of(variable)) for variable in variables}
    return {name_of(variable): _checked(variable, value) for variable, value in typed.items()
            if value is not None}


def _checked(variable, value):
    """The value of an option in SI; Refused, in the option's name and unit, if it is not permitted."""
    found, option = _in_si(variable, value), option_of(variable)
    if variable.causality != PARAMETER:         # an input's limits are those of a status
        return found
    family = PARAMETERS[name_of(variable)].family
    if family and value not in family.names():
        raise Refused(f"{option} is {value!r}; permitted are {', '.join(map(repr, family.names()))}")
    known = PARAMETERS[PARAMETERS[name_of(variable)].right or name_of(variable)].number
    if known is not None and not known.low <= found <= known.high:
        unit = UNITS[variable.unit]
        low, high = (limit * unit.display_factor for limit in (known.low, known.high))
        text = distinct(value, high if value > high else low)
        raise Refused(f"{option} is {text}; permitted is {low:g} ... {high:g} {unit.display}".rstrip())
    return found


def _in_si(variable, value):
    return TO_SI.get(_display(variable), lambda same: same)(value)


# --- how files of points are read ---------------------------------------------------------------------------

KINDS = ("wheel", "rail")
FILE_PANEL = "Files of profiles"


def reads_files(command):
    """Decorator that adds these options to a command with ``--wheel`` and ``--rail``; the command receives a
    :class:`~wrcontact.ProfileFile` if one of them is given."""

    @wraps(command)
    def with_options(**given):
        for kind in KINDS:
            chosen = {name: given.pop(f"{kind}_{name}") for name in _names(kind)}
            chosen = {name: value for name, value in chosen.items() if value is not None}
            if chosen and given[kind] is None:
                name = _file_option_name(kind, next(iter(chosen)))
                raise Refused(f"{name} is given; it is permitted only with --{kind} FILE")
            if chosen:
                with sentences():
                    given[kind] = ProfileFile(given[kind], **chosen)
        return command(**given)

    options = [_file_option(kind, name) for kind in KINDS for name in _names(kind)]
    own = list(signature(command).parameters.values())
    with_options.__signature__ = Signature(own + options)
    with_options.__annotations__ = {p.name: p.annotation for p in own + options}
    return with_options


def _names(kind):
    """The options of a ``kind`` of profile; a wheel has no inclination."""
    return [name for name in ENDINGS if kind == "rail" or name != "file_inclination"]


def _file_option_name(kind, name):
    return f"--{kind}-{ENDINGS[name]}"


def _file_option(kind, name):
    """The command's parameter for one option; None if it is not given."""
    words = f"{kind.capitalize()}: {FILE_WORDS[name][0].lower()}{FILE_WORDS[name][1:]}"
    flags, reading, value = _file_option_name(kind, name), {}, str
    if name.startswith("mirror"):
        flags, value = f"{flags}/--no-{flags[2:]}", bool
    elif name == "select":
        reading = {"metavar": "NUMBER|NAME", "parser": lambda text: int(text) if text.isdecimal() else text}
    else:
        reading = {"metavar": {"shift": "Y,Z"}.get(name, "NUMBER"), "parser": _parser(name)}
    option = typer.Option(flags, help=words, show_default=False, rich_help_panel=FILE_PANEL, **reading)
    return Parameter(f"{kind}_{name}", Parameter.KEYWORD_ONLY, default=None,
                     annotation=Annotated[value | None, option])


def _parser(name):
    def parse(text):
        try:
            return parsed(name, text)
        except ValueError as wrong:
            raise typer.BadParameter(str(wrong)) from None

    return parse


# --- sentences in the names and units that the user typed ---------------------------------------------------

INPUTS = {v.name: v for v in VARIABLES if v.causality == INPUT}
OPTIONS = {v.keyword: option_of(v) for v in VARIABLES if v.keyword}


class Typed(Terms):
    """Options such as ``--lateral-shift-mm``, and values in display units; ``aside`` has other names for
    inputs that the command has no option for."""

    def __init__(self, **aside):
        self.aside = aside

    def name(self, name):
        return self.aside.get(name) or option_of(INPUTS[name])

    def value(self, name, value, limit=float("nan")):
        unit = UNITS[INPUTS[name].unit]
        text = distinct(value * unit.display_factor, limit * unit.display_factor)
        return f"{text} {unit.display}" if unit.display else text

    def length(self, value):
        return f"{value * 1e3:g} mm"


#: In a sweep the lateral shift is not an option of its own.
SWEEP = Typed(lateral_shift="lateral shift")


def typed(sentence):
    """A sentence of :class:`~wrcontact.ContactSystem` with options in place of its keywords."""
    for keyword, option in OPTIONS.items():
        first = "^" if keyword in ("wheel", "rail", "left_wheel", "left_rail", "load") else r"\b(?<![-'])"
        if keyword in PARAMETERS:
            sentence = re.sub(rf"{first}{keyword}\b(?= is |[^\w'-]|$)", option, sentence)
    return sentence


def remark_words(remark):
    """The text of a warning, with options and display units in place of keywords and SI."""
    if not isinstance(remark, UnusualValueWarning):
        return str(remark)
    unit = UNITS[remark.unit]
    value, low, high = (f"{number * unit.display_factor:g}" for number in (remark.value, *remark.usual))
    behind = f" {unit.display}" if unit.display else ""
    option = OPTIONS.get(remark.name) or option_of(INPUTS[remark.name])
    return f"{option} is {value}{behind}; usual is {low} ... {high}{behind}. It is used as it is."
