"""The pictures: not how they look, but that what they draw are the numbers they speak of."""

import re

import matplotlib
import numpy as np
import pytest
from matplotlib.image import imread

from tests.helpers.paths import ROOT
from wrcontact import ContactSystem
from wrcontact.cli.demo import stored_inputs, stored_run
from wrcontact.plots import (
    contact_figure,
    demo_figure,
    find_jumps,
    outline_figure,
    pose_figure,
    save,
    sweep,
    sweep_figure,
)
from wrcontact.plots.demo import SHOWN_SHIFTS
from wrcontact.plots.geometry import WHEEL_ZONES, rail_outline, wheel_outline, wheel_zone
from wrcontact.plots.patch import fine_outline
from wrcontact.plots.style import number
from wrcontact.plots.sweep import told_jumps
from wrcontact.profiles import standard_profile
from wrcontact.results.convert import columns_of

SYSTEM = ContactSystem()
MM = 1e-3
#: Shifts [m] at which the right contact jumps, from the independent search of
#: data/find_jumps.py, by yaw [deg].
JUMPS = {
    0.0: (4.847933 * MM, 6.251818 * MM),
    0.5: (4.867662 * MM, 6.228034 * MM),
    1.0: (4.926844 * MM, 6.157520 * MM),
}
POSES = {
    "tread": dict(lateral_shift=1 * MM),
    "flange_root": dict(lateral_shift=5.5 * MM, yaw=0.02),
    "flange": dict(lateral_shift=7 * MM, yaw=-0.01),
    "left_flange": dict(lateral_shift=-6.8 * MM, yaw=0.015),
}


def panel(figure, label):
    """The panel of this label."""
    return next(axes for axes in figure.axes if axes.get_label() == label)


def texts(axes):
    return [text.get_text() for text in axes.texts]


@pytest.fixture(scope="module")
def swept():
    return sweep(SYSTEM)


# --- where contacts jump ---------------------------------------------------------------------------


@pytest.mark.parametrize("yaw", JUMPS)
def test_jumps_are_where_the_brute_force_search_has_them(yaw):
    told = told_jumps(sweep(SYSTEM, np.linspace(4, 8, 81) * MM, np.radians(yaw)), "right")
    # [m] the printed S1002 has steps
    assert [shift for shift, *_ in told] == pytest.approx(JUMPS[yaw], abs=0.3e-6)
    assert [wheel_zone(after) for *_, after in told] == ["flange root", "flange"]


def test_the_left_contact_jumps_in_the_mirror(swept):
    left, right = (told_jumps(swept, side) for side in ("left", "right"))
    assert len(right) == 3  # on the tread, to the flange root, to the flange
    # [m]
    assert [-shift for shift, *_ in reversed(left)] == pytest.approx([shift for shift, *_ in right], abs=2e-9)


def test_no_jump_where_the_contact_moves_steadily():
    assert find_jumps(SYSTEM, np.linspace(1, 4, 31) * MM) == []


def test_zones_are_bounded_by_joints_of_the_standard():
    joints = [joint.y for joint in standard_profile("S1002").joints]
    for limit in (WHEEL_ZONES["tread"][0], WHEEL_ZONES["flange"][1]):
        assert min(abs(limit - joint) for joint in joints) < 1e-9  # [m]
    assert [wheel_zone(y * MM) for y in (3.3, -17.9, -28.6, -38.43, -42)] == [
        "tread",
        "tread",
        "flange root",
        "flange",
        "flange",
    ]


# --- contacts and roll over the lateral shift --------------------------------------------------------


@pytest.mark.parametrize("side, sign", [("right", 1), ("left", -1)])
def test_curve_breaks_and_is_labelled_where_the_contact_jumps(swept, side, sign):
    axes = panel(sweep_figure(swept), f"{side} position")
    curve = next(line for line in axes.lines if line.get_gid() == "position")
    shift, place = curve.get_xdata(), curve.get_ydata()
    breaks = sorted(abs(shift[np.isnan(place)]))
    for jump in JUMPS[0.0]:
        assert min(abs(breaks - np.float64(jump / MM))) < 3e-4  # [mm]
    labels = [
        float(re.search(r"[\d.]+", text.replace("\N{MINUS SIGN}", "-"))[0])
        for text in texts(axes)
        if "jump" in text
    ]
    assert sorted(labels) == [0.21, 4.85, 6.25]
    dotted = [line.get_xdata()[0] for line in axes.lines if line.get_gid() == "jump"]
    assert sorted(sign * np.array(dotted)) == pytest.approx([0.2089, 4.8479, 6.2518], abs=5e-4)  # [mm]
    assert {"tread", "flange root", "flange"} <= set(texts(axes))


def test_unbroken_stretches_have_no_leap(swept):
    axes = panel(sweep_figure(swept), "right position")
    curve = next(line for line in axes.lines if line.get_gid() == "position")
    steps = abs(np.diff(curve.get_ydata()))
    assert np.nanmax(steps) < 2.0  # [mm] where the leaps have 3 to 11


