"""Directional derivatives of the kernel against central differences of its steps, at jumps too."""

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import input_row
from tests.helpers.derivatives import (
    AGREE,
    CLEAR,
    COMPLIANT_INPUTS,
    CONTINUOUS,
    INPUTS,
    KINK,
    NOMINAL,
    USUAL,
    derivative,
    differences,
    poses,
    scale,
    stepped,
)
from tests.helpers.fuzzing import cut
from tests.helpers.inside import rates_along, solver_of, workspace_of
from tools.differentiate import derivative_modules
from tools.transpile_kernel import source_modules
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel
from wrcontact.kernel.layout import (
    IN_LATERAL_SHIFT,
    IN_LOAD_TRANSFER,
    IN_NORMAL_FORCE,
    IN_ROLL,
    IN_ROLL_GUESS,
    IN_VERTICAL_SHIFT,
    IN_YAW,
    INPUT_COUNT,
    OUT_LEFT,
    OUT_RIGHT,
    OUTPUT_COUNT,
    SIDE_SIZE,
)

pytestmark = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)

RAILS = range(layout.IN_LEFT_RAIL_LATERAL, layout.IN_RIGHT_RAIL_ROLL + 1)
#: Parameters, and the share of clear differences that may be off: some lie across a kink that neither their
#: steps nor the shortest ones notice; the source's curvatures have one at each of their nodes. Of rigid
#: strips 0.7e-3 ... 2.8e-3 are, from seed to seed (11 ... 18).
CASES = {
    "hertz": ({"normal_model": "hertz"}, 0.0),
    "analyn": ({}, 1e-3),
    "vertical load": ({"load": "vertical"}, 1e-3),
    # 3.8e-3 measured: runs that a shoulder joins or parts are kinks too
    "strip": ({"normal_model": "analyn_strip"}, 5e-3),
    "elastic hertz": ({"contact_mode": "elastic", "normal_model": "hertz"}, 1e-3),
    "elastic": ({"contact_mode": "elastic"}, 1.5e-3),
    "elastic strip": ({"contact_mode": "elastic", "normal_model": "analyn_strip"}, 1e-2),
    "compliant": ({"contact_mode": "compliant"}, 1e-3),
    "vertical separation": ({"separation": "vertical"}, 1e-3),
    "equidistant": ({"separation": "equidistant", "longitudinal_curvature": "basic"}, 3e-3),
    "chord, elastic": (
        {"separation": "equidistant_chord", "contact_mode": "elastic", "load": "vertical"},
        1e-3,
    ),
    "smooth": ({"lateral_curvature": "smooth"}, 1e-3),
    "rough": ({"lateral_curvature": "rough"}, 1e-3),
}
#: Share of differences that are clear at least. Strips have many kinks, at every line of their table along
#: e^2 / (1 + e^2) and where a patch ends: fewer of their differences agree with each other.
USUALLY, STRIPS = 0.9, 0.75
QUICK = ("hertz", "analyn", "elastic hertz", "compliant")


@pytest.mark.parametrize(
    "case", [pytest.param(case, marks=[pytest.mark.full] * (case not in QUICK)) for case in CASES]
)
def test_derivatives_are_those_of_differences(case):
    """All continuous outputs against all inputs at random poses.

    Differences that agree best may all lie across one kink: with strips one is 20 nm from the first pose. The
    forces there are off by 2e-6 together, of the wheelset, the wheel and its patch, over steps of 30 nm and
    more, while derivatives agree with steps of 4 ... 16 nm to 2e-8. So what is off is held against those."""
    parameters, kinked = CASES[case]
    mode = parameters.get("contact_mode", "rigid")
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    deviations, spreads = [], []
    for row in poses(8, seed=11, mode=mode):
        for number in COMPLIANT_INPUTS if mode == "compliant" else INPUTS:
            status, rates = derivative(stepper, row, number)
            assert status <= layout.UNLOADED and np.isfinite(rates).all()
            wanted, apart, near = differences(stepper, row, number)
            size = scale(rates, number)
            deviation = np.abs(rates - wanted) / size
            across = (deviation > AGREE) & (np.abs(rates - near) <= AGREE * size)
            deviations.append(np.where(across, np.abs(rates - near) / size, deviation)[CONTINUOUS])
            spreads.append((apart / size)[CONTINUOUS])
    deviations, spreads = np.concatenate(deviations), np.concatenate(spreads)
    clear = spreads <= CLEAR
    assert clear.mean() > (STRIPS if "strip" in case else USUALLY)
    assert (deviations[clear] > AGREE).mean() <= kinked and deviations[clear].max() < KINK
    assert np.median(deviations) < 3e-8


