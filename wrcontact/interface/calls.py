"""How a call gives inputs and parameters: values and signatures from the rows of the table."""

import re
from inspect import Parameter, Signature, signature
from numbers import Integral

import numpy as np

from ..methods.numbers import is_plain, unit_behind, warn_unusual
from ..methods.words import did_you_mean
from .index import KEYWORDS
from .inputs import INPUTS
from .parameters import GROUPS, LEFT, PARAMETERS

#: Places in the kernel's inputs of those that can be given without their names, and their keywords.
POSITIONAL = [place for place, row in enumerate(INPUTS) if row.positional]
NAMED = [INPUTS[place].keyword for place in POSITIONAL]
STARTS = [row.start for row in INPUTS]
START_ROW = memoryview(np.array(STARTS, dtype=float))
#: Inputs with a usual range, with their places; what an input is without being given lies within it.
USUAL = [(place, row, *row.usual) for place, row in enumerate(INPUTS) if row.usual is not None]
#: Types of a value that is one number, and needs no other check.
NUMBERS = {float, int, np.float64}


def write_inputs(row, arguments, keywords, warned):
    """Write the inputs of a call for one pose into ``row``, a memoryview of all inputs in the kernel's order; those
    that are not given get their start.  Warns as :func:`warn_of_inputs`.

    Raises
    ------
    TypeError, ValueError
        as :func:`given_inputs`, and where a value is not one number.
    """
    row[:] = START_ROW
    plain = not arguments  # the usual call has keywords alone, with numbers within their usual range
    for name, value in keywords.items():
        if name not in KEYWORDS or type(value) not in NUMBERS:
            plain = False
            break
        row[KEYWORDS[name]] = value
    for place, _, low, high in USUAL:
        plain = plain and low <= row[place] <= high
    if plain:
        return
    given = given_inputs(arguments, keywords)
    try:
        for place, value in given.items():
            row[place] = value if type(value) in NUMBERS else single_number(value)
    except (TypeError, ValueError):
        raise wrong_input(input_values(given), array=False) from None
    warn_of_inputs(given, warned)


def given_inputs(arguments, keywords):
    """The values that a call gives by the places of their inputs in the kernel's order: {place: value}."""
    given = {}
    for place, value in zip(POSITIONAL, arguments):
        given[place] = value if type(value) in NUMBERS else checked_input(place, value)
    for name, value in keywords.items():
        place = KEYWORDS.get(name)
        if place is None:
            raise unknown_input(name)
        given[place] = value if type(value) in NUMBERS else checked_input(place, value)
    if len(arguments) > len(NAMED):
        raise TypeError(
            f"{len(arguments)} inputs have no name; permitted are {', '.join(NAMED)}, and others by name"
        )
    if len(given) < len(arguments) + len(keywords):
        twice = min(keywords.keys() & set(NAMED[: len(arguments)]))
        raise TypeError(
            f"the input {twice} is given twice, by its place and by its name; permitted is one of the two"
        )
    return given


def input_values(given):
    """The value of every input in the kernel's order, with those ``given`` by their places."""
    values = STARTS.copy()
    for place, value in given.items():
        values[place] = value
    return values


def single_number(value):
    """A number of another type than NUMBERS as a float; TypeError or ValueError if it is none, or an array."""
    if np.ndim(value):
        raise ValueError("an array")
    return float(value)


def unknown_input(name):
    """The TypeError on a keyword that no input has."""
    hint = did_you_mean(name, KEYWORDS) or f"; inputs are {', '.join(KEYWORDS)}"
    if name in PARAMETERS:
        hint = f"; {name} is a parameter of ContactSystem"
    return TypeError(f"there is no input {name!r}{hint}")


def unknown_parameter(name):
    """The TypeError on a keyword that no parameter has."""
    hint = did_you_mean(name, [*PARAMETERS, *GROUPS])
    if name in KEYWORDS:
        hint = f"; {name} is an input of evaluate"
    own = name.removesuffix("_profile")  # wheel_profile, left_rail_profile, ... of FMUs
    if own != name and own.removeprefix(LEFT) in ("wheel", "rail"):
        hint = f"; in Python it is {own}"
    return TypeError(f"ContactSystem has no parameter {name!r}{hint}")


def checked_input(place, value):
    """The ``value`` of an input, unless it has texts, truth values or None, which numpy takes for numbers:
    these raise a ValueError, in a sentence."""
    row = INPUTS[place]
    try:
        array = np.asarray(value)
    except ValueError:  # rows of different lengths
        raise ValueError(f"{row.keyword} is {value!r}; permitted are numbers{_behind(row)}") from None
    kind = array.dtype.kind
    if kind in "fiu" or kind == "b" and row.switch:
        return value
    wrong = [one for one in array.ravel().tolist() if kind != "O" or one is None or not is_plain(one)]
    if not wrong:
        return value
    if array.ndim:
        raise ValueError(f"{row.keyword} has {wrong[0]!r}; permitted are numbers{_behind(row)}")
    permitted = "True or False" if row.switch else f"a number{_behind(row)}"
    raise ValueError(f"{row.keyword} is {wrong[0]!r}; permitted is {permitted}")


