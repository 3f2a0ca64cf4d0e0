"""Extrapolated forces against another program's, and how the grid's error falls."""

import numpy as np
import pytest

from tests.helpers.creep import errors, forces, motion, stored, stored_patch
from wrcontact.halfspace.rolling import Outline, roll_ellipse, roll_outline, rolling_contact

pytestmark = pytest.mark.machine

ELLIPSES = stored("ellipses_extrapolated.json")["cases"]
PATCHES = stored("patches_extrapolated.json")
#: Of the friction limit: what either program's extrapolation from 24 and 48 cells is good to.
TOLERANCE = 2e-3


def check(case, found):
    apart = errors(
        found,
        [case[name] for name in ("Fx", "Fy", "Mz")],
        case["mu"] * case["N"],
        1e-3 * np.sqrt(case["a"] * case["b"]),
    )
    assert np.hypot(*apart[:2]) < TOLERANCE and abs(apart[2]) < TOLERANCE, (case["aob"], case["set"], apart)


@pytest.mark.parametrize("ratio", sorted({case["aob"] for case in ELLIPSES}), ids="a/b {}".format)
@pytest.mark.turns(3)
def test_ellipses(ratio):
    for case in ELLIPSES:
        if case["aob"] == ratio:
            check(case, roll_ellipse(1e-3 * case["a"], 1e-3 * case["b"], case["N"], **motion(case)))


def test_patches_of_profiles():
    for case in PATCHES["cases"]:
        patch = next(each for each in PATCHES["patches"] if abs(each["N"] - case["N"]) < 1e-3)
        check(case, roll_outline(stored_patch(patch), **motion(case)))


def test_the_error_is_of_first_order():
    """Forces on 16, 32 and 64 cells of a partly slipping patch: the differences halve (1.6 ... 2.4: stick
    and slip change cell by cell), and the extrapolated force moves by 0.3 % of the friction limit at most."""
    outline = Outline.of_ellipse(6e-3, 5e-3, 8e4)
    found = np.array(
        [
            forces(
                rolling_contact(
                    outline.on_grid(cells, cells),
                    creepage_x=-9e-4,
                    creepage_y=-7e-4,
                    spin=-0.2,
                    friction=0.3,
                    shear_modulus=82e9,
                    poisson_ratio=0.28,
                )
            )
            for cells in (16, 32, 64)
        ]
    )
    first, second = np.diff(found, axis=0)
    assert np.all((1.6 < first / second) & (first / second < 2.4)), first / second
    moved = (found[2] + second) - (found[1] + first)
    assert np.all(np.abs(moved[:2]) < 3e-3 * 0.3 * 8e4), (moved, second)
