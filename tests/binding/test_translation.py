"""The writer of C (tools/transpile): random programs of the dialect compute the same bits in C as in Python, and
what would be something else in C is refused with its line."""

import ctypes
import gc
import math
import random
import re
import shutil
import struct
import subprocess
import weakref

import pytest

from tests.helpers.paths import ROOT
from tools.transpile_kernel import Kernel, Module, Refused, definition, emitted

NATIVE = ROOT / "wrcontact" / "kernel" / "native"
COMPILER = shutil.which("gcc") or shutil.which("cc")
needs_compiler = pytest.mark.skipif(not COMPILER, reason="no C compiler here")


def written(tmp_path, text, name="trap"):
    """The functions of one module: (head, text) by name."""
    path = tmp_path / f"{name}.py"
    path.write_text(text)
    module = Module(path)
    module.refuse_silent_traps()
    return emitted(Kernel([module]), module)


def compiled(tmp_path, functions):
    """A library of some functions."""
    texts = [text for _, text in functions.values()]
    heads = [f"{head};" for head, _ in functions.values()]
    source = tmp_path / "functions.c"
    source.write_text("\n".join([f'#include "{NATIVE}/spans.h"', *heads, *texts]))
    flags = [
        "-O1",
        "-ffp-contract=off",
        "-fno-math-errno",
        "-Wall",
        "-Wno-unused",
        "-Wno-tautological-compare",
        "-Werror",
    ]
    library = tmp_path / "functions.so"
    subprocess.run([COMPILER, *flags, "-shared", "-fPIC", str(source), "-o", str(library), "-lm"], check=True)
    return ctypes.CDLL(str(library))


class Draw:
    """Random expressions of the dialect over floats x y z, ints i j and what a function has assigned."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def floats(self, depth):
        if depth == 0:
            return self.random.choice(["x", "y", "z", "0.1", "2.5", "1e-9", "-3.0", "LIMIT"])
        one, other = self.floats(depth - 1), self.floats(depth - 1)
        return self.random.choice(
            [
                f"({one} {self.random.choice('+-*/')} ({other}))",
                f"({one}) {self.random.choice('+-*')} {other}",
                f"-({one})",
                f"- -{self.floats(0)} - -{self.floats(0)}",
                f"sqrt(fabs({one}))",
                f"copysign({one}, {other})",
                f"{self.random.choice(['min', 'max'])}({one}, {other})",
                f"float({self.ints(depth - 1)})",
                f"({self.ints(depth - 1)}) * {self.floats(0)} / ({other})",
                f"({self.ints(depth - 1)}) / 7",
            ]
        )

    def ints(self, depth):
        if depth == 0:
            return self.random.choice(["i", "j", "3", "7", "COUNT"])
        one, other = self.ints(depth - 1), self.ints(depth - 1)
        return self.random.choice(
            [
                f"({one} {self.random.choice('+-')} ({other}))",
                f"({one}) * {self.ints(0)} % {self.random.choice(['5', '-5', '1048573'])}",
                f"({one}) // {self.random.choice(['3', '-4'])}",
                f"-({one})",
                f"(1 << {self.random.choice(['3', '40'])}) - {one}",
                f"{self.random.choice(['min', 'max'])}({one}, {other})",
            ]
        )

    def bools(self, depth):
        sign = self.random.choice(["<", "<=", ">", ">=", "==", "!="])
        kind = self.random.choice([self.floats, self.ints])
        compared = f"{kind(1)} {sign} {kind(1)}"
        if depth == 0:
            return compared
        one, other = self.bools(depth - 1), self.bools(depth - 1)
        return self.random.choice(
            [
                compared,
                f"({one}) and ({other})",
                f"{one} or {other}",
                f"not ({one})",
                f"not {one} and {other}",
            ]
        )

    def function(self, name):
        return f'''
def {name}(x: float, y: float, z: float, i: int, j: int):
    """Random."""
    n = {self.ints(2)}
    n %= 1000003
    u = {self.floats(3)}
    if {self.bools(2)}:
        u = {self.floats(3)}
    elif {self.bools(1)}:
        u *= {self.floats(1)}
        x, y = y, x
    else:
        u -= {self.floats(2)}
    for k in range({self.random.choice(["j", "n % 4", "5, n % 3, -2"])}):
        n = (n + k * {self.ints(1)}) % 1000003
        u = 0.5 * u + {self.floats(2)}
    while n > 5 and {self.bools(0)}:
        n = n // 2 - 1
        z = -z
        if n == 77:
            break
    return u * z + x - {self.floats(2)}, n, {self.bools(1)}
'''


HEAD = """'''Random functions.'''

