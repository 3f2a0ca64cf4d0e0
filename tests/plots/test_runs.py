"""Pictures of runs: histories and animations of tables, arrays and files."""

from importlib.util import find_spec
from types import SimpleNamespace

import numpy as np
import pytest
from fmpy.util import write_csv
from PIL import Image

from data import HUNTING
from wrcontact import ContactSystem, WheelContact, plots
from wrcontact.plots.animation_frames import frames_of
from wrcontact.results.runs import Run

SYSTEM = ContactSystem()
MM = 1e-3


def test_a_history_has_the_columns_of_the_file_in_display_units():
    run = np.genfromtxt(HUNTING, delimiter=",", names=True, deletechars="", skip_header=0)
    axis = plots.history(HUNTING, "max_pressure")
    left, right = axis.lines
    np.testing.assert_allclose(left.get_xydata(), np.transpose([run["time"], run["left.max_pressure"] / 1e6]))
    np.testing.assert_allclose(right.get_ydata(), run["right.max_pressure"] / 1e6)
    assert (axis.get_xlabel(), axis.get_ylabel()) == ("time [s]", "max_pressure [MPa]")
    assert [text.get_text() for text in axis.get_legend().get_texts()] == ["left", "right"]


@pytest.mark.parametrize(
    "name, unit, factor",
    [
        ("yaw", "deg", 180 / np.pi),
        ("lateral_shift", "mm", 1e3),
        ("right.area", "mm²", 1e6),
        ("normal_force", "kN", 1e-3),
    ],
)
def test_units_of_a_history(name, unit, factor):
    run = {"time": np.arange(3.0), name: np.array([0.1, 0.2, 0.3])}
    axis = plots.history(run, name)
    assert axis.get_ylabel().endswith(f"[{unit}]")
    np.testing.assert_allclose(axis.lines[0].get_ydata(), run[name] * factor)


def test_a_table_of_states_and_an_array_have_histories():
    table = SYSTEM.evaluate_many(np.linspace(-1, 1, 5) * MM)
    axis = plots.history(table, ["left.contact.y_wheel", "right.contact.y_wheel"], over="lateral_shift")
    np.testing.assert_allclose(axis.lines[0].get_xdata(), [-1, -0.5, 0, 0.5, 1], atol=1e-12)
    np.testing.assert_allclose(axis.lines[1].get_ydata(), table.right.contact.y_wheel / MM)
    result = np.zeros(3, dtype=[("time", float), ("roll", float)])  # as fmpy has it
    assert len(plots.history(result, "roll", over=[0.0, 1.0, 2.0]).lines[0].get_xdata()) == 3


def test_a_run_of_one_wheel_has_its_names():
    """Inputs too; a state of one pose has numbers, and what is no run is refused."""
    table = WheelContact(side="left").evaluate_many(vertical_shift_input=[1e-4, 2e-4], friction=0.4)
    run = Run.of(table)
    assert run["friction"].tolist() == [0.4, 0.4] and "left.friction" not in run
    assert run["force.z"].tolist() == table.force.z.tolist()
    assert plots.history(table, "area", over="vertical_shift_input").lines[0].get_xdata().tolist() == [
        0.1,
        0.2,
    ]
    assert Run.of(SYSTEM.evaluate(1e-3))["lateral_shift"] == 1e-3
    polars = SimpleNamespace(columns=["roll"])  # a frame without keys
    assert "roll" in Run.of(polars) and "yaw" not in Run.of(polars)
    with pytest.raises(ValueError, match="^run is int; permitted are the path of a .csv or .parquet file"):
        Run.of(3)


@pytest.mark.parametrize(
    "text, given, words",
    [
        ("time,yaw\n0,1\n", "yav", "run.csv has no column 'yav'; did you mean yaw?"),
        (
            "time,yaw,roll\n0,1,2\n",
            ["yaw", "time"],
            "yaw and time have 2 units; permitted is one for an axis",
        ),
        ("time,yaw\n0,1,2\n", "yaw", "row 2 of .* has 3 values; permitted are as many as there are names, 2"),
        ("time,yaw\n0,left\n", "yaw", "has a value that is no number: .*left"),
        ("time,yaw\n", "yaw", "has no rows; permitted is a line of names"),
    ],
)
def test_what_a_history_refuses(tmp_path, text, given, words):
    (tmp_path / "run.csv").write_text(text)
    with pytest.raises(ValueError, match=words):
        plots.history(tmp_path / "run.csv", given)


def test_booleans_and_empty_cells_of_a_file_are_read(tmp_path):
    (tmp_path / "run.csv").write_text('"time","flag","yaw"\n0,True,\n1,False,2\n')
    run = plots.read_run(tmp_path / "run.csv")
    assert run["flag"].tolist() == [1.0, 0.0] and np.isnan(run["yaw"][0]) and run["yaw"][1] == 2.0


