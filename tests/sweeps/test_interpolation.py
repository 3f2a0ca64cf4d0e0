"""Values between the states of a table, against formulas by hand and direct evaluation."""

import numpy as np
import pytest

import wrcontact

pytest.importorskip("zarr")
xarray = pytest.importorskip("xarray")
SYSTEM = wrcontact.ContactSystem()
OUTPUTS = ["roll", "right.area", "right.contact.y_wheel"]
#: No contact jumps within these.
TREAD = (-2e-3, 2e-3)


def table(shifts, outputs=OUTPUTS, system=SYSTEM, **more):
    axes = {"lateral_shift": shifts, "yaw": [-1e-3, 2e-3, 4e-3], "normal_force": [50e3, 78.5e3]}
    return wrcontact.sweep(system, axes, outputs, progress=False, **more)


@pytest.fixture(scope="module")
def data():
    return table(np.linspace(*TREAD, 9), speed=10.0)


def test_between_two_states_by_hand(data):
    """Weights of the eight corners of a cell."""
    found = wrcontact.interpolate(data)(lateral_shift=1.1e-3, yaw=2.5e-3, normal_force=60e3)
    parts = [(0.0011 - 0.001) / 0.0005, (2.5 - 2.0) / 2.0, 10.0 / 28.5]
    for name, variable in (("roll", "roll"), ("right.area", "right_area")):
        cell = data[variable].sel(lateral_shift=[1e-3, 1.5e-3], yaw=[2e-3, 4e-3]).values
        for part in parts:
            cell = (1.0 - part) * cell[0] + part * cell[1]
        assert found[name] == pytest.approx(cell, rel=1e-12)


@pytest.mark.parametrize("method", ["linear", "cubic"])
def test_the_states_themselves(method):
    data = wrcontact.sweep(
        SYSTEM,
        {"lateral_shift": np.linspace(*TREAD, 7), "yaw": np.linspace(3e-3, 0, 5)},
        OUTPUTS,
        progress=False,
    )
    between = wrcontact.interpolate(data, method=method)
    found = between(lateral_shift=data["lateral_shift"].values[:, None], yaw=data["yaw"].values)
    assert found["roll"].shape == (7, 5)
    np.testing.assert_allclose(found["right.area"], data["right_area"], rtol=1e-9)
    np.testing.assert_allclose(found["roll"], data["roll"], atol=1e-14)
    errors = between.errors_at(lateral_shift=data["lateral_shift"].values, yaw=0.0)
    assert errors.count == 7 and errors["right.area"].worst < 1e-13


def test_the_error_falls_with_the_square_of_the_step():
    """Of linear interpolation, where no contact jumps; three halves of the step."""
    coarse, fine = (
        wrcontact.interpolate(table(np.linspace(*TREAD, count)).isel(yaw=1, normal_force=1))
        for count in (41, 321)
    )
    poses = np.random.default_rng(2).uniform(*TREAD, 300)
    more, less = (one.errors_at(lateral_shift=poses) for one in (coarse, fine))
    for name in OUTPUTS:
        order = np.log2(more[name].median / less[name].median) / 3
        assert 1.9 < order < 2.4, f"{name}: {order}"


def test_errors_against_direct_evaluation(data, tmp_path):
    """The table knows its system, what is fixed, and what has been chosen."""
    chosen = data.sel(normal_force=50e3)
    between, generator = wrcontact.interpolate(chosen, "right.area"), np.random.default_rng(1)
    poses = {"lateral_shift": generator.uniform(*TREAD, 50), "yaw": generator.uniform(-1e-3, 4e-3, 50)}
    direct = SYSTEM.evaluate_many(**poses, normal_force=50e3, speed=10.0).right.area
    wrong, errors = np.abs(between(**poses)["right.area"] - direct), between.errors_at(**poses)
    error, worst = errors["right.area"], np.argmax(wrong)
    assert (errors.count, errors.without) == (50, 0) and 0.0 < error.median < error.most < error.worst
    assert error.worst == wrong[worst] and error.where == {name: poses[name][worst] for name in poses}
    assert (error.median, error.most) == (np.median(wrong), np.percentile(wrong, 95))
    assert between.errors.count == 9 * 3 and between.errors is between.errors
    lines = repr(errors).splitlines()
    assert lines[0] == "50 poses, 0 of them without a result"
    assert lines[2].startswith(f"right.area [mm2]  {1e6 * error.median:.4g}"[:22]) and "yaw" in lines[2]


