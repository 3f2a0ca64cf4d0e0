"""Runs of numbers.  C has this function in native/spans.h."""

from ..layout import native


@native
def copy_run(source: "float[:]", first: int, to: "float[:]", place: int, count: int) -> int:
    """Write ``count`` numbers of ``source`` from ``first`` on to ``to``, from ``place`` on; ``count``."""
    for i in range(count):
        to[place + i] = source[first + i]
    return count
