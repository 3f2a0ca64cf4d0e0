"""The source's figures of chapters 4 and 5: roll and contact position over the lateral shift."""

import math
from functools import lru_cache

import numpy as np

from .figure import FAILS, FORCE, HOLDS, PARTLY, SourceFigure, listed, stacked
from .search import Search2D, Search3D

STEP = 0.1  # [mm] of lateral shift between the source's searches
FINE = 0.02  # [mm] between points of an exact curve
FAR = 8.0  # [mm] largest lateral shift
LEAP = 0.5  # [mm] a contact that moves further within a nanometre of lateral shift jumps
# [mm] beside a jump the places are stated; the printed S1002 takes the last one in two steps, 1 um apart
CLOSE = 2e-3
BESIDE = 0.02  # [mm] from a jump at which slopes are taken
# [mm] y_wheel where the flange root begins and between its contacts and those on the flange
ROOT, FLANGE = -26.0, -36.5
FLANGE_ROLL = 0.1  # [deg] a roll that the wheelset has on the flange only
# [mm] of lateral shift, where the pressure goes from the flange root to the flange
NEAR_FLANGE = (6.2, 6.35)
ON_FLANGE = 6.3  # [mm] of lateral shift, from where the source sees a difference
YAWS = (0, 1, 2, 3)  # [deg]
SMALL_FORCE = 1e-4  # [N]


# --- curves ----------------------------------------------------------------------------------------


def shifts(first, step):
    """Lateral shifts from ``first`` to FAR [mm]."""
    return np.round(np.arange(round((FAR - first) / step) + 1) * step + first, 9)


def exact(study, shift, yaw=0.0):
    """Rigid contact at lateral shifts [mm] (n,) and a yaw [deg]."""
    return study.system().evaluate_many(
        lateral_shift=np.asarray(shift) / 1e3, yaw=math.radians(yaw), normal_force=0.0, outputs="geometry"
    )


def elastic(study, shift, yaw=0.0, force=FORCE):
    """Elastic equilibrium there."""
    return study.elastic.evaluate_many(
        lateral_shift=np.asarray(shift) / 1e3, yaw=math.radians(yaw), normal_force=force, outputs="patches"
    )


def roll(state):
    return np.degrees(state.roll)


def place(state):
    return state.right.contact.y_wheel * 1e3


def pressed_place(state):
    """Where the centre of pressure is on the right wheel [mm]: the contact position of an elastic contact.

    Its station in the contact plane, from the contact point, is laid along the wheel at the contact angle.
    """
    side = state.right
    return (side.contact.y_wheel + side.patch_centroid * np.cos(side.contact_angle)) * 1e3


def searched(search, shift, yaw=0.0):
    """Roll [deg], y_wheel and x_wheel of the right contact [mm] of a search; three arrays (n,)."""
    found = [search.solve(value / 1e3, math.radians(yaw)) for value in shift]
    return tuple(
        np.array(values)
        for values in zip(
            *((math.degrees(one.roll), one.right.y_wheel * 1e3, one.right.x_wheel * 1e3) for one in found)
        )
    )


def jumps(study, yaw=0.0, low=0.0, high=FAR):
    """Jumps of the right contact between two lateral shifts [mm]: (lateral shift,
    y_wheel before, after) [mm]."""
    grid = np.round(np.arange(low, high + FINE / 2, FINE), 9)
    places = place(exact(study, grid, yaw))
    found = [_jump_between(study, yaw, *step) for step in zip(grid, grid[1:], places, places[1:])]
    there = np.array([shift for shift in found if shift is not None])
    return list(
        zip(there.tolist(), *(place(exact(study, there + side, yaw)).tolist() for side in (-CLOSE, CLOSE)))
    )


def _jump_between(study, yaw, a, b, before, after):
    """Lateral shift [mm] of the largest jump between ``a`` and ``b`` with these
    places; None if there is none."""
    while abs(after - before) > LEAP and b - a > 1e-6:
        middle = 0.5 * (a + b)
        here = float(place(exact(study, [middle], yaw))[0])
        first = abs(here - before) > abs(after - here)
        a, b, before, after = (a, middle, before, here) if first else (middle, b, here, after)
    return b if abs(after - before) > LEAP else None


