"""The demo: what it prints and writes, and that its checks can fail."""

import os
import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

import wrcontact.fmu
from tests.helpers.cases import INPUT_NAMES
from tests.helpers.command_line import read_csv, start
from wrcontact import ContactSystem
from wrcontact.cli import demo as demo_module
from wrcontact.cli.demo import compare, stored_inputs, stored_run
from wrcontact.interface.variables import PLACE, VARIABLES
from wrcontact.plots.geometry import wheel_zone
from wrcontact.results.convert import columns_of


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """The demo, run once in a process of its own: what it said, and its folder."""
    folder = tmp_path_factory.mktemp("demo")
    done = start("-c", "from wrcontact.cli import main; main()", "demo", "--output", "here", folder=folder)
    return done, folder / "here"


@pytest.mark.full
def test_demo_passes_its_checks(demo):
    done, _ = demo
    assert done.returncode == 0 and "PASSED" in done.stdout, done.stdout + done.stderr


@pytest.mark.full
def test_demo_says_what_it_checked(demo):
    done, _ = demo
    verdicts = dict(re.findall(r"^ *(\w[\w ]*?)  .*?(ok|FAILED) *$", done.stdout, re.MULTILINE))
    assert set(verdicts) == {"steps not valid", *(row[0] for row in demo_module.TOLERANCES)}
    assert done.returncode == (1 if "FAILED" in verdicts.values() else 0)
    for quantity in ("steps not valid", "roll", "vertical shift", "contact positions", "rolling radius"):
        assert verdicts[quantity] == "ok", done.stdout
    assert re.search(r"160 steps, median \d+\.\d+ ms \(", done.stdout)
    assert "Traceback" not in done.stderr


@pytest.mark.full
def test_demo_leaves_three_files(demo):
    _, folder = demo
    assert sorted(os.listdir(folder)) == ["WheelsetContact.fmu", "demo.csv", "demo.png"]


@pytest.mark.full
def test_demo_table_is_what_the_kernel_returns(demo):
    """Another warm start, so other iterations, but the same answers."""
    written, stored = read_csv(demo[1] / "demo.csv"), stored_run()
    assert np.array_equal(written["time"], stored["time"])
    expected = columns_of(
        ContactSystem().evaluate_many(**{name: stored[name] for name in stored_inputs(stored)})
    )
    equilibrium = {"equilibrium.vertical_shift", "equilibrium.roll"}  # of FMUs, not of tables
    assert set(written) == {"time", *expected, *equilibrium} and set(INPUT_NAMES) <= set(written)
    for name, column in expected.items():
        nominal = VARIABLES[PLACE[name]].nominal or 1.0
        np.testing.assert_allclose(written[name], column, rtol=1e-7, atol=1e-7 * nominal, err_msg=name)


@pytest.mark.full
def test_demo_covers_tread_flange_root_and_flange_on_both_sides(demo):
    written = read_csv(demo[1] / "demo.csv")
    for side in ("left", "right"):
        zones = {wheel_zone(y) for y in written[f"{side}.contact.y_wheel"]}
        assert zones == {"tread", "flange root", "flange"}


@pytest.mark.full
def test_demo_picture_shows_something(demo):
    picture = imread(demo[1] / "demo.png")[..., :3]
    assert picture.shape[0] > 1000 and picture.shape[1] > 1000
    assert len(np.unique((255 * picture).astype(int) @ (65536, 256, 1))) > 1000  # colours
    assert 0.05 < np.mean(np.any(picture < 0.95, axis=-1)) < 0.6  # share of the paper that is not white


@pytest.fixture
def answers():
    """What an FMU would answer that returns the stored values."""
    stored = stored_run()
    wanted = {name: column.copy() for name, column in stored.items() if name not in ("time", *INPUT_NAMES)}
    return {**wanted, "status": np.zeros(len(stored["time"]))}


def failed(answers):
    return [check.quantity for check in compare(answers, stored_run()) if not check.passed]


def test_stored_values_pass(answers):
    assert failed(answers) == []


@pytest.mark.parametrize(
    "name, change, quantity",
    [
        ("roll", lambda v: v + 1.1e-9, "roll"),  # [rad]
        ("left.contact.x_track", lambda v: v - 1.1e-6, "contact positions"),  # [m]
        ("right.contact.y_wheel", lambda v: v + 1.1e-6, "contact positions"),
        ("right.penetration", lambda v: 1.161 * v, "penetration"),
        ("left.area", lambda v: 0.819 * v, "area"),
        ("right.max_pressure", lambda v: 1.301 * v, "largest pressure"),
        ("left.max_pressure", lambda v: v * np.nan, "largest pressure"),
        ("status", lambda v: v + 2, "steps not valid"),
    ],
)
def test_one_wrong_value_fails_its_check(answers, name, change, quantity):
    answers[name][40] = change(answers[name][40])
    assert failed(answers) == [quantity]
    check = next(check for check in compare(answers, stored_run()) if check.quantity == quantity)
    assert check.within == check.count - 1
    assert check.place.startswith(f"{stored_run()['lateral_shift'][40] * 1e3:.2f}")


@pytest.mark.parametrize(
    "name, tolerance, quantity",
    [
        ("right.penetration", 0.05, "penetration"),
        ("left.area", 0.10, "area"),
        ("right.max_pressure", 0.15, "largest pressure"),
    ],
)
def test_every_patch_keeps_its_tolerance(answers, name, tolerance, quantity):
    answers[name][40] = stored_run()[name][40] * (1.0 + 0.999 * tolerance)
    assert failed(answers) == []
    answers[name][40] = stored_run()[name][40] * (1.0 + 1.001 * tolerance)
    assert failed(answers) == [quantity]


def test_patches_that_lean_are_compared_as_all_others(answers):
    """A pressure counts whatever the angles of the patches, and every value is counted."""
    for k, force in ((1, 6e4), (2, 2e4), (3, 0.0)):
        answers[f"right.patch[{k}].normal_force"] = np.full(160, force)
        answers[f"right.patch[{k}].contact_angle"] = answers["right.contact_angle"] + 0.8 * (k == 2)
    answers["right.max_pressure"][40] *= 0.5
    assert failed(answers) == ["largest pressure"]
    check = next(check for check in compare(answers, stored_run()) if check.quantity == "largest pressure")
    assert check.count == 2 * 160 and check.within == check.count - 1


@pytest.mark.parametrize("name, change", [("roll", 0.9e-9), ("left.contact.z_rail", 0.9e-6)])
def test_a_deviation_within_the_tolerance_passes(answers, name, change):
    answers[name][40] += change
    assert failed(answers) == []


@pytest.mark.parametrize("right, code, word", [(True, 0, "PASSED"), (False, 1, "FAILED: roll")])
def test_exit_code_follows_the_checks(run, answers, tmp_path, monkeypatch, right, code, word):
    if not right:
        answers["roll"][7] += 1e-6
    monkeypatch.setattr(wrcontact.fmu, "build_fmu", lambda folder: Path(folder, "some.fmu"))
    monkeypatch.setattr(demo_module, "apart", lambda function, fmu, stored: (answers, np.ones(160)))
    monkeypatch.setattr(demo_module, "draw", lambda path, answers, stored: None)
    ended, out, _ = run("demo", "--output", tmp_path)
    assert ended == code and word in out
