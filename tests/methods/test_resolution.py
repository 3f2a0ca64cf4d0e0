"""Tolerance, nodes, strips and sweeps: what a tolerance promises, and what is refused."""

import functools
import pickle

import numpy as np
import pytest

import wrcontact
from tests.helpers.inside import tables_of
from wrcontact.kernel import layout
from wrcontact.methods import Analyn, NormalModel, Resolution, Strip, family_of
from wrcontact.methods.normal import DEFAULT

NAMES = ("penetration", "area", "max_pressure")
SIDES = ("left", "right")
MODELS = {model.name: model for model in family_of("normal_model").methods}
LADDERS = {model.name: model.ladder for model in (Analyn, Strip)}
FINEST_COUNTS = {"analyn": dict(nodes=38), "analyn_strip": dict(nodes=38, strips=16, sweeps=20)}


def random_poses(count, seed):
    """Lateral shift, yaw, force (count,): as wrcontact/methods/normal.py describes them."""
    rng = np.random.default_rng(seed)
    return (
        rng.uniform(-6.6e-3, 6.6e-3, count),
        np.radians(rng.uniform(-2, 2, count)) * (rng.random(count) < 0.5),
        np.exp(rng.uniform(np.log(3e3), np.log(2e5), count)),
    )


def numbers(system, poses):
    """Penetration, area and peak pressure (3, 2 n) of both wheels at all poses."""
    table = system.evaluate_many(*poses, outputs="patches")
    assert not table.status.any()
    return np.array(
        [np.concatenate([getattr(getattr(table, side), name) for side in SIDES]) for name in NAMES]
    )


@functools.lru_cache
def finest(model, count, seed):
    return numbers(
        wrcontact.ContactSystem(normal_model=model, **FINEST_COUNTS[model]), random_poses(count, seed)
    )


RUNGS = [(model, tolerance) for model, ladder in LADDERS.items() for tolerance in ladder]


@pytest.mark.parametrize(
    "count, seed, each, together",
    [
        # of 600 wheels 0.95 less two standard deviations; all three at once: 0.94 to 0.96
        (300, 51, 0.932, 0.91),
        pytest.param(10000, 52, 0.945, 0.93, marks=pytest.mark.full),
    ],
)
@pytest.mark.parametrize("model, tolerance", RUNGS)
def test_tolerance_is_kept_by_95_of_100(model, tolerance, count, seed, each, together):
    """Each of the three numbers."""
    system = wrcontact.ContactSystem(normal_model=model, tolerance=tolerance)
    error = np.abs(numbers(system, random_poses(count, seed)) / finest(model, count, seed) - 1)
    kept = (error <= tolerance).mean(axis=1)
    assert np.all(kept >= each), dict(zip(NAMES, kept))
    assert (error.max(axis=0) <= tolerance).mean() >= together


@pytest.mark.parametrize("model", LADDERS)
def test_smaller_tolerances_err_less_and_work_more(model):
    """From the coarsest to the finest: the 95th percentile falls, nodes and strips do not."""
    poses = random_poses(300, 51)
    errors, work = [], []
    for tolerance in LADDERS[model]:
        system = wrcontact.ContactSystem(normal_model=model, tolerance=tolerance)
        error = np.abs(numbers(system, poses) / finest(model, 300, 51) - 1)
        errors.append(np.percentile(error.max(axis=0), 95))
        chosen = system.resolution
        work.append(
            (chosen.nodes / chosen.stride, chosen.strips * chosen.sweeps if model == "analyn_strip" else 0)
        )
    assert errors == sorted(errors, reverse=True) and errors[-1] < 0.3 * errors[0], errors
    assert [strips for _, strips in work] == sorted(strips for _, strips in work)


def test_default_is_one_in_a_hundred():
    for model in LADDERS:
        plain, told = (
            wrcontact.ContactSystem(normal_model=model, tolerance=given) for given in (None, DEFAULT)
        )
        assert DEFAULT == 0.01 and plain.resolution == told.resolution == LADDERS[model][0.01]
        np.testing.assert_array_equal(plain.evaluate(3e-3, 0.01).values, told.evaluate(3e-3, 0.01).values)


@pytest.mark.parametrize(
    "model, resolution",
    [
        (Analyn(tolerance=0.1), Analyn.ladder[0.02]),  # coarser than the coarsest: the coarsest
        (Analyn(tolerance=0.02), Analyn.ladder[0.02]),
        (Analyn(tolerance=0.0199), Analyn.ladder[0.01]),  # the coarsest that keeps it
        (Analyn(tolerance=0.0015), Analyn.ladder[0.0015]),
        (Strip(tolerance=0.1), Strip.ladder[0.025]),
        (Strip(tolerance=0.008), Strip.ladder[0.007]),
        (Strip(tolerance=0.004), Strip.ladder[0.004]),
    ],
)
def test_the_coarsest_that_keeps_a_tolerance(model, resolution):
    assert model.resolution == resolution


def test_counts_take_the_place_of_single_numbers():
    assert Strip(strips=14).resolution == Strip.ladder[0.01]._replace(strips=14)
    assert Strip(tolerance=0.004, sweeps=1).resolution == Strip.ladder[0.004]._replace(sweeps=1)
    # each of them traced
    assert Analyn(nodes=20).resolution.nodes == 20 and Analyn(nodes=20).resolution.stride == 1
    assert Strip(tolerance=0.1, nodes=30.0, strips=16, sweeps=9).resolution == Resolution(30, 1, 16, 9)
    assert all(isinstance(value, int) for value in Strip(nodes=30.0, strips=np.int64(12)).resolution)


