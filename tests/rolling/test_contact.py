"""Forces on one grid against CONTACT on the same cells."""

import numpy as np
import pytest

from tests.helpers.creep import contact_cells, errors, stored
from wrcontact.reference.rolling import contact_of_slip, rigid_slip

CASES = stored("hertz.json")
#: CONTACT takes the rigid slip of a cell this share of a cell upstream of its middle.
OFFSET = 1.0 / 6.0
#: Of the friction limit: both solve one problem of finite size; CONTACT's pressures are solved on the grid
#: too, ours are means of Hertz's ellipse.
TOLERANCE = 3e-3


def check(case):
    meta, a, b = CASES["meta"], 1e-3 * case["a_mm"], 1e-3 * case["b_mm"]
    creep, truth = case["creep"], case["contact"]
    field = contact_cells(a, b, truth["FN"])
    slip = rigid_slip(field, creep["xi"], creep["eta"], 1e3 * creep["phi_per_mm"], OFFSET)
    found = contact_of_slip(field, slip, friction=meta["mu"], shear_modulus=1e6 * meta["G_MPa"],
                            poisson_ratio=meta["nu"])
    wanted = [truth[name] for name in ("Fx", "Fy", "Mz")]
    apart = errors(found, wanted, meta["mu"] * truth["FN"], np.sqrt(a * b))
    assert np.hypot(*apart[:2]) < TOLERANCE and abs(apart[2]) < TOLERANCE, (case["family"], case["level"], apart)


def name(case):
    return f"a/b {case['a_over_b']} {case['family']} {case['level']}"


@pytest.mark.parametrize("case", CASES["cases"][3::12], ids=name)
def test_forces_are_contacts_on_its_cells(case):
    check(case)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES["cases"], ids=name)
def test_all_forces_are_contacts_on_its_cells(case):
    check(case)
