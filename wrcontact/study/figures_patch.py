"""The source's figures of chapter 7: separations, curvatures and the patches that ANALYN makes of them.

Patches "as the source has them" are those of :mod:`~wrcontact.study.analyn` on nodes of :mod:`~wrcontact.study.sections`;
where the source only varies what the kernel also knows (longitudinal curvature, yaw) they are the kernel's.  Beside them
stands the complete theory.
"""

import math
from functools import lru_cache

import numpy as np

from .analyn import solve_analyn
from .figures import FAILS, FORCE, HOLDS, MODULUS, PARTLY, SourceFigure, stacked
from .figures_search import outlines
from .sections import Separation, circle_curvature, rough_curvature

DS = 0.2e-3         #: the source's distance of nodes for lateral curvatures [m]
FINE_DS = 0.05e-3   #: for patches that are compared with each other [m]
REACH = 3e-3        #: dyr of the circle fit [m]
DEGREE = 2          #: of the polynomial that replaces B <= 0; the source does not tell it
PRINTED = 1e-6      #: profile coordinates rounded to this are those of a file with three decimals [m]
SEVERAL = np.round(np.arange(0.9, 1.1001, 0.005), 3)   #: lateral shifts around that of figure 7.14 [mm]


# --- tables ----------------------------------------------------------------------------------------


def study_patch(nodes, section, B, correction=None, effective=True):
    """ANALYN of the source on ``nodes`` with the lateral curvature ``B`` (n,) [1/m]."""
    return solve_analyn(nodes.station, np.maximum(nodes.gap, 0.0), section.longitudinal(nodes.wheel, effective), B,
                        force=FORCE, modulus=MODULUS, correction=correction)


def patch_columns(curve, patch, margin=2):
    """Rows of a study's patch: its loaded nodes and ``margin`` beside them."""
    loaded = np.flatnonzero(patch.loaded)
    part = slice(max(loaded[0] - margin, 0), loaded[-1] + margin + 1)
    return {"curve": curve, "station [mm]": patch.station[part] * 1e3, "half length [mm]": patch.half_length[part] * 1e3,
            "pressure [MPa]": patch.pressure[part] / 1e6}


def outline_columns(curve, side):
    """Rows of a kernel's patch."""
    outline = side.outline
    return {"curve": curve, "station [mm]": outline.station * 1e3, "half length [mm]": outline.half_length * 1e3,
            "pressure [MPa]": outline.pressure / 1e6}


def sizes(name, side):
    """What one compares of a kernel's patch."""
    return {f"{name}: length [mm]": side.patch_length * 1e3, f"{name}: width [mm]": side.patch_width * 1e3,
            f"{name}: area [mm2]": side.area * 1e6, f"{name}: largest pressure [MPa]": side.max_pressure / 1e6,
            f"{name}: penetration [um]": side.penetration * 1e6}


def study_sizes(name, patch):
    """The same of a study's patch; and how many nodes are loaded, in how many pieces, and whether the first point is."""
    return {f"{name}: length [mm]": patch.length * 1e3, f"{name}: width [mm]": patch.width * 1e3,
            f"{name}: penetration [um]": patch.penetration * 1e6, f"{name}: largest pressure [MPa]": patch.pressure.max() / 1e6,
            f"{name}: loaded nodes": int(patch.loaded.sum()), f"{name}: pieces": patch.regions,
            f"{name}: first contact point in the patch": int(patch.first_point_loaded)}


def percent(one, other):
    """By how many per cent ``one`` is above ``other``."""
    return 100 * (one / other - 1)


# --- 7.1 and 7.3: where ----------------------------------------------------------------------------


def picture(number, shift, where):
    def make(study):
        side = study.right(shift)
        numbers = {"y_wheel [mm]": side.contact.y_wheel * 1e3, "contact angle [deg]": math.degrees(side.contact_angle)}
        key = f"y_wheel {numbers['y_wheel [mm]']:.2f} mm, contact angle {numbers['contact angle [deg]']:.2f} deg"
        return SourceFigure(number, f"Right wheel's contact at {shift:g} mm, no yaw: {where}", f"Contact is in the {where}.",
                            f"It is at {key}.", HOLDS, key, numbers, outlines(study.section(shift)))

    return make


# --- 7.2 and 7.4: separation -----------------------------------------------------------------------


