"""Hertz's contact of one side in closed form: one elliptic patch with the curvatures at the contact point."""

from math import isfinite, pi, sqrt

from ..contact.planes import locate_along_track
from ..layout import RULE_ELLIPSE, Contact, Region, SideOutputs, SolvedPatches, Tables
from ..patch.filling import fill_single, place_patch
from .hertz import hertz_coefficients, hertz_stiffness
from .node_coefficients import FLOOR


def hertz_contact(tables: Tables, contact: Contact, point: SideOutputs, force: float, prescribed: float):
    """Fill the solved patches by Hertz's ellipse; penetration [m], number of regions, 1, and
    1: the force is satisfied."""
    locate_along_track(tables, contact.frame, contact.regions, 1)
    penetration = solve_hertz(tables, point, contact.regions[0], contact.solved, force, prescribed)
    return penetration, 1, 1


def solve_hertz(tables: Tables, point: SideOutputs, region: Region, solved: SolvedPatches, force: float,
                prescribed: float):
    """Fill the solved patches with Hertz's ellipse under ``force`` [N], or at the ``prescribed`` penetration
    [m] if that is a number; the penetration [m].

    point : the outputs of the side, which describe its contact point.
    region : the region at this point.

    A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
    """
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
    area = pi * half_length * half_width
    patch = solved.patches[0]
    place_patch(patch, region, 0, RULE_ELLIPSE, point.contact_angle)
    totals = patch.totals
    totals.load = load
    totals.area = area
    totals.moment = 0.0
    totals.centroid = 0.0
    totals.max_pressure = 1.5 * load / area
    totals.max_half_length = half_length
    totals.start = -half_width
    totals.stop = half_width
    totals.width = 2.0 * half_width
    fill_single(solved)
    return penetration
