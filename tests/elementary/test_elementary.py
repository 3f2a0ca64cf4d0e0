"""Elementary functions of the kernel against mpmath, and in C against Python."""

import ctypes
import math
import random
import re
import subprocess
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mp

from tests.helpers.paths import ROOT, TESTS
from tools.make_elementary import constants
from wrcontact.kernel.binding.compiler import FLAGS, find_compiler
from wrcontact.kernel.elementary import circle, powers
from wrcontact.kernel.elementary.binary import counted
from wrcontact.kernel.elementary.whole import COUNTED, nearest_whole, rounded_up

COUNT = 800
#: Largest error [units in the last place]; twenty times as many arguments gave 0.92.
LARGEST = 0.95
ELEMENTARY = ROOT / "wrcontact" / "kernel" / "elementary"


def sine(x):
    return circle.sine_cosine(x)[0]


def cosine(x):
    return circle.sine_cosine(x)[1]


def even(low, high):
    return lambda draw: draw.uniform(low, high)


def far(low, high):
    """Of either sign, over orders of magnitude."""
    return lambda draw: draw.choice((-1.0, 1.0)) * math.exp(draw.uniform(math.log(low), math.log(high)))


def positive(low, high):
    return lambda draw: abs(far(low, high)(draw))


def near_quarters(draw):
    """The floats next to multiples of pi/2, where nothing but what was lost in the reduction is left."""
    return float(draw.randint(-600_000, 600_000) * mp.pi / 2)


