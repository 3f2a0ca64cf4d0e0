"""Stored cases of creep forces in SI units, and what is compared with them."""

import json

import numpy as np

from tests.helpers.paths import DATA
from wrcontact.halfspace.rolling import Outline, PressureField

FOLDER = DATA / "creep"


def stored(name):
    """What the file of data/creep holds."""
    return json.loads((FOLDER / name).read_text(encoding="utf-8"))


def motion(case):
    """Keywords of an extrapolated case for roll_ellipse and roll_outline."""
    return {
        "creepage_x": case["xi"],
        "creepage_y": case["eta"],
        "spin": 1e3 * case["phi"],
        "friction": case["mu"],
        "shear_modulus": 1e6 * case["G"],
        "poisson_ratio": case["nu"],
    }


def forces(solution):
    """Force along and across [N] and moment [N m] of a solution (3,)."""
    return np.array([solution.force_x, solution.force_y, solution.moment])


def errors(solution, truth, limit, mean_axis):
    """Differences of forces and moment (3,) from ``truth`` (3,) [N, N, N mm], over the friction limit [N]
    and the moment of that at sqrt(ab) [m]."""
    wanted = np.array(truth) * (1.0, 1.0, 1e-3)
    return (forces(solution) - wanted) / (limit * np.array([1.0, 1.0, mean_axis]))


def stored_patch(patch):
    """Outline of a patch of patches_extrapolated.json."""
    station, half_length, pressure = (np.array(patch[name]) for name in ("y", "a", "p0"))
    return Outline.of_stations(1e-3 * station, 1e-3 * half_length, 1e6 * pressure)


def contact_cells(half_length, half_width, normal_force, cells=44, wider=1.1, points=4):
    """The cells of hertz.json: the ellipse in a grid ``wider`` than itself; cells count whose middle is
    inside, with their mean pressure."""
    middle = ((np.arange(cells) + 0.5) / cells * 2.0 - 1.0) * wider
    fine = ((np.arange(cells * points) + 0.5) / (cells * points) * 2.0 - 1.0) * wider
    height = np.sqrt(np.clip(1.0 - fine[:, None] ** 2 - fine**2, 0.0, None))
    height = height.reshape(cells, points, cells, points).mean(axis=(1, 3))
    height[middle[:, None] ** 2 + middle**2 >= 1.0] = 0.0
    field = PressureField.of_cells(half_length * middle, half_width * middle, height)
    return field.scaled(normal_force)
