"""Methods and groups as objects: the same systems as by keywords, and what is refused."""

import inspect
import pickle

import numpy as np
import pytest

import wrcontact
from tests.helpers.inside import tables_of
from wrcontact import (
    Adaptive,
    Analyn,
    BasicCurvature,
    Compliant,
    Elastic,
    Equidistant,
    EquidistantChord,
    Halfspace,
    Hertz,
    Material,
    NormalLoad,
    Rough,
    Smooth,
    Strip,
    Track,
    VerticalLoad,
    VerticalSeparation,
    Wheelset,
)
from wrcontact.interface.parameters import GROUPS, PARAMETERS
from wrcontact.interface.variables import PLACE, VARIABLES
from wrcontact.kernel import layout
from wrcontact.methods import CHOICES, FAMILIES, NUMBERS, NormalModel

PAIRS = [
    ({"normal_model": Analyn(tolerance=0.004)}, {"normal_model": "analyn", "tolerance": 0.004}),
    ({"normal_model": Analyn(nodes=20)}, {"nodes": 20}),
    (
        {"normal_model": Strip(strips=14, sweeps=3)},
        {"normal_model": "analyn_strip", "strips": 14, "sweeps": 3},
    ),
    ({"normal_model": Hertz()}, {"normal_model": "hertz"}),
    ({"normal_model": Halfspace(tolerance=0.03)}, {"normal_model": "halfspace", "tolerance": 0.03}),
    ({"contact_mode": Elastic(), "load": VerticalLoad()}, {"contact_mode": "elastic", "load": "vertical"}),
    ({"contact_mode": Compliant(), "load": NormalLoad()}, {"contact_mode": "compliant"}),
    (
        {"separation": Equidistant(), "longitudinal_curvature": BasicCurvature()},
        {"separation": "equidistant", "longitudinal_curvature": "basic"},
    ),
    ({"separation": EquidistantChord()}, {"separation": "equidistant_chord"}),
    ({"separation": VerticalSeparation()}, {"separation": "vertical"}),
    ({"lateral_curvature": Smooth(reach=2e-3)}, {"lateral_curvature": "smooth", "curvature_reach": 2e-3}),
    ({"lateral_curvature": Rough(step=1e-3)}, {"lateral_curvature": "rough", "curvature_step": 1e-3}),
    ({"track": Track(gauge=1.44, rail_inclination=1 / 20)}, {"gauge": 1.44, "rail_inclination": 1 / 20}),
    (
        {"wheelset": Wheelset(nominal_radius=0.5), "material": Material(poisson_ratio=0.3)},
        {"nominal_radius": 0.5, "poisson_ratio": 0.3},
    ),
    ({"track": Track(gauge=1.44), "gauge": 1.44}, {"gauge": 1.44}),  # twice the same
    (
        {"normal_model": Strip(tolerance=0.02), "tolerance": None},
        {"normal_model": "analyn_strip", "tolerance": 0.02},
    ),
]


@pytest.mark.parametrize("objects, keywords", PAIRS)
def test_objects_and_keywords_give_the_same_system(objects, keywords):
    one, other = wrcontact.ContactSystem(**objects), wrcontact.ContactSystem(**keywords)
    np.testing.assert_array_equal(tables_of(one), tables_of(other))
    assert one.parameters == other.parameters and one.methods == other.methods and repr(one) == repr(other)
    again = pickle.loads(pickle.dumps(one))
    assert again.parameters == one.parameters and again.methods == one.methods
    np.testing.assert_array_equal(tables_of(again), tables_of(one))


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        (
            {"track": Track(gauge=1.44), "gauge": 1.435},
            "gauge is 1.435 m, but 1.44 m in track=Track(gauge=1.44); permitted is one value",
        ),
        (
            {"normal_model": Strip(), "tolerance": 0.01},
            "tolerance is 0.01, but None in normal_model=Strip(); permitted is one value",
        ),
        (
            {"lateral_curvature": Rough(), "curvature_step": 1e-3},
            "curvature_step is 0.001 m, but 0.0002 m in lateral_curvature=Rough(); permitted is one value",
        ),
        ({"track": Material()}, "track is Material(); permitted is a Track"),
        (
            {"normal_model": Adaptive()},
            f"normal_model is Adaptive(); permitted are {str(NormalModel.family.names())[1:-1]}",
        ),
        (
            {"normal_model": Halfspace(), "separation": VerticalSeparation()},
            "separation is 'vertical'; permitted with the normal_model 'halfspace', which knows the whole surface, "
            "is 'normal'",
        ),
        (
            {"normal_model": "halfspace", "lateral_curvature": "rough"},
            "lateral_curvature is 'rough'; permitted with the normal_model 'halfspace', which knows the whole "
            "surface, is 'adaptive'",
        ),
    ],
)
def test_what_contradicts_is_refused_in_a_sentence(arguments, sentence):
    with pytest.raises(ValueError) as refusal:
        wrcontact.ContactSystem(**arguments)
    assert str(refusal.value) == sentence


