"""Tables over a grid: the bits of evaluate_many, a store that goes on, and specifications that it refuses."""

import itertools
import os
import signal
import subprocess
import sys

import numpy as np
import pytest

import wrcontact
from tests.helpers.paths import ROOT
from tests.helpers.sweeps import AXES, OUTPUTS, PROGRAM, VARIABLES, in_memory, points_file
from wrcontact.sweeps.specification import asked, system_of
from wrcontact.sweeps.stores import Memory
from wrcontact.sweeps.workers import Task

pytest.importorskip("zarr")
xarray = pytest.importorskip("xarray")
SIZES = tuple(map(len, AXES.values()))


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem()


@pytest.fixture(scope="module")
def table(system):
    return in_memory(system)


def test_the_grid_has_the_bits_of_evaluate_many(system, table):
    """Block by block."""
    assert dict(table.sizes) == dict(zip(AXES, SIZES)) and list(table.data_vars) == [*VARIABLES, "status"]
    for shift, first in itertools.product(range(12), (0, 4)):
        block = table.isel(lateral_shift=[shift], yaw=slice(first, first + 4))
        grid = np.meshgrid(*(block[name].values for name in AXES), indexing="ij")
        direct = system.evaluate_many(
            outputs=OUTPUTS,
            speed=20.0,
            left_friction=0.2,
            **{name: one.ravel() for name, one in zip(AXES, grid)},
        )
        for name in direct.names:
            variable = next(one for one in block.data_vars.values() if one.attrs.get("fmu_name") == name)
            np.testing.assert_array_equal(variable.values.ravel(), direct[name], err_msg=f"{name} at {shift}")
        np.testing.assert_array_equal(block["status"].values.ravel(), direct.status)
    assert {*np.unique(table["status"])} == {0, 2}  # some states are off the profile
    assert np.all(np.isnan(table["roll"].values[table["status"] == 2]))


def test_blocks_of_another_size_have_the_same_bits(system, table):
    found = in_memory(system, block=1000)
    for name in table.data_vars:
        np.testing.assert_array_equal(found[name], table[name], err_msg=name)


def test_units_and_words(table):
    assert table["right_patch_1_area"].attrs == {
        "fmu_name": "right.patch[1].area",
        "units": "m2",
        "long_name": "Right wheel, patch 1: contact area",
    }
    assert table["right_patch_count"].attrs["units"] == "1"
    assert table["yaw"].attrs["units"] == "rad" and table["normal_force"].attrs["fmu_name"] == "normal_force"
    assert table.attrs["title"] == "S1002 on UIC60"


@pytest.mark.parametrize("workers", [1, 3, 50, None])
def test_a_store_has_the_same_bits(tmp_path, table, workers):
    found = in_memory(store=tmp_path / "a.zarr", workers=workers)
    xarray.testing.assert_identical(found.load(), table)
    assert [path.name for path in tmp_path.iterdir()] == ["a.zarr"]


def test_others_read_a_store(tmp_path, system, table):
    in_memory(system, store=tmp_path / "a.zarr")
    data = xarray.open_zarr(tmp_path / "a.zarr", consolidated=False)
    assert data["roll"].chunks == ((1,) * 12, (4, 4), (5,))
    np.testing.assert_array_equal(data["roll"], table["roll"])
    table.to_netcdf(tmp_path / "a.nc")
    xarray.testing.assert_identical(xarray.open_dataset(tmp_path / "a.nc").load(), table)


def test_all_outputs_and_status_alone(system):
    axes = {"lateral_shift": [0.0, 5e-3]}
    data = wrcontact.sweep(system, axes, progress=False)
    direct = system.evaluate_many(axes["lateral_shift"])
    assert len(data.data_vars) == len(direct.names) + 1
    np.testing.assert_array_equal(data["right_pressure_7"], direct["right.pressure[7]"])
    assert list(wrcontact.sweep(system, axes, "status", progress=False).data_vars) == ["status"]


def test_status_is_written_last(system):
    """It is the mark of a finished block."""

    class Recorder(dict):
        def __getitem__(self, name):
            written.append(name)
            return super().__getitem__(name)

    specification, written = asked(system, {"yaw": [0.0, 1e-3]}, ["roll", "right.area"], {}), []
    memory = Memory(specification, 10)
    memory._arrays = Recorder(memory.arrays())
    Task(specification, memory).solve([0])
    assert written == ["roll", "right_area", "status"]


def test_the_half_space(tmp_path):
    """Its blocks are shared by processes, which are started again for each."""
    system = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.1)
    axes = {"lateral_shift": [0.0, 1e-3, 2e-3]}
    data = wrcontact.sweep(
        system, axes, ["right.area"], tmp_path / "a.zarr", block=2, workers=1, progress=False
    )
    np.testing.assert_array_equal(data["right_area"], system.evaluate_many(axes["lateral_shift"]).right.area)


# --- a store that goes on -----------------------------------------------------------------------------------


