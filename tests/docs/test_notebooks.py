"""The notebooks are stored without outputs, in short cells with a sentence before each; test_site.py
runs them."""

import json

import pytest

from tests.helpers.paths import ROOT

FOLDER = ROOT / "docs" / "notebooks"
NOTEBOOKS = sorted(path.stem for path in FOLDER.glob("*.ipynb"))
MOST_LINES = 22  # of a cell of code


def stored(name):
    return json.loads((FOLDER / f"{name}.ipynb").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebooks_are_stored_without_outputs_and_tell_what_they_do(name):
    cells = stored(name)["cells"]
    assert cells[0]["cell_type"] == "markdown" and "".join(cells[0]["source"]).startswith("# ")
    for before, cell in zip(cells, cells[1:]):
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [] and cell["execution_count"] is None
            assert before["cell_type"] == "markdown" and "".join(before["source"]).endswith((".", ":"))
            assert len(cell["source"]) <= MOST_LINES
