"""What the strips of a run have from their number alone, against closed forms of cosines."""

import numpy as np
import pytest

from tests.helpers.constant_curvatures import waves_table
from wrcontact.kernel import layout

COUNTS = (6, 7, 10, 16)


def waves_of(count):
    return layout.Waves.at(waves_table(count))


def table(rows, height, width):
    return np.array([list(rows[i][:width]) for i in range(height)])


def angles(count):
    return (np.arange(count) + 0.5) * np.pi / count


@pytest.mark.parametrize("count", COUNTS)
def test_places_of_strips_and_fine_strips(count):
    waves, t, fine = waves_of(count), angles(count), angles(3 * count)
    assert waves.count == count
    np.testing.assert_allclose(waves.cos[:count], np.cos(t), atol=1e-15)
    np.testing.assert_allclose(waves.sin[:count], np.sin(t), atol=1e-15)
    np.testing.assert_allclose(waves.fine_cos[: 3 * count], np.cos(fine), atol=1e-15)
    np.testing.assert_allclose(waves.fine_sin[: 3 * count], np.sin(fine), atol=1e-15)
    np.testing.assert_allclose(waves.spread[:count], np.log(count / (np.pi * np.sin(t))), atol=1e-14)


@pytest.mark.parametrize("count", COUNTS)
def test_logarithms_of_cosines_are_exact(count):
    """The integral of ln|cos t - cos u| cos(m u) over u is -pi/m cos(m t), and -pi ln 2 for m = 0: what the
    rule of points leaves out of it, eq. (S11)."""
    waves, t = waves_of(count), angles(count)
    apart = np.abs(np.subtract.outer(np.cos(t), np.cos(t)))
    logarithm = np.log(np.where(apart > 0.0, apart, 1.0))
    # twice the logarithm, as the kernel has it, and per weight pi / n
    found = np.pi / count * (2.0 * logarithm + table(waves.singular, count, count))
    for m in range(count):
        wanted = -2.0 * np.pi / m * np.cos(m * t) if m else -2.0 * np.pi * np.log(2.0) * np.ones(count)
        np.testing.assert_allclose(found @ np.cos(m * t), wanted, atol=1e-12)


@pytest.mark.parametrize("count", COUNTS)
def test_smooth_functions_are_read_at_edges_and_between_strips(count):
    """Cosines below the number of strips, which are all polynomials below that degree."""
    waves, t, fine = waves_of(count), angles(count), angles(3 * count)
    refining, smoothing = table(waves.refining, 3 * count, count), table(waves.smoothing, count, 3 * count)
    for degree in range(count):
        here, there = (0.7 - np.cos(t)) ** degree, (0.7 - np.cos(fine)) ** degree
        size = 1.7**degree
        np.testing.assert_allclose(refining @ here, there, atol=1e-13 * size)
        np.testing.assert_allclose(smoothing @ there, here, atol=1e-13 * size)
        assert np.dot(waves.start[:count], here) == pytest.approx((0.7 - 1.0) ** degree, abs=1e-13 * size)
        assert np.dot(waves.stop[:count], here) == pytest.approx(1.7**degree, abs=1e-13 * size)


@pytest.mark.parametrize("count", COUNTS)
def test_what_is_too_fine_for_strips_is_rough_and_no_more(count):
    """Cosines from the number of strips on give nothing to the strips' gap, and m times themselves to the
    roughness, eq. (S13); those below give it nothing."""
    waves, fine = waves_of(count), angles(3 * count)
    smoothing, roughness = (
        table(rows, height, 3 * count)
        for rows, height in ((waves.smoothing, count), (waves.roughness, 3 * count))
    )
    for m in range(3 * count):
        wave = np.cos(m * fine)
        if m >= count:
            np.testing.assert_allclose(smoothing @ wave, 0.0, atol=1e-13)
        np.testing.assert_allclose(roughness @ wave, m * wave if m >= count else 0.0, atol=1e-11)
