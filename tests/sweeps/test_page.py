"""Every block of docs/guides/tables.md runs, and says what happens."""

import re
import shlex

import pytest

from tests.helpers.paths import ROOT

PAGE = (ROOT / "docs" / "guides" / "tables.md").read_text(encoding="utf-8")
#: A cluster in this process, in place of one that is not there.
HERE = 'processes=False, n_workers=1, dashboard_address=":0"'


def test_the_page_runs(tmp_path, monkeypatch, capsys, run):
    pytest.importorskip("zarr")
    pytest.importorskip("distributed")
    monkeypatch.chdir(tmp_path)
    names, blocks = {}, re.findall(r"```(python|sh)\n(.*?)```", PAGE, re.DOTALL)
    assert [kind for kind, _ in blocks].count("python") == 6 and ("sh" in dict(blocks))
    for kind, text in blocks:
        if kind == "sh":
            command = shlex.split(text)
            assert command.pop(0) == "wrcontact"
            assert run(*command)[:2] == (0, "441 states in command.zarr: 441 valid\n")
        else:
            exec(text.replace('"tcp://scheduler:8786"', HERE), names)
    table, between = names["table"], names["between"]
    said = capsys.readouterr().out
    assert "normal_force is 90000.0 N, there 80000.0 N" in said and "441 poses, 0 of them without" in said
    made = {path.name for path in tmp_path.iterdir()}
    assert {"table.zarr", "command.zarr", "shared.zarr", "table.nc"} <= made
    assert int(names["data"]["status"].max()) == 0 and table.sizes == {"lateral_shift": 49, "yaw": 9}
    assert between.errors["right.area"].worst > 100 * between.errors["right.area"].median
