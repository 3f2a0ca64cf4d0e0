"""The relative curvature of wheel and rail across the rail."""

from .method import Method
from .numbers import frozen, number


@frozen
class Adaptive(Method):
    """Averaged over a window in proportion to the patch (wrcontact/kernel/normal/node_coefficients.py)."""

    parameter = "lateral_curvature"
    name = "adaptive"
    kernel_number = 0
    words = "averaged over a window in proportion to the patch"


@frozen
class Smooth(Method):
    """Of a circle fitted to each profile over +- ``reach`` [m], as in the degree project."""

    parameter = "lateral_curvature"
    name = "smooth"
    kernel_number = 1
    words = "of circles fitted to the profiles"

    reach: float = number(
        3e-3,
        0.1e-3,
        10e-3,
        "m",
        "Half the width over which the smooth lateral curvature fits circles to the profiles",
        nominal=1e-3,
        keyword="curvature_reach",
    )


@frozen
class Rough(Method):
    """Change of each profile's angle over ``step`` [m] of arc length, as in the degree project."""

    parameter = "lateral_curvature"
    name = "rough"
    kernel_number = 2
    words = "change of the profiles' angles between neighbouring nodes"

    step: float = number(
        0.2e-3,
        0.02e-3,
        5e-3,
        "m",
        "Arc length from node to node of the rough lateral curvature",
        nominal=1e-3,
        keyword="curvature_step",
    )