def turned(vertical):
    """Vertical distances over y as what they are in the contact plane: shorter by cos(delta), over s = y / cos(delta)."""
    return Separation(vertical.station * vertical.stretch, vertical.gap / vertical.stretch, vertical.wheel, vertical.rail)


@lru_cache(maxsize=None)
def separation_patches(section):
    """Nodes and patch by name of the separation, with the circle fit as lateral curvature."""
    vertical = section.vertical(FINE_DS, 1600)
    kinds = {"equidistant": section.equidistant(FINE_DS, 1600), "vertical": vertical,
             "vertical, turned": turned(vertical)}
    return {name: (nodes, study_patch(nodes, section, section.smooth_lateral(nodes, REACH), DEGREE))
            for name, nodes in kinds.items()}


def difference(section, near):
    """Vertical less equidistant separation at the same point of the wheel [m], at y (n,) within ``near`` [m]."""
    vertical, equidistant = (nodes for nodes, _ in list(separation_patches(section).values())[1::-1])
    y = np.linspace(-near, near, 201)
    lateral = section.wheel.point(equidistant.wheel)[0]
    return y, np.interp(y, vertical.station, vertical.gap) - np.interp(y, lateral, equidistant.gap)


def separation(number, shift, where):
    def make(study):
        section, complete = study.section(shift), study.complete(shift)
        found = separation_patches(section)
        patches = {name: patch for name, (_, patch) in found.items()}
        numbers = {"contact angle [deg]": math.degrees(section.angle)}
        numbers |= {f"separations differ within {near:g} mm, at most [mm]":
                    float(np.abs(difference(section, near * 1e-3)[1]).max()) * 1e3 for near in (0.25, 0.5, 1.0)}
        edge = min(-patches["vertical"].station[patches["vertical"].loaded].min(), 20e-3)
        y, apart = difference(section, edge)
        numbers["separations differ inside the patch, at most [mm]"] = float(np.abs(apart).max()) * 1e3
        for name, patch in patches.items():
            numbers |= study_sizes(name, patch)
        numbers |= sizes("complete theory", complete)
        for kind in ("equidistant", "vertical"):
            numbers |= sizes(f"wrcontact, {kind}", study.right(shift, separation=kind, lateral_curvature="smooth"))
        one, other, again = patches["equidistant"], patches["vertical"], patches["vertical, turned"]
        numbers |= {"vertical less equidistant, penetration [%]": percent(other.penetration, one.penetration),
                    "vertical less equidistant, length [%]": percent(other.length, one.length),
                    "vertical less equidistant, width in y [%]": percent(other.width, one.width * math.cos(section.angle)),
                    "turned less equidistant, penetration [%]": percent(again.penetration, one.penetration),
                    "1 / cos(contact angle) - 1 [%]": 100 * (1 / math.cos(section.angle) - 1)}
        columns = stacked(*(_separation_columns(name, *found[name], section) for name in ("equidistant", "vertical")),
                          {"curve": "vertical less equidistant", "y [mm]": y * 1e3, "separation [mm]": apart * 1e3},
                          outline_columns("complete theory", complete))
        return SourceFigure(number, f"Separation and patch at {shift:g} mm, {where}: equidistant and vertical",
                            *_separation_words(numbers, where == "tread"), numbers, columns)

    return make


def _separation_columns(name, nodes, patch, section):
    """Every fourth node, 0.2 mm apart, and all within 6 mm: where it is, its separation, and the patch there."""
    keep = (np.arange(len(nodes.station)) % 4 == 0) | (np.abs(nodes.station) < 6e-3)
    return {"curve": name, "y [mm]": section.wheel.point(nodes.wheel)[0][keep] * 1e3, "separation [mm]": nodes.gap[keep] * 1e3,
            "station [mm]": nodes.station[keep] * 1e3, "half length [mm]": patch.half_length[keep] * 1e3,
            "pressure [MPa]": patch.pressure[keep] / 1e6}


