"""The source's figures 7.5 to 7.17: longitudinal and lateral curvature, and the patches that they make;
patches of a yawed wheelset."""

import math

import numpy as np

from .figure import (
    DEGREE,
    DS,
    FAILS,
    HOLDS,
    PARTLY,
    REACH,
    SourceFigure,
    listed,
    outline_columns,
    patch_columns,
    percent,
    sizes,
    stacked,
    study_patch,
    study_sizes,
)
from .figures_search import outlines
from .sections import circle_curvature, rough_curvature

# ------------------------------------------------------------------------------------- longitudinal curvature


def longitudinal_columns(section):
    """Effective and basic 1 / R along the wheel, with its abscissa."""
    y = np.linspace(max(-60e-3, section.wheel.ends[0]), min(40e-3, section.wheel.ends[1]), 401)
    y = np.unique(np.concatenate([y, section.wheel.origin + np.linspace(-1e-3, 1e-3, 101)]))
    return {
        "y_wheel [mm]": y * 1e3,
        "effective 2A [1/m]": 2 * section.longitudinal(y),
        "basic 2A [1/m]": 2 * section.longitudinal(y, effective=False),
    }


def longitudinal(number, shift, where):
    claim = {
        "tread": "On the tread the two differ little.",
        "flange root": "In the flange root they differ more.",
        "flange": "On the flange they differ most: the contact angle lengthens the radius.",
    }[where]

    def make(study):
        section, side = study.section(shift), study.right(shift)
        at, angle = np.array(side.contact.y_wheel), math.degrees(section.angle)
        effective, basic = (1 / (2 * float(section.longitudinal(at, kind))) for kind in (True, False))
        first, last = at + side.outline.station[[0, -1]] * math.cos(section.angle)
        numbers = {
            "y_wheel [mm]": float(at) * 1e3,
            "contact angle [deg]": angle,
            "effective radius [m]": effective,
            "basic radius [m]": basic,
            "wrcontact's radius [m]": 1 / side.curvature_x,
            "effective / basic radius": effective / basic,
            "patch from y_wheel [mm]": first * 1e3,
            "patch to y_wheel [mm]": last * 1e3,
        }
        columns = longitudinal_columns(section)
        if number == "7.9":
            columns = stacked({"curve": "longitudinal curvature", **columns}, outlines(section))
        return SourceFigure(
            number,
            f"Longitudinal curvature along the wheel at {shift:g} mm, {where}: effective and basic",
            f"1 / R_x at {shift:g} mm",
            claim,
            f"At the contact the radius is {effective:.3f} m cut along the normal and "
            f"{basic:.3f} m basic, a factor of {effective / basic:.3f} at a contact angle of "
            f"{angle:.1f} deg.",
            HOLDS,
            f"R {effective:.3f} m effective, {basic:.3f} m basic",
            numbers,
            columns,
        )

    return make


def longitudinal_patches(number, shift, where):
    claim = {
        "tread": "The difference is minor.",
        "flange root": "With the effective radius the patch is visibly longer in x.",
        "flange": "With the effective radius the patch is stretched in x and narrower in s.",
    }[where]

    def make(study):
        sides = {
            "effective": study.right(shift),
            "basic": study.right(shift, longitudinal_curvature="basic"),
            "complete theory": study.complete(shift),
        }
        numbers = {key: value for name, side in sides.items() for key, value in sizes(name, side).items()}
        right, basic, true = sides.values()
        numbers |= {
            "length, basic / effective": basic.patch_length / right.patch_length,
            "width, basic / effective": basic.patch_width / right.patch_width,
            "effective: length [%]": percent(right.patch_length, basic.patch_length),
            "effective: width [%]": percent(right.patch_width, basic.patch_width),
            "effective: error of the largest pressure [%]": percent(right.max_pressure, true.max_pressure),
            "basic: error of the largest pressure [%]": percent(basic.max_pressure, true.max_pressure),
        }
        length, width, own, other = list(numbers.values())[-4:]
        return SourceFigure(
            number,
            f"Patch at {shift:g} mm, {where}: effective and basic longitudinal radius",
            f"R_x, patches at {shift:g} mm",
            claim,
            f"The effective radius makes the patch {right.patch_length * 1e3:.2f} mm long instead of "
            f"{basic.patch_length * 1e3:.2f}, and {right.patch_width * 1e3:.2f} mm wide instead of "
            f"{basic.patch_width * 1e3:.2f}. Against the complete theory the largest pressure is {own:+.1f} "
            f"% off with it, {other:+.1f} % without.",
            HOLDS,
            f"effective: length {length:+.1f} %, width {round(width, 1) + 0.0:+.1f} %",
            numbers,
            stacked(*(outline_columns(name, side) for name, side in sides.items())),
        )

    return make


