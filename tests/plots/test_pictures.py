"""The pictures on one axis: what they draw is what the package computes, and obeys mechanics."""

import json

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from scipy.optimize import brentq, minimize_scalar
from scipy.spatial.transform import Rotation

import wrcontact
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem, plots
from wrcontact.plots.creepage import MODELS
from wrcontact.plots.lines import APART
from wrcontact.plots.view_3d import on_rail, wheel_surface

MM, MPA, KN = 1e-3, 1e6, 1e3
SYSTEM = ContactSystem(tangential_model="strips")
#: (shift [m], yaw [rad], speed [m/s]): tread, two patches, flange root, flange.
POSES = {
    "tread": (1e-3, 1e-3, 20.0),
    "two": (4.9e-3, 0.0, 20.0),
    "root": (6.2e-3, 0.01, 20.0),
    "flange": (7e-3, -0.01, 20.0),
    "left": (-4.9e-3, 0.004, 30.0),
}


def pose(name, system=SYSTEM, **more):
    shift, yaw, speed = POSES[name]
    return system.evaluate(lateral_shift=shift, yaw=yaw, speed=speed, **more)


def lines_of(axis, gid):
    return [np.array(line.get_data(), dtype=float).T for line in axis.lines if line.get_gid() == gid]


# --- contact lines ------------------------------------------------------------------------------------------


def rolled_rail_height(rail, inclination):
    """Height [m] of the highest point's frame at a place y [m] of a rail that leans, from its own profile."""
    angle = -np.arctan(inclination)

    def turned(y):
        z = float(rail.height(np.array([y]))[0])
        return np.cos(angle) * y - np.sin(angle) * z, np.sin(angle) * y + np.cos(angle) * z

    top = minimize_scalar(
        lambda y: turned(y)[1], bounds=(-15e-3, 15e-3), method="bounded", options={"xatol": 1e-12}
    ).x
    top = turned(top)

    def height(place):
        y = brentq(lambda y: turned(y)[0] - top[0] - place, rail.start + 1e-6, rail.stop - 1e-6, xtol=1e-14)
        return turned(y)[1] - top[1]

    return height


@pytest.mark.parametrize("side", ["right", "left"])
def test_contact_lines_end_on_both_profiles(side):
    shift = np.linspace(-7e-3, 7e-3, 29)
    axis = plots.contact_lines(SYSTEM, side=side, lateral_shift=shift)
    drawn, height = lines_of(axis, "line"), rolled_rail_height(SYSTEM.rail, 1 / 40)
    assert len(drawn) == len(shift)
    table = SYSTEM.evaluate_many(shift, outputs="geometry")
    aside = None
    for place, ((wheel, up), (rail, down)) in enumerate(drawn):
        contact = getattr(table[place], side).contact
        aside = rail * MM - contact.y_rail if aside is None else aside
        assert wheel * MM == pytest.approx(contact.y_wheel, abs=1e-12)
        assert rail * MM == pytest.approx(contact.y_rail + aside, abs=1e-12)
        on_wheel = APART - float(SYSTEM.wheel.height(np.array([contact.y_wheel]))[0])
        assert up * MM == pytest.approx(on_wheel, abs=1e-9), shift[place]  # [m]
        assert down * MM == pytest.approx(-height(contact.y_rail), abs=1e-9), shift[place]  # [m]


def test_jumps_are_gaps_between_the_contact_lines():
    """Jumps to the flange root and to the flange are those of the independent search (data/find_jumps.py)."""
    axis = plots.contact_lines(SYSTEM)
    ends = np.array([line[0, 0] for line in lines_of(axis, "line")])
    beside = np.array([line[0, 0] for line in lines_of(axis, "jump")]).reshape(-1, 2)
    assert len(beside) == 3
    for before, after in beside:
        assert not np.any((ends < before - 1e-9) & (ends > after + 1e-9))
    assert {"4.85", "6.25"} <= {text.get_text() for text in axis.texts}


# --- over the lateral shift ---------------------------------------------------------------------------------


