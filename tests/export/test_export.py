"""Tables and input files for other programs.

Witnesses: the input of CONTACT's own example, the Manchester benchmark, and its published rolls and rotations; profiles
and tables read back.
"""

import csv
import warnings

import numpy as np
import pytest

import wrcontact
from data import FOLDER, manchester
from wrcontact import Profile, export
from wrcontact.profiles.placement import place_rail


def numbers(line):
    """The numbers before the names of a line; "90d" is 90."""
    found = []
    for word in line.split():
        try:
            found.append(float(word.rstrip("d")))
        except ValueError:
            if not word.startswith("'"):
                break
    return found


def cases(path):
    """Lines of each case of an input file, without comments and blanks."""
    lines = [line for line in path.read_text().splitlines() if line.strip() and not line.startswith("%")]
    assert lines[-1].split() == ["0", "MODULE"]
    starts = [k for k, line in enumerate(lines) if line.split()[:2] == ["1", "MODULE"]]
    return [lines[a:b] for a, b in zip(starts, [*starts[1:], len(lines) - 1])]


@pytest.fixture(scope="module")
def benchmark():
    return wrcontact.ContactSystem(
        youngs_modulus=2 * manchester.SHEAR * (1 + manchester.POISSON),
        poisson_ratio=manchester.POISSON,
        load="vertical",
        contact_mode="elastic",
        tangential_model="strips",
    )


