"""Every place that a new output, parameter, method, profile format or status needs.  A failure names the places that are
missing, as CONTRIBUTING.md lists them."""

import re
from functools import cache
from pathlib import Path

import pytest

from tests.helpers.output_witnesses import WITNESSES, folded
from tests.helpers.paths import ROOT
from wrcontact.cli.typed import option_of
from wrcontact.interface.outputs import PATCH, SIDE, WEAR, WHEELSET
from wrcontact.interface.parameters import KERNEL_PARAMETERS, PARAMETERS
from wrcontact.interface.references import STORED
from wrcontact.interface.rows import Blocks, Vector
from wrcontact.interface.variables import OUTPUT, STATUS, VARIABLES
from wrcontact.methods import FAMILIES
from wrcontact.profiles.formats import FORMATS
from wrcontact.status import SENTENCES, Status


@cache
def text(*patterns):
    """The text of all files of these ``patterns``, but for this one, which is no place."""
    files = [
        path
        for pattern in patterns
        for path in sorted(ROOT.glob(pattern))
        if path.name != Path(__file__).name
    ]
    assert files, patterns
    return "\n".join(path.read_text(encoding="utf-8") for path in files)


KERNEL = tuple(
    f"wrcontact/kernel/{room}/*.py"
    for room in (
        "prepare",
        "search",
        "surface",
        "contact",
        "normal",
        "patch",
        "creep",
        "wheelset",
        "derivative",
    )
)


@cache
def words(*patterns):
    """All words in these files."""
    return frozenset(re.findall(r"\w+", text(*patterns)))


def has(word, *patterns):
    """Whether a word stands in one of these files."""
    return word in words(*patterns)


def first_of(name):
    """The row's name of an output: ``force`` of ``right.patch[2].force.x``."""
    return re.sub(r"\.[xyz]$", "", re.sub(r"\[\w+\]", "", name)).rpartition(".")[2]


@cache
def fields():
    """The field of the kernel's record by the row's name."""
    rows = [row for row in (*WHEELSET, *SIDE, *PATCH, *WEAR) if not isinstance(row, Blocks)]
    return {row.name.rpartition(".")[2]: row.field for row in rows} | {
        row.name: row.field for row in rows if isinstance(row, Vector)
    }


#: What each needs: the place as CONTRIBUTING.md names it, and whether it is there.
PLACES = {
    "output": {
        "wrcontact/interface/value_references.csv": lambda name: name in STORED[2],
        "wrcontact/kernel": lambda name: (
            folded(name)[0].endswith("[j]")  # runs of stations are written one behind the other
            or has(fields().get(first_of(name), first_of(name)), *KERNEL)
        ),
        "tests/helpers/output_witnesses.py": lambda name: folded(name)[0] in WITNESSES,
        "docs/reference/nomenclature.md": lambda name: (
            first_of(name) in text("docs/reference/nomenclature.md")
        ),
    },
    "parameter": {
        "wrcontact/interface/value_references.csv": lambda name: (
            (
                name not in PARAMETERS
                or not PARAMETERS[name].fmu_name
                or PARAMETERS[name].fmu_name in STORED[2]
            )
            and name in PARAMETERS
        ),
        "wrcontact/kernel": lambda name: has(name, *KERNEL) or name not in KERNEL_PARAMETERS,
        "docs/reference/nomenclature.md": lambda name: f"`{name}`" in text("docs/reference/nomenclature.md"),
        "docs/reference/command_line.md": lambda name: (
            option_named(name) in text("docs/reference/command_line.md")
        ),
        "tests": lambda name: has(name, "tests/**/*.py"),
    },
    "method": {
        "wrcontact/kernel": lambda method: chosen_by_default(method) or has(constant_of(method), *KERNEL),
        "docs/reference/nomenclature.md": lambda method: (
            f'"{method.name}"' in text("docs/reference/nomenclature.md")
        ),
        "docs/reference/api.md": lambda method: method.__name__ in text("docs/reference/api.md"),
        "tests": lambda method: f'"{method.name}"' in text("tests/**/*.py"),
    },
    "format": {
        "docs/guides/profiles.md": lambda ending: f"`{ending}`" in text("docs/guides/profiles.md"),
        "tests/profiles": lambda ending: has(
            ending[1:], "tests/profiles/*.py", "tests/helpers/foreign_files.py"
        ),
    },
    "status": {
        "wrcontact/status.py": lambda kind: any(one.status == kind for one in SENTENCES),
        "wrcontact/interface/variables.py": lambda kind: (
            f" {int(kind)} " in f" {VARIABLES[STATUS].description} "
        ),
        "docs/reference/statuses.md": lambda kind: (
            f"| {int(kind)} | `{kind.name}` |" in text("docs/reference/statuses.md")
        ),
        "tests": lambda kind: has(kind.name, "tests/**/*.py"),
    },
}


