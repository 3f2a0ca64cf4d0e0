"""Damaged profile files: read, or refused in a sentence."""

import time
import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from data.noisy_profiles import NAMES
from tests.helpers.profile_points import columns, miniprof, points, simpack
from wrcontact import Profile, ProfileWarning
from wrcontact.profiles import standard_profile
from wrcontact.profiles.files import prepared_text

COARSE = {kind: points(kind, 0.5) for kind in NAMES}
VALUES = st.sampled_from([0.0, 1e-3, 1e3, 1e300, -1e300, -9999.0, float("nan"), float("inf"), 25.4])
DAMAGE = st.one_of(
    st.tuples(st.just("noise"), st.integers(0, 999), st.sampled_from([1e-4, 1e-2, 0.1, 2.0])),
    st.tuples(st.just("cut"), st.integers(0, 270), st.integers(1, 200)),
    st.tuples(st.just("scale"), VALUES, VALUES),
    st.tuples(st.just("shuffle"), st.integers(0, 999), st.just(0)),
    st.tuples(st.just("set"), st.integers(0, 999), VALUES),
    st.tuples(st.just("again"), st.integers(0, 999), st.just(0)),
    st.tuples(st.just("round"), st.just(0), st.integers(0, 3)),
)


def damaged(table, damages):
    y, z = (part.copy() for part in table)
    for name, first, second in damages:
        if len(y) < 2:
            break
        if name == "noise":
            rng = np.random.default_rng(first)
            y, z = y + rng.normal(0, second, len(y)), z + rng.normal(0, second, len(z))
        elif name == "cut":
            y, z = np.delete(y, slice(first, first + second)), np.delete(z, slice(first, first + second))
        elif name == "scale":
            with np.errstate(all="ignore"):
                y, z = y * first, z * second
        elif name == "round":
            y, z = np.round(y, second), np.round(z, second)
        elif name == "set":
            z[np.random.default_rng(first).integers(0, len(z), 1 + len(z) // 30)] = second
        else:
            rng = np.random.default_rng(first)
            order = rng.permutation(len(y)) if name == "shuffle" else np.sort(rng.integers(0, len(y), len(y)))
            y, z = y[order], z[order]
    return y, z


@st.composite
def damaged_files(draw):
    """Bytes, the name's end and the kind asked for."""
    kind = draw(st.sampled_from(sorted(NAMES)))
    end = draw(
        st.sampled_from(
            {
                "wheel": [".txt", ".csv", ".prw", ".whl", ".json"],
                "rail": [".txt", ".csv", ".prr", ".ban", ".json"],
            }[kind]
        )
    )
    y, z = damaged(COARSE[kind], draw(st.lists(DAMAGE, max_size=3)))
    if end in (".prw", ".prr"):
        names = [
            "shift.y",
            "mirror.z",
            "rotate",
            "units.len.f",
            "units.ang.f",
            "bound.z.max",
            "point.dist.min",
            "inversion",
        ]
        keys = draw(st.dictionaries(st.sampled_from(names), VALUES, max_size=3))
        text = simpack(y, z, kind, "\n".join(f"{key} = {value}" for key, value in keys.items()))
    elif end in (".whl", ".ban"):
        text = miniprof(y, z)
    elif end == ".json":
        text = prepared_text(standard_profile(NAMES[kind]))
    else:
        text = columns(y, z, draw(st.sampled_from([" ", ";", ",", "\t", ", "])))
    content = text.encode()
    for _ in range(draw(st.integers(0, 2))):
        place = draw(st.integers(0, len(content)))
        junk = draw(st.binary(max_size=40))
        content = draw(
            st.sampled_from(
                [
                    content[:place],
                    content[place:],
                    content[:place] + junk + content[place:],
                    content[:place] + content,
                ]
            )
        )
    return content, end, kind


def check_any_file(folder, content, end, kind):
    """A Profile, or one sentence that starts with the file's name; nothing else, and soon."""
    path = folder / f"any{end}"
    path.write_bytes(content)
    began = time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            warnings.simplefilter("ignore", ProfileWarning)
            profile = Profile.from_file(path, kind)
    except ValueError as refusal:
        said = str(refusal)
        assert said.startswith(f"{kind} profile {path} "), said
        assert "\n" not in said
    else:
        assert profile.kind == kind and profile.start < profile.stop
        assert np.all(np.isfinite(profile.height(np.linspace(profile.start, profile.stop, 50)[1:-1])))
    assert time.process_time() - began < 20.0  # [s] of processor; some tenths


QUIET = [HealthCheck.function_scoped_fixture, HealthCheck.too_slow, HealthCheck.data_too_large]


@pytest.mark.full
@settings(max_examples=20, deadline=None, suppress_health_check=QUIET, derandomize=True, print_blob=True)
@given(file=damaged_files())
def test_damaged_files_are_read_or_refused(tmp_path, file):
    check_any_file(tmp_path, *file)


@pytest.mark.complete
@settings(max_examples=3000, deadline=None, suppress_health_check=QUIET, print_blob=True)
@given(file=damaged_files())
def test_many_damaged_files_are_read_or_refused(tmp_path, file):
    check_any_file(tmp_path, *file)


@settings(max_examples=60, deadline=None, suppress_health_check=QUIET, derandomize=True, print_blob=True)
@given(
    content=st.binary(max_size=2000),
    end=st.sampled_from([".txt", ".prw", ".whl", ".prr", ".ban", ".json"]),
    kind=st.sampled_from(sorted(NAMES)),
)
def test_any_bytes_are_read_or_refused(tmp_path, content, end, kind):
    check_any_file(tmp_path, content, end, kind)


@pytest.mark.full
@pytest.mark.parametrize(
    "text",
    [
        b"1" * 3_000_000 + b"x",
        b"\n" * 3_000_000,
        b" " * 3_000_000,
        b'{"a":' + b"[" * 3_000_000,
        b"point.begin\n" * 200_000,
        b"1,2,3," * 50_000,
    ],
    ids=["digits", "lines", "blanks", "brackets", "sections", "fields"],
)
def test_large_nonsense_does_not_hang(tmp_path, text):
    check_any_file(tmp_path, text, ".txt", "wheel")