# ------------------------------------------------------------------------------------------ lateral curvature


PRINTED = 1e-6  #: profile coordinates rounded to this are those of a file with three decimals [m]
SEVERAL = np.round(np.arange(0.9, 1.1001, 0.005), 3)  #: lateral shifts around that of figure 7.14 [mm]


#: Ways to the lateral curvature, and what profile coordinates are rounded to [m]; None is the circle fit.
KINDS = {"rough": 0.0, "rough, coordinates to 1 um": PRINTED, "smooth": None}


def curvature_of(curve, t, rounding):
    """Curvature [1/m] of a profile at nodes ``t`` (n,): of three nodes with coordinates rounded to
    ``rounding`` [m] (0: exact), or, where that is None, of the circle fit."""
    if rounding is None:
        return circle_curvature(curve, t, REACH)
    points = np.array([t, curve.profile.height(t)])
    return rough_curvature(np.round(points / rounding) * rounding if rounding else points)


def lateral_of(section, nodes, rounding):
    """B [1/m] at ``nodes`` likewise."""
    return 0.5 * (
        curvature_of(section.rail, nodes.rail, rounding) - curvature_of(section.wheel, nodes.wheel, rounding)
    )


def scatter(section, spacing, rounding):
    """Typical error [1/m] of the rough B within 15 mm of the contact: median of |B - exact B|."""
    nodes = section.equidistant(spacing, round(60e-3 / spacing))
    error = np.abs(lateral_of(section, nodes, rounding) - section.exact_lateral(nodes))
    return float(np.median(error[np.abs(nodes.station) < 15e-3]))


def lateral_curvatures(study):
    section = study.section(1.0)
    nodes = section.equidistant(DS)
    columns = {
        "s [mm]": nodes.station * 1e3,
        "y_wheel [mm]": nodes.wheel * 1e3,
        "y_rail [mm]": nodes.rail * 1e3,
    }
    for name, curve, t in (("wheel", section.wheel, nodes.wheel), ("rail", section.rail, nodes.rail)):
        columns |= {
            f"{name}, {kind} [1/m]": curvature_of(curve, t, rounding) for kind, rounding in KINDS.items()
        }
        columns[f"{name}, exact [1/m]"] = curve.curvature(t)
    numbers = {
        f"scatter of B, ds {ds:g} mm, coordinates to {step:g} mm [1/m]": scatter(
            section, ds / 1e3, step / 1e3
        )
        for ds in (0.2, 0.5, 1.0, 2.0)
        for step in (0.0, 1e-4, 1e-3)
    }
    B = section.exact_lateral(nodes)[np.abs(nodes.station) < 16e-3]
    numbers |= {"exact B from [1/m]": float(B.min()), "exact B to [1/m]": float(B.max())}
    none, little, far = (
        numbers[f"scatter of B, ds {ds:g} mm, coordinates to {step:g} mm [1/m]"]
        for ds, step in ((0.2, 0.0), (0.2, 1e-3), (2.0, 1e-3))
    )
    return SourceFigure(
        "7.11",
        "Lateral curvature of wheel and rail at 1 mm: three nodes 0.2 mm apart, and circles through 6 mm",
        "lateral curvature",
        "Three nodes give a rough curvature, the rougher the smaller ds; it is smooth from ds = 2 mm on, as "
        "a circle fit is at any ds.",
        f"On the exact profiles three nodes are not rough at all: {none:.0e} 1/m off at ds = 0.2 mm, and "
        "they follow every joint. Rounding makes the roughness: coordinates to 1 um make B scatter by "
        f"{little:.0f} 1/m, several times B itself, but at ds = 2 mm by {far:.1f} 1/m, as it falls with "
        "1/ds^2. The circle fit spreads each joint over 6 mm.",
        PARTLY,
        f"scatter {none:.0e} 1/m; to 1 um: {little:.0f} 1/m",
        numbers,
        columns,
    )


