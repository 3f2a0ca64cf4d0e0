"""The linear wheelset.

Witnesses: potential energy, Kalker's linear theory in closed form, the state matrix of data/hunting_theory.py, which
has nothing of the package, Klingel's wave, first harmonics of the forces, and runs in time.
"""

import numpy as np
import pytest
from scipy.optimize import root

import wrcontact
from data import hunting_theory as theory
from examples import critical_speed as example
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
WEIGHT = 157e3  # [N], of both wheels
CONES = {"wheel": "cone20", "rail_inclination": 0.05, "normal_model": "hertz", "tangential_model": "strips"}
#: Far from the limit of friction creep forces are linear.
STICKY = {"left_friction": 2.0, "right_friction": 2.0}
SUSPENSION = {"longitudinal_stiffness": 3.6e5, "lateral_stiffness": 2e5}


@pytest.fixture(scope="module")
def cones():
    return wrcontact.ContactSystem(**CONES)


@pytest.fixture(scope="module")
def pair(cones):
    return cones.linearize(speed=20.0, **STICKY).condensed()


def second_difference(system, name, step):
    """Of the height of a rigid wheelset [m] by an input."""
    found = system.evaluate_many(**{name: step * np.array([-1.0, 0.0, 1.0])}, outputs=["vertical_shift"])
    return float(found.vertical_shift @ [1.0, -2.0, 1.0]) / step**2


def test_gravitational_stiffness_is_that_of_the_potential_energy(cones, pair):
    """Rolling without friction a weight W stands at the height -z: its energy is -W z.  The elastic wheelset
    differs from the rigid one by 0.3 %."""
    stiff = pair.normal_stiffness
    assert stiff[0, 0] == pytest.approx(-WEIGHT * second_difference(cones, "lateral_shift", 1e-3), rel=5e-3)
    assert stiff[1, 1] == pytest.approx(-WEIGHT * second_difference(cones, "yaw", 5e-3), rel=5e-3)
    assert stiff[0, 1] == pytest.approx(0.0, abs=1e-3 * stiff[0, 0])
    # the yaw's, with the arm b of the contacts: -W tan(cone) (b - r tan(cone))
    arm = cones.evaluate(0.0).right.contact.y_track
    assert stiff[1, 1] == pytest.approx(-WEIGHT * 0.05 * (arm - 0.46 * 0.05), rel=5e-3)


def test_creep_matrices_are_kalkers(cones):
    """To the first power of the cone: V D and K of the wheelset before anything follows anything."""
    whole = cones.linearize(speed=20.0, **STICKY)
    one, radius = whole.patches[0], 0.46
    arm = cones.evaluate(0.0).right.contact.y_track
    damping, stiffness = 20.0 * whole.damping, whole.creep_stiffness
    assert damping[0, 0] == pytest.approx(2.0 * one.f22, rel=0.015)
    assert damping[0, 2] == pytest.approx(-2.0 * one.f22 * (radius + 0.05 * arm), rel=0.015)
    assert damping[3, 3] == pytest.approx(2.0 * (one.f11 * arm**2 + one.f33), rel=0.015)
    assert damping[0, 3] == pytest.approx(2.0 * one.f23, rel=0.07)
    assert damping[3, 0] == pytest.approx(-2.0 * one.f23, rel=0.07)
    assert stiffness[0, 3] == pytest.approx(-2.0 * one.f22, rel=0.015)
    assert stiffness[3, 0] == pytest.approx(2.0 * one.f11 * arm * 0.05 / radius, rel=0.03)


@pytest.mark.parametrize("speed", [10.0, 40.0, 80.0])
def test_roots_are_those_of_linear_theory(cones, speed):
    """Two frictions give the roots without a limit of friction, as tests/loop/test_hunting.py explains."""
    model = theory.cones(cones.evaluate(0.0).right.contact.y_track, SUSPENSION)
    roots = [
        cones.linearize(speed=speed, left_friction=friction, right_friction=friction).hunting_root(
            [1500.0, 1500.0, 900.0, 900.0], stiffness=[4e5, 0.0, 0.0, 7.2e5], inertia_pitch=120.0
        )
        for friction in (2.0, 1.0)
    ]
    found, wanted = 2.0 * roots[0] - roots[1], theory.hunting_root(theory.state_matrix(model, speed))
    assert found.imag == pytest.approx(wanted.imag, rel=1e-3)
    assert found.real == pytest.approx(wanted.real, abs=1e-3 * wanted.imag)


