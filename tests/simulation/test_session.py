"""The session and the table of variables, with a kernel whose answers are known: sums of its inputs."""

import math

import pytest

from tests.helpers.damages import damages
from tests.helpers.fake_system import FakeSystem
from tests.helpers.faults import needs_linux
from wrcontact.interface.variables import (
    FIRST_OUTPUT,
    FIRST_WEAR,
    INPUT,
    OUTPUT,
    PARAMETER,
    PLACE,
    REFERENCE,
    STATUS,
    UNITS,
    VARIABLES,
    documented,
    select,
)
from wrcontact.kernel import layout
from wrcontact.simulation import session as module
from wrcontact.simulation.session import Refused, Session

#: Sum of the starts of all inputs but the load: free_rolling is on, and there is friction on both sides.
STARTS = 1.0 + 2 * 0.3
SHIFT, FORCE = (REFERENCE[name] for name in ("lateral_shift", "normal_force"))


@pytest.fixture
def lines():
    return []


@pytest.fixture
def session(monkeypatch, lines):
    monkeypatch.setattr(module, "ContactSystem", FakeSystem)
    monkeypatch.setattr(FakeSystem, "made", [])
    return Session(log=lines.append)


@pytest.fixture
def running(session):
    session.start()
    return session


def roll(session):
    return session.get_reals([REFERENCE["roll"]])[0]


# --- table ------------------------------------------------------------------------------------------


def test_outputs_lie_in_the_order_of_the_kernel():
    assert [v.index for v in VARIABLES[: layout.INPUT_COUNT]] == list(range(layout.INPUT_COUNT))
    wear = 2 * layout.WEAR_RUN_COUNT * layout.STATION_COUNT
    row = layout.OUTPUT_COUNT + wear
    assert [v.index for v in VARIABLES[FIRST_OUTPUT:STATUS]] == list(range(row))
    assert VARIABLES[FIRST_WEAR].index == layout.OUTPUT_COUNT
    assert select(INPUT) + select(PARAMETER) + select(OUTPUT) == list(VARIABLES)


@pytest.mark.parametrize(
    "name, index",
    [
        ("roll", layout.OUT_ROLL),
        ("force.z", layout.OUT_FORCE + 2),
        ("moment.x", layout.OUT_MOMENT),
        ("left.contact.y_rail", layout.OUT_LEFT + layout.SIDE_Y_RAIL),
        ("right.curvature_y", layout.OUT_RIGHT + layout.SIDE_CURVATURE_Y),
        (
            "right.patch[2].width",
            layout.OUT_RIGHT
            + layout.SIDE_PATCH
            + layout.PATCH_OUTPUTS_SIZE
            + layout.PatchOutputs.width.offset // 8,
        ),
        ("left.half_length[31]", layout.OUT_LEFT + layout.SIDE_HALF_LENGTH + 30),
    ],
)
def test_names_point_to_the_right_place(name, index):
    assert VARIABLES[PLACE[name]].index == index


def test_names_are_unique_and_every_real_has_a_unit():
    assert len(REFERENCE) == len(VARIABLES)
    assert all(v.unit in UNITS for v in VARIABLES if v.type == "Real")


def test_documented_rows_fold_sides_patches_and_stations():
    names = [name for name, _ in documented()]
    assert {"side.patch[k].area", "side.station[j]", "roll"} <= set(names)
    # folded: a sixth of the outputs, and the inputs and parameters
    assert len(names) == len(set(names)) < layout.OUTPUT_COUNT / 6 + 80


