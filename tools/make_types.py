"""Write the types that editors and type checkers read, wrcontact/**/*.pyi: ``python tools/make_types.py``.

The files in tools/types are the parts that are written by hand.  A line there that begins with ``#:`` stands
for what follows from the tables of inputs, outputs and parameters (wrcontact/interface).
"""

import re
import sys
from pathlib import Path
from textwrap import indent

import numpy as np

import wrcontact
from wrcontact import methods
from wrcontact.interface import one_wheel
from wrcontact.interface.inputs import INPUTS
from wrcontact.interface.parameters import GROUPS, LEFT, PARAMETERS, SIDED
from wrcontact.methods.own import STAND_INS
from wrcontact.results.outlines import Outline
from wrcontact.results.views import View

ROOT = Path(__file__).resolve().parent.parent
TEMPLATES = ROOT / "tools" / "types"
#: Where each of them goes, in wrcontact.
PLACES = {
    "__init__": "__init__.pyi",
    "state": "state.pyi",
    "system": "system.pyi",
    "wheel": "wheel.pyi",
    "stepper": "stepper.pyi",
    "results_inputs": "results/inputs.pyi",
    "results_outlines": "results/outlines.pyi",
    "results_views": "results/views.pyi",
}
NOTE = "# Written by tools/make_types.py; do not edit.\n"
PROFILES = ("wheel", "rail")
#: A result with every property, and its parts by their classes.
STATE = wrcontact.ContactSystem(wear_outputs=True).evaluate(3e-3)
RIGHT = STATE.right
SAMPLES = {
    type(part).__name__: part
    for part in (
        STATE,
        STATE.normal,
        RIGHT,
        RIGHT.contact,
        RIGHT.normal,
        RIGHT.force,
        RIGHT.patches[0],
        RIGHT.patches[0].creepage,
        RIGHT.patches[0].tangential,
        RIGHT.strips[0],
        STATE.inputs,
    )
}
SAMPLES["Outline"] = RIGHT.outline


def properties(kind, written):
    """Lines of the properties of a class of results that are not ``written`` by hand."""
    sample = SAMPLES[kind]
    owner = Outline if kind == "Outline" else type(sample)
    for name in dir(owner):
        found = getattr(owner, name)
        if (
            name.startswith("_")
            or not isinstance(found, property)
            or name in written
            or any(name in vars(base) for base in owner.__mro__[1:])
        ):
            continue
        words = (found.__doc__ or "").strip().splitlines()
        value = getattr(sample, name)
        typed = "Any" if kind == "Inputs" else "_Array" if isinstance(value, np.ndarray) else "_N"
        if isinstance(value, View):
            typed = f"{type(value).__name__}[_N]"
        yield "@property"
        yield f"def {name}(self) -> {typed}:"
        yield from indent(
            "\n".join(['"""' + words[0], *(line.strip() for line in words[1:])]) + '"""', "    "
        ).splitlines()


def parameter_type(row, single=False):
    """The type of one keyword of ContactSystem."""
    number = row.number or (PARAMETERS[row.right].number if row.right else None)
    if row.right in PROFILES or row.name in PROFILES:
        typed = "_OneProfile"
    elif row.family:
        names = ", ".join(f'"{name}"' for name in row.family.names())
        typed = f"Literal[{names}] | {row.family.methods[0].__mro__[1].__name__}"
        typed += " | Callable[..., Any]" if row.name in STAND_INS else ""
    else:
        typed = "bool" if number.switch else "int" if number.whole else "float"
        typed += " | str" if number.ratio else ""
    if row.name in SIDED and not single:
        typed += f" | tuple[{typed}, {typed}]"
    return typed + (" | None" if row.default is None else "")


def _shown(default):
    """A default as it is written."""
    return f'"{default}"' if isinstance(default, str) else repr(default)


def parameters(single=False):
    """Lines of the keywords of ContactSystem, or of one wheel."""
    rows = [
        row
        for row in PARAMETERS.values()
        if not single or row.name not in one_wheel.WITHOUT and not row.name.startswith(LEFT)
    ]
    for row in rows[:2]:
        yield f"{row.name}: {parameter_type(row, single)} = {_shown(row.default)},"
    yield "*,"
    if single:
        yield 'side: Literal["left", "right"] = "right",'
    for name, kind in GROUPS.items():
        yield f"{name}: {kind.__name__} | None = None,"
    for row in rows[2:]:
        default = one_wheel.MODE if single and row.name == "contact_mode" else row.default
        yield f"{row.name}: {parameter_type(row, single)} = {_shown(default)},"


def inputs(typed):
    """Lines of the inputs of evaluate, those without a name first."""
    first = [row for row in INPUTS if row.positional]
    yield from (_input(row.keyword, row, typed) for row in first)
    yield "*,"
    yield from (_input(row.keyword, row, typed) for row in INPUTS if not row.positional)


def _input(name, row, typed):
    return f"{name}: {typed} = {row.start!r},"


def exports():
    """Lines of what ``import wrcontact`` offers."""
    for name in wrcontact.__all__:
        if name not in ("check", "check_fleet"):
            yield f"from .{getattr(wrcontact, name).__module__.partition('.')[2]} import {name} as {name}"


def families():
    """Names of the families of methods, for an import."""
    return (f"{family.methods[0].__mro__[1].__name__}," for family in methods.FAMILIES)


def lines(command, written):
    """What stands for one ``#:`` line."""
    kind, _, rest = command.partition(" ")
    if kind == "properties":
        return properties(rest.split()[-1], written)
    if kind == "parameters":
        return parameters(single=bool(rest))
    if rest.startswith("of a wheel"):
        return (_input(name, row, rest.split()[-1]) for name, row in one_wheel.wheel_inputs("right").items())
    return {"inputs": lambda: inputs(rest), "exports": exports, "families": families}[kind]()


def stub(name):
    """The text of one file of types."""
    template = (TEMPLATES / f"{name}.pyi.in").read_text(encoding="utf-8")

    def put(found):
        before = template[: found.start()].rpartition("\nclass ")[2]
        written = set(re.findall(r"def (\w+)\(", before))
        text = indent("\n".join(lines(found[2], written)), found[1])
        return text or f"{found[1]}..."

    return NOTE + re.sub(r"^( *)#: (.*)$", put, template, flags=re.MULTILINE)


def stubs():
    """{path: text} of all of them."""
    return {ROOT / "wrcontact" / place: stub(name) for name, place in PLACES.items()}


if __name__ == "__main__":
    changed = {
        path: text
        for path, text in stubs().items()
        if not path.exists() or path.read_text(encoding="utf-8") != text
    }
    for path, text in changed.items():
        path.write_text(text, encoding="utf-8")
    print(f"{len(changed)} files of types changed", file=sys.stderr)
