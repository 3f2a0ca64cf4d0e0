"""The source's figures: what each claims, held against numbers from elsewhere; their files; the command."""

import csv
import math
import re
from functools import cache

import numpy as np
import pytest
from matplotlib.image import imread

import data
from data import brute_force
from tests.helpers.paths import DATA
from tests.helpers.source_study import STUDY
from wrcontact import ContactSystem
from wrcontact.conventions import SIDES
from wrcontact.plots import save
from wrcontact.study.figure import FAILS, HOLDS, PARTLY
from wrcontact.study.figures import chosen, compute, index, known, summary
from wrcontact.study.pictures import DRAWN, source_figure
from wrcontact.study.search import lever_share
from wrcontact.study.sections import Section

NUMBERS = ("4.4", "4.5", "4.6", "5.6", "5.7", "5.8", "5.9", *(f"7.{k}" for k in range(1, 18)))


@cache
def figure(number):
    return compute(number, STUDY)


def reference_jumps(yaw):
    """Lateral shifts at which the right contact jumps by data/find_jumps.py [mm]: root, flange."""
    page = (DATA / "README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([\d.]+) \| ([\d.]+) \| -", page, re.MULTILINE)
    shifts = [float(shift) for at_yaw, shift in rows if float(at_yaw) == yaw]
    return shifts[0], shifts[-1]


def at(number, curve, shift):
    """A curve of a figure at a lateral shift [mm]."""
    value = list(figure(number).columns)[2]
    shifts, values = figure(number).curve(curve, "lateral shift [mm]", value)
    return float(values[np.argmin(np.abs(shifts - shift))])


# --- chapters 4 and 5 -----------------------------------------------------------------------------


def test_roll_and_place_are_those_of_the_brute_force():
    """data/rigid_positions.csv is an independent search over both
    parameters of the wheel's surface."""
    rows = [row for row in data.rows_of(DATA / "rigid_positions.csv") if row["yaw_deg"] == 0]
    assert len(rows) > 5
    for row in rows:
        shift = row["lateral_shift_mm"]
        # [deg]
        assert at("4.4", "rigid, exact", shift) == pytest.approx(math.degrees(row["roll_rad"]), abs=1e-7)
        # [mm]
        assert at("4.5", "rigid, exact", shift) == pytest.approx(row["R_y_wheel_mm"], abs=1e-4)


def test_4_4_the_roll_bends_and_does_not_jump():
    numbers = figure("4.4").numbers
    root, flange = reference_jumps(0)
    assert numbers["bend to the flange root at [mm]"] == pytest.approx(root, abs=1e-4)
    assert numbers["bend to the flange at [mm]"] == pytest.approx(flange, abs=1e-4)
    assert numbers["change of roll at the jump to the flange [deg]"] < 5e-6
    assert numbers["slope, flange root / tread"] == pytest.approx(2.44, abs=0.05)
    assert numbers["slope, flange / flange root"] == pytest.approx(30, abs=2)
    assert numbers["2-D search less exact, largest [deg]"] < 2e-3


def test_4_5_three_jumps():
    numbers = figure("4.5").numbers
    assert [numbers[f"jump {k} at [mm]"] for k in (1, 2, 3)] == pytest.approx(
        [0.2089, 4.8479, 6.2518], abs=2e-4
    )
    assert [numbers[f"jump {k} by [mm]"] for k in (1, 2, 3)] == pytest.approx([-10.2, -10.5, -4.2], abs=0.2)
    assert figure("4.5").verdict == HOLDS


def test_4_6_the_source_own_search_is_on_the_rigid_contact():
    numbers = figure("4.6").numbers
    assert numbers["2-D search dy 0.1 mm less exact, flange, largest [mm]"] < 0.06  # half a node
    assert numbers["2-D search dy 1 mm less exact, flange, largest [mm]"] > 1.0
    assert figure("4.6").verdict == FAILS


