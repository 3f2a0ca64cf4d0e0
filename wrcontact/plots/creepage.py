"""Creep force of a patch over the creepage, by model."""

import numpy as np

from ..creep import creep_forces
from ..methods import CHOICES
from ..methods.numbers import check_choice
from .style import INK, KILONEWTON, QUIET, given_axis, styled

#: What may run along the axis: the component of the force, the unit, the words for both, and the title.
OVER = {
    "creepage_x": (
        "x",
        1e3,
        "longitudinal creepage, wheel forwards + [\N{PER MILLE SIGN}]",
        "force on the wheel, backwards [kN]",
        "Longitudinal creep force",
    ),
    "creepage_y": (
        "y",
        1e3,
        "lateral creepage, wheel to the field side + [\N{PER MILLE SIGN}]",
        "force on the wheel, to the track side [kN]",
        "Lateral creep force",
    ),
    "spin": (
        "y",
        1.0,
        "spin [1/m]",
        "force on the wheel, to the track side [kN]",
        "Lateral creep force of spin",
    ),
}
#: All models of the kernel; "halfspace" takes a tenth of a second for each point.
MODELS = tuple(name for name in CHOICES["tangential_model"] if name not in ("none", "halfspace"))
LOOKS = {
    "strips": {"color": "#0072B2"},
    "fastsim": {"color": "#D55E00", "linestyle": (0, (6, 2))},
    "fastrip": {"color": "#009E73", "linestyle": (0, (3, 1.5))},
    "polach": {"color": "#CC79A7", "linestyle": (0, (6, 1.5, 1, 1.5))},
    "halfspace": {"color": INK, "linestyle": "", "marker": "o", "markersize": 4.5, "fillstyle": "none"},
}
POINTS, FEW = 49, 13  # of a curve, and of one by the half-space
#: The axis ends at this multiple of the creepage at which linear theory has used up the friction.
REACH = 3.0
SMALL = 1e-9  # [-] or [1/m] creepage of linear theory


@styled
def creep_curves(patch, axis=None, *, models=MODELS, over="creepage_x", largest=None, friction=0.3, **others):
    """Creep force against the creepage, over the creepage, by model; every point is one of
    :func:`wrcontact.creep_forces`.

    Parameters
    ----------
    patch : a :class:`~wrcontact.CreepPatch`.
    axis : axis of matplotlib; None for one in a new figure.
    models : names of tangential models; "halfspace", the complete theory, is drawn by circles.
    over : "creepage_x", "creepage_y" or "spin", whose lateral force is drawn.
    largest : end of the axis [-] or [1/m]; None for three times the creepage at which the linear theory of
        small creepages has used up the friction.
    friction : coefficient of friction.
    others : creepages that stay as they are, keywords of :func:`wrcontact.creep_forces`.

    Returns
    -------
    axis
    """
    check_choice("over", over, OVER)
    for model in models:
        check_choice("models", model, LOOKS)
    component, unit, words, direction, title = OVER[over]

    def force(model, creepage):
        found = creep_forces(patch, **{**others, over: creepage}, friction=friction, tangential_model=model)
        return -getattr(found, component)

    limit = friction * patch.normal_force
    largest = REACH * _saturating(force, limit) if largest is None else largest
    axis = given_axis(axis, 5.6, 3.8)
    axis.axhline(limit / KILONEWTON, color=QUIET, linewidth=0.8)
    axis.annotate(
        "friction times normal force",
        (0.02, limit / KILONEWTON),
        (0, 3),
        color=QUIET,
        fontsize=8,
        xycoords=axis.get_yaxis_transform(),
        textcoords="offset points",
    )
    for model in models:
        creepage = np.linspace(0.0, largest, FEW if model == "halfspace" else POINTS)
        values = np.array([force(model, each) for each in creepage])
        axis.plot(creepage * unit, values / KILONEWTON, label=model, clip_on=False, **LOOKS[model])
    axis.set(
        xlim=(0.0, largest * unit), ylim=(0.0, 1.12 * limit / KILONEWTON), xlabel=words, ylabel=direction
    )
    axis.set_title(f"{title}, {patch.normal_force / KILONEWTON:.1f} kN, friction {friction:g}")
    axis.legend(loc="lower right")
    return axis


def _saturating(force, limit):
    """The creepage at which the force would be the ``limit`` if it grew on as at small creepages."""
    return abs(limit * SMALL / force("strips", SMALL))