@pytest.mark.parametrize("case", ["hertz", "analyn", "elastic", "compliant"])
def test_derivatives_add_up(case):
    """Along several inputs at once it is the sum."""
    parameters, _ = CASES[case]
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    row = poses(4, seed=3, mode=parameters.get("contact_mode", "rigid"))[3]
    seed = USUAL * np.resize([1.0, -2.0, 3.0, 0.5, -1.0, 0.01, 0.02], INPUT_COUNT)
    total = derivative(stepper, row, seed)[1]
    parts = np.array([derivative(stepper, row, number)[1] * seed[number] for number in range(INPUT_COUNT)])
    rounding = 1e-10 * np.abs(parts).max(axis=0) + 1e-12 * NOMINAL
    assert (np.abs(total - parts.sum(axis=0)) <= rounding).all()


def jump(stepper, row):
    """Lateral shifts 1e-12 m apart between which the right contact jumps."""

    def contact(shift):
        row[IN_LATERAL_SHIFT] = shift
        return stepped(stepper, row)[1][OUT_RIGHT + layout.SIDE_Y_WHEEL]

    shifts = np.linspace(4e-3, 7e-3, 301)
    places = np.array([contact(shift) for shift in shifts])
    k = np.abs(np.diff(places)).argmax()
    low, high, before, after = shifts[k], shifts[k + 1], places[k], places[k + 1]
    assert abs(after - before) > 2e-3
    while high - low > 1e-12:
        middle = 0.5 * (low + high)
        if abs(contact(middle) - before) < abs(contact(middle) - after):
            low = middle
        else:
            high = middle
    return low, high


@pytest.mark.parametrize("yaw", [0.0, 0.01])
def test_at_a_jump_the_derivative_is_that_of_its_side(yaw):
    stepper = wrcontact.ContactSystem(normal_model="hertz").stepper()
    row = input_row(0.0, yaw, 0.0, 8e4, 0.1)
    sides = []
    for shift, sign in zip(jump(stepper, row), (-1.0, 1.0)):
        for number in INPUTS:
            row[IN_LATERAL_SHIFT] = shift
            here = derivative(stepper, row, number)[1]
            row[IN_LATERAL_SHIFT] = shift + sign * 1e-9
            near = derivative(stepper, row, number)[1]
            # 1 nm over the millimetre in which curvatures change
            assert (np.abs(here - near) <= 1e-4 * scale(here, number)).all()
            sides.append(here)
    # the roll goes on otherwise
    assert abs(sides[0][0] - sides[len(INPUTS)][0]) > 1e-3 * abs(sides[0][0])


def test_elastic_stand_on_a_jump_moves_with_it():
    """The right wheel's deepest point changes between root and flange there: heights are those of
    brackets, not of an equation."""
    stepper = wrcontact.ContactSystem(contact_mode="elastic", normal_model="hertz").stepper()
    row = input_row(4.88004678e-03, 1.23176316e-02, 0.0, 5.00121932e04, -5.35283157e-01)
    for number in INPUTS:
        status, rates = derivative(stepper, row, number)
        wanted, _, _ = differences(stepper, row, number)
        assert status == layout.VALID
        # brackets end at 1e-13 m, and these differences are over 1e-4 of nominal inputs
        assert rates[:2] == pytest.approx(wanted[:2], rel=1e-3)
    # as if all regions stayed the roll would go the other way
    assert derivative(stepper, row, IN_LATERAL_SHIFT)[1][layout.OUT_ROLL] > 1.0


