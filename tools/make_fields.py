"""Write what follows from the tables of inputs, outputs and parameters (wrcontact/interface) in Python:
``python tools/make_fields.py``.

* wrcontact/results/fields.py: the parts of results. Each row is a property of a class, with its words and its place in
  the kernel's row.
* wrcontact/keywords.py: the keywords of systems and calls with their types and words, for editors and type checkers.
"""

import sys
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
if __name__ == "__main__":  # without the face of the package, which imports what is written here
    sys.modules["wrcontact"] = ModuleType("wrcontact")
    sys.modules["wrcontact"].__path__ = [str(ROOT / "wrcontact")]

from wrcontact import methods  # noqa: E402
from wrcontact.interface import one_wheel  # noqa: E402
from wrcontact.interface import outputs as table  # noqa: E402
from wrcontact.interface.inputs import INPUTS  # noqa: E402
from wrcontact.interface.parameters import BOTH_SIDED, GROUPS, LEFT, PARAMETERS  # noqa: E402
from wrcontact.interface.rows import AXES, Blocks, Run, Vector  # noqa: E402
from wrcontact.kernel import layout  # noqa: E402
from wrcontact.methods.numbers import unit_behind  # noqa: E402
from wrcontact.methods.own import STAND_INS  # noqa: E402

NOTE = "# Written by tools/make_fields.py from wrcontact/interface; do not edit.\n"
HEAD = '''"""The parts of a result and the inputs by name: a property for each row of the tables of inputs and outputs."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .views import N, RunView, StripView, Vector, View


class InputFields(np.ndarray):
    """Inputs by the names of Python's keywords."""
'''
#: Classes of a result: their words, rows and record. A name with a dot is a property of the part before it.
CLASSES = {
    "PatchFields": ("One contact patch.", table.PATCH, layout.PatchOutputs),
    "SideFields": ("One wheel on its rail.", table.SIDE, layout.SideOutputs),
    "WheelsetFields": ("A wheelset on its track.", table.WHEELSET, layout.Outputs),
}
NORMAL = "Forces and moments of the pressures alone, without creep forces."
#: Parts of these classes: their class and its words.
PARTS = {
    ("PatchFields", "creepage"): (
        "Creepage",
        "Velocity of the wheel against the rail in the plane of a patch, over the rolling speed.",
    ),
    ("PatchFields", "tangential"): ("Tangential", "Creep force and moment of a patch on its wheel."),
    ("SideFields", "contact"): (
        "Contact",
        "The contact point in the frames of the wheel, the rail and the track.",
    ),
    ("SideFields", "normal"): ("SideNormal", NORMAL),
    ("WheelsetFields", "normal"): ("WheelsetNormal", NORMAL),
}

OUTLINE = "Outline and pressure at evenly spaced stations across, from the first loaded place to the last."
STRIPS = """The strips of a patch along the rolling direction, across the rail: arrays (16,), or (n, 16) of a
    table, zero where the patch is not there."""


def words_of(row, behind="."):
    """The docstring of a row's property."""
    words = row.meaning.format(axis=", ".join(way for _, way in AXES))
    return f"{words[0].upper()}{words[1:]} [{row.unit}]{behind}"


def property_of(name, kind, words, value):
    """The text of one property."""
    return f'    @property\n    def {name}(self) -> {kind}:\n        """{words}"""\n        return {value}\n'


def class_of(name, bases, words, members, properties):
    """The text of a class, with the names of its ``members`` in their order."""
    shown = "".join(f"        {member!r},\n" for member in members).replace("'", '"')
    head = (
        f'class {name}({bases}):\n    """{words}"""\n\n    __slots__ = ()\n    _members = (\n{shown}    )\n'
    )
    return "\n".join([head, *properties])


def number(row, record):
    """The property of a number or vector."""
    place, own = getattr(record, row.field).offset // 8, row.name.rpartition(".")[2]
    if isinstance(row, Vector):
        return property_of(
            own, "Vector[N]", words_of(row), f"Vector(self._values, self._offset + {place}, self.layout)"
        )
    return property_of(own, "N", words_of(row), f"self._number({place})")


def parts_and_class(name):
    """The texts of a class and of the classes of its parts."""
    words, rows, record = CLASSES[name]
    rows = [row for row in rows if not isinstance(row, (Blocks, Run))]
    found, properties, members = [], [], dict.fromkeys(row.name.split(".")[0] for row in rows)
    for (owner, part), (kind, meaning) in PARTS.items():
        if owner == name:
            inside = [row for row in rows if row.name.startswith(f"{part}.")]
            own = [row.name.rpartition(".")[2] for row in inside]
            found.append(class_of(kind, "View[N]", meaning, own, [number(row, record) for row in inside]))
            value = f"{kind}(self._values, self._offset, self.layout)"
            properties.append(property_of(part, f"{kind}[N]", meaning, value))
    properties += [number(row, record) for row in rows if "." not in row.name and not row.whole]
    return [*found, class_of(name, "View[N]", words, members, properties)]


def runs(rows, behind, value):
    """The properties of runs; ``value`` gives that of a row."""
    return [property_of(row.name, "NDArray[Any]", words_of(row, behind), value(row)) for row in rows]