def test_roll_is_drawn_in_degrees(swept):
    line = panel(sweep_figure(swept), "roll").lines[-1]
    at = np.argmin(abs(line.get_xdata() - 5.0))
    assert np.radians(line.get_ydata()[at]) == pytest.approx(-3.696026826666e-4, abs=1e-9)  # [rad]


# --- wheel, rail and contact plane -------------------------------------------------------------------


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("pose", POSES.values(), ids=POSES)
def test_drawn_wheel_touches_drawn_rail_at_the_contact_point(pose, side):
    state = SYSTEM.evaluate(**pose)
    contact = getattr(state, side).contact
    wheel, rail = wheel_outline(SYSTEM, state, side), rail_outline(SYSTEM, side)
    for y, z in (wheel, rail):
        near = abs(y - contact.y_track) < 1 * MM
        order = np.argsort(y[near])
        height = np.interp(contact.y_track, y[near][order], z[near][order])
        assert height == pytest.approx(contact.z_track, abs=2e-6)  # [m] straight lines between drawn points


@pytest.mark.parametrize("side, sign", [("right", 1), ("left", -1)])
def test_rail_leans_inwards_and_keeps_the_gauge(side, sign):
    y, z = rail_outline(SYSTEM, side)
    inner = slice(None, np.argmin(z))
    face = np.interp(14 * MM, z[inner][::-1], sign * y[inner][::-1])
    assert face == pytest.approx(1.435 / 2, abs=2e-6)  # [m]
    assert sign * y[np.argmin(z)] == pytest.approx(0.7605385, abs=0.1 * MM)


@pytest.mark.parametrize("side", ["left", "right"])
def test_contact_plane_is_tangent(side):
    state = SYSTEM.evaluate(lateral_shift=5.5 * MM)
    axes = panel(contact_figure(SYSTEM, state), f"{side} contact")
    *_, plane, point = axes.lines
    contact = getattr(state, side)
    assert point.get_xydata()[0] == pytest.approx(
        [contact.contact.y_track / MM, -contact.contact.z_track / MM]
    )
    (y0, y1), (z0, z1) = plane.get_data()
    outwards = 1 if side == "right" else -1
    assert np.arctan2(z1 - z0, outwards * (y1 - y0)) % np.pi == pytest.approx(contact.contact_angle)


# --- patches -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("shift", [0.0, 3 * MM, 6 * MM, 7 * MM])
def test_drawn_outline_holds_area_and_force(shift):
    side = SYSTEM.evaluate(lateral_shift=shift).right
    station, half_length, pressure = fine_outline(side.outline)
    area = (
        np.trapezoid(2 * half_length, station)
        if hasattr(np, "trapezoid")
        else np.trapz(2 * half_length, station)
    )
    assert area == pytest.approx(side.area, rel=0.01)
    line_load = np.pi / 2 * half_length * pressure  # elliptic in the rolling direction
    force = np.sum(0.5 * (line_load[1:] + line_load[:-1]) * np.diff(station))
    assert force == pytest.approx(78.5e3, rel=0.02)  # [N]


def test_drawn_outline_passes_through_the_stored_stations():
    outline = SYSTEM.evaluate(lateral_shift=5 * MM).right.outline
    station, half_length, pressure = (values[::12] for values in fine_outline(outline))
    np.testing.assert_allclose(station, outline.station, atol=1e-12)
    np.testing.assert_allclose(half_length, outline.half_length, atol=1e-9)
    np.testing.assert_allclose(pressure, outline.pressure, atol=1.0)


def test_patch_is_filled_by_pressure_in_megapascal():
    state = SYSTEM.evaluate(lateral_shift=3 * MM)
    axes = panel(outline_figure(state), "right patch")
    mesh = axes.collections[0]
    assert np.max(mesh.get_array()) == pytest.approx(state.right.max_pressure / 1e6, rel=0.01)
    assert axes.get_aspect() == 1.0
    line = panel(outline_figure(state), "right pressure").lines[0]
    assert np.max(line.get_ydata()) == pytest.approx(state.right.max_pressure / 1e6, rel=0.01)


@pytest.mark.parametrize("transfer", [1.0, -1.0])
def test_wheel_without_load_is_drawn_as_unloaded(transfer):
    figure = outline_figure(SYSTEM.evaluate(load_transfer=transfer))
    empty, loaded = ("left", "right") if transfer > 0 else ("right", "left")
    assert texts(panel(figure, f"{empty} patch")) == ["unloaded"]
    assert panel(figure, f"{loaded} patch").collections


@pytest.mark.parametrize(
    "mode, given, told",
    [
        ("elastic", {}, "78.5 kN per wheel"),
        pytest.param(
            "compliant", {"vertical_shift_input": 0.25 * MM}, "0.250 mm down", marks=pytest.mark.full
        ),
    ],
)
def test_a_pressed_wheelset_is_drawn_too(tmp_path, mode, given, told):
    system = ContactSystem(contact_mode=mode)
    state = system.evaluate(**given)
    figure = pose_figure(system, state)
    assert (
        told in figure.get_suptitle()
        if hasattr(figure, "get_suptitle")
        else told in figure._suptitle.get_text()
    )
    mesh = panel(figure, "right patch").collections[0]
    assert np.max(mesh.get_array()) == pytest.approx(np.max(state.right.outline.pressure) / 1e6, rel=0.01)
    assert save(figure, tmp_path / "pressed.png").stat().st_size > 20_000