def test_what_does_not_move():
    """The roll's guess moves nothing, an unloaded wheel's patch stays empty, and held outputs are held."""
    stepper = wrcontact.ContactSystem().stepper()
    row = input_row(2e-3, 5e-3, 0.0, 8e4, 1.0)
    status, rates = derivative(stepper, row, IN_LATERAL_SHIFT)
    left = rates[OUT_LEFT : OUT_LEFT + SIDE_SIZE]
    assert status == layout.UNLOADED and np.isfinite(rates).all()
    assert left[layout.SIDE_Y_WHEEL] != 0.0 and not left[layout.SIDE_PENETRATION :].any()
    assert not derivative(stepper, row, IN_ROLL_GUESS)[1].any()
    for bad, wanted in (
        ({IN_LATERAL_SHIFT: 0.02}, layout.OFF_PROFILE),
        ({IN_NORMAL_FORCE: np.nan}, layout.INVALID_INPUT),
    ):
        wrong = row.copy()
        wrong[list(bad)] = list(bad.values())
        status, rates = derivative(stepper, wrong, IN_LATERAL_SHIFT)
        assert status == wanted and not rates.any()


@pytest.mark.parametrize("held", [1.0, -1e3, np.nan])
@pytest.mark.parametrize("case", ["analyn", "elastic strip", "compliant"])
def test_what_the_memory_of_a_derivative_held_before_does_not_count(case, held):
    parameters, _ = CASES[case]
    stepper = wrcontact.ContactSystem(**parameters, tangential_model="strips").stepper()
    row = poses(1, seed=3, mode=parameters.get("contact_mode", "rigid"))[0]
    row[[layout.IN_SPEED, layout.IN_FREE_ROLLING]] = 20.0, 1.0
    row[[layout.IN_LEFT_FRICTION, layout.IN_RIGHT_FRICTION]] = 0.3
    expected = derivative(stepper, row, IN_YAW)[1]
    solver_of(stepper)._room[:] = held
    assert expected.any() and np.array_equal(derivative(stepper, row, IN_YAW)[1], expected)


@pytest.mark.parametrize("case", ["analyn", "elastic"])
def test_nothing_else_changes(case):
    parameters, _ = CASES[case]
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    for row in poses(4, seed=8):
        stepped(stepper, row)
        before = [
            array.copy() for array in (stepper.state, workspace_of(stepper), stepper.inputs, stepper.outputs)
        ]
        derivative_again = [rates_along(stepper, np.eye(INPUT_COUNT)[0]) for _ in range(2)]
        after = (stepper.state, workspace_of(stepper), stepper.inputs, stepper.outputs)
        assert all(np.array_equal(one, other, equal_nan=True) for one, other in zip(before, after))
        assert np.array_equal(*derivative_again)


def test_a_width_that_ends_where_there_is_no_gap():
    """A pose whose derivatives were no numbers: halving ends on the last place that has a
    gap, where that does not rise."""
    stepper = wrcontact.ContactSystem(contact_mode="compliant", normal_model="analyn_strip").stepper()
    row = input_row(
        0.00524538460052467,
        0.07927101240045407,
        0.0,
        78.5e3,
        0.0,
        -0.0008804023341258616,
        -0.0017729272540683517,
    )
    for number in range(INPUT_COUNT):
        status, rates = derivative(stepper, row, number)
        assert status == 0 and np.isfinite(rates).all()
        assert rates.any() == (number in (IN_LATERAL_SHIFT, IN_YAW, IN_ROLL, IN_VERTICAL_SHIFT, *RAILS))


#: The right wheel's patch at 10 kN reaches over an end of the wheel: over its outer one on a wide gauge, or over the one
#: of a wheel whose inner part is cut off [mm].
ENDS = {
    "outer, 0.2 mm left": ({"gauge": 1.57055}, 1e-5),
    "outer, 1 mm left": ({"gauge": 1.56895}, 1e-5),
    "inner, 0.3 mm left": ({"wheel": cut("S1002", start=-13.4)}, 3e-3),
    "inner, 1 mm left": ({"wheel": cut("S1002", start=-17.73)}, 4.5e-3),
}


