"""Poses at which random tests have found an error once."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.contact_fuzz import LARGER, LENGTHS, differences, larger
from tests.helpers.fuzzing import RAILS, Cut
from wrcontact import Status

#: Once refused with status 3, or answered with a penetration below zero, and why.
ONCE_WRONG = {
    "a cubic between nodes fell below the smallest gap behind 5 mm of conformal flange root": (
        dict(rail="54E1", load="vertical", longitudinal_curvature="basic"),
        (0.0062163828919897905, 6.066567236501792e-10, 4.564452217957401, -0.23866685678112942),
    ),
    "likewise with true arc lengths": (
        dict(
            rail="54E1", gauge=1.4305113549748596, gauge_depth=0.010858378562526454, separation="equidistant"
        ),
        (-0.003254338123946434, -0.00017116613581495688, 15.653515755327103, 0.5867618771729588),
    ),
    "a cubic between strips did": (
        dict(
            rail="54E1",
            rail_inclination=1 / 30,
            gauge_depth=0.01146564059544422,
            load="vertical",
            normal_model="analyn_strip",
            lateral_curvature="smooth",
        ),
        (0.005679777440424658, 0.0, 0.002450529202564173, 0.0),
    ),
    "a pressed wheel's deepest point lay between two scan nodes": (
        dict(
            rail_inclination=0.05,
            gauge_depth=0.015324165046210553,
            contact_mode="elastic",
            load="vertical",
            normal_model="hertz",
            longitudinal_curvature="basic",
            nominal_radius=0.54,
        ),
        (0.006499755218311807, 0.0, 0.002346353967339998, 0.5417281106406198),
    ),
    "the overlap beside a yawed flange was measured along normals of a rail far from it": (
        dict(
            rail="54E1",
            rail_inclination=0.05,
            gauge=1.4475665265719946,
            nominal_radius=0.6030339862110008,
            contact_mode="elastic",
            normal_model="hertz",
            lateral_curvature="rough",
        ),
        (-0.009079556219458874, -0.1038165521871656, 0.04649006733406925, 0.9041416830032534),
    ),
    "two pressed regions on a conformal shelf pushed each other away": (
        dict(
            rail="60E1",
            rail_inclination=0.05,
            gauge=1.4406786721171585,
            nominal_radius=0.43672238439725314,
            contact_mode="elastic",
            normal_model="analyn_strip",
            separation="equidistant",
        ),
        (0.009189783618039796, 7.976463693736359e-05, 0.01031417556451461, 0.0),
    ),
}


@pytest.mark.parametrize("why", ONCE_WRONG, ids=lambda why: why.replace(" ", "_"))
def test_poses_that_were_wrong_once(why):
    parameters, pose = ONCE_WRONG[why]
    state = wrcontact.ContactSystem(**parameters).evaluate(*pose)
    assert state.status == Status.VALID
    assert min(state.left.penetration, state.right.penetration) > 0


#: Strips of which some pull.  Once all of them together pulled, with status 0; the direction of a force was not
#: that of its strips, so that a vertical load was missed, by a quarter where ANALYN had no answer.
ONCE_PULLING = {
    "all strips of a flange root that hardly touches": (
        dict(
            rail_inclination=0.0,
            gauge=1.4365844353041164,
            nominal_radius=0.383966012552166,
            contact_mode="compliant",
            longitudinal_curvature="basic",
            lateral_curvature="smooth",
        ),
        dict(
            lateral_shift=0.007000490498649822,
            yaw=-2.3459433332746724e-09,
            normal_force=0.4375431956075317,
            load_transfer=0.5248083326590911,
            vertical_shift_input=-0.0006852608690164824,
            roll_input=-0.0011764795821560862,
        ),
        {Status.NOT_CONVERGED},
    ),
    "all strips, where vertical parts add up to a load": (
        dict(
            nominal_radius=0.4403085046870089,
            rail_inclination=0.0,
            gauge=1.4453486547610337,
            load="vertical",
            separation="equidistant_chord",
            lateral_curvature="smooth",
        ),
        dict(
            lateral_shift=-0.011292716480331777,
            normal_force=0.010162831829718352,
            load_transfer=0.6232557819396405,
        ),
        {Status.NOT_CONVERGED},
    ),
    "all strips of an elastic wheel": (
        dict(
            rail="60E1",
            rail_inclination=1 / 30,
            gauge=1.4467405630101,
            gauge_depth=0.010887458448659777,
            contact_mode="elastic",
            load="vertical",
            separation="vertical",
            longitudinal_curvature="basic",
            lateral_curvature="rough",
        ),
        dict(
            lateral_shift=0.011264879256661406,
            yaw=6.60828733377615e-08,
            normal_force=0.37753014788963335,
            load_transfer=-0.3166687714226468,
        ),
        {Status.VALID, Status.NOT_CONVERGED},
    ),
    "a whole region of four": (
        dict(
            rail_inclination=0.05,
            gauge=1.4278066730570755,
            nominal_radius=0.5032672304528599,
            contact_mode="elastic",
            load="vertical",
            separation="equidistant",
            longitudinal_curvature="basic",
            lateral_curvature="rough",
        ),
        dict(
            lateral_shift=0.002361847819849205,
            yaw=0.03497360976124769,
            normal_force=181095.75540086976,
            load_transfer=0.6329157553680766,
        ),
        {Status.VALID},
    ),
    "a strip at the wrong depth": (
        dict(
            rail="60E1",
            rail_inclination=0.0,
            gauge=1.431584492630568,
            load="vertical",
            separation="vertical",
            longitudinal_curvature="basic",
            lateral_curvature="rough",
        ),
        dict(lateral_shift=-0.003508157806724604, yaw=-0.05676001449426614, normal_force=937157.8250046275),
        {Status.NOT_CONVERGED},
    ),
}


@pytest.mark.parametrize("which", ONCE_PULLING, ids=lambda which: which.replace(" ", "_"))
def test_strips_that_pull_are_no_answer_or_leave_the_load_as_it_is(which):
    parameters, pose, statuses = ONCE_PULLING[which]
    state = wrcontact.ContactSystem(normal_model="analyn_strip", **parameters).evaluate(**pose)
    assert state.status in statuses
    if state.status == Status.VALID:
        assert min(state.left.normal_force, state.right.normal_force) > 0.0
    if parameters.get("load") == "vertical" and state.status == Status.VALID:
        for side, sign in ((state.left, -1), (state.right, 1)):
            wanted = pose["normal_force"] * (1 + sign * pose.get("load_transfer", 0.0))
            assert -side.force.z == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("guess", [0.0, 1e-3, -1e-3, 0.02])
def test_a_long_move_past_the_end_of_a_rail_does_not_lose_the_root(guess):
    """Newton's method for the roll moved by 0.11 rad from tread to flange, where the left wheel was beside its rail:
    status 2, for 1 of 50 000 poses and from some guesses alone."""
    system = wrcontact.ContactSystem(
        rail_inclination=0.05,
        gauge=1.4469257046836164,
        gauge_depth=0.011166542774933931,
        nominal_radius=0.6595921132150079,
        normal_model="hertz",
    )
    pose = {"lateral_shift": 0.009490981904771711, "yaw": -0.06252962156660026}
    state = system.evaluate(**pose, roll_guess=guess)
    beside = system.evaluate(lateral_shift=pose["lateral_shift"] + 1e-9, yaw=pose["yaw"])
    assert state.status == beside.status == Status.VALID
    assert state.roll == pytest.approx(beside.roll, abs=2e-8)


def test_an_overlap_that_is_largest_at_a_profile_s_end_is_off_the_profile():
    """Once status 3."""
    wheel = Cut("S1002", start=-12.622386733876674).profile()
    elastic = wrcontact.ContactSystem(
        wheel,
        rail_inclination=0.028368054877115124,
        gauge=1.4342425134139376,
        nominal_radius=0.6702563017078506,
        contact_mode="elastic",
        load="vertical",
        normal_model="analyn_strip",
        longitudinal_curvature="basic",
        lateral_curvature="smooth",
    )
    for shift, force in (
        (-0.0025763587153089834, 508272.8674985917),
        (0.002576329408950417, 5.513487330775905),
    ):
        assert elastic.evaluate(shift, 0.0, force).status in (Status.VALID, Status.OFF_PROFILE)


def test_a_sharp_second_contact_between_two_scan_nodes_is_found():
    """A flange 1.6e-6 m above its rail under 6e-6 m of penetration: found in this size, and
    not in one 17 % larger."""
    wheel, rail = larger("S1002"), larger("60E1")
    lengths = {name: LARGER * value for name, value in LENGTHS.items()}
    lengths["nominal_radius"] = LARGER * 0.3967601922387142
    pose = -0.006520705976562699, -5.110903245303732e-06, 10e3
    one = (
        wrcontact.ContactSystem(
            rail="60E1", rail_inclination=0.089475854701787, nominal_radius=0.3967601922387142
        )
        .evaluate(*pose, load_transfer=0.9)
        .left
    )
    other = (
        wrcontact.ContactSystem(wheel, rail, rail_inclination=0.089475854701787, **lengths)
        .evaluate(LARGER * pose[0], pose[1], LARGER**2 * pose[2], load_transfer=0.9)
        .left
    )
    assert (one.patch_count, other.patch_count) == (2, 2)
    assert other.patches[1].normal_force == pytest.approx(LARGER**2 * one.patches[1].normal_force, rel=1e-3)


@pytest.mark.parametrize(
    "pose", [(-0.0061749, -0.012209894, 78500.0, -0.203122), (-0.0062, -0.01, 78500.0, 0.0)]
)
def test_patches_do_not_depend_on_where_the_scan_has_its_nodes(pose):
    """A wheel cut off on its field side has its scan nodes elsewhere. Beside a flange root the flange was
    missed where its smallest gap lies between two nodes that are both higher than the one before."""
    reference = wrcontact.ContactSystem().evaluate(*pose).left
    assert reference.patch_count == 2
    for stop in np.linspace(59.9, 58.9, 11):
        found = wrcontact.ContactSystem(Cut("S1002", stop=stop).profile()).evaluate(*pose).left
        assert found.patch_count == 2, stop
        # the same places by Newton's method from other starts
        assert found.patches[1].normal_force == pytest.approx(reference.patches[1].normal_force, rel=1e-8), (
            stop
        )


@pytest.mark.parametrize(
    "rail, side, pose",
    [
        (
            "UIC60",
            "left",
            (-0.006218527176697193, 0.007355280962730304, 27215.919364984762, 0.2009340418447575),
        ),
        (
            "UIC60",
            "left",
            (0.00030198057043384977, -0.010794209917342958, 37053.43304952801, -0.08212366228083967),
        ),
        (
            "UIC60",
            "left",
            (0.00033545056529126795, 0.014403084931006255, 28992.008797876708, -0.1073204772062557),
        ),
        (
            "UIC60",
            "right",
            (0.006163263525442407, 0.012319540456797985, 185530.12012688673, -0.2152699318985355),
        ),
        (
            "54E1",
            "left",
            (-0.006087608355140479, 0.014018496963233304, 156365.20610192217, -0.33085431741403815),
        ),
        (
            "54E1",
            "right",
            (-0.0005404628671692698, 0.04250867422671269, 18614.224630994177, -0.0638226561405264),
        ),
    ],
)
def test_a_shallow_minimum_is_found_wherever_the_scan_has_its_nodes(rail, side, pose):
    """A minimum and the hump before it may both lie between two nodes, with a gap that rises, or falls, at
    both: up to 8 % of the penetration hung on that."""
    found = [
        getattr(wrcontact.ContactSystem(Cut("S1002", stop=stop).profile(), rail).evaluate(*pose), side)
        for stop in (60.0, 59.7, 59.3, 59.13)
    ]
    for other in found[1:]:
        assert other.patch_count == found[0].patch_count
        # the same places by Newton's method from other starts
        assert other.penetration == pytest.approx(found[0].penetration, rel=1e-8)
        assert other.max_pressure == pytest.approx(found[0].max_pressure, rel=1e-8)


@pytest.mark.parametrize("count", [200, pytest.param(20_000, marks=pytest.mark.full)])
@pytest.mark.parametrize("rail", RAILS)
@pytest.mark.turns(3)
def test_many_patches_do_not_depend_on_where_the_scan_has_its_nodes(rail, count):
    """Half of the poses beside the jump to the flange. The same places by Newton's method from other
    starts, known to 1e-11 m."""
    rng = np.random.default_rng(5)
    shift = np.where(
        np.arange(count) % 2,
        rng.uniform(-8e-3, 8e-3, count),
        rng.choice([-1.0, 1.0], count) * rng.uniform(5.5e-3, 6.8e-3, count),
    )
    pose = {
        "lateral_shift": shift,
        "yaw": rng.uniform(-0.05, 0.05, count),
        "load_transfer": rng.uniform(-0.5, 0.5, count),
        "normal_force": np.exp(rng.uniform(np.log(1e3), np.log(2e5), count)),
    }
    tables = [
        wrcontact.ContactSystem(Cut("S1002", stop=stop).profile(), rail).evaluate_many(**pose)
        for stop in (60.0, 59.7, 59.3, 59.13)
    ]
    for other in tables[1:]:
        assert not other.status.any()
        off = differences(tables[0], other)
        worst = int(np.argmax(off))
        assert off[worst] < 1e-6, {name: values[worst] for name, values in pose.items()}
