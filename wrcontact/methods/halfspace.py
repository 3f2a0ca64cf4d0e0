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
    }

    tolerance: float | None = tolerance_from(3e-4)

    def check_beside(self, chosen):
        """As for every method; with creep forces, which would carry a part of a vertical load, the load is
        the normal one."""
        super().check_beside(chosen)
        if chosen["tangential_model"] != "none" and chosen["load"] != "normal":
            raise ValueError(
                f"load is {chosen['load']!r}; permitted with the normal_model 'halfspace' and the "
                f"tangential_model {chosen['tangential_model']!r} is 'normal'"
            )
