"""The kernel's preparation of its tables: against the numpy witness, compiled against its
source, and what it refuses."""

import numpy as np
import pytest

import wrcontact
from tests.helpers import numpy_curvatures, numpy_profiles, numpy_scan
from tests.helpers.inside import tables_of
from tests.helpers.numpy_profiles import place_rail, readable_wheel
from tests.helpers.numpy_tables import build_tables
from wrcontact.interface.inputs import LATERAL_LIMIT
from wrcontact.interface.parameters import KERNEL_PARAMETERS
from wrcontact.kernel import layout
from wrcontact.kernel.binding import library
from wrcontact.kernel.binding.fixed_tables import fixed_tables
from wrcontact.kernel.binding.library import Kernel, default_kernel
from wrcontact.kernel.prepare import tables as prepare_tables
from wrcontact.methods import NUMBERS
from wrcontact.profiles import Profile
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.profiles.definition import definition
from wrcontact.profiles.zones import Arc, Polynomial

CURVATURE = 1e-10   # [1/m]; chords of 0.2 mm between points that are exact to 1e-17 m
LARGE_STEP = {"rail": "54E1", "rail_inclination": 1 / 20, "gauge": 1.43, "gauge_depth": 0.012,
              "nominal_radius": 0.5}


def worn_wheel():
    y = np.arange(-60.0, 56.0, 0.5)
    return Profile.from_points(y, -y / 20 + np.where(y < -30, 0.05 * (y + 30) ** 2, 0.0), name="worn",
                               kind="wheel")


def measured_rail():
    y = np.arange(-36.0, 36.1, 0.4)
    return Profile.from_points(y, 1e3 * standard_profile("UIC60").height(1e-3 * y), name="measured",
                               kind="rail")


def stepped_wheel():
    """A cone with a zone of 0.6 mm that is a step of 0.1 um higher: too short for the usual
    repair at both its ends."""
    zones = ((-60.0, -10.0, 0.0), (-10.0, -9.4, 1e-4), (-9.4, 55.0, 0.0))
    return Profile("stepped", "wheel",
                   tuple(Polynomial(low, high, (step, -0.05), 0.0) for low, high, step in zones))


CASES = {
    "default": {},
    "other rail and track": LARGE_STEP,
    "upright": {"rail": "60E1", "rail_inclination": 0.0, "running_circle_distance": 1.51},
    "measured": {"wheel": worn_wheel(), "rail": measured_rail()},
    "stepped": {"wheel": stepped_wheel()},
    "methods": {"normal_model": "analyn_strip", "contact_mode": "elastic", "load": "vertical",
                "separation": "vertical", "longitudinal_curvature": "basic", "tolerance": 0.02,
                "youngs_modulus": 2e11, "poisson_ratio": 0.3},
    "rough": {"lateral_curvature": "rough", "rail": measured_rail()},
    "smooth": {"lateral_curvature": "smooth", "curvature_reach": 1.7e-3},
}


def witness(system):
    """The tables by numpy from the exact profiles."""
    chosen = system.parameters
    methods = {name: numbers[chosen[name]] for name, numbers in NUMBERS.items()}
    placed = place_rail(system.rail, inclination=chosen["rail_inclination"], gauge=chosen["gauge"],
                        gauge_depth=chosen["gauge_depth"])
    tables = build_tables(readable_wheel(system.wheel), placed, nominal_radius=chosen["nominal_radius"],
                          running_circle_distance=chosen["running_circle_distance"],
                          contact_modulus=chosen["youngs_modulus"] / (2 * (1 - chosen["poisson_ratio"] ** 2)),
                          shear_modulus=chosen["youngs_modulus"] / (2 * (1 + chosen["poisson_ratio"])),
                          methods=methods, resolution=system.resolution,
                          curvature_step=chosen["curvature_step"], curvature_reach=chosen["curvature_reach"])
    known = {**chosen, **methods, "tolerance": chosen["tolerance"] or 0.01}
    tables[layout.SET_PARAMETERS:][:layout.PARAMETERS_SIZE] = [known[name] for name in KERNEL_PARAMETERS]
    return tables


@pytest.mark.parametrize("case", CASES)
def test_tables_are_those_of_the_witness(case):
    system = wrcontact.ContactSystem(**CASES[case])
    found, wanted = tables_of(system), witness(system)
    assert found.size == wanted.size
    curvatures = int(found[layout.SET_WHEEL_CURVATURE])
    np.testing.assert_allclose(found[:curvatures], wanted[:curvatures], rtol=1e-12, atol=0.0)
    np.testing.assert_allclose(found[curvatures:], wanted[curvatures:], rtol=1e-12, atol=CURVATURE)


