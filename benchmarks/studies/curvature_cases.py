"""Contacts with a known answer for the curvature study: gap curve g(s), A(s), force, and the half-space's
solution.

    positions   S1002 on UIC60 1:40 at 0 ... 6.5 mm, 78.5 kN
    random      three rails, two inclinations, half of them yawed, 3 ... 200 kN
    noisy       measured-like profiles: sampled, smoothed noise added, read as a file is; two truths, with and
                without the noise

The truth is frictionless half-space theory (data/halfspace_reference.py) for h = A(s) x^2 + g(s),
which is what ANALYN is given.
"""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline, make_smoothing_spline

import wrcontact
from data import halfspace_reference
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel
from wrcontact.kernel.contact import frame, traces
from wrcontact.profiles.placement import readable_wheel

MM = 1e-3
POSITIONS = (0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 4.7, 5, 5.2, 5.5, 5.8, 6, 6.2, 6.3, 6.4, 6.5)  # [mm]
FORCE = 78.5e3  # [N]
NOISY_POSITIONS = (0, 1.5, 3, 6, 6.4)  # [mm]
#: Spacing [mm] and standard deviation [um] of the noise, and cut-off wavelength of its smoothing [mm].
NOISE = ((0.1, 2, 4), (0.1, 5, 4), (0.1, 10, 4), (0.1, 20, 4), (0.2, 5, 4), (0.2, 20, 4), (0.5, 2, 4),
         (0.5, 10, 4))
#: Read as measured, noise is asperities, and the half-space carries on their tips; for trying by hand.
RAW_NOISE = ((0.5, 2, 0), (0.5, 5, 0))
SEEDS = 2

REACH = 45e-3  # [m] stations beyond are not looked at
LOOKED_AT = 3.0  # times the penetration: the gap up to which a curve is kept
STATIONS = 1200
LEAST = 10  # coarse stations near the contact; noise at a profile's end leaves fewer
FINE = 100  # cells of the half-space over the patch
FINEST_WIDE = 0.07e-3  # [m] largest cell across the rail
OUTSIDE = 20e-3  # [m] gap where there is none


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
    state, inputs, outputs = (np.zeros(n)
                              for n in (layout.STATE_SIZE, layout.INPUT_COUNT, layout.OUTPUT_COUNT))
    inputs[[layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]] = shift, yaw, force
    if default_kernel().bind(tables, state, work, inputs, outputs).step() != 0:
        return None
    right = layout.OUT_RIGHT  # solved last: the contact frame left in the workspace is its
    kernel = np.array([outputs[right + at] for at in (layout.SIDE_PENETRATION, layout.SIDE_AREA,
                                                      layout.SIDE_MAX_PRESSURE)])
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
    tables, work = layout.Tables.at(tables), layout.Work.at(work)
    g, A = np.full(len(s), frame.NO_GAP), np.ones(len(s))
    middle = int(np.searchsorted(s, 0.0))
    for stations in (range(middle, len(s)), range(middle - 1, -1, -1)):
        traces.start_traces(work.contact.frame, 0.0, work.contact.frame.rail.y, work.contact.frame.wheel.y)
        for j in stations:
            gap, _, _, curvature = frame.normal_gap(tables, work.contact.frame, float(s[j]), 1e-10)
            if gap >= frame.NO_GAP:
                break
            g[j], A[j] = gap, curvature / 2
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
            look_up = halfspace_reference.RegularGridInterpolator((guess.x, guess.s), guess.pressure,
                                                                  bounds_error=False, fill_value=0.0)
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
    systems = [(f"{rail} 1:{slope}", wrcontact.ContactSystem(rail=rail, rail_inclination=1 / slope))
               for rail in ("UIC60", "60E1", "54E1") for slope in (40, 20)]
    cases = []
    for i in range(count):
        name, system = systems[i % 6]
        shift, yaw = random.uniform(-6.6, 6.6), random.uniform(-35e-3, 35e-3) * ((i // 6) % 2)
        force = 10 ** random.uniform(3.5, 5.3)
        cases.append(gap_curve(system, shift * MM, yaw, force,
                               f"{name} {shift:.2f} mm {yaw:.3f} {force / 1e3:.0f} kN"))
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
    return wrcontact.Profile.from_points(y, profile.height(y * MM) / MM + error,
                                         name=f"{profile.name} measured", kind=profile.kind)


def noisy_cases(shifts=NOISY_POSITIONS, noise=NOISE, seeds=SEEDS):
    clean = wrcontact.ContactSystem()
    truths = {case.name: case.truth for case in position_cases(shifts)}
    cases = []
    for spacing, deviation, cutoff in noise:
        for seed in range(seeds):
            random = np.random.default_rng(seed)
            system = wrcontact.ContactSystem(measured(readable_wheel(clean.wheel), spacing, deviation, cutoff,
                                                      random),
                                             measured(clean.rail, spacing, deviation, cutoff, random))
            for shift in shifts:
                name = f"{shift} mm"
                case = gap_curve(system, shift * MM, 0.0, FORCE,
                                 f"{name} {spacing} mm {deviation} um {cutoff} mm {seed}")
                if case is not None:
                    case.noiseless = truths[name]
                    cases.append(with_truth(case))
    return cases
