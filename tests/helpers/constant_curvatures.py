"""The kernel's nodes and strips on a gap of constant curvatures, of which Hertz's contact is the solution."""

import functools

import numpy as np

from data.hertz import MODULUS, hertz
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import hertz_table, influence_table
from wrcontact.kernel.contact import frame
from wrcontact.kernel.normal.coefficients import weigh_nodes
from wrcontact.kernel.normal.strip_contact import start_runs, sweep_strips
from wrcontact.kernel.normal.strip_patches import fill_from_strips
from wrcontact.kernel.normal.strip_surfaces import INSET, SHALLOW, ZONE_STATIONS, bend_gaps, weigh_zone
from wrcontact.kernel.prepare.waves import write_waves


@functools.lru_cache
def waves_table(count):
    """Numbers of the kernel's table for runs of ``count`` strips (n,)."""
    numbers = np.zeros(layout.WAVES_SIZE)
    write_waves(layout.Waves.at(numbers), count)
    return numbers


def lay_constant_curvatures(A, B, force, half_nodes=15, window=3, strips=10, sweeps=6):
    """The kernel's tables and workspace, as records, with nodes on the gap B s^2 and constant A,
    written by hand; and Hertz's penetration [m]."""
    parts = {"hertz": hertz_table(), "influence": influence_table(), "waves": waves_table(strips)}
    array = np.concatenate([np.zeros(layout.SETTING_COUNT), *parts.values()])
    tables = layout.Tables.at(array)
    tables.pairs[1].tables = tables
    tables.contact_modulus, tables.sweeps = MODULUS, sweeps
    offset = layout.SETTING_COUNT
    for name, table in parts.items():
        setattr(tables, name, offset)
        offset += len(table)
    work = layout.Work.at(np.zeros(layout.WORK_SIZE))
    penetration = hertz(A, B, force)[0]
    half_width = np.sqrt(penetration / B)
    region = work.contact.regions[0]
    frame.incline_region(tables, work.contact.frame, region, 0.0)  # all of the load in one plane
    region.spacing = half_width / half_nodes
    last = half_nodes + 2
    region.low, region.high = -1.0, 1.0
    region.first, region.last = -last, last
    region.width_low = region.width_high = half_width
    region.side_low = region.side_high = B
    for k in range(-last - window, last + window + 1):
        work.contact.nodes[0].gap[k] = B * (region.spacing * k) ** 2
        work.contact.nodes[0].A[k] = A
    weigh_nodes(tables, region, work.contact.nodes[0], window, 0, True)
    return tables, work, penetration


def trace_constant_curvatures(A, B, force, strips=10, sweeps=6, depth=1.0, share=1.0, stretch=1.0, gap=None):
    """The kernel's tables and workspace with the first runs of the strip model on the gap B s^2, or ``gap``
    (two functions of s, itself and its slope), and constant A, sunk by ``depth`` times Hertz's penetration;
    and that penetration [m].

    ``share`` of the penetration comes along the normal, and the curve between wheel and rail is ``stretch``
    times as long as the rail.
    """
    tables, work, exact = lay_constant_curvatures(A, B, force, strips=strips, sweeps=sweeps)
    contact, problem = work.contact, work.contact.strip_problem
    contact.frame.plane.cos, contact.filling = 1.0, True
    contact.frame.pressed = contact.frame.sunk = True
    problem.penetration = depth * exact
    zone = problem.zones[0]
    zone.depth = share * problem.penetration
    zone.stop = np.sqrt((1 - SHALLOW) * zone.depth / B)
    zone.start, zone.middle = -zone.stop, 0.0
    zone.spacing = (zone.stop - zone.start) / (ZONE_STATIONS - 1 + 2 * INSET)
    rise, slope = gap or (lambda s: B * s * s, lambda s: 2 * B * s)
    problem.traced_count = ZONE_STATIONS
    for i in range(ZONE_STATIONS):
        at = problem.traced[i]
        s = zone.start + (i + INSET) * zone.spacing
        at.region, at.joined, at.station, at.place = 0, i < ZONE_STATIONS - 1, s, stretch * s
        at.overlap, at.rise = zone.depth - rise(s), -slope(s)
        at.cos, at.A, at.share, at.counted, at.stretch = 1.0, A, share, 1.0, stretch
    bend_gaps(problem)
    weigh_zone(tables.pairs[1], problem, zone, A, 0, False)
    start_runs(tables.pairs[1], contact)
    return tables, work, exact


def sweep_constant_curvatures(tables, work, force):
    """Penetration [m], area [m2] and peak pressure [Pa] (3,) after all sweeps under ``force`` [N]."""
    contact, side = work.contact, work.sides[1]
    penetration = sweep_strips(tables.pairs[1], contact, tables.sweeps, force, False)
    fill_from_strips(tables, contact, side, 1)
    assert side.patch_count == 1
    np.testing.assert_allclose(side.totals.load, force, rtol=1e-12)
    return np.array([penetration, side.totals.area, side.totals.max_pressure])