def test_values_go_by_their_numbers_where_places_differ(session, monkeypatch):
    """As when a row has been added before them."""
    turned = {len(VARIABLES) - number: v for number, v in module.BY_REFERENCE.items()}
    monkeypatch.setattr(module, "BY_REFERENCE", turned)
    number = {v.name: found for found, v in turned.items()}
    session.set_reals([number["lateral_shift"], number["gauge"]], [2.0, 1.5])
    session.set_booleans([number["free_rolling"]], [False])
    session.start()
    session.set_reals([number["lateral_shift"]], [3.0])
    read = [number[name] for name in ("gauge", "lateral_shift", "yaw", "roll", "right.slip[31]")]
    first = 3.0 + 78500.0 + STARTS - 1.0 + 0.2  # free_rolling is off, the second step
    assert session.get_reals(read) == pytest.approx([1.5, 3.0, 0.0, first, first + layout.OUTPUT_COUNT - 1])
    assert session.get_booleans([number["free_rolling"]]) == [False]
    assert session.get_integers([number["status"]]) == [0]


# --- life cycle -------------------------------------------------------------------------------------


def test_first_instant_is_right_without_a_step(session):
    session.set_reals([SHIFT], [2.0])
    session.start()
    assert roll(session) == pytest.approx(2.0 + 78500.0 + 0.1 + STARTS)


def test_outputs_are_computed_once_per_change(running):
    running.set_reals([SHIFT, FORCE], [1.0, 10.0])
    first = roll(running)
    running.step()
    running.set_reals([SHIFT, FORCE], [1.0, 10.0])
    running.step()
    assert roll(running) == first
    assert running.evaluations == 2


def test_values_are_read_in_any_order_and_any_number(running):
    references = [
        REFERENCE["right.slip[31]"],
        REFERENCE["gauge"],
        SHIFT,
        REFERENCE["roll"],
        REFERENCE["roll"],
    ]
    values = running.get_reals(references)
    assert values[0] == values[3] + layout.OUTPUT_COUNT - 1 and values[1:3] == [1.435, 0.0]
    assert values[3] == values[4]
    assert running.get_reals(references[:1]) == values[:1]
    integers = running.get_integers([REFERENCE["status"], REFERENCE["left.patch_count"]])
    assert integers == [0, int(values[3]) + layout.OUT_LEFT]
    assert running.get_strings([REFERENCE["rail_profile"]]) == ["UIC60"]


def test_parameters_reach_the_system_under_their_keywords(session):
    session.set_reals([REFERENCE["gauge"]], [1.44])
    session.set_strings([REFERENCE["wheel_profile"]], ["Cone20"])
    session.start()
    assert (FakeSystem.made[-1]["gauge"], FakeSystem.made[-1]["wheel"]) == (1.44, "cone20")


def test_profile_file_in_the_resources_is_found_by_its_name(session, tmp_path):
    (tmp_path / "own.txt").write_text("")
    session.resources = str(tmp_path)
    session.set_strings([REFERENCE["rail_profile"]], ["own.txt"])
    session.start()
    assert FakeSystem.made[-1]["rail"] == str(tmp_path / "own.txt")
    assert FakeSystem.made[-1]["wheel"] == "S1002"


def test_no_file_outside_the_resources_is_read(session, tmp_path, monkeypatch):
    """Neither by its path, from the root or upwards, nor by a link, nor beside the host: one sentence, with
    the parameter's name.  The resources themselves may lie behind a link."""
    place, secret = tmp_path / "resources" / "worn", tmp_path / "secret.txt"
    place.mkdir(parents=True)
    secret.write_text("")
    (place / "own.txt").write_text("")
    (place / "link.txt").symlink_to(secret)
    (tmp_path / "entry").symlink_to(place.parent)
    monkeypatch.chdir(tmp_path)
    session.resources = str(tmp_path / "entry")
    for parameter in ("wheel_profile", "left_rail_profile"):
        for name in (
            str(secret),
            "../secret.txt",
            "worn/../../secret.txt",
            "secret.txt",
            "worn/link.txt",
            ".",
            "worn",
            "x" * 5000,
        ):
            session.reset()
            session.set_strings([REFERENCE[parameter]], [name])
            with pytest.raises(Refused, match=f"{parameter} is .*; permitted are .* FMU's resources$"):
                session.start()
    session.reset()
    session.set_strings([REFERENCE["wheel_profile"]], ["worn/own.txt"])
    session.start()
    assert FakeSystem.made[-1]["wheel"] == str(place / "own.txt")


