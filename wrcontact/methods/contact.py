"""How contact is found and described: contact mode, load, separation and curvatures.

The numbers by which the kernel knows the methods are in FMUs and saved states: they never move, and a new
method gets the next one.  The first method of a family is the default.
"""

from .method import Method
from .numbers import frozen, number


class ContactMode(Method):
    """How wheel and rail meet: which of height, roll and loads are given and which follow."""

    parameter = "contact_mode"
    constant = "MODE"
    decides = "how wheel and rail meet"


@frozen
class Rigid(ContactMode):
    """Contact where the undeformed profiles touch first, at equal gaps left and right."""

    name = "rigid"
    kernel_number = 0
    words = "the undeformed surfaces touch"


@frozen
class Elastic(ContactMode):
    """Each wheel approaches its rail until it carries its load; height and roll follow
    (wrcontact/kernel/wheelset/elastic.py)."""

    name = "elastic"
    kernel_number = 1
    words = "the wheels approach the rails until each carries its load, which gives height and roll"


@frozen
class Compliant(ContactMode):
    """Height and roll are inputs, and the loads follow."""

    name = "compliant"
    kernel_number = 2
    words = "vertical_shift_input and roll_input give height and roll, and the loads follow"


class Load(Method):
    """What the input ``normal_force`` prescribes."""

    parameter = "load"
    constant = "LOAD"
    decides = "what normal_force is"


@frozen
class NormalLoad(Load):
    """``normal_force`` is the total over the patches of a wheel."""

    name = "normal"
    kernel_number = 0
    words = "the sum over the patches of a wheel"


@frozen
class VerticalLoad(Load):
    """``normal_force`` is the vertical component of the resultant of a wheel's patches."""

    name = "vertical"
    kernel_number = 1
    words = "the vertical component of their resultant"


class Separation(Method):
    """How the undeformed distance for ANALYN is measured (wrcontact/kernel/contact/separation.py)."""

    parameter = "separation"
    constant = "SEPARATION"
    decides = "how the undeformed distance of wheel and rail is measured"


@frozen
class NormalSeparation(Separation):
    """Along the normal of the contact plane."""

    name = "normal"
    kernel_number = 0
    words = "along the normal of the contact plane"


@frozen
class VerticalSeparation(Separation):
    """Vertically, at a common lateral coordinate."""

    name = "vertical"
    kernel_number = 1
    words = "at equal lateral coordinates"


@frozen
class Equidistant(Separation):
    """Between points at equal arc length from the contact, along the mean of their normals."""

    name = "equidistant"
    kernel_number = 2
    words = "between points at equal arc lengths from the contact"


@frozen
class EquidistantChord(Separation):
    """As :class:`Equidistant`, with nodes stepped off by a circle, as in the degree project."""

    name = "equidistant_chord"
    kernel_number = 3
    words = "between nodes at equal chord steps from the contact"


class LongitudinalCurvature(Method):
    """The rolling curvature of the wheel."""

    parameter = "longitudinal_curvature"
    constant = "LONGITUDINAL"
    decides = "rolling curvature of the wheel"


@frozen
class EffectiveCurvature(LongitudinalCurvature):
    """Curvature of the cut along the contact normal."""

    name = "effective"
    kernel_number = 0
    words = "of the cut along the contact normal"


@frozen
class BasicCurvature(LongitudinalCurvature):
    """1 / rolling radius."""

    name = "basic"
    kernel_number = 1
    words = "1 / rolling radius"


class LateralCurvature(Method):
    """The relative curvature of wheel and rail across the rail."""

    parameter = "lateral_curvature"
    constant = "LATERAL"
    decides = "curvature across the rail"


@frozen
class Adaptive(LateralCurvature):
    """Averaged over a window in proportion to the patch (wrcontact/kernel/normal/coefficients.py)."""

    name = "adaptive"
    kernel_number = 0
    words = "averaged over a window in proportion to the patch"


@frozen
class Smooth(LateralCurvature):
    """Of a circle fitted to each profile over +- ``reach`` [m], as in the degree project."""

    name = "smooth"
    kernel_number = 1
    words = "of circles fitted to the profiles over curvature_reach on either side"

    reach: float = number(
        3e-3,
        0.1e-3,
        10e-3,
        "m",
        "Half the width over which lateral_curvature smooth fits circles to the profiles",
        nominal=1e-3,
        keyword="curvature_reach",
    )


@frozen
class Rough(LateralCurvature):
    """Change of each profile's angle over ``step`` [m] of arc length, as in the degree project."""

    name = "rough"
    kernel_number = 2
    words = "change of the profile angles over curvature_step"

    step: float = number(
        0.2e-3,
        0.02e-3,
        5e-3,
        "m",
        "Arc length over which lateral_curvature rough takes the change of the profile angle",
        nominal=1e-3,
        keyword="curvature_step",
    )
