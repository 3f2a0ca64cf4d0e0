"""Results in other forms: rows and columns of tables, dictionaries, arrays, short texts, pandas, xarray."""

import json
import math
import pickle
import re
import sys

import numpy as np
import pytest

import wrcontact
from wrcontact.interface.inputs import INPUTS

SYSTEM = wrcontact.ContactSystem()
SHIFTS = np.array([0.0, 5e-3, 20e-3, -3e-3])  # [m] one patch, two patches, off the profile, one patch


@pytest.fixture(scope="module")
def table():
    return SYSTEM.evaluate_many(SHIFTS, yaw=0.005)


@pytest.fixture(scope="module")
def state():
    return SYSTEM.evaluate(5e-3, yaw=0.005)


def test_a_row_of_a_table_is_the_state_of_one_pose(table):
    row = table[1]
    assert row.status is wrcontact.Status.VALID and len(row.right.patches) == 2
    assert row.right.area == table.right.area[1] and row["lateral_shift"] == 5e-3
    assert table[2].status is wrcontact.Status.OFF_PROFILE and np.isnan(table[-2].roll)
    assert len(list(table)) == 4


def test_rows_of_a_table_are_a_table(table):
    np.testing.assert_array_equal(table[1:3].right.area, table.right.area[1:3])
    valid = table[table.status == 0]
    assert len(valid) == 3 and np.all(np.isfinite(valid.values))
    np.testing.assert_array_equal(valid["lateral_shift"], [0.0, 5e-3, -3e-3])


def test_names_lead_to_the_properties(table, state):
    assert state["right.patch[2].area"] == state.right.patches[1].area
    assert state["force.y"] == state.force.y and state["status"] == 0
    np.testing.assert_array_equal(table["left.pressure[4]"], table.left.outline.pressure[:, 3])
    first, last = wrcontact.interface.variables.FIRST_OUTPUT, wrcontact.interface.variables.FIRST_WEAR
    assert list(table.names) == [v.name for v in wrcontact.interface.variables.VARIABLES[first:last]]
    np.testing.assert_array_equal(np.stack([table[name] for name in table.names], axis=1), table.values)
    with pytest.raises(KeyError, match="right.ara'; did you mean right.area"):
        table["right.ara"]
    with pytest.raises(KeyError, match="'zzz'; .names lists them"):
        table["zzz"]
    with pytest.raises(TypeError, match="one pose"):
        state[0]


def test_names_of_outlines_follow_the_number_of_stations():
    system = wrcontact.ContactSystem(stations=5)
    table = system.evaluate_many([0.0, 1e-3])
    np.testing.assert_array_equal(table["right.half_length[5]"], table.right.outline.half_length[:, 4])
    assert "left.station[6]" not in table.names
    some = system.evaluate_many([0.0, 1e-3], side="right")
    np.testing.assert_array_equal(some.right.outline.pressure, table.right.outline.pressure)


def test_a_vector_is_an_array(table, state):
    np.testing.assert_array_equal(np.asarray(state.force), [state.force.x, state.force.y, state.force.z])
    assert np.linalg.norm(state.force) > 1e5 and len([*state.moment]) == 3
    assert np.asarray(table.force).shape == (4, 3)


def test_a_vector_is_a_sequence_of_three(table, state):
    force = state.force
    assert (force[0], force[1], force[-1]) == (force.x, force.y, force.z) and force[1] < 0.0
    assert len(force) == 3 and tuple(force) == force[:] and force[1:] == (force.y, force.z)
    x, y, z = table.right.patches[0].force
    np.testing.assert_array_equal(table.right.patches[0].force[1], y)
    assert len(table.force) == 3 and x.shape == z.shape == (4,)
    with pytest.raises(IndexError):
        force[3]