#: What a failure ends with.
GENERATED = (
    "`make kernel` and then `make pages` write value_references.csv, nomenclature.md and command_line.md"
)


def constant_of(method):
    """The kernel's constant of a method: MODE_RIGID."""
    return f"{method.family.constant}_{method.name.upper()}"


def chosen_by_default(method):
    """Whether the kernel needs no branch for it: the last ``else``, or another method's number."""
    others = [one for one in method.family.methods if one is not method and not one.python_only]
    return method.python_only or all(has(constant_of(one), *KERNEL) for one in others)


def option_named(name):
    """The option of a parameter by its Python name; the FMU's variables have it."""
    found = [option_of(one) for one in VARIABLES if one.keyword == name]
    return f"`{found[0]}" if found else f"`--{name.replace('_', '-')}"


def missing(kind, one):
    """The places that a thing of this kind lacks."""
    return [place for place, is_there in PLACES[kind].items() if not is_there(one)]


def things():
    """(Kind, thing) of all that there are."""
    yield from (
        ("output", one.name) for one in VARIABLES if one.causality == OUTPUT and one.index is not None
    )
    yield from (
        ("parameter", name) for name in PARAMETERS if PARAMETERS[name].fmu_name and not PARAMETERS[name].right
    )
    yield from (("method", method) for family in FAMILIES for method in family.methods)
    yield from (("format", ending) for one in FORMATS if one.read for ending in one.endings)
    yield from (("status", kind) for kind in Status if kind != Status.VALID)


def test_everything_is_in_all_its_places():
    lacking = {
        f"the {kind} {folded(one)[0] if kind == 'output' else getattr(one, 'name', one)} is missing in {', '.join(places)}"
        for kind, one in things()
        if (places := missing(kind, one))
    }
    if lacking:
        pytest.fail("\n".join([*sorted(lacking), GENERATED]), pytrace=False)


class Nowhere:
    """A method, and a status, that are in no place."""

    name, python_only = "nowhere_at_all", False

    def __int__(self):
        return 99


@pytest.mark.parametrize("kind", PLACES)
def test_what_is_nowhere_lacks_every_place(kind, monkeypatch):
    """... so that no place is found where there is none, and a first change is led to each of them."""
    one = {"output": "nowhere_at_all", "parameter": "nowhere_at_all", "format": ".nowhere_at_all"}.get(kind)
    if one is None:
        one = Nowhere()
        one.family, one.__name__ = FAMILIES[0], "NowhereAtAll"
    monkeypatch.setattr(f"{__name__}.KERNEL_PARAMETERS", (*KERNEL_PARAMETERS, "nowhere_at_all"))
    monkeypatch.setattr(f"{__name__}.chosen_by_default", lambda method: False)
    assert missing(kind, one) == list(PLACES[kind])


@pytest.mark.parametrize("kind", PLACES)
def test_contributing_lists_the_places(kind):
    page = text("CONTRIBUTING.md").partition("## How to add")[2].partition("\n## ")[0]
    (entry,) = [one for one in re.split(r"\n\* \*\*", page) if one.lower().startswith(f"a new {kind}")]
    assert [place for place in PLACES[kind] if f"`{place}`" not in entry] == []
