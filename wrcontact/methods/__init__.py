"""The methods that a contact system can be built with: one small frozen object each.

``ContactSystem(normal_model=Analyn(tolerance=0.004))`` gives the same system as
``ContactSystem(normal_model="analyn", tolerance=0.004)``.  A method is one class: it knows its name, the
kernel's number, its words, its numerics with their ranges, and what it cannot be combined with.  Making the
class registers it; everything else (FMU, command line, documentation, tests) asks :data:`FAMILIES`.  Nothing
here imports the kernel.
"""

from .contact import *  # noqa: F403
from .contact import ContactMode, LateralCurvature, Load, LongitudinalCurvature, Separation
from .method import Family, Method  # noqa: F401
from .normal import *  # noqa: F403
from .normal import NormalModel, Resolution  # noqa: F401
from .tangential import *  # noqa: F403
from .tangential import TangentialModel

FAMILIES = tuple(
    base.family
    for base in (
        ContactMode,
        Load,
        NormalModel,
        Separation,
        LongitudinalCurvature,
        LateralCurvature,
        TangentialModel,
    )
)

#: Names that an FMU and the command line offer, by parameter; the first one is the default.
CHOICES = {family.parameter: family.names(python=False) for family in FAMILIES}

#: The kernel's number of every method, by parameter and name.
NUMBERS = {
    family.parameter: {method.name: method.kernel_number for method in family.methods} for family in FAMILIES
}

#: The classes of all methods, which are names of wrcontact too.
__all__ = [method.__name__ for family in FAMILIES for method in family.methods]


def family_of(parameter):
    """The family of one parameter."""
    return next(family for family in FAMILIES if family.parameter == parameter)
