"""Which lateral curvature?  ANALYN with different ones compared with the half-space, and a picture.

    python -m benchmarks.studies.curvature [--quick] [--picture FILE]
    python -m benchmarks --write curvature        the table of docs/method.md

What was found is in docs/method.md, section 8; cases are in curvature_cases.py, the model
that takes any curvature in curvature_model.py.  A curvature is a function of a measured region that returns B
[1/m] at its stations: in 1 + beta (where the patch ends), in 1 + alpha (how long it is) and in n r (what it
carries).
"""

import sys
from dataclasses import replace
from math import inf
from pathlib import Path

import numpy as np

from wrcontact.plots import style
from wrcontact.progress import tracked, working

from . import curvature_cases
from .curvature_cases import MM, NOISE, noisy_cases, position_cases, random_cases
from .curvature_model import FLOOR, Model

PICTURE = Path("out") / "curvature_study.png"
QUICK_NOISE = NOISE[2:3]
CASES = "cases"  # the row on them


# ----------------------------------------------------------------------------------------- kinds of curvature


def windowed(region, window):
    """Half the second difference over ``window`` [m]: g''/2 averaged with a triangle of that half-width."""
    t = region.t
    return (region.rise(t + window) - 2 * region.g + region.rise(t - window)) / (2 * window**2)


def fitted(region, half):
    """From a parabola fitted to g over +-``half`` [m]: to first order a circle fitted to wheel and rail
    each."""
    u = np.linspace(-1, 1, 31)
    weights = np.linalg.pinv(np.vander(u, 3))[0] / half**2
    return sum(weight * region.rise(region.t + half * at) for weight, at in zip(weights, u))


def secant(region, window):
    """g/t^2; inside +-``window`` linear between the second difference at the origin and the secant at its
    edge."""
    t = region.t
    middle = max((region.rise(window) + region.rise(-window)) / (2 * window**2), 0.0)
    edge = np.where(t < 0, region.rise(-window), region.rise(window)) / window**2
    inside = middle + (edge - middle) * np.abs(t) / window
    return np.where(np.abs(t) < window, inside, region.g / np.maximum(t, window) ** 2 * (t > 0)
                    + region.g / np.maximum(-t, window) ** 2 * (t < 0))


def slope_secant(region, window):
    """g'/(2t), the plain mean of g''/2 between origin and station."""
    t = np.where(np.abs(region.t) < window, np.copysign(window, region.t), region.t)
    return (region.rise(t + 0.02 * window) - region.rise(t - 0.02 * window)) / (0.04 * window) / (2 * t)


def floored(region, B):
    return np.maximum(B, FLOOR * region.A)


def one(kind):
    """The same B in all three places, as in the source."""
    def curvature(region):
        B = kind(region)
        return B, B, B
    return curvature


def repaired(region):
    """Rough curvature, and where that is not positive inside the patch a polynomial through what is around: a
    cubic."""
    B, inside = windowed(region, 0.05 * region.width), (region.t > -region.left) & (region.t < region.right)
    good = inside & (B > FLOOR * region.A)
    if good.sum() < 8 or not np.any(inside & ~good):
        return B
    t = region.t / region.width
    return np.where(inside & ~good, np.polyval(np.polyfit(t[good], B[good], 3), t), B)


def quartic(region):
    """Curvature of the quartic fitted to g over the interpenetration."""
    t, inside = region.t / region.width, (region.t > -region.left) & (region.t < region.right)
    fit = np.polyfit(t[inside], region.g[inside], 4)
    return np.polyval(np.polyder(fit, 2), t) / (2 * region.width**2)


def whole(region):
    """One B for the region, level/width^2."""
    return np.full_like(region.t,
                        region.rise(np.array([-region.left, region.right])).mean() / region.width**2)


def mean(kind, other):
    return lambda region: np.sqrt(floored(region, kind(region)) * floored(region, other(region)))


def share(kind, part):
    """A kind whose window is a share of the half-width of the interpenetration."""
    return lambda region: kind(region, part * region.width)


def by_length(part):
    """Window tied to the half-length sqrt(level / 2A) instead."""
    return lambda region: windowed(region, part * np.sqrt(region.level / (2 * region.A.mean())))