def test_inputs_have_names(table):
    state = SYSTEM.evaluate(5e-3, yaw=0.005, left_friction=0.2)
    inputs = state.inputs
    assert inputs.lateral_shift == inputs["lateral_shift"] == inputs[0] == 5e-3
    assert isinstance(inputs.yaw, float)
    assert inputs.left_friction == inputs["left.friction"] == inputs["left_friction"] == 0.2
    assert inputs.to_dict()["left.friction"] == 0.2 and len(inputs.to_dict()) == len(INPUTS)
    assert {row.keyword: getattr(inputs, row.keyword) for row in INPUTS} == dict(
        zip((row.keyword for row in INPUTS), np.asarray(inputs))
    )
    np.testing.assert_array_equal(table.inputs.lateral_shift, SHIFTS)
    np.testing.assert_array_equal(table.inputs["yaw"], np.full(4, 0.005))
    assert table.inputs[1].lateral_shift == table[1].inputs.lateral_shift == 5e-3
    np.testing.assert_array_equal(table.inputs[table.status == 0].lateral_shift, SHIFTS[[0, 1, 3]])
    assert [row.lateral_shift for row in table.inputs] == SHIFTS.tolist()
    with pytest.raises(KeyError, match="there is no input 'friction'; did you mean left.friction"):
        inputs["friction"]
    assert not hasattr(inputs, "friction")


def test_inputs_are_an_array(table, state):
    """As before they had names; what is no row of inputs has no names."""
    assert isinstance(state.inputs, np.ndarray) and state.inputs.shape == (len(INPUTS),)
    assert table.inputs.shape == (4, len(INPUTS)) and pickle.loads(pickle.dumps(state.inputs)).yaw == 0.005
    for part in (
        state.inputs[:2],
        table.inputs[:, 0],
        table.inputs[:, :3],
        2.0 * state.inputs,
        state.inputs == 1.0,
        np.asarray(state.inputs),
        state.inputs.max(),
    ):
        assert not hasattr(part, "lateral_shift")
    assert state.inputs.max() == 78.5e3 and state.inputs[:2].tolist() == [5e-3, 0.005]
    assert wrcontact.explain(table[2].status, table[2].inputs).startswith("lateral_shift is 0.02 m")


def test_a_state_s_inputs_know_its_contact_mode():
    """What a compliant wheelset, or one wheel, is told concerns the inputs that it has."""
    whole, one = wrcontact.ContactSystem(contact_mode="compliant"), wrcontact.WheelContact(side="right")
    for lifted in (
        whole.evaluate(),
        whole.evaluate_many([0.0, 1e-3])[1],
        whole.evaluate_many([0.0, 1e-3], outputs=["roll"])[:1][0],
        one.evaluate(),
    ):
        assert wrcontact.explain(lifted.status, lifted.inputs).startswith("vertical_shift_input is 0 m at")
    rough = one.evaluate(friction=9.0)
    assert wrcontact.explain(rough.status, rough.inputs) == "friction is 9; permitted is 0 <= friction <= 2"
    given = whole.evaluate(left_friction=9.0)
    assert wrcontact.explain(given.status, given.inputs.to_dict()).startswith("left.friction is 9; permitted")
    with pytest.raises(ValueError, match="7 is not a valid Status"):
        wrcontact.explain(7, rough.inputs)


def test_the_text_of_inputs_has_units(table):
    state = SYSTEM.evaluate(5e-3, speed=20.0)
    assert (
        repr(state.inputs)
        == str(state.inputs)
        == ("Inputs(lateral_shift=0.005 m, yaw=0 rad, normal_force=78500 N, load_transfer=0, speed=20 m/s)")
    )
    assert repr(table.inputs) == (
        "Inputs(4 poses, lateral_shift=-0.003 ... 0.02 m, yaw=0.005 rad, "
        "normal_force=78500 N, load_transfer=0)"
    )


