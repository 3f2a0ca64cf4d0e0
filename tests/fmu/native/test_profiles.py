"""Native FMUs with measured profiles."""

import pytest
from fmpy import read_model_description

from tests.helpers.cases import OUTPUT_NAMES, poses
from tests.helpers.fmus import Host, assert_same, measured, needs_compiler, run_scenario, stepped
from wrcontact import ContactSystem
from wrcontact.fmu import native
from wrcontact.interface.variables import REFERENCE
from wrcontact.simulation.session import Session

pytestmark = needs_compiler


def test_own_profiles_are_packed_and_can_be_switched(packed, tmp_path):
    """All pairs of measured and standard profiles, by the String parameters: the values of a
    Python session of the file."""
    fmus, wheel, rail = packed
    rows = poses(6)
    for version in (2, 3):
        host = Host(fmus[version], tmp_path / f"host {version}")
        described = {v.name: v for v in read_model_description(str(fmus[version])).modelVariables}
        assert (described["wheel_profile"].start, described["rail_profile"].start) == (wheel.name, rail.name)
        pairs = ({"wheel_profile": "s1002", "rail_profile": "54e1"},     # the case has no effect
                 {"wheel_profile": wheel.name, "rail_profile": "UIC60"},
                 {"wheel_profile": "S1002", "rail_profile": rail.name})
        for pair in ({}, *pairs[3 - version:]):
            start = {**pair, "normal_model": "hertz"}
            seen = host.ask("trajectory", rows=rows, names=OUTPUT_NAMES, start=start)["seen"]
            made = Session(resources=str(wheel.parent), tell=lambda sentence: None)
            whole = {"wheel_profile": wheel.name, "rail_profile": rail.name, **start}
            made.set_strings([REFERENCE[name] for name in whole], list(whole.values()))
            made.start()
            for row, found in zip(rows, seen, strict=True):
                assert_same(found, stepped(made, row))
        host.end()


def test_measured_points_give_the_standards_contact(packed):
    """To what points 0.1 mm apart tell of the rail's steep side, from which the gauge is measured."""
    _, wheel, rail = packed
    own, standard = ContactSystem(wheel=str(wheel), rail=str(rail)), ContactSystem()
    for shift in (0.0, 3e-3, 7e-3):
        found, wanted = (system.evaluate(lateral_shift=shift, yaw=0.0, normal_force=78.5e3)
                         for system in (own, standard))
        assert found.roll == pytest.approx(wanted.roll, abs=3e-6)  # [rad]; 2e-7 with points twice as dense
        assert found.right.penetration == pytest.approx(wanted.right.penetration, rel=0.05)


def test_names_of_packed_profiles_are_told(packed, tmp_path):
    fmus, wheel, rail = packed
    answer = run_scenario("refusals", fmus[2], tmp_path / "unpacked", {"cases": {
        "unknown": {"wheel_profile": "S1003"}, "of the other kind": {"wheel_profile": rail.name}}})
    for name, part in (("unknown", wheel.name), ("of the other kind", "a profile of the other kind")):
        assert answer[name]["refused"] and part in answer[name]["log"][0][-1]
        assert answer[name]["after"]["status"] == 0


BAD_FILES = {"no numbers": "wheel\nof the tram\n", "two points": "0 0\n1 1\n",
             "nan": "0 0\n1 nan\n2 0\n" * 20, "empty": ""}


@pytest.mark.parametrize("case", BAD_FILES)
def test_bad_profile_file_is_refused_at_the_build(tmp_path, case):
    file = tmp_path / "Rad ä.txt"
    file.write_text(BAD_FILES[case])
    with pytest.raises(ValueError, match="Rad ä") as refused:
        native.build_native_fmus(tmp_path / "out", wheel=str(file))
    assert 20 < len(str(refused.value)) < 400 and not (tmp_path / "out").exists()


def test_two_profiles_of_one_name_are_refused(tmp_path):
    wheel, rail = measured("S1002", tmp_path / "a" / "profile.txt"), measured("UIC60",
                                                                              tmp_path / "b" / "profile.txt")
    with pytest.raises(ValueError,
                       match="wheel and rail profile have the same file name, profile.txt; rename one of "
                       "them"):
        native.build_native_fmus(tmp_path / "out", wheel=wheel, rail=rail)
    with pytest.raises(ValueError, match="missing.txt"):
        native.build_native_fmus(tmp_path / "out", wheel=str(tmp_path / "missing.txt"))
