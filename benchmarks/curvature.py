"""Which lateral curvature?  ANALYN with different ones compared with the half-space.

    python -m benchmarks --write curvature        the table of docs/theory

What was found is in docs/theory/curvature.md; the model that takes any curvature is in
curvature_model.py.
A curvature is a function of a measured region that returns B [1/m] at its stations: in 1 + beta (where the
patch ends), in 1 + alpha (how long it is) and in n r (what it carries).

Cases are contacts with a known answer: gap curve g(s), A(s), force, and the half-space's solution.

    positions   S1002 on UIC60 1:40 at 0 ... 6.5 mm, 78.5 kN
    random      three rails, two inclinations, half of them yawed, 3 ... 200 kN
    noisy       measured-like profiles: sampled, smoothed noise added, read as a file is; two truths, with and
                without the noise

The truth is frictionless half-space theory (data/halfspace_reference.py) for h = A(s) x^2 + g(s),
which is what ANALYN is given.
"""

from dataclasses import dataclass, replace
from math import inf

import numpy as np
from scipy.interpolate import CubicSpline, make_smoothing_spline

import wrcontact
from data import halfspace_reference
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel
from wrcontact.kernel.contact import frame, penetrated, traces
from wrcontact.profiles.placement import readable_wheel
from wrcontact.progress import tracked, working

from .curvature_model import FLOOR, Model

CASES = "cases"  # the row on them
MM = 1e-3
POSITIONS = (0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 4.7, 5, 5.2, 5.5, 5.8, 6, 6.2, 6.3, 6.4, 6.5)  # [mm]
FORCE = 78.5e3  # [N]
NOISY_POSITIONS = (0, 1.5, 3, 6, 6.4)  # [mm]
#: Spacing [mm] and standard deviation [um] of the noise, and cut-off wavelength of its smoothing [mm].
NOISE = (
    (0.1, 2, 4),
    (0.1, 5, 4),
    (0.1, 10, 4),
    (0.1, 20, 4),
    (0.2, 5, 4),
    (0.2, 20, 4),
    (0.5, 2, 4),
    (0.5, 10, 4),
)
SEEDS = 2

REACH = 45e-3  # [m] stations beyond are not looked at
LOOKED_AT = 3.0  # times the penetration: the gap up to which a curve is kept
STATIONS = 1200
LEAST = 10  # coarse stations near the contact; noise at a profile's end leaves fewer
FINE = 100  # cells of the half-space over the patch
FINEST_WIDE = 0.07e-3  # [m] largest cell across the rail
OUTSIDE = 20e-3  # [m] gap where there is none
QUICK_NOISE = NOISE[2:3]


@dataclass
class Case:
    """One wheel's contact: stations s, gap g and A (n,), force [N], and truth = (penetration, area, peak
    pressure)."""

    name: str
    s: np.ndarray
    g: np.ndarray
    A: np.ndarray
    force: float
    truth: np.ndarray = None
    kernel: np.ndarray = None  # the answer of the kernel as it is
    solution: object = None  # the half-space's, with its pressures
    noiseless: np.ndarray = None  # noisy profiles: the truth without the noise


# ------------------------------------------------------------------------------------------------- gap curves


def gap_curve(system, shift, yaw, force, name):
    """The right wheel's :class:`Case` at a pose, its truth still unknown; None where it has no contact."""
    tables, work = system._tables.copy(), np.zeros(layout.WORK_SIZE)
    state, inputs, outputs = (
        np.zeros(n) for n in (layout.STATE_SIZE, layout.INPUT_COUNT, layout.OUTPUT_COUNT)
    )
    inputs[[layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]] = shift, yaw, force
    if default_kernel().bind(tables, state, work, inputs, outputs).step() != 0:
        return None
    right = layout.OUT_RIGHT  # solved last: the contact frame left in the workspace is its
    kernel = np.array(
        [outputs[right + at] for at in (layout.SIDE_PENETRATION, layout.SIDE_AREA, layout.SIDE_MAX_PRESSURE)]
    )
    coarse = np.linspace(-REACH, REACH, 1801)
    near = coarse[normal_gaps(tables, work, coarse)[0] < LOOKED_AT * kernel[0]]
    if len(near) < LEAST:
        return None
    s = np.linspace(near[0] - 1e-4, near[-1] + 1e-4, STATIONS)
    g, A = normal_gaps(tables, work, s)
    there = g < frame.NO_GAP
    return Case(name, s[there], g[there], A[there], force, kernel=kernel)


def normal_gaps(tables, work, s):
    """Gap [m] and A = 1/(2 R_x) [1/m] at stations ``s`` (n,), rising; traced from the contact point
    outwards."""
    pair, work = layout.Tables.at(tables).pairs[1], layout.Work.at(work)
    g, A = np.full(len(s), frame.NO_GAP), np.ones(len(s))
    middle = int(np.searchsorted(s, 0.0))
    for stations in (range(middle, len(s)), range(middle - 1, -1, -1)):
        traces.start_traces(work.contact.frame, 0.0, work.contact.frame.rail.y, work.contact.frame.wheel.y)
        for j in stations:
            gap, _, _ = frame.normal_gap(pair, work.contact.frame, float(s[j]), 1e-10)
            if gap >= frame.NO_GAP:
                break
            g[j], A[j] = gap, penetrated.met_curvature(pair, work.contact.frame) / 2
    return g, A


# ------------------------------------------------------------------------------------------------------ truth