def test_a_patch_is_true_where_it_is(table, state):
    """The second pose of the table has two patches, no pose has three."""
    assert [bool(patch) for patch in table.right.patches] == [True, True, False]
    assert [bool(patch) for patch in table[:1].right.patches] == [True, False, False]
    assert all(state.right.patches) and len(state.right.patches) == 2
    absent = SYSTEM.evaluate(5e-3, outputs="geometry")
    assert absent.right.patches == () and np.isnan(absent.right.patch_count)
    assert not any(SYSTEM.evaluate_many(SHIFTS, outputs="geometry").right.patches)
    assert state and table and state.right and state.force and not SYSTEM.evaluate_many([])


def test_to_dict(table, state):
    content = json.loads(json.dumps(state.to_dict()))
    assert content["status"] == 0 and content["inputs"]["lateral_shift"] == 5e-3
    assert content["right"]["contact"]["y_wheel"] == state.right.contact.y_wheel
    assert [patch["area"] for patch in content["right"]["patches"]] == [p.area for p in state.right.patches]
    assert content["left"]["outline"]["station"] == state.left.outline.station.tolist()
    np.testing.assert_array_equal(
        table.to_dict()["right"]["outline"]["pressure"], table.right.outline.pressure
    )


def test_a_state_survives_pickling(table, state):
    assert pickle.loads(pickle.dumps(state)).right.area == state.right.area
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(table))["roll"], table["roll"])


# --- only what is wanted ----------------------------------------------------------------------------------


#: The first output of a wheel that is beyond a depth; those of the wheelset belong to every depth.
BEYOND = {"geometry": "penetration", "patches": "station[1]", "all": ""}


def wanted_names(names, outputs, side):
    """Of all names those that ``outputs`` and ``side`` mean, as docs/guides/usage.md tells it."""
    if not isinstance(outputs, str):  # a name, or the family before a point or a bracket
        return [
            name for name in names if any(re.fullmatch(rf"{re.escape(w)}([.\[].*)?", name) for w in outputs)
        ]
    kept = [name for name in names if not name.startswith(("left.", "right."))]
    for one in ("left", "right") if side == "both" else (side,):
        own = [name for name in names if name.startswith(f"{one}.")]
        kept += own[: own.index(f"{one}.{BEYOND[outputs]}") if BEYOND[outputs] else None]
    return kept


@pytest.mark.parametrize(
    "outputs, side",
    [
        ("geometry", "both"),
        ("patches", "right"),
        ("all", "left"),
        (["right.area"], "both"),
        (["roll", "left.contact", "right.patch[2]"], "both"),
        (["moment", "left.half_length"], "both"),
    ],
)
def test_a_table_holds_only_what_is_wanted(table, outputs, side):
    some = SYSTEM.evaluate_many(SHIFTS, yaw=0.005, outputs=outputs, side=side)
    assert sorted(some.names) == sorted(wanted_names(table.names, outputs, side))
    assert some.values.shape == (4, len(some.names))
    for name in some.names:
        if outputs == "geometry" or side != "both":
            if name.startswith(("force", "moment", "normal.", "driving_torque")) or name.endswith(
                "patch_count"
            ):
                continue  # the resultant needs both loads
        np.testing.assert_array_equal(some[name], table[name], err_msg=name)
    for name in set(table.names) - set(some.names):
        assert np.all(np.isnan(some[name])), name
    np.testing.assert_array_equal(
        some[1].values, np.where(np.isin(table.names, some.names), some[1].values, np.nan)
    )


@pytest.mark.parametrize(
    "outputs, word", [("geometri", "'geometri'"), (["right.ara"], "'right.ara'"), ([], "empty"), ([3], "3")]
)
def test_unknown_outputs_are_refused(outputs, word):
    with pytest.raises(ValueError, match=f"^outputs .*{word}"):
        SYSTEM.evaluate_many(0.0, outputs=outputs)


def test_parts_are_the_table(table):
    parts = list(SYSTEM.evaluate_parts(np.repeat(SHIFTS, 10), yaw=0.005, outputs=["roll", "left"]))
    assert len(parts) > 1
    together = np.concatenate([part["left.area"] for part in parts])
    np.testing.assert_allclose(together, np.repeat(table["left.area"], 10), rtol=1e-9)


