"""What is recorded of a run."""

from dataclasses import dataclass

import numpy as np

#: Of each wheelset: shift against the track [m], yaw [rad], loads of wheels, lateral force of the rails [N].
RECORDED = ("shift", "yaw", "left_load", "right_load", "force_y")


@dataclass
class Run:
    """``time`` (n,) [s]; ``wheelsets`` (n, wheelsets, 5) as ``RECORDED`` says [m, rad, N]; ``places``
    (n, bodies, 3) [m], wheelsets first and the car body last; what it cost."""

    time: np.ndarray
    wheelsets: np.ndarray
    places: np.ndarray
    steps: int
    contact_steps: int
    derivatives: int
    failed: int
    processor: float

    def __getitem__(self, name):
        """One of ``RECORDED`` (n, wheelsets)."""
        return self.wheelsets[:, :, RECORDED.index(name)]

    @property
    def calls(self):
        """Steps and derivatives of the contacts for each step of the solver."""
        return (self.contact_steps + self.derivatives) / self.steps