@pytest.mark.filterwarnings("ignore::wrcontact.ProfileWarning")
@pytest.mark.parametrize("case", ENDS)
def test_a_patch_that_ends_where_the_wheel_ends_has_the_derivatives_of_differences(case):
    """The end stays where it is on the wheel: the patch there becomes wider or narrower as the wheel moves, and its
    load is no longer the same."""
    parameters, shift = ENDS[case]
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    row = input_row(shift, 0.0, 0.0, 10e3, 0.0)
    for number in (IN_LATERAL_SHIFT, IN_NORMAL_FORCE):
        status, rates = derivative(stepper, row, number)
        wanted, apart, _ = differences(stepper, row, number)
        size = scale(rates, number)
        clear = CONTINUOUS & (apart <= CLEAR * size)
        assert status == 0 and clear.sum() > 0.9 * CONTINUOUS.sum()
        assert np.max(np.abs(rates - wanted)[clear] / size[clear]) < KINK / 10


@pytest.mark.full
@pytest.mark.parametrize("case", ["hertz", "analyn", "strip", "elastic", "compliant"])
def test_derivatives_are_numbers(case):
    """Far out, too, and where a wheel carries nothing."""
    parameters, _ = CASES[case]
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    rng = np.random.default_rng(8)
    for row in poses(300, seed=8, mode=parameters.get("contact_mode", "rigid")):
        row[IN_LOAD_TRANSFER] = rng.choice([-1.0, 1.0, row[IN_LOAD_TRANSFER]])
        row[IN_NORMAL_FORCE] = rng.choice([0.0, 1e-3, row[IN_NORMAL_FORCE], row[IN_NORMAL_FORCE]])
        assert np.isfinite(derivative(stepper, row, int(rng.integers(INPUT_COUNT)))[1]).all(), row.tolist()


@pytest.fixture(scope="module")
def differentiated(tmp_path_factory):
    """The differentiated kernel as Python, beside a copy of the kernel: the module
    with ``differentiate_t``."""
    folder = tmp_path_factory.mktemp("differentiated") / "differentiated_kernel"
    folder.mkdir()
    (folder / "__init__.py").touch()
    modules = source_modules()
    for module in modules:
        text = module.text
        if "native" in module.marks.values():  # without its bodies, which C has by itself
            names = ", ".join(module.functions)
            text = f"from wrcontact.kernel.{module.room}.{module.name} import {names}\n".encode()
        Path(folder, f"{module.name}.py").write_bytes(text)
    for name, text in derivative_modules(modules).items():
        Path(folder, f"{name}.py").write_text(text, encoding="utf-8")
    sys.path.insert(0, str(folder.parent))
    yield [
        importlib.import_module(f"differentiated_kernel.{name}")
        for name in ("derivative_wheelset_rules", "step")
    ]
    sys.path.remove(str(folder.parent))


@pytest.mark.full
@pytest.mark.parametrize("case", ["hertz", "analyn", "strip", "elastic hertz", "compliant", "equidistant"])
def test_compiled_and_python_derivatives_agree_to_the_last_bit(differentiated, case):
    parameters, _ = CASES[case]
    derivatives, step = differentiated
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    for row in poses(2, seed=2, mode=parameters.get("contact_mode", "rigid")):
        for number in (IN_YAW, IN_NORMAL_FORCE):
            rates = derivative(stepper, row, number)[1]
            work, state, outputs = [0.0] * layout.WORK_SIZE, stepper.state.tolist(), [0.0] * OUTPUT_COUNT
            tables = stepper.tables.tolist()
            assert step.step(tables, state, work, row.tolist(), outputs) <= layout.UNLOADED
            work_t = [0.0] * layout.WORK_SIZE
            work_t[layout.Work.inputs.offset // 8 + number] = 1.0
            assert not derivatives.differentiate_t(tables, work, work_t)
            assert np.array_equal(rates, work_t[layout.Work.outputs.offset // 8 :][:OUTPUT_COUNT])
