"""The C of one module as it is committed, from what Pyccel writes."""

import ast
import re

from .modules import Refused

EDGE = "/*........................................*/"  # Pyccel's line above and below each function
#: How a function is declared that has a mark (kernel/layout/record.py), or none.
STORAGE = {None: "static inline", "seldom": "static OUT_OF_LINE", "inlined": "static ALWAYS_INLINE"}
C_WORDS = {"if", "for", "while", "return", "sizeof", "switch"}
#: Of math.h; every compiler has them without a library.
MATH_CALLS = set("copysign fabs isfinite sqrt".split())
SPAN_CALLS = set(
    "INT64_C cspan_at cspan_slice double_min double_max int64_t_min int64_t_max "
    "py_floor_div_int64_t pyc_modulo".split()
)


def written(module):
    """The functions of a module that C does not have by itself, by name."""
    return {name: node for name, node in module.functions.items() if module.marks.get(name) != "native"}


def storage(module, function):
    """How a function is declared."""
    return STORAGE[module.marks.get(function)]


def tidy_constants(module, constants):
    """Lines of the constants of a module."""
    definitions = [definition(f"{module.name}__{name}", value) for name, value in constants.items()]
    return ["", f"/* {module.place} */", *definitions] if definitions else []


def tidy_prototypes(module, text):
    """Lines that declare the functions of a module, from Pyccel's header."""
    found = re.findall(rf"^((\w.* \*?){module.name}__(\w+)\(.*\));$", text, re.MULTILINE)
    return [
        "",
        f"/* {module.place} */",
        *(f"{storage(module, name)} {line};" for line, _, name in found if name in written(module)),
    ]


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


def tidy_code(module, text):
    """The module's functions in the order of the Python source, each under its docstring."""
    chunks = {}
    for chunk in text.split(EDGE):
        signature = re.search(
            rf"^(\w.* \*?{module.name}__(\w+)\(.*\))\n\{{\n(.*)^\}}$", chunk, re.MULTILINE | re.DOTALL
        )
        if signature and signature[2] in written(module):
            head = f"{storage(module, signature[2])} {signature[1]}"
            chunks[signature[2]] = f"{head}\n{{\n{tidy_body(signature[3])}}}"
    functions = written(module)
    if chunks.keys() != functions.keys():
        raise Refused(
            f"{module.path.name}: Pyccel renamed or dropped {sorted(chunks.keys() ^ functions.keys())}"
        )
    documented = [comment(ast.get_docstring(node)) + chunks[name] for name, node in functions.items()]
    return "\n\n".join([banner(module), *documented]) + "\n"


def tidy_body(body):
    """The statements of one function, without the names that Pyccel declares and nobody reads."""
    for name in ["result", *re.findall(r"\bDummy_\d+(?=;)", body)]:
        uses = len(re.findall(rf"\b{name}\b", body))
        called = re.search(rf"^ *{name} = \w+\(", body, re.MULTILINE)
        if uses == 1 or uses == 2 and called:
            body = re.sub(rf"^ *\w+ {name};\n", "", body, flags=re.MULTILINE)
            body = re.sub(rf"^( *){name} = ", r"\1", body, flags=re.MULTILINE)
    # a cast that Pyccel writes or not, by what it has translated before
    body = re.sub(r"<< \(int64_t\)\((\w+)\)", r"<< \1", body)
    return re.sub(
        r"^( *)/\*(.*)\*/$",
        lambda match: f"{match[1]}/* {apart(match[2]).strip()} */",
        body,
        flags=re.MULTILINE,
    )


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


def refuse_unknown_calls(module, text, functions):
    """Refuse calls that neither the kernel nor spans.h and math.h define, and arrays on the stack."""
    code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    if re.search(r"\w+\[", code.replace("shape[", "")):
        raise Refused(
            f"{module.path.name}: the C would copy an array to the stack; an argument like x[a:b] "
            "needs a name first"
        )
    unknown = set(re.findall(r"\b([A-Za-z_]\w*)\(", code)) - functions - MATH_CALLS - SPAN_CALLS - C_WORDS
    if unknown:
        raise Refused(
            f"{module.path.name}: the C would call {', '.join(sorted(unknown))}, which spans.h and "
            "math.h do not have"
        )
