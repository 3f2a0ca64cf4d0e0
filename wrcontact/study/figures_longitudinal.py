"""The source's figures 7.5 to 7.10: longitudinal curvature, and the patches that it makes."""

import math

import numpy as np

from .figure import HOLDS, SourceFigure, stacked
from .figures_search import outlines
from .patch_tables import outline_columns, percent, sizes


def longitudinal_columns(section):
    """Effective and basic 1 / R along the wheel, with its abscissa."""
    y = np.linspace(max(-60e-3, section.wheel.ends[0]), min(40e-3, section.wheel.ends[1]), 401)
    y = np.unique(np.concatenate([y, section.wheel.origin + np.linspace(-1e-3, 1e-3, 101)]))
    return {"y_wheel [mm]": y * 1e3, "effective 2A [1/m]": 2 * section.longitudinal(y),
            "basic 2A [1/m]": 2 * section.longitudinal(y, effective=False)}


def longitudinal(number, shift, where):
    claim = {"tread": "On the tread the two differ little.",
             "flange root": "In the flange root they differ more.",
             "flange": "On the flange they differ most: the contact angle lengthens the radius."}[where]

    def make(study):
        section, side = study.section(shift), study.right(shift)
        at, angle = np.array(side.contact.y_wheel), math.degrees(section.angle)
        effective, basic = (1 / (2 * float(section.longitudinal(at, kind))) for kind in (True, False))
        first, last = at + side.outline.station[[0, -1]] * math.cos(section.angle)
        numbers = {"y_wheel [mm]": float(at) * 1e3, "contact angle [deg]": angle,
                   "effective radius [m]": effective, "basic radius [m]": basic,
                   "wrcontact's radius [m]": 1 / side.curvature_x,
                   "effective / basic radius": effective / basic, "patch from y_wheel [mm]": first * 1e3,
                   "patch to y_wheel [mm]": last * 1e3}
        columns = longitudinal_columns(section)
        if number == "7.9":
            columns = stacked({"curve": "longitudinal curvature", **columns}, outlines(section))
        return SourceFigure(number,
                            f"Longitudinal curvature along the wheel at {shift:g} mm, {where}: effective and "
                            "basic", f"1 / R_x at {shift:g} mm", claim,
                            f"At the contact the radius is {effective:.3f} m cut along the normal and "
                            f"{basic:.3f} m basic, a factor of {effective / basic:.3f} at a contact angle of "
                            f"{angle:.1f} deg.",
                            HOLDS, f"R {effective:.3f} m effective, {basic:.3f} m basic", numbers, columns)

    return make


def longitudinal_patches(number, shift, where):
    claim = {"tread": "The difference is minor.",
             "flange root": "With the effective radius the patch is visibly longer in x.",
             "flange": "With the effective radius the patch is stretched in x and narrower in s."}[where]

    def make(study):
        sides = {"effective": study.right(shift), "basic": study.right(shift, longitudinal_curvature="basic"),
                 "complete theory": study.complete(shift)}
        numbers = {key: value for name, side in sides.items() for key, value in sizes(name, side).items()}
        right, basic, true = sides.values()
        numbers |= {"length, basic / effective": basic.patch_length / right.patch_length,
                    "width, basic / effective": basic.patch_width / right.patch_width,
                    "effective: length [%]": percent(right.patch_length, basic.patch_length),
                    "effective: width [%]": percent(right.patch_width, basic.patch_width),
                    "effective: error of the largest pressure [%]": percent(right.max_pressure,
                                                                            true.max_pressure),
                    "basic: error of the largest pressure [%]": percent(basic.max_pressure,
                                                                        true.max_pressure)}
        length, width, own, other = list(numbers.values())[-4:]
        return SourceFigure(
            number, f"Patch at {shift:g} mm, {where}: effective and basic longitudinal radius",
            f"R_x, patches at {shift:g} mm", claim,
            f"The effective radius makes the patch {right.patch_length * 1e3:.2f} mm long instead of "
            f"{basic.patch_length * 1e3:.2f}, and {right.patch_width * 1e3:.2f} mm wide instead of "
            f"{basic.patch_width * 1e3:.2f}. Against the complete theory the largest pressure is {own:+.1f} "
            f"% off with it, {other:+.1f} % without.", HOLDS,
            f"effective: length {length:+.1f} %, width {round(width, 1) + 0.0:+.1f} %", numbers,
            stacked(*(outline_columns(name, side) for name, side in sides.items())))

    return make


FIGURES = {
    "7.5": longitudinal("7.5", 1.0, "tread"),
    "7.6": longitudinal_patches("7.6", 1.0, "tread"),
    "7.7": longitudinal("7.7", 6.0, "flange root"),
    "7.8": longitudinal_patches("7.8", 6.0, "flange root"),
    "7.9": longitudinal("7.9", 6.5, "flange"),
    "7.10": longitudinal_patches("7.10", 6.5, "flange"),
}
