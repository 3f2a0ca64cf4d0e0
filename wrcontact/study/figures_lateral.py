"""The source's figures 7.11 to 7.14: lateral curvature, and the patches that it makes."""

import numpy as np

from .figure import FAILS, PARTLY, SourceFigure, stacked
from .patch_tables import DEGREE, DS, REACH, outline_columns, patch_columns, sizes, study_patch, study_sizes
from .sections import circle_curvature, rough_curvature

PRINTED = 1e-6      #: profile coordinates rounded to this are those of a file with three decimals [m]
SEVERAL = np.round(np.arange(0.9, 1.1001, 0.005), 3)   #: lateral shifts around that of figure 7.14 [mm]


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
    return 0.5 * (curvature_of(section.rail, nodes.rail, rounding)
                  - curvature_of(section.wheel, nodes.wheel, rounding))


def scatter(section, spacing, rounding):
    """Typical error [1/m] of the rough B within 15 mm of the contact: median of |B - exact B|."""
    nodes = section.equidistant(spacing, round(60e-3 / spacing))
    error = np.abs(lateral_of(section, nodes, rounding) - section.exact_lateral(nodes))
    return float(np.median(error[np.abs(nodes.station) < 15e-3]))


def lateral_curvatures(study):
    section = study.section(1.0)
    nodes = section.equidistant(DS)
    columns = {"s [mm]": nodes.station * 1e3, "y_wheel [mm]": nodes.wheel * 1e3,
               "y_rail [mm]": nodes.rail * 1e3}
    for name, curve, t in (("wheel", section.wheel, nodes.wheel), ("rail", section.rail, nodes.rail)):
        columns |= {f"{name}, {kind} [1/m]": curvature_of(curve, t, rounding)
                    for kind, rounding in KINDS.items()}
        columns[f"{name}, exact [1/m]"] = curve.curvature(t)
    numbers = {f"scatter of B, ds {ds:g} mm, coordinates to {step:g} mm [1/m]":
               scatter(section, ds / 1e3, step / 1e3)
               for ds in (0.2, 0.5, 1.0, 2.0) for step in (0.0, 1e-4, 1e-3)}
    B = section.exact_lateral(nodes)[np.abs(nodes.station) < 16e-3]
    numbers |= {"exact B from [1/m]": float(B.min()), "exact B to [1/m]": float(B.max())}
    none, little, far = (numbers[f"scatter of B, ds {ds:g} mm, coordinates to {step:g} mm [1/m]"]
                         for ds, step in
                         ((0.2, 0.0), (0.2, 1e-3), (2.0, 1e-3)))
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
        f"scatter {none:.0e} 1/m; to 1 um: {little:.0f} 1/m", numbers, columns)


def torn(study, rounding, correction=None):
    """Share of lateral shifts around 1 mm at which the first contact point drops out of the rough patch."""
    inside = 0
    for section in (study.section(float(shift)) for shift in SEVERAL):
        nodes = section.equidistant(DS)
        inside += study_patch(nodes, section, lateral_of(section, nodes, rounding),
                              correction).first_point_loaded
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
            numbers |= {f"{kind}: B at the first point [1/m]": float(B[np.argmin(np.abs(nodes.station))]),
                        f"{kind}: B <= 0 over [mm]": float(negative.sum()) * DS * 1e3,
                        **study_sizes(kind, patches[kind]),
                        **study_sizes(f"{kind}, corrected", study_patch(nodes, section, B, DEGREE))}
        numbers |= sizes("complete theory", complete) | sizes("wrcontact", study.right(shift))
        for kind in ("rough", "smooth"):
            numbers |= sizes(f"wrcontact, {kind}", study.right(shift, lateral_curvature=kind))
        if number == "7.14":
            numbers |= {f"first point out, coordinates to {step:g} mm{words}":
                        torn(study, step / 1e3, correction)
                        for step in (0.0, 1e-4, 1e-3, 1e-2)
                        for words, correction in (("", None), (", corrected", DEGREE))}
        columns = stacked(*(patch_columns(kind, patch) for kind, patch in patches.items()),
                          outline_columns("complete theory", complete))
        return SourceFigure(number, f"Patch at {shift:g} mm: rough and smooth lateral curvature",
                            f"B, patches at {shift:g} mm", *_lateral_words(number, numbers), numbers, columns)

    return make


def _lateral_words(number, numbers):
    """Claim, finding, verdict and key."""
    rough, smooth = (numbers[f"{kind}: loaded nodes"] for kind in ("rough", "smooth"))
    wide, less = (numbers[f"{kind}: width [mm]"] for kind in ("rough", "smooth"))
    own, left = (numbers[f"{kind}: B <= 0 over [mm]"] for kind in ("rough", "smooth"))
    depth, true, ours = (numbers[f"{name}: penetration [um]"]
                         for name in ("rough", "complete theory", "wrcontact"))
    hole = (f"B is negative over {own:.1f} mm inside the patch, {left:.1f} mm of which the circle fit "
            f"leaves; dropping them tears the patch and makes the penetration {depth:.0f} um instead of "
            f"{true:.0f} (wrcontact: {ours:.0f}).")
    key = f"loaded nodes {rough} rough, {smooth} smooth"
    if number == "7.12":
        return ("The rough curvature leaves fewer nodes with B > 0, the smooth patch reaches further.",
                f"{rough} nodes against {smooth}, but within the same width ({wide:.1f} and {less:.1f} mm). "
                f"{hole}", PARTLY,
                key)
    if number == "7.13":
        return ("Here the smooth curvature leaves fewer nodes: no trend.",
                f"There is one: again the rough one leaves fewer nodes, {rough} against {smooth}, though the "
                f"smooth patch is {wide - less:.1f} mm less wide. {hole}", FAILS, key)
    exact, fine, file = (numbers[f"first point out, coordinates to {step} mm"]
                         for step in ("0", "0.0001", "0.001"))
    return ("The rough curvature breaks the patch; even the first contact point is not in it.",
            "Not with exact profiles: the first point has B = "
            f"{numbers['rough: B at the first point [1/m]']:.1f} 1/m and is in the patch at all of "
            f"{len(SEVERAL)} shifts from 0.9 to 1.1 mm. With coordinates to 1 um the patch falls into "
            f"{numbers['rough, coordinates to 1 um: pieces']} pieces and the first point is out at "
            f"{file:.0%} of the shifts, with 0.1 um at {fine:.0%}. {hole}", PARTLY,
            f"first point out: {exact:.0%}; to 1 um: {file:.0%}")


FIGURES = {
    "7.11": lateral_curvatures,
    "7.12": lateral_patches("7.12", 0.0),
    "7.13": lateral_patches("7.13", 2.0),
    "7.14": lateral_patches("7.14", 1.0),
}
