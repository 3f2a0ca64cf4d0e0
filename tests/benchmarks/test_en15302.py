"""The benchmark of EN 15302: its reference profiles, curves and conicities (data/en15302)."""

import numpy as np
import pytest

from benchmarks import record, studies
from data import en15302
from data.en15302 import WHEELS
from tests.helpers.cases import MM
from tests.helpers.same_numbers import differences
from wrcontact.conditioning import equivalent_conicity
from wrcontact.profiles import standard_profile

#: Two slips of the transcription (data/en15302/README.md), which no limit and no test counts: a conicity, by its
#: amplitude, and a rolling radius difference, by its shift [m].
SLIPS = {"WheelCRailA": 4.2e-3}, {"WheelHRailA": 3.1e-3}


def printed(slips, case, places):
    """Which of the ``places`` [m] of a case are no slips."""
    return np.abs(places - slips.get(case, np.nan)) > 1e-9 if case in slips else np.full(len(places), True)


@pytest.mark.parametrize("case", WHEELS)
def test_every_amplitude_is_inside_the_limits(case):
    """A result inside either pair of limits passes the standard; there are 33 amplitudes, 1.0 ... 7.4 mm.

    At a corner of 0.175 at y = -10.23 mm wheel H once stood 0.1 mm deep in the rail, and 23 amplitudes passed.
    """
    reference, found = en15302.limits(case), en15302.found_conicity(case)
    assert len(found) == 33
    assert np.all(reference.inside_value(found) | reference.inside_shift(found))
    # all but one amplitude of one case, beside a step of the curve, keep the tolerance on the value
    assert np.count_nonzero(~reference.inside_value(found)) <= (case == "WheelHmodRailA")
    there = printed(SLIPS[0], case, reference.amplitude)
    assert np.mean(np.abs(found - reference.value)[there]) < 0.002  # measured 0.0003 ... 0.0018


@pytest.mark.parametrize("case", WHEELS)
def test_the_rolling_radius_difference_is_the_standards(case):
    """Points of the reference in the plane of shift and difference, both in mm, as distances from our curve.

    The curve has steps, where contacts jump: beside one a small shift is a large difference.
    """
    reference = np.array(en15302.radius_difference(case))
    reference = reference[:, printed(SLIPS[1], case, reference[0])]
    assert np.max(np.abs(reference[0])) >= 6.8 * MM
    off = en15302.distances(reference, en15302.found_curve(case)) / MM
    assert np.mean(off) < 0.003 and np.max(off) < 0.05  # [mm] measured up to 0.0022 and 0.040


@pytest.mark.parametrize("case", WHEELS)
def test_the_references_curves_have_its_conicities(case):
    """The integration alone, of the standard's own curve: also of different wheels left and right.

    The curve has a point every 0.1 mm, between which a step is a slope: all conicities are inside the limits,
    and those that no step is near are exact but for the printed digits.
    """
    shift, difference = en15302.radius_difference(case)
    there = printed(SLIPS[1], case, shift)
    reference = en15302.limits(case)
    found = equivalent_conicity(shift[there], difference[there], reference.amplitude)
    there = np.isfinite(found) & printed(SLIPS[0], case, reference.amplitude)  # larger ones leave the curve
    assert np.count_nonzero(there) >= 21
    inside = reference.inside_value(found) | reference.inside_shift(found)
    assert np.all(inside[there])
    assert np.median(np.abs(found - reference.value)[there]) < 0.0019  # measured 0.0002 ... 0.0018


@pytest.mark.parametrize(
    "kind, letter, low, high", [*((("wheel", k, -34, 29)) for k in "ABHI"), ("rail", "A", -28, 34)]
)
def test_zones_of_the_catalogue_are_the_points_of_another_transcription(kind, letter, low, high):
    """The points come from another project than the zones; at joints they lie on chords, such as at the corner of
    wheel H (16 um)."""
    y, z = np.loadtxt(en15302.FOLDER / f"{kind}_{letter}.csv", delimiter=",", skiprows=1).T
    y, z = y[(low < y) & (y < high)], z[(low < y) & (y < high)]
    exact = standard_profile(f"EN15302-{letter}" if kind == "wheel" else "EN15302-rail-A")
    off = np.abs(exact.height(y * MM) / MM + z)
    slope = np.hypot(1.0, exact.slope(y * MM))
    assert len(y) > 400 and np.max(off / slope) < 0.02 and np.median(off) < 0.0005  # [mm]


def test_a_shift_that_is_wrong_is_seen():
    """The limits would not pass curves that are 0.3 mm wider, nor another wheel's."""
    shift, difference = en15302.found_curve("WheelBRailA")
    reference = en15302.limits("WheelBRailA")
    for wrong in (shift * 1.05, shift + np.sign(shift) * 0.3 * MM):
        found = equivalent_conicity(
            np.unique(wrong), np.interp(np.unique(wrong), wrong, difference), reference.amplitude
        )
        assert not np.all(reference.inside_value(found) | reference.inside_shift(found))


def test_the_table_is_that_of_today():
    """docs/guides/check.md; if this fails: ``python -m benchmarks --write en15302``."""
    found, kept = record.short(studies.en15302_rows()), record.load("en15302")["rows"]
    assert differences(found, kept, absolute=2e-5) == []
