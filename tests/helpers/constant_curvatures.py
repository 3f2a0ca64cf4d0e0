"""Hertz's contact by scipy, and the kernel's nodes on a gap of constant curvatures."""

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipkm1

from wrcontact.kernel import layout
from wrcontact.kernel.binding.hertz_table import hertz_table
from wrcontact.kernel.binding.influence_table import influence_table
from wrcontact.kernel.contact import regions
from wrcontact.kernel.normal.node_coefficients import weigh_nodes

MODULUS = 210e9 / (2 * (1 - 0.28**2))


def hertz(A, B, force):
    """Penetration, semi-axes a (along), b (across) and peak pressure of Hertz's contact by scipy's elliptic
    integrals.

    Johnson (1985), eq. (4.24)-(4.32), with separation A x^2 + B s^2.
    """
    small, large = min(A, B), max(A, B)

    def mismatch(log_q):
        q = np.exp(log_q)
        K, E = ellipkm1(q * q), ellipe(1 - q * q)
        return (K - E) / (E / q**2 - K) - small / large

    q = 1.0
    if small < large:
        q = np.exp(brentq(mismatch, np.log(1e-6), np.log(1 - 1e-9), xtol=1e-15, rtol=1e-15))
    K, E = ellipkm1(q * q), ellipe(1 - q * q)
    L = (2 * E / (np.pi * q**2)) ** (1 / 3)
    scale = (0.75 * force / (MODULUS * (A + B))) ** (1 / 3)
    a, b = (L * scale, q * L * scale) if A < B else (q * L * scale, L * scale)
    penetration = 2 * K / (np.pi * L) * ((0.75 * force / MODULUS) ** 2 * (A + B)) ** (1 / 3)
    return penetration, a, b, 1.5 * force / (np.pi * a * b)


def lay_constant_curvatures(A, B, force, half_nodes=15, window=3, strips=24, sweeps=2):
    """The kernel's tables, workspace and state, as records, with nodes on the gap B s^2 and constant A,
    written by hand; and Hertz's penetration [m]."""
    parts = {"hertz": hertz_table(), "influence": influence_table()}
    array = np.concatenate([np.zeros(layout.SETTING_COUNT), *parts.values()])
    tables = layout.Tables.at(array)
    tables.contact_modulus, tables.strips, tables.sweeps = MODULUS, strips, sweeps
    offset = layout.SETTING_COUNT
    for name, table in parts.items():
        setattr(tables, name, offset)
        offset += len(table)
    work, state = layout.Work.at(np.zeros(layout.WORK_SIZE)), layout.State.at(np.zeros(layout.STATE_SIZE))
    penetration = hertz(A, B, force)[0]
    half_width = np.sqrt(penetration / B)
    region = work.regions[0]
    regions.incline_region(tables, region, 0.0)      # one plane: all of penetration and load
    region.spacing = half_width / half_nodes
    last = half_nodes + 2
    region.low, region.high = -1.0, 1.0
    region.first, region.last = -last, last
    region.width_low = region.width_high = half_width
    region.side_low = region.side_high = B
    for k in range(-last - window, last + window + 1):
        work.nodes[0].gap[k] = B * (region.spacing * k) ** 2
        work.nodes[0].A[k] = A
    weigh_nodes(tables, region, work.nodes[0], window, 0)
    return tables, work, state, penetration