def test_curves_of_a_cone_are_those_of_a_cone():
    """Rolling radii, contact angles and roll of cones 1:20 follow in closed form from where they touch."""
    system = ContactSystem(wheel="cone20", rail_inclination=1 / 20)
    swept = plots.sweep(system, np.linspace(-5, 5, 21) * MM)
    shift, difference = lines_of(plots.radius_difference(swept), None)[0].T
    places = swept.state.right.contact.y_wheel - swept.state.left.contact.y_wheel
    assert difference == pytest.approx(-places / 20 / MM, abs=1e-9)  # [mm]
    # as it rolls by the difference over 1.5 m, the wheelset moves under its centre, 0.46 m up, and on the
    # rails, whose tops have a radius of 0.3 m
    assert difference == pytest.approx(0.1 * shift / (1 - 0.1 * (0.46 + 0.3) / 1.5), rel=0.003, abs=1e-9)
    angle = plots.contact_angle(swept)
    roll = lines_of(plots.roll_angle(swept), None)[1][:, 1]
    for line, way in zip(lines_of(angle, None), (1, -1)):
        assert line[:, 1] == pytest.approx(np.degrees(np.arctan(1 / 20)) + way * roll, abs=1e-6)  # [deg]
    contacts = swept.state.right.contact.y_track - swept.state.left.contact.y_track
    lower = swept.state.right.contact.z_rail - swept.state.left.contact.z_rail
    assert roll == pytest.approx(np.degrees((lower - difference * MM) / contacts), rel=2e-3, abs=1e-9)


@pytest.mark.parametrize("draw, jumps", [(plots.radius_difference, 6), (plots.contact_angle, 3)])
def test_curves_have_gaps_at_jumps(draw, jumps):
    axis = draw(plots.sweep(SYSTEM))
    assert len(lines_of(axis, "jump")) == 6
    for line in (line for line in lines_of(axis, None) if len(line) > 2):
        assert np.count_nonzero(np.isnan(line[:, 1])) == jumps


def test_a_sweep_without_contact_is_refused():
    swept = plots.sweep(SYSTEM, np.array([20e-3, 21e-3]))
    for draw in (plots.radius_difference, plots.contact_angle, plots.roll_angle):
        with pytest.raises(ValueError, match="none of the 2 lateral shifts has a contact"):
            draw(swept)


# --- three dimensions ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, side", [("two", "right"), ("root", "right"), ("left", "left"), ("tread", "left")]
)
def test_the_drawn_wheel_is_the_wheel_in_its_pose(name, side):
    """Turned back by another program, each point has the radius of the profile; the contact point is on
    it."""
    state = pose(name)
    points = np.stack(wheel_surface(SYSTEM, state, side), axis=-1).reshape(-1, 3)
    contact = getattr(state, side).contact
    points = np.vstack([points, [contact.x_track, contact.y_track, contact.z_track]])
    centre = [0.0, state.inputs.lateral_shift, state.vertical_shift - 0.46]
    own = (points - centre) @ Rotation.from_euler("ZX", [state.inputs.yaw, state.roll]).as_matrix()
    y = (1 if side == "right" else -1) * own[:, 1] - 0.75
    radius = 0.46 + SYSTEM.wheel.height(y)
    # [m] the printed S1002 has steps of 1.2e-7 m at its joints, one of which is at a drawn place
    assert np.hypot(own[:, 0], own[:, 2]) == pytest.approx(radius, abs=1.5e-7)


