"""The source's figures 7.15 to 7.17: patches of a yawed wheelset."""

import math

from .figure import FAILS, PARTLY, SourceFigure, listed, stacked
from .patch_tables import outline_columns, sizes


def yaw_patches(number, shift, where):
    def make(study):
        numbers, tables = {}, []
        for yaw in (0, 1, 2):
            name, side = f"yaw {yaw} deg", study.right(shift, float(yaw))
            complete = study.complete(shift, float(yaw))
            numbers |= {f"{name}: y_wheel [mm]": side.contact.y_wheel * 1e3,
                        f"{name}: x_wheel [mm]": side.contact.x_wheel * 1e3,
                        f"{name}: longitudinal radius [m]": 1 / side.curvature_x,
                        f"{name}: lateral radius [m]": 1 / side.curvature_y, **sizes(name, side),
                        f"{name}: complete theory, area [mm2]": complete.area * 1e6}
            tables += [outline_columns(name, side), outline_columns(f"{name}, complete theory", complete)]
        if where == "tread":
            narrow = study.right(shift, running_circle_distance=1.5 * math.cos(math.radians(2)))
            numbers |= sizes("no yaw, wheelset narrower by cos(2 deg)", narrow)
        return SourceFigure(number, f"Patch at {shift:g} mm, {where}, for yaw 0, 1, 2 deg",
                            f"yaw, patches at {shift:g} mm",
                            "Yaw changes the patch, without a clear pattern.", *_yaw_words(numbers, where),
                            numbers, stacked(*tables))

    return make


def _yaw_words(numbers, where):
    """Finding, verdict and key."""
    area, length, width, pressure, radius = (
        [numbers[f"yaw {yaw} deg: {what}"] for yaw in (0, 1, 2)] for what in
        ("area [mm2]", "length [mm]", "width [mm]", "largest pressure [MPa]", "longitudinal radius [m]"))
    key = f"area {listed(area, 1)} mm2"
    if where == "tread":
        narrow = numbers["no yaw, wheelset narrower by cos(2 deg): area [mm2]"]
        return (f"There is one here: area {listed(area, 0)} mm2, largest pressure {listed(pressure, 0)} MPa. "
                f"Yaw acts as a narrower wheelset: one narrower by cos(2 deg) has {narrow:.0f} mm2 without "
                "yaw.", FAILS,
                key)
    if where == "flange root":
        return (f"0 and 1 deg are alike ({listed(area[:2], 1)} mm2); at 2 deg the wheel is on its flange, "
                f"{numbers['yaw 2 deg: x_wheel [mm]']:.0f} mm ahead, as the jump is at 5.878 mm: "
                f"{area[2]:.1f} mm2 and {pressure[2] / pressure[0]:.1f} times the pressure. Patches of two "
                "places are compared; that hides the pattern.",
                PARTLY, key)
    return (f"There is one: the patch becomes shorter ({listed(length, 1)} mm) and wider ({listed(width, 2)} "
            f"mm), as the longitudinal radius falls ({listed(radius, 2)} "
            "m).", FAILS, f"length {listed(length, 1)} mm")


FIGURES = {
    "7.15": yaw_patches("7.15", 1.0, "tread"),
    "7.16": yaw_patches("7.16", 6.0, "flange root"),
    "7.17": yaw_patches("7.17", 6.5, "flange"),
}
