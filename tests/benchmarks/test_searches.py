"""The searches side by side: what is told of errors and failures."""

import math

import pytest

import wrcontact
from benchmarks.studies import searches
from wrcontact.study import Search3D


@pytest.mark.check
def test_comparison_tells_errors_and_failures():
    system = wrcontact.ContactSystem()
    poses = [(shift, math.radians(2)) for shift in (1e-3, 6e-3)]
    row = searches.summary("3-D", True, list(searches.trials(system, Search3D(system, dx=1e-3), poses)))
    assert row.poses == 2 and [trial.shift for trial in row.failed] == [6e-3]
    assert row.roll_worst < 1e-6 and row.y_worst < 2e-4 and row.steps > 0 and row.units > 0


def test_comparison_prints_its_tables(capsys):
    searches.main(quick=True)
    text = capsys.readouterr().out
    assert text.count("\n| --- | --- |") == 6    # one under the head of each table
    assert "| denser nodes, dx and dy to 0.01 mm | 1 ... 3 deg | 0 of 4 |" in text
