"""Files of a sweep in every format, what happens when the output stream fails, and the command build."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.helpers.command_line import OUTSIDE, read_csv, start
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem, Stepper
from wrcontact.cli import main, tables
from wrcontact.fmu import build, native
from wrcontact.results.convert import columns_of

MAIN = "from wrcontact.cli import main; main(prog_name='wrcontact')"
SWEEP = ("sweep", "--from-mm", 13, "--to-mm", 16, "--step-mm", 0.25)  # the last rows are off the profile


@pytest.fixture(scope="module")
def table():
    return ContactSystem().evaluate_many(lateral_shift=np.arange(13, 16.1, 0.25) / 1e3)


# --- files of a sweep -------------------------------------------------------------------------------------


@pytest.mark.parametrize("option", ["--output", "--csv"])
def test_csv(run, tmp_path, table, option):
    code, out, err = run(*SWEEP, option, tmp_path / "a.csv")
    assert (code, out) == (0, f"13 rows written to {tmp_path / 'a.csv'}\n") and "4 of 13 rows" in err
    assert_columns(read_csv(tmp_path / "a.csv"), table)


def test_named_outputs_in_a_file(run, tmp_path):
    words = ("sweep", "--from-mm", 0, "--to-mm", 3, "--step-mm", 0.5, "--outputs", "roll,right.area")
    assert run(*words, "--output", tmp_path / "a.csv")[0] == 0
    found = read_csv(tmp_path / "a.csv")
    assert list(found) == ["lateral_shift", "roll", "right.area", "status"]
    state = ContactSystem().evaluate(lateral_shift=2e-3)
    assert (found["roll"][4], found["right.area"][4]) == (state.roll, state.right.area)
    code, _, err = run(*words)
    assert (
        code == 2 and err == "wrcontact: --outputs is given; it is permitted only with --output or --axis\n"
    )
    code, _, err = run(*words[:-1], "rol", "--output", tmp_path / "b.csv")
    assert code == 2 and "--outputs has 'rol'; permitted are" in err and not (tmp_path / "b.csv").exists()


@pytest.mark.full  # README's command installs none of the tables' packages
def test_a_netcdf_file_has_the_shift_as_a_coordinate(run, tmp_path):
    xarray = pytest.importorskip("xarray")
    words = ("--from-mm", 0, "--to-mm", 3, "--outputs", "roll")
    assert run("sweep", *words, "--output", tmp_path / "a.nc")[0] == 0
    with xarray.open_dataset(tmp_path / "a.nc") as data:
        assert set(data.coords) == {"lateral_shift"} and set(data.data_vars) == {"roll", "status"}


def assert_columns(found, table):
    assert list(found) == list(columns_of(table))
    for name, values in columns_of(table).items():
        np.testing.assert_array_equal(np.asarray(found[name], dtype=float), values, err_msg=name)


def test_json(run, tmp_path, table):
    assert run(*SWEEP, "--output", tmp_path / "a.json")[0] == 0
    rows = json.loads((tmp_path / "a.json").read_text())
    assert rows[-1]["roll"] is None and rows[0]["status"] == 0
    assert_columns({name: [row[name] for row in rows] for name in rows[0]}, table)


@pytest.mark.full
def test_parquet(run, tmp_path, table, monkeypatch):
    parquet = pytest.importorskip("pyarrow.parquet")
    monkeypatch.setattr(tables, "GROUP", 5)  # several groups
    assert run(*SWEEP, "--parquet", tmp_path / "a.parquet")[0] == 0
    read = parquet.read_table(tmp_path / "a.parquet")
    assert str(read.schema.field("status").type) == "int64"
    assert_columns({name: read[name].to_numpy() for name in read.column_names}, table)


@pytest.mark.full
def test_netcdf(run, tmp_path, table):
    netcdf = pytest.importorskip("netCDF4")
    assert run(*SWEEP, "--output", tmp_path / "a.nc")[0] == 0
    with netcdf.Dataset(tmp_path / "a.nc") as data:
        assert data["pressure"].dimensions == ("pose", "side", "station_number")
        assert list(data["side"][:]) == ["left", "right"] and data["area"].units == "m2"
        np.testing.assert_array_equal(data["pressure"][:, 1], table.right.outline.pressure)
        np.testing.assert_array_equal(data["patch.area"][:, 0, 1], table["left.patch[2].area"])
        np.testing.assert_array_equal(data["status"][:], table.status)


@pytest.mark.full
def test_parts_of_a_netcdf_file_follow_each_other(tmp_path, table):
    """Three parts of a table, with 5, 1 and 7 poses."""
    netcdf = pytest.importorskip("netCDF4")
    shifts = np.arange(13, 16.1, 0.25) / 1e3
    with tables.TableFile(tmp_path / "a.nc", "netcdf").open(13) as write:
        for part in np.split(shifts, [5, 6]):
            write(ContactSystem().evaluate_many(lateral_shift=part))
    with netcdf.Dataset(tmp_path / "a.nc") as data:
        np.testing.assert_array_equal(data["status"][:], table.status)
        np.testing.assert_array_equal(data["pressure"][:, 1], table.right.outline.pressure)


@pytest.mark.parametrize("ending, package", [("parquet", "pyarrow"), ("nc", "netCDF4")])
def test_a_missing_package_is_one_sentence(run, tmp_path, monkeypatch, ending, package):
    monkeypatch.setitem(sys.modules, package, None)
    code, out, err = run(*SWEEP, "--output", tmp_path / f"a.{ending}")
    assert code == 2 and out == "" and not list(tmp_path.iterdir())
    assert err.startswith(f"wrcontact: a .{ending} file needs {package}, which is not installed; pip install")
    assert err.count("\n") == 1


@pytest.mark.full
def test_memory_does_not_grow_with_the_rows(run, tmp_path, monkeypatch):
    """No more than 512 rows are there at a time."""
    sizes = []

    def step_many(self, inputs, outputs, status):
        sizes.append(len(outputs))
        outputs[:], status[:] = 1.0, 0

    monkeypatch.setattr(Stepper, "step_many", step_many)
    assert run("sweep", "--from-mm", 0, "--to-mm", 0.03, "--step-mm", 1e-5, "--csv", tmp_path / "a")[0] == 0
    assert sum(sizes) == 3001 and max(sizes) <= 512
    assert len((tmp_path / "a").read_text().splitlines()) == 3002


def test_a_shift_is_printed_with_the_digits_of_its_step(run):
    _, out, _ = run("sweep", "--from-mm", 0, "--to-mm", 0.0002, "--step-mm", 0.0001)
    assert "0.00010" in out and "0.00020" in out


# --- the output stream fails ------------------------------------------------------------------------------


@pytest.mark.full
@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no /dev/full")
@pytest.mark.parametrize("words", [("solve",), ("--help",), ("sweep", "--step-mm", "4")], ids=" ".join)
def test_a_full_disk_is_one_sentence(tmp_path, words):
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-c", MAIN, *words],
            env=OUTSIDE,
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            cwd=tmp_path,
        )
    assert done.returncode == 1
    assert done.stderr == "wrcontact: the output cannot be written: No space left on device\n"


def test_a_reader_that_leaves_is_no_error(tmp_path):
    command = [sys.executable, "-c", MAIN, "solve", "--json"]
    done = subprocess.Popen(
        command, env=OUTSIDE, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    done.stdout.close()
    assert done.stderr.read() == b"" and done.wait() == 1


def test_an_ascii_terminal_gets_question_marks(tmp_path):
    """A profile's name has a letter that the terminal does not."""
    script = (
        "import wrcontact, sys; from wrcontact.cli import report, main\n"
        "from wrcontact.profiles import Profile, standard_profile\n"
        "import wrcontact.cli.commands as c\n"
        "wheel = Profile('Ü', 'wheel', standard_profile('S1002').zones)\n"
        "c._system = lambda *a: wrcontact.ContactSystem(wheel=wheel)\n"
        "main(['solve'])"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**OUTSIDE, "PYTHONIOENCODING": "ascii"},
        capture_output=True,
        cwd=tmp_path,
    )
    assert done.returncode == 0 and done.stdout.startswith(b"? on UIC60") and done.stderr == b""


