"""The complete half-space theory."""

from .hertz import Hertz
from .normal_model import NormalModel, tolerance_from
from .numbers import frozen


@frozen
class Halfspace(NormalModel):
    """Complete elastic half-space on the true three-dimensional gap, whose normals turn with the surfaces
    (wrcontact/reference/halfspace.py).

    It needs scipy, so an FMU does not have it.  A wheel takes some tenths of a second, seconds where narrow
    patches lie far apart.  ``tolerance`` [1] is the relative error of its grid, 0.005 where None.
    """

    name = "halfspace"
    kernel_number = (
        Hertz.kernel_number
    )  # it takes the rigid geometry alone from the kernel, whose cheapest model is Hertz's
    words = "complete half-space theory on the true gap"
    python_only = True
    needs = {
        "knows the whole surface": {
            "longitudinal_curvature": "effective",
            "separation": "normal",
            "lateral_curvature": "adaptive",
        },
        "has no damping": {"contact_damping": 0.0},
        "has no friction": {"tangential_model": "none"},
    }

    tolerance: float | None = tolerance_from(3e-4)