def test_resolution_reaches_the_kernel():
    system = wrcontact.ContactSystem(normal_model="analyn_strip", nodes=20, strips=14, sweeps=3)
    tables = layout.Tables.at(tables_of(system))
    assert (tables.nodes, tables.stride, tables.waves.count, tables.sweeps) == (20, 1, 14, 3)


def test_every_permitted_count_gives_an_answer():
    """All ends and some between: within 20 % of the finest, where nothing is near a jump."""
    shifts = np.array([-3e-3, 0.0, 2e-3, 6.4e-3])
    for model in LADDERS:
        fine = wrcontact.ContactSystem(normal_model=model, **FINEST_COUNTS[model]).evaluate_many(
            shifts, 0.005
        )
        for nodes in (4, 5, 9, 17, 38):
            for strips, sweeps in (
                ((None, None),) if model == "analyn" else ((6, 1), (7, 20), (11, 2), (16, 1), (16, 20))
            ):
                counts = dict(nodes=nodes, strips=strips, sweeps=sweeps)
                table = wrcontact.ContactSystem(normal_model=model, **counts).evaluate_many(shifts, 0.005)
                assert not table.status.any()
                for name in NAMES:
                    np.testing.assert_allclose(
                        getattr(table.right, name), getattr(fine.right, name), rtol=0.2
                    )


def test_pickled_and_shown():
    system = wrcontact.ContactSystem(normal_model="analyn_strip", tolerance=0.02, strips=14)
    assert repr(system) == "ContactSystem(normal_model='analyn_strip', tolerance=0.02, strips=14)"
    assert pickle.loads(pickle.dumps(system)).resolution == system.resolution


# --- refusals -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        ({"tolerance": 0.2}, "tolerance is 0.2; permitted is 0.0001 ... 0.1"),
        ({"tolerance": 0.0}, "tolerance is 0.0; permitted is 0.0001 ... 0.1"),
        ({"tolerance": "fine"}, "tolerance is 'fine'; permitted is 0.0001 ... 0.1"),
        ({"tolerance": float("nan")}, "tolerance is nan; permitted is 0.0001 ... 0.1"),
        (
            {"normal_model": "analyn_strip", "tolerance": 0.002},
            "tolerance is 0.002; permitted with the normal_model 'analyn_strip' is 0.004 ... 0.1",
        ),
        ({"nodes": 3}, "nodes is 3; permitted are whole numbers 4 ... 38"),
        ({"nodes": 39}, "nodes is 39; permitted are whole numbers 4 ... 38"),
        ({"nodes": 10.5}, "nodes is 10.5; permitted are whole numbers 4 ... 38"),
        ({"nodes": "many"}, "nodes is 'many'; permitted are whole numbers 4 ... 38"),
        ({"nodes": True}, "nodes is True; permitted are whole numbers 4 ... 38"),
        ({"nodes": float("nan")}, "nodes is nan; permitted are whole numbers 4 ... 38"),
        ({"normal_model": "analyn_strip", "strips": 5}, "strips is 5; permitted are whole numbers 6 ... 16"),
        (
            {"normal_model": "analyn_strip", "strips": 17},
            "strips is 17; permitted are whole numbers 6 ... 16",
        ),
        ({"normal_model": "analyn_strip", "sweeps": 0}, "sweeps is 0; permitted are whole numbers 1 ... 20"),
        (
            {"normal_model": "analyn_strip", "sweeps": 21},
            "sweeps is 21; permitted are whole numbers 1 ... 20",
        ),
        (
            {"strips": 12},
            "strips is 12; it cannot be given with the normal_model 'analyn', only 'analyn_strip' or 'auto' has it",
        ),
        (
            {"sweeps": 2},
            "sweeps is 2; it cannot be given with the normal_model 'analyn', only 'analyn_strip' or 'auto' has it",
        ),
        (
            {"normal_model": "hertz", "nodes": 15},
            "nodes is 15; it cannot be given with the normal_model 'hertz', only "
            f"{' or '.join(map(repr, NormalModel.family.with_keyword('nodes')))} has it",
        ),
        (
            {"normal_model": "halfspace", "strips": 12},
            "strips is 12; it cannot be given with the normal_model 'halfspace', only 'analyn_strip' or 'auto' has it",
        ),
    ],
)
def test_refusals(arguments, sentence):
    with pytest.raises(ValueError) as refusal:
        wrcontact.ContactSystem(**arguments)
    assert str(refusal.value) == sentence


@pytest.mark.parametrize("model", ["analyn", "analyn_strip", "hertz", "halfspace"])
def test_the_smallest_tolerance_of_each_model_is_permitted(model):
    finest = MODELS[model].numbers()["tolerance"].low
    wrcontact.ContactSystem(normal_model=model, tolerance=finest)
    with pytest.raises(ValueError, match="tolerance is"):
        wrcontact.ContactSystem(normal_model=model, tolerance=0.999 * finest)


def test_ends_of_the_counts_are_permitted():
    for name in ("nodes", "strips", "sweeps"):
        known = Strip.numbers()[name]
        for value in (known.low, known.high):
            assert (
                getattr(
                    wrcontact.ContactSystem(normal_model="analyn_strip", **{name: value}).resolution, name
                )
                == value
            )