def test_system_is_built_once_unless_a_parameter_changes(session):
    session.initialise()
    session.start()
    assert len(FakeSystem.made) == 1
    session.reset()
    session.initialise()
    session.set_reals([REFERENCE["gauge"]], [1.5])
    session.start()
    assert [made["gauge"] for made in FakeSystem.made[1:]] == [1.435, 1.5]


def test_wrong_parameter_is_refused_and_can_be_mended(session):
    session.set_reals([REFERENCE["gauge"]], [14.35])
    with pytest.raises(Refused, match="gauge is 14.35 m"):
        session.initialise()
    session.set_reals([REFERENCE["gauge"]], [1.4])
    session.start()
    assert session.status == 0


def test_parameters_are_fixed_once_the_simulation_runs(running):
    running.set_reals([REFERENCE["gauge"]], [1.435])
    with pytest.raises(Refused, match="gauge is fixed at 1.435"):
        running.set_reals([REFERENCE["gauge"]], [1.5])
    assert running.get_reals([REFERENCE["gauge"]]) == [1.435]


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda s: s.set_reals([REFERENCE["roll"]], [1.0]), "roll is an output"),
        (lambda s: s.set_integers([REFERENCE["status"]], [1]), "status is an output"),
        (lambda s: s.get_reals([REFERENCE["status"]]), "status is of type Integer"),
        (lambda s: s.get_reals([REFERENCE["load"]]), "load is of type String"),
        (lambda s: s.get_integers([len(VARIABLES)]), f"{len(VARIABLES)} does not exist"),
        (lambda s: s.get_reals([-1]), "-1 does not exist"),
        (lambda s: s.set_reals([-1], [0.0]), "-1 does not exist"),
    ],
)
def test_misuse_is_refused(running, call, words):
    with pytest.raises(Refused, match=words):
        call(running)


def test_reset_brings_back_the_start(running):
    running.set_reals([SHIFT], [3.0])
    running.step()
    running.reset()
    assert running.get_reals([SHIFT, FORCE]) == [0.0, 78500.0]
    running.start()
    assert roll(running) == pytest.approx(78500.1 + STARTS)


# --- status -----------------------------------------------------------------------------------------


def test_one_line_per_step_whose_status_is_not_zero(running, lines):
    running.set_reals([FORCE], [-5.0])
    roll(running)
    running.step()
    assert len(lines) == 1 and "normal_force" in lines[0] and "-5" in lines[0]
    running.step()
    assert len(lines) == 2
    running.set_reals([FORCE], [5e4])
    running.step()
    assert running.status == 0 and len(lines) == 2


@pytest.mark.parametrize("load, words", [(78.5, "normal_force is 78.5 N"), (78.5e6, "is 7.85e+07 N")])
def test_an_unusual_load_is_logged_once(running, lines, load, words):
    """78.5 for 78.5 kN; not a load of zero, which lifts a wheel."""
    running.set_reals([FORCE], [0.0])
    running.step()
    lines.clear()
    for factor in (1.0, 1.1):
        running.set_reals([FORCE], [load * factor])
        running.step()
    assert len(lines) == 1 and words in lines[0] and "usual is 500 ... 1e+06 N" in lines[0]
    running.reset()
    running.start()
    running.set_reals([FORCE], [load])
    running.step()
    assert len(lines) == 2


def test_invalid_input_keeps_the_last_outputs(running):
    before = roll(running)
    running.set_reals([SHIFT], [math.nan])
    running.step()
    assert (roll(running), running.status) == (before, 4)
    running.set_reals([SHIFT], [1.0])
    assert running.get_reals([SHIFT]) == [1.0] and roll(running) == pytest.approx(before + 1.1)


def test_invalid_start_is_logged_at_the_first_instant(session, lines):
    session.set_reals([FORCE], [-1.0])
    session.start()
    assert session.status == 4 and len(lines) == 1
    session.step()
    assert len(lines) == 2