def slopes(study, shift, yaw=0.0):
    """Slope of the roll before and behind a lateral shift [mm], [deg/mm], and what the roll changes
    within 2e-6 mm [deg]."""
    at = shift + np.array([-2 * BESIDE, -BESIDE, -1e-6, 1e-6, BESIDE, 2 * BESIDE])
    values = roll(exact(study, at, yaw))
    return (values[1] - values[0]) / BESIDE, (values[5] - values[4]) / BESIDE, abs(values[3] - values[2])


def largest(values):
    """Largest magnitude; a pose without an answer (NaN) is left out."""
    return float(np.nanmax(np.abs(values)))


def steepest(shift, values):
    """Largest change between neighbours over their distance."""
    return largest(np.diff(values) / np.diff(shift))


def first_below(shift, values, level):
    """Where ``values`` first fall below ``level``, on the straight line between two of them."""
    k = int(np.argmax(values < level))
    return float(np.interp(-level, -values[k - 1 : k + 1], shift[k - 1 : k + 1]))


def joined(curves, grid, name):
    """Long table of ``curves`` (values over ``grid`` [mm], or both) under the heading ``name``."""
    return stacked(
        *(
            {"curve": curve, "lateral shift [mm]": at, name: values}
            for curve, (at, values) in (
                (curve, entry if isinstance(entry, tuple) else (grid, entry))
                for curve, entry in curves.items()
            )
        )
    )


@lru_cache(maxsize=1)
def plane_sweep(study):
    """Of the source's 2-D search with dy = 0.1 mm: lateral shifts, roll, y_wheel."""
    grid = shifts(-FAR, STEP)
    return grid, *searched(Search2D(study.system()), grid)[:2]


@lru_cache(maxsize=1)
def yawed_sweep(study):
    """Of the source's 3-D search with dx = 0.1 mm, by yaw [deg]: roll, y_wheel,
    x_wheel over lateral shifts [mm]."""
    grid, search = shifts(0.0, STEP), Search3D(study.system())
    return grid, {yaw: searched(search, grid, yaw) for yaw in YAWS}


# --- chapter 4 -------------------------------------------------------------------------------------


def roll_without_yaw(study):
    grid, found, _ = plane_sweep(study)
    fine = shifts(-FAR, FINE)
    rigid, soft = roll(exact(study, fine)), roll(elastic(study, fine))
    _, root, flange = (shift for shift, *_ in jumps(study))
    (root_low, root_high, root_step), (low, high, flange_step) = slopes(study, root), slopes(study, flange)
    root_bend, flange_bend = root_high / root_low, high / low
    later = first_below(fine, soft, -FLANGE_ROLL) - first_below(fine, rigid, -FLANGE_ROLL)
    numbers = {
        "bend to the flange root at [mm]": root,
        "bend to the flange at [mm]": flange,
        "change of roll at the jump to the flange root [deg]": root_step,
        "change of roll at the jump to the flange [deg]": flange_step,
        "slope, flange root / tread": root_bend,
        "slope, flange / flange root": flange_bend,
        "2-D search less exact, largest [deg]": largest(found - roll(exact(study, grid))),
        "steepest rigid [deg/mm]": steepest(fine, rigid),
        "steepest elastic [deg/mm]": steepest(fine, soft),
        f"elastic roll of {FLANGE_ROLL} deg comes later by [mm]": later,
        "roughness of the elastic roll between flange root and flange [deg]": _roughness(study),
    }
    return SourceFigure(
        "4.4",
        "Roll over lateral shift: rigid search against elastic contact",
        "roll, rigid and elastic",
        "Rigid roll jumps where the contact moves from tread to flange root and to the flange; elastic "
        "contact smooths it.",
        f"The roll does not jump, it bends: its slope grows {root_bend:.1f}-fold at {root:.3f} mm and "
        f"{flange_bend:.0f}-fold at {flange:.3f} mm, while it is continuous. Only the place jumps (4.5). "
        f"Elastic contact at 78.5 kN rounds the first bend; on the flange it rolls {later:.2f} mm later, no "
        "less steeply.",
        PARTLY,
        f"slope x {flange_bend:.0f} at {flange:.3f} mm, no jump",
        numbers,
        joined(
            {
                "source's 2-D search, dy 0.1 mm": (grid, found),
                "rigid, exact": rigid,
                "elastic, 78.5 kN": soft,
            },
            fine,
            "roll [deg]",
        ),
    )


