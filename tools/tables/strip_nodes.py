"""Ellipses by the kernel's strips: what they give at the nodes at which exact forces are stored, and how
stiff they are."""

from functools import lru_cache
from pathlib import Path

import numpy as np

from wrcontact.creep.forces import roll
from wrcontact.creep.kalker_table import kalker_coefficients
from wrcontact.creep.patch import elliptic_patch
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import CORRECTION_UNIT
from wrcontact.kernel.creep import rolling_strips, stiffness
from wrcontact.kernel.prepare import tables as fixed

from .rolling_table import CORRECTION_NODES, assemble, stored, uncorrected

#: Where the exact forces are stored (tools/make_rolling_tables.py).
EXACT = Path(__file__).with_name("data")
#: A saturation at which forces are those of linear theory, but for so much of them.
SMALL = 1e-6
#: The forces over mu N do not depend on these.
SHEAR_MODULUS, MEAN_AXIS, FORCE, FRICTION = 80e9, 5e-3, 1e5, 0.3


def exact_forces(nu, folder=EXACT):
    """The stored arrays for a Poisson's ratio, by name; ``forces`` is (ratio, beta, alpha, rho, column)."""
    with np.load(Path(folder, f"rolling_nu{100 * nu:03.0f}.npz")) as found:
        return {name: found[name] for name in found.files}


@lru_cache(maxsize=4)
def uncorrected_tables(nu):
    """The kernel's tables (n,) of strips without correction."""
    array = np.zeros(layout.SETTING_COUNT + layout.ROLLING_TABLE_SIZE)
    tables = layout.Tables.at(array)
    tables.tangential, tables.shear_modulus = layout.TANGENTIAL_STRIPS, SHEAR_MODULUS
    tables.parameters.poisson_ratio = nu
    tables.rolling = layout.SETTING_COUNT
    table = assemble(stored()["factors"], uncorrected())
    sizes = [0.0] * fixed.FIXED_ROLLING + [float(len(table))]
    fixed.append_rolling(tables, layout.SETTING_COUNT, memoryview(np.concatenate([sizes, table])), nu)
    return array


def strip_forces(exact, nu):
    """Force and moment by uncorrected strips at the nodes of ``exact``, over mu N and mu N sqrt(ab), and the
    stick share (ratio, beta, alpha, rho, 4)."""
    beta, alpha, rho = np.meshgrid(exact["beta"], exact["alpha"], exact["rho"], indexing="ij")
    direction = np.stack([np.sin(beta), np.cos(beta) * np.cos(alpha), np.cos(beta) * np.sin(alpha)], axis=-1)
    bound = FRICTION * FORCE
    scale = bound / (MEAN_AXIS**2 * SHEAR_MODULUS) / np.array([1.0, 1.0, MEAN_AXIS])
    found = np.zeros(exact["forces"].shape)
    unit = np.array([bound, bound, bound * MEAN_AXIS, 1.0])
    workspace = np.zeros(layout.WORK_SIZE)
    work = layout.Work.at(workspace)
    rubbing, work.rolling.bare = work.patch, True
    tables = uncorrected_tables(nu)
    for k, ratio in enumerate(exact["ratio"].tolist()):
        patch = elliptic_patch(MEAN_AXIS * ratio**0.5, MEAN_AXIS * ratio**-0.5, FORCE, poisson_ratio=nu)
        wide = np.array([1.0, 1.0, (1.0 + 0.66 * ratio**-2.7) ** 0.5])
        creepages = -rho[..., None] * direction / wide * scale / exact["creep_coefficients"][k]
        for place in np.ndindex(rho.shape):
            rubbing.creepage_x, rubbing.creepage_y, rubbing.spin = creepages[place]
            rubbing.friction = FRICTION
            roll(patch, tables, workspace)
            found[(k, *place)] = (rubbing.creep_x, rubbing.creep_y, rubbing.creep_moment, rubbing.stick_share)
    return found / unit