# --- build ------------------------------------------------------------------------------------------------


@pytest.fixture
def asked(monkeypatch):
    """What the command asks for; nothing is built."""
    asked = []

    def builder(name):
        def built(**chosen):
            asked.append((name, chosen))
            return Path(name) if name == "python" else [Path("fmi2"), Path("fmi3")]

        return built

    monkeypatch.setattr(build, "build_fmu", builder("python"))
    monkeypatch.setattr(native, "build_native_fmus", builder("native"))
    return asked


def test_build_passes_its_options_on(run, asked):
    assert run("build") == (0, "python\n", "")
    assert run(
        "build",
        "--native",
        "--platforms",
        "x86_64-linux,x86_64-windows",
        "--wheel",
        "w.csv",
        "--rail",
        "54E1",
        "--output",
        "here",
        "--smoothing-um",
        10,
    ) == (0, "fmi2\nfmi3\n", "")
    nothing = {"wheel": (None, None), "rail": (None, None), "smoothing": None, "settings": {}}
    assert asked[0] == ("python", {"output": Path("dist"), **nothing})
    assert asked[1] == (
        "native",
        {
            "output": Path("here"),
            "wheel": (None, "w.csv"),
            "rail": (None, "54E1"),
            "smoothing": 1e-5,
            "settings": {},
            "platforms": ["x86_64-linux", "x86_64-windows"],
        },
    )


def test_build_of_all_platforms(run, asked):
    assert run("build", "--native", "--platforms", "all")[0] == 0
    assert len(asked[0][1]["platforms"]) == 5


def test_build_refuses_an_unknown_profile(run, tmp_path):
    code, out, err = run("build", "--wheel", "no such", "--output", tmp_path / "out")
    assert code == 2 and out == "" and err.startswith("wrcontact: --wheel is 'no such'; permitted are S1002")
    assert not (tmp_path / "out").exists()


@pytest.mark.full
def test_build_fmu_is_the_command(tmp_path):
    done = start(str(ROOT / "build_fmu.py"), "--help-all", folder=tmp_path)
    assert done.returncode == 0 and "build_fmu.py build" in done.stdout
    for option in ("--output", "--native", "--platforms", "--wheel", "--rail", "--smoothing-um"):
        assert option in done.stdout
    with pytest.raises(SystemExit):
        main(["build", "--help"])
