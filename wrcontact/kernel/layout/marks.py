"""Marks at functions that say what the C compiler makes of them; in Python they do nothing.

A compiler inlines only so much of one unit.  What it spends on functions that a usual step does not enter it
takes from the usual step: 4 % when yawed.
"""


def seldom(function):
    """A function that a usual step does not call: it is kept out of line."""
    return function


def inlined(function):
    """A small function of the innermost loops: it is always inlined.  Without it the compiler leaves it out
    where the unit has grown enough, and a rigid step takes up to 5 % more instructions."""
    return function
