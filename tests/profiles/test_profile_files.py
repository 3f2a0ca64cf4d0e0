"""Profiles from the world: formats, what is repaired, what is refused, smoothing, and
files damaged at random.

Files are written here from S1002 and UIC60 at even arc lengths, with noise of known seeds; a
failing case names its seed.
"""

import math
import re

import numpy as np
import pytest

import wrcontact
from tests.helpers.profile_points import (
    MM,
    RNG,
    SINGLE,
    Y,
    Z,
    changed,
    columns,
    error,
    miniprof,
    points,
    read,
    simpack,
    swept,
)
from wrcontact.profiles import standard_profile
from wrcontact.profiles.files import LARGEST_FILE, prepared_text
from wrcontact.profiles.running_circle import BACK

# --- formats --------------------------------------------------------------------------------------


TEXTS = {
    "blanks": columns(Y, Z),
    "comma": columns(Y, Z, ","),
    "comma and blank": columns(Y, Z, ", "),
    "semicolon": "y;z\n" + columns(Y, Z, ";"),
    "tab": columns(Y, Z, "\t"),
    "decimal comma, semicolon": "\ufeffy [mm];z [mm]\n" + columns(Y, Z, ";").replace(".", ","),
    "decimal comma, blank": columns(Y, Z).replace(".", ","),
    "decimal comma, comma and blank": "".join(
        f"{a:.9f}\u002c {b:.9f}\n".replace(".", ",") for a, b in zip(Y, Z)
    ),
    "CRLF": columns(Y, Z).replace("\n", "\r\n"),
    "comments and header": "# wheel 7\n! left\nmeasured 2024 10 12\n700\n"
    + columns(Y, Z).replace("\n", " % point\n"),
    "columns by name": "s,z,y\n" + "".join(f"{k},{b:.12g},{a:.12g}\n" for k, (a, b) in enumerate(zip(Y, Z))),
    "more columns": "".join(f"{a:.12g} {b:.12g} 0.5 1\n" for a, b in zip(Y, Z)),
    "Fortran": columns(Y, Z).replace("e", "D"),
    "UTF-16": columns(Y, Z).encode("utf-16"),
    "Latin-1": "Räder\n".encode("latin-1") + columns(Y, Z).encode(),
}


@pytest.mark.parametrize("case", TEXTS)
def test_plain_text_is_read(tmp_path, case):
    profile, said = read(tmp_path, TEXTS[case])
    # the spline through points 0.2 mm apart; S1002's own steps are 1.2e-4
    assert said == "" and error(profile) < 1e-4


TURN = 0.02
SIMPACK = {
    "mm": (Y, Z, "units.len.f = 1000."),
    "m, descending": (Y[::-1] * MM, Z[::-1] * MM, "units.len.f = +1.0e+00\n inversion = 1"),
    "unit by name": (Y / 10, Z / 10, "units.len = 'cm'"),
    "mirrored": (-Y, -Z, "units.len.f = 1000\nmirror.y = 1\nmirror.z = 1"),
    "shifted": (Y + 3.0, Z - 2.0, "units.len.f = 1000\nshift.y = -3\nshift.z = 2"),
    "turned": (
        np.cos(TURN) * Y + np.sin(TURN) * Z,
        np.cos(TURN) * Z - np.sin(TURN) * Y,
        f"units.len.f = 1000\nunits.ang.f = {180 / math.pi!r}\nrotate = {math.degrees(TURN)!r}",
    ),
    "bounded": (
        np.append(Y, 90.0),
        np.append(Z, 77.0),
        "units.len.f = 1000\nbound.y.min = -80\nbound.y.max = 65\nbound.z.min = 1\nbound.z.max = 0",
    ),
    "near points": (np.repeat(Y, 2), np.repeat(Z, 2), "units.len.f = 1000\npoint.dist.min = 0.01"),
}