def strip_coefficients(tables, work, ratio):
    """C11, C22, C23 (3,) of an ellipse with this a/b by the kernel's strips, on records Tables with a shear
    modulus of 1 Pa and Work."""
    patch, totals = work.patch, work.patch.totals
    patch.rule = layout.RULE_ELLIPSE
    half_width = ratio**-0.5
    totals.start, totals.stop, totals.width = -half_width, half_width, 2.0 * half_width
    totals.max_half_length, totals.area, totals.load = ratio**0.5, np.pi, 1.0
    rolling_strips.divide_into_strips(patch, work.contact.strips)
    patch.half_length, patch.half_width = ratio**0.5, half_width  # also beyond the permitted ratios
    stiffness.find_stiffnesses(tables, work.rolling, patch)
    blocks = work.rolling.blocks
    a, h, along, across, turning = np.array(
        [
            [block.half_length, block.stop - block.start, block.along, block.across, block.turning]
            for block in blocks
        ]
    ).T
    return np.array(
        [
            np.pi * (along * a * h).sum(),
            np.pi * (across * a * h).sum(),
            0.5 * np.pi * (turning * a**2 * h).sum(),
        ]
    )


def correction_slopes(exact, apart, nu):
    """What strips lack of linear theory per saturation (ratio, 5): force along x by s1, force across by s2 and
    s3, moment by s2 and s3, over mu N and mu N sqrt(ab).

    Kalker's coefficients tell the first four, C23 that of the moment by s2 too.  The moment by s3 is what
    ``apart``, exact forces less those of strips at the nodes, goes to as the saturation falls: a straight line
    through its first two nodes.
    """
    small = {name: exact[name] for name in ("ratio", "creep_coefficients")}
    small |= {
        "beta": np.array([0.0, 0.5 * np.pi]),
        "alpha": np.array([0.0, 0.5 * np.pi]),
        "rho": np.array([SMALL]),
    }
    small["forces"] = np.zeros((len(exact["ratio"]), 2, 2, 1, 4))
    found = strip_forces(small, nu)[:, :, :, 0] / SMALL
    wide = np.sqrt(1.0 + 0.66 * exact["ratio"] ** -2.7)
    first_of, second_of, third_of = exact["creep_coefficients"].T  # that the saturations are meant with
    first_true, second_true, third_true = kalker_coefficients(exact["ratio"], nu)
    first, after = exact["rho"][:2]
    turning = apart[:, 0, len(exact["alpha"]) // 2, :2, 2] / [first, after]
    return np.stack(
        [
            first_true / first_of - found[:, 1, 0, 0],
            second_true / second_of - found[:, 0, 0, 1],
            third_true / third_of / wide - found[:, 0, 1, 1],
            -third_true / second_of - found[:, 0, 0, 2],
            turning @ [after / (after - first), -first / (after - first)],
        ],
        axis=-1,
    )


def corrections(folder=EXACT):
    """The arrays of wrcontact/kernel/data/rolling_correction.npz by name, from exact forces in ``folder``."""
    all_exact = [exact_forces(nu, folder) for nu in CORRECTION_NODES]
    apart = [exact["forces"] - strip_forces(exact, nu) for nu, exact in zip(CORRECTION_NODES, all_exact)]
    numbers = np.rint(np.array(apart) / CORRECTION_UNIT)
    if np.abs(numbers).max() > np.iinfo(np.int16).max:
        raise ValueError(f"a correction is {np.abs(numbers).max() * CORRECTION_UNIT:.3g}, too large to store")
    slopes = [
        correction_slopes(exact, found, nu) for nu, exact, found in zip(CORRECTION_NODES, all_exact, apart)
    ]
    return {
        "correction": numbers.astype(np.int16),
        "slopes": np.array(slopes),
        "nu": np.array(CORRECTION_NODES),
        "creep_coefficients": np.array([exact["creep_coefficients"] for exact in all_exact]),
        "ratio": all_exact[0]["ratio"],
        "rho": all_exact[0]["rho"],
    }