@pytest.mark.skipif(not default_kernel().compiled, reason="no compiled library here")
@pytest.mark.parametrize("case", ["default", "measured", pytest.param("rough", marks=pytest.mark.full)])
def test_compiled_preparation_is_its_source_to_the_last_bit(case, monkeypatch):
    compiled = tables_of(wrcontact.ContactSystem(**CASES[case]))
    monkeypatch.setattr(library.default_kernel(), "library", None)
    source = tables_of(wrcontact.ContactSystem(**CASES[case]))
    np.testing.assert_array_equal(compiled.view(np.int64), source.view(np.int64))


def test_more_room_is_found(monkeypatch):
    expected = tables_of(wrcontact.ContactSystem())
    for room in (500, 3000, 9200, 12700, 13600):
        monkeypatch.setattr(library, "TABLE_ROOM", room)
        np.testing.assert_array_equal(tables_of(wrcontact.ContactSystem()), expected)


def test_no_room_is_told(monkeypatch):
    monkeypatch.setattr(library, "TABLE_ROOM", 1000)
    monkeypatch.setattr(library, "MOST_ROOM", 2000)
    with pytest.raises(ValueError, match="S1002 and UIC60 have too many points"):
        wrcontact.ContactSystem()


def test_what_does_not_fit_is_refused_in_a_sentence():
    with pytest.raises(ValueError,
                       match=r"gauge_depth reaches 0\.029\d* m, but the inner side of the rail profile "
                       r"crown ends at"):
        wrcontact.ContactSystem(rail=Profile("crown", "rail", (Arc(-30.0, 30.0, 300.0, 0.0, 300.0, -1),)),
                                gauge_depth=0.03)
    with pytest.raises(ValueError, match=r"the wheel profile is 0\.\d+ m wide; permitted are at most 0\.2 m"):
        wide = tuple(Polynomial(low, low + 1.0, (0.0, 0.0, 0.0)) for low in range(-150, 250))
        wrcontact.ContactSystem(wheel=Profile("wide", "wheel", bent(wide)))
    with pytest.raises(ValueError, match="too steep at y = 0"):
        wrcontact.ContactSystem(wheel=Profile("away", "wheel", (Polynomial(5.0, 60.0, (0.0,)),)))


def bent(zones):
    """The same zones on a parabola that is bent enough for the fine raster."""
    bend = 0.02 / 2  # [1/mm]
    return tuple(Polynomial(z.start, z.stop, (bend * z.start**2, 2 * bend * z.start, bend), z.start)
                 for z in zones)


def test_a_definition_is_read_exactly():
    """Every number of the zones is in the definition."""
    wheel = standard_profile("S1002")
    held = definition(wheel)
    for zone in wheel.zones:
        numbers = [value for value in vars(zone).values()
                   if isinstance(value, float)] + list(getattr(zone, "coefficients", ()))
        assert all(value in held for value in numbers)


def test_setup_that_is_no_array_is_refused():
    upright = definition(standard_profile("UIC60"))
    with pytest.raises(TypeError, match="setup must be a numpy array"):
        Kernel().prepare([0.0], upright, upright, fixed_tables())


def test_constants_are_those_of_the_witness():
    from wrcontact.kernel.prepare import curvatures as prepare_curvatures
    from wrcontact.kernel.prepare import pieces as prepare_pieces
    from wrcontact.kernel.prepare import scan as prepare_scan
    from wrcontact.kernel.prepare import zones as prepare_placement

    pairs = [(prepare_pieces, numpy_profiles,
              ("PIECE_ERROR", "PIECE_BEND_ERROR", "LONGEST_PIECE", "SHORTEST_PIECE",
               "REPAIR_WIDTH", "REPAIRED_STEP", "BIN_WIDTH", "MM")),
             (prepare_placement, numpy_profiles, ("STEEPEST",)),
             (prepare_scan, numpy_scan, ("COARSE_STEP", "FINE_STEP", "STRAIGHT", "TOO_STEEP")),
             (prepare_curvatures, numpy_curvatures,
              ("RASTER_SHARE", "FINEST", "COARSEST", "SAMPLES", "GAUSS_POINTS",
               "ARC_ITERATIONS", "ARC_SHARP"))]
    for ours, theirs, names in pairs:
        for name in names:
            assert getattr(ours, name) == getattr(theirs, name), name
    assert prepare_tables.START_COUNT == 2 * round(LATERAL_LIMIT / prepare_tables.START_STEP) + 1
    assert prepare_tables.STARTS_EACH_METRE == 1.0 / prepare_tables.START_STEP
    assert prepare_pieces.BINS_EACH_METRE == 1.0 / (numpy_profiles.BIN_WIDTH * numpy_profiles.MM)
