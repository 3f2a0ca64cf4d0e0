"""Several processes give the table that one gives."""

import subprocess
import sys

import numpy as np
import pytest

import wrcontact

SYSTEM = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.1)
#: The third has no force on one wheel, the fourth lies beyond the profiles.
SHIFTS, TRANSFERS = np.array([1e-3, 0.0, 2e-3, 0.2, -3e-3]), np.array([0.0, 0.1, 1.0, 0.0, 0.0])


@pytest.mark.parametrize(
    "wanted",
    [
        {},
        pytest.param({"outputs": ["right.area", "roll"]}, marks=pytest.mark.full),
        pytest.param({"side": "left", "penetration": 5e-5}, marks=pytest.mark.full),
    ],
)
def test_rows_are_those_of_one_process(wanted):
    """In the same order, with the same bits."""
    alone = SYSTEM.evaluate_many(SHIFTS, load_transfer=TRANSFERS, **wanted)
    shared = SYSTEM.evaluate_many(SHIFTS, load_transfer=TRANSFERS, processes=2, **wanted)
    np.testing.assert_array_equal(shared.status, alone.status)
    assert alone.status[3] == wrcontact.Status.OFF_PROFILE
    assert shared.names == alone.names
    for name in alone.names:
        np.testing.assert_array_equal(shared[name], alone[name])


@pytest.mark.full
def test_parts_come_in_order():
    whole = SYSTEM.evaluate_many(SHIFTS, side="right", outputs=["right.area"])
    parts = list(SYSTEM.evaluate_parts(SHIFTS, side="right", outputs=["right.area"], processes=2))
    np.testing.assert_array_equal(np.concatenate([part["right.area"] for part in parts]), whole["right.area"])


@pytest.mark.parametrize("number", [0, -1, 1.5, True, "2", None])
def test_the_number_of_processes_is_checked(number):
    with pytest.raises(ValueError, match="processes is"):
        SYSTEM.evaluate_many(SHIFTS, processes=number)


def test_other_models_need_no_processes(monkeypatch):
    def none(*arguments):
        raise AssertionError

    monkeypatch.setattr("wrcontact.halfspace.stepping.shared_parts", none)
    table = wrcontact.ContactSystem().evaluate_many(SHIFTS, processes=2)
    assert table.status[0] == wrcontact.Status.VALID


@pytest.mark.full
def test_a_script_without_the_question_for_its_name_is_reported(tmp_path):
    """Its processes run it again as they start; without an answer they would start others without end.  The
    second process is late here: it is stopped while it works, and must not leave a pool behind, whose
    semaphores are then reported below the sentence."""
    script = tmp_path / "table.py"
    script.write_text(
        "import multiprocessing, time\n"
        "from concurrent.futures import ProcessPoolExecutor\n"
        "import wrcontact\n"
        "if multiprocessing.current_process().name == 'SpawnProcess-2':\n"
        "    ProcessPoolExecutor.map = lambda *arguments: time.sleep(3600)\n"
        "system = wrcontact.ContactSystem(normal_model='halfspace', tolerance=0.1)\n"
        "system.evaluate_many([1e-3, 0.0, 2e-3], processes=2)\n"
    )
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 1 and "a process of 2 has ended early" in done.stderr.splitlines()[-1]
    assert "leaked" not in done.stderr