def test_elastic_contact_is_smoother_and_tends_to_the_rigid_one():
    numbers = figure("4.5").numbers
    assert (
        numbers["largest step before the flange, elastic [mm]"] < 0.05 * numbers["largest step, rigid [mm]"]
    )
    assert figure("5.6").numbers["yaw 0 deg: elastic slope, 0.4 mm behind / before"] < 1.5
    assert figure("5.6").numbers["yaw 0 deg: share of shifts with less elastic roll"] > 0.8
    numbers = figure("4.4").numbers
    assert numbers["elastic roll of 0.1 deg comes later by [mm]"] == pytest.approx(0.071, abs=0.01)
    assert numbers["roughness of the elastic roll between flange root and flange [deg]"] < 3e-3
    assert figure("4.6").numbers["elastic at 1e-4 N less rigid, flange, largest [mm]"] < 1e-3
    assert figure("4.6").numbers["elastic at 1e-4 N less rigid, elsewhere, largest [mm]"] < 1e-3


@pytest.mark.parametrize("shift", [2.0, 3.0, 6.0])
def test_elastic_roll_is_what_the_complete_theory_makes_of_the_levers(shift):
    """Each wheel sinks by its penetration over the cosine of its contact angle; the
    lever is that of the study."""
    sides = [
        getattr(STUDY.system(normal_model="halfspace").evaluate(lateral_shift=shift / 1e3), side)
        for side in SIDES
    ]
    left, right = (side.penetration / math.cos(side.contact_angle) for side in sides)
    arms = sum(abs(side.contact.y_track - shift / 1e3) for side in sides)
    turn = (right - left) / (lever_share(STUDY.system(), shift / 1e3) * arms)
    found = math.radians(at("4.4", "elastic, 78.5 kN", shift) - at("4.4", "rigid, exact", shift))
    assert found == pytest.approx(turn, rel=0.15)


def test_5_6_bends_come_later_with_yaw():
    numbers = figure("5.6").numbers
    for yaw in (0, 1):
        assert numbers[f"yaw {yaw} deg: bend at [mm]"] == pytest.approx(reference_jumps(yaw)[0], abs=1e-4)
        assert numbers[f"yaw {yaw} deg: slope behind / before"] == pytest.approx(2.45, abs=0.05)
        assert numbers[f"yaw {yaw} deg: step of the roll [deg]"] < 1e-6
        for shift in (3.0, 5.0, 6.5):  # the source's own search beside the exact one
            assert at("5.6", f"source's 3-D search, dx 0.1 mm, yaw {yaw} deg", shift) == pytest.approx(
                at("5.6", f"rigid, exact, yaw {yaw} deg", shift), abs=1e-3
            )  # [deg]


def test_5_7_the_contact_at_5_mm():
    numbers = figure("5.7").numbers
    assert numbers["y_wheel [mm]"] == pytest.approx(-28.614, abs=1e-3)
    assert numbers["patches under load"] == 2 and 20 < numbers["gap at the other place [um]"] < 40


def test_5_8_jumps_by_yaw():
    numbers = figure("5.8").numbers
    for yaw in (0, 1, 2):
        root, flange = reference_jumps(yaw)
        assert numbers[f"yaw {yaw} deg: jump to the flange root [mm]"] == pytest.approx(root, abs=1e-4)
        assert numbers[f"yaw {yaw} deg: jump to the flange [mm]"] == pytest.approx(flange, abs=1e-4)
    assert math.isnan(numbers["yaw 3 deg: jump to the flange root [mm]"])
    assert numbers["yaw 3 deg: jump to the flange [mm]"] == pytest.approx(5.417, abs=1e-3)


def test_5_8_roll_on_the_tread_is_smaller_with_yaw_because_the_wheelset_is_narrower():
    for shift in (1.0, 3.0, 4.5):
        rolls = [abs(at("5.8", f"exact, yaw {yaw} deg", shift)) for yaw in (0, 1, 2, 3)]
        assert rolls == sorted(rolls, reverse=True)
    numbers = figure("5.8").numbers
    assert numbers["3 mm, 1 deg: rise of the contact towards the axle [um]"] < 1
    share = next(value for name, value in numbers.items() if "narrower" in name)
    assert share == pytest.approx(109, abs=3)  # [%]