def test_a_file_that_fmpy_wrote_is_read(tmp_path):
    result = np.zeros(3, dtype=[("time", float), ("right.area", float), ("free_rolling", bool)])
    result["time"], result["right.area"], result["free_rolling"] = [0, 1, 2], [1e-4, 2e-4, 3e-4], [1, 0, 1]
    write_csv(str(tmp_path / "run.csv"), result)
    axis = plots.history(tmp_path / "run.csv", "right.area")
    np.testing.assert_allclose(axis.lines[0].get_xydata(), [[0, 100], [1, 200], [2, 300]])
    assert plots.read_run(tmp_path / "run.csv")["free_rolling"].tolist() == [1.0, 0.0, 1.0]


# --- animations ---------------------------------------------------------------------------------------------


def test_a_film_has_the_states_of_the_run():
    """Frames are evenly chosen; contact points are those of the file, which another program computed."""
    run = plots.read_run(HUNTING)
    shown = frames_of(SYSTEM, run, 9)
    assert len(shown.rows) == 9 and shown.time[[0, -1]].tolist() == run["time"][[0, -1]].tolist()
    for row, time in zip(shown.rows, shown.time):
        at = int(np.argmin(np.abs(run["time"] - time)))
        assert row.inputs.lateral_shift == run["lateral_shift"][at]
        assert row.right.contact.y_wheel == pytest.approx(run["right.contact.y_wheel"][at], abs=1e-6)  # [m]
        across = row.right.outline.station + row.right.contact.y_rail
        assert shown.window[0] - 5 < across[0] / MM and across[-1] / MM < shown.window[1] + 5


def test_a_film_of_a_compliant_wheelset_has_its_height_and_roll():
    """As the wheelset of a closed loop has them, vertical_shift and roll are where the contact stands."""
    system, rigid = ContactSystem(contact_mode="compliant"), SYSTEM.evaluate(2e-3)
    run = {
        "lateral_shift": np.full(2, 2e-3),
        "vertical_shift": np.full(2, rigid.vertical_shift + 8e-5),
        "roll": np.full(2, rigid.roll),
        "time": np.array([0.0, 0.1]),
        "speed": np.array([10.0, 20.0]),
    }
    shown = frames_of(system, run, 5)
    assert shown.distance.tolist() == [0.0, pytest.approx(1.5)]
    assert shown.rows[1].right.patches[0].penetration == pytest.approx(8e-5, rel=0.05)
    assert shown.rows[1].vertical_shift == run["vertical_shift"][1]


@pytest.mark.full
def test_an_animation_has_its_frames(tmp_path):
    table = SYSTEM.evaluate_many(np.array([-6.5, 0.0, 6.5]) * MM, yaw=np.array([0.0, 5e-3, 0.0]))
    with Image.open(plots.animate(SYSTEM, table, tmp_path / "run.gif", frames=3)) as film:
        frames = []
        for place in range(film.n_frames):
            film.seek(place)
            frames.append(np.asarray(film.convert("L"), dtype=float))
    assert len(frames) == 3
    for frame, other in zip(frames, frames[1:]):
        assert 0.005 < np.mean(np.abs(frame - other) > 20) < 0.3  # what moves; all else stands still


@pytest.mark.full
@pytest.mark.skipif(not find_spec("imageio_ffmpeg"), reason="imageio-ffmpeg is not installed")
def test_an_animation_by_ffmpeg(tmp_path):
    file = plots.animate(SYSTEM, SYSTEM.evaluate_many(np.array([0.0, 1e-3])), tmp_path / "run.mp4")
    assert file.read_bytes()[4:8] == b"ftyp"


@pytest.mark.parametrize(
    "name, run, given, words",
    [
        ("run.png", {"lateral_shift": np.zeros(2)}, {}, "permitted are files that end in .gif or .mp4"),
        ("run.gif", {"time": np.zeros(2)}, {}, "the run has no 'lateral_shift'"),
        ("run.gif", {"lateral_shift": np.full(2, 0.02)}, {}, "none of the 2 poses of the run has a contact"),
        (
            "run.gif",
            {"lateral_shift": np.zeros(2)},
            {"frames": 0},
            "frames is 0; permitted are whole numbers",
        ),
        ("run.gif", {"lateral_shift": np.zeros(2)}, {"rate": 0.0}, "rate is 0 frames per second"),
    ],
)
def test_what_an_animation_refuses(tmp_path, name, run, given, words):
    with pytest.raises(ValueError, match=words):
        plots.animate(SYSTEM, run, tmp_path / name, **given)
    assert not list(tmp_path.iterdir())


def test_without_ffmpeg_a_sentence_says_what_to_do(tmp_path, monkeypatch):
    monkeypatch.setattr("wrcontact.plots.animation.find_spec", lambda name: None)
    monkeypatch.setattr("matplotlib.animation.FFMpegWriter.isAvailable", classmethod(lambda cls: False))
    with pytest.raises(
        ValueError, match="needs ffmpeg, and there is none; permitted is a file that ends in .gif"
    ):
        plots.animate(SYSTEM, {"lateral_shift": np.zeros(2)}, tmp_path / "run.mp4")