def _separation_words(numbers, on_tread):
    """Claim, finding, verdict and key."""
    length, depth = numbers["vertical less equidistant, length [%]"], numbers["vertical less equidistant, penetration [%]"]
    half, one = (numbers[f"separations differ within {near:g} mm, at most [mm]"] for near in (0.5, 1.0))
    if on_tread:
        return ("On the tread both are almost the same, and begin to differ towards the flange.",
                f"Within 1 mm of the contact they differ by {one:.1e} mm, within the patch by "
                f"{numbers['separations differ inside the patch, at most [mm]']:.1e} mm; the patch becomes {length:+.1f} % longer, the "
                f"penetration {depth:+.1f} %, with vertical distances.", HOLDS, f"penetration {depth:+.1f} %, length {length:+.1f} %")
    share, again = numbers["1 / cos(contact angle) - 1 [%]"], numbers["turned less equidistant, penetration [%]"]
    return ("They differ by 1e-4 ... 1e-3 mm around the contact; the equidistant patch is wider in y and narrower in x, "
            "because other nodes are paired.",
            f"They differ by {half:.0e} mm at 0.5 mm and {one:.0e} mm at 1 mm from the contact, and always by about a tenth: a vertical "
            f"distance is 1 / cos(contact angle) = {share:.0f} % longer. With it the patch becomes {length:.1f} % longer and "
            f"{-numbers['vertical less equidistant, width in y [%]']:.0f} % narrower in y, the penetration {depth:.1f} % larger. Pairing "
            f"is the small part: the same vertical distances, turned into the contact plane, come within {abs(again):.1f} %.",
            PARTLY, f"{half:.0e} to {one:.0e} mm within 1 mm; penetration {depth:+.1f} % with vertical distances")


# --- 7.5 to 7.10: longitudinal curvature -----------------------------------------------------------


def longitudinal_columns(section):
    """Effective and basic 1 / R along the wheel, with its abscissa."""
    y = np.linspace(max(-60e-3, section.wheel.ends[0]), min(40e-3, section.wheel.ends[1]), 501)
    return {"y_wheel [mm]": y * 1e3, "effective 2A [1/m]": 2 * section.longitudinal(y),
            "basic 2A [1/m]": 2 * section.longitudinal(y, effective=False)}


def longitudinal(number, shift, where):
    def make(study):
        section = study.section(shift)
        at = np.array(section.state.right.contact.y_wheel)
        effective, basic = (2 * float(section.longitudinal(at, kind)) for kind in (True, False))
        kernel = study.right(shift).curvature_x
        numbers = {"y_wheel [mm]": float(at) * 1e3, "contact angle [deg]": math.degrees(section.angle),
                   "effective radius [m]": 1 / effective, "basic radius [m]": 1 / basic, "kernel's radius [m]": 1 / kernel,
                   "effective / basic radius": basic / effective}
        patch = study.right(shift).outline.station
        numbers |= {"patch from y_wheel [mm]": float(at + patch[0] * math.cos(section.angle)) * 1e3,
                    "patch to y_wheel [mm]": float(at + patch[-1] * math.cos(section.angle)) * 1e3}
        columns = longitudinal_columns(section)
        if number == "7.9":
            columns = stacked({"curve": "longitudinal curvature", **columns}, outlines(section))
        key = f"R {1 / effective:.3f} m effective, {1 / basic:.3f} m basic"
        return SourceFigure(number, f"Longitudinal curvature along the wheel at {shift:g} mm, {where}: effective and basic",
                            {"tread": "On the tread the two differ little.", "flange root": "In the flange root they differ more.",
                             "flange": "On the flange they differ most: the contact angle lengthens the radius."}[where],
                            f"At the contact the radius is {1 / effective:.3f} m cut along the normal and {1 / basic:.3f} m basic, a factor of "
                            f"{basic / effective:.3f} at a contact angle of {numbers['contact angle [deg]']:.1f} deg.", HOLDS, key, numbers, columns)

    return make


