"""README and documentation: examples run, linked files exist, counts and tables agree with the package."""

import re

import pytest

from benchmarks import pages
from tests.helpers.paths import ROOT, TESTS
from wrcontact.cli import main
from wrcontact.creep import forces
from wrcontact.fmu import native
from wrcontact.interface.variables import OUTPUT, VARIABLES
from wrcontact.kernel import layout
from wrcontact.kernel.binding.files import PLATFORMS
from wrcontact.profiles.catalogue import USUAL

DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.rglob("*.md"))]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_example_runs(capsys):
    exec(re.search(r"```python\n(.*?)```", README, re.DOTALL).group(1), {})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 4 and lines[0].startswith("0 -0.000369")  # two patches at 5 mm
    # the S1002's 70 deg flank, and the roll
    assert float(lines[3]) == pytest.approx(1.2249, abs=2e-3)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_linked_files_exist(page):
    for link in re.findall(r"\]\((?!http)([^)#]+)", page.read_text(encoding="utf-8")):
        assert (page.parent / link).exists(), link


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_that_are_named_exist(page):
    """Paths in backticks, from the top of the repository or of the package, and names of tests."""
    words = set(re.findall(r"`([^`\s]+)`", page.read_text(encoding="utf-8")))
    paths = {
        word.split("::")[0]
        for word in words
        if re.match(r"(wrcontact|kernel|tests|benchmarks|tools|examples|docs|fmu_src)/", word)
    }
    missing = {path for path in paths if not ((ROOT / path).exists() or (ROOT / "wrcontact" / path).exists())}
    assert not missing - {"kernel/_wrcontact_kernel-<platform>"}
    tests = {file.name for file in (ROOT / "tests").rglob("test_*.py")}
    assert {word.split("::")[0] for word in words if re.match(r"test_\w+\.py", word)} <= tests
    package, examples = (
        {file.name for file in (ROOT / folder).rglob("*.py")} for folder in ("wrcontact", "examples")
    )
    assert {word for word in words if re.fullmatch(r"\w+\.py", word)} <= package | tests | examples


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_tests_that_are_named_exist(page):
    """Tests by name, whole or shortened by an ellipsis, in the file that is named with them."""
    text = page.read_text(encoding="utf-8")
    for file, test, shortened in re.findall(r"(?:(test_\w+\.py)::)?\b(test_\w+)\b(?!\.py)(…?)", text):
        sources = [path.read_text(encoding="utf-8") for path in TESTS.rglob(file or "test_*.py")]
        end = r"\w*\(" if shortened else r"\("
        assert any(re.search(rf"^def {test}{end}", source, re.MULTILINE) for source in sources) or (
            not file and list(TESTS.rglob(f"{test}.py"))
        ), f"{file} {test}"


#: A word that a test has if it runs the tool.
TOOLS = {
    "fmpy": "validate_fmu",
    "fmutool": '"fmutool"',
    "fmucontainer": '"fmucontainer"',
    "simulate_fmu": "simulated_exchange",
    "ecospy": '"ecospy"',
    "libcosimpy": '"libcosimpy"',
    "a C host": "host.c",
}


def test_tools_that_are_said_to_run_are_run():
    """Every row with a "yes" names the tests that run the tool."""
    page = (DOCS / "guides" / "importers.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (.+?) \|(.*\byes\b.*)\|(.*)\|$", page, re.MULTILINE)
    assert len(rows) >= len(TOOLS)
    for tool, _, tests in rows:
        files = [DOCS / "guides" / link for link in re.findall(r"\]\((.*?)\)", tests)]
        sources = [file.read_text(encoding="utf-8") for file in files]
        word = next((word for name, word in TOOLS.items() if tool.startswith(name)), tool.split(",")[0])
        assert sources and all(word in source for source in sources), tool


def test_the_page_on_fmus_names_what_there_is(capsys):
    files = [DOCS / "guides" / name for name in ("fmu.md", "fmu_hosts.md")]
    page = "".join(file.read_text(encoding="utf-8") for file in files)
    page = pages.PATTERN.sub("", page)  # without tables
    for name in (*PLATFORMS, *USUAL):
        assert name in page, name
    wildcards = re.search(r"-ffp-contract=off (.*) -o WheelsetContact", page)[1].split()
    assert wildcards == ["*.c", "kernel/native/*.c"]
    assert {unit.rpartition("/")[0] for unit in native.compiled_units(2)} == {"", "kernel/native"}
    with pytest.raises(SystemExit):
        main(["build", "--help-all"])
    options = capsys.readouterr().out
    for option in re.findall(r"--[a-z]+", re.sub("<!--.*?-->", "", page)):  # marks of tables are no options
        assert option in options, option


def test_every_input_and_parameter_is_in_a_table():
    """And every choice of every method."""
    page = (DOCS / "reference" / "nomenclature.md").read_text(encoding="utf-8")
    for variable in VARIABLES:
        if variable.causality != OUTPUT:
            assert re.search(rf"^\|.*`{variable.name}`[^|]* \|", page, re.MULTILINE), variable.name
            assert all(f'"{choice}"' in page for choice in variable.choices), variable.name
    for name in ("force", "moment", "roll", "vertical_shift", "status"):
        assert re.search(rf"^\|.*`{name}[^|]* \|", page, re.MULTILINE), name


def test_the_model_of_one_s_own_is_a_model():
    """The one of own_model.md, uncompiled: linear theory where creepages are small (1 %), friction times load
    where they are large."""
    text = (DOCS / "guides" / "own_model.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    code = next(block for block in blocks if "def solve_" in block)
    module = {"__package__": "wrcontact.kernel.creep"}
    exec(code, module)
    tables = layout.Tables.at(forces.model_tables(layout.TANGENTIAL_POLACH, 210e9, 0.28))
    found = []
    for creepage in (1e-6, 1.0):
        patch = layout.Patch(half_length=6e-3, half_width=4e-3, friction=0.3, creepage_x=-creepage)
        patch.totals.load = 80e3
        module["solve_shen"](tables, patch)
        found.append(patch.creep_x)
    along, _, _ = module["kalker_coefficients"](tables.rolling, 1.5)
    assert found == pytest.approx([tables.shear_modulus * 24e-6 * along * 1e-6, 24e3], rel=0.01)


def test_the_page_of_data_describes_each_file_once():
    """The tables and programs that stand in the folder data itself."""
    page = (ROOT / "data" / "README.md").read_text(encoding="utf-8")
    named = re.findall(r"^\| `([\w./]+)`(?:, `([\w.]+)`)? \|", page, re.MULTILINE)
    names = [name for names in named for name in names if name]
    assert len(set(names)) == len(names) and all((ROOT / "data" / name).exists() for name in names)
    there = {path.name for path in (ROOT / "data").iterdir() if path.suffix in (".csv", ".json", ".py")}
    assert there - set(names) <= {"__init__.py"}
