"""The page's way to step an FMU fast through fmpy."""

import re

import numpy as np

from tests.helpers.fmus import needs_compiler
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem


@needs_compiler
def test_the_example_of_the_page_steps_the_fmu(fmus, tmp_path, monkeypatch):
    """Run as it stands, beside the FMU; its values are those of Python, from the tread to the flange root."""
    page = (ROOT / "docs" / "guides" / "fmu.md").read_text(encoding="utf-8")
    (code,) = (
        block for block in re.findall(r"```python\n(.*?)```", page, re.DOTALL) if "fmi2GetReal" in block
    )
    (tmp_path / fmus[2].name).write_bytes(fmus[2].read_bytes())
    monkeypatch.chdir(tmp_path)
    seen = {}
    exec(code, seen)
    seen["fmu"].freeInstance()
    shifts = 5e-6 * np.arange(1000)
    wanted = ContactSystem().evaluate_many(lateral_shift=shifts, yaw=0.0, outputs=["force.y"])["force.y"]
    np.testing.assert_allclose(seen["lateral_force"], wanted, rtol=1e-9, atol=1e-6)
    assert np.ptp(wanted) > 1e3
