"""The tables of the rail that is laid for a pose: bounds against samples, arc lengths against sums, and how much is laid."""

import numpy as np
import pytest

from tests.helpers.sections import moved, nose, stepped, stepper_on
from wrcontact import ContactSystem
from wrcontact.kernel import layout
from wrcontact.kernel.prepare.scan import FINE_STEP, FOOT_REACH
from wrcontact.kernel.search.bounds import WIDEST
from wrcontact.kernel.surface.tables import read_cubic
from wrcontact.profiles.compiled import evaluate_table

RAILS = {
    "nose": (lambda: nose(np.linspace(-0.1, 0.1, 21)), 0.75, dict(track_position=0.01, lateral_shift=-1e-3)),
    "ramp": (
        lambda: moved(np.linspace(-0.3, 0.6, 9), 0.03, 0.02),
        None,
        dict(track_position=0.1, lateral_shift=3e-3),
    ),
}


@pytest.fixture(scope="module", params=RAILS)
def laid(request):
    """The right pair of tables after a step, and what evaluates its rail."""
    make, lateral, inputs = RAILS[request.param]
    stepper = stepper_on(ContactSystem(rail_inclination=0.0), make(), lateral=lateral)
    assert stepped(stepper, **inputs)[0] == 0
    tables = layout.Tables.at(stepper._tables)
    pair = tables.pairs[1]
    first, last = (layout.offset(part, tables) for part in (pair.rail, pair.rail_arc))
    table = stepper._tables[first:last].copy()
    return pair, stepper, lambda x: np.array(evaluate_table(table, x))


def test_bounds_of_its_cells_hold(laid):
    pair, _, jet = laid
    scan, start, stop = pair.scan, pair.rail.start, pair.rail.stop
    for i in range(scan.rail_count):
        cell, edge = scan.rail[i], start + FINE_STEP * i
        x = np.clip(np.linspace(edge - FINE_STEP, edge + FINE_STEP + 1.5e-3, 301), start, stop)
        bend = jet(x)[2]
        assert cell.least_bend <= bend.min() and bend.max() <= cell.most_bend, i
        for exponent in range(layout.EXPONENTS + 1):
            length = FINE_STEP * (1.01 + (1.0 + WIDEST) * 1.01 * 2**exponent)
            x = np.clip(np.linspace(edge - 0.01 * FINE_STEP, edge + length, 301), start, stop)
            assert cell.least_bends[exponent] <= jet(x)[2].min(), (i, exponent)
            x = np.clip(np.linspace(edge - FOOT_REACH, edge + length + FOOT_REACH, 301), start, stop)
            _, slope, bend = jet(x)
            assert np.abs(slope * bend / (1.0 + slope**2)).max() <= cell.turns[exponent], (i, exponent)


def test_its_arc_lengths_are_sums(laid):
    """To what the cubics of the tables leave; the table of abscissae is the other way round."""
    pair, _, jet = laid
    x = np.linspace(pair.rail.start, pair.rail.stop, 20001)
    middle = 0.5 * (x[1:] + x[:-1])
    arc = np.r_[0.0, np.cumsum(np.diff(x) * np.sqrt(1.0 + jet(middle)[1] ** 2))]
    own = np.array([read_cubic(pair.rail_arc, one) for one in x[::500]])
    assert own - own[0] == pytest.approx(arc[::500], abs=3e-8)
    back = np.array([read_cubic(pair.rail_at_arc, one) for one in own])
    assert back == pytest.approx(x[::500], abs=3e-8)


def test_a_part_of_the_section_is_laid(laid):
    """Up to gaps of 0.8 mm: fewer than two lines of three."""
    sections = laid[0].sections
    assert sections.cut_first or sections.cut_last
    assert sections.last - sections.first < 0.67 * sections.knot_count