@pytest.mark.parametrize(
    "function, exact, arguments",
    [
        (sine, mp.sin, [even(-0.13, 0.13)]),  # yaw and roll
        (sine, mp.sin, [even(-4.0, 4.0)]),
        (sine, mp.sin, [even(-1e6, 1e6)]),
        (sine, mp.sin, [near_quarters]),
        (sine, mp.sin, [far(1e-320, 1e-3)]),
        (cosine, mp.cos, [even(-4.0, 4.0)]),
        (cosine, mp.cos, [even(-1e6, 1e6)]),
        (cosine, mp.cos, [near_quarters]),
        (cosine, mp.cos, [far(1e-320, 1e-3)]),
        (circle.atan, mp.atan, [even(-0.44, 0.44)]),
        (circle.atan, mp.atan, [even(-3.0, 3.0)]),
        (circle.atan, mp.atan, [far(1e-320, 1e300)]),
        (circle.atan2, mp.atan2, [even(-1.0, 1.0), even(-1.0, 1.0)]),
        (circle.atan2, mp.atan2, [far(1e-130, 1e130), far(1e-130, 1e130)]),
        (powers.exp, mp.exp, [even(-40.0, 1.0)]),
        (powers.exp, mp.exp, [even(-745.0, 709.7)]),
        (powers.exp, mp.exp, [far(1e-20, 1.0)]),
        (powers.log, mp.log, [even(0.5, 2.0)]),
        (powers.log, mp.log, [lambda draw: 1.0 + far(1e-15, 0.3)(draw)]),
        (powers.log, mp.log, [positive(5e-324, 1.7e308)]),
        (powers.cube_root, mp.cbrt, [even(1.0, 8.0)]),
        (powers.cube_root, mp.cbrt, [positive(5e-324, 1.7e308)]),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_errors_are_below_one_unit_in_the_last_place(function, exact, arguments):
    draw = random.Random(0)
    with mpmath.workprec(250):
        for _ in range(COUNT):
            given = [argument(draw) for argument in arguments]
            wanted = exact(*map(mp.mpf, given))
            error = abs(mp.mpf(function(*given)) - wanted) / math.ulp(float(wanted))
            assert error < LARGEST, given


INF, NAN = math.inf, math.nan
EDGES = [
    (sine, (0.0,), 0.0),
    (sine, (-0.0,), -0.0),
    (cosine, (-0.0,), 1.0),
    (sine, (5e-324,), 5e-324),
    (sine, (INF,), NAN),
    (cosine, (-INF,), NAN),
    (sine, (NAN,), NAN),
    (cosine, (1e300,), NAN),
    (circle.atan, (0.0,), 0.0),
    (circle.atan, (-0.0,), -0.0),
    (circle.atan, (INF,), math.pi / 2),
    (circle.atan, (-INF,), -math.pi / 2),
    (circle.atan, (NAN,), NAN),
    (circle.atan, (1.0,), math.pi / 4),
    *(
        (circle.atan2, (y, x), math.atan2(y, x))
        for y in (0.0, -0.0, 1.0, -1.0, INF, -INF)
        for x in (0.0, -0.0, 1.0, -1.0, INF, -INF)
    ),
    (circle.atan2, (NAN, 1.0), NAN),
    (circle.atan2, (1.0, NAN), NAN),
    (powers.exp, (0.0,), 1.0),
    (powers.exp, (-0.0,), 1.0),
    (powers.exp, (-INF,), 0.0),
    (powers.exp, (INF,), INF),
    (powers.exp, (710.0,), INF),
    (powers.exp, (-746.0,), 0.0),
    (powers.exp, (NAN,), NAN),
    (powers.exp, (-745.1,), 5e-324),
    (powers.log, (1.0,), 0.0),
    (powers.log, (0.0,), -INF),
    (powers.log, (-1.0,), NAN),
    (powers.log, (INF,), INF),
    (powers.log, (NAN,), NAN),
    (powers.cube_root, (0.0,), 0.0),
    (powers.cube_root, (INF,), INF),
    (powers.cube_root, (NAN,), NAN),
    (powers.cube_root, (-8.0,), -2.0),
    (powers.cube_root, (27.0,), 3.0),
    (nearest_whole, (2.5,), 2.0),
    (nearest_whole, (-2.6,), -3.0),
    (rounded_up, (3.0,), 3),
    (rounded_up, (3.1,), 4),
    (rounded_up, (0.0,), 0),
    (counted, (COUNTED,), 0),
    (counted, (COUNTED + 4294967295.0,), 4294967295),
]


@pytest.mark.parametrize("function, given, wanted", EDGES, ids=lambda value: getattr(value, "__name__", None))
def test_edges(function, given, wanted):
    """Zeros with their signs, infinities and what is no number."""
    found = function(*given)
    assert found == wanted or math.isnan(found) and math.isnan(wanted)
    assert math.copysign(1.0, found) == math.copysign(1.0, wanted) or math.isnan(wanted)


def test_odd_functions_are_odd_to_the_last_bit():
    """A wheelset and its mirror image have the same bits."""
    for x in map(even(-4.0, 4.0), [random.Random(1)] * COUNT):
        assert sine(-x) == -sine(x) and cosine(-x) == cosine(x) and circle.atan(-x) == -circle.atan(x)


def test_the_numbers_are_those_of_the_tool():
    """Every constant that the tool makes stands in the room."""
    text = "".join(path.read_text() for path in ELEMENTARY.glob("*.py"))
    written = dict(re.findall(r"^(\w+): Final\[float\] = (\S+)", text, re.MULTILINE))
    for name, value in constants().items():
        assert float(written[name]) == value, name


@pytest.fixture(scope="module", params=["-O3", "-O1", "-O3 -march=haswell"])
def compiled(request, tmp_path_factory):
    """The functions in C, also for a processor with fused multiply-add."""
    compiler, flags = find_compiler(), request.param.split()
    if compiler is None:
        pytest.skip("there is no compiler")
    if "-march=haswell" in flags and " fma " not in processor():
        pytest.skip("this processor has no fused multiply-add")
    library = tmp_path_factory.mktemp("elementary") / "functions.so"
    subprocess.run(
        [
            *compiler,
            *FLAGS,
            "-fvisibility=default",
            *flags,
            "-shared",
            "-I",
            str(ROOT / "wrcontact"),
            str(TESTS / "elementary" / "functions.c"),
            "-o",
            str(library),
        ],
        check=True,
    )
    return ctypes.CDLL(str(library)).elementary


def processor():
    """What Linux says of the processor, or ''."""
    file = Path("/proc/cpuinfo")
    return file.read_text() if file.exists() else ""


def test_c_gives_the_bits_of_python(compiled):
    draw = random.Random(2)
    kinds = [
        even(-4.0, 4.0),
        far(1e-320, 1e300),
        even(-745.0, 745.0),
        near_quarters,
        lambda draw: draw.choice((0.0, -0.0, INF, -INF, NAN, 1.0)),
    ]
    pairs = np.array([[draw.choice(kinds)(draw), draw.choice(kinds)(draw)] for _ in range(20_000)])
    found = np.empty((len(pairs), 7))
    compiled(*(ctypes.c_void_p(array.ctypes.data) for array in (pairs, found)), ctypes.c_int64(len(pairs)))
    wanted = np.array(
        [
            [
                *circle.sine_cosine(x),
                circle.atan(x),
                circle.atan2(x, y),
                powers.exp(x),
                powers.log(x),
                powers.cube_root(x),
            ]
            for x, y in pairs.tolist()
        ]
    )
    numbers = ~np.isnan(wanted)
    np.testing.assert_array_equal(np.isnan(found), ~numbers)
    np.testing.assert_array_equal(found[numbers].view(np.int64), wanted[numbers].view(np.int64))