@pytest.mark.parametrize("case", SIMPACK)
def test_simpack_is_read_with_what_its_keys_ask_for(tmp_path, case):
    y, z, keys = SIMPACK[case]
    profile, said = read(tmp_path, simpack(y, z, "wheel", keys), name="own.prw")
    assert said == "" and error(profile) < 1e-4


def test_simpack_rail_and_weights(tmp_path):
    y, z = points("rail")
    z = np.where(np.arange(len(y)) == 300, z + 5.0, z)
    text = "".join(f"{a:.12g} {b:.12g} {0.0 if k == 300 else 1.0}\n" for k, (a, b) in enumerate(zip(y, z)))
    profile, said = read(tmp_path, simpack([], [], "rail").replace("! y z\n", text), "rail", "own.prr")
    assert said == "" and error(profile) < 1e-4


@pytest.mark.parametrize(
    "y, z",
    [(Y + BACK, 12.0 - Z), (-Y - BACK, 12.0 - Z), (Y[::-1] + BACK, Z[::-1])],
    ids=["from the flange's back, upwards", "the other side first", "downwards"],
)
def test_miniprof_wheel_is_found_from_its_shape(tmp_path, y, z):
    profile, said = read(tmp_path, miniprof(y, z), name="own.whl")
    assert said == "" and error(profile) < 2e-4 and profile.height(0.0) == pytest.approx(0.0, abs=1e-7)


def test_miniprof_rail_with_other_columns(tmp_path):
    y, z = points("rail")
    profile, said = read(tmp_path, miniprof(-z, y, "ColumnDef=Y,X,A,C,N\n"), "rail", "own.ban")
    assert said == "" and error(profile) < 1e-4


# --- repaired -------------------------------------------------------------------------------------


HALF = RNG.permutation(len(Y))
EDGE = (Y < -34.0) | (Y > -30.0)
RAIL_Y, RAIL_Z = points("rail")
FOOT_Y = np.array([-9.0, -9.0, -20.0, -75.0, -75.0])
FOOT_Z = np.array([42.0, 120.0, 128.0, 148.0, 160.0])


def dense(values):
    """Corner points of the foot, closer."""
    return np.interp(np.linspace(0, 4, 400), np.arange(5), values)[::-1]