def longitudinal_patches(number, shift, where):
    def make(study):
        sides = {"effective": study.right(shift), "basic": study.right(shift, longitudinal_curvature="basic"),
                 "complete theory": study.complete(shift)}
        numbers = {}
        for name, side in sides.items():
            numbers |= sizes(name, side)
        ratio = {what: numbers[f"basic: {what}"] / numbers[f"effective: {what}"] for what in
                 ("length [mm]", "width [mm]", "largest pressure [MPa]", "penetration [um]")}
        numbers |= {f"{what.split(' [')[0]}, basic / effective": value for what, value in ratio.items()}
        error = percent(numbers["basic: largest pressure [MPa]"], numbers["complete theory: largest pressure [MPa]"])
        right = percent(numbers["effective: largest pressure [MPa]"], numbers["complete theory: largest pressure [MPa]"])
        key = (f"effective {percent(1, ratio['length [mm]']):+.1f} % longer, {percent(1, ratio['width [mm]']):+.1f} % wide")
        claim = {"tread": "The difference is minor.", "flange root": "With the effective radius the patch is visibly longer in x.",
                 "flange": "With the effective radius the patch is stretched in x and narrower in s."}[where]
        return SourceFigure(
            number, f"Patch at {shift:g} mm, {where}: effective and basic longitudinal radius", claim,
            f"The effective radius makes the patch {numbers['effective: length [mm]']:.2f} mm long instead of "
            f"{numbers['basic: length [mm]']:.2f}, and {numbers['effective: width [mm]']:.2f} mm wide instead of "
            f"{numbers['basic: width [mm]']:.2f}. Against the complete theory the largest pressure is {right:+.1f} % off with it, "
            f"{error:+.1f} % without.", HOLDS, key, numbers,
            stacked(*(outline_columns(name, side) for name, side in sides.items())))

    return make


# --- 7.11 to 7.14: lateral curvature ---------------------------------------------------------------


def coordinates(curve, t, step=0.0):
    """Points (2, n) [m] of a curve in its profile's own axes, rounded to ``step`` as in a file with few decimals."""
    points = np.array([t, curve.profile.height(t)])
    return np.round(points / step) * step if step else points


def curvatures(section, nodes):
    """Curvature of wheel and rail [1/m] by name: rough, rough from rounded coordinates, smooth; pairs of arrays (n,)."""
    curves = ((section.wheel, nodes.wheel), (section.rail, nodes.rail))
    return {"rough": tuple(rough_curvature(coordinates(*pair)) for pair in curves),
            "rough, coordinates to 1 um": tuple(rough_curvature(coordinates(*pair, PRINTED)) for pair in curves),
            "smooth": tuple(circle_curvature(*pair, REACH) for pair in curves)}


def scatter(section, spacing, step):
    """Typical error [1/m] of the rough B within 15 mm of the contact: median of |B - exact B|."""
    nodes = section.equidistant(spacing, round(60e-3 / spacing))
    near = np.abs(nodes.station) < 15e-3
    wheel, rail = (rough_curvature(coordinates(curve, t, step)) for curve, t in
                   ((section.wheel, nodes.wheel), (section.rail, nodes.rail)))
    return float(np.median(np.abs((rail - wheel) / 2 - section.exact_lateral(nodes))[near]))


def lateral_curvatures(study):
    section = study.section(1.0)
    nodes = section.equidistant(DS)
    found = curvatures(section, nodes)
    columns = {"s [mm]": nodes.station * 1e3, "y_wheel [mm]": nodes.wheel * 1e3, "y_rail [mm]": nodes.rail * 1e3}
    for k, name in enumerate(("wheel", "rail")):
        columns |= {f"{name}, {kind} [1/m]": pair[k] for kind, pair in found.items()}
    exact = section.rail.curvature(nodes.rail), section.wheel.curvature(nodes.wheel)
    columns |= {"wheel, exact [1/m]": exact[1], "rail, exact [1/m]": exact[0]}
    numbers = {f"scatter of B, ds {ds:g} mm, coordinates to {step:g} mm [1/m]": scatter(section, ds / 1e3, step / 1e3)
               for ds in (0.2, 0.5, 1.0, 2.0) for step in (0.0, 1e-4, 1e-3)}
    B = section.exact_lateral(nodes)
    inside = np.abs(nodes.station) < 16e-3
    numbers["exact B from [1/m]"], numbers["exact B to [1/m]"] = float(B[inside].min()), float(B[inside].max())
    none, little, far = (numbers[f"scatter of B, ds {ds:g} mm, coordinates to {step:g} mm [1/m]"] for ds, step in
                         ((0.2, 0.0), (0.2, 1e-3), (2.0, 1e-3)))
    return SourceFigure(
        "7.11", "Lateral curvature of wheel and rail at 1 mm: three nodes 0.2 mm apart, and circles through 6 mm",
        "Three nodes give a rough curvature, the rougher the smaller ds; it is smooth from ds = 2 mm on, as a circle fit is at any ds.",
        f"On the exact profiles three nodes are not rough at all: {none:.0e} 1/m off at ds = 0.2 mm, and they follow every joint. "
        f"Rounding makes the roughness: coordinates to 1 um make B scatter by {little:.0f} 1/m, several times B itself, and at ds = 2 mm "
        f"by {far:.2f} 1/m, as it falls with 1/ds^2. The circle fit spreads each joint over 6 mm.", PARTLY,
        f"scatter of B {none:.0e} 1/m exact, {little:.0f} 1/m with coordinates to 1 um", numbers, columns)