def solve_half_space(case):
    """Half-space solution of a case on a grid fitted to its patch."""
    gap, longitudinal = CubicSpline(case.s, case.g), CubicSpline(case.s, case.A)

    def solve(low, high, cells, guess=None):
        x, s = (a + (b - a) * (np.arange(n) + 0.5) / n for a, b, n in zip(low, high, cells))
        h = gap(s) + longitudinal(s) * x[:, None] ** 2
        h[:, (s < case.s[0]) | (s > case.s[-1])] = OUTSIDE
        if guess is not None:
            look_up = halfspace_reference.RegularGridInterpolator(
                (guess.x, guess.s), guess.pressure, bounds_error=False, fill_value=0.0
            )
            guess = look_up(tuple(np.meshgrid(x, s, indexing="ij")))
        return halfspace_reference.solve(x, s, h, case.force, guess=guess)

    limit = 1.3 * case.kernel[0]
    inside, half = case.s[case.g < limit], np.sqrt(limit / case.A.min())
    coarse = solve((-half, inside[0]), (half, inside[-1]), (48, 120))
    low, high = halfspace_reference.around_patch(coarse)
    while True:
        solution = solve(low, high, (FINE, int(np.clip((high[1] - low[1]) / FINEST_WIDE, FINE, 500))), coarse)
        if not solution.touches_border:
            return solution
        low, high = low - 0.1 * (high - low), high + 0.1 * (high - low)


def with_truth(case):
    case.solution = solve_half_space(case)
    case.truth = np.array([case.solution.penetration, case.solution.area, case.solution.max_pressure])
    return case


# ------------------------------------------------------------------------------------------------------ cases


def position_cases(shifts=POSITIONS):
    system = wrcontact.ContactSystem()
    return [with_truth(gap_curve(system, shift * MM, 0.0, FORCE, f"{shift} mm")) for shift in shifts]


def random_cases(count, seed=3):
    random = np.random.default_rng(seed)
    systems = [
        (f"{rail} 1:{slope}", wrcontact.ContactSystem(rail=rail, rail_inclination=1 / slope))
        for rail in ("UIC60", "60E1", "54E1")
        for slope in (40, 20)
    ]
    cases = []
    for i in range(count):
        name, system = systems[i % 6]
        shift, yaw = random.uniform(-6.6, 6.6), random.uniform(-35e-3, 35e-3) * ((i // 6) % 2)
        force = 10 ** random.uniform(3.5, 5.3)
        cases.append(
            gap_curve(system, shift * MM, yaw, force, f"{name} {shift:.2f} mm {yaw:.3f} {force / 1e3:.0f} kN")
        )
    return [with_truth(case) for case in cases if case is not None]


def measured(profile, spacing, noise, cutoff, random):
    """``profile`` as if measured every ``spacing`` [mm] with ``noise`` [um], less what a smoothing takes out
    of that.

    The smoothing spline (least squares plus lambda times the integral of z''^2) halves waves of length
    ``cutoff`` [mm]: lambda = (cutoff / 2 pi)^4 / spacing.  It is linear, so it is applied to the noise alone;
    what it would do to the profile itself (in y it flattens the gauge corner and moves the gauge point) is
    another matter than curvature.
    """
    y = np.arange(np.ceil(profile.start / MM / spacing) + 1, profile.stop / MM / spacing - 1) * spacing
    error = random.normal(0.0, noise * 1e-3, len(y))
    if cutoff > 0:
        error = make_smoothing_spline(y, error, lam=(cutoff / (2 * np.pi)) ** 4 / spacing)(y)
    return wrcontact.Profile.from_points(
        y, profile.height(y * MM) / MM + error, name=f"{profile.name} measured", kind=profile.kind
    )


def noisy_cases(shifts=NOISY_POSITIONS, noise=NOISE, seeds=SEEDS):
    clean = wrcontact.ContactSystem()
    truths = {case.name: case.truth for case in position_cases(shifts)}
    cases = []
    for spacing, deviation, cutoff in noise:
        for seed in range(seeds):
            random = np.random.default_rng(seed)
            system = wrcontact.ContactSystem(
                measured(readable_wheel(clean.wheel), spacing, deviation, cutoff, random),
                measured(clean.rail, spacing, deviation, cutoff, random),
            )
            for shift in shifts:
                name = f"{shift} mm"
                case = gap_curve(
                    system, shift * MM, 0.0, FORCE, f"{name} {spacing} mm {deviation} um {cutoff} mm {seed}"
                )
                if case is not None:
                    case.noiseless = truths[name]
                    cases.append(with_truth(case))
    return cases


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
    return np.where(
        np.abs(t) < window,
        inside,
        region.g / np.maximum(t, window) ** 2 * (t > 0) + region.g / np.maximum(-t, window) ** 2 * (t < 0),
    )


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
    return np.full_like(
        region.t, region.rise(np.array([-region.left, region.right])).mean() / region.width**2
    )


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
    B = [
        region.rise(at) / at**2 * min(region.width / abs(at), SIDE_LIMIT) ** power
        for at in (-region.left, region.right)
    ]
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
    "√(window · max(window, secant))": before(one(kept)),
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
        rows[name] = {
            "positions": mean_and(np.max, place),
            "random": mean_and(np.max, drawn),
            "noisy": mean_and(percentile, noise),
            "clean": clean.mean(axis=0),
        }
    moved = np.array([case.truth / case.noiseless - 1 for case in noisy])
    rows[CASES] = {
        "count": (len(positions), len(random), len(noisy)),
        "moved": 100 * np.abs(moved).mean(axis=0),
    }
    return rows