def test_5_9_longitudinal_shift():
    numbers = figure("5.9").numbers
    assert numbers["yaw 1 deg: largest [mm]"] == pytest.approx(22.8, abs=0.2)
    for row in data.rows_of(DATA / "rigid_positions.csv"):
        if row["yaw_deg"] in (1, 2, 3) and row["lateral_shift_mm"] >= 0:
            assert at(
                "5.9", f"exact, yaw {row['yaw_deg']:.0f} deg", row["lateral_shift_mm"]
            ) == pytest.approx(row["R_x_wheel_mm"], abs=2e-3)  # [mm]
    assert numbers["yaw 1 deg at 6.5 mm [mm]"] == pytest.approx(18.34, abs=0.01)
    assert numbers["yaw 3 deg at 1 mm [mm]"] < numbers["yaw 2 deg at 1 mm [mm]"]


@pytest.mark.parametrize(
    "shift, yaw",
    [(1.0, 3), pytest.param(6.5, 1, marks=pytest.mark.full), pytest.param(8.0, 2, marks=pytest.mark.full)],
)
def test_5_8_and_5_9_against_the_brute_force(shift, yaw):
    """The search over both parameters of the wheel's surface, which shares no code with the package."""
    found = brute_force.rigid_contact(brute_force.track(), shift / 1e3, math.radians(yaw))
    # [deg]
    assert at("5.8", f"exact, yaw {yaw} deg", shift) == pytest.approx(math.degrees(found.roll), abs=1e-6)
    # [mm]
    assert at("5.9", f"exact, yaw {yaw} deg", shift) == pytest.approx(found.right.x_wheel * 1e3, abs=2e-3)


# --- chapter 7 ------------------------------------------------------------------------------------


def test_7_2_and_7_4_separations():
    tread, root = figure("7.2").numbers, figure("7.4").numbers
    assert tread["separations differ inside the patch by [mm]"] < 5e-4
    assert abs(tread["vertical: penetration [%]"]) < 0.5
    assert (
        1e-4
        < root["separations differ within 0.5 mm by [mm]"]
        < root["separations differ within 1 mm by [mm]"]
        < 2e-3
    )
    assert root["1 / cos(contact angle) [%]"] == pytest.approx(
        100 / math.cos(math.radians(24.2695)) - 100, abs=0.01
    )
    # equidistant is narrower in x
    assert root["vertical: length [%]"] == pytest.approx(5.5, abs=0.3)
    assert root["vertical: width in y [%]"] == pytest.approx(-7, abs=1.5)  # and wider in y
    assert root["vertical: penetration [%]"] == pytest.approx(11.4, abs=0.5)
    assert abs(root["vertical, turned: penetration [%]"]) < 2
    for numbers in (tread, root):  # the equidistant patch is the right one
        assert numbers["wrcontact, equidistant: penetration [um]"] == pytest.approx(
            numbers["equidistant: penetration [um]"], rel=0.03
        )


@pytest.mark.parametrize("number, factor", [("7.5", 1.0025), ("7.7", 1.0976), ("7.9", 2.58)])
def test_effective_radius(number, factor):
    numbers = figure(number).numbers
    assert numbers["effective / basic radius"] == pytest.approx(factor, rel=2e-3)
    assert numbers["effective radius [m]"] == pytest.approx(numbers["wrcontact's radius [m]"], rel=1e-6)


@pytest.mark.parametrize(
    "number, length, width", [("7.6", 0.1, 0.0), ("7.8", 3.9, -2.4), ("7.10", 46.3, -17.4)]
)
def test_effective_radius_stretches_the_patch(number, length, width):
    numbers = figure(number).numbers
    assert numbers["effective: length [%]"] == pytest.approx(length, abs=0.3)
    assert numbers["effective: width [%]"] == pytest.approx(width, abs=0.3)
    assert abs(numbers["effective: error of the largest pressure [%]"]) < 2  # against the complete theory
    assert abs(numbers["effective: length [mm]"] / numbers["complete theory: length [mm]"] - 1) < 0.035


