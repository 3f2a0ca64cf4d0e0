"""Integrals over the cells between strips, against sums over fine parts of the same quadratics."""

import numpy as np
import pytest

from wrcontact.kernel.patch import quadrature

#: Values one cell further in, at the inner end and at the outer end: both signs, bent both ways, nearly straight.
VALUES = [
    (1.0, 0.8, 0.3),
    (0.4, 1.0, 0.9),
    (2.0, 0.5, 0.2),
    (1.0, 0.6, 0.2 + 1e-9),
    (1.1, 0.6, -0.5),
    (-2.0, -0.7, 0.4),
    (0.0, 0.0, 1.0),
    (3.0, 0.01, 0.02),
    (-3.0, 0.01, 0.02),
]


def bend_and_slope(before, low, high):
    """Of the quadratic through (-1, before), (0, low), (1, high), whose bend is at most half of both ends."""
    most = 0.5 * (abs(low) + abs(high))
    bend = float(np.clip(0.5 * (before + high) - low, -most, most))
    return bend, high - low - bend


@pytest.mark.parametrize("values", VALUES)
def test_integrals_are_those_of_fine_parts(values):
    bend, slope = bend_and_slope(*values)
    start, stop = quadrature.cell_part(*values)
    ends = np.array([0.0, start, stop, 1.0])
    at = np.linspace(0.0, 1.0, 4001)
    found = np.array([quadrature.quadratic_value(*values, x) for x in at])
    np.testing.assert_allclose(found, values[1] + at * (slope + at * bend), rtol=0, atol=1e-15)
    inside = (at > start + 1e-9) & (at < stop - 1e-9)
    assert np.all(found[inside] > 0.0) and np.all(found[(at < start - 1e-9) | (at > stop + 1e-9)] <= 0.0), (
        ends
    )
    for upper in (0.3, stop):
        x = np.linspace(0.0, upper, 4001)
        line = values[1] + x * (slope + x * bend)
        # the trapezoidal rule misses (width^2 / 12) times the change of the slope
        assert quadrature.quadratic_integral(*values, upper) == pytest.approx(np.trapezoid(line, x), abs=1e-7)
        assert quadrature.quadratic_moment(*values, upper) == pytest.approx(
            np.trapezoid(line * x, x), abs=1e-7
        )
    # places crowd at both ends, where the root may rise steeply
    x = start + (stop - start) * 0.5 * (1.0 - np.cos(np.linspace(0.0, np.pi, 20001)))
    root = np.sqrt(np.maximum(values[1] + x * (slope + x * bend), 0.0))
    # in closed form where it bends down
    exact = 2e-7 if bend < 0.0 else 0.01
    assert quadrature.root_integral(*values, start, stop) == pytest.approx(np.trapezoid(root, x), abs=exact)


def test_a_root_that_bends_up_is_missed_by_the_square_of_the_bend():
    """Of the expansion about the chord, between the values 1 and 0.7, in a part of the cell."""
    x, missed = np.linspace(0.1, 0.9, 4001), []
    for bend in (0.1, 0.05, 0.025):
        exact = np.trapezoid(np.sqrt(1.0 + x * (-0.3 - bend + x * bend)), x)
        missed.append(quadrature.root_integral(1.3 + 2.0 * bend, 1.0, 0.7, 0.1, 0.9) - exact)
    assert np.abs(missed[0]) < 3e-5
    np.testing.assert_allclose(np.divide(missed[:-1], missed[1:]), 4.0, rtol=0.1)


def test_an_ellipse_is_integrated_exactly():
    """A quarter of the unit circle's area, in one cell and in two parts of it."""
    values = (0.0, 1.0, 0.0)
    quarter = 0.25 * np.pi
    assert quadrature.root_integral(*values, 0.0, 1.0) < quarter  # its bend is limited
    assert quadrature.bent_integral(1.0, 0.0, -1.0, 0.0, 1.0) == pytest.approx(quarter, rel=1e-14)
    parts = [quadrature.bent_integral(1.0, 0.0, -1.0, *part) for part in ((-0.6, 0.3), (0.3, 1.0))]
    assert sum(parts) == pytest.approx(quarter + 0.5 * (0.6 * 0.8 + np.arcsin(0.6)), rel=1e-14)


def test_where_nothing_is_loaded_there_is_no_area():
    assert quadrature.cell_part(-1.0, -0.5, -0.1) == (0.0, 0.0)
    assert quadrature.root_integral(0.0, 0.0, 0.0, 0.0, 1.0) == 0.0
    for spread in (0.0, -1.0):  # an arch that touches zero, and one below it
        assert quadrature.bent_integral(0.25 * spread, 0.0, -1.0, -1.0, 1.0) == 0.0
