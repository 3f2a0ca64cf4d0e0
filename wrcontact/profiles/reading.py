"""Properties of a file of points, found when it was read."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Reading:
    """Properties of a file of points.

    ``points``, the number of points used; their median ``spacing`` and the ``widest`` one [m]; their estimated ``noise`` and the
    applied ``smoothing`` [m]; ``remarks``, a tuple of sentences on repairs.
    """

    points: int
    spacing: float
    widest: float
    noise: float
    smoothing: float
    remarks: tuple