def test_a_jump_of_the_contact_stays_whatever_the_size_of_the_table():
    """At 4.85 mm of lateral shift the contact on the wheel jumps by more than 10 mm."""

    def errors(count):
        data = wrcontact.sweep(
            SYSTEM,
            {"lateral_shift": np.linspace(3e-3, 7e-3, count)},
            ["right.contact.y_wheel"],
            progress=False,
        )
        return wrcontact.interpolate(data).errors_at(lateral_shift=np.linspace(3e-3, 7e-3, 9973))[
            "right.contact.y_wheel"
        ]

    coarse, fine = errors(41), errors(641)
    shifts = np.array([4.8e-3, 4.9e-3])
    jump = abs(np.diff(SYSTEM.evaluate_many(shifts).right.contact.y_wheel)[0])
    assert jump > 10e-3 and fine.median < coarse.median / 100
    assert fine.worst > 0.4 * jump and coarse.worst > 0.4 * jump


def test_a_cell_with_a_corner_without_a_result_has_none():
    data = wrcontact.sweep(SYSTEM, {"lateral_shift": [13e-3, 14e-3, 15e-3, 16e-3]}, ["roll"], progress=False)
    assert data["status"].values.tolist() == [0, 0, 0, 2]
    between = wrcontact.interpolate(data)
    found = between(lateral_shift=[13.5e-3, 14.9e-3, 15.1e-3, 12.9e-3, 17e-3])["roll"]
    assert np.isfinite(found).tolist() == [True, True, False, False, False]  # outside is NaN, too
    errors = between.errors_at(lateral_shift=[13.5e-3, 15.1e-3])
    assert (errors.count, errors.without) == (2, 1) and np.isfinite(errors["roll"].worst)
    with pytest.raises(ValueError, match="1 of 4 states have no result; permitted for 'cubic' is"):
        wrcontact.interpolate(data, method="cubic")


def test_a_store_and_its_files(tmp_path, data):
    table(np.linspace(*TREAD, 9), store=tmp_path / "a.zarr", speed=10.0)
    data.to_netcdf(tmp_path / "a.nc")
    poses = {"lateral_shift": 0.3e-3, "yaw": 0.0, "normal_force": 60e3}
    expected = wrcontact.interpolate(data)(**poses)
    for source in (tmp_path / "a.zarr", str(tmp_path / "a.zarr"), xarray.open_dataset(tmp_path / "a.nc")):
        assert wrcontact.interpolate(source)(**poses) == expected
    between = wrcontact.interpolate(tmp_path / "a.zarr", ["right_area", "roll"])
    assert between.outputs == ("right.area", "roll") and "yaw 3" in repr(between)


@pytest.mark.parametrize(
    "given, words",
    [
        ({"table": xarray.Dataset()}, "permitted is the path of a store, or a data set, of wrcontact.sweep"),
        ({"outputs": ["right.ara"]}, "outputs has 'right.ara', which .* not have; did you mean right.area"),
        ({"outputs": ["zz"]}, "does not have; it has roll, right.area, right.contact.y_wheel"),
        ({"outputs": []}, "outputs is empty; permitted are outputs of the table"),
        ({"method": "spline"}, "method is 'spline'; permitted are 'linear'"),
        (
            {"method": "cubic"},
            r"the axis yaw has 3 values; permitted for 'cubic' are 4 or more; dataset.isel",
        ),
    ],
)
def test_wrong_arguments(data, given, words):
    with pytest.raises(ValueError, match=words):
        wrcontact.interpolate(**{"table": data, **given})


def test_a_lost_axis(data):
    with pytest.raises(ValueError, match="the table has lost its axis yaw; permitted is a choice that keeps"):
        wrcontact.interpolate(data.isel(yaw=0, drop=True))


def test_a_text_is_no_place(data):
    with pytest.raises(ValueError, match="yaw is 'x'; permitted is a number, in rad"):
        wrcontact.interpolate(data)(lateral_shift=0.0, yaw="x", normal_force=6e4)


@pytest.mark.parametrize(
    "poses, words",
    [
        ({"lateral_shift": 0.0}, "yaw is not given; the axes are lateral_shift, yaw, normal_force"),
        (
            {"lateral_shift": 0.0, "yaw": 0.0, "normal_force": 6e4, "speed": 1.0},
            "the table has no axis 'speed'",
        ),
    ],
)
def test_wrong_poses(data, poses, words):
    with pytest.raises(TypeError, match=words):
        wrcontact.interpolate(data)(**poses)