def test_two_degrees_of_freedom_hunt_with_klingels_wave(cones):
    """A free wheelset whose mass is negligible, at 1 m/s, by the geometry of rigid contact: L = 2 pi sqrt(b r
    (1 - r roll / y) / conicity), docs/reference/conventions.md."""
    swing = cones.linearize(speed=1.0, **STICKY).condensed().hunting_root([1.0, 1.0])
    beside, shift = cones.evaluate(1e-3), 1e-3
    conicity = (beside.right.rolling_radius - beside.left.rolling_radius) / (2.0 * shift)
    arm = cones.evaluate(0.0).right.contact.y_track
    wave = 2.0 * np.pi * np.sqrt(arm * 0.46 * (1.0 - 0.46 * beside.roll / shift) / conicity)
    assert 2.0 * np.pi * 1.0 / swing.imag == pytest.approx(wave, rel=3e-3)


def test_gyroscopic_moments_are_those_of_a_top(cones):
    """A wheelset that yaws to the right turns the axle's angular momentum: forward rolling is about -y."""
    whole = cones.linearize(speed=20.0)
    momentum = -120.0 * whole.wheel_rate * np.array([0.0, 1.0, 0.0])
    gyroscopic = whole.gyroscopic(120.0)
    for place, axis in ((3, [0.0, 0.0, 1.0]), (2, [1.0, 0.0, 0.0])):
        needed = np.cross(axis, momentum)  # moment that turns it at 1 rad/s
        np.testing.assert_allclose(gyroscopic[[2, 3], place], needed[[0, 2]], rtol=1e-12)
    assert whole.wheel_rate == pytest.approx(20.0 / 0.46, rel=1e-3)


def test_every_contact_mode_has_the_same_matrices():
    found = [
        wrcontact.ContactSystem(**CONES, contact_mode=mode).linearize(speed=20.0, lateral_shift=1e-3)
        for mode in ("rigid", "elastic", "compliant")
    ]
    for other in found[1:]:
        assert (other.stiffness == found[0].stiffness).all() and (other.damping == found[0].damping).all()


def test_off_the_centre_the_forces_change_as_the_matrices_say():
    """Forces of poses beside the steady motion, and its load transfer as a moment."""
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="strips")
    at = {"lateral_shift": 2e-3, "yaw": 3e-3, "speed": 25.0, "load_transfer": 0.1}
    linear = system.linearize(**at)
    assert linear.forces[1] == pytest.approx(-WEIGHT, rel=1e-8)
    assert linear.forces[2] == pytest.approx(-0.1 * WEIGHT * 0.75, rel=1e-7)
    move = np.array([2e-8, 1e-8, -1e-8, 3e-8])

    def forces(way):
        y, z, roll, yaw = np.array(linear.place) + way * move
        given = {**at, "lateral_shift": y, "yaw": yaw, "vertical_shift_input": z, "roll_input": roll}
        state = system.evaluate(**given)
        about = state.moment
        return np.array(
            [state.force.y, state.force.z, about.x * np.cos(yaw) + about.y * np.sin(yaw), about.z]
        )

    change = (forces(1.0) - forces(-1.0)) / 2.0
    np.testing.assert_allclose(change, -linear.stiffness @ move, rtol=1e-3, atol=1e-3)


def test_condensing_keeps_the_slow_response():
    """The forces at the coordinates that are kept, at s = 1e-4 rad/s, by the whole dynamic stiffness."""
    whole = wrcontact.ContactSystem(tangential_model="strips").linearize(speed=30.0, lateral_shift=1e-3)
    few = whole.condensed(["yaw", "lateral_shift"])
    s = 1e-4j
    dynamic = whole.stiffness + s * whole.damping
    a, b = [3, 0], [1, 2]
    wanted = dynamic[np.ix_(a, a)] - dynamic[np.ix_(a, b)] @ np.linalg.solve(
        dynamic[np.ix_(b, b)], dynamic[np.ix_(b, a)]
    )
    found = few.stiffness + s * few.damping
    np.testing.assert_allclose(found.real, wanted.real, rtol=1e-9)
    np.testing.assert_allclose(found.imag, wanted.imag, rtol=1e-6)
    np.testing.assert_allclose(whole.condensed(whole.coordinates).stiffness, whole.stiffness)


