"""The normal contact of one side, by the model that is chosen: each one fills the patches of the side.

A further model is a file with a function like :func:`~.analyn_contact.analyn_contact`, and a branch here; see
``NormalModel`` in wrcontact/methods/normal.py for its duties.
"""

from typing import Final

from ..layout import (
    MODEL_ANALYN,
    MODEL_ANALYN_STRIP,
    MODEL_AUTO,
    MODEL_HERTZ,
    Contact,
    Pair,
    SideSearch,
    Tables,
)
from .analyn_contact import analyn_contact
from .auto_contact import auto_contact
from .hertz_contact import hertz_contact
from .model_error import analyn_error
from .strip_contact import coarse_contact, strip_contact

#: For strips, of tread and flange: 1.29 and 1.45.
STRIP_RATE: Final[float] = 1.35


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
        if pair.tables.error and satisfied and contact.filling:
            side.model_error = analyn_error(pair.tables, contact.regions, contact.nodes, count)
    elif model == MODEL_AUTO:
        penetration, count, satisfied = auto_contact(pair, contact, side, force, prescribed)
    elif contact.coarse:
        penetration, count, satisfied = coarse_contact(pair, contact, force)
    else:
        penetration, count, satisfied = strip_contact(pair, contact, side, force, prescribed)
    return penetration, count, satisfied


def has_coarse_form(tables: Tables) -> bool:
    """Whether the model has a form for the first trials of an equilibrium, a per cent off."""
    return tables.normal_model == MODEL_ANALYN_STRIP or tables.normal_model == MODEL_AUTO


def residual_rate(tables: Tables):
    """Approximate derivative of (depth - penetration under the force) with respect to the depth.

    Strips are as long as at that depth, and a strip's pressure keeps its shape.
    """
    rate = 1.0
    if tables.normal_model == MODEL_ANALYN_STRIP:
        rate = STRIP_RATE
    return rate
