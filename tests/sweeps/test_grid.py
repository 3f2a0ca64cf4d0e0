"""Axes and blocks of a grid, and the sentences on wrong ones."""

import sys

import numpy as np
import pytest

import wrcontact
from wrcontact.interface.inputs import INPUTS
from wrcontact.results.layout import OUTPUTS
from wrcontact.sweeps.grid import block_at, block_shape, checked_axes, checked_inputs
from wrcontact.sweeps.stores import plain

pytestmark = pytest.mark.check
SYSTEM = wrcontact.ContactSystem()


@pytest.mark.parametrize(
    "sizes, block",
    [((7,), 3), ((7,), 100), ((4, 5, 6), 1), ((4, 5, 6), 13), ((4, 5, 6), 60), ((1, 9, 1, 4), 8)],
)
def test_blocks_cover_the_grid_once(sizes, block):
    shape, seen = block_shape(sizes, block), np.zeros(sizes, dtype=int)
    corners = np.argwhere(np.ones([-(-size // width) for size, width in zip(sizes, shape)])) * shape
    for corner in corners:
        at = block_at(corner, shape, sizes)
        assert seen[at].size <= block
        seen[at] += 1
    assert np.all(seen == 1)


def test_axes_have_the_names_of_keywords_and_of_fmus():
    axes = checked_axes({"left.friction": [0.1, 0.2], "yaw": (1e-3, 0.0)})
    assert list(axes) == ["left_friction", "yaw"] and axes["yaw"].tolist() == [1e-3, 0.0]
    assert checked_inputs({"right.friction": 0.1, "normal_force": 78500, "speed": 3}, axes) == {
        "right_friction": 0.1,
        "speed": 3.0,
    }  # a default changes nothing


def test_names_of_arrays_are_different():
    names = [*map(plain, OUTPUTS), *(row.keyword for row in INPUTS), "status"]
    assert len(set(names)) == len(names) and all(name.isidentifier() for name in names)


@pytest.mark.parametrize(
    "axes, words",
    [
        ({}, "axes is {}; permitted is a dict"),
        ({"yaww": [0]}, "axes has 'yaww'; permitted are names of inputs, .*did you mean yaw"),
        ({"roll": [0]}, "axes has 'roll'.*did you mean roll_guess or roll_input"),
        ({"left.friction": [0.1], "left_friction": [0.2]}, "axes has 'left_friction' twice"),
        ({"yaw": []}, r"the axis yaw has the shape \(0,\)"),
        ({"yaw": 1e-3}, r"the axis yaw has the shape \(\)"),
        ({"yaw": [[0.0]]}, r"the axis yaw has the shape \(1, 1\)"),
        ({"yaw": [0.0, np.nan]}, "the axis yaw has nan; permitted are finite numbers"),
        (
            {"yaw": [0.0, 1e-3, 1e-3]},
            "the axis yaw has 0.001 rad before 0.001 rad; permitted are values that",
        ),
        ({"yaw": [0.0, 2e-3, 1e-3]}, "the axis yaw has 0.002 rad before 0.001 rad"),
        ({"yaw": [1e-3, 0.0, 2e-3, 0.5e-3]}, "the axis yaw has 0 rad before 0.002 rad"),
        ({"yaw": ["0", "1"]}, "yaw has '0'; permitted are numbers, in rad"),
    ],
)
def test_wrong_axes(axes, words):
    with pytest.raises(ValueError, match=words):
        wrcontact.sweep(SYSTEM, axes)


@pytest.mark.parametrize(
    "given, error, words",
    [
        ({"yaw": 0.0}, ValueError, "yaw is given twice, as an axis and as a number"),
        ({"speeed": 1.0}, TypeError, "there is no input 'speeed'; did you mean speed"),
        ({"gauge": 1.4}, TypeError, "gauge is a parameter of ContactSystem"),
        ({"speed": [1.0, 2.0]}, ValueError, r"speed has the shape \(2,\); permitted is one number; arrays"),
        ({"speed": np.inf}, ValueError, "speed is inf; permitted is a finite number"),
        ({"speed": "1"}, ValueError, "speed is '1'; permitted is a number, in m/s"),
        ({"outputs": ["right.ara"]}, ValueError, "outputs has 'right.ara'.*did you mean right.area"),
        ({"outputs": []}, ValueError, "outputs is empty"),
        ({"block": 0}, ValueError, "block is 0; permitted is a whole number from 1 on"),
        ({"workers": 1.5}, ValueError, "workers is 1.5; permitted is a whole number from 1 on"),
        ({"client": "tcp://host:1"}, ValueError, "store is None; permitted with a client is a folder"),
        (
            {"client": "tcp://host:1", "store": "a", "workers": 2},
            ValueError,
            "workers is 2; it cannot be given with a client",
        ),
        (
            {"client": "tcp://host:1", "store": "a"},
            ValueError,
            "client is 'tcp://host:1'; permitted is a dask",
        ),
    ],
)
def test_wrong_arguments(given, error, words):
    with pytest.raises(error, match=words):
        wrcontact.sweep(SYSTEM, {"yaw": [0.0, 1e-3]}, **given)


def test_something_else_than_a_system():
    with pytest.raises(ValueError, match="system is 'S1002'; permitted is a ContactSystem"):
        wrcontact.sweep("S1002", {"yaw": [0.0, 1e-3]})


def test_missing_packages_are_one_sentence(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(ImportError, match=r"needs xarray, which is not installed; .*'wrcontact\[tables\]'"):
        wrcontact.sweep(SYSTEM, {"yaw": [0.0, 1e-3]})
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(ImportError, match=r"a store needs zarr, .*'wrcontact\[tables\]'"):
        wrcontact.interpolate(tmp_path)
    assert not list(tmp_path.iterdir())