def kept(region, part=0.2):
    """The kernel's first choice, sqrt(B_t max(B_t, B_s))."""
    t, s = floored(region, share(windowed, part)(region)), floored(region, share(secant, part)(region))
    return np.sqrt(t * np.maximum(t, s))


# -------------------------------------------------------------------------------------------- the one to take

WINDOW = 4 / 15  # of the half-width
SIDE_LIMIT = 4.0  # largest mean over one half-width that counts
LEAST_WINDOWED = 0.05  # of the secant
FAR_BUMP = 0.12  # share of a far bump's own curvature


def sides(region, power=2.0):
    """One B for each side of the origin: the secant to its half-width, times (mean half-width / its
    own)^2."""
    B = [region.rise(at) / at**2 * min(region.width / abs(at), SIDE_LIMIT) ** power
         for at in (-region.left, region.right)]
    return np.where(region.t < 0, *B)


def recommended(region, power=2.0):
    """B of the side where the patch ends, the secant along it, and the mean of secant and window for what it
    carries."""
    s = floored(region, share(secant, WINDOW)(region))
    w = np.maximum(share(windowed, WINDOW)(region), LEAST_WINDOWED * s)
    far = np.minimum(np.abs(region.t) / region.width, 1.0)
    return sides(region, power), s, np.sqrt(w * (s + FAR_BUMP * far * np.maximum(w - s, 0.0)))


def before(curvature):
    """A model with regions and interaction as the kernel first had them."""
    return Model(curvature, merge=0.35, push="point", share=1.0)


BEST = Model(recommended)
SCHEMES = {
    "pointwise (window 0.02 of the half-width W)": before(one(share(windowed, 0.02))),
    "three nodes 0.2 mm apart (the source's rough)": before(one(lambda region: windowed(region, 0.2 * MM))),
    "circle fit ±1 mm": before(one(lambda region: fitted(region, 1 * MM))),
    "circle fit ±3 mm (the source's smooth)": before(one(lambda region: fitted(region, 3 * MM))),
    "circle fit ±5 mm": before(one(lambda region: fitted(region, 5 * MM))),
    "rough, B ≤ 0 replaced by a cubic": before(one(repaired)),
    "quartic through the interpenetration": before(one(quartic)),
    "one B per region, level/W²": before(one(whole)),
    **{f"window {part} W": before(one(share(windowed, part))) for part in (0.1, 0.2, 0.3, 0.4)},
    "window 0.3 of the half-length √(level/2A)": before(one(by_length(0.3))),
    "secant g/s²": before(one(share(secant, 0.2))),
    "slope secant g′/2s": before(one(share(slope_secant, 0.2))),
    "√(window · secant)": before(one(mean(share(windowed, 0.2), share(secant, 0.2)))),
    "√(window · slope secant)": before(one(mean(share(windowed, 0.2), share(slope_secant, 0.2)))),
    "√(window · max(window, secant)), eq. (7.4)": before(one(kept)),
    "three B's, one region": replace(BEST, merge=inf),
    "three B's, regions without interaction": replace(BEST, push=None),
    "three B's, interaction of points": replace(BEST, push="point"),
    "three B's, plain side secant": replace(BEST, curvature=lambda region: recommended(region, power=0.0)),
    "**three B's, extended interaction**": BEST,
    "three B's, interaction felt station by station": replace(BEST, push="station"),
}

# --------------------------------------------------------------------------------------------- the experiment


def errors(model, cases):
    """Errors of penetration, area and peak pressure [%] (cases, 3)."""
    return np.array([100 * (np.array(model.solve(case)[0]) / case.truth - 1) for case in cases])


def mean_and(worst, error):
    """Mean and another summary of the sizes of errors [%] (cases, 3)."""
    return np.abs(error).mean(axis=0), worst(np.abs(error), axis=0)


def percentile(values, axis):
    return np.percentile(values, 95, axis=axis)


