"""``wrcontact export``."""

import numpy as np
import pytest

from wrcontact import ContactSystem
from wrcontact.export import read_contact_table


def test_a_table_of_shifts_and_yaws(run, tmp_path):
    file = tmp_path / "contacts.csv"
    code, out, err = run(
        "export",
        "--shifts-mm",
        "-2:2:2",
        "--yaws-deg",
        "0,1",
        "--rail",
        "54E1",
        "--output",
        file,
    )
    assert code == 0 and err == "" and f"6 rows written to {file}" in out.replace("\n", " ")
    found = read_contact_table(file)
    np.testing.assert_allclose(found["lateral_shift"], [-2e-3, 0.0, 2e-3] * 2, atol=1e-15)
    np.testing.assert_allclose(found["yaw"], np.radians([0.0] * 3 + [1.0] * 3))
    state = ContactSystem(rail="54E1").evaluate(2e-3, np.radians(1.0))
    assert found["left.contact.y_wheel"][5] == pytest.approx(state.left.contact.y_wheel, rel=1e-9)


def test_a_pose_and_a_run_for_contact(run, tmp_path):
    code, out, _ = run("export", "--to", "contact", "--lateral-shift-mm", 1, "--output", tmp_path / "one")
    assert code == 0 and "right.inp" in out and (tmp_path / "one" / "left_rail.prr").exists()
    (tmp_path / "run.csv").write_text("time,lateral_shift,yaw\n0,1e-3,0\n0.1,2e-3,1e-3\n")
    code, _, _ = run("export", "--to", "contact", "--run", tmp_path / "run.csv", "--output", tmp_path / "two")
    text = (tmp_path / "two" / "right.inp").read_text()
    assert code == 0 and text.count("1 MODULE") == 2 and "lateral shift 2 mm, yaw 1 mrad" in text


@pytest.mark.parametrize(
    "words, said",
    [
        (("--to", "um"), "--to is 'um'; permitted are 'contact', 'table'"),
        (
            ("--to", "contact", "--shifts-mm", "1:2:1"),
            "--shifts-mm is given; it is permitted only with --to table",
        ),
        (("--shifts-mm", "1:2"), "--shifts-mm is '1:2'; permitted is FROM:TO:STEP"),
        (("--run", "a.csv"), "--run is given"),
        (("--lateral-shift-mm", 1), "--lateral-shift-mm is given"),
        (("--yaw-deg", 1, "--yaws-deg", "1"), "permitted is one of them"),
        (("--yaws-deg", "1,a"), "--yaws-deg is '1,a'"),
        (("--output", "a.txt"), "ends in .csv"),
        (("--to", "contact", "--run", "none.csv", "--yaw-deg", 1), "--run and inputs of a pose"),
    ],
)
def test_what_does_not_belong_is_refused(run, words, said):
    code, _, err = run("export", *words)
    assert code == 2 and said in " ".join(err.split())