def _roughness(study):
    """Largest second difference of the elastic roll [deg] where the pressure goes from the
    flange root to the flange."""
    grid = np.arange(NEAR_FLANGE[0], NEAR_FLANGE[1], FINE / 5)
    return largest(np.diff(roll(elastic(study, grid)), 2))


def place_without_yaw(study):
    grid, _, found = plane_sweep(study)
    fine = shifts(-FAR, FINE)
    rigid, soft = place(exact(study, fine)), pressed_place(elastic(study, fine))
    there = jumps(study)
    numbers = {f"jump {k + 1} at [mm]": shift for k, (shift, _, _) in enumerate(there)}
    numbers |= {f"jump {k + 1} by [mm]": after - before for k, (_, before, after) in enumerate(there)}
    most, least = (largest(np.diff(places)) for places in (rigid, soft))
    before = largest(np.diff(soft)[fine[1:] < NEAR_FLANGE[0]])
    numbers |= {
        "largest step, rigid [mm]": most,
        "largest step, elastic [mm]": least,
        "largest step before the flange, elastic [mm]": before,
    }
    words = ", ".join(f"{shift:.3f} mm ({before:.1f} to {after:.1f})" for shift, before, after in there)
    return SourceFigure(
        "4.5",
        "Lateral contact position on the right wheel: rigid search against elastic contact",
        "contact position",
        "The rigid contact jumps from tread to flange root and from flange root to flange; elastic contact "
        "is smooth.",
        f"y_wheel jumps at {words}: three jumps, the first on the tread. With 78.5 kN the centre of pressure "
        f"moves by at most {before:.2f} mm in {FINE} mm of shift instead of {most:.1f} mm; to the flange it "
        f"still goes in steps of {least:.0f} mm.",
        HOLDS,
        f"jumps at {listed((shift for shift, *_ in there), 3)} mm",
        numbers,
        joined(
            {
                "source's 2-D search, dy 0.1 mm": (grid, found),
                "rigid, exact": rigid,
                "elastic, 78.5 kN": soft,
            },
            fine,
            "y_wheel [mm]",
        ),
    )


def place_with_little_force(study):
    grid, _, found = plane_sweep(study)
    fine = shifts(-FAR, FINE)
    rigid, soft = place(exact(study, fine)), pressed_place(elastic(study, fine, force=SMALL_FORCE))
    coarse = searched(Search2D(study.system(), spacing=1e-3, tolerance=1e-6), grid)[1]
    known, flange = place(exact(study, grid)), np.abs(grid) > ON_FLANGE
    near, far = (largest((places - known)[flange]) for places in (found, coarse))
    numbers = {
        "2-D search dy 0.1 mm less exact, flange, largest [mm]": near,
        "2-D search dy 1 mm less exact, flange, largest [mm]": far,
    }
    beyond = np.abs(fine) > ON_FLANGE
    away = np.min(np.abs(fine[:, None] - [shift for shift, *_ in jumps(study, low=-FAR)]), axis=1) > FINE
    there, elsewhere = (largest((soft - rigid)[away & where]) for where in (beyond, ~beyond))
    numbers |= {
        "elastic at 1e-4 N less rigid, flange, largest [mm]": there,
        "elastic at 1e-4 N less rigid, elsewhere, largest [mm]": elsewhere,
    }
    return SourceFigure(
        "4.6",
        "Lateral contact position on the right wheel: elastic contact with next to no force",
        "the same at 1e-4 N",
        "At 1e-4 N both agree on tread and flange root, but beyond 6.3 mm they differ noticeably.",
        f"Away from the jumps elastic contact at 1e-4 N is rigid contact, to {there:.0e} mm on the flange "
        f"and {elsewhere:.0e} mm elsewhere. So the difference on the flange is one of the two programs, not "
        f"of elasticity. Coarse nodes can make one: with dy = 1 mm the 2-D search is up to {far:.1f} mm off "
        f"there, with 0.1 mm {near:.2f} mm.",
        FAILS,
        f"flange: {there:.0e} mm from rigid",
        numbers,
        joined(
            {
                "source's 2-D search, dy 0.1 mm": (grid, found),
                "source's 2-D search, dy 1 mm": (grid, coarse),
                "rigid, exact": rigid,
                "elastic, 1e-4 N": soft,
            },
            fine,
            "y_wheel [mm]",
        ),
    )


