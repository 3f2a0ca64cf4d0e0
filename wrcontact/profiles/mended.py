"""The points of a profile while they are repaired."""

from dataclasses import dataclass, replace

import numpy as np

#: Neighbours on either side by which a point or a gap is judged.
SIDE = 5


@dataclass(frozen=True)
class Mended:
    """Points ``y``, ``z`` (n,) [mm] in order along the curve, y rising and z down, with their
    ``weight`` and ``noise`` [mm]."""

    y: np.ndarray
    z: np.ndarray
    weight: np.ndarray
    noise: float = 0.0

    def only(self, which):
        """The points selected by ``which``, a mask or indices."""
        return replace(self, y=self.y[which], z=self.z[which], weight=self.weight[which])