#: Points, kind, what is said of them, and how far off the standard profile they may leave it [mm].
REPAIRED = {
    "outliers": (
        Y,
        changed(Z, SINGLE, RNG.uniform(0.1, 2.0, 30) * RNG.choice([-1, 1], 30)),
        "wheel",
        r"30 outliers of up to 1\.\d+ mm left out \(y = -\d+.* mm\)",
        2e-4,
    ),
    "outliers in y": (
        changed(Y, SINGLE[:9], 0.5),
        Z,
        "wheel",
        r"outliers? of up to 0\.\d+ mm left out",
        3e-3,
    ),
    "runs of outliers": (
        Y,
        changed(Z, SINGLE[:8, None] + np.arange(3), 0.7),
        "wheel",
        "24 outliers of up to 0.5",
        2e-4,
    ),
    "not in order": (Y[HALF], Z[HALF], "wheel", r"76\d points sorted by y", 1e-4),
    "two exchanged": (
        Y[np.r_[:300, 301, 300, 302 : len(Y)]],
        Z[np.r_[:300, 301, 300, 302 : len(Y)]],
        "wheel",
        r"2 points sorted by y \(y = -32",
        1e-4,
    ),
    "reversed": (
        Y[::-1],
        Z[::-1],
        "wheel",
        "the points ran from the largest y to the smallest; reversed",
        1e-4,
    ),
    "repeated": (np.repeat(Y, 2), np.repeat(Z, 2), "wheel", "767 repeated points left out", 1e-4),
    "measured twice": (
        np.tile(Y, 2),
        np.concatenate([Z, Z + 2e-3]),
        "wheel",
        r"sorted by y .*at the same y as others averaged \(y = .*z up to 2 um apart\)",
        3e-3,
    ),
    "not numbers": (
        np.where(np.arange(len(Y)) % 50 == 3, np.nan, Y),
        Z,
        "wheel",
        r"16 points without finite numbers left out \(line 4, 54, 104, \.\.\.\)",
        2e-4,
    ),
    "missing values": (
        Y,
        np.where(np.arange(len(Y)) % 50 == 3, -9999.0, Z),
        "wheel",
        "16 points far from the others left out",
        2e-4,
    ),
    "metres": (Y / 1e3, Z / 1e3, "wheel", "its width of 0.1298 means metres; converted to mm", 1e-4),
    "inches": (RAIL_Y / 25.4, RAIL_Z / 25.4, "rail", r"its width of 2.9\d* means inches", 1e-4),
    "centimetres": (Y / 10, Z / 10, "wheel", "means centimetres", 1e-4),
    "micrometres": (Y * 1e3, Z * 1e3, "wheel", "means micrometres", 1e-4),
    "mirrored": (-Y, Z, "wheel", "the flange was at the larger y; mirrored", 1e-4),
    "upside down": (RAIL_Y, -RAIL_Z, "rail", "z was positive upwards; its sign is changed", 1e-4),
    "from the flange's back": (
        Y + 70.0,
        Z - 9.0,
        "wheel",
        "running circle is assumed 70 mm from the back of the flange at y = 0 mm; y shifted by -70 mm",
        9.1,
    ),
    "another height": (Y, Z + 300.0, "wheel", "z was 300 mm at the running circle; shifted to 0", 1e-4),
    "gap": (Y[EDGE], Z[EDGE], "wheel", r"gap of 4\.\d+ mm bridged \(y = -34\.\d+ \.\.\. -29\.\d+ mm\)", 0.05),
    "straight gap": (
        Y[(Y < 35.0) | (Y > 50.0)],
        Z[(Y < 35.0) | (Y > 50.0)],
        "wheel",
        r"gap of 15\.\d+ mm bridged \(y = 34\.\d+ \.\.\. 50\.\d+ mm\)",
        1e-4,
    ),
    "whole section": (
        np.concatenate([dense(FOOT_Y), RAIL_Y, -dense(FOOT_Y)[::-1]]),
        np.concatenate([dense(FOOT_Z), RAIL_Z, dense(FOOT_Z)[::-1]]),
        "rail",
        "",
        1e-4,
    ),
}


@pytest.mark.parametrize("case", REPAIRED)
def test_what_can_be_put_right_is_and_solves(tmp_path, case):
    y, z, kind, sentence, off = REPAIRED[case]
    profile, said = read(tmp_path, columns(y, z), kind)
    if sentence:
        assert re.search(f"^{kind} profile own.txt: .*{sentence}", said), said
    else:
        assert said == ""
    assert error(profile) < off
    assert not swept(**{kind: profile}).status.any()


def head(y, corner=13.0):
    """A rail without crown: flat, with round corners, and a steep side below."""
    u = np.clip(np.abs(y) - 23.5, 0.0, corner - 1e-3)
    return corner - np.sqrt(corner**2 - u * u) + 20.0 * np.maximum(np.abs(y) - 36.4, 0.0)


def hollow(depth):
    return Z - depth * np.exp(-(((Y - 2.0) / 14.0) ** 4))


def worn_rail(depth, shift=-1.0):
    """A gauge corner worn to the shape of the wheel's root, which is let into it by ``depth`` [mm]."""
    wheel = np.interp(RAIL_Y, Y[Y > -45] + shift, Z[Y > -45])
    return np.maximum(RAIL_Z, wheel - np.max((wheel - RAIL_Z)[np.abs(RAIL_Y) < 30]) + depth)


