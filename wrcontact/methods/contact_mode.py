"""How wheel and rail meet: which of height, roll and loads are given and which follow."""

from .method import Method
from .numbers import frozen


@frozen
class Rigid(Method):
    """Contact where the undeformed profiles touch first, at equal gaps left and right."""

    parameter = "contact_mode"
    name = "rigid"
    kernel_number = 0
    words = "undeformed surfaces touch, at equal gaps left and right"


@frozen
class Elastic(Method):
    """Each wheel approaches its rail until it carries its load; height and roll follow
    (wrcontact/kernel/wheelset/elastic.py)."""

    parameter = "contact_mode"
    name = "elastic"
    kernel_number = 1
    words = "each wheel approaches its rail until it carries its load, which gives height and roll"


@frozen
class Compliant(Method):
    """Height and roll are inputs, and the loads follow."""

    parameter = "contact_mode"
    name = "compliant"
    kernel_number = 2
    words = "height and roll are the inputs vertical_shift_input and roll_input, and the loads follow"
