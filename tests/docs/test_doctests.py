"""Examples in the package's docstrings run as they are printed."""

import doctest
import importlib
from pathlib import Path

import pytest

import wrcontact

PACKAGE = Path(wrcontact.__file__).parent
MODULES = [
    path.relative_to(PACKAGE.parent).with_suffix("").as_posix().replace("/", ".")
    for path in sorted(PACKAGE.rglob("*.py"))
    if ">>> " in path.read_text(encoding="utf-8")
]


def test_modules_have_examples():
    assert len(MODULES) >= 12


@pytest.mark.parametrize("name", MODULES)
def test_examples(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said = []
    for test in doctest.DocTestFinder().find(importlib.import_module(name.removesuffix(".__init__"))):
        doctest.DocTestRunner().run(test, out=said.append)
    assert not said, "".join(said)