WIDE = np.linspace(-36.8, 36.8, 500)
#: Points of a wheel and of a rail, and what is said of either.
WORN = {
    "hollow 1 mm": ((Y, hollow(1.0)), None, ""),
    "hollow 3 mm": ((Y, hollow(3.0)), None, ""),
    "flat rail": (None, (WIDE, head(WIDE)), ""),
    "conformal": ((Y, hollow(1.5)), (RAIL_Y, worn_rail(0.3)), "kink"),
    "kink": (
        (Y, Z - np.tan(np.radians(10.0)) * np.maximum(Y - 3.05, 0.0)),
        None,
        r"1 kink of up to 9\.\d+ deg rounded over 1 mm \(y = 3\.05 mm\), by up to 0\.04\d* mm",
    ),
    "chamfer": (
        (Y, Z - np.maximum(Y - 50.0, 0.0)),
        None,
        r"1 kink of up to 4\d.* deg rounded over 1 mm \(y = 50 mm\)",
    ),
    "vertical gauge face": (
        None,
        (
            np.r_[np.full(60, -34.0), RAIL_Y[np.abs(RAIL_Y) < 34]],
            np.r_[np.linspace(25.0, 8.7, 60), RAIL_Z[np.abs(RAIL_Y) < 34]],
        ),
        "",
    ),
}


@pytest.mark.full
@pytest.mark.parametrize("deviation", [0.0, 0.02], ids=["exact", "noisy"])
@pytest.mark.parametrize("case", WORN)
def test_worn_and_difficult_shapes_solve(tmp_path, case, deviation):
    rng, given_profiles, said = np.random.default_rng(5), {}, ""
    for kind, table in zip(("wheel", "rail"), WORN[case][:2]):
        if table is not None:
            table = [part + rng.normal(0.0, deviation, len(part)) for part in table]
            given_profiles[kind], words = read(tmp_path, columns(*table), kind)
            said += words
    assert re.search(
        "noise of .* um smoothed, points moved by up to" if deviation else WORN[case][2], said
    ), said
    state = swept(**given_profiles)
    assert not state.status.any()
    assert np.all(state.right.area > 0.0) and np.all(state.right.max_pressure > 0.0)


# --- refused --------------------------------------------------------------------------------------