def torn(study, rounding, correction=None):
    """Share of lateral shifts around 1 mm at which the first contact point drops out of the rough patch."""
    inside = 0
    for section in (study.section(float(shift)) for shift in SEVERAL):
        nodes = section.equidistant(DS)
        inside += study_patch(
            nodes, section, lateral_of(section, nodes, rounding), correction
        ).first_point_loaded
    return 1 - inside / len(SEVERAL)


def lateral_patches(number, shift):
    def make(study):
        section, complete = study.section(shift), study.complete(shift)
        nodes = section.equidistant(DS)
        patches, numbers = {}, {}
        for kind, rounding in KINDS.items():
            B = lateral_of(section, nodes, rounding)
            patches[kind] = study_patch(nodes, section, B)
            negative = (B <= 0) & (nodes.gap < patches[kind].penetration) & (np.abs(nodes.station) < 15e-3)
            numbers |= {
                f"{kind}: B at the first point [1/m]": float(B[np.argmin(np.abs(nodes.station))]),
                f"{kind}: B <= 0 over [mm]": float(negative.sum()) * DS * 1e3,
                **study_sizes(kind, patches[kind]),
                **study_sizes(f"{kind}, corrected", study_patch(nodes, section, B, DEGREE)),
            }
        numbers |= sizes("complete theory", complete) | sizes("wrcontact", study.right(shift))
        for kind in ("rough", "smooth"):
            numbers |= sizes(f"wrcontact, {kind}", study.right(shift, lateral_curvature=kind))
        if number == "7.14":
            numbers |= {
                f"first point out, coordinates to {step:g} mm{words}": torn(study, step / 1e3, correction)
                for step in (0.0, 1e-4, 1e-3, 1e-2)
                for words, correction in (("", None), (", corrected", DEGREE))
            }
        columns = stacked(
            *(patch_columns(kind, patch) for kind, patch in patches.items()),
            outline_columns("complete theory", complete),
        )
        return SourceFigure(
            number,
            f"Patch at {shift:g} mm: rough and smooth lateral curvature",
            f"B, patches at {shift:g} mm",
            *_lateral_words(number, numbers),
            numbers,
            columns,
        )

    return make


def _lateral_words(number, numbers):
    """Claim, finding, verdict and key."""
    rough, smooth = (numbers[f"{kind}: loaded nodes"] for kind in ("rough", "smooth"))
    wide, less = (numbers[f"{kind}: width [mm]"] for kind in ("rough", "smooth"))
    own, left = (numbers[f"{kind}: B <= 0 over [mm]"] for kind in ("rough", "smooth"))
    depth, true, ours = (
        numbers[f"{name}: penetration [um]"] for name in ("rough", "complete theory", "wrcontact")
    )
    hole = (
        f"B is negative over {own:.1f} mm inside the patch, {left:.1f} mm of which the circle fit "
        f"leaves; dropping them tears the patch and makes the penetration {depth:.0f} um instead of "
        f"{true:.0f} (wrcontact: {ours:.0f})."
    )
    key = f"loaded nodes {rough} rough, {smooth} smooth"
    if number == "7.12":
        return (
            "The rough curvature leaves fewer nodes with B > 0, the smooth patch reaches further.",
            f"{rough} nodes against {smooth}, but within the same width ({wide:.1f} and {less:.1f} mm). "
            f"{hole}",
            PARTLY,
            key,
        )
    if number == "7.13":
        return (
            "Here the smooth curvature leaves fewer nodes: no trend.",
            f"There is one: again the rough one leaves fewer nodes, {rough} against {smooth}, though the "
            f"smooth patch is {wide - less:.1f} mm less wide. {hole}",
            FAILS,
            key,
        )
    exact, fine, file = (
        numbers[f"first point out, coordinates to {step} mm"] for step in ("0", "0.0001", "0.001")
    )
    return (
        "The rough curvature breaks the patch; even the first contact point is not in it.",
        "Not with exact profiles: the first point has B = "
        f"{numbers['rough: B at the first point [1/m]']:.1f} 1/m and is in the patch at all of "
        f"{len(SEVERAL)} shifts from 0.9 to 1.1 mm. With coordinates to 1 um the patch falls into "
        f"{numbers['rough, coordinates to 1 um: pieces']} pieces and the first point is out at "
        f"{file:.0%} of the shifts, with 0.1 um at {fine:.0%}. {hole}",
        PARTLY,
        f"first point out: {exact:.0%}; to 1 um: {file:.0%}",
    )