from math import copysign, fabs, sqrt
from typing import Final

LIMIT: Final[float] = 0.75
COUNT: Final[int] = 11
"""


def answer(function, row):
    """What Python computes, or None where it divides by zero or the numbers are larger than C has."""
    try:
        number, count, truth = function(*row)
    except (ZeroDivisionError, OverflowError):
        return None
    return None if abs(count) > 2**31 else (struct.pack("<d", number), count, truth)


@needs_compiler
def test_random_programs_have_the_same_bits_in_c_as_in_python(tmp_path):
    draw = Draw(7)
    names = [f"f{number}" for number in range(30)]
    text = HEAD + "".join(draw.function(name) for name in names)
    scope = {}
    exec(compile(text, "random.py", "exec"), scope)
    functions = written(tmp_path, text, "draw")
    constants = {name: ("", definition(f"draw__{name}", scope[name])) for name in ("LIMIT", "COUNT")}
    heads = "\n".join(text for _, text in constants.values())
    functions = {"constants": ("", heads)} | functions
    library = compiled(tmp_path, functions)
    asked = 0
    for name in names:
        call = getattr(library, f"draw__{name}")
        call.restype = None
        for _ in range(20):
            row = [draw.random.gauss(0.0, 2.0) for _ in range(3)] + [
                draw.random.randint(-9, 9) for _ in range(2)
            ]
            wanted = answer(scope[name], row)
            if wanted is None:
                continue
            number, count, truth = ctypes.c_double(), ctypes.c_int64(), ctypes.c_bool()
            given = [ctypes.c_double(x) for x in row[:3]] + [ctypes.c_int64(n) for n in row[3:]]
            call(ctypes.byref(number), ctypes.byref(count), ctypes.byref(truth), *given)
            found = (struct.pack("<d", number.value), count.value, truth.value)
            if math.isnan(number.value):
                found = (wanted[0] if math.isnan(struct.unpack("<d", wanted[0])[0]) else b"", *found[1:])
            assert found == wanted, f"{name}{tuple(row)}: {functions[name][1]}"
            asked += 1
    assert asked > 300


@pytest.mark.parametrize(
    "body, why",
    [
        ("for i in range(3):\n        x += 1.0\n    else:\n        x = 0.0", "a loop has no else"),
        ("for i in range(3):\n        i += 1", "changes its own variable"),
        ("for i in range(3):\n        x += 1.0\n    x += i", "one turn further"),
        ("x = x ** 2", "power differs from machine to machine"),
        ("x = x ** 0.3", "power differs from machine to machine"),
        ("x = 1", "1 is a int, and a float is wanted"),
        ("n = 1\n    n = x", "x is a float, and a int is wanted"),
        ("n = 1\n    n /= 2", "n / 2 is a float, and a int is wanted"),
        ("b = x > 0.0\n    b = 1", "1 is a int, and a bool is wanted"),
        ("x = x // 2.0", "wants two ints"),
        ("x = x + (x > 0.0)", "computes with a bool"),
        ("x = max(x, 1)", "compares a float with a int"),
        ("if x:\n        x = 0.0", "a condition is a bool"),
        ("if x > 0.0 and 3:\n        x = 0.0", "'and' and 'or' join bools"),
        ("if 0.0 < x < 1.0:\n        x = 0.0", "two values are compared"),
        ("x = abs(x)", "abs is a function that neither"),
        ("x = fabs(x) if x < 1.0 else 0.0", "is a IfExp, and a float is wanted"),
        ("for i in range(x):\n        x = 0.0", "the range wants an int"),
        ("for i in range(0, 9, i):\n        x = 0.0", "the step of a range is a whole number"),
        ("x = x @ x", "the dialect has no MatMult"),
        ("try:\n        x = 0.0\n    finally:\n        x = 1.0", "the dialect has no Try"),
    ],
)
def test_python_that_means_something_else_in_c_is_refused(tmp_path, body, why):
    with pytest.raises(Refused, match=f"trap.py, line .*{re.escape(why)}"):
        written(
            tmp_path, f"from math import fabs\n\n\ndef trap(x: float) -> float:\n    {body}\n    return x\n"
        )


@pytest.mark.parametrize("name", ["sin", "hypot", "floor", "log1p"])
def test_inexact_functions_are_refused(tmp_path, name):
    """Also floor: where a processor lacks it, it is one of the mathematical library's."""
    with pytest.raises(Refused, match=f"trap.py, line 1: {name} of math differs"):
        written(
            tmp_path, f"from math import fabs, {name}\n\n\ndef inexact(x: float):\n    return {name}(x)\n"
        )