def test_the_manchester_benchmark(tmp_path, benchmark):
    """CONTACT's example has these numbers; rolls and rotations are those of the benchmark, which the package finds to
    2e-7 rad and 4e-5 on the tread."""
    with open(FOLDER / "manchester_a22_creepages.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["side"] == "right"][1:5]
    shifts, yaws = (np.array([float(row[name]) for row in rows]) for name in ("lateral_shift_mm", "yaw_rad"))
    table = benchmark.evaluate_many(1e-3 * shifts, yaws, 10e3, speed=2.0)
    paths = export.to_contact(benchmark, table, tmp_path)
    assert [path.name for path in paths] == ["left.inp", "right.inp"]
    for path, side in zip(paths, "01"):
        found = cases(path)
        assert len(found) == 4
        first = [numbers(line) for line in found[0]]
        assert [line.split()[0] for line in found[0][1:4]] == [side + "203100", "0022033", "0000321"]
        assert first[4:7] == [[999, 100, 30, 1, 1e-5], [0.3, 0.3], [0.28, 0.28, 82000, 82000]]
        assert first[7:9] == [[0.2, 0.2, 1, 90, 8, 4], [14, 0, 1435, 0]]
        assert first[10] == [0] * 6 and first[11] == [1360, -70, 460]
        assert first[9] == first[12] == [0, 1, 0]  # mirror, scale, smoothing of the profiles
        for one, row in zip(found, rows):
            place, velocity = numbers(one[-2]), numbers(one[-1])
            assert place[:2] == [0, float(row["lateral_shift_mm"])] and place[2] == pytest.approx(
                10e3, rel=1e-8
            )
            assert place[3] == pytest.approx(float(row["roll_rad"]), abs=3e-7)
            assert place[4:] == [float(row["yaw_rad"]), 0]
            assert velocity[:5] == [2000, 0, 0, 0, 0]
            assert velocity[5] == pytest.approx(float(row["pitch_rate_rad_s"]), rel=1e-4)
        assert [line.split()[0] for line in found[1][1:4]] == [side + "203100", "0011002", "0100321"]
        assert len(found[1]) == 7


def test_profiles_beside_the_input_are_the_placed_ones(tmp_path):
    """The rail leans already; both sides differ."""
    system = wrcontact.ContactSystem(
        wheel=("LMA", "S1002"), rail=("54E1", "60E1"), rail_inclination=(0.05, 0.025)
    )
    export.to_contact(system, system.evaluate(1e-3), tmp_path)
    for side, rail, inclination in (("left", "54E1", 0.05), ("right", "60E1", 0.025)):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = Profile.from_file(
                tmp_path / f"{side}_rail.prr", "rail", smoothing=0.0, file_inclination=0.0
            )
        wanted = place_rail(
            system.left_rail if side == "left" else system.rail,
            inclination=inclination,
            gauge=1.435,
            gauge_depth=0.014,
        )
        y = np.linspace(-0.03, 0.03, 601)
        assert rail in wanted.profile.name
        np.testing.assert_allclose(found.height(y), wanted.profile.height(y), atol=1e-7)
        y_wheel = np.linspace(-0.02, 0.02, 81)
        wheel = Profile.from_file(tmp_path / f"{side}_wheel.prw", "wheel", smoothing=0.0)
        mine = system.left_wheel if side == "left" else system.wheel
        np.testing.assert_allclose(wheel.height(y_wheel), mine.height(y_wheel), atol=1e-7)


def test_without_creep_forces_nothing_rubs(tmp_path):
    system = wrcontact.ContactSystem()
    state = system.evaluate(2e-3, normal_force=60e3, load_transfer=0.2)
    left, right = (cases(path)[0] for path in export.to_contact(system, state, tmp_path))
    assert left[1].split()[0] == "0200100" and right[1].split()[0] == "1200100"
    assert numbers(left[-2])[2] == pytest.approx(-state.left.force.z, rel=1e-8)
    assert numbers(right[-2])[2] == pytest.approx(-state.right.force.z, rel=1e-8)
    assert numbers(right[-1])[5] == 0.0


def test_rates_follow_both_wheels(tmp_path):
    """A rigid wheelset that moves sideways falls and rolls as the next pose does."""
    system = wrcontact.ContactSystem(tangential_model="strips")
    state = system.evaluate(3e-3, speed=20.0, lateral_velocity=0.1, yaw_rate=0.02)
    line = numbers(cases(export.to_contact(system, state, tmp_path)[1])[0][-1])
    ahead, behind = (system.evaluate(3e-3 + 0.1 * dt, 0.02 * dt) for dt in (1e-5, -1e-5))
    assert line[1] == 100.0 and line[4] == 0.02
    assert line[2] == pytest.approx(1e3 * (ahead.vertical_shift - behind.vertical_shift) / 2e-5, rel=1e-3)
    assert line[3] == pytest.approx((ahead.roll - behind.roll) / 2e-5, rel=1e-3)


@pytest.mark.parametrize(
    "parameters, inputs, words",
    [
        ({}, {"track_curvature": 1e-3}, "pose 1 has a track_curvature"),
        ({}, {"left_rail_roll": 1e-3}, "pose 1 has a rail that is moved"),
        ({}, {"lateral_shift": 0.03}, "pose 1 has the status 2"),
        ({"friction_fall": 0.4, "tangential_model": "strips"}, {}, "friction_fall is 0.4"),
        ({"flange_friction_ratio": 0.4, "tangential_model": "strips"}, {}, "flange_friction_ratio is 0.4"),
    ],
)
def test_what_contact_has_no_number_for_is_refused(tmp_path, parameters, inputs, words):
    system = wrcontact.ContactSystem(**parameters)
    with pytest.raises(ValueError, match=words):
        export.to_contact(system, system.evaluate(**inputs), tmp_path / "out")
    assert not (tmp_path / "out").exists()


# --- tables -------------------------------------------------------------------------------------------------


def test_tables_come_back(tmp_path):
    """With a row off the profiles; and each row is the pose itself."""
    system = wrcontact.ContactSystem(rail="54E1")
    shifts, yaws = np.array([-5e-3, 0.0, 0.03]), np.array([0.0, 20e-3])
    table = export.contact_table(system, shifts, yaws)
    export.write_contact_table(tmp_path / "contacts.csv", table)
    found = export.read_contact_table(tmp_path / "contacts.csv")
    assert set(found) | {"title"} == set(table) and len(found["yaw"]) == 6
    for name, values in found.items():
        np.testing.assert_allclose(values, table[name], rtol=1e-14, atol=1e-18)
    pose = system.evaluate(-5e-3, 20e-3)
    assert found["right.contact_angle"][3] == pytest.approx(pose.right.contact_angle, rel=1e-13)
    assert found["left.contact.y_rail"][3] == pytest.approx(pose.left.contact.y_rail, rel=1e-13)
    assert (
        found["status"].tolist() == table["status"].tolist()
        and np.isnan(found["roll"][found["status"] > 1]).all()
    )
    text = (tmp_path / "contacts.csv").read_text()
    assert "54E1" in text.splitlines()[0] and "z down" in text and "right.contact_angle [deg]" in text
    with pytest.raises(ValueError, match="no table of contacts"):
        export.read_contact_table(__file__)


def test_units_of_tables(tmp_path):
    system = wrcontact.ContactSystem()
    export.write_contact_table(tmp_path / "a.csv", export.contact_table(system, 4e-3, 0.01))
    lines = [line for line in (tmp_path / "a.csv").read_text().splitlines() if not line.startswith("#")]
    row = dict(zip(lines[0].split(","), map(float, lines[1].split(","))))
    state = system.evaluate(4e-3, 0.01)
    assert row["lateral_shift [mm]"] == pytest.approx(4.0) and row["yaw [deg]"] == pytest.approx(0.5729578)
    assert row["right.rolling_radius [mm]"] == pytest.approx(1e3 * state.right.rolling_radius)
    assert row["left.contact_angle [deg]"] == pytest.approx(np.degrees(state.left.contact_angle))
    assert row["roll [deg]"] == pytest.approx(np.degrees(state.roll))
