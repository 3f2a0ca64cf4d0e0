"""How creep forces follow from a solved patch and its creepages."""

from typing import ClassVar

from .method import Method
from .numbers import frozen, whole


class TangentialModel(Method):
    """How tractions and creep forces follow from a solved patch, its creepages and its friction.

    The kernel has a function for each model, called for one patch that presses, rubs and rolls forwards, cut
    into strips along the rolling direction.  It reads load, semi-axes, strips, creepages and friction from
    the record of the patch, and writes there the force on the wheel [N] in the frame of the creepages, no
    more than friction times load; its moment about the normal [N m]; the share of the area that sticks; and
    the largest traction [Pa].  All are zero before.  Of each strip it writes force and moment per width.

    Attributes
    ----------
    one_ellipse : whether it takes the patch for one ellipse: it has no moment, no stick zone and nothing for
        the strips, so that its power is not that of its tractions.
    """

    parameter = "tangential_model"
    constant = "TANGENTIAL"
    decides = "creep forces"
    one_ellipse: ClassVar[bool] = False


def published_spin():
    """The field ``published_spin``."""
    return whole(
        0,
        0,
        1,
        "1: the longitudinal part of spin has the flexibility of spin, as FASTSIM and "
        "FaStrip were published; 0: that of longitudinal creepage, which is closer to the complete "
        "theory",
        nominal=1.0,
    )


@frozen
class NoTangential(TangentialModel):
    """Contact without friction, which costs nothing."""

    name = "none"
    kernel_number = 0
    words = "no friction"


@frozen
class CoupledStrips(TangentialModel):
    """Coupled strips with a correction from exact solutions of ellipses
    (wrcontact/kernel/creep/coupled_strips.py)."""

    name = "strips"
    kernel_number = 1
    words = "coupled strips, corrected by exact solutions of ellipses"


@frozen
class Fastsim(TangentialModel):
    """Kalker's simplified theory (wrcontact/kernel/creep/fastsim.py)."""

    name = "fastsim"
    kernel_number = 2
    words = "Kalker's simplified theory, FASTSIM"

    published_spin: int = published_spin()


@frozen
class Fastrip(TangentialModel):
    """Strip theory joined with FASTSIM (wrcontact/kernel/creep/fastrip.py)."""

    name = "fastrip"
    kernel_number = 3
    words = "strip theory with FASTSIM, FaStrip"

    published_spin: int = published_spin()


@frozen
class Polach(TangentialModel):
    """Polach's formula for one ellipse (wrcontact/kernel/creep/polach.py)."""

    name = "polach"
    kernel_number = 4
    words = "Polach's formula for one ellipse"
    one_ellipse = True


@frozen
class HalfspaceRolling(TangentialModel):
    """Steady rolling by the complete half-space theory (wrcontact/halfspace/rolling).

    It needs scipy, so an FMU does not have it.
    """

    name = "halfspace"
    kernel_number = 5  # for which the kernel finds no creep force
    words = "complete theory of steady rolling on the half-space"
    python_only = True
    needs = {"is computed once for each load": {"load": "normal"}}
