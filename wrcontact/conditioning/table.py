"""The check of a pair as a table over the lateral shift: contact points, contact angles, rolling radii and their
difference, equivalent conicity."""

import math

import numpy as np

from ..conventions import SIDES
from ..interface.units import UNITS
from ..results.words import unit_name
from .conicity import Swing
from .text import headline

#: Digits of a number in a file.
DIGITS = 9
#: Names of each side's columns, where :class:`~wrcontact.conditioning.SideCurves` has them, and their units.
OF_SIDE = (
    ("contact.y_wheel", "y_wheel", "m"),
    ("contact.y_rail", "y_rail", "m"),
    ("contact_angle", "contact_angle", "rad"),
    ("rolling_radius", "rolling_radius", "m"),
)
#: What the columns mean, line by line at the top of a file.
FRAMES = """\
lateral_shift: of the wheelset from the track's centre, positive to the right; roll: positive with the right wheel down; no yaw, rigid contact
contact.y_wheel: from the running circle, positive to the field side; contact.y_rail: from the highest point of the inclined head, positive to the field side
contact_angle: positive towards the flange; rolling_radius: at the contact point
radius_difference: right minus left rolling radius; level_radius_difference: the same at zero roll
delta_tan_gamma: tan of the right minus tan of the left contact angle; free_curvature: of the curve in which a free wheelset rolls without longitudinal creepage, positive to the right
conicity: equivalent conicity (EN 15302, at zero roll) at an amplitude of |lateral_shift|; rolled_conicity: the same with roll
empty: no value (no contact, or no oscillation with this amplitude)"""


def table_columns(report):
    """Columns of a :class:`~wrcontact.conditioning.Conditioning` at all shifts with contact: {name: (values
    (n,) in SI, unit)}."""
    curves = report.curves
    there = np.isfinite(curves.roll)
    found = {"lateral_shift": (curves.lateral_shift, "m"), "roll": (curves.roll, "rad")}
    for side in SIDES:
        for name, field, unit in OF_SIDE:
            found[f"{side}.{name}"] = getattr(getattr(curves, side), field), unit
    for name in ("radius_difference", "level_radius_difference"):
        found[name] = getattr(curves, name), "m"
    found["delta_tan_gamma"] = curves.delta_tan_gamma, "1"
    found["free_curvature"] = curves.free_curvature, "1/m"
    for name, swing in (("conicity", "level"), ("rolled_conicity", "rolled")):
        found[name] = _conicities(report.conicity_curves[swing], curves.lateral_shift), "1"
    return {name: (values[there], unit) for name, (values, unit) in found.items()}


def _conicities(curve, shifts):
    """Equivalent conicity (n,) at amplitudes of |``shifts``| (n,) [m]; NaN at zero and without a ``curve``."""
    amplitudes, place = np.unique(np.round(np.abs(shifts), 12), return_inverse=True)
    if curve is None:
        return np.full(len(shifts), math.nan)
    swing = Swing(*curve)
    return np.array([swing.conicity(one)[0] if one > 0.0 else math.nan for one in amplitudes])[place]


def table_text(report):
    """The table as CSV in mm and deg; lines that begin with "#" say the pair, frames and signs."""
    found = table_columns(report)
    heads = [f"{name} [{unit_name(unit) or unit}]" for name, (_, unit) in found.items()]
    values = [column * UNITS[unit].display_factor for column, unit in found.values()]
    lines = [f"# {line}" for line in (headline(report), *FRAMES.splitlines())]
    lines.append(",".join(heads))
    lines += [",".join(map(_cell, row)) for row in zip(*values)]
    return "\n".join(lines) + "\n"


def _cell(value):
    return f"{value + 0.0:.{DIGITS}g}" if math.isfinite(value) else ""
