"""Pyccel's command without what the translation of the kernel does not need.

Pyccel 2.2.3 reads and annotates a module once as itself and once more as what others import, looks for global
variables at every call, and writes wrappers for CPython and copies of libraries. Without that it writes the
same C in half the time.
"""

import functools
import gc

from pyccel.ast import variable
from pyccel.ast.core import FunctionDef
from pyccel.codegen import make_pipeline
from pyccel.codegen.wrappergen import Wrappergen
from pyccel.commands.console import pyccel_command
from pyccel.parser.parser import Parser

read_imported, cloned = Parser.parse_sons, FunctionDef.clone


def read_imported_once(self, parsers, verbose):
    """Pyccel looks for an imported module's parser by its path as text; it is known by its Path."""
    parsers.update({str(path): parser for path, parser in parsers.items()})
    return read_imported(self, parsers, verbose)


def clone_apart(self, name, **changed):
    """The clone of a function. An imported one is no user of the body that it shares with the function
    itself: a statement of a function has to have one function as its user."""
    clone = cloned(self, name, **changed)
    if changed.get("is_imported"):
        for attribute in clone._my_attribute_nodes:
            nodes = getattr(clone, attribute)
            for node in nodes if isinstance(nodes, tuple) else (nodes,):
                users = getattr(node, "_user_nodes", ())
                if users and users[-1] is clone:
                    users.pop()
    return clone


@functools.cache
def names_of_class(kind):
    return frozenset(dir(kind))


def main():
    gc.disable()  # it is a short run, and everything is in use
    Wrappergen.wrap = lambda self, folder: None
    make_pipeline.manage_dependencies = lambda *given, **options: None
    FunctionDef.global_vars = ()  # the kernel has none: Module refuses them
    Parser.parse_sons = read_imported_once
    FunctionDef.clone = clone_apart
    variable.dir = lambda node: names_of_class(type(node))  # clone() lists its own names for each of them
    pyccel_command()


if __name__ == "__main__":
    main()