def test_patches_lie_on_the_rail_and_normals_have_the_direction_of_their_force():
    state = SYSTEM.evaluate(lateral_shift=3e-3)
    y, z = on_rail(SYSTEM, state, "right", np.array([0.0]))
    contact = state.right.contact
    assert (y[0], z[0]) == pytest.approx((contact.y_track, contact.z_track), abs=2e-7)  # [m]
    axis = plots.wheel_on_rail(SYSTEM, state)
    (arrow,) = [
        one for one in axis.collections if type(one).__name__ == "Line3DCollection" and one.zorder == 8
    ]
    start, end = np.array(arrow._segments3d[0])
    patch = state.right.patches[0]
    foot = np.array([patch.x_track, patch.y_track, -patch.z_track]) / MM
    start, end = sorted((start, end), key=lambda point: np.linalg.norm(point - foot))
    assert start == pytest.approx(foot, abs=1e-9)
    stroke, force = end - start, np.array(state.right.normal.force)
    assert stroke / np.linalg.norm(stroke) == pytest.approx(
        force / np.linalg.norm(force) * [1, 1, -1], abs=1e-6
    )
    assert [text.get_text() for text in axis.texts] == ["78 kN"]


def test_a_flat_axis_is_refused_for_three_dimensions():
    with pytest.raises(ValueError, match='permitted is one with projection="3d"'):
        plots.wheel_on_rail(SYSTEM, pose("tread"), Figure().subplots())


# --- patches ------------------------------------------------------------------------------------------------


def integral(mesh):
    """Integral of a gouraud mesh over its plane, straight lines between its corners."""
    points, values = (
        mesh.get_coordinates(),
        np.asarray(mesh.get_array()).reshape(mesh.get_coordinates().shape[:2]),
    )
    diagonals = points[1:, 1:] - points[:-1, :-1], points[1:, :-1] - points[:-1, 1:]
    areas = 0.5 * np.abs(
        diagonals[0][..., 0] * diagonals[1][..., 1] - diagonals[0][..., 1] * diagonals[1][..., 0]
    )
    means = (values[1:, 1:] + values[:-1, :-1] + values[1:, :-1] + values[:-1, 1:]) / 4
    return float(np.sum(areas * means))


def meshes(axis):
    return [one for one in axis.collections if type(one).__name__ == "QuadMesh"]


@pytest.mark.parametrize("name", POSES)
@pytest.mark.parametrize("side", ["left", "right"])
def test_the_drawn_pressure_carries_the_load(name, side):
    state = pose(name)
    total = sum(integral(mesh) for mesh in meshes(plots.patch_map(SYSTEM, state, side=side)))
    assert total == pytest.approx(getattr(state, side).normal_force, rel=0.01), (name, side)  # MPa mm2 = N


@pytest.mark.parametrize(
    "name", [*(pytest.param(name, marks=pytest.mark.full) for name in ("tread", "two")), "root"]
)
def test_tractions_are_within_friction_and_have_the_force_of_the_complete_theory(name):
    state = pose(name, right_friction=0.37)
    complete = pose(name, ContactSystem(tangential_model="halfspace"), right_friction=0.37)
    for number, patch in enumerate(state.right.patches):
        found = plots.patch_tractions(SYSTEM, state, "right", number)
        assert found.friction == pytest.approx(0.37, rel=1e-9)
        shear, bound = np.hypot(found.shear_x, found.shear_y), 0.37 * found.pressure
        assert np.all(shear <= bound + 1e-6 * bound.max())
        assert found.pressure.sum() * found.cell_area == pytest.approx(patch.normal_force, rel=1e-6)
        force = np.array([found.shear_x.sum(), found.shear_y.sum()]) * found.cell_area
        limit = 0.37 * patch.normal_force
        exact = complete.right.patches[number].tangential
        # forces of 48 cells are up to 1.5 % off, those of strips 3 % (docs/theory/rolling.md)
        assert np.hypot(*(force - [exact.x, exact.y])) < 0.03 * limit, (name, number)
        assert np.hypot(*(force - [patch.tangential.x, patch.tangential.y])) < 0.045 * limit, (name, number)
        stick = found.cover[~found.slips].sum() / found.cover.sum()
        assert stick == pytest.approx(patch.stick_share, abs=0.12), (name, number)


