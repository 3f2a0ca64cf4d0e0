"""docs/reference/nomenclature.md is what its script writes, and what it names exists."""

import runpy

from tests.helpers.paths import ROOT
from wrcontact.interface.inputs import INPUTS
from wrcontact.interface.outputs import PATCH, SIDE, WHEELSET
from wrcontact.interface.parameters import PARAMETERS

SCRIPT = runpy.run_path(str(ROOT / "docs" / "make_nomenclature.py"))


def test_the_page_is_up_to_date():
    """``python docs/make_nomenclature.py`` writes it."""
    assert SCRIPT["PAGE"].read_text(encoding="utf-8") == SCRIPT["page"]()


def test_symbols_are_of_rows_and_fields_that_exist():
    names = {row.name for row in (*INPUTS, *WHEELSET, *SIDE)} | {f"patch.{row.name}" for row in PATCH}
    assert set(SCRIPT["SYMBOLS"]) <= names | set(PARAMETERS)
    assert SCRIPT["unknown_fields"]() == []
