"""What stands around the functions of a module in C: constants, prototypes, comments."""

import ast

from .modules import Refused

#: How a function is declared that has a mark (kernel/layout/record.py), or none.
STORAGE = {None: "static inline", "seldom": "static OUT_OF_LINE", "inlined": "static ALWAYS_INLINE"}


def constants(module, values):
    """Lines of the constants of a module."""
    definitions = [definition(f"{module.name}__{name}", value) for name, value in values.items()]
    return ["", f"/* {module.place} */", *definitions] if definitions else []


def definition(name, value):
    """C definition of one constant."""
    if isinstance(value, tuple):
        return f"static const double {name}[] = {{{', '.join(map(repr, value))}}};"
    if isinstance(value, bool):
        return f"static const bool {name} = {int(value)};"
    if isinstance(value, int):
        return f"static const int64_t {name} = INT64_C({value});"
    if isinstance(value, float) and value - value == 0.0:
        return f"static const double {name} = {value!r};"
    raise Refused(f"the constant {name} = {value!r} is not a bool, an int or a finite float")


def storage(module, name):
    """How a function is declared."""
    return STORAGE[module.marks.get(name)]


def prototypes(module, functions):
    """Lines that declare the ``functions`` of a module: (head, text) by name."""
    lines = [f"{storage(module, name)} {head};" for name, (head, _) in functions.items()]
    return ["", f"/* {module.place} */", *lines]


def code(module, functions):
    """The ``functions`` of a module in the order of the Python source, each under its docstring."""
    texts = [
        comment(ast.get_docstring(module.functions[name])) + f"{storage(module, name)} {text}"
        for name, (_, text) in functions.items()
    ]
    return "\n\n".join([banner(module), *texts]) + "\n"


def apart(text):
    """Text for a C comment, which ``E*/(n r)`` would end."""
    return text.replace("*/", "* /").replace("/*", "/ *")


def comment(text):
    """A docstring as a C comment, with a line end; '' where there is none."""
    if not text:
        return ""
    lines = apart(text).splitlines()
    if len(lines) == 1:
        return f"/* {lines[0]} */\n"
    return "\n".join([f"/* {lines[0]}", *(f" * {line}".rstrip() for line in lines[1:]), " */\n"])


def banner(module):
    """First lines of a generated file."""
    origin = f"---- From {module.place}; change that one."
    return comment(f"{origin}\n\n{ast.get_docstring(module.tree) or ''}".rstrip()).rstrip()
