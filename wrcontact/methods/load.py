"""What the input ``normal_force`` prescribes."""

from .method import Method
from .numbers import frozen


@frozen
class NormalLoad(Method):
    """``normal_force`` is the total over the patches of a wheel."""

    parameter = "load"
    name = "normal"
    kernel_number = 0
    words = "the total over the patches of a wheel"


@frozen
class VerticalLoad(Method):
    """``normal_force`` is the vertical component of the resultant of a wheel's patches."""

    parameter = "load"
    name = "vertical"
    kernel_number = 1
    words = "the vertical component of their resultant"