def test_7_10_the_basic_radius_is_wrong_by_a_fifth():
    assert figure("7.10").numbers["basic: error of the largest pressure [%]"] == pytest.approx(20.5, abs=1)


def test_7_11_roughness_is_rounding():
    numbers = figure("7.11").numbers
    scatter = {
        (ds, step): numbers[f"scatter of B, ds {ds} mm, coordinates to {step} mm [1/m]"]
        for ds in ("0.2", "1", "2")
        for step in ("0", "0.0001", "0.001")
    }
    assert scatter["0.2", "0"] < 1e-3 and 5 < scatter["0.2", "0.001"] < 20
    # two second differences of coordinates rounded to q, each with a variance of 6 q^2 / 12 over ds^4
    assert scatter["1", "0.0001"] == pytest.approx(0.674 * 0.5 * math.sqrt(2 * 6 / 12) * 1e-7 / 1e-6, rel=0.4)
    assert scatter["0.2", "0.0001"] / scatter["1", "0.0001"] == pytest.approx(25, rel=0.4)
    assert scatter["2", "0.001"] < 0.3


@pytest.mark.parametrize("number, rough, smooth", [("7.12", 74, 81), ("7.13", 33, 37), ("7.14", 61, 66)])
def test_rough_curvature_always_leaves_fewer_nodes(number, rough, smooth):
    numbers = figure(number).numbers
    assert (numbers["rough: loaded nodes"], numbers["smooth: loaded nodes"]) == pytest.approx(
        (rough, smooth), abs=1
    )
    assert numbers["rough: B <= 0 over [mm]"] > numbers["smooth: B <= 0 over [mm]"] > 4
    true = numbers["complete theory: penetration [um]"]
    assert numbers["rough: penetration [um]"] > 1.15 * true
    assert numbers["smooth: penetration [um]"] > 1.1 * true
    assert numbers["wrcontact: penetration [um]"] == pytest.approx(true, rel=0.01)
    # B <= 0 floored instead of dropped, and other curvatures for extent and length
    for kind in ("rough", "smooth"):
        assert numbers[f"wrcontact, {kind}: penetration [um]"] == pytest.approx(true, rel=0.1)


def test_7_14_exact_profiles_do_not_break_the_patch_and_rounded_ones_do():
    numbers = figure("7.14").numbers
    assert numbers["rough: first contact point in the patch"] == 1
    assert (
        numbers["first point out, coordinates to 0 mm"]
        == 0
        == numbers["first point out, coordinates to 0.0001 mm"]
    )
    assert 0.2 < numbers["first point out, coordinates to 0.001 mm"] < 0.6
    assert numbers["first point out, coordinates to 0.001 mm, corrected"] == 0
    assert numbers["first point out, coordinates to 0.01 mm, corrected"] == pytest.approx(1 / 7, abs=0.1)
    assert numbers["rough, coordinates to 1 um: pieces"] > 10 and numbers["rough: pieces"] == 2


def test_yaw_has_patterns_where_the_contact_does_not_jump():
    tread, root, flange = (figure(number).numbers for number in ("7.15", "7.16", "7.17"))
    area = [tread[f"yaw {yaw} deg: area [mm2]"] for yaw in (0, 1, 2)]
    assert area == sorted(area)
    assert tread["no yaw, wheelset narrower by cos(2 deg): area [mm2]"] == pytest.approx(area[2], rel=0.01)
    assert root["yaw 2 deg: x_wheel [mm]"] == pytest.approx(42.762, abs=1e-2)  # on the flange
    assert root["yaw 2 deg: largest pressure [MPa]"] > 1.8 * root["yaw 0 deg: largest pressure [MPa]"]
    length, width = (
        [flange[f"yaw {yaw} deg: {what} [mm]"] for yaw in (0, 1, 2)] for what in ("length", "width")
    )
    assert length == sorted(length, reverse=True) and width == sorted(width)
    assert length == pytest.approx([28.6, 25.5, 21.6], abs=0.2)
    for numbers in (tread, root, flange):
        for yaw in (0, 1, 2):
            assert numbers[f"yaw {yaw} deg: area [mm2]"] == pytest.approx(
                numbers[f"yaw {yaw} deg: complete theory, area [mm2]"], rel=0.05
            )


