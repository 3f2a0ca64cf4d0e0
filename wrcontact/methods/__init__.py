"""The methods that a contact system can be built with: one small frozen object each.

``ContactSystem(normal_model=Analyn(tolerance=0.004))`` gives the same system as
``ContactSystem(normal_model="analyn", tolerance=0.004)``.  A method knows its name, the kernel's number, its
words, its numerics with their ranges, and what it cannot be combined with; families.py lists all methods.
Nothing here imports the kernel.
"""

from .analyn import Analyn
from .contact_mode import Compliant, Elastic, Rigid
from .families import CHOICES, FAMILIES, NUMBERS, family_of
from .halfspace import Halfspace
from .hertz import Hertz
from .lateral_curvature import Adaptive, Rough, Smooth
from .load import NormalLoad, VerticalLoad
from .longitudinal_curvature import BasicCurvature, EffectiveCurvature
from .method import Method
from .normal_model import NormalModel, Resolution
from .separation import Equidistant, EquidistantChord, NormalSeparation, VerticalSeparation
from .strip import Strip
from .tangential_model import (
    CoupledStrips,
    Fastrip,
    Fastsim,
    HalfspaceRolling,
    NoTangential,
    Polach,
    TangentialModel,
)

__all__ = [
    "CHOICES",
    "FAMILIES",
    "NUMBERS",
    "Adaptive",
    "Analyn",
    "BasicCurvature",
    "Compliant",
    "CoupledStrips",
    "EffectiveCurvature",
    "Elastic",
    "Equidistant",
    "EquidistantChord",
    "Fastrip",
    "Fastsim",
    "Halfspace",
    "HalfspaceRolling",
    "Hertz",
    "Method",
    "NoTangential",
    "NormalLoad",
    "NormalModel",
    "NormalSeparation",
    "Polach",
    "Resolution",
    "Rigid",
    "Rough",
    "Smooth",
    "Strip",
    "TangentialModel",
    "VerticalLoad",
    "VerticalSeparation",
    "family_of",
]
