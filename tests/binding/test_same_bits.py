"""The compiled kernel and its Python source are one program, to the last bit: every method in a few poses, in
the full tests in many."""

import numpy as np
import pytest

from tests.helpers.kernel_runs import FORMS, bits, id_of, needs_library, poses, run_steps

#: Wheelsets of the check, and of the full tests; an elastic one is a dozen times the work.
FEW, MANY, MANY_ELASTIC = 12, 80, 30

METHODS = [
    {},
    {"normal_model": "hertz", "longitudinal_curvature": "basic", "stations": 7},
    {"normal_model": "analyn_strip", "stations": 61},
    {"normal_model": "analyn_strip", "nodes": 38, "strips": 13, "sweeps": 7},
    {"separation": "equidistant", "normal_model": "analyn_strip"},
    {"wear_outputs": True, "tangential_model": "strips", "stations": 7},
    *(form for form in FORMS if "lateral_curvature" not in form),
]
#: The uncompiled kernel prepares their tables for seconds.
ONLY_FULL = [
    {"separation": "vertical", "lateral_curvature": "rough"},
    {"separation": "equidistant_chord", "lateral_curvature": "smooth"},
    {"lateral_curvature": "rough", "normal_model": "hertz", "curvature_step": 1e-3},
    *(form for form in FORMS if "lateral_curvature" in form),
]


@needs_library
@pytest.mark.parametrize("count", [FEW, pytest.param(MANY, marks=pytest.mark.full)])
@pytest.mark.parametrize(
    "parameters",
    [*METHODS, *(pytest.param(methods, marks=pytest.mark.full) for methods in ONLY_FULL)],
    ids=id_of,
)
@pytest.mark.turns(3)
def test_compiled_and_python_agree_to_the_last_bit(tmp_path, parameters, count):
    rows = poses(min(count, MANY_ELASTIC) if parameters.get("contact_mode") == "elastic" else count)
    compiled = run_steps(rows, tmp_path, choice="compiled", **parameters)
    source = run_steps(rows, tmp_path, choice="python", **parameters)
    assert len(set(compiled[:, 0])) > 1, "the poses should meet more than one status"
    np.testing.assert_array_equal(bits(compiled), bits(source))
