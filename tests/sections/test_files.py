"""Files of sections: what is read is what was written, and what cannot be used is refused in one sentence."""

import sys

import numpy as np
import pytest

from tests.helpers.sections import nose, nose_points
from tests.helpers.slice_files import MM, POSITIONS, columns, section, write_slices
from wrcontact import RailSections

PLACES = np.array([0.5, 3.0, 8.0, 17.0]) * MM
TOML = pytest.mark.skipif(sys.version_info < (3, 11), reason="Python before 3.11 reads no TOML")


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"ending": "txt"},
        {"ending": "txt", "unit": 1.0},
        {"features": [[0.0, 20.0, 999]] * 5},
    ],
)
def test_a_slice_file_is_the_sections_that_it_lists(tmp_path, options):
    """Sections in millimetres and metres, positions with an offset, a feature behind the end."""
    read, made = RailSections.from_file(write_slices(tmp_path, **options)), nose(POSITIONS)
    assert read.name == "nose" and read.positions == pytest.approx(POSITIONS, abs=1e-9)
    for u in (-0.1, -0.03, 0.02, 0.1):
        assert read.height(u, PLACES) == pytest.approx(made.height(u, PLACES), abs=1e-8)


def test_positions_are_in_the_unit_of_the_file(tmp_path):
    write_slices(tmp_path)
    text = (tmp_path / "nose.slcs").read_text()
    for k, u in enumerate(POSITIONS):
        text = text.replace(f"{1e3 * u - 0.01:.6f} 'nose_{k}", f"{u:.6f} 'nose_{k}")
    (tmp_path / "metres.slcs").write_text(text.replace("0.01 1.0", "0.5 1000.0"))
    read = RailSections.from_file(tmp_path / "metres.slcs")
    assert read.positions == pytest.approx(POSITIONS + 0.5, abs=1e-9)


@TOML
@pytest.mark.parametrize("unit, factor", [("mm", MM), ("m", 1.0)])
def test_a_toml_is_the_sections_that_it_lists(tmp_path, unit, factor):
    lines = ['kind = "rail sections"', 'name = "frog"', f'unit = "{unit}"', 'position_unit = "mm"']
    for k, u in enumerate(POSITIONS):
        (tmp_path / f"{k}.csv").write_text(columns(section(k), factor))
        lines += [
            "[[slice]]",
            f"position = {1e3 * u}",
            f'file = "{k}.csv"',
            f"features = [0.0, {0.06 / factor}]",
        ]
    (tmp_path / "own.toml").write_text("\n".join(lines))
    read = RailSections.from_file(tmp_path / "own.toml")
    assert read.name == "frog"
    assert read.features == pytest.approx(np.array([[0.0, min(0.06, read.features.max())]] * 5))
    assert read.height(0.02, PLACES) == pytest.approx(nose(POSITIONS).height(0.02, PLACES), abs=1e-8)


@pytest.mark.parametrize(
    "change, sentence",
    [
        (("  5  NSLC", "1 NSLC"), "has 1 as NSLC, the number of slices; permitted are 2 ... 2000"),
        (("  5  NSLC", "6"), "ends where a line should have position and file of slice 6 of 6"),
        (("  5  NSLC", "five"), "has 'five' in line 3; permitted is NSLC, the number of slices: 1 numbers"),
        (("0 0 0", "0 1 2"), "has 1 kinks and 2 accelerations between parts; permitted are files without"),
        (("\n1\n", "\n3\n"), "has U_INTPOL 3; permitted are 1 and 2, without PERTURB"),
        (("\n1\n", "\n1 2\n"), "has U_INTPOL 1 2; permitted are 1 and 2"),
        (("'nose_2.prr'", "nose_2"), "permitted is slice 3 of 5: a position and 'file'"),
        (("nose_2.prr", "nose_9.prr"), r"has slice 3 in 'nose_9.prr', which cannot be read \(No such file"),
        (("nose_2.prr", "empty.prr"), "has slice 3 in 'empty.prr', which contains no points between"),
        (("0.01 1.0", "1"), "permitted is U_OFFSET and U_SCALE: 2 numbers"),
        (("49.990000 '", "-49.990000 '"), "position 4 is -0.04998 m, behind 0 m of the one before"),
    ],
)
def test_a_slice_file_that_cannot_be_used_is_refused(tmp_path, change, sentence):
    path = write_slices(tmp_path)
    (tmp_path / "empty.prr").write_text("point.begin\npoint.end\n")
    assert change[0] in path.read_text()
    path.write_text(path.read_text().replace(*change))
    with pytest.raises(ValueError, match=sentence) as raised:
        RailSections.from_file(path)
    assert str(raised.value).startswith("rail sections ") and "\n" not in str(raised.value)


def test_features_at_other_positions_are_refused(tmp_path):
    path = write_slices(tmp_path, features=[[0.0, 20.0]] * 5)
    path.write_text(path.read_text().replace("49.990000 0.0", "48.0 0.0"))
    with pytest.raises(
        ValueError, match="has features for 48 where slice 4 is at 49.99; permitted are the same"
    ):
        RailSections.from_file(path)


def test_parts_that_begin_are_refused(tmp_path):
    path = write_slices(tmp_path, features=[[0.0, 20.0]] * 4 + [[-1, -1]])
    with pytest.raises(
        ValueError, match="slice 5 at 0.1 m does not have feature 1; permitted are features that all"
    ):
        RailSections.from_file(path)


def test_smoothing_that_a_file_asks_for_is_told(tmp_path):
    with pytest.warns(
        UserWarning, match="U_INTPOL 2 asks for smoothing along the track: the surface goes through"
    ):
        RailSections.from_file(write_slices(tmp_path, middle="2"))


@TOML
@pytest.mark.parametrize(
    "text, sentence",
    [
        ("kind = ", "is not TOML"),
        ('kind = "rail"', "has the kind 'rail'; permitted is 'rail sections'"),
        ('kind = "rail sections"\nunit = "ft"', "has unit 'ft'; permitted are 'm' and 'mm'"),
        (
            'kind = "rail sections"\ncolour = 1',
            "has 'colour'; permitted are kind, name, position_unit, slice, unit",
        ),
        ('kind = "rail sections"\n[[slice]]\nposition = 0', "has fewer than 2 tables"),
        (
            'kind = "rail sections"\n[[slice]]\nposition = 0\n[[slice]]\nposition = 1',
            "has no position or no file in slice 1; permitted are a number and a name",
        ),
        (
            'kind = "rail sections"\n[[slice]]\nposition = 0\nfile = "a.csv"\nplace = 3\n[[slice]]',
            "has 'place' in slice 1; permitted are features, file, position",
        ),
        (
            'kind = "rail sections"\nunit = "mm"\n[[slice]]\nposition = 0\nfile = "a.csv"\nfeatures = [0, 20]\n'
            '[[slice]]\nposition = 1\nfile = "a.csv"',
            "has other features in slice 2 than in slice 1",
        ),
    ],
)
def test_a_toml_that_cannot_be_used_is_refused(tmp_path, text, sentence):
    (tmp_path / "a.csv").write_text(columns(nose_points()))
    (tmp_path / "own.toml").write_text(text)
    with pytest.raises(ValueError, match=sentence) as raised:
        RailSections.from_file(tmp_path / "own.toml")
    assert str(raised.value).startswith("rail sections ")


def test_other_endings_are_refused(tmp_path):
    with pytest.raises(ValueError, match=r"ends in \.csv; permitted are \.slcs and \.toml"):
        RailSections.from_file(tmp_path / "own.csv")