# -------------------------------------------------------------------------------------------------------- yaw


def yaw_patches(number, shift, where):
    def make(study):
        numbers, tables = {}, []
        for yaw in (0, 1, 2):
            name, side = f"yaw {yaw} deg", study.right(shift, float(yaw))
            complete = study.complete(shift, float(yaw))
            numbers |= {
                f"{name}: y_wheel [mm]": side.contact.y_wheel * 1e3,
                f"{name}: x_wheel [mm]": side.contact.x_wheel * 1e3,
                f"{name}: longitudinal radius [m]": 1 / side.curvature_x,
                f"{name}: lateral radius [m]": 1 / side.curvature_y,
                **sizes(name, side),
                f"{name}: complete theory, area [mm2]": complete.area * 1e6,
            }
            tables += [outline_columns(name, side), outline_columns(f"{name}, complete theory", complete)]
        if where == "tread":
            narrow = study.right(shift, running_circle_distance=1.5 * math.cos(math.radians(2)))
            numbers |= sizes("no yaw, wheelset narrower by cos(2 deg)", narrow)
        return SourceFigure(
            number,
            f"Patch at {shift:g} mm, {where}, for yaw 0, 1, 2 deg",
            f"yaw, patches at {shift:g} mm",
            "Yaw changes the patch, without a clear pattern.",
            *_yaw_words(numbers, where),
            numbers,
            stacked(*tables),
        )

    return make


def _yaw_words(numbers, where):
    """Finding, verdict and key."""
    area, length, width, pressure, radius = (
        [numbers[f"yaw {yaw} deg: {what}"] for yaw in (0, 1, 2)]
        for what in (
            "area [mm2]",
            "length [mm]",
            "width [mm]",
            "largest pressure [MPa]",
            "longitudinal radius [m]",
        )
    )
    key = f"area {listed(area, 1)} mm2"
    if where == "tread":
        narrow = numbers["no yaw, wheelset narrower by cos(2 deg): area [mm2]"]
        return (
            f"There is one here: area {listed(area, 0)} mm2, largest pressure {listed(pressure, 0)} MPa. "
            f"Yaw acts as a narrower wheelset: one narrower by cos(2 deg) has {narrow:.0f} mm2 without "
            "yaw.",
            FAILS,
            key,
        )
    if where == "flange root":
        return (
            f"0 and 1 deg are alike ({listed(area[:2], 1)} mm2); at 2 deg the wheel is on its flange, "
            f"{numbers['yaw 2 deg: x_wheel [mm]']:.0f} mm ahead, as the jump is at 5.878 mm: "
            f"{area[2]:.1f} mm2 and {pressure[2] / pressure[0]:.1f} times the pressure. Patches of two "
            "places are compared; that hides the pattern.",
            PARTLY,
            key,
        )
    return (
        f"There is one: the patch becomes shorter ({listed(length, 1)} mm) and wider ({listed(width, 2)} "
        f"mm), as the longitudinal radius falls ({listed(radius, 2)} "
        "m).",
        FAILS,
        f"length {listed(length, 1)} mm",
    )


FIGURES = {
    "7.5": longitudinal("7.5", 1.0, "tread"),
    "7.6": longitudinal_patches("7.6", 1.0, "tread"),
    "7.7": longitudinal("7.7", 6.0, "flange root"),
    "7.8": longitudinal_patches("7.8", 6.0, "flange root"),
    "7.9": longitudinal("7.9", 6.5, "flange"),
    "7.10": longitudinal_patches("7.10", 6.5, "flange"),
    "7.11": lateral_curvatures,
    "7.12": lateral_patches("7.12", 0.0),
    "7.13": lateral_patches("7.13", 2.0),
    "7.14": lateral_patches("7.14", 1.0),
    "7.15": yaw_patches("7.15", 1.0, "tread"),
    "7.16": yaw_patches("7.16", 6.0, "flange root"),
    "7.17": yaw_patches("7.17", 6.5, "flange"),
}