@pytest.mark.parametrize("name", ["tread", "two"])
def test_arrows_are_the_tractions_of_their_places(name):
    state = pose(name)
    axis = plots.patch_map(SYSTEM, state)
    (arrows,) = [one for one in axis.collections if type(one).__name__ == "Quiver"]
    fields = [
        plots.patch_tractions(SYSTEM, state, "right", number) for number in range(len(state.right.patches))
    ]
    assert len(arrows.U) > 20
    for x, y, u, v in zip(arrows.X, arrows.Y, arrows.U, arrows.V):
        cells = [(np.hypot(field.station - x * MM, field.along - y * MM), field) for field in fields]
        distance, field = min(cells, key=lambda pair: pair[0].min())
        cell = np.unravel_index(np.argmin(distance), distance.shape)
        assert distance[cell] < 1e-9
        assert (u * MPA, v * MPA) == pytest.approx((field.shear_y[cell], field.shear_x[cell]), rel=1e-9)
    slow = state.right.patches[-1]
    if slow.stick_share == 0.0:  # it slips: friction is against the slip
        assert np.sum(fields[-1].shear_x) * slow.creepage.x < 0.0


def test_where_a_patch_sticks_is_coloured_so():
    """The coloured area has the stick share of the state."""
    state = pose("tread")
    axis = plots.patch_map(SYSTEM, state, colour="slip")
    (stick,) = [one for one in axis.collections if type(one).__name__ == "QuadContourSet"]
    edge = next(one for one in axis.patches if isinstance(one, PathPatch)).get_path()
    random = np.random.default_rng(3)
    low, high = edge.get_extents().get_points()
    points = random.uniform(low, high, (4000, 2))
    points = points[edge.contains_points(points)]
    share = np.mean(np.any([path.contains_points(points) for path in stick.get_paths()], axis=0))
    assert share == pytest.approx(state.right.patches[0].stick_share, abs=0.08)
    assert {text.get_text() for text in axis.get_legend().get_texts()} == {"sticks", "slips"}


def test_a_wheelset_without_creep_forces_has_pressure_alone():
    state = ContactSystem().evaluate(3e-3)
    axis = plots.patch_map(ContactSystem(), state)
    assert len(meshes(axis)) == 1 and not [one for one in axis.collections if type(one).__name__ == "Quiver"]
    with pytest.raises(ValueError, match="colour is 'shear'; permitted is 'pressure'"):
        plots.patch_map(ContactSystem(), state, colour="shear")
    with pytest.raises(ValueError, match="patch 0 of the right wheel has no creep force"):
        plots.patch_tractions(ContactSystem(), state)
    unloaded = ContactSystem().evaluate(3e-3, load_transfer=-1.0)
    assert [text.get_text() for text in plots.patch_map(ContactSystem(), unloaded).texts] == ["unloaded"]


@pytest.mark.parametrize("count", [1, pytest.param(6, marks=pytest.mark.full)])
def test_random_poses_are_drawn(count):
    random = np.random.default_rng(11)
    for _ in range(count):
        given = {
            "lateral_shift": random.uniform(-7e-3, 7e-3),
            "yaw": random.normal(0.0, 5e-3),
            "speed": random.uniform(1, 60),
            "normal_force": random.uniform(2e4, 1.5e5),
            "lateral_velocity": random.normal(0.0, 0.02),
        }
        state = SYSTEM.evaluate(**given)
        for side in ("left", "right"):
            axis = plots.patch_map(SYSTEM, state, side=side)
            total = sum(integral(mesh) for mesh in meshes(axis))
            assert total == pytest.approx(getattr(state, side).normal_force, rel=0.01), (given, side)


# --- creep curves -------------------------------------------------------------------------------------------


def kalker_of_a_circle():
    """C11, C22, C23 for nu = 0.25 and a = b, from Kalker's table."""
    with open(ROOT / "data" / "creep" / "kalker_cij.json", encoding="utf-8") as file:
        return [row[1] for row in json.load(file)["table"][1][9]]