def test_no_wheel_with_load_is_drawn_too(tmp_path):
    state = SYSTEM.evaluate(normal_force=0.0)
    assert save(pose_figure(SYSTEM, state), tmp_path / "empty.png").stat().st_size > 20_000


# --- the picture of the demo -------------------------------------------------------------------------


@pytest.fixture(scope="module")
def run():
    """The stored run, and the kernel's answers to it."""
    stored = stored_run()
    inputs = {name: stored[name] for name in stored_inputs(stored)}
    return columns_of(SYSTEM.evaluate_many(**inputs)), stored


@pytest.fixture(scope="module")
def demo_picture(run):
    return demo_figure(SYSTEM, *run)


def test_demo_draws_answers_and_stored_values(demo_picture, run):
    answers, stored = run
    for name, unit in (("contact.y_wheel", MM), ("max_pressure", 1e6), ("area", 1e-6), ("normal_force", 1e3)):
        left_line, left_circles, right_line, right_circles = panel(demo_picture, f"run {name}").lines
        np.testing.assert_array_equal(left_line.get_ydata(), answers[f"left.{name}"] / unit)
        np.testing.assert_array_equal(right_line.get_ydata(), answers[f"right.{name}"] / unit)
        np.testing.assert_array_equal(right_circles.get_ydata(), stored[f"right.{name}"] / unit)
        assert len(left_circles.get_ydata()) == len(stored["time"])  # none is left out
    np.testing.assert_allclose(
        panel(demo_picture, "run yaw").lines[0].get_ydata(), np.degrees(stored["yaw"]), rtol=1e-12
    )


def test_demo_patches_are_drawn_to_one_scale(demo_picture):
    panels = [panel(demo_picture, f"patch at {shift / MM:g} mm") for shift in SHOWN_SHIFTS]
    assert (
        len({(round(np.ptp(axes.get_xlim()), 9), round(np.ptp(axes.get_ylim()), 9)) for axes in panels}) == 1
    )
    assert len({axes.collections[0].norm.vmax for axes in panels}) == 1
    titles = [axes.get_title(loc="left") for axes in panels]
    assert [title.split(",")[0] for title in titles] == [
        "tread",
        "tread",
        "flange root",
        "flange root",
        "flange",
    ]


# --- looks -------------------------------------------------------------------------------------------


def test_saved_picture_is_not_empty(tmp_path):
    state = SYSTEM.evaluate(lateral_shift=5 * MM)
    picture = imread(save(pose_figure(SYSTEM, state), tmp_path / "pose.png"))[..., :3]
    assert min(picture.shape[:2]) > 1000 and np.std(picture) > 0.1


def test_settings_of_the_caller_are_left_alone(tmp_path):
    with matplotlib.rc_context({"font.size": 17, "axes.spines.top": True}):
        figure = outline_figure(SYSTEM.evaluate())
        assert matplotlib.rcParams["font.size"] == 17
        assert not figure.axes[0].spines["top"].get_visible()


@pytest.mark.parametrize(
    "value, digits, text", [(-28.61, 1, "\N{MINUS SIGN}28.6"), (-0.001, 1, "0.0"), (5.0, 2, "5.00")]
)
def test_number(value, digits, text):
    assert number(value, digits) == text


def test_jumps_of_the_documentation(swept):
    page = (ROOT / "docs" / "reference" / "conventions.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([\d.]+) \| (\S+) → (\S+) \|", page, re.MULTILINE)
    rows = [[float(cell.replace("\N{MINUS SIGN}", "-")) for cell in row] for row in rows]
    told = np.array(told_jumps(swept, "right")) / MM
    assert np.shape(rows) == told.shape
    np.testing.assert_allclose(np.array(rows)[:, 0], told[:, 0], atol=6e-4)  # [mm]
    # [mm] steep before the last jump
    np.testing.assert_allclose(np.array(rows)[:, 1:], told[:, 1:], atol=0.5)


def test_creep_forces_are_drawn():
    """The shear stress of each station, and their size in the title; without them neither."""
    pose = dict(lateral_shift=3 * MM, yaw=4e-3, speed=20.0)
    for model in ("none", "strips"):
        state = ContactSystem(tangential_model=model).evaluate(**pose)
        figure = outline_figure(state, side="right")
        lower, title = panel(figure, "right pressure"), panel(figure, "right patch").get_title(loc="left")
        assert len(lower.lines) == (1 if model == "none" else 2)
        assert ("creep force" in title) == (model != "none")
    np.testing.assert_array_equal(lower.lines[1].get_ydata(), state.right.outline.shear / 1e6)
    (patch,) = state.right.patches
    assert f"creep force {np.hypot(patch.tangential.x, patch.tangential.y) / 1e3:.1f} kN" in title
