"""Correction of the strip model: its error in force and stick share for an ellipse, against the complete theory.

For the ellipse with the patch's area and length over width, r = a/b, the saturation

    s1 = -xi ab G C11/(mu N),   s2 = -eta ab G C22/(mu N),
    s3 = -phi (ab)^1.5 G C23/(mu N) sqrt(1 + 0.66 r^-2.7)                                        (D1)

is mirrored until s1 and s3 are not negative, and taken in polar coordinates: its length R as R / (1 + R), its
elevation arctan(s1 / sqrt(s2^2 + s3^2)) and its azimuth arctan2(s3, s2).  Over these and ln r the table holds
the force over mu N, the moment over mu N sqrt(ab) and the stick share that are missing; between its nodes
they follow straight lines along each coordinate.  The force is then cut to mu N, the stick share to 0 ... 1.

Three kinks would lie where a wheelset that runs straight has its creepages, and are none: from the origin on
the first step of z = R / (1 + R), up to z1, is a parabola, T (z/z1)^2 with the table's T, beside which

    L s (1 - z/z1) / (1 + R)                                                                      (D2)

counts, with L what the strips lack of linear theory per saturation s; so is the first step of the elevation for all but the longitudinal force, which are even
in s1; and beside s2 = 0 the azimuth's straight lines are bent until they meet with one slope.

s3 is zero on both sides of the azimuth's ends, where the table's values change over into their mirror images;
so the correction is continuous all over.
"""

from math import fabs, pi, sqrt
from typing import Final

from ..elementary.circle import atan2
from ..elementary.powers import exp, log
from ..layout import (
    CORRECTION_AXES,
    CORRECTION_AZIMUTHS,
    CORRECTION_COLUMNS,
    CORRECTION_ELEVATIONS,
    CORRECTION_LINE,
    CORRECTION_RADII,
    CORRECTION_RATIOS,
    Patch,
    RollingTable,
    Tables,
)
from ..surface.tables import table_cell
from .tractions import cut_to, kalker_coefficients

ELEVATION_STRIDE: Final[int] = CORRECTION_AZIMUTHS * CORRECTION_LINE
RATIO_STRIDE: Final[int] = CORRECTION_ELEVATIONS * ELEVATION_STRIDE
#: The azimuth of s2 = 0.
MIDDLE_AZIMUTH: Final[int] = (CORRECTION_AZIMUTHS - 1) // 2
#: ln 0.1, of the smallest a/b of the table; each one is twice the one before.
LN_FIRST_RATIO: Final[float] = -2.302585092994045684
#: Nodes of the elevation are 22.5 degrees apart, with one more in the first interval.
PER_RADIAN: Final[float] = 2.54647908947032537230  # 8 / pi
PER_DOUBLING: Final[float] = 1.44269504088896340736  # 1 / ln 2


def correct_force(tables: Tables, patch: Patch, share: float):
    """Add to a patch's force, moment and stick share what is missing; its friction has fallen to a ``share``
    of that of rest."""
    table = tables.rolling
    bound = patch.friction * patch.totals.load * share
    mean_axis = sqrt(patch.half_length * patch.half_width)
    ratio, on_ratio = table_cell(
        (log(patch.half_length / patch.half_width) - LN_FIRST_RATIO) * PER_DOUBLING,
        float(CORRECTION_RATIOS - 1),
    )
    along, across, turning = saturation(tables, patch, ratio, on_ratio)
    sign_x = 1.0
    if along < 0.0:
        sign_x = -1.0
        along = -along
    sign_y = 1.0
    if turning < 0.0:
        sign_y = -1.0
        across = -across
        turning = -turning
    at, on_elevation, on_azimuth, on_radius, faint = node_at(table, along, across, turning)
    if faint > 0.0:
        scale = faint * bound
        patch.creep_x += scale * sign_x * slope_at(table, 0, ratio, on_ratio) * along
        patch.creep_y += (
            scale
            * sign_y
            * (slope_at(table, 1, ratio, on_ratio) * across + slope_at(table, 2, ratio, on_ratio) * turning)
        )
        patch.creep_moment += (
            scale
            * sign_y
            * mean_axis
            * (slope_at(table, 3, ratio, on_ratio) * across + slope_at(table, 4, ratio, on_ratio) * turning)
        )
    at += ratio * RATIO_STRIDE
    beyond, bend = middle_bend(at, on_azimuth)
    patch.creep_x += (
        sign_x * bound * missing(table, at, on_ratio, on_elevation, on_azimuth, bend, beyond, on_radius)
    )
    if at % RATIO_STRIDE < ELEVATION_STRIDE:
        on_elevation *= on_elevation
    patch.creep_y += (
        sign_y * bound * missing(table, at + 1, on_ratio, on_elevation, on_azimuth, bend, beyond, on_radius)
    )
    turned = missing(table, at + 2, on_ratio, on_elevation, on_azimuth, bend, beyond, on_radius)
    patch.creep_moment += sign_y * bound * mean_axis * turned
    patch.stick_share += missing(table, at + 3, on_ratio, on_elevation, on_azimuth, bend, beyond, on_radius)
    patch.stick_share = min(max(patch.stick_share, 0.0), 1.0)
    force_x, force_y = cut_to(patch.creep_x, patch.creep_y, bound)
    patch.creep_x = force_x
    patch.creep_y = force_y


