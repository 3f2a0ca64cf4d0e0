"""The force of coupled strips is continuous, and how steep it is.

Creepages are in units of saturation: those at which linear theory has the force of full slip.
"""

import numpy as np
import pytest

from data.creep_cases import Model, all_shapes, forces, full_slip, vector
from wrcontact.creep import elliptic_patch

#: Steepest slopes [mu N per unit of saturation]; linear theory itself has 1.41 for lateral creepage with
#: spin.
RANDOM_SLOPE, SPIN_SLOPE = 2.4, 5.0
#: No step of the force is larger than this share of mu N where it is cut in two until nothing is left.
JUMP = 1e-8


class Line:
    """Force over mu N (2,) along a line in saturation."""

    def __init__(self, patch, start, direction):
        self.model = Model("strips")
        self.scale, self.bound, _ = full_slip(patch, 0.3)
        self.start, self.direction = np.array(start), np.array(direction)
        self.tables = forces.model_tables(self.model.number, patch.youngs_modulus, patch.poisson_ratio)
        self.model.solve(patch, 0.0, 0.0, 0.0, 0.3)

    def __call__(self, s):
        rolling = self.model.rolling
        rolling.creepage_x, rolling.creepage_y, rolling.spin = -(self.start + s * self.direction) * self.scale
        forces.default_kernel().divide_into_strips(self.model.workspace)
        forces.default_kernel().solve_creep_force(self.tables, self.model.workspace)
        return vector(rolling)[:2] / self.bound

    def steps(self, stations):
        """Steps of the force between the stations (n - 1,)."""
        return np.hypot(*np.diff([self(s) for s in stations], axis=0).T)

    def jump(self, low, high):
        """What is left of the larger half of a step, cut in two forty times."""
        below, above = self(low), self(high)
        for _ in range(40):
            middle = 0.5 * (low + high)
            value = self(middle)
            if np.hypot(*(value - below)) > np.hypot(*(above - value)):
                high, above = middle, value
            else:
                low, below = middle, value
        return np.hypot(*(above - below))


def examine(line, stations, steepest):
    """The slope is bounded, and the steepest steps are no jumps."""
    steps = line.steps(stations)
    slope = steps.max() / (stations[1] - stations[0])
    assert slope <= steepest, (line.start, line.direction, stations[steps.argmax()])
    for place in np.argsort(steps)[-3:]:
        assert line.jump(stations[place], stations[place + 1]) < JUMP, (line.start, line.direction)
    return slope


@pytest.mark.parametrize(
    "number",
    [
        0,
        8,
        *(
            pytest.param(number, marks=pytest.mark.full)
            for number in range(len(all_shapes()))
            if number not in (0, 8)
        ),
    ],
)
def test_random_lines(number):
    """Through the middle of saturation, 8 lines with steps of 0.002."""
    rng = np.random.default_rng(100 + number)
    patch = all_shapes()[number]
    slopes = []
    for _ in range(8):
        direction = rng.normal(size=3)
        line = Line(patch, rng.uniform(-2.0, 2.0, 3), direction / np.linalg.norm(direction))
        slopes.append(examine(line, np.arange(-1.0, 1.0, 0.002), RANDOM_SLOPE))
    assert max(slopes) > 0.2  # it is a force


@pytest.mark.parametrize("ratio", [0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 20.0])
def test_lines_of_spin(ratio):
    """Through k = 1, where all strips of an ellipse begin to slip at once, with small lateral creepage."""
    patch = elliptic_patch(5e-3 * ratio**0.5, 5e-3 * ratio**-0.5, 8e4)
    for lateral in (0.0, 0.01, -0.01, -0.03, -0.1):
        examine(Line(patch, (0.05, lateral, 0.0), (0.0, 0.0, 1.0)), np.arange(0.7, 1.3, 0.001), SPIN_SLOPE)


@pytest.mark.full
def test_random_pairs():
    """6000 pairs a millionth of saturation apart, on patches of all shapes and up to 20 times saturation."""
    rng = np.random.default_rng(5)
    patches = all_shapes()
    for _ in range(6000):
        patch = patches[rng.integers(len(patches))]
        start = rng.normal(size=3) * np.exp(rng.uniform(-2.0, 3.0))
        direction = rng.normal(size=3)
        line = Line(patch, start, direction / np.linalg.norm(direction))
        assert np.hypot(*(line(1e-6) - line(0.0))) < SPIN_SLOPE * 1e-6, (patch.half_length.max(), start)