# --- errors name the argument -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: SYSTEM.evaluate("a"), "lateral_shift is 'a'"),
        (lambda: SYSTEM.evaluate(0.0, yaw=[1.0, 2.0]), "yaw has the shape .2,.; permitted is one number"),
        (lambda: SYSTEM.evaluate_many([0.0], normal_force="much"), "normal_force is 'much'.* in N"),
        (lambda: SYSTEM.evaluate_many([1.0, 2.0], yaw=[1.0, 2.0, 3.0]), "lateral_shift .2,., yaw .3,."),
        (lambda: SYSTEM.evaluate_many(0.0, roll_guess=np.zeros((2, 2))), "roll_guess has the shape"),
        (lambda: SYSTEM.evaluate(0.0, penetration=(1, 2, 3)), "penetration is .1, 2, 3."),
        (lambda: SYSTEM.evaluate(0.0, penetration="deep"), "penetration is 'deep'"),
        (
            lambda: SYSTEM.evaluate(0.0, outputs=["rol"]),
            "outputs has .rol.; permitted are .*; did you mean roll",
        ),
        (lambda: wrcontact.ContactSystem(normal_model=[1]), "normal_model is"),
    ],
)
def test_errors_name_the_argument(call, words):
    with pytest.raises(ValueError, match=words):
        call()


# --- texts ------------------------------------------------------------------------------------------------


def test_texts_are_short(table, state):
    shown = [
        SYSTEM,
        SYSTEM.wheel,
        SYSTEM.rail,
        SYSTEM.stepper(),
        table,
        state,
        state.right,
        state.force,
        state.right.contact,
        state.right.patches,
        state.right.outline,
        table.right,
        table.left.patches,
        wrcontact.check(SYSTEM),
        wrcontact.plots.sweep(SYSTEM, SHIFTS[:2]),
    ]
    assert {repr(one): len(repr(one)) for one in shown if len(repr(one)) > 600} == {}
    assert "S1002" in repr(SYSTEM.wheel) and "wheel" in repr(SYSTEM.wheel)


def test_the_text_of_a_table_counts_its_outcomes(table):
    assert repr(table) == "WheelsetState(4 poses: 3 valid, 1 off profile)"
    both = SYSTEM.evaluate_many([0.0, 0.0, 20e-3, 0.0], load_transfer=[0.0, 1.0, 0.0, 2.0])
    words = "4 poses: 1 valid, 1 unloaded, 1 off profile, 1 invalid input"
    assert repr(both) == f"WheelsetState({words})" and f"<caption>{words}</caption>" in both._repr_html_()
    assert repr(table[:2]) == "WheelsetState(2 poses: 2 valid)"
    assert repr(table[:0]) == "WheelsetState(0 poses)"


def test_html(table, state):
    assert "<td>contact.y_wheel</td><td>mm</td>" in state._repr_html_()
    assert "4 poses" in table._repr_html_() and table._repr_html_().count("<tr>") == 5
    some = SYSTEM.evaluate_many(np.zeros(50), outputs=["right.pressure[3]"])
    assert some._repr_html_().count("<tr>") == 11 and "right.pressure[3]" in some._repr_html_()


# --- other packages ---------------------------------------------------------------------------------------


@pytest.mark.full
def test_pandas(table):
    pytest.importorskip("pandas")
    frame = table.to_pandas()
    np.testing.assert_array_equal(frame["right.patch[1].area"], table["right.patch[1].area"])
    assert frame["status"].tolist() == [0, 0, 2, 0] and frame.shape == (4, len(INPUTS) + len(table.names) + 1)


