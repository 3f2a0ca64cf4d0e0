"""What a store of wear goes on with, files of results that lack something, and the place of a worn rail."""

import functools
import json

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import energy, poses, system, table
from wrcontact.profiles import Profile, standard_profile
from wrcontact.results.convert import columns_of
from wrcontact.wear import store
from wrcontact.wear.bins import Arc
from wrcontact.wear.laws import law_mark, law_of
from wrcontact.wear.update import smoothed, worn_profile

MM = 1e-3

# --- the mark of a law --------------------------------------------------------------------------------------

FACTOR = 2.0


def scaled(factor):
    return lambda power_density: factor * 1e-9 * power_density


def edged(power_density, edge=3.14159e7):
    """Differs from others between two places at which laws are tried."""
    return np.where(power_density < edge, 1e-9, 2e-9) * power_density


class Mine:
    def __init__(self, factor):
        self.factor = factor

    def law(self, power_density):
        return self.factor * 1e-9 * power_density


def global_factor(power_density):
    return FACTOR * 1e-9 * power_density


DIFFERENT = {
    "lambdas": (lambda power_density: 1e-9 * power_density, lambda power_density: 2e-9 * power_density),
    "closures": (scaled(1.0), scaled(1.0 + 1e-12)),
    "defaults": (edged, functools.partial(edged, edge=3.14160e7)),
    "objects": (Mine(1.0).law, Mine(1.0 + 1e-12).law),
    "numbers of a law": (wrcontact.Usfd(), wrcontact.Usfd(calibration=0.5)),
    "an edge of a law": (wrcontact.Usfd(), wrcontact.Usfd(first=10.4000001e6)),
    "a law and its function": (energy, lambda power_density, slip: 1e-9 * power_density + 0.0 * slip + 1e-20),
}


@pytest.mark.parametrize("case", DIFFERENT)
def test_laws_that_differ_have_different_marks(case):
    marks = [law_mark(law_of(law)) for law in DIFFERENT[case]]
    assert marks[0] != marks[1] and " object at 0x" not in "".join(marks)


def test_the_same_law_has_the_same_mark(monkeypatch):
    for make in (lambda: scaled(3.0), lambda: Mine(2.0).law, wrcontact.Usfd, lambda: global_factor):
        assert law_mark(law_of(make())) == law_mark(law_of(make()))
    before = law_mark(law_of(global_factor))
    monkeypatch.setitem(globals(), "FACTOR", 2.0000001)
    assert law_mark(law_of(global_factor)) != before


def simulate(worn):
    inputs, share = poses()
    few = {name: values[::6] for name, values in inputs.items()}
    return worn.evaluate_many(**few), share[::6] / share[::6].sum()


def run(folder, law=energy, mileage=1e6, **changes):
    return wrcontact.wear_run(simulate, system(), law, mileage, 1e-4, method="euler", store=folder, **changes)


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    folder = tmp_path_factory.mktemp("kept")
    return folder, run(folder)


def copied(kept, folder):
    for file in kept[0].iterdir():
        (folder / file.name).write_bytes(file.read_bytes())
    return folder


def namesake(power_density):
    return 3e-9 * power_density


namesake.__name__ = energy.__name__


@pytest.mark.parametrize(
    "change, what",
    [
        ({"law": namesake}, "law"),
        ({"smoothing": 2e-3}, "steps"),
        ({"part": "rail"}, "profiles|steps"),
    ],
)
def test_a_store_of_another_run_is_refused_by_what_differs(kept, tmp_path, change, what):
    with pytest.raises(ValueError, match=f"which has another run, with another (.* and )?({what})"):
        run(copied(kept, tmp_path), **change)


def test_a_store_of_another_version_is_refused(kept, tmp_path, monkeypatch):
    monkeypatch.setattr(store, "__version__", "0.0.0")
    with pytest.raises(ValueError, match="which has another run, with another version; permitted is"):
        run(copied(kept, tmp_path))


def test_a_store_goes_on_with_the_same_numbers(kept, tmp_path):
    again = run(copied(kept, tmp_path))
    assert [step.length for step in again.steps] == [step.length for step in kept[1].steps]
    assert again.profiles()[-1].zones == kept[1].profiles()[-1].zones


def digit(text):
    """The text with another digit in the middle of its numbers, still JSON."""
    at = text.index('"taken"') + 25
    return text[:at] + str((int(text[at]) + 1) % 10) + text[at + 1 :]