def test_values_are_set_completely_or_not_at_all(running):
    with pytest.raises(Refused, match="roll is an output"):
        running.set_reals([SHIFT, REFERENCE["roll"]], [1.0, 1.0])
    with pytest.raises(Refused, match="load is fixed at 'normal'"):
        running.set_strings([REFERENCE["load"]], ["vertical"])
    with pytest.raises(Refused, match="load is a NULL pointer"):
        running.set_strings([REFERENCE["load"]], [None])
    assert running.get_reals([SHIFT]) == [0.0] and running.get_strings([REFERENCE["load"]]) == ["normal"]


# --- saved states -----------------------------------------------------------------------------------


def advance(session, shifts):
    """Roll after a step at each shift."""
    seen = []
    for shift in shifts:
        session.set_reals([SHIFT], [shift])
        session.step()
        seen.append(roll(session))
    return seen


def test_snapshot_goes_on_bit_by_bit(running):
    advance(running, [0.1, 0.2])
    saved = running.snapshot()
    straight = advance(running, [0.3, 0.7, 0.9])
    running.restore(saved)
    assert advance(running, [0.3, 0.7, 0.9]) == straight
    other = Session(log=None)
    other.restore(saved)
    assert advance(other, [0.3, 0.7, 0.9]) == straight
    assert len(FakeSystem.made) == 2, "the system was built anew where it was there"


def test_snapshot_holds_parameters_and_pending_inputs(running):
    other = Session(log=None)
    other.set_reals([REFERENCE["gauge"]], [1.5])
    other.start()
    other.set_reals([SHIFT], [0.5])
    running.restore(other.snapshot())
    assert running.get_reals([REFERENCE["gauge"], SHIFT]) == [1.5, 0.5]
    assert roll(running) == roll(other)


@pytest.mark.parametrize("mode", ["elastic", "compliant"])
def test_snapshot_of_a_real_wheelset_goes_on_bit_by_bit(mode):
    """With the kernel itself: its state and the inputs are all that decides how it goes on."""
    session, other = Session(log=None), Session(log=None)
    session.set_strings([REFERENCE["contact_mode"]], [mode])
    session.set_reals([REFERENCE["vertical_shift_input"]], [0.25e-3])
    session.start()
    advance(session, [1e-3, 1.1e-3])
    other.restore(session.snapshot())
    shifts = [1.2e-3, 4e-3, 4.01e-3]
    assert advance(session, shifts) == advance(other, shifts)
    reals = [REFERENCE[v.name] for v in select(OUTPUT, "Real")]
    assert session.get_reals(reals) == other.get_reals(reals)
    assert session.status == 0


def test_snapshot_before_initialisation(session):
    session.set_reals([REFERENCE["gauge"]], [1.5])
    saved = session.snapshot()
    session.start()
    session.restore(saved)
    assert not session.machine.locked
    session.set_reals([REFERENCE["gauge"]], [1.6])
    session.start()
    assert FakeSystem.made[-1]["gauge"] == 1.6


def test_state_of_another_build_is_refused(running, monkeypatch):
    saved = running.snapshot()
    monkeypatch.setattr(module, "BUILD", "wrcontact_0123")
    with pytest.raises(Refused, match="comes from wrcontact, this is wrcontact_0123"):
        running.restore(saved)


@needs_linux
@pytest.mark.parametrize("count", [500, pytest.param(20_000, marks=pytest.mark.full)])
def test_damaged_states_of_a_session_are_refused(count):
    """Those of the FMUs are in tests/fmu."""
    one, other = (Session(log=lambda sentence: None) for _ in range(2))
    for session in (one, other):
        session.start()
        session.set_reals([0, 1], [3e-3, 1e-3])
        session.step()
    for name, bad in damages(one.snapshot(), 3, count):
        with pytest.raises(Refused, match="the saved state .*; the present state is kept"):
            one.restore(bad)
            pytest.fail(name)
    for session in (one, other):
        session.set_reals([0], [6e-3])
    assert one.get_reals([REFERENCE["roll"]]) == other.get_reals([REFERENCE["roll"]]) and one.status == 0