@pytest.mark.parametrize(
    "over, coefficient, power", [("creepage_x", 0, 2), ("creepage_y", 1, 2), ("spin", 2, 3)]
)
def test_curves_start_with_the_slope_of_kalker_s_table(over, coefficient, power):
    radius, load = 5e-3, 80e3
    patch = wrcontact.elliptic_patch(radius, radius, load, youngs_modulus=200e9, poisson_ratio=0.25)
    slope = 80e9 * radius**power * kalker_of_a_circle()[coefficient]  # G = E/(2(1 + nu)) = 80 GPa
    axis = plots.creep_curves(patch, over=over, largest=0.01 * 0.3 * load / slope)
    assert (
        [line.get_label() for line in axis.lines[1:]]
        == list(MODELS)
        == ["strips", "fastsim", "fastrip", "polach"]
    )
    for line in axis.lines[1:]:
        creepage, force = line.get_data()
        scale = 1.0 if over == "spin" else 1e3
        found = force[-1] * KN / (creepage[-1] / scale)
        # the table is printed to three digits; 1 % of the friction is 1 % away from the linear theory
        assert found == pytest.approx(slope, rel=0.03), line.get_label()


@pytest.mark.full
def test_curves_end_at_friction_times_load_and_never_exceed_it():
    patch = wrcontact.elliptic_patch(6e-3, 4e-3, 80e3)
    axis = plots.creep_curves(patch, models=("strips", "fastsim", "halfspace"), friction=0.25)
    assert axis.lines[0].get_ydata()[0] == pytest.approx(20.0)  # [kN]
    for line in axis.lines[1:]:
        force = line.get_ydata()
        assert np.all(force <= 20.0 * (1 + 1e-6)) and force[-1] > 0.95 * 20.0
        assert np.all(np.diff(force) > -1e-3)
    assert len(axis.lines[-1].get_xdata()) < len(axis.lines[1].get_xdata())


@pytest.mark.parametrize(
    "given, words",
    [
        ({"models": ("kalker",)}, "models is 'kalker'; permitted are 'strips'"),
        ({"over": "speed"}, "over is 'speed'; permitted are 'creepage_x'"),
    ],
)
def test_unknown_models_and_creepages_are_refused(given, words):
    with pytest.raises(ValueError, match=words):
        plots.creep_curves(wrcontact.elliptic_patch(6e-3, 4e-3, 80e3), **given)


# --- all of them --------------------------------------------------------------------------------------------


def one_of_each():
    """Each picture by name, as a function of the axis."""
    swept, state = plots.sweep(SYSTEM, np.linspace(-1, 1, 5) * MM), pose("tread")
    table = SYSTEM.evaluate_many(np.linspace(-1, 1, 5) * MM)
    return {
        "lines": lambda axis: plots.contact_lines(SYSTEM, axis, lateral_shift=np.linspace(0, 1, 3) * MM),
        "radii": lambda axis: plots.radius_difference(swept, axis),
        "angles": lambda axis: plots.contact_angle(swept, axis),
        "roll": lambda axis: plots.roll_angle(swept, axis),
        "patch": lambda axis: plots.patch_map(SYSTEM, state, axis),
        "creep": lambda axis: plots.creep_curves(
            wrcontact.elliptic_patch(6e-3, 4e-3, 8e4), axis, models=("polach",)
        ),
        "history": lambda axis: plots.history(table, "right.area", axis, over="lateral_shift"),
    }


@pytest.mark.parametrize("name", one_of_each())
def test_pictures_are_drawn_on_the_caller_s_axis_with_units(name):
    axis = Figure().subplots()
    assert one_of_each()[name](axis) is axis
    assert axis.has_data() and "[" in axis.get_xlabel()
    assert name == "lines" or "[" in axis.get_ylabel()
    alone = one_of_each()[name](None)
    assert alone.get_figure() is not axis.get_figure() and alone.get_xlabel() == axis.get_xlabel()


