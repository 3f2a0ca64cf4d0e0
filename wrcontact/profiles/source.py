"""Where the numbers of a standard profile come from, and how far they are to be trusted."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Source:
    """Where the numbers of a standard profile come from; its text is one line.

    ``standard`` that defines it and its ``year``, None where it is not known; ``sources``, how many independent
    sources agree on the numbers; ``origin``, what they were read from; a ``note`` on what is uncertain or
    special.  ``running_circle_distance`` [m] is that of its wheelsets, where it is not 1.5 m;
    ``inclined`` [1] is the inclination that a rail's zones have already.
    """

    standard: str
    year: int | None
    sources: int
    origin: str
    note: str = ""
    running_circle_distance: float | None = None
    inclined: float = 0.0

    def __str__(self):
        standard = f"{self.standard}:{self.year}" if self.year else self.standard
        agree = {0: "", 1: " (one source)"}.get(self.sources, f" ({self.sources} sources agree)")
        return f"{standard}; from {self.origin}{agree}" + (f"; {self.note}" if self.note else "")
