"""How the undeformed distance for ANALYN is measured (wrcontact/kernel/contact/separation.py)."""

from .method import Method
from .numbers import frozen


@frozen
class NormalSeparation(Method):
    """Along the normal of the contact plane."""

    parameter = "separation"
    name = "normal"
    kernel_number = 0
    words = "along the normal of the contact plane"


@frozen
class VerticalSeparation(Method):
    """Vertically, at a common lateral coordinate."""

    parameter = "separation"
    name = "vertical"
    kernel_number = 1
    words = "vertically at common lateral coordinate"


@frozen
class Equidistant(Method):
    """Between points at equal arc length from the contact, along the mean of their normals."""

    parameter = "separation"
    name = "equidistant"
    kernel_number = 2
    words = "between points at equal arc length from the contact"


@frozen
class EquidistantChord(Method):
    """As :class:`Equidistant`, with nodes stepped off by a circle, as in the degree project."""

    parameter = "separation"
    name = "equidistant_chord"
    kernel_number = 3
    words = "between nodes that circles step off from the contact"
