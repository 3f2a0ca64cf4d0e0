"""Rates along several directions at once, in the C of the differentiated kernel.

Pyccel translates functions that carry one rate beside each value.  Here the type of every rate becomes
``lanes`` (native/lanes.h): as many rates as there are directions in one pass, with which C computes as with
numbers.  A rate is what differentiate has called ``..._t``, the second of two results of the same value, and
whatever is assigned from a rate.
"""

import itertools
import re

from .modules import Refused

#: Rates that are asked for something: no rate is left of them.
ASKED = re.compile(r"\bderivative_rates__(nonzero|common_rate)\(")
NAME = r"[A-Za-z_]\w*"
RATE_ARRAYS = ("work_t", "place_t")


def parameter_kinds(prototypes):
    """Of every function whether each of its parameters is a rate, from the ``prototypes`` of all (text)."""
    found = {f"derivative_rates__{name}": [True] for name in ("nonzero", "common_rate")}
    for name, text in re.findall(rf"^static .* \*?({NAME})\((.*)\);$", prototypes, re.MULTILINE):
        found[name] = [is_rate for _, _, is_rate in parameters(text)]
    return found


def parameters(text):
    """(type, name, whether it is a rate) of the parameters in a prototype, which may be in lanes itself."""
    found, results = [], 0
    for part in text.split(", "):
        kind, name = part.rsplit(" ", 1)
        results += kind in ("double*", "lanes*")
        is_rate = results % 2 == 0 if kind == "double*" else kind == "double" and name.endswith("_t")
        is_rate = is_rate or kind in ("lanes", "lanes*")
        found.append((kind, name, is_rate))
    return found


def in_lanes(text, kinds):
    """The C ``text`` of prototypes or functions with rates in lanes; ``kinds`` is that of
    :func:`parameter_kinds`."""
    parts = re.split(r"(^static [^\n]*\)\n\{\n.*?^\})", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(
        function_in_lanes(part, kinds)
        if part.startswith("static ") and "\n{\n" in part
        else re.sub(r"^(static .* \*?\w+\()(.*)(\);)$", prototype_in_lanes, part, flags=re.MULTILINE)
        for part in parts
    )


def prototype_in_lanes(match):
    """One prototype, or the head of a function, with the types of its rates."""
    typed = []
    for kind, name, is_rate in parameters(match[2]):
        kind = "array_lanes_1d" if kind == "array_double_1d" and name in RATE_ARRAYS else kind
        typed.append(f"{kind.replace('double', 'lanes') if is_rate else kind} {name}")
    return f"{match[1]}{', '.join(typed)}{match[3]}"


def function_in_lanes(text, kinds):
    """One function."""
    head, body = text.split("\n{\n", 1)
    opened = re.fullmatch(r"(static .* \*?\w+\()(.*)(\))", head)
    rates = {name for _, name, is_rate in parameters(opened[2]) if is_rate}
    for array in RATE_ARRAYS:
        body = body.replace(f"cspan_at(&{array}, ", f"lanes_at(&{array}, ")
    lines = body.split("\n")
    declared = dict(
        found.group(1, 0) for found in map(re.compile(rf" +double ({NAME});").fullmatch, lines) if found
    )
    known = {name for _, name, _ in parameters(opened[2])} | declared.keys()
    rates |= {name for name in declared if name.endswith("_t") and name[:-2] in known}
    before = -1
    while before != len(rates):
        before = len(rates)
        for line in lines:
            rates |= {name for name in assigned_rates(line, rates, kinds) if name in declared}
    numbers = itertools.count(1)
    changed = [line for statement in lines for line in statement_in_lanes(statement, rates, kinds, numbers)]
    changed = [
        line.replace("double", "lanes")
        if line in {declared[name] for name in rates & declared.keys()}
        else line
        for line in changed
    ]
    return prototype_in_lanes(opened) + "\n{\n" + "\n".join(changed)


def assigned_rates(line, rates, kinds):
    """Names that a statement gives rates to."""
    found = re.fullmatch(rf" +({NAME}) = (.*);", line)
    if found and has_rate(found[2], rates):
        yield found[1]
    for name, arguments in calls(line, kinds):
        yield from (
            argument[1:]
            for argument, is_rate in zip(arguments, kinds[name])
            if is_rate and argument.startswith("&")
        )


def statement_in_lanes(line, rates, kinds, numbers):
    """The lines of one statement: a rate is assigned lane by lane, and a number that stands for a rate is the
    same along all directions.  ``numbers`` count the names that sums of rates get as arguments."""
    space, before = re.match(" *", line)[0], []
    for name, arguments in calls(line, kinds):
        own = []
        for argument, is_rate in zip(arguments, kinds[name]):
            if not is_rate or argument.startswith("&") or is_place(argument, rates):
                own.append(argument)
            elif has_rate(argument, rates):
                own.append(f"rates_{next(numbers)}")
                before += [
                    f"{space}lanes {own[-1]};",
                    f"{space}EACH_LANE each({own[-1]}) = {by_lane(argument, rates)};",
                ]
            else:
                own.append(f"all_lanes({argument})")
        line = line.replace(f"{name}({', '.join(arguments)})", f"{name}({', '.join(own)})")
    found = re.fullmatch(r" +(.*?) = (.*);", line)
    if found and has_rate(found[1], rates):
        line = (
            f"{space}EACH_LANE {by_lane(found[1], rates)} = {by_lane(found[2], rates)};"
            if has_rate(found[2], rates)
            else f"{space}{found[1]} = all_lanes({found[2]});"
        )
    return [*before, line]


def is_place(expression, rates):
    """Whether a C expression names one rate."""
    found = re.match(r"\(\*lanes_at\(", expression)
    return (
        expression in rates
        or re.fullmatch(rf"\(\*({NAME})\)", expression)
        and expression[2:-1] in rates
        or found
        and closed_at(expression, 1) == len(expression)
    )


def by_lane(expression, rates):
    """A C expression of rates for one of the directions."""
    parts, place = [], 0
    for found in re.finditer(rf"\(\*lanes_at\(|\(\*({NAME})\)|\b({NAME})\b", expression):
        if found.start() < place:
            continue
        name = found[1] or found[2]
        if name and name not in rates:
            continue
        stop = found.end() if name else closed_at(expression, found.start() + 1)
        parts += [expression[place : found.start()], f"each({expression[found.start() : stop]})"]
        place = stop
    return "".join([*parts, expression[place:]])


def has_rate(expression, rates):
    """Whether a C expression is a rate."""
    for asked in list(ASKED.finditer(expression)):
        inside = closed_at(expression, asked.end())
        expression = expression.replace(expression[asked.start() : inside], "0")
    return "lanes_at(" in expression or any(name in rates for name in re.findall(rf"\b{NAME}\b", expression))


def closed_at(text, start):
    """The place behind the bracket that closes the one before ``start``."""
    depth = 1
    for place in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    raise Refused(f"a bracket is not closed: {text}")


def calls(line, kinds):
    """(name, arguments) of the calls in a statement of functions with rates."""
    for found in re.finditer(rf"\b({NAME})\(", line):
        if found[1] in kinds and any(kinds[found[1]]):
            yield found[1], split_arguments(line[found.end() : closed_at(line, found.end()) - 1])


def split_arguments(text):
    """The arguments of a call."""
    found, depth, start = [], 0, 0
    for place, letter in enumerate(text):
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            found.append(text[start:place])
            start = place + 2
    return [*found, text[start:]]
