"""What a file of points had to say about itself when it was read."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Reading:
    """How a profile came out of a file of points: how many ``points`` its curve follows, their median ``spacing`` and the
    ``widest`` one [m], their ``noise`` and the ``smoothing`` taken [m], and ``remarks``, what was put right."""

    points: int
    spacing: float
    widest: float
    noise: float
    smoothing: float
    remarks: tuple
