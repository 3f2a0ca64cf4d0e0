"""Guides: their Python runs, page by page in one namespace, options of their commands exist, and what a page
shows is what comes out.

A block of ``sh`` is run too, and a block of ``text`` has what the block before it prints; "…" is more of it.
``<!-- not run: reason -->`` before a block keeps it out.
"""

import importlib.util
import re
import shlex
import warnings

import fmpy
import matplotlib.pyplot
import numpy as np
import pytest

import wrcontact
from data.measured.make_measured import HERE, texts, worn_rail, worn_wheel
from tests.helpers.fmus import needs_compiler
from tests.helpers.paths import ROOT
from tests.helpers.profile_points import columns, points, simpack
from wrcontact.kernel.binding.library import default_kernel

DOCS = ROOT / "docs"
PAGES = {
    page.name: page.read_text(encoding="utf-8")
    for page in (
        DOCS / "index.md",
        DOCS / "choose.md",
        DOCS / "reference" / "statuses.md",
        *sorted((DOCS / "guides").glob("*.md")),
    )
}
BLOCK = re.compile(
    r"(<!-- not run: (?P<reason>.+?) -->\n+)?^```(?P<kind>\w*)\n(?P<code>.*?)^```", re.M | re.S
)
#: Pages whose examples need FMUs beside them; the page that builds its own; pages that take seconds.
WITH_FMUS = ("fmu.md", "fmu_hosts.md", "importers.md")
BUILDS = "measured_wheel.md"
SLOW = ("check.md", "usage.md")
#: Pages whose examples need an extra.
WITH_PANDAS = ("contact_geometry.md",)
COMMAND = re.compile(r"^(?:    )?wrcontact ((?:build|check|demo|figures|plot|solve|sweep)\b.*)$", re.M)


def marks(name):
    compiler = [needs_compiler] if name in (*WITH_FMUS, BUILDS) else []
    return compiler + [pytest.mark.full] * (name in (*WITH_FMUS, BUILDS, *SLOW, *WITH_PANDAS))


EXAMPLES = [
    pytest.param(name, marks=marks(name))
    for name, page in PAGES.items()
    if "```python" in page and name not in ("gallery.md", "tables.md")
]  # run elsewhere, with extras
pytestmark = pytest.mark.skipif(
    not default_kernel().compiled, reason="the examples of pages want the compiled library, and none is here"
)


def blocks(name):
    """What is run of a page: (kind, code)."""
    return [
        (found["kind"], found["code"])
        for found in BLOCK.finditer(PAGES[name])
        if found["kind"] in ("python", "sh", "text") and not found["reason"]
    ]


def one_line(text):
    return " ".join(text.split())


def prepared(folder):
    """Names that pages take for granted, and the files that they read."""
    for name, text in texts().items():
        (folder / name).write_bytes(text.encode("ascii"))
    for name, kind in (("left.csv", "wheel"), ("right.csv", "wheel"), ("worn.csv", "rail")):
        (folder / name).write_text(columns(*points(kind), ","))
    (folder / "uic60.prr").write_text(simpack(*points("rail"), "rail"))
    shifts = np.linspace(-5e-3, 5e-3, 11)
    return {
        "wrcontact": wrcontact,
        "ContactSystem": wrcontact.ContactSystem,
        "np": np,
        "fmpy": fmpy,
        "matplotlib": matplotlib,
        "shifts": shifts,
        "step": 1e-3,
        "distance": np.linspace(0.0, 20.0, 11),
        "table": wrcontact.ContactSystem().evaluate_many(lateral_shift=shifts),
    }


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_run_and_print_what_the_page_shows(name, request, tmp_path, monkeypatch, run, capsys):
    if name in WITH_PANDAS:
        pytest.importorskip("pandas")
    if name in WITH_FMUS:
        for file in request.getfixturevalue("fmus").values():
            (tmp_path / file.name).write_bytes(file.read_bytes())
    monkeypatch.chdir(tmp_path)
    names, said = prepared(tmp_path), ""
    for kind, code in blocks(name):
        if kind == "text":
            missing = [line for line in code.splitlines() if one_line(line.strip("…")) not in one_line(said)]
            assert not missing, said
        elif kind == "sh":
            said = "".join(commanded(line, run) for line in code.replace("\\\n", " ").splitlines())
        else:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", wrcontact.ProfileWarning)  # of the files above
                exec(code, names)
            said = capsys.readouterr().out
    matplotlib.pyplot.close("all")


