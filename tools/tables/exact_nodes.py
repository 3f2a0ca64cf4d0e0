"""Exact creep forces of ellipses at the nodes of the kernel's correction table.

A node is a ratio of half-axes and a vector of saturation

    s = (s1, s2, f s3),   s1 = -xi ab G C11 / mu N,   s2 = -eta ab G C22 / mu N,
    s3 = -phi (ab)^1.5 G C23 / mu N,   f = sqrt(1 + 0.66 r^-2.7),   r = a/b                           (R9)

given by its length rho, its elevation beta towards s1 and its azimuth alpha from s2 towards s3.  C are
Kalker's coefficients, of :func:`creep_coefficients`.
"""

import math
from itertools import product

import numpy as np

from wrcontact.creep.kalker_table import COEFFICIENTS, POISSON_NODES, asymptotes, parabola_weights
from wrcontact.halfspace.rolling.extrapolation import COARSE_CELLS, roll_outline
from wrcontact.halfspace.rolling.pressure import Outline

#: Shorter over longer half-axis in the rows of Kalker's table.
RATIOS = tuple(k / 10 for k in range(1, 11))
RATIO = 0.1 * 2.0 ** np.arange(9)
BETA = np.radians([0.0, 11.25, 22.5, 45.0, 67.5, 90.0])
ALPHA = np.radians(np.arange(0.0, 181.0, 15.0))
RHO = np.array([0.25, 0.5, 0.75, 1.0, 1.35, 1.8, 2.5, 3.6, 5.5, 10.0])
#: Stored of each node: force along and across over mu N, moment over mu N sqrt(ab), share of the area that
#: sticks.
COLUMNS = ("force_x", "force_y", "moment", "stick_share")

# forces over mu N do not depend on these: only the ratio of half-axes and Poisson's ratio are left
_SHEAR_MODULUS = 80e9  # [Pa]
_NORMAL_FORCE = 1e5  # [N]
_FRICTION = 0.3
_MEAN_AXIS = 5e-3  # sqrt(ab) [m]


def creep_coefficients(half_length, half_width, poisson_ratio):
    """Kalker's C11, C22, C23 (3,) of an ellipse; its half-length lies along the rolling direction.

    Between the ratios of Kalker's table straight lines, unlike the smooth curves of the kernel: the stored
    tables were made with them.  1/C is a parabola of Poisson's ratio.  Ellipses beyond the table, g < 0.1,
    have its asymptotes.
    """
    ratio = half_length / half_width
    g = min(ratio, 1.0 / ratio)
    if g < RATIOS[0] * (1.0 - 1e-12):
        return asymptotes([math.log(ratio)], poisson_ratio)[:, 0]
    table = COEFFICIENTS[int(ratio > 1.0)]
    at_ratio = np.array([[np.interp(g, RATIOS, table[:, i, k]) for k in range(3)] for i in range(3)])
    return 1.0 / (parabola_weights(POISSON_NODES, poisson_ratio) / at_ratio).sum(axis=1)


def spin_factor(ratio):
    """f of (R9): spin uses up the friction of a wide patch at less linear force."""
    return math.sqrt(1.0 + 0.66 * ratio**-2.7)


def creepages(ratio, poisson_ratio, saturation):
    """(xi, eta, phi) of a vector of saturation s (3,), with the fixed load and size of this module. (R9)"""
    c11, c22, c23 = creep_coefficients(ratio, 1.0, poisson_ratio)
    scale = _FRICTION * _NORMAL_FORCE / (_MEAN_AXIS**2 * _SHEAR_MODULUS)
    s1, s2, s3 = saturation
    return (-s1 * scale / c11, -s2 * scale / c22, -s3 / spin_factor(ratio) * scale / (_MEAN_AXIS * c23))


def saturation(rho, beta, alpha):
    """Vector of saturation (3,) of a node."""
    flat = rho * math.cos(beta)
    return np.array([rho * math.sin(beta), flat * math.cos(alpha), flat * math.sin(alpha)])


def solve_line(line, poisson_ratio, cells=COARSE_CELLS):
    """COLUMNS of the nodes of one line (RHO, 4): ``line`` is (place in RATIO, in BETA, in ALPHA)."""
    ratio, beta, alpha = RATIO[line[0]], BETA[line[1]], ALPHA[line[2]]
    outline = Outline.of_ellipse(_MEAN_AXIS * math.sqrt(ratio), _MEAN_AXIS / math.sqrt(ratio), _NORMAL_FORCE)
    scale = np.array([1.0, 1.0, _MEAN_AXIS]) * _FRICTION * _NORMAL_FORCE
    found, forces = np.empty((len(RHO), len(COLUMNS))), None
    for place, rho in enumerate(RHO):
        xi, eta, phi = creepages(ratio, poisson_ratio, saturation(rho, beta, alpha))
        forces = roll_outline(
            outline,
            creepage_x=xi,
            creepage_y=eta,
            spin=phi,
            friction=_FRICTION,
            shear_modulus=_SHEAR_MODULUS,
            poisson_ratio=poisson_ratio,
            cells=cells,
            start=forces,
        )
        found[place, :3] = np.array([forces.force_x, forces.force_y, forces.moment]) / scale
        found[place, 3] = forces.stick_share
    return found


def lines():
    """The lines of nodes that are solved: those that symmetry gives are left out."""
    return [
        line
        for line in product(range(len(RATIO)), range(len(BETA)), range(len(ALPHA)))
        if line[2] < len(ALPHA) - 1 and (line[1] < len(BETA) - 1 or line[2] == 0)
    ]


def filled(found):
    """The whole table (ratio, beta, alpha, rho, column) from a dictionary of solved lines.

    At alpha = 180 degrees eta has changed its sign against alpha = 0: a mirrored patch, whose lateral force
    and moment change sign.  At beta = 90 degrees there is no eta and no spin, whatever alpha.
    """
    table = np.full((len(RATIO), len(BETA), len(ALPHA), len(RHO), len(COLUMNS)), np.nan)
    for line, values in found.items():
        table[line] = values
    table[:, :, -1] = table[:, :, 0] * (1.0, -1.0, -1.0, 1.0)
    table[:, -1] = table[:, -1, :1]
    return table