def saturation(tables: Tables, patch: Patch, cell: int, share: float):
    """s1, s2, s3 of eq. (D1), with the coefficients that the table was made with; ``cell`` and ``share`` are
    the patch's place among the table's ratios a/b."""
    ratio = patch.half_length / patch.half_width
    area = patch.half_length * patch.half_width
    first, second, third = kalker_coefficients(tables.rolling, ratio)
    scale = -area * tables.shear_modulus / (patch.friction * patch.totals.load)
    wide = sqrt(1.0 + 0.66 * exp(-2.7 * log(ratio)))
    at = 3 * cell
    return (
        scale * first * scale_at(tables.rolling, at, share) * patch.creepage_x,
        scale * second * scale_at(tables.rolling, at + 1, share) * patch.creepage_y,
        scale * sqrt(area) * third * scale_at(tables.rolling, at + 2, share) * patch.spin * wide,
    )


def scale_at(table: RollingTable, at: int, share: float):
    """A scale of the table between two ratios."""
    return table.scales[at] + share * (table.scales[at + 3] - table.scales[at])


def node_at(table: RollingTable, along: float, across: float, turning: float):
    """Where the cell of a saturation begins in the corrections of a ratio, where in it that lies, and how much
    the slopes at no creepage count; ``along`` and ``turning`` are not negative."""
    flat = sqrt(across * across + turning * turning)
    radius = sqrt(flat * flat + along * along)
    place = atan2(along, flat) * PER_RADIAN
    elevation, on_elevation = table_cell(place + min(place, 1.0), float(CORRECTION_ELEVATIONS - 1))
    azimuth, on_azimuth = table_cell(
        atan2(fabs(turning), across) / pi * float(CORRECTION_AZIMUTHS - 1), float(CORRECTION_AZIMUTHS - 1)
    )
    cell, on_radius = radius_cell(table, radius / (1.0 + radius))
    faint = 0.0
    if cell == 0:
        faint = (1.0 - on_radius) / (1.0 + radius)
        on_radius *= on_radius
    at = elevation * ELEVATION_STRIDE + azimuth * CORRECTION_LINE + cell * CORRECTION_COLUMNS
    return at, on_elevation, on_azimuth, on_radius, faint


def slope_at(table: RollingTable, axis: int, ratio: int, share: float):
    """One of the slopes at no creepage, between two ratios."""
    at = CORRECTION_AXES * ratio + axis
    return table.slopes[at] + share * (table.slopes[at + CORRECTION_AXES] - table.slopes[at])


def radius_cell(table: RollingTable, place: float):
    """The cell that holds R / (1 + R) = ``place``, and where in it."""
    cell = 0
    while cell < CORRECTION_RADII - 2 and place >= table.radii[cell + 1]:
        cell += 1
    return cell, (place - table.radii[cell]) / (table.radii[cell + 1] - table.radii[cell])


def middle_bend(at: int, on_azimuth: float):
    """Where the third node lies that the azimuth's straight line in the cell ``at`` is bent by, and how much:
    beside s2 = 0, where both lines get the mean of their slopes; elsewhere by nothing."""
    azimuth = at % ELEVATION_STRIDE // CORRECTION_LINE
    beyond = 0
    bend = 0.0
    if azimuth == MIDDLE_AZIMUTH:
        beyond = -CORRECTION_LINE
        bend = 0.5 * on_azimuth * (on_azimuth - 1.0)
    elif azimuth == MIDDLE_AZIMUTH - 1:
        beyond = 2 * CORRECTION_LINE
        bend = 0.5 * on_azimuth * (on_azimuth - 1.0)
    return beyond, bend


def missing(
    table: RollingTable,
    at: int,
    on_ratio: float,
    on_elevation: float,
    on_azimuth: float,
    bend: float,
    beyond: int,
    on_radius: float,
):
    """A number of the table, linear along all four coordinates of the cell that begins ``at``, but for the
    ``bend`` of the azimuth."""
    low = on_plane(table, at, on_elevation, on_azimuth, bend, beyond, on_radius)
    high = on_plane(table, at + RATIO_STRIDE, on_elevation, on_azimuth, bend, beyond, on_radius)
    return low + on_ratio * (high - low)


def on_plane(
    table: RollingTable,
    at: int,
    on_elevation: float,
    on_azimuth: float,
    bend: float,
    beyond: int,
    on_radius: float,
):
    """The same for one ratio."""
    low = on_cone(table, at, on_azimuth, bend, beyond, on_radius)
    high = on_cone(table, at + ELEVATION_STRIDE, on_azimuth, bend, beyond, on_radius)
    return low + on_elevation * (high - low)


def on_cone(table: RollingTable, at: int, on_azimuth: float, bend: float, beyond: int, on_radius: float):
    """The same for one elevation."""
    low = on_line(table, at, on_radius)
    high = on_line(table, at + CORRECTION_LINE, on_radius)
    found = low + on_azimuth * (high - low)
    if beyond < 0:
        found += bend * (on_line(table, at + beyond, on_radius) - low - (low - high))
    elif beyond > 0:
        found += bend * (on_line(table, at + beyond, on_radius) - high - (high - low))
    return found


def on_line(table: RollingTable, at: int, on_radius: float):
    """The same for one azimuth."""
    low = table.corrections[at]
    return low + on_radius * (table.corrections[at + CORRECTION_COLUMNS] - low)
