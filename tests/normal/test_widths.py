"""How oblique the patch of a yawed wheel is, against the surfaces themselves."""

import math

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid, quad
from scipy.optimize import brentq

import wrcontact
from data import brute_force
from tests.helpers.cases import FORCE, system
from tests.helpers.inside import tables_of, work_of
from tests.helpers.overlap import overlap
from wrcontact.kernel import layout
from wrcontact.kernel.normal import patch_places
from wrcontact.profiles.compiled import evaluate_table


def ridge(track, pose, abscissa):
    """Where along x the wheel overlaps the rail's point most, along the rail's normal there: a grid, and the
    parabola through its highest three values."""
    x = np.linspace(-0.06, 0.06, 2401)
    depth = overlap(track, pose, x, np.full_like(x, abscissa))
    k = np.argmax(depth)
    before, here, after = depth[k - 1 : k + 2]
    return x[k] + 0.5 * (x[1] - x[0]) * (before - after) / (before - 2.0 * here + after)


def abscissa_at(track, start, length):
    """The rail's abscissa at this arc length from ``start`` [m]."""

    def rest(y):
        return quad(lambda v: math.hypot(1.0, track.rail(v)[1]), start, y, epsabs=1e-12)[0] - length

    return brentq(rest, start - abs(length) - 1e-6, start + abs(length) + 1e-6, xtol=1e-12)


@pytest.mark.parametrize("shift, yaw", [(2e-3, 0.02), (5.2e-3, 0.0175), (7.5e-3, 0.03), (7.5e-3, -0.03)])
def test_the_ridge_of_a_yawed_wheel_s_patch_is_as_oblique_as_its_gap(shift, yaw):
    """Between both ends of the interpenetration, over the rail's arc length; up to 3 on a flange. The wheel
    has sunk to its estimated penetration."""
    stepper = system().stepper()
    stepper.inputs[:7] = shift, yaw, 0.0, FORCE, 0.0, 0.0, 0.0
    assert stepper.step() == 0
    contact = work_of(stepper).contact  # of the right wheel, which came last
    region, point = contact.regions[0], contact.overlap.points[0]
    state = system().evaluate(shift, yaw)
    track = brute_force.track()
    height = contact.frame.height  # to which it has sunk
    sunk = state.right.penetration / math.cos(state.right.contact_angle)
    assert height - state.vertical_shift == pytest.approx(sunk, rel=0.2)
    pose = brute_force.Pose(shift, yaw, state.roll, height)
    low, high = (abscissa_at(track, point.rail, way) for way in (-region.width_low, region.width_high))
    slant = (ridge(track, pose, high) - ridge(track, pose, low)) / (region.width_low + region.width_high)
    assert region.slant == pytest.approx(slant, rel=1e-3)
    assert 0.05 < abs(slant) < 4.0


def test_a_region_pushes_along_the_mean_normal_of_its_own_nodes():
    """Loaded all the way to its ends, beyond which the nodes are those of another one. Witness: the rail's unit
    normals by numpy, weighted by the loads."""
    wheelset = wrcontact.ContactSystem()
    tables = layout.Tables.at(tables_of(wheelset))
    contact = layout.Work.at(np.zeros(layout.WORK_SIZE)).contact
    nodes, region, pair = contact.nodes[0], contact.regions[0], tables.pairs[1]
    loads = np.random.default_rng(8).uniform(1.0, 2.0, 41)
    for rail, first, last in ((-0.03, -20, 20), (-0.02, -7, 20), (0.01, -20, 5)):
        for k in range(-30, 31):
            nodes.line[k], nodes.rise[k] = 1e6, 0.0
        for k in range(first, last + 1):
            nodes.line[k] = loads[k + 20]
        region.rail, region.spacing, region.first, region.last = rail, 1e-4, first, last
        patch_places.mean_normal(pair, contact.frame, region, nodes, 1e-5)
        y = np.linspace(rail - 5e-3, rail + 5e-3, 2001)
        _, slope, _ = evaluate_table(wheelset.profile_tables()[1], y)
        arc = cumulative_trapezoid(np.hypot(1.0, slope), y, initial=0.0)
        at = np.interp(np.interp(rail, y, arc) + 1e-4 * np.arange(first, last + 1), arc, np.arctan(slope))
        weights = loads[first + 20 : last + 21]
        wanted = [np.average(part(at), weights=weights) for part in (np.cos, np.sin)]
        assert [region.cos, region.sin] == pytest.approx(wanted, abs=1e-7), rail
