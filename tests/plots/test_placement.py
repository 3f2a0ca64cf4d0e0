"""Pictures in the caller's axes, long titles, curves inside their panels, and yawed patches at their own
place along the track."""

import inspect
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure

import wrcontact
from wrcontact import ContactSystem, plots
from wrcontact.plots.geometry import stations_along
from wrcontact.plots.patch import patch_places

SYSTEM = ContactSystem()
YAWED = {"lateral_shift": 4.9e-3, "yaw": 0.02}  # [m, rad] two patches on the right wheel
MM = 1e-3


def panel(figure, label):
    return next(axes for axes in figure.axes if axes.get_label() == label)


@pytest.fixture(scope="module")
def report():
    """The check of a pair with long names."""
    wheel = replace(SYSTEM.wheel, name="S1002_after_240000_km_left_wheel_bogie_2_axle_3_car_17_2024.whl")
    rail = replace(SYSTEM.rail, name="UIC60 curve R 1200 km 123.456 high rail after grinding " + 60 * "x")
    return wrcontact.check(ContactSystem(wheel=wheel, rail=rail))


@pytest.fixture(scope="module")
def check_picture(report):
    return plots.check_figure(report)


# --- check.png --------------------------------------------------------------------------------------------


@pytest.mark.full
def test_a_long_title_stays_in_its_figure(check_picture):
    check_picture.draw_without_rendering()
    box = check_picture._suptitle.get_window_extent()
    assert box.x0 >= 0 and box.x1 <= check_picture.bbox.x1 and box.y1 <= check_picture.bbox.y1
    top = max(axes.get_tightbbox().y1 for axes in check_picture.axes)
    assert top <= box.y0
    assert "2024.whl" in check_picture._suptitle.get_text()


@pytest.mark.parametrize("label", ["radii", "conicity", "moves", "roll rate", "distance", "near"])
def test_curves_stay_in_their_panels(check_picture, label):
    axes = panel(check_picture, label)
    low, high = axes.get_ylim()
    for line in axes.lines:
        x, y = (np.asarray(values, dtype=float) for values in line.get_data())
        shown = y[(abs(x) <= 8) & np.isfinite(y)] if len(x) > 2 else []
        assert np.all((shown >= low) & (shown <= high)), line.get_label()


def test_contact_points_are_drawn_without_distortion(check_picture):
    check_picture.draw_without_rendering()
    axes = panel(check_picture, "places")
    origin, right, up = (axes.transData.transform(point) for point in ((0, 0), (1, 0), (0, 1)))
    assert right[0] - origin[0] == pytest.approx(up[1] - origin[1], rel=1e-3)


# --- yawed patches ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("yaw", [0.02, -0.02])
@pytest.mark.parametrize("shift, side", [(4.9e-3, "right"), (-4.9e-3, "left"), (6.5e-3, "right")])
def test_the_locus_passes_the_contact_point_and_the_other_patch(shift, side, yaw):
    """The contact point of a shift just behind the jump lies where the second patch is before it."""
    state = SYSTEM.evaluate(lateral_shift=shift, yaw=yaw)
    assert stations_along(SYSTEM, state, side, np.zeros(1))[0] == pytest.approx(0.0, abs=1e-5)  # [m]
    if abs(shift) < 6e-3:
        behind = SYSTEM.evaluate(lateral_shift=shift * 5.05 / 4.9, yaw=yaw)
        found, other = (getattr(one, side) for one in (state, behind))
        at = stations_along(SYSTEM, state, side, np.array([found.patches[1].centroid]))[0]
        assert at == pytest.approx(other.contact.x_track - found.contact.x_track, abs=0.3e-3)  # [m]
        assert abs(at) > 1.5e-3


def test_two_patches_are_drawn_at_their_own_places():
    state = SYSTEM.evaluate(**YAWED)
    first, second = (
        mesh.get_coordinates()[..., 1]
        for mesh in panel(plots.outline_figure(SYSTEM, state), "right patch").collections[:2]
    )
    middles = [np.mean([part.min(), part.max()]) for part in (first, second)]  # [mm] flange root, tread
    assert middles == pytest.approx([1.8, 0.0], abs=0.15)
    axes = panel(plots.outline_figure(SYSTEM, state), "right patch")
    low, high = axes.get_ylim()
    assert low < min(first.min(), second.min()) and max(first.max(), second.max()) < high
    without = panel(plots.outline_figure(state), "right patch").collections[0].get_coordinates()[..., 1]
    assert without.min() == pytest.approx(-without.max())


def test_patches_without_yaw_lie_beside_the_contact_point():
    state = SYSTEM.evaluate(lateral_shift=4.9e-3)
    assert not np.any(patch_places(SYSTEM, state, "right"))


# --- a pose -----------------------------------------------------------------------------------------------


def test_all_patches_of_a_pose_are_marked_and_the_left_one_lies_as_in_its_section():
    state = SYSTEM.evaluate(lateral_shift=4.9e-3)
    figure = plots.pose_figure(SYSTEM, state)
    marks = [line for line in panel(figure, "right contact").lines if line.get_label() == "patch"]
    centres = [[patch.y_track / MM, -patch.z_track / MM] for patch in state.right.patches]
    assert len(centres) == 2 and np.transpose(marks[0].get_data()) == pytest.approx(np.array(centres))
    assert [
        text.get_text() for text in panel(figure, "right contact").texts if text.get_text().isdigit()
    ] == ["1", "2"]
    assert not [line for line in panel(figure, "left contact").lines if line.get_label() == "patch"]
    for kind in ("patch", "pressure"):  # the field side is on the left of the left wheel
        assert panel(figure, f"left {kind}").xaxis_inverted()
        assert not panel(figure, f"right {kind}").xaxis_inverted()


