"""Hertz's contact of one side in closed form: one elliptic patch with the curvatures at the contact point."""

from math import isfinite, pi, sqrt

from ..contact.planes import locate_along_track
from ..layout import RULE_ELLIPSE, Contact, SideSearch, Tables
from ..patch.filling import add_load, begin_patch, clear_patches, finish_patch, finish_patches
from .hertz import hertz_coefficients, hertz_stiffness
from .node_coefficients import FLOOR


def hertz_contact(tables: Tables, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the only patch of a side by Hertz's ellipse under ``force`` [N], or at the ``prescribed``
    penetration [m] if that is a number; penetration [m], number of regions, 1, and 1: the force is satisfied.

    A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
    """
    locate_along_track(tables, contact.frame, contact.regions, 1)
    region = contact.regions[0]
    point = side.point
    table = tables.hertz
    A = 0.5 * point.curvature_x
    B = 0.5 * point.curvature_y
    if not B > FLOOR * A:
        B = FLOOR * A
    stiffness = hertz_stiffness(table, A, B, tables.contact_modulus)
    penetration = prescribed
    if not isfinite(prescribed):
        penetration = (force / (region.share * stiffness)) ** (2.0 / 3.0)
    load = stiffness * penetration * sqrt(penetration)
    region.stiffness = 1.5 * stiffness * sqrt(penetration)
    region.carried = load
    region.moment = 0.0
    region.slant = 0.0
    region.local_penetration = penetration
    one_alpha, one_beta, nr = hertz_coefficients(table, A, B)
    half_length = sqrt(penetration / (one_alpha * A))
    half_width = sqrt(penetration / (one_beta * B))
    clear_patches(side)
    patch = side.patches[begin_patch(side, region, -half_width, 0, RULE_ELLIPSE, point.contact_angle)]
    add_load(patch, 0, load, 0.0)
    patch.totals.area = pi * half_length * half_width
    patch.totals.stop = half_width
    pressure = 1.5 * load / patch.totals.area
    patch.pressure_square = pressure * pressure
    patch.half_length_square = half_length * half_length
    finish_patch(side)
    finish_patches(side)
    return penetration, 1, True
