"""What is generated is what its makers write today: ``make pages`` writes it."""

import runpy

import pytest

from tests.helpers.paths import ROOT

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