def killed(store, workers=2, states=100, blow="KILL"):
    """Return code and errors of a sweep to ``store`` whose process gets a ``blow`` in the middle."""
    program = PROGRAM.format(store=str(store), workers=workers, states=states, blow=blow)
    ended = subprocess.run(
        [sys.executable, "-c", program],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=600,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
    )
    return ended.returncode, ended.stderr


@pytest.mark.parametrize("workers", [1, 3])
def test_a_killed_sweep_goes_on(tmp_path, system, table, workers):
    code, errors = killed(tmp_path / "a.zarr")
    assert code == -signal.SIGKILL, errors
    before = xarray.open_zarr(tmp_path / "a.zarr", consolidated=False, chunks=None)["status"].load()
    there, told = int((before >= 0).sum()), []
    assert 100 <= there < 480 and there % 20 == 0
    found = in_memory(
        system, store=tmp_path / "a.zarr", workers=workers, progress=lambda *numbers: told.append(numbers)
    )
    assert [total for _, total, _ in told] == [480 - there] * ((480 - there) // 20)  # none is done again
    assert told[-1][0] == 480 - there and told[-1][2] == int(
        (table["status"] > 1).sum() - ((before > 1) & (before >= 0)).sum()
    )
    xarray.testing.assert_identical(found.load(), table)


def test_an_interrupted_sweep_goes_on(tmp_path, system, table):
    code, errors = killed(tmp_path / "a.zarr", blow="INT")
    assert code in (1, -signal.SIGINT) and "KeyboardInterrupt" in errors
    xarray.testing.assert_identical(in_memory(system, store=tmp_path / "a.zarr").load(), table)


def test_a_finished_sweep_computes_nothing(tmp_path, system, monkeypatch):
    def sweep():
        return wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], tmp_path / "a.zarr", progress=False)

    first = sweep().load()
    monkeypatch.setattr(wrcontact.ContactSystem, "evaluate_many", None)
    xarray.testing.assert_identical(sweep().load(), first)


QUESTION = {"axes": {"yaw": [0.0, 1e-3], "normal_force": [50e3, 60e3]}, "outputs": ["roll", "right.area"]}


@pytest.mark.parametrize(
    "change, words",
    [
        ({"speed": 2.0}, "speed is 2.0 m/s, there 0.0 m/s"),
        ({"outputs": ["roll"]}, "outputs lacks 'right.area', which is there"),
        (
            {"outputs": ["roll", "right.area", "right.penetration"]},
            "outputs has 'right.penetration', which is not there",
        ),
        (
            {"axes": {"yaw": [0.0, 2e-3], "normal_force": [50e3, 60e3]}},
            "yaw has 2 values 0 ... 0.002 rad, there 2 values 0 ... 0.001 rad",
        ),
        (
            {"axes": {"yaw": [0.0, 1e-3 + 1e-17], "normal_force": [50e3, 60e3]}},
            "yaw has 2 values 0 ... 0.001 rad, there 2 values 0 ... 0.001 rad that differ",
        ),
        (
            {"axes": {"normal_force": [50e3, 60e3], "yaw": [0.0, 1e-3]}},
            "the axes are normal_force, yaw, there yaw, normal_force",
        ),
        ({"axes": {"yaw": [0.0, 1e-3]}}, "the axes are yaw, there yaw, normal_force"),
        ({"block": 3}, "block is 3, there 50000"),
        ({"system": {"gauge": 1.436}}, "gauge is 1.436 m, there 1.435 m"),
        ({"system": {"normal_model": "hertz"}}, "normal_model is 'hertz', there 'analyn'"),
        ({"system": {"wheel": "cone20"}}, "the wheel profile has another content; the left wheel profile"),
        ({"system": {"left_rail": "54E1"}}, "the left rail profile has another content"),
    ],
)
def test_another_specification_is_refused(tmp_path, change, words):
    def sweep(system=None, axes=QUESTION["axes"], outputs=QUESTION["outputs"], **more):
        return wrcontact.sweep(
            wrcontact.ContactSystem(**system or {}),
            axes,
            outputs,
            tmp_path / "a.zarr",
            progress=False,
            **more,
        )

    before = sweep().load()
    with pytest.raises(ValueError) as refused:
        sweep(**{"outputs": QUESTION["outputs"], **change})
    assert str(refused.value).startswith(
        f"the store {tmp_path / 'a.zarr'} has another specification: {words}"
    )
    xarray.testing.assert_identical(sweep(speed=0.0).load(), before)  # a default is no other specification


def test_another_version_is_refused(tmp_path, system, monkeypatch):
    wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], tmp_path / "a.zarr", progress=False)
    monkeypatch.setattr("wrcontact.sweeps.specification.__version__", "9.9")
    with pytest.raises(ValueError, match=f"wrcontact is 9.9, there {wrcontact.__version__}"):
        wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], tmp_path / "a.zarr", progress=False)


