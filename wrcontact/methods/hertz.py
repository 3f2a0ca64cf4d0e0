"""Hertz's ellipse."""

from .normal_model import NormalModel, tolerance_from
from .numbers import frozen


@frozen
class Hertz(NormalModel):
    """One Hertz ellipse from the curvatures at the contact point.

    ``tolerance`` only sets the nodes over which an adaptive lateral curvature is averaged; the ellipse is a
    formula.
    """

    name = "hertz"
    kernel_number = 0
    words = "one Hertz ellipse from the curvatures at the contact point"

    tolerance: float | None = tolerance_from(1e-4)
