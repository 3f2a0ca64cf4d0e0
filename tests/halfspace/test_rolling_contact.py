"""Forces on one grid against CONTACT on the same cells."""

import numpy as np
import pytest

from tests.helpers.creep import contact_cells, errors, stored
from wrcontact.halfspace.rolling import PressureField, contact_of_slip, rigid_slip

CASES = stored("hertz.json")
PATCHES = stored("contact_patches.json")
#: CONTACT takes the rigid slip of a cell this share of a cell upstream of its middle.
OFFSET = 1.0 / 6.0
#: Of the friction limit: both solve one problem of finite size; CONTACT's pressures are solved on the grid
#: too, ours are means of Hertz's ellipse.
TOLERANCE = 3e-3
#: Of the friction limit (and of its moment at 5 mm), on CONTACT's own pressures.
SAME_PROBLEM = 2e-5


def name(case):
    return f"a/b {case['a_over_b']} {case['family']} {case['level']}"


@pytest.mark.parametrize("case", CASES["cases"], ids=name)
@pytest.mark.turns(3)
def test_forces_are_contacts_on_its_cells(case):
    meta, a, b = CASES["meta"], 1e-3 * case["a_mm"], 1e-3 * case["b_mm"]
    creep, truth = case["creep"], case["contact"]
    field = contact_cells(a, b, truth["FN"])
    slip = rigid_slip(field, creep["xi"], creep["eta"], 1e3 * creep["phi_per_mm"], OFFSET)
    found = contact_of_slip(
        field, slip, friction=meta["mu"], shear_modulus=1e6 * meta["G_MPa"], poisson_ratio=meta["nu"]
    )
    wanted = [truth[name] for name in ("Fx", "Fy", "Mz")]
    apart = errors(found, wanted, meta["mu"] * truth["FN"], np.sqrt(a * b))
    assert max(np.hypot(*apart[:2]), abs(apart[2])) < TOLERANCE, (name(case), apart)


@pytest.mark.parametrize(
    "number",
    [
        pytest.param(number, marks=[pytest.mark.complete] if number % 4 else [])
        for number in range(len(PATCHES["patches"][0]["cases"]))
    ],
)
@pytest.mark.parametrize("patch", PATCHES["patches"], ids="{0[y_shift_mm]} mm".format)
def test_forces_on_contacts_own_pressures(patch, number):
    """Both solve the same finite problem, on the same pressures: the bar is CONTACT's stopping criterion and
    its seven printed digits."""
    meta, grid = PATCHES["meta"], patch["grid"]
    field = PressureField.of_cells(
        1e-3 * (grid["x_first"] + grid["dx"] * np.arange(grid["nx"])),
        1e-3 * (grid["y_first"] + grid["dy"] * np.arange(grid["ny"])),
        1e6 * np.array(patch["pressure_MPa"]),
    )
    case = patch["cases"][number]
    truth = case["contact"]
    slip = rigid_slip(field, case["xi"], case["eta"], 1e3 * case["phi_per_mm"], OFFSET)
    found = contact_of_slip(
        field, slip, friction=meta["mu"], shear_modulus=1e6 * meta["G_MPa"], poisson_ratio=meta["nu"]
    )
    wanted = [truth[name] for name in ("Fx", "Fy", "Mz")]
    apart = errors(found, wanted, meta["mu"] * truth["FN"], 5e-3)
    assert np.abs(apart).max() < SAME_PROBLEM, (patch["y_shift_mm"], case["xi"], case["eta"], apart)
