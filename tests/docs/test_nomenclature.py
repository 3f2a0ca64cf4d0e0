"""What docs/reference/nomenclature.md names exists."""

import runpy

from tests.helpers.paths import ROOT
from wrcontact.interface.inputs import INPUTS
from wrcontact.interface.outputs import PATCH, SIDE, WHEELSET
from wrcontact.interface.parameters import PARAMETERS

SCRIPT = runpy.run_path(str(ROOT / "docs" / "make_nomenclature.py"))


def test_symbols_are_of_rows_and_fields_that_exist():
    names = {row.name for row in (*INPUTS, *WHEELSET, *SIDE)} | {f"patch.{row.name}" for row in PATCH}
    assert set(SCRIPT["SYMBOLS"]) <= names | set(PARAMETERS)
    assert SCRIPT["unknown_fields"]() == []
