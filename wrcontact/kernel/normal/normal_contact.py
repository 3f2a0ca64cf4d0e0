"""The normal contact of one side, by the model that is chosen: each one fills the solved patches.

A further model is a file with a function like :func:`~.analyn_contact.analyn_contact`, and a line here.
"""

from ..layout import MODEL_ANALYN, MODEL_HERTZ, Contact, SideOutputs, SideSearch, State, Tables
from .analyn_contact import analyn_contact
from .hertz_contact import hertz_contact
from .strip_contact import coarse_contact, strip_contact


def solve_normal(tables: Tables, contact: Contact, state: State, side: SideSearch, point: SideOutputs,
                 force: float, prescribed: float):
    """Fill the solved patches of the side whose frame is open, under ``force`` [N], or at ``prescribed``
    penetration [m] if that is a number.  ``point`` : the outputs of the side, which describe its contact
    point.

    Returns the penetration [m], the number of regions, and 1 when the force is satisfied, else 0.
    """
    model = tables.normal_model
    if model == MODEL_HERTZ:
        penetration, count, satisfied = hertz_contact(tables, contact, point, force, prescribed)
    elif model == MODEL_ANALYN:
        penetration, count, satisfied = analyn_contact(tables, contact, state, side, force, prescribed)
    elif contact.coarse:
        penetration, count, satisfied = coarse_contact(tables, contact, state, force)
    else:
        penetration, count, satisfied = strip_contact(tables, contact, state, side, force, prescribed)
    return penetration, count, satisfied
