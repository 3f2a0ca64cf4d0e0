"""Generated tables of README and docs: they are written from what is kept, and what is kept is what the
measurement gives today."""

import re

import numpy as np
import pytest

from benchmarks import pages, parts, record, rows, worst
from benchmarks.pages import TABLES
from tests.helpers.paths import ROOT
from tests.helpers.same_numbers import SINGLE_POSES, differences

#: Errors that another file's test computes again, since it has them anyway.
ELSEWHERE = {"en15302", "worst_steps"}  # tests/benchmarks/test_en15302.py, and below
QUICK = [name for name, part in parts.PARTS.items() if part.kind == parts.ERRORS and name not in ELSEWHERE]
WORST = [name for name, _ in worst.systems()]
#: Long ones, with nothing that the others have not met on another machine.
ONE_MACHINE = {"worn_pairs"}
#: Studies of at most some minutes; the half-space's own rows have a test below.
LONG = ("elastic_roll", "profile_noise", "conicity_noise", "source_figures")


def test_every_table_stands_once_in_its_page():
    texts = ["README.md", *(path.relative_to(ROOT).as_posix() for path in ROOT.glob("docs/**/*.md"))]
    written = [(page, name) for page in texts for name in pages.names(page)]
    assert sorted(written) == sorted((table.page, name) for name, table in TABLES.items())


def test_the_readme_is_short():
    """110 lines, one table of seven rows; docs/evidence/benchmarks.md says where its numbers are from."""
    assert (ROOT / "README.md").read_text(encoding="utf-8").count("\n") <= 110
    assert pages.names("README.md") == ["short"]
    elsewhere = {
        part
        for table in TABLES.values()
        if table.page == "docs/evidence/benchmarks.md"
        for part in table.parts
    }
    assert set(TABLES["short"].parts) <= elsewhere


def test_every_part_is_in_a_table_and_kept():
    assert {name for table in TABLES.values() for name in table.parts} == set(parts.PARTS)
    assert {path.stem for path in record.FOLDER.glob("*.json")} == set(parts.PARTS)


def test_tables_say_of_which_commit_they_are():
    """And, with times, the unit and how noisy the run was; on docs/evidence/benchmarks.md, where a reader
    looks for it."""
    for page in {table.page for table in TABLES.values()}:
        text = (ROOT / page).read_text(encoding="utf-8")
        for found in pages.PATTERN.finditer(text):
            table = TABLES[found[1]]
            if page != pages.BENCHMARKS:
                assert "of commit" not in found[0] and "load average" not in found[0]
                continue
            kinds = {parts.PARTS[name].kind for name in table.parts}
            timed, others = parts.TIMES in kinds, kinds != {parts.TIMES}
            assert ("Times are those of commit `" in found[0]) == timed, found[1]
            assert ("Errors and counts are those of commit `" in found[0]) == others, found[1]
            if timed:
                assert "`np.sqrt` of 2000 doubles between them" in found[0]
                assert re.search(r"µs at best, \d+ % more in the median and \d+ % more at the 95th", found[0])


@pytest.mark.full
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.machine][: name not in ONE_MACHINE]) for name in QUICK]
)
def test_errors_are_those_of_today(name):
    """If this fails, a table is out of date: ``python -m benchmarks --write errors``."""
    found = record.short(parts.PARTS[name].measure(rows.FULL))
    wider = SINGLE_POSES if name == "elastic_trials" else None
    assert differences(found, record.load(name)["rows"], wider=wider) == []


@pytest.mark.full
@pytest.mark.parametrize("name", WORST)
@pytest.mark.turns(4)
def test_worst_steps_are_those_of_today(name):
    """If this fails, too: ``python -m benchmarks --write errors``."""
    found = record.short(worst.worst_steps(parts.STEPS, [name]))
    assert differences(found, {name: record.load("worst_steps")["rows"][name]}) == []


@pytest.mark.full
@pytest.mark.parametrize("name", LONG)
@pytest.mark.turns(2)
def test_studies_are_those_of_today(name):
    """If this fails: ``python -m benchmarks --write studies``."""
    found = record.short(parts.PARTS[name].measure(rows.FULL))
    assert differences(found, record.load(name)["rows"]) == []


@pytest.mark.full
def test_the_half_space_is_that_of_today():
    """Its first row, on the positions."""
    row = next(iter(rows.halfspace(rows.FULL)))
    row.every = 160  # one row of the hunting run
    found, kept = record.short(row.errors()), record.load("halfspace")["rows"][row.name]
    for run in ("positions mean", "positions worst"):
        assert differences(found[run], kept[run]) == []


def test_a_changed_number_is_seen():
    kept = {"row": {"mean": [0.7, 1.8], "worst": 39.6, "words": "as before"}}
    assert differences(kept, kept) == []
    for changed in (
        {"row": {"mean": [0.72, 1.8], "worst": 39.6, "words": "as before"}},
        {"row": {"mean": [0.7, 1.8], "worst": 40.0, "words": "as before"}},
        {"row": {"mean": [0.7, 1.8], "worst": np.nan, "words": "as before"}},
        {"row": {"mean": [0.7, 1.8], "worst": 39.6, "words": "otherwise"}},
        {"row": {"mean": [0.7], "worst": 39.6, "words": "as before"}},
        {},
    ):
        assert len(differences(changed, kept)) == 1
        assert len(differences(changed, kept, wider=SINGLE_POSES)) == 1


def test_trials_of_single_poses_may_differ_by_one():
    kept = {"row": {"mean": 9.598, "most": 67.0}}
    assert differences({"row": {"mean": 9.596, "most": 66.0}}, kept, wider=SINGLE_POSES) == []
    for changed in ({"row": {"mean": 9.7, "most": 67.0}}, {"row": {"mean": 9.598, "most": 72.0}}):
        assert len(differences(changed, kept, wider=SINGLE_POSES)) == 1