# --- chapter 5 -------------------------------------------------------------------------------------


def roll_with_yaw_elastic(study):
    grid, found = yawed_sweep(study)
    fine = shifts(0.0, FINE)
    curves, numbers = {}, {}
    for yaw in (0, 1):
        rigid, soft = roll(exact(study, fine, yaw)), roll(elastic(study, fine, yaw))
        curves |= {
            f"source's 3-D search, dx 0.1 mm, yaw {yaw} deg": (grid, found[yaw][0]),
            f"rigid, exact, yaw {yaw} deg": rigid,
            f"elastic, 78.5 kN, yaw {yaw} deg": soft,
        }
        root = next(shift for shift, before, after in jumps(study, yaw) if before > ROOT > after)
        low, high, step = slopes(study, root, yaw)
        numbers |= {
            f"yaw {yaw} deg: bend at [mm]": root,
            f"yaw {yaw} deg: slope behind / before": high / low,
            f"yaw {yaw} deg: step of the roll [deg]": step,
        }
        numbers |= {
            f"yaw {yaw} deg: {name}": value for name, value in _softer(fine, rigid, soft, root).items()
        }
    share, least, most = (numbers[f"yaw 0 deg: {name}"] for name in SOFTER)
    at, at_one = (numbers[f"yaw {yaw} deg: bend at [mm]"] for yaw in (0, 1))
    bend, bend_one = (numbers[f"yaw {yaw} deg: slope behind / before"] for yaw in (0, 1))
    return SourceFigure(
        "5.6",
        "Roll over lateral shift, yaw 0 and 1 deg: rigid 3-D search, elastic contact",
        "roll, yaw 0 and 1 deg",
        "The rigid roll has a slight jump near 5 mm that elastic contact (Baeza) has not, and is higher at "
        "the same shift.",
        f"It is a bend: the roll's slope grows {bend:.1f}-fold at {at:.3f} mm without yaw and "
        f"{bend_one:.1f}-fold at {at_one:.3f} mm with 1 deg; the roll itself does not step. The elastic roll "
        f"bends gradually there; it is the smaller one at {share:.0%} of the shifts, by up to {most:.3f} "
        f"deg, and elsewhere the larger one by up to {least:.4f} deg.",
        PARTLY,
        f"slope x {bend:.1f} at {at:.3f}, {at_one:.3f} mm, no jump",
        numbers,
        joined(curves, fine, "roll [deg]"),
    )


#: Names of what is compared of elastic and rigid roll.
SOFTER = (
    "share of shifts with less elastic roll",
    "elastic less rigid, largest [deg]",
    "rigid less elastic, largest [deg]",
)


def _softer(shift, rigid, soft, bend):
    """What elastic contact makes of the roll, by the names of SOFTER; and its slopes on both
    sides of ``bend`` [mm]."""
    more = np.abs(soft) - np.abs(rigid)
    values = float(np.mean(more[1:] < 0)), float(np.nanmax(more)), float(-np.nanmin(more))
    at = np.interp([bend - 0.4, bend, bend + 0.4], shift, soft)
    return dict(zip(SOFTER, values)) | {
        "elastic slope, 0.4 mm behind / before": float((at[2] - at[1]) / (at[1] - at[0]))
    }


