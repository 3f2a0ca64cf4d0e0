"""What the source does, in numpy: contact searches, inputs to ANALYN and ANALYN itself, as
baselines; and its figures.

"The source" is the degree project that wrcontact started from: KTH, written at TUEV SUED Sweden, on how
undeformed distance, longitudinal and lateral curvature change the contact patch of ANALYN, with Matlab
searches in two and three dimensions. (The text at hand bears neither title page nor year.) Its equations are
cited as "source eq. (4.3)"; where one is wrong as printed, the docstring says so.

Nothing of this is needed for a simulation, and nothing of it is packed into the FMU.

>>> from wrcontact import ContactSystem
>>> from wrcontact.study import Search2D
>>> found = Search2D(ContactSystem(), spacing=1e-4).solve(lateral_shift=3e-3)
>>> found.converged, round(found.roll, 6)
(True, -0.000184)
"""

from .search import Contact, Result, Search2D, Search3D, exact_result
from .variants import AdaptiveSearch, ConstraintSearch, DenserSearch

__all__ = [
    "AdaptiveSearch",
    "ConstraintSearch",
    "Contact",
    "DenserSearch",
    "Result",
    "Search2D",
    "Search3D",
    "exact_result",
]