# --- the caller's axes ------------------------------------------------------------------------------------


def drawn(report):
    """Each picture, and the shape of its axes."""
    state = SYSTEM.evaluate(**YAWED)
    swept = plots.sweep(SYSTEM, np.linspace(-1, 1, 5) * MM)
    return {
        "sweep": (lambda ax: plots.sweep_figure(swept, ax=ax), (1, 3)),
        "outline": (lambda ax: plots.outline_figure(SYSTEM, state, ax=ax), (2, 2)),
        "outline of one side": (lambda ax: plots.outline_figure(state, ax=ax, side="right"), (2, 1)),
        "contact": (lambda ax: plots.contact_figure(SYSTEM, state, ax=ax), (1, 2)),
        "contact of one side": (lambda ax: plots.contact_figure(SYSTEM, state, ax=ax, side="left"), (1, 1)),
        "pose": (lambda ax: plots.pose_figure(SYSTEM, state, ax=ax), (3, 2)),
        "check": (lambda ax: plots.check_figure(report, ax=ax), (8, 1)),
    }


def test_pictures_are_drawn_in_the_axes_of_the_caller(report):
    for name, (draw, shape) in drawn(report).items():
        figure = Figure()
        axes = figure.subplots(*shape)
        assert draw(axes) is figure, name
        assert all(one.get_label() and one.has_data() for one in np.ravel(axes)), name
        assert figure._suptitle is None, name


@pytest.mark.parametrize("name", ["sweep", "contact", "pose", "check"])
def test_another_number_of_axes_is_refused(report, name):
    with pytest.raises(ValueError, match="ax has 4 axes; permitted are"):
        drawn(report)[name][0](Figure().subplots(2, 2))


def test_an_unknown_side_is_refused():
    with pytest.raises(ValueError, match="side is 'up'"):
        plots.contact_figure(SYSTEM, SYSTEM.evaluate(), side="up")


@pytest.mark.full
@pytest.mark.parametrize(
    "draw",
    [
        plots.outline_figure,
        *(pytest.param(draw, marks=pytest.mark.full) for draw in (plots.contact_figure, plots.pose_figure)),
    ],
)
def test_the_system_comes_first_and_may_come_second(draw):
    """In one order; calls in the other one work too."""
    shown = list(inspect.signature(draw).parameters)
    assert shown == ["system", "state", "ax", "side"][: len(shown)]
    state = SYSTEM.evaluate(**YAWED)
    pictures = [
        draw(SYSTEM, state),
        draw(state, SYSTEM),
        draw(state=state, system=SYSTEM),
        draw(state, system=SYSTEM),
    ]
    shapes = [
        [
            [
                np.concatenate([[(0, 0)], *(path.vertices for path in part.get_paths())])
                for part in axes.collections
            ]
            + [line.get_xydata() for line in axes.lines]
            for axes in picture.axes
        ]
        for picture in pictures
    ]
    for other in shapes[1:]:
        assert len(other) == len(shapes[0]) > 1
        for some, same in zip(shapes[0], other):
            for one, two in zip(some, same):
                np.testing.assert_array_equal(one, two)


def test_axes_and_side_follow_in_this_order():
    state = SYSTEM.evaluate(**YAWED)
    for draw, shape in ((plots.outline_figure, (2, 1)), (plots.contact_figure, (1, 1))):
        for first in ((SYSTEM, state), (state, SYSTEM)):
            figure = Figure()
            assert draw(*first, figure.subplots(*shape), "left") is figure


@pytest.mark.parametrize(
    "draw, given, words",
    [
        (
            plots.pose_figure,
            lambda state: (state,),
            r"system is None; permitted is pose_figure\(system, state\)",
        ),
        (plots.contact_figure, lambda state: (SYSTEM,), "state is None; permitted is what system.evaluate"),
        (
            plots.outline_figure,
            lambda state: (SYSTEM, SYSTEM.evaluate_many([0.0, 1e-3])),
            r"state is a table of 2 poses; permitted is one of them, such as table\[0\]",
        ),
    ],
)
def test_a_picture_of_no_pose_is_refused(draw, given, words):
    with pytest.raises(TypeError, match=f"^{words}"):
        draw(*given(SYSTEM.evaluate()))


@pytest.mark.parametrize(
    "wanted, left, right",
    [
        ({"side": "right"}, "not computed", ""),
        ({"outputs": "patches"}, "not computed", "not computed"),
        ({"outputs": "geometry"}, "not computed", "not computed"),
        ({"load_transfer": 1.0}, "unloaded", ""),
    ],
)
def test_a_wheel_that_is_not_drawn_says_why(wanted, left, right):
    figure = plots.outline_figure(SYSTEM, SYSTEM.evaluate(1e-3, **wanted))
    for side, words in (("left", left), ("right", right)):
        assert "".join(text.get_text() for text in panel(figure, f"{side} patch").texts) == words


def test_plots_are_reachable_from_the_package():
    assert {"plots", "conditioning"} <= set(dir(wrcontact))
    with pytest.raises(AttributeError, match="no attribute 'plot'"):
        wrcontact.plot  # noqa: B018