def commanded(line, run):
    program, *words = shlex.split(line)
    assert program == "wrcontact"
    code, out, errors = run(*words)
    assert code == 0, errors
    return out + errors


@pytest.mark.parametrize("name", [name for name, page in PAGES.items() if "wrcontact " in page])
def test_commands_have_options_that_exist(name, run):
    """Of all lines that begin with wrcontact; ``--help`` lets them do nothing."""
    for line in COMMAND.findall(PAGES[name].replace("\\\n", " ")):
        words = shlex.split(line, comments=True)
        code, _, errors = run(*words, "--help")
        assert code == 0, f"{line}: {errors}"


def test_programs_exist():
    """Those that a page runs by ``python -m`` and ``python FILE``."""
    found = {word for page in PAGES.values() for word in re.findall(r"\bpython (-m [\w.]+|\S+\.py)", page)}
    assert len(found) > 8
    for words in found - {"-m build"}:  # of the extra "platforms"
        module = words.removeprefix("-m ")
        known = importlib.util.find_spec(module) if words.startswith("-m") else (ROOT / words).exists()
        assert known, words


def test_a_block_that_is_not_run_says_why():
    for name, page in PAGES.items():
        for comment in re.findall(r"<!-- not run.*", page):
            assert re.fullmatch(r"<!-- not run: \w.{10,} -->", comment), f"{name}: {comment}"


def test_the_measured_files_are_what_their_program_makes():
    for name, text in texts().items():
        assert (HERE / name).read_bytes() == text.encode("ascii"), name


def exact(kind, place, folder):
    """The profile through points without noise."""
    np.savetxt(folder / f"{kind}.txt", np.transpose(place), fmt="%.9f")
    return wrcontact.Profile.from_file(folder / f"{kind}.txt", kind)


@pytest.mark.filterwarnings("ignore::wrcontact.ProfileWarning")
def test_the_truth_of_the_measured_pair_is_as_the_page_says(tmp_path):
    """The wear is a formula, and the points without noise give this row."""
    page = PAGES[BUILDS]
    wheel, rail = exact("wheel", worn_wheel(), tmp_path), exact("rail", worn_rail(), tmp_path)
    report = wrcontact.check(wrcontact.ContactSystem(wheel=wheel, rail=rail))
    jumps = sum(jump.side == "right" and abs(jump.lateral_shift) < 8e-3 for jump in report.jumps)
    row = re.search(r"^\| truth.*?\| (\d+) \| (\S+) \| (\S+) \|$", page, re.M)
    assert jumps == int(row[1])
    assert report.conicity.level[1:3] == pytest.approx([float(row[2]), float(row[3])], abs=0.006)
    low, high, said = -38e-3, 30e-3, float(re.search(r"curve is (\S+) µm from the truth", page)[1])
    y = np.linspace(low, high, 3001)
    smoothed = wrcontact.Profile.from_file(HERE / "worn.whl", "wheel")
    assert smoothed.height(0.0) == pytest.approx(0.0, abs=5e-6)  # [m] z is 0 at the worn running circle
    found = smoothed.height(y) - wheel.height(y)
    assert 1e6 * np.std(found) == pytest.approx(said, abs=0.06)


SECTIONS = re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", PAGES["importers.md"], re.M | re.S)
GENERAL = ("What to connect", "Which tool runs which FMU")


@pytest.mark.parametrize(
    "tool, text", [part for part in SECTIONS if part[0] not in GENERAL], ids=lambda word: word.split()[0]
)
def test_each_tool_says_whether_it_was_tried(tool, text):
    """Once; and what was tried by a test names it."""
    said = re.findall(r"^\*\*(Tried|Not tried):\*\* (.*?)(?:\n\n|\Z)", text, re.M | re.S)
    assert len(said) == 1, tool
    ((verdict, words),) = said
    assert verdict == "Not tried" or "by hand" in words or re.search(r"\]\(\S+test_\w+\.py\)", words), tool


def test_strings_that_did_not_arrive_are_seen():
    """The table of mistakes: a wheelset 1 mm above its rails."""
    raised = {"vertical_shift_input": -1e-3, "normal_force": 60e3}
    rigid = wrcontact.ContactSystem().evaluate(**raised)
    compliant = wrcontact.ContactSystem(contact_mode="compliant").evaluate(**raised)
    assert (compliant.status, compliant.force.z) == (1, 0.0)
    # normals are not quite vertical
    assert rigid.status == 0 and rigid.force.z == pytest.approx(-120e3, rel=0.01)