def outlines():
    """The texts of the classes of outlines and strips."""
    usual, names = [row for row in table.SIDE if isinstance(row, Run)], [row.name for row in table.WEAR]
    members = [row.name for row in usual]
    properties = [
        *runs(usual, ", one value per station.", lambda row: f'self._run("{row.name}")'),
        *runs(
            table.WEAR, ", one value per station; with wear_outputs.", lambda row: f'self._run("{row.name}")'
        ),
    ]
    strips = runs(
        table.STRIPS,
        ", one value per strip.",
        lambda row: f"self._strips({getattr(layout.StripOutputs, row.field).offset // 8})",
    )
    return [
        class_of("Outline", "RunView[N]", OUTLINE, members, properties),
        class_of("WornOutline", "Outline[N]", "An outline with the outputs of wear.", [*members, *names], []),
        class_of("Strips", "StripView[N]", STRIPS, [row.name for row in table.STRIPS], strips),
    ]


def fields():
    """The text of wrcontact/results/fields.py."""
    inputs = [
        property_of(row.keyword, "Any", f"{row.words} [{row.unit}].", f'self["{row.name}"]') for row in INPUTS
    ]
    classes = [one for name in CLASSES for one in parts_and_class(name)]
    return "\n\n".join(["\n".join([HEAD, *inputs]), *classes, *outlines()])


# --- keywords -----------------------------------------------------------------------------------------------

KEYWORDS = '''"""Keywords of systems and calls, for editors and type checkers; they are read from the same tables when the package
runs."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from os import PathLike
from typing import Any, Literal, TypedDict

from numpy.typing import ArrayLike

from .interface.friction import Friction
from .interface.parameters import Material, Track, Wheelset
from .methods import (
{families}
)
from .profiles import Profile, ProfileFile
from .sections import RailSections, WheelSections

OneProfile = str | PathLike[str] | ProfileFile | Profile
OneRail = OneProfile | RailSections
OneWheel = OneProfile | WheelSections
Depth = Literal["all", "patches", "geometry"]
Wanted = Depth | str | Iterable[str]
Sides = Literal["both", "left", "right"]
{names}
'''
PROFILES = ("wheel", "rail")


def base_of(family):
    """The name of the class that the methods of a family are."""
    return family.methods[0].__mro__[1].__name__


def parameter_type(row, single=False):
    """The type of one keyword of ContactSystem; ``single`` of one wheel's."""
    number = row.number or (PARAMETERS[row.right].number if row.right else None)
    if row.right in PROFILES:
        typed = "OneRail" if row.right == "rail" else "OneWheel"
    elif row.family:
        typed = f"{base_of(row.family)}Name | {base_of(row.family)}"
        typed += " | Callable[..., Any]" if row.name in STAND_INS else ""
    else:
        typed = "bool" if number.switch else "int" if number.whole else "float"
        typed += " | str" if number.ratio else ""
    if row.name in BOTH_SIDED and not single:
        typed += f" | tuple[{typed}, {typed}]"
    return typed + (" | None" if row.default is None else "")


def names_of(family):
    """The line of the names of a family's methods."""
    names = ", ".join(f'"{name}"' for name in family.names())
    return f"{base_of(family)}Name = Literal[{names}]"


def parameter_words(row):
    """What a keyword is, with its range and default."""
    if row.right:
        return f"On the left side, {row.right}; by default that of the right."
    if row.family:
        return f"{row.family.decides[0].upper()}{row.family.decides[1:]}; by default {row.default!r}."
    known, words = row.number, f"{row.meaning[0].upper()}{row.meaning[1:]}"
    if not known.switch:
        words += f"; {known.low:g} ... {known.high:g}{unit_behind(known.unit)}"
    if row.default is not None:
        words += f"; by default {row.default if known.switch else format(row.default, 'g')}"
    return f"{words}."


def keys(name, words, rows):
    """The text of a class of keywords: (name, type, words) of each."""
    inside = "".join(f'    {key}: {kind}\n    """{meaning}"""\n' for key, kind, meaning in rows)
    return f'class {name}(TypedDict, total=False):\n    """{words}"""\n\n{inside}'


def keywords():
    """The text of wrcontact/keywords.py."""
    rows = [row for name, row in PARAMETERS.items() if name not in PROFILES]
    own = [row for row in rows if row.name not in one_wheel.WITHOUT and not row.name.startswith(LEFT)]
    groups = [
        (name, f"{kind.__name__} | None", f"{kind.__name__} in one record.") for name, kind in GROUPS.items()
    ]
    inputs = [(row.keyword, f"{row.words} [{row.unit}]; by default {row.start:g}.") for row in INPUTS]
    wheel = one_wheel.wheel_inputs("right").items()
    classes = [
        keys(
            "SystemKeywords", "Of a system.", [(r.name, parameter_type(r), parameter_words(r)) for r in rows]
        ),
        keys(
            "WheelKeywords",
            "Of a system of one wheel.",
            [*groups, *((r.name, parameter_type(r, True), parameter_words(r)) for r in own)],
        ),
        keys("PoseInputs", "Of one pose.", [(name, "float", words) for name, words in inputs]),
        keys("TableInputs", "Of a table of poses.", [(name, "ArrayLike", words) for name, words in inputs]),
        keys(
            "WheelInputs",
            "Of one pose of a wheel.",
            [
                (n, "float", f"{r.meaning[0].upper()}{r.meaning[1:]} [{r.unit}]; by default {r.start:g}.")
                for n, r in wheel
            ],
        ),
    ]
    families = ",\n".join(f"    {base}" for base in sorted(map(base_of, methods.FAMILIES))) + ","
    names = "\n".join(map(names_of, methods.FAMILIES))
    return "\n\n".join([KEYWORDS.format(families=families, names=names), *classes])


def files():
    """{path: text} of both files."""
    package = ROOT / "wrcontact"
    return {package / "results" / "fields.py": NOTE + fields(), package / "keywords.py": NOTE + keywords()}


if __name__ == "__main__":
    for path, text in files().items():
        path.write_text(text, encoding="utf-8")
