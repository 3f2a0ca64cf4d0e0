"""Cases of steady rolling with their forces by the complete theory (data/creep), and the errors of
the models in them."""

import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from wrcontact.creep import elliptic_patch, forces, outlined_patch
from wrcontact.creep.kalker_table import kalker_coefficients
from wrcontact.kernel import layout
from wrcontact.methods import NUMBERS

CREEP = Path(__file__).with_name("creep")
MM = 1e-3
#: Names of the sets, as in the files.
SETS = ("hertz", "ellipses", "long_and_short", "patches", "contact_patches")


class Case(NamedTuple):
    """One case; creepages and moment hold for station zero of the patches."""

    name: str
    parts: tuple  # patches (CreepPatch) that are in contact
    creepages: tuple  # xi, eta [-], phi [1/m]
    friction: float
    force: tuple  # of the complete theory [N]
    moment: float  # [N m]
    bound: float  # mu N [N]
    size: float  # sqrt(a b) of the equivalent ellipse [m]


@cache
def cases(name):
    """The cases of one of SETS, as a tuple."""
    return tuple(
        {
            "hertz": hertz,
            "ellipses": ellipses,
            "long_and_short": long_and_short,
            "patches": outlined,
            "contact_patches": gridded,
        }[name]()
    )


def read(name):
    return json.loads((CREEP / f"{name}.json").read_text())


def hertz():
    """Ellipses by CONTACT.  Rail minus wheel and the force on the rail: both signs flip, and the relation of
    force and creepage stays."""
    found = read("hertz")
    meta = found["meta"]
    for row in found["cases"]:
        a, b, creep, contact = row["a_mm"] * MM, row["b_mm"] * MM, row["creep"], row["contact"]
        patch = elliptic_patch(a, b, meta["FN"], modulus(meta["G_MPa"], meta["nu"]), meta["nu"])
        yield Case(
            f"a/b {row['a_over_b']} {row['family']} {row['level']}",
            (patch,),
            (creep["xi"], creep["eta"], creep["phi_per_mm"] / MM),
            meta["mu"],
            (contact["Fx"], contact["Fy"]),
            contact.get("Mz", np.nan) * MM,
            meta["mu"] * meta["FN"],
            np.sqrt(a * b),
        )


def modulus(shear_modulus, nu):
    """Young's modulus [Pa] from the shear modulus [MPa]."""
    return 2e6 * shear_modulus * (1.0 + nu)


def extrapolated(row, patch):
    return Case(
        f"{row.get('case', 'ellipse')} a/b {row['aob']:.3g} {row['set']}",
        (patch,),
        (row["xi"], row["eta"], row["phi"] / MM),
        row["mu"],
        (row["Fx"], row["Fy"]),
        row["Mz"] * MM,
        row["mu"] * row["N"],
        np.sqrt(row["a"] * row["b"]) * MM,
    )


def extrapolated_ellipses(wanted):
    for row in read("ellipses_extrapolated")["cases"]:
        if wanted(row["aob"]):
            yield extrapolated(
                row,
                elliptic_patch(
                    row["a"] * MM, row["b"] * MM, row["N"], modulus(row["G"], row["nu"]), row["nu"]
                ),
            )


def ellipses():
    return extrapolated_ellipses(lambda ratio: 0.2 < ratio < 4.0)


def long_and_short():
    return extrapolated_ellipses(lambda ratio: not 0.2 < ratio < 4.0)


def outlined():
    """Patches of the strip model."""
    found = read("patches_extrapolated")
    outlines = {}
    for row in found["cases"]:
        if row["patch"] not in outlines:
            # the number of the patch is that of a longer list
            one = min(
                found["patches"], key=lambda one: abs(one["N"] - row["N"]) + (one["case"] != row["case"])
            )
            outlines[row["patch"]] = outlined_patch(
                np.array(one["y"]) * MM,
                np.array(one["a"]) * MM,
                np.array(one["p0"]) * 1e6,
                normal_force=row["N"],
                youngs_modulus=modulus(row["G"], row["nu"]),
                poisson_ratio=row["nu"],
            )
        yield extrapolated(row, outlines[row["patch"]])


def gridded():
    """Patches by CONTACT, its pressures too."""
    found = read("contact_patches")
    meta = found["meta"]
    for one in found["patches"]:
        parts = grid_parts(one, modulus(meta["G_MPa"], meta["nu"]), meta["nu"])
        size = np.sqrt(one["area_mm2"] / np.pi) * MM
        for row in one["cases"]:
            contact = row["contact"]
            creepages = row["xi"], row["eta"], row["phi_per_mm"] / MM
            yield Case(
                f"CONTACT {one['y_shift_mm']} mm {creepages}",
                parts,
                creepages,
                meta["mu"],
                (contact["Fx"], contact["Fy"]),
                contact["Mz"] * MM,
                meta["mu"] * one["FN"],
                size,
            )


