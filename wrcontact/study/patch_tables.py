"""Patches of the source's figures as rows of tables.

Patches "as the source has them" are those of :mod:`~wrcontact.study.analyn` on nodes of
:mod:`~wrcontact.study.sections`; where the source only varies what the kernel also knows (longitudinal
curvature, yaw) they are the kernel's. Beside them stands the complete theory.
"""

import numpy as np

from .analyn import solve_analyn
from .figure import FORCE, MODULUS

DS = 0.2e-3         #: the source's distance of nodes for lateral curvatures [m]
REACH = 3e-3        #: dyr of the circle fit [m]
DEGREE = 2          #: of the polynomial that replaces B <= 0; the source does not tell it


def study_patch(nodes, section, B, correction=None, effective=True):
    """ANALYN of the source on ``nodes`` with the lateral curvature ``B`` (n,) [1/m]."""
    return solve_analyn(nodes.station, np.maximum(nodes.gap, 0.0),
                        section.longitudinal(nodes.wheel, effective), B, force=FORCE, modulus=MODULUS,
                        correction=correction)


def patch_columns(curve, patch, margin=2):
    """Rows of a study's patch: its loaded nodes and ``margin`` beside them."""
    loaded = np.flatnonzero(patch.loaded)
    part = slice(max(loaded[0] - margin, 0), loaded[-1] + margin + 1)
    return {"curve": curve, "station [mm]": patch.station[part] * 1e3,
            "half length [mm]": patch.half_length[part] * 1e3, "pressure [MPa]": patch.pressure[part] / 1e6}


def outline_columns(curve, side):
    """Rows of a kernel's patch."""
    outline = side.outline
    return {"curve": curve, "station [mm]": outline.station * 1e3,
            "half length [mm]": outline.half_length * 1e3, "pressure [MPa]": outline.pressure / 1e6}


def sizes(name, side):
    """What one compares of a kernel's patch."""
    return {f"{name}: length [mm]": side.patch_length * 1e3, f"{name}: width [mm]": side.patch_width * 1e3,
            f"{name}: area [mm2]": side.area * 1e6,
            f"{name}: largest pressure [MPa]": side.max_pressure / 1e6,
            f"{name}: penetration [um]": side.penetration * 1e6}


def study_sizes(name, patch):
    """The same of a study's patch; and how many nodes are loaded, in how many pieces, and
    whether the first point is."""
    return {f"{name}: length [mm]": patch.length * 1e3, f"{name}: width [mm]": patch.width * 1e3,
            f"{name}: penetration [um]": patch.penetration * 1e6,
            f"{name}: largest pressure [MPa]": patch.pressure.max() / 1e6,
            f"{name}: loaded nodes": int(patch.loaded.sum()), f"{name}: pieces": patch.regions,
            f"{name}: first contact point in the patch": int(patch.first_point_loaded)}


def percent(one, other):
    """By how many per cent ``one`` is above ``other``."""
    return 100 * (one / other - 1)
