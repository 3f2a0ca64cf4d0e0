"""The normal contact of one side, by the model that is chosen: each one fills the patches of the side.

A further model is a file with a function like :func:`~.analyn_contact.analyn_contact`, and a branch here; see
``NormalModel`` in wrcontact/methods/normal.py for its duties.

Hertz's stands here: one elliptic patch in closed form, with the curvatures at the contact point.
"""

from math import isfinite, pi, sqrt

from ..contact.frame import locate_along_track
from ..elementary.powers import cube_root
from ..layout import (MODEL_ANALYN, MODEL_ANALYN_STRIP, MODEL_HERTZ, RULE_ELLIPSE, Contact, Pair, SideSearch,
                      Tables)
from ..patch.filling import add_load, begin_patch, clear_patches, finish_patch, finish_patches
from .analyn_contact import analyn_contact
from .coefficients import FLOOR, hertz_coefficients, hertz_stiffness
from .strip_contact import coarse_contact, strip_contact


def hertz_contact(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the only patch of a side by Hertz's ellipse under ``force`` [N], or at the ``prescribed``
    penetration [m] if that is a number; penetration [m], number of regions, 1, and 1: the force is satisfied.

    A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
    """
    locate_along_track(pair, contact.frame, contact.regions, 1)
    region = contact.regions[0]
    point = side.point
    table = pair.tables.hertz
    A = 0.5 * point.curvature_x
    B = max(FLOOR * A, 0.5 * point.curvature_y)
    one_alpha, one_beta, nr = hertz_coefficients(table, A, B)
    stiffness = hertz_stiffness(one_beta, nr, B, pair.tables.contact_modulus)
    penetration = prescribed
    if not isfinite(prescribed):
        root = cube_root(force / (region.share * stiffness))
        penetration = root * root
    load = stiffness * penetration * sqrt(penetration)
    region.stiffness = 1.5 * stiffness * sqrt(penetration)
    region.carried = load
    region.moment = 0.0
    region.slant = 0.0
    region.local_penetration = penetration
    half_length = sqrt(penetration / (one_alpha * A))
    half_width = sqrt(penetration / (one_beta * B))
    clear_patches(side)
    patch = side.patches[begin_patch(side, region, -half_width, 0, RULE_ELLIPSE)]
    add_load(patch, 0, load, 0.0)
    patch.totals.area = pi * half_length * half_width
    patch.totals.stop = half_width
    pressure = 1.5 * load / patch.totals.area
    patch.pressure_square = pressure * pressure
    patch.half_length_square = half_length * half_length
    finish_patch(side)
    finish_patches(side)
    return penetration, 1, True


def solve_normal(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the patches of the side whose frame is open, under ``force`` [N], or at ``prescribed`` penetration
    [m] if that is a number.

    Returns the penetration [m], the number of regions, and whether the force is satisfied.
    """
    model = pair.tables.normal_model
    if model == MODEL_HERTZ:
        penetration, count, satisfied = hertz_contact(pair, contact, side, force, prescribed)
    elif model == MODEL_ANALYN:
        penetration, count, satisfied = analyn_contact(pair, contact, side, force, prescribed)
    elif contact.coarse:
        penetration, count, satisfied = coarse_contact(pair, contact, force)
    else:
        penetration, count, satisfied = strip_contact(pair, contact, side, force, prescribed)
    return penetration, count, satisfied


def has_coarse_form(tables: Tables) -> bool:
    """Whether the model has a form for the first trials of an equilibrium, a per cent off."""
    return tables.normal_model == MODEL_ANALYN_STRIP
