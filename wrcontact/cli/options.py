"""Options from the one table of variables, in the units that people use.

``lateral_shift`` [m] becomes ``--lateral-shift-mm``; a command gets the values back in SI.  An option that is not given
leaves the package's own default.
"""

from functools import wraps
from inspect import Parameter, Signature, signature
from math import radians
from typing import Annotated, Optional

import typer

from ..interface.variables import INPUT, PARAMETER, REAL, UNITS, VARIABLES
from ..profiles import RAILS, WHEELS
from ..system import GEOMETRY as GEOMETRY_NAMES

#: From what people type to SI.  Division by a power of ten is exact to rounding, multiplication by 0.001 is not.
TO_SI = {"mm": lambda value: value / 1e3, "deg": radians, "kN": lambda value: value * 1e3, "MPa": lambda value: value * 1e6}
#: Options whose words the table has for the FMU only.
WORDS = {
    "wheel": f"Wheel profile: {', '.join(WHEELS)}, or the path of a file of points (docs/profiles.md)",
    "rail": f"Rail profile: {', '.join(RAILS)}, or the path of a file of points (docs/profiles.md)",
    "rail_inclination": "Inclination of the rail to the track centre, as 1:40 or as a slope, 0.025",
    "normal_force": "Force that presses each wheel on its rail, before load transfer; what of it is meant says --load",
    "load_transfer": "Share L of that force N moved from left to right: N (1 + L) on the right wheel, N (1 - L) on the left",
    "vertical_shift_input": "Height of the wheelset with --contact-mode compliant, positive down",
    "roll_input": "Roll of the wheelset with --contact-mode compliant, positive with the right wheel down",
    "contact_mode": "How wheel and rail meet: rigid, undeformed surfaces touch at equal gaps left and right; elastic, the "
                    "wheels sink in until each carries its load, which gives height and roll; compliant, height and roll "
                    "are --vertical-shift-mm and --roll-deg, and the loads follow",
    "load": "What --normal-force-kn prescribes: normal, the total over the patches of a wheel; vertical, the vertical "
            "component of their resultant",
    "separation": "How the undeformed distance of wheel and rail is measured: normal, along the normal of the contact "
                  "plane; vertical, at common lateral coordinate; equidistant, between points at equal arc length from the "
                  "contact; equidistant_chord, between nodes that circles step off from the contact",
    "lateral_curvature": "Curvature across the rail: adaptive, averaged over a window in proportion to the patch; smooth, "
                         "of circles fitted to the profiles over --curvature-reach-mm to either side; rough, change of the "
                         "profiles' angles over --curvature-step-mm",
    "curvature_step": "Arc length over which --lateral-curvature rough takes the change of angle",
    "curvature_reach": "Half the width over which --lateral-curvature smooth fits circles to the profiles",
}
RATIO = "rail_inclination"


def number(text):
    """The number that was typed."""
    try:
        return float(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is not a number") from None


def ratio(text):
    """The slope that ``1:40``, ``1/40`` or ``0.025`` means."""
    try:
        rise, _, run = str(text).replace("/", ":").partition(":")
        return float(rise) / float(run or 1)
    except (ValueError, ZeroDivisionError):
        raise typer.BadParameter(f"{text!r} is neither a ratio such as 1:40 nor a slope such as 0.025") from None


#: roll_guess is left out: it changes the cost of an answer, never the answer.
POSE = [v for v in VARIABLES if v.causality == INPUT and v.name != "roll_guess"]
LOAD = [v for v in POSE if v.name != "lateral_shift"]
SYSTEM = [v for v in VARIABLES if v.causality == PARAMETER]
#: Profiles, track and wheelset, without materials and methods.
GEOMETRY = [v for v in SYSTEM if (v.keyword or v.name) in ("wheel", "rail", *GEOMETRY_NAMES)]
PANELS = {INPUT: "Pose and load", PARAMETER: "Wheelset, track, material and methods"}


def takes(**groups):
    """Give a command the options of groups of variables.

    ``@takes(pose=POSE, system=SYSTEM)`` calls the command with ``pose`` and ``system``, dicts of the SI values given,
    under the names that :class:`~wrcontact.ContactSystem` and its ``evaluate`` have for them.
    """

    def decorate(command):
        @wraps(command)
        def with_options(**given):
            taken = {group: _values(variables, given) for group, variables in groups.items()}
            return command(**taken, **given)

        options = [_option(variable) for variables in groups.values() for variable in variables]
        own = [p.replace(kind=Parameter.KEYWORD_ONLY) for p in signature(command).parameters.values() if p.name not in groups]
        with_options.__signature__ = Signature(options + own)
        with_options.__annotations__ = {p.name: p.annotation for p in options + own}
        return with_options

    return decorate


def name_of(variable):
    """The name that Python has for a variable: ``wheel`` for the FMU's ``wheel_profile``."""
    return variable.keyword or variable.name


def option_of(variable):
    """The option of a variable: ``--nominal-radius-mm``; ``--roll-deg`` for ``roll_input``."""
    words = [name_of(variable).removesuffix("_input").replace("_", "-"), _display(variable).lower()]
    return "--" + "-".join(word for word in words if word)


def _display(variable):
    """The unit that people want to see, "" for numbers without one and for names."""
    return UNITS[variable.unit].display if variable.type == REAL else ""


def _option(variable):
    """The parameter of a command for a variable; None stands for the package's default."""
    unit = _display(variable)
    start = f"{variable.start * UNITS[variable.unit].display_factor:g}" if variable.type == REAL else variable.start
    words = WORDS.get(name_of(variable), variable.meaning) + (f", in {unit}" if unit else "") + f" (default: {start})"
    kind, reading = str, {"metavar": "NAME"}
    if variable.type == REAL:
        kind, reading = float, {"metavar": "NUMBER", "parser": ratio if name_of(variable) == RATIO else number}
    option = typer.Option(option_of(variable), help=words, show_default=False,
                          rich_help_panel=PANELS[variable.causality], **reading)
    return Parameter(name_of(variable), Parameter.KEYWORD_ONLY, default=None, annotation=Annotated[Optional[kind], option])


def _values(variables, given):
    """Take the values of ``variables`` out of ``given``, in SI, without those that were not given."""
    typed = {variable: given.pop(name_of(variable)) for variable in variables}
    return {name_of(variable): _in_si(variable, value) for variable, value in typed.items() if value is not None}


def _in_si(variable, value):
    return TO_SI.get(_display(variable), lambda same: same)(value)