# --- files and command ----------------------------------------------------------------------------


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.turns(3)
def test_table_and_picture(number, tmp_path):
    found = figure(number)
    assert found.number == number and found.verdict in (HOLDS, PARTLY, FAILS)
    found.write(tmp_path / "table.csv")
    with open(tmp_path / "table.csv", newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    assert names == list(found.columns) and len(rows) > 50
    for name, column in zip(names, zip(*rows)):
        if name != "curve":
            assert re.search(r"\[(mm|deg|MPa|1/m)\]$", name)
            assert any(map(str.strip, column)) and [float(cell or "nan") for cell in column]
    assert (tmp_path / "table.csv").stat().st_size < 120_000
    picture = imread(save(source_figure(found), tmp_path / "picture.png"))[..., :3]
    assert min(picture.shape[:2]) > 400 and np.std(picture) > 0.05


def test_every_panel_of_every_picture_says_what_it_shows():
    for number in NUMBERS:
        picture = source_figure(figure(number))
        assert picture.get_suptitle().startswith(f"{number} ")
        panels = [panel for part in (picture, *picture.subfigs) for panel in part.get_axes()]
        assert panels and all("[" in panel.get_xlabel() for panel in panels), number
        assert any("[" in panel.get_ylabel() for panel in panels), number


def test_words():
    for number in NUMBERS:
        found = figure(number)
        assert found.claim.endswith(".") and found.finding.endswith(".") and len(found.key) <= 40, number
        assert re.search(r"\d", found.key) and re.search(r"\d", found.finding), number
        assert "nan" not in found.finding


def test_index_and_summary_have_a_line_for_each():
    figures = [figure(number) for number in NUMBERS]
    page = index(figures)
    assert all(f"(fig_{number.replace('.', '_')}.png)" in page for number in NUMBERS)
    assert summary(figures).row_count == len(NUMBERS)


def test_command_writes_only_what_is_asked_for(run, tmp_path):
    code, out, err = run("figures", "--output", tmp_path / "here", "--only", "7.3", "7.10")
    assert code == 0 and err == ""
    assert sorted(path.name for path in (tmp_path / "here").iterdir()) == [
        "fig_7_10.csv",
        "fig_7_10.png",
        "fig_7_3.csv",
        "fig_7_3.png",
        "figures.md",
    ]
    lines = [line.split() for line in out.splitlines() if line[:1].isdigit()]
    assert [words[0] for words in lines[:2]] == ["7.3", "7.10"] and "2 figures" in out


def test_command_refuses_unknown_figures_in_one_sentence(run, tmp_path):
    code, out, err = run("figures", "--output", tmp_path / "none", "--only", "7.99")
    assert code == 2 and out == "" and err.count("\n") == 1
    assert "figure '7.99' is not known; known are 4.4, 4.5, 4.6, 5.6" in err and err.rstrip().endswith("7.17")
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize(
    "words, numbers",
    [
        ((), NUMBERS),
        (("7.4,7.2",), ("7.2", "7.4")),
        (("fig_7_2", "4.4"), ("4.4", "7.2")),
        (("7.2", "7.2"), ("7.2",)),
    ],
)
def test_chosen(words, numbers):
    assert chosen(words) == numbers and known() == NUMBERS and tuple(DRAWN) == NUMBERS


def test_section_is_prepared_for_the_pose():
    state = ContactSystem().evaluate(lateral_shift=2e-3)
    section = Section(ContactSystem(), 2e-3)
    assert section.angle == state.right.contact_angle and section.wheel.origin == state.right.contact.y_wheel
    slopes = [curve.direction(curve.origin) for curve in (section.wheel, section.rail)]
    assert slopes[0] == pytest.approx(slopes[1], abs=1e-9)
    assert slopes[0] == pytest.approx(-section.angle, abs=1e-9)
