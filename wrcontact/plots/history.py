"""Histories: quantities of a run over time or distance, from arrays, a table of states, or a file of an FMU's
results."""

import numpy as np

from ..interface.variables import UNITS, VARIABLES
from ..results.climbing import flange_climb, wheel_lift
from ..results.runs import Run
from ..results.words import unit_name
from .style import INK, SIDE_COLOUR, given_axis, styled

UNITS_BY_NAME = {variable.name: variable.unit for variable in VARIABLES if variable.unit}
#: What runs and FMUs of wheelsets have beside the variables of the contact.
UNITS_OF_RUNS = {
    "time": "s",
    "distance": "m",
    "vertical_velocity": "m/s",
    "left.wheel_lift": "m",
    "right.wheel_lift": "m",
}
#: What follows from the columns of a run, by name and side; the limits are those at the steepest contact.
DERIVED = {
    f"{side}.{name}": find
    for side in SIDE_COLOUR
    for name, find in (
        ("climb_limit", lambda run, side: getattr(flange_climb(run), f"{side}_limit")),
        ("climb_margin", lambda run, side: getattr(flange_climb(run), f"{side}_margin")),
        ("wheel_lift", wheel_lift),
    )
}
DERIVED["climb_sum_margin"] = lambda run, side: flange_climb(run).sum_margin
COLOURS = (INK, "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
STROKES = ("-", (0, (5, 1.5)), (0, (2, 1.2)), (0, (6, 1.5, 1, 1.5)))


@styled
def history(run, names, axis=None, *, over="time"):
    """Quantities of one unit over time or distance, in display units.

    Parameters
    ----------
    run : arrays (n,) in SI by FMU name: a dict, the result of fmpy, a DataFrame, a table of states of
        ``evaluate_many``, or the path of a CSV file with a line of names.
    names : one FMU name, or several of the same unit; "normal_force" stands for that of both wheels where
        there is no other.  "climb_limit" is Nadal's limit of Y/Q at the steepest contact, "climb_margin" the
        margin to it, "climb_sum_margin" that to Weinstock's, "wheel_lift" the height of the running circle
        (:func:`~wrcontact.flange_climb`, :func:`~wrcontact.wheel_lift`).
    axis : axis of matplotlib; None for one in a new figure.
    over : name of what runs along the axis, or an array (n,) of times [s].

    Returns
    -------
    axis

    Raises
    ------
    ValueError
        in a sentence, where a name is unknown or the units differ.
    """
    run = Run.of(run)
    names = [each for name in ([names] if isinstance(names, str) else names) for each in _of_sides(run, name)]
    units = {unit_of(name) for name in names}
    if len(units) != 1:
        raise ValueError(f"{' and '.join(names)} have {len(units)} units; permitted is one for an axis")
    (unit,) = units
    along, words = _along(run, over)
    axis, common = given_axis(axis, 6.4, 3.2), _common(names)
    for place, name in enumerate(names):
        side = name.split(".")[0]
        colour = SIDE_COLOUR.get(side, COLOURS[place % len(COLOURS)])
        axis.plot(
            along,
            column(run, name) * UNITS[unit].display_factor,
            color=colour,
            label=name if not common else side,
            linewidth=1.2,
            linestyle=STROKES[place % len(STROKES)],
        )
    axis.set(xlim=(np.nanmin(along), np.nanmax(along)), xlabel=words, ylabel=_bracketed(common, unit))
    if len(names) > 1:
        axis.legend(loc="best")
    return axis


def _of_sides(run, name):
    """The name, or those of both wheels where the run has only these."""
    sides = [f"{side}.{name}" for side in SIDE_COLOUR]
    known = {*run.names, *DERIVED}
    return sides if name not in known and known.issuperset(sides) else [name]


def _along(run, over):
    """The numbers along the axis and their words."""
    if not isinstance(over, str):
        return np.asarray(over, dtype=float), "time [s]"
    unit = unit_of(over)
    if over == "distance":
        return column(run, over), "distance [m]"
    return column(run, over) * UNITS[unit].display_factor, _bracketed(over, unit)


def _common(names):
    """The name that all have beside the side; "" where there are several."""
    ends = {name.partition(".")[2] if name.split(".")[0] in SIDE_COLOUR else name for name in names}
    return ends.pop() if len(ends) == 1 else ""


def _bracketed(words, unit):
    """Words with the display unit in brackets."""
    return f"{words} [{unit_name(unit) or '-'}]".strip().replace("mm2", "mm²")


def unit_of(name):
    """The SI unit of a variable by its FMU name; "1" of another one."""
    return UNITS_BY_NAME.get(name) or UNITS_OF_RUNS.get(name, "1")


def column(run, name):
    """One column (n,) of a :class:`~wrcontact.results.runs.Run` in SI, or what follows from its columns; ValueError
    where the run has none of this name."""
    if name not in run and name in DERIVED:
        return np.asarray(DERIVED[name](run, name.split(".")[0]), dtype=float)
    return run[name]
