"""Native FMUs with measured profiles."""

import pytest
from fmpy import read_model_description

from tests.helpers.cases import OUTPUT_NAMES, poses
from tests.helpers.fmus import Host, assert_same, measured, needs_compiler, run_scenario, stepped
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
        pairs = (
            {"wheel_profile": "s1002", "rail_profile": "54e1"},  # the case has no effect
            {"wheel_profile": wheel.name, "rail_profile": "UIC60"},
            {"wheel_profile": "S1002", "rail_profile": rail.name},
        )
        for pair in ({}, *pairs[3 - version :]):
            start = {**pair, "normal_model": "hertz"}
            seen = host.ask("trajectory", rows=rows, names=OUTPUT_NAMES, start=start)["seen"]
            made = Session(resources=str(wheel.parent), log=lambda sentence: None)
            whole = {"wheel_profile": wheel.name, "rail_profile": rail.name, **start}
            made.set_strings([REFERENCE[name] for name in whole], list(whole.values()))
            made.start()
            for row, found in zip(rows, seen, strict=True):
                assert_same(found, stepped(made, row))
        host.end()


@pytest.mark.full
def test_profiles_of_the_catalogue_are_packed_and_can_be_switched(tmp_path):
    """A designation of EN 13715 is packed where it is chosen, all others always."""
    wheel = "s1002/h30/e31.5/15"
    fmu, _ = native.build_native_fmus(tmp_path, wheel=wheel, rail="r65", cache=None)
    host = Host(fmu, tmp_path / "host")
    for pair in ({}, {"wheel_profile": "LMA", "rail_profile": "chn60"}):
        start = {**pair, "normal_model": "hertz"}
        seen = host.ask("trajectory", rows=poses(3), names=OUTPUT_NAMES, start=start)["seen"]
        made = Session(resources=None, log=lambda sentence: None)
        whole = {"wheel_profile": wheel, "rail_profile": "R65", **start}
        made.set_strings([REFERENCE[name] for name in whole], list(whole.values()))
        made.start()
        for row, found in zip(poses(3), seen, strict=True):
            assert_same(found, stepped(made, row))
    host.end()


def test_names_of_packed_profiles_are_reported(packed, tmp_path):
    fmus, wheel, rail = packed
    answer = run_scenario(
        "refusals",
        fmus[2],
        tmp_path / "unpacked",
        {"cases": {"unknown": {"wheel_profile": "S1003"}, "of the other kind": {"wheel_profile": rail.name}}},
    )
    for name, part in (("unknown", wheel.name), ("of the other kind", "a profile of the other kind")):
        assert answer[name]["refused"] and part in answer[name]["log"][0][-1]
        assert answer[name]["after"]["status"] == 0


def test_two_profiles_of_one_name_are_refused(tmp_path):
    wheel, rail = (
        measured("S1002", tmp_path / "a" / "profile.txt"),
        measured("UIC60", tmp_path / "b" / "profile.txt"),
    )
    with pytest.raises(
        ValueError, match="wheel and rail profile have the same file name, profile.txt; rename one of them"
    ):
        native.build_native_fmus(tmp_path / "out", wheel=wheel, rail=rail)
    with pytest.raises(ValueError, match="missing.txt"):
        native.build_native_fmus(tmp_path / "out", wheel=str(tmp_path / "missing.txt"))
