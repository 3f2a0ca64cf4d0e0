"""Whole numbers beside a float."""

from typing import Final

from ..layout import inlined

#: Added and taken away again, it leaves a whole number: 1.5 * 2^52.
WHOLE: Final[float] = 6755399441055744.0
#: 2^52: a whole number that is added to it is read from the sum by binary.counted.
COUNTED: Final[float] = 4503599627370496.0


@inlined
def nearest_whole(x: float):
    """The whole number next to ``x``, as a float; |x| < 2^51."""
    return (x + WHOLE) - WHOLE


def rounded_up(x: float):
    """The smallest whole number that is not below ``x``, which is not negative."""
    count = int(x)
    if float(count) < x:
        count += 1
    return count