def lateral_curvature_by(section, nodes, kind):
    """B [1/m] by the name of :func:`curvatures`."""
    wheel, rail = curvatures(section, nodes)[kind]
    return (rail - wheel) / 2


def torn(study, step, correction=None):
    """Share of lateral shifts around 1 mm at which the first contact point drops out of the rough patch."""
    count = 0
    for shift in SEVERAL:
        section = study.section(float(shift))
        nodes = section.equidistant(DS)
        wheel, rail = (rough_curvature(coordinates(curve, t, step)) for curve, t in
                       ((section.wheel, nodes.wheel), (section.rail, nodes.rail)))
        count += not study_patch(nodes, section, (rail - wheel) / 2, correction).first_point_loaded
    return count / len(SEVERAL)


def lateral_patches(number, shift):
    def make(study):
        section, complete = study.section(shift), study.complete(shift)
        nodes = section.equidistant(DS)
        patches, numbers = {}, {}
        for kind in ("rough", "rough, coordinates to 1 um", "smooth"):
            B = lateral_curvature_by(section, nodes, kind)
            patches[kind] = study_patch(nodes, section, B)
            numbers |= study_sizes(kind, patches[kind])
            numbers[f"{kind}: B at the first point [1/m]"] = float(B[np.argmin(np.abs(nodes.station))])
            mended = study_patch(nodes, section, B, DEGREE)
            numbers |= study_sizes(f"{kind}, corrected", mended)
            inside = np.abs(nodes.station) < 15e-3
            numbers[f"{kind}: B <= 0 over [mm]"] = float(np.sum(B[inside & (nodes.gap < patches[kind].penetration)] <= 0)) * DS * 1e3
        numbers |= sizes("complete theory", complete) | sizes("wrcontact", study.right(shift))
        if number == "7.14":
            for step in (0.0, 1e-8, 1e-7, 1e-6):
                numbers[f"first point out, coordinates to {step * 1e3:g} mm, share of shifts"] = torn(study, step)
                numbers[f"first point out, coordinates to {step * 1e3:g} mm, corrected, share of shifts"] = torn(study, step, DEGREE)
        columns = stacked(*(patch_columns(kind, patch) for kind, patch in patches.items()),
                          outline_columns("complete theory", complete))
        return SourceFigure(number, f"Patch at {shift:g} mm: rough and smooth lateral curvature", *_lateral_words(number, numbers),
                            numbers, columns)

    return make


def _lateral_words(number, numbers):
    """Claim, finding, verdict and key."""
    rough, smooth = (numbers[f"{kind}: loaded nodes"] for kind in ("rough", "smooth"))
    gap = numbers["rough: B <= 0 over [mm]"], numbers["smooth: B <= 0 over [mm]"]
    depth, true = numbers["rough: penetration [um]"], numbers["complete theory: penetration [um]"]
    own = numbers["wrcontact: penetration [um]"]
    here = numbers["rough: B at the first point [1/m]"]
    hole = (f"B is negative over {gap[0]:.1f} mm inside the patch, {gap[1]:.1f} mm of which the circle fit leaves; dropping them tears the "
            f"patch in two and makes the penetration {depth:.0f} um instead of {true:.0f} (wrcontact: {own:.0f}).")
    key = f"{rough} loaded nodes rough, {smooth} smooth"
    if number == "7.12":
        return ("The rough curvature leaves fewer nodes with B > 0, the smooth patch reaches further.",
                f"{rough} nodes against {smooth}, within the same width ({numbers['rough: width [mm]']:.1f} and "
                f"{numbers['smooth: width [mm]']:.1f} mm). {hole}", PARTLY, key)
    if number == "7.13":
        return ("Here the smooth curvature leaves fewer nodes: no trend.",
                f"There is one: again fewer nodes with the rough one, {rough} against {smooth}, though the smooth patch is "
                f"{numbers['rough: width [mm]'] - numbers['smooth: width [mm]']:.1f} mm less wide. {hole}", FAILS, key)
    exact, fine, file = (numbers[f"first point out, coordinates to {step} mm, share of shifts"] for step in ("0", "0.0001", "0.001"))
    return ("The rough curvature breaks the patch; even the first contact point is not in it.",
            f"Not with exact profiles: the first point has B = {here:.1f} 1/m and is in the patch at all {len(SEVERAL)} shifts from 0.9 to 1.1 mm. "
            f"With coordinates to 1 um the patch falls into {numbers['rough, coordinates to 1 um: pieces']} pieces and the first point "
            f"is out at {file:.0%} of the shifts, with 0.1 um at {fine:.0%}. {hole}", PARTLY,
            f"first point out: {exact:.0%} exact, {file:.0%} with coordinates to 1 um")


