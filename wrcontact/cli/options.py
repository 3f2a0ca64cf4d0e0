"""Command line options, made from the table of variables, in display units: ``lateral_shift`` [m] becomes
``--lateral-shift-mm``, and the command receives the value in SI.  An option that is not given leaves the
package's default.
"""

import re
from math import isnan, radians

import typer

from ..interface.parameters import GEOMETRY as GEOMETRY_NAMES
from ..interface.parameters import LEFT, PARAMETERS
from ..interface.variables import BOOLEAN, INPUT, PARAMETER, REAL, UNITS, VARIABLES
from ..methods.numbers import ALSO_RATIO, ratio_of
from ..methods.words import did_you_mean
from ..results.words import unit_name
from ..status import distinct
from .adding import adding, option
from .errors import Refused
from .groups import OF_KINDS, USUAL, group_of
from .typed import described, display_of, name_of, option_of

#: From display units to SI.  Division by a power of ten is correctly rounded; multiplication by 0.001 is not.
TO_SI = {
    "mm": lambda value: value / 1e3,
    "deg": radians,
    "kN": lambda value: value * 1e3,
    "MPa": lambda value: value * 1e6,
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
    """The slope of ``1:40``, ``1/40`` or ``0.025``; typer's BadParameter if it is none."""
    slope = ratio_of(text)
    if isnan(slope):
        raise typer.BadParameter(f"{text!r} is neither a ratio such as 1:40 nor a slope such as 0.025")
    return slope


#: Without roll_guess, which changes the cost of a result but never the result, and without switches.
POSE = [v for v in VARIABLES if v.causality == INPUT and v.type == REAL and v.name != "roll_guess"]
LOAD = [v for v in POSE if v.name != "lateral_shift"]
SYSTEM = [v for v in VARIABLES if v.causality == PARAMETER]
#: Profiles, track and wheelset, without materials and methods.
GEOMETRY = [
    v for v in SYSTEM if (v.keyword or v.name).removeprefix(LEFT) in ("wheel", "rail", *GEOMETRY_NAMES)
]


def takes(**groups):
    """Decorator that adds options for groups of variables to a command.

    ``@takes(pose=POSE, system=SYSTEM)`` calls the command with ``pose`` and ``system``, dicts of the SI
    values given, with the names of the arguments of :class:`~wrcontact.ContactSystem` and its ``evaluate``.
    """

    def fold(given):
        return {group: _values(variables, given) for group, variables in groups.items()} | given

    options = [_option(variable) for variables in groups.values() for variable in variables]
    return lambda command: adding(command, options, fold, groups)


def _unit(variable):
    """The unit of an option's value, which may be an SI unit; "" without one."""
    return unit_name(variable.unit) if variable.type == REAL else ""


def _option(variable):
    """The command's parameter for a variable; its default None means the package's default."""
    name, unit = name_of(variable), _unit(variable)
    row = PARAMETERS[name] if variable.causality == PARAMETER else None
    start = (
        f"{variable.start * UNITS[variable.unit].display_factor:g}"
        if variable.type == REAL
        else variable.start
    )
    if row and row.right:
        words = _words(PARAMETERS[row.right])
        words, start = f"Left side: {words[0].lower()}{words[1:]}", "as right"
    else:
        words = _words(row) if row else described(variable.description)
    words += (f" [{unit}]" if unit else "") + f" (default: {start})"
    kind, reading = str, {"metavar": "|".join(row.family.names()) if row and row.family else "NAME"}
    if variable.type == REAL:
        kind, reading = float, {"metavar": "NUMBER", "parser": ratio if name.endswith(RATIO) else number}
    if variable.type == BOOLEAN:
        kind, reading, start = bool, {}, "no"
    return option(
        name,
        kind,
        None,
        option_of(variable),
        help=words,
        show_default=False,
        hidden=name not in USUAL,
        rich_help_panel=group_of(name),
        **reading,
    )


def _words(row):
    """What the help says of a parameter, without unit and default."""
    if not row.family:
        also = ALSO_RATIO if row.number and row.number.ratio else ""
        return OF_KINDS.get(row.name) or described(row.meaning) + also
    methods = "; ".join(f"{method.name}: {method.words}" for method in row.family.methods)
    return described(f"{row.family.decides[0].upper()}{row.family.decides[1:]}. {methods}")


def _values(variables, given):
    """Remove the options of ``variables`` from ``given``; return those that were given, by Python name, in
    SI."""
    typed = {variable: given.pop(name_of(variable)) for variable in variables}
    return {
        name_of(variable): _checked(variable, value) for variable, value in typed.items() if value is not None
    }


def _checked(variable, value):
    """The value of an option in SI; Refused, in the option's name and unit, if it is not permitted."""
    found, flag = _in_si(variable, value), option_of(variable)
    if variable.causality != PARAMETER:  # an input's limits are those of a status
        return found
    family = PARAMETERS[name_of(variable)].family
    if family and value not in family.names():
        raise Refused(
            f"{flag} is {value!r}; permitted are {', '.join(map(repr, family.names()))}"
            f"{did_you_mean(value, family.names())}"
        )
    known = PARAMETERS[PARAMETERS[name_of(variable)].right or name_of(variable)].number
    if known is not None and not known.low <= found <= known.high:
        unit = UNITS[variable.unit]
        low, high = (limit * unit.display_factor for limit in (known.low, known.high))
        text = distinct(value, high if value > high else low)
        words = f"{flag} is {text}; permitted is {low:g} ... {high:g} {_unit(variable)}".rstrip()
        raise Refused(words + known.meant(value, unit.display_factor, _unit(variable)))
    return found


def _in_si(variable, value):
    return TO_SI.get(display_of(variable), lambda same: same)(value)
