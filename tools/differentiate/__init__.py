"""Differentiate the kernel's Python: from its modules to modules that carry a rate beside
every value (forward mode).

The dialect is small: functions of floats, ints and arrays of floats. For every function on the way of a step
that returns or writes something that follows the inputs there is one with ``_t`` at its name's end: behind
each float and each array that follows the inputs stands another of the same name with ``_t``, its rate along
the seed. Values are computed as they were, operation by operation, so that they have the kernel's own bits
and every branch is the one that a step takes.

Tables are constant, and so is ``state``, which never changes an answer. Searches and iterations are
not differentiated; what they find is, by the rules in wrcontact/kernel/derivative: RULES (rules.py) says
which function is the rule of which, and there

    held(x)                   x as a constant
    moving(x, other)          x, with the rate of ``other``
    seeded(x, rate)           x, with this rate
    rate_of(x)                the rate of x as a value
    differentiated(f(...))    the call of a function that has a rule, differentiated as it is written

and a plain call of a function that has a rule is the kernel's own: whatever it writes has no rate
until the rule gives it one.
"""

from .modules import derivative_modules
from .rules import RULE_MODULES

__all__ = ["RULE_MODULES", "derivative_modules"]
