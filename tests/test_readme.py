"""The README tells the truth: its example runs, its files exist, its counts are today's."""

import re
from pathlib import Path

import pytest

from wrcontact.interface.variables import INPUT, OUTPUT, VARIABLES, select

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_example_runs(capsys):
    exec(re.search(r"```python\n(.*?)```", README, re.DOTALL).group(1), {})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 4 and lines[0].startswith("0 -0.000369")        # two patches at 5 mm
    assert float(lines[3]) == pytest.approx(1.2249, abs=2e-3)            # the S1002's 70 deg flank, and the roll


def test_linked_files_exist():
    for link in re.findall(r"\]\((?!http)([^)#]+)\)", README):
        assert (ROOT / link).exists(), link


def test_counts():
    assert f"all {len(select(OUTPUT))} outputs" in README
    assert f"{len(select(INPUT))} inputs and {len(select(OUTPUT))} outputs" in README


def test_every_input_and_parameter_is_in_a_table():
    """And every choice of every method."""
    for variable in VARIABLES:
        if variable.causality != OUTPUT:
            assert re.search(rf"^\| [^|]*`{variable.name}`[^|]* \|", README, re.MULTILINE), variable.name
            assert all(f'"{choice}"' in README for choice in variable.choices), variable.name
    for name in ("force", "moment", "roll", "vertical_shift", "status"):
        assert re.search(rf"^\| [^|]*`{name}`[^|]* \|", README, re.MULTILINE), name
