"""The points of a profile while they are repaired."""

from dataclasses import dataclass, replace

import numpy as np

#: A gap or an outlier is judged by so many neighbours on either side.
SIDE = 5


@dataclass(frozen=True)
class Mended:
    """Points (n,) in order of the curve, y rising on the whole, z down [mm], their ``weight`` and ``noise`` [mm]."""

    y: np.ndarray
    z: np.ndarray
    weight: np.ndarray
    noise: float = 0.0

    def only(self, which):
        """The points that ``which``, a mask or indices, picks."""
        return replace(self, y=self.y[which], z=self.z[which], weight=self.weight[which])