def study(quick=False):
    """Rows by lateral curvature: mean and worst errors [%] of each kind of cases; and one row on the
    cases."""
    with working("half-space of the curvature study", 3) as advance:
        positions = position_cases()
        advance()
        random = random_cases(12 if quick else 120)
        advance()
        noisy = noisy_cases(noise=QUICK_NOISE, seeds=1) if quick else noisy_cases()
        advance()
    rows = {}
    for name, model in tracked(SCHEMES.items(), "lateral curvatures", len(SCHEMES)):
        place, drawn, noise = (errors(model, cases) for cases in (positions, random, noisy))
        lift = np.array([case.truth / case.noiseless for case in noisy])
        clean = np.abs(100 * ((1 + noise / 100) * lift - 1))
        rows[name] = {"positions": mean_and(np.max, place), "random": mean_and(np.max, drawn),
                      "noisy": mean_and(percentile, noise), "clean": clean.mean(axis=0)}
    moved = np.array([case.truth / case.noiseless - 1 for case in noisy])
    rows[CASES] = {"count": (len(positions), len(random), len(noisy)),
                   "moved": 100 * np.abs(moved).mean(axis=0)}
    return rows


def main(quick=False, picture=PICTURE):
    """Print the study and draw its picture."""
    for name, row in study(quick).items():
        print(name, *(np.round(values, 1).tolist() for values in row.values()))
    Path(picture).parent.mkdir(parents=True, exist_ok=True)
    print(f"picture: {style.save(draw(position_cases()), picture)}")


# ------------------------------------------------------------------------------------------------ the picture

DRAWN = {"circle fit ±3 mm (the source's smooth)": "#999999",
         "√(window · max(window, secant)), eq. (7.4)": "#0072B2",
         "**three B's, extended interaction**": "#D55E00"}
SHOWN = (1.5, 5.0)  # [mm]


@style.styled
def draw(positions):
    """Errors over the positions, and two patches: curvature, half-length and pressure along the wheel."""
    figure = style.new_figure(10, 8)
    panels = figure.subplots(3, 3)
    shifts = curvature_cases.POSITIONS
    for name, colour in DRAWN.items():
        error = errors(SCHEMES[name], positions)
        for panel, column, title in zip(panels[0], error.T, ("penetration", "area", "peak pressure")):
            panel.plot(shifts, column, "o-", color=colour, markersize=3, label=name.strip("*"))
            panel.set(title=f"error in {title} [%]", xlabel="lateral shift [mm]")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside upper left", ncols=3)
    for panel in panels[0]:
        panel.axhline(0, color=style.QUIET, linewidth=0.8)
    for row, shift in zip(panels[1:], SHOWN):
        draw_patch(row, positions[shifts.index(shift)])
    return figure


def draw_patch(row, case):
    truth, patch = case.solution, case.solution.pressure
    cell = truth.x[1] - truth.x[0]
    row[1].plot(truth.s / MM, (patch > 0).sum(axis=0) * cell / 2 / MM, color=style.INK, label="half-space")
    row[2].plot(truth.s / MM, patch.max(axis=0) / 1e6, color=style.INK)
    for name, colour in list(DRAWN.items())[1:]:
        for region in SCHEMES[name].solve(case)[1]:
            s = (region.origin + region.t) / MM
            row[1].plot(s, region.half_length / MM, color=colour)
            row[2].plot(s, region.pressure / 1e6, color=colour)
    for region in BEST.solve(case)[1]:
        s = (region.origin + region.t) / MM
        for B, look in ((windowed(region, 0.02 * region.width), ":"), (recommended(region)[1], "--"),
                        (recommended(region)[2], "-")):
            row[0].plot(s, B, look, color=style.INK if look == ":"
                        else DRAWN["**three B's, extended interaction**"])
    row[0].set(title=f"{case.name}: B [1/m], dotted pointwise", ylim=(-2, 9), xlabel="station [mm]")
    row[1].set(title="half-length [mm]", xlabel="station [mm]")
    row[2].set(title="pressure on x = 0 [MPa]", xlabel="station [mm]")
    for panel in row:
        panel.set_xlim(truth.s[0] / MM, truth.s[-1] / MM)


if __name__ == "__main__":
    arguments = sys.argv[1:]
    chosen = arguments[arguments.index("--picture") + 1] if "--picture" in arguments else PICTURE
    main(quick="--quick" in arguments, picture=chosen)