SPIKED = changed(Z, RNG.choice(len(Z), 150, replace=False), 3.0)
REFUSED = {
    "empty": (
        b"",
        "wheel",
        "own.txt",
        "contains no lines of two numbers; permitted are text files with y and z in mm",
    ),
    "too few": (columns(Y[::100], Z[::100]), "wheel", "own.txt", "has 8 points; permitted are 10 or more"),
    "too many": (
        columns(np.tile(Y, 30), np.tile(Z, 30)),
        "wheel",
        "own.txt",
        "has 23010 points; permitted are at most 20000",
    ),
    "too large": (
        b"1 2\n" * (LARGEST_FILE // 4 + 1),
        "wheel",
        "own.txt",
        "has more than 4 MB; permitted are files of at most that",
    ),
    "only NaN": (
        "nan nan\n" * 50,
        "wheel",
        "own.txt",
        "has only points that are not finite numbers; permitted are numbers in mm",
    ),
    "unknown unit": (
        columns(Y * 7, Z * 7),
        "wheel",
        "own.txt",
        r"is 908\.\d+ mm wide; permitted are 20 \.\.\. 200 mm",
    ),
    "too high": (
        columns(Y, 30 * Z),
        "wheel",
        "own.txt",
        r"is \d+\.?\d* mm high; permitted are 300 mm or less",
    ),
    "no flange": (
        columns(Y[Y > -25], Z[Y > -25]),
        "wheel",
        "own.txt",
        r"has the tip of its flange, or its deepest point, at y = -24.* mm; permitted are -80 "
        r"\.\.\. -30 mm",
    ),
    "low flange": (
        columns(Y, Z / 4),
        "wheel",
        "own.txt",
        r"has a flange of \d.* mm, .*; permitted are 10 \.\.\. 60 mm",
    ),
    "rail for wheel": (
        columns(RAIL_Y, RAIL_Z),
        "wheel",
        "own.txt",
        "has its field side 39.* mm deeper than the running circle, as a rail's head",
    ),
    "wheel for rail": (
        columns(Y, Z),
        "rail",
        "own.txt",
        r"is 129\.8 mm wide before it turns back; permitted are 20 \.\.\. 110 mm for a rail",
    ),
    "half a rail": (
        columns(RAIL_Y[RAIL_Y > 0], RAIL_Z[RAIL_Y > 0]),
        "rail",
        "own.txt",
        "permitted are heads with 2 mm or more on either side",
    ),
    "gap": (
        columns(Y[(Y < -5) | (Y > 15)], Z[(Y < -5) | (Y > 15)]),
        "wheel",
        "own.txt",
        r"has no points between y = -5\.\d+ and 15\.\d+ mm, a gap of 20\.\d mm; permitted are 10 mm or "
        r"a straight",
    ),
    "outliers everywhere": (
        columns(Y, SPIKED),
        "wheel",
        "own.txt",
        r"has \d+ outliers or more among its 767 points; permitted are at most 10%",
    ),
    "strong noise": (
        columns(Y, Z + np.random.default_rng(1).normal(0, 1.5, len(Z))),
        "wheel",
        "own.txt",
        r"has noise of \d+ um; permitted is at most 500 um",
    ),
    "fold": (
        columns(np.r_[Y[:400], Y[395:]], np.r_[Z[:400], Z[395:] + 3.0]),
        "wheel",
        "own.txt",
        "a spike or a fold; permitted are at most 90 deg",
    ),
    "a wall too high": (
        columns(np.maximum(RAIL_Y, -28.0), RAIL_Z),
        "rail",
        "own.txt",
        r"folds back or is vertical at y = .* mm, z = .* mm; permitted is that from z = 5 "
        r"mm on$",
    ),
    "commas": (
        "".join(f"{k},5,{k},25\n" for k in range(60)),
        "wheel",
        "own.csv",
        "has commas that may be decimal signs or separators",
    ),
    "other kind by name": (
        columns(Y, Z),
        "rail",
        "own.prw",
        "ends in .prw, which is a wheel profile; permitted are rail profiles",
    ),
    "other kind inside": (
        simpack(Y, Z, "rail"),
        "wheel",
        "own.prw",
        "says header type 0, which is a rail profile; permitted are wheel",
    ),
    "no Simpack points": (
        "header.begin\nheader.end\n",
        "wheel",
        "own.prw",
        "contains no points between point.begin and point.end",
    ),
    "no MiniProf points": (
        "ColumnDef=X,Y\n\n",
        "rail",
        "own.ban",
        "contains no lines of numbers after its header",
    ),
    "not prepared": (
        '{"zones": 3}',
        "wheel",
        "own.json",
        "is JSON, but not a profile of wrcontact; permitted are points",
    ),
    "prepared, not finite": (
        prepared_text(standard_profile("UIC60")).replace("300.0", "NaN"),
        "rail",
        "own.json",
        "values that are not finite numbers",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_used_is_refused_in_one_sentence(tmp_path, case):
    text, kind, name, sentence = REFUSED[case]
    with pytest.raises(ValueError) as refusal:
        read(tmp_path, text, kind, name)
    said = str(refusal.value)
    assert said.startswith(f"{kind} profile {tmp_path / name} ") and "\n" not in said
    assert re.search(sentence, said), said


@pytest.mark.parametrize("smoothing", [-1e-6, 0.01, math.nan, "much"])
def test_smoothing_out_of_range_is_refused(tmp_path, smoothing):
    with pytest.raises(ValueError, match=r"smoothing is .*; permitted is 0 \.\.\. 0.0005 m"):
        read(tmp_path, TEXTS["blanks"], smoothing=smoothing)
    with pytest.raises(ValueError, match="smoothing is"):
        wrcontact.ContactSystem(smoothing=smoothing)
