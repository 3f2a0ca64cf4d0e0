"""``wrcontact sweep --axis``: a table over several inputs in a store, and the sentences around it."""

import sys

import numpy as np
import pytest

import wrcontact
from tests.helpers.faults import cli, needs_linux
from wrcontact.cli.grids import _axis

AXES = (
    "--axis",
    "lateral_shift=-3e-3:3e-3:4",
    "--axis",
    "left.friction=0.1,0.3",
    "--tangential-model",
    "polach",
)


def test_axes():
    for text, name, values in (
        ("yaw=-1e-3:1e-3:5", "yaw", np.linspace(-1e-3, 1e-3, 5)),
        ("left.friction=0.1,0.2", "left.friction", [0.1, 0.2]),
        ("yaw=2e-3", "yaw", [2e-3]),
    ):
        found = _axis(text)
        assert found[0] == name
        np.testing.assert_array_equal(found[1], values)


@pytest.mark.parametrize(
    "words, sentence",
    [
        ("--axis yaw=0,1e-3", "--axis is given without --store, the folder of the table"),
        (
            "--axis yaw=0:1 --store a",
            "--axis is 'yaw=0:1'; permitted is NAME=START:STOP:COUNT, NAME=VALUE,VALUE",
        ),
        ("--axis yaw --store a", "--axis is 'yaw'; permitted is NAME=START:STOP:COUNT"),
        ("--axis yaw=0:1:x --store a", "--axis is 'yaw=0:1:x'; permitted is"),
        ("--axis yaw=0:1:1 --store a", "--axis has 1 values in 'yaw=0:1:1'; permitted are 2 ... 10000000"),
        ("--axis yaw=0 --axis yaw=1 --store a", "--axis has 'yaw' twice; permitted is each input once"),
        ("--axis yaw=0 --axis yaww=1 --store a", "--axis has 'yaww'; permitted are names of inputs, such as"),
        (
            "--axis yaw=1:1:3 --store a",
            "--axis yaw has 1 rad before 1 rad; permitted are values that all rise",
        ),
        ("--store a", "--store is given; it is permitted only with --axis"),
        ("--workers 2", "--workers is given; it is permitted only with --axis"),
        ("--axis yaw=0 --store a --workers 0", "--workers is 0; permitted is a whole number from 1 on"),
        (
            "--axis yaw=0 --store a --workers 2 --scheduler a:1",
            "--workers and --scheduler are given; permitted",
        ),
        ("--axis yaw=0 --store a --from-mm 1", "--from-mm is given; it is permitted only without --axis"),
        ("--axis yaw=0 --store a --output b.csv", "--output is given; it is permitted only without --axis"),
        (
            "--axis yaw=0 --store a --yaw-deg 1",
            "yaw is given twice, as an axis and as a number; permitted is",
        ),
        ("--axis left_friction=0.1 --store a", "--left-friction is given; it is permitted only with --tan"),
        ("--axis yaw=0 --store a --outputs right.ara", "--outputs has 'right.ara'; permitted are 'all'"),
    ],
)
def test_wrong_options(run, tmp_path, monkeypatch, words, sentence):
    monkeypatch.chdir(tmp_path)
    code, out, err = run("sweep", *words.split())
    assert (code, out, err.count("\n")) == (2, "", 1) and err.startswith(f"wrcontact: {sentence}")
    assert not list(tmp_path.iterdir())


def test_missing_packages_are_one_sentence(run, tmp_path, monkeypatch):
    for package, words, extra in (
        ("xarray", (), "tables"),
        ("distributed", ("--scheduler", "a:1"), "cluster"),
    ):
        monkeypatch.setitem(sys.modules, package, None)
        code, out, err = run("sweep", *AXES, "--store", tmp_path / "a.zarr", *words)
        assert (code, out) == (2, "") and f"pip install 'wrcontact[{extra}]'" in err and err.count("\n") == 1


@pytest.mark.full
def test_a_table_in_a_store(run, tmp_path):
    xarray, store = pytest.importorskip("xarray"), tmp_path / "a.zarr"
    pytest.importorskip("zarr")
    words = (
        "sweep",
        *AXES,
        "--speed",
        10,
        "--yaw-deg",
        0.1,
        "--outputs",
        "roll,left.friction_power",
        "--store",
        store,
    )
    for _ in range(2):  # the second finds all there
        assert run(*words) == (0, f"8 states in {store}: 8 valid\n", "")
    found = xarray.open_zarr(store, consolidated=False, chunks=None)
    direct = wrcontact.ContactSystem(tangential_model="polach").evaluate_many(
        np.repeat(np.linspace(-3e-3, 3e-3, 4), 2),
        yaw=np.radians(0.1),
        speed=10,
        left_friction=np.tile([0.1, 0.3], 4),
    )
    np.testing.assert_array_equal(found["left_friction_power"].values.ravel(), direct["left.friction_power"])
    code, out, err = run(*words, "--right-friction", 0.1)
    assert (code, out) == (2, "") and err == (
        f"wrcontact: the store {store} has another specification: right_friction is 0.1, there 0.3; permitted "
        "is the same specification, or another store\n"
    )
    code, out, err = run("sweep", "--axis", "yaw=0.5", "--outputs", "roll", "--store", tmp_path / "b.zarr")
    assert (code, out) == (2, "")
    assert err == f"wrcontact: no state in {tmp_path / 'b.zarr'} has a contact: 1 off profile\n"


@pytest.mark.full
def test_a_scheduler_that_does_not_answer(run, tmp_path, monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr("wrcontact.workers.PATIENCE", 1.0)
    for address in ("tcp://localhost:1", "somewhere"):
        code, out, err = run("sweep", *AXES, "--store", tmp_path / "a.zarr", "--scheduler", address)
        assert (code, out) == (2, "")
        assert err.startswith(
            f"wrcontact: --scheduler is {address!r}, where no dask scheduler answers within 1.0 s ("
        )


#: The command line gets a signal when the first block is there.
STRUCK = """
import contextlib, os, signal
from wrcontact.sweeps import run
plain = run.working

@contextlib.contextmanager
def working(*arguments, **options):
    with plain(*arguments, **options) as advance:
        def advanced(*steps, **words):
            advance(*steps, **words)
            os.kill(os.getpid(), signal.{blow})
        yield advanced

run.working = working
"""


@pytest.mark.full
@needs_linux
@pytest.mark.parametrize("blow, code, word", [("SIGINT", 130, "interrupted"), ("SIGTERM", 143, "terminated")])
def test_an_end_by_a_signal_says_how_to_go_on(run, tmp_path, blow, code, word):
    pytest.importorskip("zarr")
    store = tmp_path / "a.zarr"
    words = (
        "sweep",
        "--axis",
        "lateral_shift=-7e-3:7e-3:50",
        "--axis",
        "normal_force=5e4:1e5:5000",
        "--outputs",
        "roll,right.area",
        "--store",
        store,
    )
    program = cli(*words, "--workers", 1, before=STRUCK.format(blow=blow))
    out, err = program.communicate(timeout=600)
    assert (program.returncode, out) == (code, "")
    assert err.splitlines()[-1] == (
        f"wrcontact: {word}; the finished blocks are in {store}, and the same command goes on from there"
    )
    assert 0 < len(list(store.glob("status/c/*/*"))) < 5
    assert run(*words)[:2] == (0, f"250000 states in {store}: 250000 valid\n")
