"""Many steps in the limit cycle between the flanges: no status, and the cycle stays what it is."""

import numpy as np
import pytest

from examples.hunting_wheelset.long_run import hunt, report


@pytest.mark.parametrize("steps", [20_000, pytest.param(1_000_000, marks=pytest.mark.complete)])
def test_no_status(archives, steps):
    """The wheels never leave the rails, nor does the contact fail; the real-time factor is printed."""
    run = hunt(archives, steps)
    print(report(run, steps))
    assert run.worst_status == 0
    assert np.isfinite(run.motion).all() and np.isfinite(run.forces).all()
    parts = np.array_split(run["lateral_shift"], steps // 10_000)
    sizes = [np.ptp(part) / 2 for part in parts[len(parts) // 2 :]]  # second by second
    # the flanges have 6.3 mm of play, which a wheelset that hunts uses
    assert np.all(np.abs(np.array(sizes) - sizes[0]) < 0.2e-3)
    assert 5.5e-3 < sizes[-1] < 6.5e-3