def test_the_first_picture_of_the_readme_has_lines_and_a_patch(tmp_path):
    system = ContactSystem(rail="60E1", tangential_model="strips")
    figure = plots.hero_figure(system, system.evaluate(4.95e-3, speed=20.0, free_rolling=True))
    lines, patch = figure.axes[:2]
    assert len(lines_of(lines, "line")) == 65 and len(meshes(patch)) == 2
    file = plots.save(figure, tmp_path / "title_picture.png", resolution=40)
    assert file.read_bytes().startswith(b"\x89PNG")


def test_sections_are_drawn_with_their_heights():
    u = np.linspace(0.0, 0.4, 5)
    rail = wrcontact.profiles.standard_profile("UIC60")
    ramp = wrcontact.RailSections(u, [rail] * 5, places=np.column_stack([0.0 * u, -0.05 * u]), name="ramp")
    figure = plots.sections_figure(ramp)
    across, above = figure.axes[:2]
    assert len(across.lines) == 5 and figure.get_suptitle() == "ramp"
    for line, position in zip(across.lines, u):
        y, z = line.get_data()
        assert np.min(z) == pytest.approx(-50.0 * position, abs=1e-3) and y[0] == pytest.approx(
            rail.start / MM
        )
    assert [line[0, 0] for line in lines_of(above, "slice")] == pytest.approx(list(u))
    assert above.get_xlabel() == "position along the track [m]"


def test_a_wheelset_with_wheels_that_are_not_round_is_drawn():
    """An eccentric wheel on both sides: the height is a cosine of the rotation."""
    wheel = wrcontact.WheelSections.eccentric("S1002", 2e-4)
    system, turn = ContactSystem(wheel=wheel), np.linspace(-np.pi, np.pi, 9)
    figure = plots.around_wheel_figure(system, turn, outputs="patches")
    angle, height = figure.axes[0].lines[0].get_data()
    assert angle == pytest.approx(np.degrees(turn))
    assert height - height.mean() == pytest.approx(0.2 * (np.cos(turn) - np.cos(turn).mean()), abs=1e-5)
    assert figure.axes[4].get_xlabel() == "rotation of the wheelset about its axle [deg]"
    with pytest.raises(ValueError, match="which are round; permitted is one with WheelSections"):
        plots.around_wheel_figure(ContactSystem())


def test_a_wheelset_along_a_changing_rail_is_drawn():
    """A ramp of 1:50 on both sides: it rises, and is pushed back."""
    u = np.linspace(-0.4, 0.4, 5)
    rail = wrcontact.profiles.standard_profile("UIC60")
    ramp = wrcontact.RailSections(u, [rail] * 5, places=np.column_stack([0.0 * u, -0.02 * u]), name="ramp")
    system = ContactSystem(rail=ramp)
    at = np.linspace(-0.1, 0.1, 5)
    figure = plots.along_track_figure(system, at, lateral_shift=1e-3)
    height, contacts, loads, forces, pressures = figure.axes
    assert np.diff(height.lines[0].get_data()[1]) == pytest.approx(0.02 * np.diff(at) / MM, rel=1e-6)
    for side, line in zip(("left", "right"), forces.lines):
        state = system.evaluate(track_position=at[2], lateral_shift=1e-3)
        assert line.get_data()[1][2] == pytest.approx(getattr(state, side).force.x / 1e3, rel=1e-9)
        assert line.get_data()[1][2] == pytest.approx(-78.5 * 0.02, rel=5e-3)
    assert len(contacts.lines) == len(pressures.lines) == 2 and len(loads.lines) >= 2
    assert pressures.get_xlabel() == "position of the wheelset along the track [m]"
    assert plots.along.slices_of(system)[[0, -1]] == pytest.approx([-0.4, 0.4])
    with pytest.raises(
        ValueError, match="which are the same all along the track; permitted is one with RailSections"
    ):
        plots.along_track_figure(ContactSystem())
    with pytest.raises(
        ValueError, match="permitted for this picture are rails that are the same all along it"
    ):
        plots.pose_figure(system, state)
    with pytest.raises(ValueError, match="permitted for a sweep over the lateral shift are rails"):
        plots.sweep(system)