@pytest.mark.full
def test_one_state_is_a_table_of_one_row(table):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    row = table[1]
    pandas.testing.assert_frame_equal(row.to_pandas(), table[1:2].to_pandas())
    xarray.testing.assert_identical(row.to_xarray(), table[1:2].to_xarray())
    some = SYSTEM.evaluate(5e-3, side="right").to_pandas()
    assert some.shape == (1, len(INPUTS) + len(table.names) + 1)
    assert np.isnan(some["left.area"][0]) and some["right.area"][0] > 0.0


@pytest.mark.full
def test_xarray(table):
    pytest.importorskip("xarray")
    data = table.to_xarray()
    np.testing.assert_array_equal(data["patch.area"].sel(side="right", patch=2), table["right.patch[2].area"])
    np.testing.assert_array_equal(data["force"], np.asarray(table.force))
    np.testing.assert_array_equal(data["pressure"].sel(side="left"), table.left.outline.pressure)
    np.testing.assert_array_equal(data["normal_force"].sel(side="left"), table["left.normal_force"])
    np.testing.assert_array_equal(data["normal_force_input"], table["normal_force"])
    assert data["area"].attrs["units"] == "m2"


@pytest.mark.full  # README's command installs none of the tables' packages
def test_inputs_that_vary_are_coordinates():
    xarray = pytest.importorskip("xarray")
    table = SYSTEM.evaluate_many(lateral_shift=np.linspace(-4, 4, 9) * 1e-3, yaw=1e-3, outputs=["roll"])
    data = table.to_xarray()
    assert set(data.variables) == {"lateral_shift", "roll", "status"} and set(data.coords) == {
        "lateral_shift"
    }
    near = data.sel(lateral_shift=2.3e-3, method="nearest")
    assert near["roll"] == SYSTEM.evaluate(lateral_shift=2e-3, yaw=1e-3).roll
    assert "yaw" in SYSTEM.evaluate_many(lateral_shift=[0.0, 1e-3]).to_xarray().data_vars
    assert isinstance(near, xarray.Dataset)


@pytest.mark.full  # README's command installs none of the tables' packages
def test_a_table_of_names_has_no_other_inputs():
    """... in memory and in frames; by name it knows them all."""
    pytest.importorskip("pandas")
    shifts = np.linspace(-4, 4, 1000) * 1e-3
    table = SYSTEM.evaluate_many(lateral_shift=shifts, yaw=1e-3, outputs=["roll"])
    assert list(table.to_pandas()) == ["lateral_shift", "roll", "status"]
    few = SYSTEM.evaluate_many(lateral_shift=shifts[:200], yaw=1e-3, outputs=["roll"])
    grown = len(pickle.dumps(table)) - len(pickle.dumps(few))
    assert grown == pytest.approx(800 * 3 * 8, abs=50)  # [B] shift, roll, status; and longer numbers of sizes
    np.testing.assert_array_equal(table["yaw"], np.full(1000, 1e-3))
    np.testing.assert_array_equal(table[10:20].inputs.lateral_shift, shifts[10:20])
    np.testing.assert_array_equal(table[table.roll > 0]["lateral_shift"], shifts[table.roll > 0])
    assert table[7].inputs.yaw == 1e-3 and table[7].inputs.lateral_shift == shifts[7]


def test_the_summary_of_a_pose(state):
    said = state.summary
    assert said.startswith("valid; roll -0.0") and f"{state.right.max_pressure / 1e6:.1f} MPa" in said
    assert (
        "right 2 patches" in said
        and f"left 1 patch, {math.degrees(state.left.contact_angle):.4f} deg" in said
    )
    assert SYSTEM.evaluate(lateral_shift=0.05).summary == "off profile"
    assert SYSTEM.evaluate(lateral_shift=0.0, outputs=["right.area"]).summary.count("right") == 1


@pytest.mark.parametrize("method, package", [("to_pandas", "pandas"), ("to_xarray", "xarray")])
def test_a_missing_package_is_one_sentence(monkeypatch, table, method, package):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ImportError, match=f"{method} needs {package}, .*pip install {package}"):
        getattr(table, method)()
