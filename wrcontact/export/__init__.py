"""Results for other programs: tables of contacts, and input files of CONTACT.

>>> import wrcontact
>>> from wrcontact import export
>>> table = export.contact_table(wrcontact.ContactSystem(), [0.0, 1e-3])
>>> export.write_contact_table("contacts.csv", table)                                       # doctest: +SKIP
>>> state = wrcontact.ContactSystem().evaluate(1e-3)
>>> export.to_contact(wrcontact.ContactSystem(), state, "contact")                          # doctest: +SKIP
"""

from .contact import to_contact
from .table import contact_table, read_contact_table, write_contact_table

__all__ = ["contact_table", "read_contact_table", "to_contact", "write_contact_table"]