@pytest.mark.full
@pytest.mark.parametrize(
    "name, damage",
    [
        ("step_00000.json", lambda text: text[: len(text) // 2]),
        ("step_00000.json", lambda text: ""),
        ("step_00000.json", lambda text: "[]"),
        ("step_00000.json", lambda text: json.dumps({"mark": json.loads(text)["mark"]})),
        ("step_00000.json", digit),
        ("worn_00000_right.json", lambda text: text[: len(text) // 2]),
        ("worn_00000_left.json", lambda text: text.replace("1", "2", 1)),
        ("worn_00000_left.json", None),
    ],
)
def test_a_damaged_store_is_reported_in_a_sentence(kept, tmp_path, name, damage):
    path = copied(kept, tmp_path) / name
    if damage is None:
        path.unlink()
    else:
        path.write_text(damage(path.read_text()))
    with pytest.raises(ValueError) as told:
        run(tmp_path)
    said = str(told.value)
    assert str(tmp_path) in said and f"where {name} is damaged" in said and "\n" not in said
    for file in tmp_path.glob("*_0000*"):
        file.unlink()
    assert run(tmp_path).distance[-1] == pytest.approx(1e6)


# --- files that lack something ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name",
    [
        "station", "half_length", "pressure", "power", "slip", "wheel_place", "rail_place", "patch_of",
    ],
)  # fmt: skip
def test_a_row_that_lacks_a_number_is_left_out_and_counted(name):
    """The mass is that of the other rows: a number that is missing is no zero."""
    columns, share = columns_of(table()), poses()[1]
    lacking = {key: np.array(values, dtype=float) for key, values in columns.items()}
    for station in range(5, 17):
        lacking[f"right.{name}[{station}]"][7] = np.nan
    others = np.arange(60) != 7
    wears = [wrcontact.Wear(system(), energy) for _ in range(2)]
    wears[0].add_fmu(lacking, distance=share)
    wears[1].add_fmu({key: values[others] for key, values in lacking.items()}, distance=share[others])
    assert wears[0].left_out == 1 and wears[0].rows == 59
    for part in ("left.wheel", "right.wheel", "right.rail"):
        assert wears[0].mass(part) == pytest.approx(wears[1].mass(part), rel=1e-12)


def test_many_rows_that_lack_numbers_are_refused():
    columns = {key: np.array(values, dtype=float) for key, values in columns_of(table()).items()}
    for station in range(1, 13):
        columns[f"right.power[{station}]"][:] = np.nan
    with pytest.raises(
        ValueError, match="60 of 60 rows of the results have a status other than 0 or numbers"
    ):
        wrcontact.Wear(system(), energy).add_fmu(columns, distance=1.0)


@pytest.mark.parametrize("name", ["right.power", "left.slip", "right.wheel_place"])
def test_a_station_that_is_not_there_is_reported(name):
    columns = columns_of(table())
    last = max(int(key.partition("[")[2][:-1]) for key in columns if key.startswith("right.power["))
    del columns[f"{name}[{last}]"]
    with pytest.raises(
        ValueError, match=rf"has no column '{name}\[{last}\]', though others have {last} stations"
    ):
        wrcontact.Wear(system(), energy).add_fmu(columns, distance=1.0)


@pytest.mark.parametrize(
    "content, words",
    [
        (b"time,speed\n0,20\n\xff\xfe,20\n", r"result.csv is not text in UTF-8 \(byte 16\)"),
        (
            b"time,speed,status\n0,20\n1,20\n2,20\n",
            "row 2 of .* has 2 values; permitted are as many as there are names, 3",
        ),
    ],
)
def test_a_file_that_is_no_table_is_reported(tmp_path, content, words):
    (tmp_path / "result.csv").write_bytes(content)
    with pytest.raises(ValueError, match=words):
        wrcontact.Wear(system(), energy).add_fmu(tmp_path / "result.csv")


# --- the place of a worn rail -------------------------------------------------------------------------------


def side_worn(depth, inclination=1 / 40):
    """UIC60 whose gauge face has lost this depth [m]."""
    arc = Arc(standard_profile("UIC60"), inclination)
    return worn_profile(arc, smoothed(np.where(arc.own_places < -25 * MM, depth, 0.0), arc, 1e-3))


@pytest.mark.parametrize("inclination", [1 / 40, 1 / 20, 0.0])
@pytest.mark.parametrize("depth", [0.5 * MM, 1.5 * MM])
def test_side_wear_widens_the_gauge(depth, inclination):
    """The rail keeps its place: the crown, which is not worn, has the same contacts, and the face moves by the depth
    over the cosine of its slope, 1:20 in an upright rail."""
    worn, new = side_worn(depth, inclination), standard_profile("UIC60")
    aside = depth * np.hypot(1.0, 0.05 + inclination)  # to first order in the sum of both slopes
    assert worn.worn_face == pytest.approx(aside, rel=0.02)
    both = [wrcontact.ContactSystem(rail=rail, rail_inclination=inclination) for rail in (new, worn)]
    assert both[1].profile_tables()[2] == pytest.approx(both[0].profile_tables()[2], abs=1e-12)
    states = [one.evaluate(lateral_shift=-3 * MM, normal_force=78.5e3) for one in both]
    for name in ("y_track", "y_wheel"):
        places = [getattr(state.right.contact, name) for state in states]
        assert places[1] == pytest.approx(places[0], abs=1e-9)
    plays = [wrcontact.check(one).flange_shift for one in both]
    assert plays[1] - plays[0] == pytest.approx(depth, rel=0.25)


def test_a_rail_that_wears_twice_adds_up():
    once = side_worn(0.8 * MM)
    arc = Arc(once, 1 / 40)
    twice = worn_profile(arc, smoothed(np.where(arc.own_places < -25 * MM, 0.4 * MM, 0.0), arc, 1e-3))
    assert twice.worn_face == pytest.approx(side_worn(1.2 * MM).worn_face, rel=0.01)
    assert standard_profile("UIC60").worn_face == 0.0


def test_crown_wear_moves_no_face():
    arc = Arc(standard_profile("UIC60"), 1 / 40)
    worn = worn_profile(arc, smoothed(np.where(np.abs(arc.own_places) < 15 * MM, 1 * MM, 0.0), arc, 1e-3))
    # the gauge is measured below the worn top, 1 mm deeper on a face of 1:20 that leans to 1:13
    assert abs(worn.worn_face) < 0.1 * MM


def test_a_saved_rail_keeps_its_place(tmp_path):
    worn = side_worn(1.0 * MM)
    worn.save(tmp_path / "worn.json")
    again = Profile.from_file(tmp_path / "worn.json", "rail")
    assert again == worn and again.worn_face == worn.worn_face
    text = (tmp_path / "worn.json").read_text()
    (tmp_path / "wrong.json").write_text(text.replace(f'"worn_face": {worn.worn_face!r}', '"worn_face": 7.0'))
    with pytest.raises(ValueError, match="is not a prepared profile .*worn_face is 7.0 m"):
        Profile.from_file(tmp_path / "wrong.json", "rail")