def test_quasi_linear_stiffness_is_the_first_harmonic_of_the_force():
    """Hertz on cones without friction: the lateral force along the swing, each place by scipy's own search, to
    1 %."""
    system = wrcontact.ContactSystem(contact_mode="compliant", normal_model="hertz", wheel="cone20")
    amplitude, count = 5e-3, 48
    found = system.linearize(amplitude=amplitude, phases=count)
    phases = 2.0 * np.pi * (np.arange(count) + 0.5) / count
    start = np.array([system.evaluate(0.0).equilibrium.vertical_shift, 0.0]) / 1e-5

    def force(shift, start):
        def missing(scaled):
            state = system.evaluate(shift, vertical_shift_input=1e-5 * scaled[0], roll_input=1e-5 * scaled[1])
            return np.array([state.force.z + WEIGHT, state.moment.x]) / 1e3

        at = root(missing, start, tol=1e-10).x
        return system.evaluate(shift, vertical_shift_input=1e-5 * at[0], roll_input=1e-5 * at[1]).force.y, at

    harmonic = 0.0
    for phase in phases:
        across, start = force(amplitude * np.sin(phase), start)
        harmonic -= 2.0 / count * across * np.sin(phase) / amplitude
    assert found.coordinates == ("lateral_shift", "yaw") and found.amplitude == amplitude
    assert found.stiffness[0, 0] == pytest.approx(harmonic, rel=0.01)
    assert abs(found.creep_stiffness).max() < 1e-6 * found.stiffness[0, 0]


def test_a_small_swing_is_the_linear_motion(cones):
    linear = cones.linearize(speed=20.0).condensed()
    swung = cones.linearize(speed=20.0, amplitude=1e-7, phases=8)
    for name in ("stiffness", "damping", "rotation"):
        one, other = getattr(linear, name), getattr(swung, name)
        np.testing.assert_allclose(other, one, rtol=1e-4, atol=1e-4 * abs(one).max())


def test_creep_falls_with_the_amplitude():
    """Large swings in yaw use up the friction: the secant falls, to 4 mu N / (pi amplitude) where all slides."""
    system = wrcontact.ContactSystem(**{**CONES, "tangential_model": "polach"})
    found = [
        system.linearize(speed=20.0, amplitude=1e-6, yaw_amplitude=yaw, phases=64).stiffness[0, 1]
        for yaw in (1e-4, 0.02)
    ]
    assert found[0] < 5.0 * found[1] < 0.0
    assert found[1] == pytest.approx(-4.0 * 0.3 * WEIGHT / (np.pi * 0.02), rel=0.15)


@pytest.mark.full
def test_critical_speed_by_eigenvalues_is_that_of_runs():
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="strips")
    critical = example.critical_speed(system, 43.0, 48.0)
    assert example.critical_speed_of_runs(system, critical) == pytest.approx(critical, rel=0.01)


@pytest.mark.full
def test_limit_cycle_is_that_of_a_run():
    """S1002 between its flanges: where the root of the quasi-linear matrices passes zero, to what the other harmonics
    leave; and a run that begins there."""
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="strips")
    shift = example.Run(system, example.CYCLE).lateral_shift(2.0, start=6.2e-3)
    found = np.ptp(shift[-len(shift) // 5 :]) / 2.0
    below, above = (
        example.swing_root(system, example.CYCLE, amplitude * found).real for amplitude in (0.75, 1.01)
    )
    assert below > 0.1 and above < -1.0, (below, above)


def test_a_run_grows_as_the_root_says():
    """Below the critical speed, for a second."""
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="strips")
    root = example.root(system, 60.0)
    shift = example.Run(system, 60.0).lateral_shift(0.7, 1e-3)
    assert example.growth(shift, 1e-3) == pytest.approx(root.real, rel=0.1)
    turns = np.flatnonzero((shift[1:-1] - shift[:-2]) * (shift[2:] - shift[1:-1]) < 0.0)[2:]
    assert np.pi / (1e-3 * np.mean(np.diff(turns))) == pytest.approx(root.imag, rel=0.02)


@pytest.mark.parametrize(
    "inputs, words",
    [
        ({}, "speed is 0"),
        ({"speed": 20.0, "roll_input": 0.0}, "roll_input is given"),
        ({"speed": 20.0, "amplitude": -1e-3}, "amplitude is -0.001"),
        ({"speed": 20.0, "frequency": 3.0}, "only with an amplitude"),
        ({"speed": 20.0, "amplitude": 1e-3, "phases": 2}, "phases is 2"),
    ],
)
def test_what_has_no_linear_motion_is_refused(cones, inputs, words):
    with pytest.raises(ValueError, match=words):
        cones.linearize(**inputs)


def test_sentences_of_the_record(cones, pair):
    with pytest.raises(ValueError, match="keep has 'jaw'.*yaw"):
        cones.linearize(speed=20.0).condensed(["jaw"])
    with pytest.raises(ValueError, match="mass is"):
        pair.state_matrix([1500.0, 0.0])
    with pytest.raises(ValueError, match=r"damping has the shape \(3,\)"):
        pair.state_matrix([1500.0, 900.0], damping=[0.0, 0.0, 0.0])
    with pytest.raises(RuntimeError, match="flange tips|no steady motion"):
        wrcontact.ContactSystem().linearize(lateral_shift=6.6e-3)