def _behind(row):
    """The unit of an input behind the word number."""
    return "" if row.unit == "1" else f", in {row.unit}"


def warn_of_inputs(given, warned):
    """Give an UnusualValueWarning for every input among those ``given``, numbers or arrays by their places,
    whose largest number is above 0 and outside its usual range; once for each name in the set ``warned``."""
    for place, row, low, high in USUAL:
        value = given.get(place, 0.0)
        if type(value) not in NUMBERS:
            value = np.asarray(value, dtype=float)
            value = np.max(value, initial=0.0, where=np.isfinite(value))
        if value > 0.0 and not low <= value <= high and row.name not in warned:
            if warn_unusual(row.name, value, row.unit, row.usual):
                warned.add(row.name)


def wrong_input(values, array):
    """The ValueError on input ``values`` that are not numbers or, with ``array``, arrays (n,) of numbers that
    fit together."""
    kind = "a number or an array (n,) of numbers" if array else "one number"
    for row, value in zip(INPUTS, values):
        try:
            numbers = np.asarray(value, dtype=float)
        except (TypeError, ValueError):
            return ValueError(f"{row.keyword} is {value!r}; permitted is {kind}{_behind(row)}")
        if numbers.ndim > array:
            return ValueError(
                f"{row.keyword} has the shape {numbers.shape}; permitted is {kind}"
                f"{'' if array else '; evaluate_many takes arrays'}"
            )
    shapes = ", ".join(
        f"{row.keyword} {np.shape(value)}" for row, value in zip(INPUTS, values) if np.ndim(value)
    )
    return ValueError(f"the inputs have the shapes {shapes}; permitted are arrays of one length")


def check_count(name, count):
    """Refuse a number of processes or threads that is no whole number from 1 on, with a ValueError."""
    if isinstance(count, bool) or not isinstance(count, Integral) or count < 1:
        raise ValueError(f"{name} is {count!r}; permitted is a whole number from 1 on")


def describe_inputs(function):
    """Give ``evaluate`` or ``evaluate_many`` its signature, and the words of the inputs."""
    found = signature(function).parameters
    rows = [
        _parameter(row.keyword, row.start, row.positional)
        for row in sorted(INPUTS, key=lambda row: not row.positional)
    ]
    others = ("penetration", "side", "outputs", "processes", "threads")
    named = [_untyped(found[name]) for name in others if name in found]
    function.__signature__ = Signature([found["self"], *rows, *named])
    _fill(function, "{inputs}", [f"{row.keyword} : {row.words} [{row.unit}]." for row in INPUTS])


def describe_wheel_inputs(function, rows):
    """The same for one wheel, whose inputs are ``rows`` by their names."""
    found = signature(function).parameters
    named = [_parameter(name, row.start, False) for name, row in rows.items()]
    function.__signature__ = Signature([found["self"], *named, _untyped(found["outputs"])])
    _fill(function, "{inputs}", [f"{name} : {row.meaning} [{row.unit}]." for name, row in rows.items()])


def describe_parameters(system):
    """Give :class:`~wrcontact.ContactSystem` its signature, with every keyword, and the words of the
    parameters."""
    names = [_parameter(row.name, row.default, row.name in ("wheel", "rail")) for row in PARAMETERS.values()]
    groups = [_parameter(name, None, False) for name in GROUPS]
    system.__signature__ = Signature(names[:2] + groups + names[2:])
    _fill(system, "{parameters}", [line for row in list(PARAMETERS.values())[2:] for line in _lines(row)])


def _untyped(parameter):
    """A parameter without its type, as those that follow from rows are shown."""
    return parameter.replace(annotation=Parameter.empty)


def _parameter(name, default, positional):
    """One parameter of a signature."""
    kind = Parameter.POSITIONAL_OR_KEYWORD if positional else Parameter.KEYWORD_ONLY
    return Parameter(name, kind, default=default)


def _lines(row):
    """What a docstring says about one parameter."""
    if row.right:
        yield f"{row.name} : {row.right} on the left side; None, the default, is that on the right."
        return
    if row.family is None:
        known = row.number
        if known.switch:
            yield f"{row.name} : {row.meaning}."
            return
        yield f"{row.name} : {row.meaning}, {known.low:g} ... {known.high:g}{unit_behind(known.unit)}."
        return
    yield f"{row.name} : {row.family.decides}:"
    for method in row.family.methods:
        yield f"    {method.name!r}, :class:`~wrcontact.{method.__name__}` : {method.words}"


def _fill(described, place, lines):
    """Write ``lines`` at ``place`` of a docstring, as far indented as it is; ``python -OO`` drops docstrings."""
    described.__doc__ = re.sub(
        rf"^( *){re.escape(place)}$",
        lambda found: "\n".join(found[1] + line for line in lines),
        described.__doc__ or "",
        flags=re.MULTILINE,
    )
