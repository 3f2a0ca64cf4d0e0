"""All methods: what each family decides, and its methods, of which the first is the default."""

from dataclasses import dataclass

from .analyn import Analyn
from .choices import check_choice
from .contact_mode import Compliant, Elastic, Rigid
from .halfspace import Halfspace
from .hertz import Hertz
from .lateral_curvature import Adaptive, Rough, Smooth
from .load import NormalLoad, VerticalLoad
from .longitudinal_curvature import BasicCurvature, EffectiveCurvature
from .separation import Equidistant, EquidistantChord, NormalSeparation, VerticalSeparation
from .strip import Strip
from .tangential_model import (
    CoupledStrips,
    Fastrip,
    Fastsim,
    HalfspaceRolling,
    NoTangential,
    Polach,
)


@dataclass(frozen=True)
class Family:
    """The methods for one ``parameter``; ``decides`` says what for, in words for the user.

    The kernel's constants for their numbers begin with ``constant``: MODE_RIGID.
    """

    parameter: str
    constant: str
    decides: str
    methods: tuple

    @property
    def default(self):
        """The name of the first method."""
        return self.methods[0].name

    def names(self, python=True):
        """The strings that can be chosen, those of an FMU and the command line without ``python``."""
        return tuple(method.name for method in self.methods if python or not method.python_only)

    def method(self, name):
        """The class of the method with this name; ValueError, in a sentence, where there is none."""
        check_choice(self.parameter, name, self.names())
        return next(method for method in self.methods if method.name == name)

    def with_keyword(self, keyword):
        """Names of the methods that have this number."""
        return [method.name for method in self.methods if keyword in method.keywords()]


FAMILIES = (
    Family("contact_mode", "MODE", "how wheel and rail meet", (Rigid, Elastic, Compliant)),
    Family("load", "LOAD", "what normal_force prescribes", (NormalLoad, VerticalLoad)),
    Family("normal_model", "MODEL", "normal contact", (Analyn, Strip, Hertz, Halfspace)),
    Family(
        "separation",
        "SEPARATION",
        "how the undeformed distance is measured",
        (NormalSeparation, VerticalSeparation, Equidistant, EquidistantChord),
    ),
    Family(
        "longitudinal_curvature",
        "LONGITUDINAL",
        "rolling curvature of the wheel",
        (EffectiveCurvature, BasicCurvature),
    ),
    Family("lateral_curvature", "LATERAL", "relative lateral curvature", (Adaptive, Smooth, Rough)),
    Family(
        "tangential_model",
        "TANGENTIAL",
        "creep forces",
        (NoTangential, CoupledStrips, Fastsim, Fastrip, Polach, HalfspaceRolling),
    ),
)

#: Names that an FMU and the command line offer, by parameter; the first one is the default.
CHOICES = {family.parameter: family.names(python=False) for family in FAMILIES}

#: The kernel's number of every method, by parameter and name.
NUMBERS = {
    family.parameter: {method.name: method.kernel_number for method in family.methods} for family in FAMILIES
}


def family_of(parameter):
    """The family of one parameter."""
    return next(family for family in FAMILIES if family.parameter == parameter)


def _check():
    """A family holds methods of its own parameter, each with its own name."""
    for family in FAMILIES:
        names = family.names()
        if len(set(names)) < len(names) or any(
            method.parameter != family.parameter for method in family.methods
        ):
            raise TypeError(
                f"the methods of {family.parameter} are not its own, or two have one name: {names}"
            )


_check()
