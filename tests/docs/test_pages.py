"""What is generated is what its makers write today: ``make pages`` writes it."""

import re
import runpy

import pytest
import typer

from tests.helpers.paths import ROOT
from wrcontact.cli import main

SCRIPT = runpy.run_path(str(ROOT / "docs" / "make_pages.py"))


@pytest.mark.parametrize("name", SCRIPT["EXACT"])
def test_files_are_what_is_written(name):
    """If this fails: ``make pages``."""
    texts = SCRIPT["EXACT"][name]()
    assert texts and not [path.name for path in SCRIPT["changed"](texts)]


def test_a_changed_or_missing_file_is_seen(tmp_path):
    (tmp_path / "same").write_text("α\n", encoding="utf-8")
    (tmp_path / "other").write_text("β\n", encoding="utf-8")
    found = SCRIPT["changed"]({tmp_path / name: "α\n" for name in ("same", "other", "missing")})
    assert found == {tmp_path / "other": "α\n", tmp_path / "missing": "α\n"}


def test_every_maker_is_called():
    """Those of docs and of tools write pages and types."""
    text = (ROOT / "docs" / "make_pages.py").read_text(encoding="utf-8")
    measured = " ".join(" ".join(words) for words in SCRIPT["MEASURED"].values())
    makers = {path.name for path in (ROOT / "docs").glob("make_*.py")} - {"make_pages.py"}
    assert not [name for name in makers if name not in text and name not in measured]


def test_what_is_measured_is_not_checked_here(capsys):
    for words in (["--check", "times"], ["pages"]):
        with pytest.raises(SystemExit) as ended:
            SCRIPT["main"](words)
        assert ended.value.code == 2
    assert "there is no pages; known are references" in capsys.readouterr().err


def test_an_option_of_several_commands_stands_once():
    """... and each command names, by groups and exceptions, every option that it has."""
    text = (ROOT / "docs/reference/command_line.md").read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if line.startswith("| `--")]
    assert len(rows) == len(set(rows)) and len(rows) > 100
    commands, _, common = text.partition("\n## Options of several commands\n")
    groups = {part.partition("\n")[0]: options_in(part) for part in common.split("\n### ")[1:]}
    found = typer.main.get_command(main).commands
    for part in commands.split("\n## wrcontact ")[1:]:
        name, rest = part.partition("\n")[::2]
        own, _, takes = rest.partition("\nIt also takes ")
        said = options_in(own)
        for group in filter(None, takes.strip().removesuffix(".").split("; ")):
            title, words = re.search(r"\[([^]]+)\]\([^)]*\)(.*)", group).groups()
            named = set(re.findall(r"`(--[a-z0-9-]+)`", words))
            said |= named if group.startswith("of ") else groups[title] - named
        has = {p.opts[0] for p in found[name].params if p.param_type_name == "option"}
        assert said == has - {"--help", "--help-all"}, name


def options_in(text):
    """Options of the tables in a text."""
    return set(re.findall(r"^\| `(--[a-z0-9-]+)", text, re.MULTILINE))
