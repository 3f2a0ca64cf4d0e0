"""A figure of the source as we find it, the wheelset in the variants that the figures
need, and tables of columns.

Everything in a :class:`SourceFigure` is in the units that people read: mm, deg, kN, MPa, 1/m.
"""

import csv
import math
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..storage.atomic import open_atomically
from ..system import ContactSystem
from .sections import Section, solve_analyn

FORCE = 78.5e3  #: normal force of every figure [N]
MODULUS = 210e9 / (2 * (1 - 0.28**2))  #: E* of source eq. (2.9) [Pa]
HOLDS, PARTLY, FAILS = "holds", "partly", "fails"  # verdicts
DS = 0.2e-3  #: the source's distance of nodes for lateral curvatures [m]
REACH = 3e-3  #: dyr of the circle fit [m]
DEGREE = 2  #: of the polynomial that replaces B <= 0; the source does not state it


@dataclass(frozen=True)
class SourceFigure:
    """A figure of the source as we find it.

    Attributes
    ----------
    number, title, short : "7.10", what the picture shows, and the same in a few words.
    claim, finding : what the source says of it, and what we find with exact geometry; sentences.
    verdict : of the claim: "holds", "partly" or "fails".
    key : the number to remember, with its unit, in a few words.
    numbers : what the finding rests on, by name with unit.
    columns : the table, by name with unit; arrays or lists (n,), of numbers or of
    words. NaN is an empty cell.
    """

    number: str
    title: str
    short: str
    claim: str
    finding: str
    verdict: str
    key: str
    numbers: dict
    columns: dict

    def write(self, path):
        """Write the columns to a CSV file, numbers with seven digits."""
        with open_atomically(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.columns)
            writer.writerows(
                [_cell(value) for value in row] for row in zip(*self.columns.values(), strict=True)
            )

    @property
    def curves(self):
        """Names of the curves in the table's order."""
        return list(dict.fromkeys(self.columns["curve"]))

    def curve(self, name, *columns):
        """These columns of a curve, arrays (n,)."""
        rows = [k for k, curve in enumerate(self.columns["curve"]) if curve == name]
        return tuple(np.array(self.columns[column])[rows] for column in columns)

    @property
    def stem(self):
        """Name of its files, "fig_7_10"."""
        return "fig_" + self.number.replace(".", "_")


def _cell(value):
    if isinstance(value, str):
        return value
    return f"{value + 0.0:.7g}" if math.isfinite(value) else ""


class Study:
    """The wheelset of the source's figures in every variant that they need; each is made once."""

    @cache
    def system(self, **parameters):
        """S1002 on UIC60 1:40, gauge 1435 mm, radius 460 mm, with other methods if ``parameters`` say so."""
        return ContactSystem(**parameters)

    @property
    def elastic(self):
        """The same with the wheelset in elastic equilibrium."""
        return self.system(contact_mode="elastic")

    @cache
    def section(self, shift):
        """:class:`~wrcontact.study.sections.Section` at a lateral shift [mm]."""
        return Section(self.system(), shift / 1e3)

    @cache
    def right(self, shift, yaw=0.0, **parameters):
        """The right wheel's contact under the load, at a lateral shift [mm] and yaw [deg]."""
        return (
            self.system(**parameters)
            .evaluate(lateral_shift=shift / 1e3, yaw=math.radians(yaw), normal_force=FORCE)
            .right
        )

    def complete(self, shift, yaw=0.0):
        """The same by the complete theory."""
        return self.right(shift, yaw, normal_model="halfspace")


def stacked(*tables):
    """One table (dict of columns) from several: rows below each other, empty cells
    where a column is missing."""
    names = list(dict.fromkeys(name for table in tables for name in table))
    columns = {name: [] for name in names}
    for table in tables:
        count = max(len(column) for column in table.values() if not isinstance(column, str))
        for name in names:
            values = table.get(name, math.nan)
            columns[name] += [values] * count if isinstance(values, (str, float)) else list(values)
    return columns


def listed(values, digits):
    """Numbers in words: "28.4, 25.5, 21.7"."""
    return ", ".join(f"{value:.{digits}f}" for value in values)


# ---------------------------------------------------------------------------------- patches as rows of tables


# Patches "as the source has them" are those of :mod:`~wrcontact.study.sections`; where the source only varies
# what the kernel also knows (longitudinal curvature, yaw) they are the kernel's. Beside them stands the
# complete theory.


def study_patch(nodes, section, B, correction=None):
    """ANALYN of the source on ``nodes`` with the lateral curvature ``B`` (n,) [1/m]."""
    return solve_analyn(
        nodes.station,
        np.maximum(nodes.gap, 0.0),
        section.longitudinal(nodes.wheel),
        B,
        force=FORCE,
        modulus=MODULUS,
        correction=correction,
    )


def patch_columns(curve, patch, margin=2):
    """Rows of a study's patch: its loaded nodes and ``margin`` beside them."""
    loaded = np.flatnonzero(patch.loaded)
    part = slice(max(loaded[0] - margin, 0), loaded[-1] + margin + 1)
    return {
        "curve": curve,
        "station [mm]": patch.station[part] * 1e3,
        "half length [mm]": patch.half_length[part] * 1e3,
        "pressure [MPa]": patch.pressure[part] / 1e6,
    }


def outline_columns(curve, side):
    """Rows of a kernel's patch."""
    outline = side.outline
    return {
        "curve": curve,
        "station [mm]": outline.station * 1e3,
        "half length [mm]": outline.half_length * 1e3,
        "pressure [MPa]": outline.pressure / 1e6,
    }


def sizes(name, side):
    """What one compares of a kernel's patch."""
    return {
        f"{name}: length [mm]": side.patch_length * 1e3,
        f"{name}: width [mm]": side.patch_width * 1e3,
        f"{name}: area [mm2]": side.area * 1e6,
        f"{name}: largest pressure [MPa]": side.max_pressure / 1e6,
        f"{name}: penetration [um]": side.penetration * 1e6,
    }


def study_sizes(name, patch):
    """The same of a study's patch; and how many nodes are loaded, in how many pieces, and
    whether the first point is."""
    return {
        f"{name}: length [mm]": patch.length * 1e3,
        f"{name}: width [mm]": patch.width * 1e3,
        f"{name}: penetration [um]": patch.penetration * 1e6,
        f"{name}: largest pressure [MPa]": patch.pressure.max() / 1e6,
        f"{name}: loaded nodes": int(patch.loaded.sum()),
        f"{name}: pieces": patch.regions,
        f"{name}: first contact point in the patch": int(patch.first_point_loaded),
    }


def percent(one, other):
    """By how many per cent ``one`` is above ``other``."""
    return 100 * (one / other - 1)
