"""How deep a pressed wheel overlaps the rail, against the surface of revolution by dense search and against
Hertz's contact of circles."""

import math
from functools import cache

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import wrcontact
from data import brute_force
from data.hertz import hertz
from tests.helpers.elastic import compliant, elastic
from tests.helpers.inside import tables_of, work_of
from tests.helpers.overlap import deepest
from wrcontact.kernel import layout
from wrcontact.kernel.contact.curves import abscissa_after, rail_length, rail_way
from wrcontact.kernel.surface.tables import height_slope
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc


def test_stations_run_along_the_rail_from_abscissa_to_abscissa():
    """The way to an abscissa leads to just this one, and is within 1e-8 m of the arc length, by quadrature."""
    pair = layout.Tables.at(tables_of(elastic())).pairs[1]
    rail, rng = pair.rail, np.random.default_rng(2)
    for low, high in np.sort(rng.uniform(rail.start, rail.stop, (200, 2))):
        for x in (low, high):
            assert abscissa_after(pair, rail_way(pair, x)) == pytest.approx(x, abs=1e-14), (low, high)
    for low in rng.uniform(rail.start, rail.stop - 8e-3, 40):
        high = low + rng.uniform(1e-3, 8e-3)
        arc = quad(lambda x: math.hypot(1.0, height_slope(rail, x)[1]), low, high, limit=200, epsabs=1e-10)[0]
        assert rail_length(pair, low, high) == pytest.approx(arc, abs=2e-8), (low, high)
    assert abscissa_after(pair, -1e-3) == pytest.approx(rail.start - 1e-3, abs=1e-15)


# --- overlap, by dense search ---------------------------------------------------------------------


OVERLAPS = [
    (0.0, 0.0),
    (2e-3, 0.01),
    (4.95e-3, 0.0),
    (5.2e-3, 0.0175),
    (6e-3, 0.0),
    (6.15e-3, 0.0175),
    (7e-3, 0.02),
    (-6e-3, 0.03),
    (6.6e-3, -0.05),
]


@pytest.mark.parametrize("shift, yaw", OVERLAPS)
def test_overlap_is_that_of_the_surface_of_revolution(shift, yaw):
    """Every region's deepest point along the rail's normals, at the pose where the wheelset carries FORCE."""
    stand = elastic().evaluate(shift, yaw)
    stepper, track = compliant().stepper(), brute_force.track()
    stepper.inputs[:7] = shift, yaw, 0.0, 0.0, 0.0, stand.vertical_shift, stand.roll
    assert stepper.step() == 0
    overlap = work_of(stepper).contact.overlap
    points = overlap.points[: overlap.count]
    pose = brute_force.Pose(shift, yaw, stand.roll, stand.vertical_shift)
    for point in points:  # of the right wheel, which came last
        depth, _, abscissa = deepest(track, pose, point.rail)
        assert point.depth == pytest.approx(depth, abs=1e-11)  # [m]; measured 5e-13
        assert point.rail == pytest.approx(abscissa, abs=1e-7)
    state = compliant().evaluate(shift, yaw, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    assert state.right.penetration == max(point.depth for point in points)
    assert deepest(track, pose.mirrored(), state.left.contact.y_rail)[0] == pytest.approx(
        state.left.penetration, abs=1e-11
    )
    assert len(points) == (2 if shift in (4.95e-3, 5.2e-3, 6.15e-3) else 1)


@pytest.mark.parametrize("height", [-29e-6, -14e-6, 4e-6])
def test_a_region_ends_at_the_saddle_before_the_next_one(height):
    """A flange and the tread 8 mm beside it: Newton's long step from the saddle's first guess did not meet the wheel,
    the region was cut through its middle, and carried 121 kN for 218 kN.  The witness is the half-space."""
    pose = {"lateral_shift": 5.881725482e-3, "yaw": -43.47194655e-3}
    pose |= {"vertical_shift_input": height, "roll_input": -0.35846827e-3}
    true = compliant(rail="60E1", normal_model=wrcontact.Halfspace(tolerance=0.02)).evaluate(**pose).right
    for model, share in (("analyn", 0.06), ("analyn_strip", 0.02)):
        found = compliant(rail="60E1", normal_model=model).evaluate(**pose).right
        assert found.normal_force == pytest.approx(true.normal_force, rel=share)
        assert found.patches[0].contact_angle == pytest.approx(true.patches[0].contact_angle, abs=5e-3)
        assert found.patches[0].max_pressure == pytest.approx(true.patches[0].max_pressure, rel=0.13)


# --- Hertz, pressed down --------------------------------------------------------------------------


BALL, CROWN = 0.2, 0.09  # radii of wheel and rail profile [m]


@cache
def circles(**parameters):
    """A wheel and a rail of one circle each, that touch at 13 deg."""
    wheel = Profile("ball", "wheel", (Arc(-60.0, 60.0, 1e3 * BALL, 45.0, -199.0, +1),))
    rail = Profile("crown", "rail", (Arc(-36.0, 36.0, 1e3 * CROWN, 0.0, 1e3 * CROWN, -1),))
    return wrcontact.ContactSystem(
        wheel, rail, rail_inclination=0.0, gauge=1.4, gauge_depth=6e-3, **parameters
    )


@pytest.mark.parametrize("sink", [1e-6, 1e-5, 1e-4])
def test_a_ball_pressed_down_on_a_slope_is_hertz(sink):
    """Circles overlap by what their radii exceed the distance of their centres, sink
    cos(angle) to first order."""
    rigid = circles().evaluate()
    state = circles(contact_mode="compliant").evaluate(vertical_shift_input=rigid.vertical_shift + sink)
    angle = rigid.right.contact_angle
    assert state.status == 0 and abs(angle) > 0.1
    total = BALL + CROWN
    # of the centres, across and down
    apart = total * np.array([np.sin(angle), np.cos(angle)]) - [0.0, sink]
    depth = total - np.hypot(*apart)
    assert depth == pytest.approx(sink * math.cos(angle), rel=sink / total)
    A = 0.5 * math.cos(angle) / rigid.right.rolling_radius
    B = 0.5 * (1 / BALL + 1 / CROWN)
    force = brentq(lambda load: hertz(A, B, load)[0] - depth, 1e-3, 1e7, rtol=1e-13)
    for side in (state.left, state.right):
        assert side.penetration == pytest.approx(depth, abs=1e-13)
        # the gap is a circle's and not its parabola's: patch over radius squared, 1e-3
        assert side.normal_force == pytest.approx(force, rel=2e-3)
    again = circles(contact_mode="elastic").evaluate(normal_force=state.right.normal_force)
    assert again.vertical_shift == pytest.approx(state.vertical_shift, abs=1e-12)