def test_what_is_no_store_is_left_alone(tmp_path, system):
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "notes").write_text("mine")
    (tmp_path / "file").write_text("mine")
    xarray.Dataset({"a": ("x", [1.0])}).to_zarr(tmp_path / "other.zarr", consolidated=False)
    for name in ("folder", "file", "other.zarr"):
        with pytest.raises(ValueError, match=f"{name} is no store of wrcontact.sweep; permitted is one, or"):
            wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], tmp_path / name)
    assert (tmp_path / "folder" / "notes").read_text() == (tmp_path / "file").read_text() == "mine"
    with pytest.raises(ValueError, match="store is 's3://a/b'; permitted is the path of a folder"):
        wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], "s3://a/b")
    with pytest.raises(FileNotFoundError, match="missing/a.zarr"):
        wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], tmp_path / "missing" / "a.zarr")
    (tmp_path / "empty").mkdir()
    assert wrcontact.sweep(system, {"yaw": [0.0, 1e-3]}, ["roll"], tmp_path / "empty")["roll"].size == 2


# --- profiles by their content ------------------------------------------------------------------------------


def test_a_profile_file_that_changes_changes_nothing(tmp_path):
    """The system has read it; a system of the changed file is another one."""
    file = points_file(tmp_path / "worn.csv", wrcontact.ContactSystem().wheel)
    system, table = wrcontact.ContactSystem(wheel=str(file)), None
    for content in (None, "changed", "missing"):
        if content == "changed":
            points_file(file, wrcontact.ContactSystem().wheel, step=0.3)
            with pytest.raises(ValueError, match="the wheel profile has another content"):
                in_memory(wrcontact.ContactSystem(wheel=str(file)), store=tmp_path / "a.zarr")
        elif content == "missing":
            file.unlink()
        found = in_memory(system, store=tmp_path / f"{content or 'a'}.zarr")
        table = table or found.load()
        xarray.testing.assert_identical(found.load(), table)


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"wheel": "file", "rail": "54E1", "rail_inclination": 1 / 20, "stations": 11},
        {"wheel": ("S1002", "file"), "contact_mode": "elastic", "tangential_model": "strips"},
    ],
)
def test_a_store_has_the_whole_system(tmp_path, options):
    file = str(points_file(tmp_path / "worn.csv", wrcontact.ContactSystem().wheel))
    wheel = options.get("wheel", "S1002")
    wheel = (
        file
        if wheel == "file"
        else tuple(file if one == "file" else one for one in wheel)
        if isinstance(wheel, tuple)
        else wheel
    )
    system = wrcontact.ContactSystem(**{**options, "wheel": wheel})
    specification = asked(system, {"yaw": [0.0]}, "all", {})
    again = system_of(specification.record(), specification.profiles())
    own, other = system.evaluate(3e-3, yaw=2e-3, speed=10.0), again.evaluate(3e-3, yaw=2e-3, speed=10.0)
    np.testing.assert_array_equal(own.values, other.values)
    assert file not in str(specification.record()) + str(specification.profiles())


# --- lost and damaged chunks --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, damage",
    [
        ("right_area", None),
        ("right_area", "bit"),
        ("roll", b""),
        ("status", None),
        ("status", "bit"),
        ("status", b"\x00\x01garbage"),
    ],
)
def test_a_lost_or_damaged_chunk_is_computed_again(tmp_path, name, damage):
    """It is no NaN with status 0, and no error."""
    pytest.importorskip("zarr")
    shifts = np.linspace(-4e-3, 4e-3, 12)
    ask = {
        "axes": {"lateral_shift": shifts},
        "outputs": ["right.area", "roll"],
        "block": 4,
        "progress": False,
    }
    system = wrcontact.ContactSystem()
    whole = wrcontact.sweep(system, store=tmp_path / "own", **ask)["right_area"].values.copy()
    chunk = tmp_path / "own" / name / "c" / "1"
    assert chunk.is_file()
    if damage == "bit":  # in the middle; a checksum tells it
        kept = bytearray(chunk.read_bytes())
        kept[len(kept) // 2] ^= 1
        damage = bytes(kept)
    chunk.unlink() if damage is None else chunk.write_bytes(damage)
    states = []
    again = wrcontact.sweep(
        system, store=tmp_path / "own", **(ask | {"progress": lambda *given: states.append(given)})
    )
    assert states[-1][:2] == (4, 4)
    assert np.array_equal(again["right_area"].values, whole) and not again["status"].values.any()


def test_blocks_without_a_result_are_not_computed_again(tmp_path):
    pytest.importorskip("zarr")
    ask = {"axes": {"lateral_shift": np.linspace(0.2, 0.3, 8)}, "outputs": ["right.area"], "block": 4}
    system, states = wrcontact.ContactSystem(), []
    wrcontact.sweep(system, store=tmp_path / "own", progress=False, **ask)
    wrcontact.sweep(system, store=tmp_path / "own", progress=lambda *given: states.append(given), **ask)
    assert states == []
