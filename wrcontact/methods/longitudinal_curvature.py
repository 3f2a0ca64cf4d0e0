"""The wheel's curvature in rolling direction."""

from .method import Method
from .numbers import frozen


@frozen
class EffectiveCurvature(Method):
    """Curvature of the cut along the contact normal."""

    parameter = "longitudinal_curvature"
    name = "effective"
    kernel_number = 0
    words = "of the cut along the contact normal"


@frozen
class BasicCurvature(Method):
    """1 / rolling radius."""

    parameter = "longitudinal_curvature"
    name = "basic"
    kernel_number = 1
    words = "1 / rolling radius"
