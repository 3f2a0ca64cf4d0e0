"""ANALYN."""

from .normal_model import ANALYN_LADDER, NormalModel, node_count, tolerance_from
from .numbers import frozen


@frozen
class Analyn(NormalModel):
    """ANALYN (Sichani, Enblom, Berg 2014), with regions that interact.

    ``tolerance`` [1] is the relative error of the numerics, ``nodes`` per half-width replaces what it needs.
    """

    name = "analyn"
    kernel_number = 1
    words = "ANALYN with interacting regions"
    ladder = ANALYN_LADDER

    tolerance: float | None = tolerance_from(min(ANALYN_LADDER))
    nodes: int | None = node_count()