@needs_compiler
def test_the_end_of_a_range_is_read_once(tmp_path):
    text = (
        "def turns(n: int):\n    total = 0\n    for i in range(1, n + 1):\n        n = 2\n        total += n * i\n"
        "    return total\n"
    )
    library = compiled(tmp_path, written(tmp_path, text))
    library.trap__turns.restype, library.trap__turns.argtypes = ctypes.c_int64, [ctypes.c_int64]
    assert library.trap__turns(5) == 2 * (1 + 2 + 3 + 4 + 5)


@needs_compiler
def test_results_of_a_call_may_go_where_its_arguments_were(tmp_path):
    text = """
def pair(one: float, other: float):
    return other, one - other


def turned(x: 'float[:]'):
    x[0], x[1] = pair(x[0], x[1])
    x[1], x[0] = x[0], x[1] + 1.0
    pair(x[0], 2.0)
    return x[0] - 10.0 * x[1]
"""
    functions = written(tmp_path, text)
    array = "array_double_1d trap__x(double* x) { return span_of(x, 2); }"
    entry = "double trap__entry(double* x) { return trap__turned(trap__x(x)); }"
    library = compiled(tmp_path, functions | {"array": ("", array), "entry": ("", entry)})
    library.trap__entry.restype = ctypes.c_double
    scope, numbers = {}, [3.0, 5.0]
    exec(text, scope)
    assert library.trap__entry((ctypes.c_double * 2)(*numbers)) == scope["turned"](numbers) == -51.0


def test_comments_and_names_of_the_python_stand_in_the_c(tmp_path):
    text = 'def half(x: float):\n    """Half of x."""\n    # a remark */ here\n    y = 0.5 * x  # beside it\n    return y\n'
    head, body = written(tmp_path, text)["half"]
    assert head == "double trap__half(double x)"
    assert "    /* a remark * / here */\n    /* beside it */\n    y = 0.5 * x;\n    return y;\n" in body


def test_trees_are_forgotten_with_their_kernel(tmp_path):
    """A process that translates one kernel after another, as that of planted errors, does not keep them."""
    path = tmp_path / "kept.py"
    path.write_text("LIMIT: Final[float] = 2.0\n\n\ndef twice(x: float):\n    return LIMIT * x\n")
    module = Module(path)
    kernel = Kernel([module])
    assert "twice" in emitted(kernel, module)
    trees = [weakref.ref(module.tree), weakref.ref(kernel.node("kept", "twice"))]
    assert all(tree() is not None for tree in trees)
    del module, kernel
    gc.collect()
    assert [tree() for tree in trees] == [None, None]
