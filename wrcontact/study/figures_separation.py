"""The source's figures 7.1 to 7.4: where the wheel touches, and the separation of the profiles there."""

import math
from functools import cache

import numpy as np
from scipy.interpolate import CubicSpline

from .figure import (
    DEGREE,
    HOLDS,
    PARTLY,
    REACH,
    SourceFigure,
    outline_columns,
    percent,
    sizes,
    stacked,
    study_patch,
    study_sizes,
)
from .figures_search import outlines
from .sections import Separation

FINE_DS = 0.05e-3  #: distance of nodes for patches that are compared with each other [m]


def picture(number, shift, where):
    def make(study):
        side = study.right(shift)
        place, angle = side.contact.y_wheel * 1e3, math.degrees(side.contact_angle)
        key = f"y_wheel {place:.2f} mm, angle {angle:.2f} deg"
        return SourceFigure(
            number,
            f"Right wheel's contact at {shift:g} mm, no yaw: {where}",
            f"contact at {shift:g} mm",
            f"The contact is {'in' if where == 'flange root' else 'on'} the {where}.",
            f"It is, at {key}.",
            HOLDS,
            key,
            {"y_wheel [mm]": place, "contact angle [deg]": angle},
            outlines(study.section(shift)),
        )

    return make


def turned(vertical):
    """Vertical distances over y as what they are in the contact plane: shorter by cos(delta),
    over s = y / cos(delta)."""
    return Separation(
        vertical.station * vertical.stretch, vertical.gap / vertical.stretch, vertical.wheel, vertical.rail
    )


@cache
def separation_patches(section):
    """Nodes and patch by name of the separation, with the circle fit as lateral curvature."""
    vertical = section.vertical(FINE_DS, 1600)
    kinds = {
        "equidistant": section.equidistant(FINE_DS, 1600),
        "vertical": vertical,
        "vertical, turned": turned(vertical),
    }
    return {
        name: (nodes, study_patch(nodes, section, section.smooth_lateral(nodes, REACH), DEGREE))
        for name, nodes in kinds.items()
    }


def difference(section, low, high):
    """Vertical less equidistant separation at the same point of the wheel [m], at y (n,) between
    ``low`` and ``high``."""
    vertical, equidistant = (separation_patches(section)[name][0] for name in ("vertical", "equidistant"))
    y, lateral = np.linspace(low, high, 401), section.wheel.point(equidistant.wheel)[0]
    return y, CubicSpline(vertical.station, vertical.gap)(y) - CubicSpline(lateral, equidistant.gap)(y)


def separation(number, shift, where):
    def make(study):
        section, complete = study.section(shift), study.complete(shift)
        patches = {name: patch for name, (_, patch) in separation_patches(section).items()}
        y, apart = difference(section, *patches["vertical"].station[patches["vertical"].loaded][[0, -1]])
        numbers = {
            "contact angle [deg]": math.degrees(section.angle),
            **_differences(section, apart),
            **_separation_effect(section, patches),
        }
        for name, patch in patches.items():
            numbers |= study_sizes(name, patch)
        for kind in ("equidistant", "vertical"):
            numbers |= sizes(
                f"wrcontact, {kind}", study.right(shift, separation=kind, lateral_curvature="smooth")
            )
        numbers |= sizes("complete theory", complete)
        columns = stacked(
            *(_separation_columns(name, section) for name in ("equidistant", "vertical")),
            {"curve": "vertical less equidistant", "y [mm]": y * 1e3, "separation [mm]": apart * 1e3},
            outline_columns("complete theory", complete),
        )
        return SourceFigure(
            number,
            f"Separation and patch at {shift:g} mm, {where}: equidistant and vertical",
            f"separation at {shift:g} mm",
            *_separation_words(numbers, where),
            numbers,
            columns,
        )

    return make


def _differences(section, apart):
    """How far vertical and equidistant separations are apart near the contact, and inside the
    patch (``apart``) [mm]."""
    found = {"inside the patch": apart} | {
        f"within {near:g} mm": difference(section, -near * 1e-3, near * 1e-3)[1] for near in (0.25, 0.5, 1.0)
    }
    return {
        f"separations differ {where} by [mm]": float(np.abs(values).max()) * 1e3
        for where, values in found.items()
    }


def _separation_effect(section, patches):
    """What vertical distances change of the patch, as they are and turned into the contact plane [%]."""
    one, other, again = (patches[name] for name in ("equidistant", "vertical", "vertical, turned"))
    cosine = math.cos(section.angle)
    return {
        "vertical: penetration [%]": percent(other.penetration, one.penetration),
        "vertical: length [%]": percent(other.length, one.length),
        "vertical: width in y [%]": percent(other.width, one.width * cosine),
        "vertical, turned: penetration [%]": percent(again.penetration, one.penetration),
        "1 / cos(contact angle) [%]": percent(1, cosine),
    }


def _separation_columns(name, section):
    """Every fourth node, 0.2 mm apart, and all within 6 mm: where it is, its
    separation, and the patch there."""
    nodes, patch = separation_patches(section)[name]
    keep = (np.arange(len(nodes.station)) % 4 == 0) | (np.abs(nodes.station) < 6e-3)
    return {
        "curve": name,
        "y [mm]": section.wheel.point(nodes.wheel)[0][keep] * 1e3,
        "separation [mm]": nodes.gap[keep] * 1e3,
        "station [mm]": nodes.station[keep] * 1e3,
        "half length [mm]": patch.half_length[keep] * 1e3,
        "pressure [MPa]": patch.pressure[keep] / 1e6,
    }


def _separation_words(numbers, where):
    """Claim, finding, verdict and key."""
    depth, length, width, again = (
        numbers[f"vertical: {what} [%]"] if what != "turned" else numbers["vertical, turned: penetration [%]"]
        for what in ("penetration", "length", "width in y", "turned")
    )
    half, one, patch = (
        numbers[f"separations differ {near} by [mm]"]
        for near in ("within 0.5 mm", "within 1 mm", "inside the patch")
    )
    if where == "tread":
        return (
            "On the tread both are almost the same, and begin to differ towards the flange.",
            f"Within 1 mm of the contact they differ by {one:.0e} mm, within the patch by {patch:.0e} "
            f"mm; with vertical distances the patch is {length:.1f} % longer and the penetration "
            f"{depth:.1f} % larger.",
            HOLDS,
            f"penetration {depth:+.1f} %, length {length:+.1f} %",
        )
    return (
        "They differ by 1e-4 ... 1e-3 mm around the contact; the equidistant patch is wider in y and "
        "narrower in x, because other nodes are paired.",
        f"They differ by {half:.0e} mm at 0.5 mm and {one:.0e} mm at 1 mm from the contact, {patch:.0e} "
        "mm at the patch's edge, and always by about a tenth: a vertical distance is 1 / cos(contact "
        f"angle) = {numbers['1 / cos(contact angle) [%]']:.0f} % longer. With it the patch is "
        f"{length:.1f} % longer and {-width:.0f} % narrower in y, the penetration {depth:.1f} % larger. "
        "Pairing is the small part: the same vertical distances, turned into the contact plane, come "
        f"within {abs(again):.1f} %.",
        PARTLY,
        f"{half:.0e} ... {one:.0e} mm; penetration {depth:+.1f} %",
    )


FIGURES = {
    "7.1": picture("7.1", 1.0, "tread"),
    "7.2": separation("7.2", 1.0, "tread"),
    "7.3": picture("7.3", 6.0, "flange root"),
    "7.4": separation("7.4", 6.0, "flange root"),
}
