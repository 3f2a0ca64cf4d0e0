"""Files of Python as trees, each read once for all tests of the structure."""

import ast
from functools import cache


@cache
def parsed(path):
    return ast.parse(path.read_text(encoding="utf-8"))