# --- 7.15 to 7.17: yaw -----------------------------------------------------------------------------


def yaw_patches(number, shift, where):
    def make(study):
        numbers, tables = {}, []
        for yaw in (0, 1, 2):
            side, complete = study.right(shift, float(yaw)), study.complete(shift, float(yaw))
            name = f"yaw {yaw} deg"
            numbers |= {f"{name}: y_wheel [mm]": side.contact.y_wheel * 1e3, f"{name}: x_wheel [mm]": side.contact.x_wheel * 1e3,
                        f"{name}: longitudinal radius [m]": 1 / side.curvature_x,
                        f"{name}: lateral radius [m]": 1 / side.curvature_y, **sizes(name, side)}
            numbers[f"{name}: complete theory, area [mm2]"] = complete.area * 1e6
            tables += [outline_columns(name, side), outline_columns(f"{name}, complete theory", complete)]
        if where == "tread":
            narrow = study.right(shift, running_circle_distance=1.5 * math.cos(math.radians(2)))
            numbers |= sizes("no yaw, wheelset narrower by cos(2 deg)", narrow)
        return SourceFigure(number, f"Patch at {shift:g} mm, {where}, for yaw 0, 1, 2 deg",
                            "Yaw changes the patch, without a clear pattern.", *_yaw_words(numbers, where), numbers, stacked(*tables))

    return make


def _yaw_words(numbers, where):
    """Finding, verdict and key."""
    area, length, width, pressure = ([numbers[f"yaw {yaw} deg: {what}"] for yaw in (0, 1, 2)] for what in
                                     ("area [mm2]", "length [mm]", "width [mm]", "largest pressure [MPa]"))
    key = f"area {', '.join(f'{value:.1f}' for value in area)} mm2"
    if where == "tread":
        narrow = numbers["no yaw, wheelset narrower by cos(2 deg): area [mm2]"]
        return (f"A pattern here: area {', '.join(f'{value:.0f}' for value in area)} mm2, largest pressure "
                f"{', '.join(f'{value:.0f}' for value in pressure)} MPa. Yaw acts as a narrower wheelset: one narrower by cos(2 deg) has "
                f"{narrow:.0f} mm2 without yaw.", PARTLY, key)
    if where == "flange root":
        return (f"0 and 1 deg are alike ({area[0]:.1f} and {area[1]:.1f} mm2); at 2 deg the wheel is on its flange, "
                f"{numbers['yaw 2 deg: x_wheel [mm]']:.0f} mm ahead (the jump is at 5.878 mm): {area[2]:.1f} mm2 and "
                f"{pressure[2] / pressure[0]:.1f} times the pressure. Patches of two places are compared; that hides the pattern.",
                PARTLY, key)
    radius = [numbers[f"yaw {yaw} deg: longitudinal radius [m]"] for yaw in (0, 1, 2)]
    return (f"A clear pattern: the patch becomes shorter ({', '.join(f'{value:.1f}' for value in length)} mm) and wider "
            f"({', '.join(f'{value:.2f}' for value in width)} mm), as the longitudinal radius falls "
            f"({', '.join(f'{value:.2f}' for value in radius)} m).", FAILS, f"length {', '.join(f'{value:.1f}' for value in length)} mm")


FIGURES = {
    "7.1": picture("7.1", 1.0, "tread"),
    "7.2": separation("7.2", 1.0, "tread"),
    "7.3": picture("7.3", 6.0, "flange root"),
    "7.4": separation("7.4", 6.0, "flange root"),
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