def grid_parts(one, youngs_modulus, nu):
    """A pressure grid as outlined patches: the half-length of a row from its second moment."""
    grid, pressure = one["grid"], np.array(one["pressure_MPa"])
    x = grid["x_first"] + grid["dx"] * np.arange(pressure.shape[1])
    y = grid["y_first"] + grid["dy"] * np.arange(pressure.shape[0])
    load = pressure.sum(axis=1) * grid["dx"]
    centre = (pressure * x).sum() / pressure.sum()
    second = (pressure * (x - centre) ** 2).sum(axis=1) * grid["dx"]
    half_length = 2.0 * np.sqrt(second / np.where(load > 0.0, load, 1.0))
    rows = np.flatnonzero(load > 0.0)
    total, parts = load.sum(), []
    for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
        if len(run) < 3:
            total -= load[run].sum()
    for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
        if len(run) >= 3:
            station = np.concatenate([[y[run[0]] - grid["dy"] / 2], y[run], [y[run[-1]] + grid["dy"] / 2]])
            a, q = (np.concatenate([[0.0], values[run], [0.0]]) for values in (half_length, load))
            top = np.divide(2.0 * q, np.pi * a, out=np.zeros_like(q), where=a > 0.0)
            parts.append(
                outlined_patch(
                    station * MM,
                    a * MM,
                    top * 1e6,
                    youngs_modulus=youngs_modulus,
                    poisson_ratio=nu,
                    normal_force=one["FN"] * load[run].sum() / total,
                )
            )
    return tuple(parts)


class Model:
    """A model of creep forces on patches."""

    def __init__(self, name, published=False):
        self.number = NUMBERS["tangential_model"][name]
        self.workspace = np.zeros(layout.WORK_SIZE)
        self.work = layout.Work.at(self.workspace)
        self.rolling = self.work.patch
        self.work.rolling.published = published

    def solve(self, patch, xi, eta, phi, friction):
        """The record Patch for creepages at the patch's centre of load."""
        rolling = self.rolling
        rolling.creepage_x, rolling.creepage_y, rolling.spin, rolling.friction = xi, eta, phi, friction
        forces.roll(
            patch, forces.model_tables(self.number, patch.youngs_modulus, patch.poisson_ratio), self.workspace
        )
        return rolling

    def forces(self, case):
        """Force x, y and moment (3,) about station zero."""
        xi, eta, phi = case.creepages
        total = np.zeros(3)
        for patch in case.parts:
            forces.write_patch(patch, self.rolling, self.work.contact.strips)
            centroid = self.rolling.totals.centroid
            found = self.solve(patch, xi - phi * centroid, eta, phi, case.friction)
            total += found.creep_x, found.creep_y, found.creep_moment - centroid * found.creep_x
        return total


def errors(model, name):
    """Errors of the force and of the moment (n, 2) of a :class:`Model` in a set, in % of the force of full
    slip and of that times sqrt(ab)."""
    rows = []
    for case in cases(name):
        found = model.forces(case)
        rows.append(
            (
                np.hypot(found[0] - case.force[0], found[1] - case.force[1]) / case.bound,
                abs(found[2] - case.moment) / (case.bound * case.size),
            )
        )
    return 100.0 * np.array(rows)


def summary(values):
    """Mean, 95 % quantile and largest."""
    return float(np.mean(values)), float(np.percentile(values, 95)), float(np.max(values))


def full_slip(patch, friction):
    """Creepages xi, eta [-] and phi [1/m] (3,) at which linear theory has the force of full slip, for the
    ellipse with the patch's ends and its longest strip; and that force [N] and sqrt(ab) [m]."""
    a, b = patch.half_length.max(), 0.5 * np.ptp(patch.station)
    bound = friction * patch.normal_force
    shear_modulus = patch.youngs_modulus / (2.0 * (1.0 + patch.poisson_ratio))
    scale = bound / (shear_modulus * a * b) / kalker_coefficients(a / b, patch.poisson_ratio)[:, 0]
    return scale / np.array([1.0, 1.0, np.sqrt(a * b)]), bound, np.sqrt(a * b)


def vector(rolling):
    """Force and moment (3,) that were found."""
    return np.array([rolling.creep_x, rolling.creep_y, rolling.creep_moment])


def all_shapes():
    """Some patches of every kind: ellipses from short to long, patches of the strip model, CONTACT's."""
    ellipses = [
        elliptic_patch(5e-3 * ratio**0.5, 5e-3 * ratio**-0.5, 8e4)
        for ratio in (0.05, 0.25, 1.0, 3.5, 20.0, 40.0)
    ]
    outlined = list({id(case.parts[0]): case.parts[0] for case in cases("patches")}.values())
    gridded = list({id(part): part for case in cases("contact_patches") for part in case.parts}.values())
    return ellipses + outlined[::2] + gridded[::2]


def random_patch(rng):
    """An ellipse or a jagged outline of any size."""
    if rng.random() < 0.5:
        ratio, size = np.exp(rng.uniform(np.log(0.02), np.log(80.0))), 10.0 ** rng.uniform(-4.0, -1.7)
        return elliptic_patch(
            size * ratio**0.5,
            size * ratio**-0.5,
            10.0 ** rng.uniform(0.0, 5.3),
            poisson_ratio=rng.choice([0.0, 0.1, 0.25, 0.28, 0.3, 0.5]),
        )
    count = rng.integers(4, 60)
    station = np.cumsum(rng.uniform(0.05, 1.0, count)) * 10.0 ** rng.uniform(-5.0, -3.0)
    shape = rng.uniform(0.01, 1.0, count) ** rng.choice([0.2, 1.0, 3.0])
    half_length = 10.0 ** rng.uniform(-4.0, -2.0) * shape
    return outlined_patch(
        station, half_length, 1e9 * rng.uniform(0.01, 1.0, count), slant=rng.choice([0.0, 0.0, 0.3, -1.0])
    )
