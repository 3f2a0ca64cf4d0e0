"""The smallest gap of profiles with corners and with points that are very close to each other."""

import numpy as np

import wrcontact
from tests.helpers.sampled_pair import SampledPair
from wrcontact.profiles import standard_profile

COLD = 1e-7  # [rad] a guess, so that no pose starts at the contacts of the one before


def fine_rail(step, digits):
    """UIC60 as points: every 0.25 mm, and ``step`` [mm] apart where its corner touches flanges; heights
    [mm] with so many digits behind the point."""
    y = np.unique(np.append(np.arange(-35.9, 35.9, 0.25), np.arange(-35.9, -33.0, step)))
    z = np.round(standard_profile("UIC60").height(y * 1e-3) * 1e3, digits)
    return wrcontact.Profile.from_points(y, z, name="fine", kind="rail")


def misses(system, pair, table, shift):
    """By how much the vertical shifts of poses without yaw are above the smallest gap of each wheel
    (n, 2) [m]."""
    return np.array(
        [
            [table.vertical_shift[k] - pair.smallest(sign * at, sign * table.roll[k])[0] for sign in (-1, 1)]
            for k, at in enumerate(shift)
        ]
    )


def test_points_five_micrometres_apart_hide_no_contact():
    """In the cell in which the rail ends, a bound of -1 1/m stood for a bend of -150 000 1/m: 81 of 400 such
    poses had status 2."""
    system = wrcontact.ContactSystem(rail=fine_rail(5e-3, 3))
    pair = SampledPair(system.wheel.zones, system.rail.zones)
    shift = np.linspace(6.28e-3, 6.36e-3, 24)
    table = system.evaluate_many(shift, roll_guess=COLD, outputs="geometry")
    assert not table.status.any()
    # the corner of the rail bends by up to 2e5 1/m over 10 um
    assert np.abs(misses(system, pair, table, shift)).max() < 1e-9