@pytest.mark.parametrize(
    "kind, numbers, sentence",
    [
        (
            Track,
            {"gauge": 1435},
            "gauge is 1435; permitted is 0.5 ... 2 m; did you mean 1435 mm, which is 1.435 m?",
        ),
        (Material, {"poisson_ratio": 0.5}, "poisson_ratio is 0.5; permitted is 0 ... 0.499"),
        (
            Analyn,
            {"tolerance": 1e-3},
            "tolerance is 0.001; permitted with the normal_model 'analyn' is 0.0015 ... 0.1",
        ),
        (Strip, {"sweeps": 2.5}, "sweeps is 2.5; permitted are whole numbers 1 ... 20"),
        (
            Smooth,
            {"reach": 3},
            "reach is 3; permitted with the lateral_curvature 'smooth' is 0.0001 ... 0.01 m; did you mean 3 mm, which is 0.003 m?",
        ),
    ],
)
def test_wrong_numbers_are_refused_when_an_object_is_made(kind, numbers, sentence):
    with pytest.raises(ValueError) as refusal:
        kind(**numbers)
    assert str(refusal.value) == sentence


def test_unknown_keywords_are_refused():
    with pytest.raises(TypeError, match="ContactSystem has no parameter 'gague'"):
        wrcontact.ContactSystem(gague=1.435)


def test_objects_show_what_differs_from_the_default():
    assert repr(Strip(strips=14)) == "Strip(strips=14)" and repr(Track()) == "Track()"
    assert Analyn(tolerance=0.01) != Analyn() and len({Analyn(), Analyn(), Hertz()}) == 2
    with pytest.raises(AttributeError):
        Analyn().tolerance = 0.02


def test_every_keyword_is_shown_and_explained():
    shown = inspect.signature(wrcontact.ContactSystem).parameters
    assert list(shown) == ["wheel", "rail", *GROUPS, *list(PARAMETERS)[2:]]
    assert all(shown[name].default == row.default for name, row in PARAMETERS.items())
    assert all(name in wrcontact.ContactSystem.__doc__ for name in shown)
    assert "{" not in wrcontact.ContactSystem.__doc__ + wrcontact.ContactSystem.evaluate.__doc__
    assert all(known.meaning for row in PARAMETERS.values() if (known := row.number))


def test_the_kernel_has_the_number_of_every_method():
    assert (layout.MODE_ELASTIC, layout.LOAD_VERTICAL) == (1, 1)
    assert (layout.MODEL_HERTZ, layout.MODEL_ANALYN_STRIP) == (0, 2)
    assert (layout.SEPARATION_EQUIDISTANT_CHORD, layout.LONGITUDINAL_BASIC, layout.LATERAL_ROUGH) == (3, 1, 2)
    for parameter, numbers in NUMBERS.items():
        for name, number in numbers.items():
            system = wrcontact.ContactSystem(**{parameter: name})
            assert getattr(layout.Tables.at(tables_of(system)).parameters, parameter) == number


def test_an_fmu_offers_what_its_table_says():
    for family in FAMILIES:
        variable = VARIABLES[PLACE[family.parameter]]
        assert variable.choices == CHOICES[family.parameter] and variable.start == family.default
        assert all(
            f"{method.name} = {method.words}" in variable.meaning
            for method in family.methods
            if not method.python_only
        )


#: Names by number, as they are in FMUs and saved states in users' hands: only appended to.
RELEASED = {
    "contact_mode": ("rigid", "elastic", "compliant"),
    "load": ("normal", "vertical"),
    "normal_model": ("hertz", "analyn", "analyn_strip"),
    "separation": ("normal", "vertical", "equidistant", "equidistant_chord"),
    "longitudinal_curvature": ("effective", "basic"),
    "lateral_curvature": ("adaptive", "smooth", "rough"),
    "tangential_model": ("none", "strips", "fastsim", "fastrip", "polach"),
}


def test_numbers_of_methods_never_move():
    for parameter, names in RELEASED.items():
        assert [NUMBERS[parameter][name] for name in names] == list(range(len(names)))
    assert list(RELEASED) == [family.parameter for family in FAMILIES]


def test_a_method_registers_itself(monkeypatch):
    family = NormalModel.family
    monkeypatch.setattr(family, "methods", family.methods)
    number = max(one.kernel_number for one in family.methods) + 1

    class Own(NormalModel):
        name, kernel_number, words = "own", number, "a model of one's own"

    assert family.method("own") is Own and family.names(python=False)[-1] == "own"
    for name, taken in (("own", number + 1), ("other", 0)):
        with pytest.raises(TypeError, match="two methods of normal_model"):
            type("Other", (NormalModel,), {"name": name, "kernel_number": taken, "words": ""})
    with pytest.raises(TypeError, match="Other has no kernel_number and no words"):
        type("Other", (NormalModel,), {"name": "other"})


def test_every_method_is_a_name_of_the_package():
    for family in FAMILIES:
        assert all(getattr(wrcontact, method.__name__) is method for method in family.methods)
        assert {method.__name__ for method in family.methods} <= set(wrcontact.__all__)
