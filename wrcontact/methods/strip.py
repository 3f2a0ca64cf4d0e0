"""The strip model: strips that press on each other."""

from .normal_model import NormalModel, Resolution, node_count, tolerance_from
from .numbers import frozen, whole

#: Resolution by falling tolerance.
STRIP_LADDER = {
    0.025: Resolution(8, 2, 16, 2),
    0.015: Resolution(8, 2, 20, 2),
    0.01: Resolution(8, 2, 24, 2),
    0.007: Resolution(8, 2, 32, 3),
    0.004: Resolution(8, 2, 48, 4),
}


@frozen
class Strip(NormalModel):
    """Strips of a patch that press on each other.

    ``tolerance`` [1] is the relative error of the numerics; ``strips``, ``sweeps`` (how often they are
    corrected) and ``nodes`` per half-width replace what it needs.
    """

    name = "analyn_strip"
    kernel_number = 2
    words = "strips that press on each other"
    ladder = STRIP_LADDER

    tolerance: float | None = tolerance_from(min(STRIP_LADDER))
    nodes: int | None = node_count()
    strips: int | None = whole(
        None,
        16,
        64,
        "Strips of the strip model, instead of those that the tolerance needs",
        python_only=True,
    )
    sweeps: int | None = whole(
        None,
        1,
        4,
        "Sweeps of the strip model, instead of those that the tolerance needs",
        python_only=True,
    )
