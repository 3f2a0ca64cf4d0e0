"""Hertz's contact of one side: one elliptic patch in closed form, with the curvatures at the contact point.

The ellipse is no wider than wheel and rail.  Where the surfaces are nearly parallel, as in the flange root,
that of the contact point's curvatures would reach beyond the profiles: 120 mm under 90 kN.  There the lateral
curvature is the one whose ellipse ends where the first of both profiles does; penetration, load and pressure
are those of this ellipse.
"""

from math import isfinite, pi, sqrt
from typing import Final

from ..contact.curves import rail_length
from ..elementary.powers import cube_root
from ..layout import RULE_ELLIPSE, Contact, Frame, Pair, Region, SideSearch, Tables, seldom
from ..patch.filling import add_load, begin_patch, clear_patches, finish_patch, finish_patches
from .coefficients import FLOOR, hertz_coefficients, hertz_stiffness

#: Sharpest lateral over longitudinal curvature of an ellipse that is kept on the profiles [-].
SHARPEST: Final[float] = 1e3
#: Room for half of it [m] where the contact point is at the end of a profile.
NARROWEST: Final[float] = 1e-6
#: Steps in which it gets as narrow as the profiles leave room; each leaves a quarter of what is missed, or
#: less.
NARROWINGS: Final[int] = 30


def hertz_contact(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the only patch of a side by Hertz's ellipse under ``force`` [N], or at the ``prescribed``
    penetration [m] if that is a number; penetration [m], number of regions, 1, and 1: the force is satisfied.

    A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
    """
    region = contact.regions[0]
    point = side.point
    region.x_track = point.x_track
    A = 0.5 * point.curvature_x
    B = max(FLOOR * A, 0.5 * point.curvature_y)
    half_length, half_width, stiffness, penetration = press_ellipse(
        pair.tables, region, A, B, force, prescribed
    )
    low, high = profile_ends(pair, region)
    # no station is nearer than its abscissa
    widest = min(region.rail - low, high - region.rail)
    if half_width > widest:
        widest = widest_ellipse(pair, contact.frame, region, low, high)
    if half_width > widest:
        B = narrow_ellipse(pair.tables, region, A, B, force, prescribed, widest)
        half_length, half_width, stiffness, penetration = press_ellipse(
            pair.tables, region, A, B, force, prescribed
        )
    region.stiffness = 1.5 * stiffness * sqrt(penetration)
    region.carried = stiffness * penetration * sqrt(penetration)
    region.moment = 0.0
    region.slant = 0.0
    region.local_penetration = penetration
    if contact.filling:
        fill_ellipse(side, region, half_length, half_width)
    return penetration, 1, True


def fill_ellipse(side: SideSearch, region: Region, half_length: float, half_width: float):
    """Let the ellipse with these half-axes [m] be the only patch of a side."""
    clear_patches(side)
    load = region.carried
    patch = side.patches[begin_patch(side, region, -half_width, 0, RULE_ELLIPSE)]
    add_load(patch, 0, load, 0.0)
    patch.totals.area = pi * half_length * half_width
    patch.totals.stop = half_width
    pressure = 1.5 * load / patch.totals.area
    patch.pressure_square = pressure * pressure
    patch.half_length_square = half_length * half_length
    finish_patch(side)
    finish_patches(side)


def press_ellipse(tables: Tables, region: Region, A: float, B: float, force: float, prescribed: float):
    """Half-length and half-width [m], N / penetration^(3/2) [N/m^1.5] and penetration [m] of the ellipse for
    the separation A x^2 + B s^2 under ``force`` [N], as far as it counts in the region, or at the
    ``prescribed`` penetration [m] if that is a number."""
    one_alpha, one_beta, nr = hertz_coefficients(tables.hertz, A, B)
    stiffness = hertz_stiffness(one_beta, nr, B, tables.contact_modulus)
    penetration = prescribed
    if not isfinite(prescribed):
        root = cube_root(force / (region.share * stiffness))
        penetration = root * root
    return sqrt(penetration / (one_alpha * A)), sqrt(penetration / (one_beta * B)), stiffness, penetration


def profile_ends(pair: Pair, region: Region):
    """Abscissae of the rail [m] at which the first profile ends to either side of the contact point.  Below a
    patch both abscissae run alike (patch_places.py)."""
    low = max(pair.rail.start, region.rail - (region.wheel - pair.wheel.start))
    high = min(pair.rail.stop, region.rail + (pair.wheel.stop - region.wheel))
    return low, high


@seldom
def widest_ellipse(pair: Pair, frame: Frame, region: Region, low: float, high: float):
    """Distance [m] of the contact point from the nearer one of two ends, in stations of the patch: along the
    rail of a pressed wheel, else in the contact plane."""
    if frame.pressed:
        widest = min(rail_length(pair, low, region.rail), rail_length(pair, region.rail, high))
    else:
        widest = min(region.rail - low, high - region.rail) / frame.plane.cos
    return max(widest, NARROWEST)


@seldom
def narrow_ellipse(
    tables: Tables, region: Region, A: float, B: float, force: float, prescribed: float, widest: float
):
    """The lateral curvature [1/m] whose ellipse is ``widest`` [m] to either side, if it is not sharper than
    SHARPEST A; the arguments are those of :func:`press_ellipse`.

    The square of the half-width is nearly as 1/B: its logarithm falls by 0.8 ... 1.2 where that of B rises
    by 1, also under a force.
    """
    for narrowing in range(NARROWINGS):
        half_length, half_width, stiffness, penetration = press_ellipse(
            tables, region, A, B, force, prescribed
        )
        share = half_width / widest
        B = min(B * share * share, SHARPEST * A)
    return B