def flange_root_picture(study):
    section, side = study.section(5.0), study.right(5.0)
    shift, before, after = next(jump for jump in jumps(study) if jump[1] > ROOT > jump[2])
    here, clear = side.contact.y_wheel * 1e3, _other_gap(section, before) * 1e6
    numbers = {
        "y_wheel [mm]": here,
        "contact angle [deg]": math.degrees(side.contact_angle),
        "jump at [mm]": shift,
        "before [mm]": before,
        "behind [mm]": after,
        "gap at the other place [um]": clear,
        "patches under load": side.patch_count,
    }
    return SourceFigure(
        "5.7",
        "Right wheel's contact at 5 mm, no yaw",
        "contact at 5 mm",
        "The contact has moved from the tread side of the flange root to its flange side.",
        f"At 5 mm it is at y_wheel = {here:.2f} mm, {5 - shift:.2f} mm of shift behind the jump from "
        f"{before:.1f} to {after:.1f} mm. The place it left is {clear:.0f} um clear of the rail: under 78.5 "
        f"kN both carry, in {side.patch_count} patches.",
        HOLDS,
        f"y_wheel {here:.2f} mm",
        numbers,
        outlines(section),
    )


def _other_gap(section, y_wheel):
    """Smallest vertical gap [m] within 3 mm of ``y_wheel`` [mm]."""
    nodes = section.vertical(2e-5, 2000)
    return float(nodes.gap[np.abs(nodes.wheel * 1e3 - y_wheel) < 3].min())


def outlines(section):
    """Wheel, rail and contact point on the track: y to the right, height above top of rail [mm]."""
    contact = section.state.right.contact
    origin = np.array([contact.y_track, contact.z_track])[:, None]
    tables = []
    for name, curve, span in (
        ("wheel", section.wheel, (-0.068, 0.06)),
        ("rail", section.rail, (-0.05, 0.05)),
    ):
        low, high = max(span[0], curve.ends[0]), min(span[1], curve.ends[1])
        y, z = (curve.point(np.linspace(low, high, 301)) + origin) * 1e3
        tables.append({"curve": name, "y_track [mm]": y, "height [mm]": -z})
    tables.append(
        {"curve": "contact point", "y_track [mm]": origin[0] * 1e3, "height [mm]": -origin[1] * 1e3}
    )
    return stacked(*tables)


def roll_with_yaw(study):
    grid, found = yawed_sweep(study)
    fine = shifts(0.0, FINE)
    curves, numbers = {}, {}
    for yaw in YAWS:
        curves |= {
            f"exact, yaw {yaw} deg": roll(exact(study, fine, yaw)),
            f"source's 3-D search, yaw {yaw} deg": (grid, found[yaw][0]),
        }
        for name, low, high in (("flange root", FLANGE, ROOT), ("flange", -60, FLANGE)):
            here = [shift for shift, before, after in jumps(study, yaw) if low < after < high < before]
            numbers[f"yaw {yaw} deg: jump to the {name} [mm]"] = here[0] if here else math.nan
        numbers[f"yaw {yaw} deg: roll at 3 mm [deg]"] = float(roll(exact(study, [3.0], yaw))[0])
    numbers |= _why_less(study)
    flange, root = (
        [numbers[f"yaw {yaw} deg: jump to the {name} [mm]"] for yaw in YAWS]
        for name in ("flange", "flange root")
    )
    bare, turned = (numbers[f"yaw {yaw} deg: roll at 3 mm [deg]"] for yaw in (0, 1))
    rise, share = (numbers[name] for name in WHY)
    return SourceFigure(
        "5.8",
        "Roll over lateral shift for yaw 0, 1, 2, 3 deg",
        "roll, yaw 0 ... 3 deg",
        "With yaw the jump comes at smaller shifts, as flange contact does; on tread and flange root the "
        "roll is smaller, because the contact, further from the principal profile, is nearer to the axle.",
        f"Flange contact comes earlier, at {listed(flange, 3)} mm, but the flange root later, at "
        f"{listed(root[:3], 3)} mm and at 3 deg never. Before, the roll is smaller ({bare:.4f} deg at 3 mm, "
        f"{turned:.4f} with 1 deg), but not for that reason: the contact rises by {rise:.1f} um only. A "
        f"yawed wheelset is a narrower one: one narrower by cos(yaw) has {share:.0f} % of that change "
        "without any yaw.",
        PARTLY,
        f"flange at {listed(flange, 3)} mm",
        numbers,
        joined(curves, fine, "roll [deg]"),
    )


