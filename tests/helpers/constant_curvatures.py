"""The kernel's nodes on a gap of constant curvatures, of which Hertz's contact is the solution."""

import numpy as np

from data.hertz import MODULUS, hertz
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import hertz_table, influence_table
from wrcontact.kernel.contact import frame
from wrcontact.kernel.normal.coefficients import weigh_nodes


def lay_constant_curvatures(A, B, force, half_nodes=15, window=3, strips=24, sweeps=2):
    """The kernel's tables and workspace, as records, with nodes on the gap B s^2 and constant A,
    written by hand; and Hertz's penetration [m]."""
    parts = {"hertz": hertz_table(), "influence": influence_table()}
    array = np.concatenate([np.zeros(layout.SETTING_COUNT), *parts.values()])
    tables = layout.Tables.at(array)
    tables.pairs[1].tables = tables
    tables.contact_modulus, tables.strips, tables.sweeps = MODULUS, strips, sweeps
    offset = layout.SETTING_COUNT
    for name, table in parts.items():
        setattr(tables, name, offset)
        offset += len(table)
    work = layout.Work.at(np.zeros(layout.WORK_SIZE))
    penetration = hertz(A, B, force)[0]
    half_width = np.sqrt(penetration / B)
    region = work.contact.regions[0]
    frame.incline_region(tables, work.contact.frame, region, 0.0)     # all of the load in one plane
    region.spacing = half_width / half_nodes
    last = half_nodes + 2
    region.low, region.high = -1.0, 1.0
    region.first, region.last = -last, last
    region.width_low = region.width_high = half_width
    region.side_low = region.side_high = B
    for k in range(-last - window, last + window + 1):
        work.contact.nodes[0].gap[k] = B * (region.spacing * k) ** 2
        work.contact.nodes[0].A[k] = A
    weigh_nodes(tables, region, work.contact.nodes[0], window, 0)
    return tables, work, penetration