#: Names of what explains the smaller roll with yaw.
WHY = (
    "3 mm, 1 deg: rise of the contact towards the axle [um]",
    "3 mm: change of roll of a wheelset narrower by cos(1 deg), of that with 1 deg [%]",
)


def _why_less(study):
    """The source's reason for the smaller roll and another one, by the names of WHY."""
    narrower = study.system(running_circle_distance=1.5 * math.cos(math.radians(1)))
    cases = (study.system(), 0.0), (narrower, 0.0), (study.system(), math.radians(1))
    bare, narrow, yawed = (
        system.evaluate(lateral_shift=3e-3, yaw=yaw, normal_force=0.0, outputs="geometry")
        for system, yaw in cases
    )
    rise = yawed.right.contact.x_wheel**2 / (2 * yawed.right.rolling_radius)
    return dict(zip(WHY, (rise * 1e6, 100 * (narrow.roll - bare.roll) / (yawed.roll - bare.roll))))


def shift_with_yaw(study):
    grid, found = yawed_sweep(study)
    fine = shifts(0.0, FINE)
    curves, numbers = {}, {}
    for yaw in YAWS:
        x = exact(study, fine, yaw).right.contact.x_wheel * 1e3
        curves |= {f"exact, yaw {yaw} deg": x, f"source's 3-D search, yaw {yaw} deg": (grid, found[yaw][2])}
        numbers[f"yaw {yaw} deg: largest [mm]"] = float(x.max()) + 0.0
        places = exact(study, [1.0, 6.5, 8.0], yaw).right.contact.x_wheel * 1e3 + 0.0
        numbers |= {
            f"yaw {yaw} deg at {at:g} mm [mm]": float(place) for at, place in zip((1.0, 6.5, 8.0), places)
        }
    first, later, last = (
        numbers[f"yaw 1 deg{name}"] for name in (": largest [mm]", " at 6.5 mm [mm]", " at 8 mm [mm]")
    )
    two, three, most = (
        numbers[f"yaw {name} [mm]"] for name in ("2 deg at 1 mm", "3 deg at 1 mm", "3 deg: largest")
    )
    return SourceFigure(
        "5.9",
        "Longitudinal shift of the right contact for yaw 0, 1, 2, 3 deg",
        "longitudinal shift",
        "With yaw the contact moves ahead of the axle, about 20 mm in flange contact at 1 deg.",
        f"At 1 deg it is {first:.1f} mm ahead where flange contact begins, {later:.1f} mm at 6.5 mm and "
        f"{last:.1f} mm at 8 mm; at 3 deg up to {most:.0f} mm. More yaw is not always further ahead: at 1 mm "
        f"it is {two:.2f} mm with 2 deg and {three:.2f} mm with 3, as the contact is then on the other side "
        "of the first jump.",
        HOLDS,
        f"flange, 1 deg: {first:.1f} ... {last:.1f} mm",
        numbers,
        joined(curves, fine, "x_wheel [mm]"),
    )


FIGURES = {
    "4.4": roll_without_yaw,
    "4.5": place_without_yaw,
    "4.6": place_with_little_force,
    "5.6": roll_with_yaw_elastic,
    "5.7": flange_root_picture,
    "5.8": roll_with_yaw,
    "5.9": shift_with_yaw,
}
